"""Names of steps keep the little words that belong to them, whatever the sentence says."""

from __future__ import annotations

import pytest

from assistant.language.understanding import understand
from assistant.model.listening import Listening
from assistant.model.teacher_acts import act_to_json

_NAMES = ("ease in", "back off", "pull out", "swing over", "pick it up", "drop it")
_SAYINGS = {
    "split {} into two": "subtask",
    "please remove {} from the list": "subtask",
    "{} is really two jobs": "subtask",
    "you may skip {} if you like": "subtask",
}


@pytest.mark.parametrize("name", _NAMES)
@pytest.mark.parametrize("saying", _SAYINGS)
def test_a_verb_with_its_particle_is_one_name(name: str, saying: str) -> None:
    (act,) = understand(saying.format(name), Listening(stage="learning")).acts
    assert act_to_json(act)[_SAYINGS[saying]] == name


@pytest.mark.parametrize(
    ("text", "name"),
    [
        ("split put pot down into two", "put pot down"),
        ("remove screw lid on, please", "screw lid on"),
        ("leave rinsing out", "rinsing"),
        ("break rinsing up", "rinsing"),
        ("take rinsing off the list", "rinsing"),
        ("cut rinsing in two", "rinsing"),
        ("strike wiping out of the list", "wiping"),
    ],
)
def test_a_particle_belongs_to_the_verb_that_takes_it(text: str, name: str) -> None:
    (act,) = understand(text, Listening(stage="learning")).acts
    assert act_to_json(act)["subtask"] == name


@pytest.mark.parametrize(
    ("text", "names"),
    [
        ("reach over must come before take hold", ("reach over", "take hold")),
        ("put back has to happen before let go of it", ("put back", "let go of it")),
        ("drop it comes after swing over, always", ("swing over", "drop it")),
    ],
)
def test_two_names_keep_their_little_words(text: str, names: tuple[str, str]) -> None:
    (act,) = understand(text, Listening(stage="introduction", asked="order")).acts
    told = act_to_json(act)
    assert (told["first"], told["second"]) == names
