"""No question of the introduction is a dead end, and answers are heard through a guess."""

from __future__ import annotations

from dataclasses import replace

import pytest

from assistant.dialogue import effects as fx
from assistant.dialogue.listening import beneath, listening
from assistant.dialogue.machine import begin
from assistant.dialogue.plain_answers import answers_plainly
from assistant.dialogue.state import Introducing
from assistant.language.speech import phrase
from assistant.model import teacher_acts as acts
from assistant.model.task import TaskObject
from tests.dialogue.teaching import Lessons, said

ODD = "pour me a cup of tea"


def test_a_guess_at_an_answer_is_asked_about_as_that_answer() -> None:
    teacher = Lessons().open().hear(acts.Inform(ODD), text=ODD, sure=0.6)
    assert teacher.topics == ["confirm.did_you_mean.task_name"]
    assert phrase(teacher.lines[0]) == f'Shall I call the task "{ODD}"?'
    assert teacher.hear(acts.Affirm()).dialogue.known.name == ODD


def test_words_that_nobody_understands_twice_may_be_the_answer() -> None:
    teacher = Lessons().open().hear(acts.Unknown(), text="gobble").hear(acts.Unknown(), text=ODD)
    assert teacher.topics == [
        "error.not_understood_again",
        "help.task_name",
        "confirm.take_words",
    ]
    assert teacher.hear(acts.Affirm(), text="yes").dialogue.known.name == ODD


def test_after_help_a_guess_is_read_back_again() -> None:
    teacher = Lessons().open()
    for text in ("gobble", "gabble"):
        teacher.hear(acts.Unknown(), text=text)
    teacher.hear(acts.Inform(ODD), text=ODD, sure=0.6)
    assert teacher.topics == ["confirm.did_you_mean.task_name"]


def test_an_answer_is_heard_through_a_guess() -> None:
    teacher = Lessons().open().hear(acts.Inform(ODD), text=ODD, sure=0.6)
    below = beneath(teacher.dialogue)
    assert listening(teacher.dialogue).asked == "did_you_mean"
    assert below is not None
    assert below.asked == "task_name"
    assert beneath(begin()) is None
    assert said(teacher, "it's called making tea").dialogue.known.name == "making tea"


def test_a_vague_answer_to_a_yes_or_no_is_asked_for_plainly() -> None:
    teacher = Lessons().ready().hear(acts.Quit(), text="bye")
    teacher.hear(acts.Affirm(), text="well as you like", sure=0.5)
    assert teacher.topics == ["told.yes_or_no", "ask.unsaved"]


def test_a_size_is_taken_however_it_is_said() -> None:
    for text in ("15 centimetres across and maybe 12 high", "a little cup, 8 cm wide, 9 tall"):
        teacher = Lessons().open().tell("tea").tell("done").tell(("teapot", "target"))
        assert teacher.asked == "body"
        assert said(teacher, text).asked == "pose"


def test_no_size_is_asked_for_again_and_not_guessed_at() -> None:
    teacher = Lessons().open().tell("tea").tell("done").tell(("teapot", "target"))
    assert said(teacher, "oh it is round, like a melon").topics == ["error.size", "ask.body"]


def test_who_tells_no_place_is_offered_to_show_it() -> None:
    teacher = Lessons().open().tell("tea").tell("done").tell(("teapot", "target"))
    said(said(teacher, "a box, 10 by 10 by 10"), "it's in front of you")
    assert teacher.topics == ["confirm.place_shown"]
    assert "teapot" in teacher.hear(acts.Affirm(), text="yes").dialogue.known.unplaced


def test_a_list_in_unknown_verbs_is_asked_about_as_steps() -> None:
    teacher = Lessons().open().tell("tea").tell("done").tell(("block", "target"))
    steps = "twizzle the pot, carry it over, yonk it and set it back"
    teacher.hear(acts.Unknown(), text=steps, sure=0.6)
    assert teacher.topics == ["confirm.listed_steps"]
    teacher.hear(acts.Affirm(), text="yes")
    names = [part.name for part in teacher.dialogue.known.root.parts]
    assert names[0] == "twizzle the pot"
    assert len(names) == 4


def test_scratch_that_to_a_guess_takes_back_the_guess_alone() -> None:
    teacher = Lessons().learned().hear(acts.AddSubtask("wait"), text="add a wait", sure=0.6)
    assert teacher.topics == ["confirm.did_you_mean"]
    before = teacher.dialogue.known
    teacher.hear(acts.Undo(), text="scratch that")
    assert teacher.topics == ["told.as_it_was", "confirm.segmentation"]
    assert teacher.dialogue.known == before


def test_a_place_of_nothing_is_one_of_the_thing_asked_about() -> None:
    teacher = Lessons().open().tell("tea").tell("done").tell(("teapot", "target"))
    teacher.tell("a box, 10 by 10 by 10")
    teacher.hear(acts.SetPose("", (500.0, 100.0, 240.0)), text="500 x 100 x 240", sure=0.6)
    assert teacher.topics[0] == "read_back.place"
    assert teacher.lines[0].slots["thing"] == "teapot"


