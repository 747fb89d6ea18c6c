"""Lines that name what they are about before they say what is to be done with it."""

from __future__ import annotations

import pytest

from assistant.language.understanding import understand
from assistant.model.listening import Listening
from assistant.model.teacher_acts import act_to_json


@pytest.mark.parametrize(
    ("text", "act", "name"),
    [
        ("the rinsing, split it in two", "split", "rinsing"),
        ("rinsing, delete that one please", "remove_subtask", "rinsing"),
        ("about rinsing, you may skip it", "optional", "rinsing"),
        ("I must stress that rinsing has to be done every time", "required", "rinsing"),
    ],
)
def test_a_pronoun_stands_for_the_topic(text: str, act: str, name: str) -> None:
    (told,) = understand(text, Listening(stage="learning")).acts
    assert act_to_json(told) == {"act": act, "subtask": name}


@pytest.mark.parametrize(
    ("text", "language"),
    [
        ("go on, but slower", "english"),
        ("carry on, just slower", "english"),
        ("weiter, aber langsamer", "german"),
        ("mach weiter, nur langsamer", "german"),
    ],
)
def test_going_on_with_a_correction_is_both(text: str, language: str) -> None:
    told = [act_to_json(act) for act in understand(text, Listening("practice"), language).acts]
    assert told == [{"act": "resume"}, {"act": "adjust_speed", "change": "slower"}]


@pytest.mark.parametrize(
    ("text", "old", "new"),
    [
        ("refer to lowering as easing from here on", "lowering", "easing"),
        ("instead of lowering please say easing", "lowering", "easing"),
        ("never call it lowering, call it easing", "lowering", "easing"),
        ("lowering is a silly word, call it easing", "lowering", "easing"),
        ("the step that used to be lowering shall be called easing", "lowering", "easing"),
    ],
)
def test_old_and_new_names_are_told_apart(text: str, old: str, new: str) -> None:
    (told,) = understand(text, Listening(stage="learning")).acts
    assert act_to_json(told) == {"act": "rename", "old": old, "new": new}
