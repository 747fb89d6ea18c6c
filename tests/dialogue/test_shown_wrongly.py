"""Who showed it wrongly is learned from anew, not from both (paper II-B)."""

from __future__ import annotations

import pytest

from assistant.dialogue import effects as fx
from assistant.dialogue import events as ev
from assistant.dialogue.machine import public_view
from assistant.language.speech import phrase
from assistant.model import teacher_acts as acts
from assistant.model.motion import Refusal
from tests.dialogue.teaching import Lessons, demonstration, lesson


def shown(teacher: Lessons) -> int:
    return int(public_view(teacher.dialogue)["demonstrations"])


def show(teacher: Lessons) -> Lessons:
    teacher.hear(acts.Start()).hear(acts.Approve())
    return teacher.happen(ev.Shown(demonstration())).happen(ev.Learned(lesson()))


def shown_twice() -> Lessons:
    return show(Lessons().learned().hear(acts.GoBack("demonstration")))


def test_shown_once_more_is_learned_from_as_well() -> None:
    teacher = shown_twice()
    assert shown(teacher) == 2
    assert public_view(teacher.dialogue)["stage"] == "learning"
    assert 'from all 2 times you showed it; say "only the new one"' in phrase(teacher.lines[0])


@pytest.mark.parametrize(
    "text",
    [
        "no thats the old one, i showed it new",
        "forget the first one, use the second",
        "delete the first demonstration",
        "only the new one please",
    ],
)
def test_the_newest_alone_is_learned_from_for_who_says_so(text: str) -> None:
    teacher = shown_twice().hear(acts.Unknown(), text=text)
    assert teacher.topics[0] == "told.newest_only"
    learn = next(one for one in teacher.effects if isinstance(one, fx.Learn))
    assert len(learn.demonstrations) == 1
    assert shown(teacher.happen(ev.Learned(lesson()))) == 1
    assert shown(teacher.hear(acts.Undo())) == 2


def test_what_was_shown_wrongly_is_forgotten_before_it_is_shown_anew() -> None:
    teacher = Lessons().learned()
    teacher.hear(acts.GoBack("demonstration"), text="no i did it wrong, i want to show it again")
    assert teacher.topics == ["told.shown_forgotten", "ask.ready_to_watch"]
    assert shown(teacher) == 0
    assert shown(show(teacher)) == 1


def test_the_old_one_can_be_forgotten_while_the_new_one_is_waited_for() -> None:
    teacher = Lessons().learned().hear(acts.GoBack("demonstration"))
    assert shown(teacher.hear(acts.Unknown(), text="only the new one")) == 0
    assert shown(teacher.hear(acts.Undo())) == 1


@pytest.mark.parametrize(
    "text", ["no, the first cut is later", "i did it", "forget the first step"]
)
def test_other_words_forget_nothing(text: str) -> None:
    assert shown(shown_twice().hear(acts.Unknown(), text=text)) == 2


def test_after_a_refusal_a_new_showing_asks_once_about_the_earlier_one() -> None:
    for answer, left in ((acts.Affirm(), 1), (acts.Deny(), 2)):
        teacher = Lessons().ready().hear(acts.Start())
        refusal = Refusal("reach", "block")
        teacher.happen(ev.Checked(teacher.dialogue.known.setup, refusal))
        teacher.hear(acts.GoBack("demonstration")).hear(acts.Start())
        assert teacher.topics == ["confirm.forget_earlier"]
        teacher.hear(answer)
        assert teacher.topics == ["report.watching"]
        teacher.hear(acts.Approve()).happen(ev.Shown(demonstration()))
        assert shown(teacher.happen(ev.Learned(lesson()))) == left


def test_a_showing_more_after_no_trouble_is_simply_watched() -> None:
    teacher = Lessons().learned().hear(acts.GoBack("demonstration")).hear(acts.Start())
    assert teacher.topics == ["report.watching"]