def test_help_is_given_however_unsurely_it_was_asked_for() -> None:
    teacher = Lessons().introduce().hear(acts.Help(), text="what can I change", sure=0.5)
    assert teacher.topics == ["help.confirm_tree", "confirm.tree"]


def test_who_may_have_been_misheard_is_asked_and_not_helped() -> None:
    teacher = Lessons().open().hear(acts.Help(), text="help", sure=0.6, voice=True)
    assert teacher.asked == "did_you_mean"


def test_three_numbers_plainly_tell_a_place_that_was_asked_for() -> None:
    teacher = Lessons().open().tell("move the drum").tell("the drum stands on the mat")
    teacher.tell(("drum", "mat")).tell("a box, 3 by 3 by 10 cm")
    assert teacher.asked == "pose"
    said(teacher, "500, -200, 240")
    assert teacher.topics[0] == "read_back.place"
    assert teacher.dialogue.known.setup.places["drum"].xyz_mm == (500.0, -200.0, 240.0)


@pytest.mark.parametrize(
    ("language", "text", "name"),
    [
        ("german", "nimm den Block", "nimm den Block"),
        ("german", "stell ihn auf das Ziel", "stell ihn auf das Ziel"),
        ("german", "den Block anheben", "Block anheben"),
        ("german", "der erste Schritt heißt aufnehmen", "aufnehmen"),
        ("english", "then put it on the tray", "put it on the tray"),
    ],
)
def test_a_step_is_called_by_what_is_done_not_by_a_thing_alone(
    language: str, text: str, name: str
) -> None:
    teacher = Lessons(begin(language)).open().tell("task").tell("done it is now")
    teacher.tell(("block", "target")).tell(2)
    assert said(teacher, text).dialogue.known.root.parts[0].name == name


@pytest.mark.parametrize(
    ("text", "names"),
    [
        ("the sugar bowl and the tray, what else", ["sugar bowl", "tray"]),
        ("well it's right in front of you", []),
        ("a jar and a lid, obviously", ["jar", "lid"]),
    ],
)
def test_of_an_unclear_answer_only_things_are_taken(text: str, names: list[str]) -> None:
    teacher = Lessons().open().tell("task").tell("done it is now")
    teacher.hear(acts.Inform(("front", "other")), text=text, sure=0.4)
    assert (teacher.topics == ["confirm.did_you_mean.objects"]) == bool(names)
    teacher.hear(acts.Affirm(), text="yes")
    assert [one.name for one in teacher.dialogue.known.objects or ()] == names


@pytest.mark.parametrize(
    "text",
    [
        "Goodness, how many? Well you take it, and you carry it over, and you set it down",
        "well you take it and you carry it over and you set it down",
    ],
)
def test_steps_told_at_length_are_read_back_as_steps(text: str) -> None:
    teacher = Lessons().open().tell("task").tell("done it is").tell(("block", "target"))
    said(teacher, text)
    if teacher.asked == "did_you_mean":
        assert teacher.topics == ["confirm.listed_steps"]
        teacher.hear(acts.Affirm(), text="yes")
    parts = teacher.dialogue.known.root.parts
    assert [part.name for part in parts] == ["take it", "carry it over", "set it down"]


def test_a_yes_that_answers_nothing_is_told_to_be_no_answer() -> None:
    teacher = Lessons().open().tell("task").tell("done it is").tell(("block", "target"))
    teacher.hear(acts.Affirm(), text="yes that will do", sure=0.5)
    assert teacher.topics[0] == "error.not_an_answer"


def test_the_thing_a_step_concerns_may_be_called_by_what_it_is() -> None:
    things = (TaskObject("sugar bowl", "object"), TaskObject("tray", "target"))
    opened = Lessons().open().dialogue
    known = replace(opened.known, objects=things)
    asked = replace(opened, known=known, state=Introducing("objects", (1,)))
    answer = (acts.Inform(("bowl",)),)
    assert answers_plainly(asked, answer, "the bowl I suppose")
    assert not answers_plainly(asked, answer, "which bowl?")
    assert not answers_plainly(asked, answer, "the bowl or the tray")


def test_a_place_of_nothing_is_not_read_back() -> None:
    moved = acts.SetPose("", by_mm=(0.0, -60.0, 0.0))
    teacher = Lessons().introduce().hear(moved, text="only forget the 6 cm", sure=0.5)
    assert teacher.topics[0] == "error.not_understood"
    assert teacher.asked == "confirm_tree"


@pytest.mark.parametrize("text", ["thank you, goodnight", "ok, bye!", "see you tomorrow"])
def test_a_goodbye_starts_nothing(text: str) -> None:
    teacher = Lessons().ready().hear(acts.Start(), text=text, sure=0.6)
    assert teacher.asked == "unsaved"
    teacher = Lessons().ready().hear(acts.Start(), text=text)
    assert not teacher.did(fx.Check)


@pytest.mark.parametrize("text", ["go home", "swap them"])
def test_a_question_that_is_passed_over_is_said_to_be_left_aside(text: str) -> None:
    teacher = Lessons().ready().run().hear(acts.Translate("left", "little"), text="a bit more left")
    assert teacher.asked == "facing"
    teacher.hear(acts.Unknown(), text=text)
    assert teacher.topics[0] == "told.left_aside"
