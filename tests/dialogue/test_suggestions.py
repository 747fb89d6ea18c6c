"""What the robot offers to be said is understood where it offers it, in every language."""

from __future__ import annotations

import re
from collections.abc import Iterator

import pytest

from assistant.dialogue.effects import Say
from assistant.dialogue.events import Heard
from assistant.dialogue.helping import help_line
from assistant.dialogue.machine import begin, listening, step
from assistant.dialogue.state import Dialogue
from assistant.language.completion import suggestions
from assistant.language.speech import phrase
from assistant.language.understanding import understand
from assistant.model import teacher_acts as acts
from assistant.model.lesson import Question
from assistant.model.teacher_acts import ASKED
from tests.dialogue import teaching
from tests.dialogue.teaching import Lessons

QUOTED = {"english": r'"([^"]+)"', "german": "„([^“]+)“"}
LOST = ("not_understood", "not_understood_again", "not_an_answer", "not_now")
STEPS = {
    "english": teaching.STEPS,
    "german": (
        "Block anfahren",
        "Block greifen",
        "Block anheben",
        "Block zum Ziel absenken",
        "Block auf dem Ziel loslassen",
    ),
}
GROUPS = {"english": ("pick up object", "place object"), "german": ("aufnehmen", "abliefern")}
MISSING = Question("missing_step", "lift", "never_shown", {"introduced": 6, "shown": 5})


def states(language: str) -> Iterator[Dialogue]:
    """Yield the dialogue at every question a lesson may lead to."""

    def teacher(at: Dialogue | None = None) -> Lessons:
        return Lessons(at or begin(language), steps=STEPS[language], groups=GROUPS[language])

    first = teacher().open()
    yield first.dialogue
    yield first.tell("pick and place").dialogue
    yield first.tell("the block rests on the target").dialogue
    yield teacher(first.dialogue).tell(("vase", "target")).dialogue
    yield teacher(first.dialogue).tell(("vase", "target")).hear(acts.Deny()).dialogue
    yield first.tell(("block", "target")).dialogue
    yield first.tell(2).dialogue
    yield teacher(first.dialogue).tell("gimble").tell("frobnicate").dialogue
    yield teacher(first.dialogue).tell("gimble").tell("frobnicate").tell(0).dialogue
    yield teacher().introduce().dialogue
    yield teacher().confirmed().dialogue
    yield teacher().confirmed().hear(acts.Start()).dialogue
    optional = Question("optional", STEPS[language][2], "no_key_state_change", {})
    order = Question("order", GROUPS[language][0], "seen", {})
    for questions in ((), (MISSING,), (optional,), (order,)):
        yield teacher().learned(*questions).dialogue
    ready = teacher().ready()
    yield ready.dialogue
    yield teacher(ready.dialogue).hear(acts.Translate("left")).dialogue
    yield teacher(ready.dialogue).moving().dialogue
    yield teacher(ready.dialogue).moving().hear(acts.Pause()).dialogue
    yield teacher(ready.dialogue).moving().hear(acts.Stop()).dialogue
    yield ready.run().dialogue
    yield ready.hear(acts.Affirm()).dialogue
    yield ready.hear(acts.Quit()).dialogue


def test_all_questions_are_come_to() -> None:
    for language in QUOTED:
        asked = {listening(dialogue).asked for dialogue in states(language)}
        assert {*ASKED, None} - asked <= {"did_you_mean", "which"}


def answers(dialogue: Dialogue, text: str) -> list[str]:
    """Return what the robot answers to some words."""
    meant = understand(text, listening(dialogue), dialogue.language)
    effects = step(dialogue, Heard(text, meant))[1]
    return [one.line.topic for one in effects if isinstance(one, Say)]


@pytest.mark.parametrize("language", QUOTED)
def test_what_is_offered_is_understood(language: str) -> None:
    lost = []
    for dialogue in states(language):
        lines = (*dialogue.said, help_line(dialogue))
        told = " ".join(
            phrase(one, language) for one in lines if one.act in ("ask", "confirm", "help")
        )
        for offered in re.findall(QUOTED[language], told):
            names = (
                dialogue.known.name,
                *listening(dialogue).subtasks,
                *listening(dialogue).objects,
            )
            if "..." not in offered and offered not in names:
                answer = answers(dialogue, offered)
                if set(answer) & set(LOST):
                    lost.append((listening(dialogue).asked, offered, answer))
    assert lost == []


@pytest.mark.parametrize("language", QUOTED)
def test_what_is_completed_is_understood(language: str) -> None:
    lost = []
    for dialogue in states(language):
        for offered in suggestions(listening(dialogue), language):
            answer = answers(dialogue, offered)
            if set(answer) & {"not_understood", "not_understood_again"}:
                lost.append((listening(dialogue).asked, offered))
    assert lost == []


def test_the_usual_motions_are_offered_to_who_cannot_count_parts() -> None:
    teacher = Lessons().open().tell("tower").tell("done").tell(("block", "target")).tell(2)
    teacher.tell("pick up the block").tell("put it on the target")
    assert teacher.asked == "subtask_count"
    teacher.hear(acts.Help(), text="I don't know")
    assert teacher.topics == ["confirm.suggested_parts"]
    teacher.hear(acts.Affirm(), text="yes").hear(acts.Help(), text="no idea")
    assert teacher.topics == ["confirm.suggested_parts"]
    assert teacher.hear(acts.Affirm(), text="yes").asked == "confirm_tree"
