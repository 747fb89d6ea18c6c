"""What was taken for a thing and is none is taken back by plain words."""

from __future__ import annotations

import pytest

from assistant.dialogue.machine import begin
from assistant.model import teacher_acts as acts
from tests.dialogue.teaching import Lessons


def asked_about(thing: str) -> Lessons:
    teacher = Lessons().open().tell("task").tell("the block is on the target").tell((thing,))
    assert teacher.asked == "body"
    return teacher


def test_no_to_the_size_of_what_is_no_thing_asks_for_the_things_again() -> None:
    teacher = asked_about("greifen").hear(acts.Deny(), text="no")
    assert teacher.asked == "objects"
    assert teacher.dialogue.known.objects is None
    assert teacher.hear(acts.Undo()).asked == "body"


@pytest.mark.parametrize(
    "text", ["no, the things are the block and the target", "I meant the block and the target"]
)
def test_the_things_that_are_told_instead_are_taken(text: str) -> None:
    teacher = asked_about("greifen").hear(acts.Inform("block"), text=text)
    assert [one.name for one in teacher.dialogue.known.objects or ()] == ["block", "target"]
    assert teacher.asked == "subtask_count"


@pytest.mark.parametrize("text", ["no idea", "as wide as the block", "the block is 6 cm wide"])
def test_other_words_take_nothing_back(text: str) -> None:
    teacher = asked_about("lid").hear(acts.Unknown(), text=text)
    assert [one.name for one in teacher.dialogue.known.objects or ()] == ["lid"]


def test_how_big_a_thing_is_taken_to_be_is_told() -> None:
    teacher = Lessons().ready().hear(acts.Unknown(), text="what size is the block?")
    assert teacher.topics == ["told.size", "ask.ready_slow"]
    size_mm = teacher.dialogue.known.scene.bodies["block"].size_mm
    told = teacher.lines[0].slots["size"]
    assert [10.0 * float(told[axis]) for axis in "xyz"] == pytest.approx(size_mm)
    assert "told.size" not in Lessons().ready().hear(acts.Unknown(), text="how big?").topics


def german() -> Lessons:
    return Lessons(begin("german")).open().tell("Stapeln").tell("der Block liegt auf dem Ziel")


@pytest.mark.parametrize("verbs", [("Greifen",), ("hinfahren",), ("greifen", "ablegen")])
def test_verbs_alone_are_no_things(verbs: tuple[str, ...]) -> None:
    teacher = german().tell(verbs)
    assert teacher.asked == "objects"
    assert teacher.dialogue.known.objects is None


@pytest.mark.parametrize("thing", ["Reifen", "Faden", "Haken"])
def test_a_thing_that_ends_as_verbs_do_is_one(thing: str) -> None:
    teacher = german().tell((thing,))
    assert [one.name for one in teacher.dialogue.known.objects or ()] == [thing]


@pytest.mark.parametrize(
    "text", ["nein, die Dinge sind der Block und das Ziel", "ich meinte den Block und das Ziel"]
)
def test_the_things_told_instead_are_found_by_the_words_of_the_language(text: str) -> None:
    teacher = german().tell(("Deckel",)).hear(acts.Inform("Block"), text=text)
    assert [one.name for one in teacher.dialogue.known.objects or ()] == ["block", "target"]


def test_new_things_are_told_instead_as_well() -> None:
    text = "nein, die Dinge sind eine Tasse und ein Teller"
    teacher = german().tell(("Deckel",)).hear(acts.Inform("Teller"), text=text)
    assert [one.name for one in teacher.dialogue.known.objects or ()] == ["Tasse", "Teller"]


def test_steps_told_too_early_leave_the_things_to_be_asked() -> None:
    steps = "hinfahren, greifen, ablegen"
    teacher = german().hear(acts.Inform(tuple(steps.split(", "))), text=steps)
    assert teacher.asked == "objects"
    assert [part.name for part in teacher.dialogue.known.root.parts] == steps.split(", ")
