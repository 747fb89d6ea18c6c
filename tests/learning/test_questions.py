from __future__ import annotations

from dataclasses import replace
from types import MappingProxyType

import numpy as np

from assistant.learning.candidates import Evidence, gather
from assistant.learning.questions import DOUBTED, UNHEARD, UNSURE, questions
from assistant.learning.smoothing import smooth
from assistant.model.demonstration import Demonstration, Recording
from assistant.model.lesson import Episode, Question, SegmentationPoint
from assistant.model.settings import SegmentationSettings
from assistant.model.task import Action, Primitive, Subtask, Task

LEAVES = (
    Primitive("go up", Action("move", "up")),
    Primitive("go left", Action("move", "left")),
    Primitive("wave", Action("free", "wave"), optional=True),
)
TASK = Task("t", Subtask("t", LEAVES))
FIRST = Episode(0.0, 1.0, "go up", 0.9)
SECOND = Episode(1.0, 2.0, "go left", 0.9)


def given(gap: bool = False) -> tuple[Demonstration, Evidence]:
    t_s = np.arange(0.0, 2.0, 0.02)
    if gap:
        t_s = np.concatenate([t_s[:40], t_s[40:] + 3.0])
    path = np.zeros((len(t_s), 7))
    path[:, 1], path[:, 6] = 0.1 * np.sin(t_s), 1.0
    shown = Demonstration(Recording(t_s, path, np.where(t_s > 1.0, 0.08, 0.02)))
    return shown, gather(shown, smooth(shown.recording), SegmentationSettings())


def cut(confidence: float) -> SegmentationPoint:
    return SegmentationPoint(1.0, confidence, MappingProxyType({}))


def asked(
    points: tuple[SegmentationPoint, ...],
    episodes: tuple[Episode, ...],
    all_right: float = 1.0,
    *,
    gap: bool = False,
) -> tuple[Question, ...]:
    shown, evidence = given(gap)
    return questions(TASK, shown, evidence, points, episodes, all_right)


def test_what_is_clear_is_not_asked() -> None:
    assert asked((cut(0.99),), (FIRST, SECOND)) == ()


def test_an_unsure_cut_is_asked_about_with_its_time() -> None:
    (question,) = asked((cut(0.7),), (FIRST, SECOND), UNSURE - 0.1)
    assert (question.asked, question.about) == ("confirm_segmentation", "go up")
    assert question.facts["at_s"] == 1.0
    assert question.facts["next"] == "go left"


def test_only_the_least_sure_cuts_are_asked_about() -> None:
    cuts = tuple(replace(cut(chance), at_s=at) for at, chance in ((1.0, 0.95), (2.0, 0.6)))
    (question,) = asked(cuts, (FIRST, SECOND, replace(FIRST, from_s=2.0)), UNSURE - 0.1)
    assert question.facts["at_s"] == 2.0


def test_of_what_is_right_as_a_whole_no_cut_is_doubted() -> None:
    assert asked((cut(0.7),), (FIRST, SECOND), UNSURE + 0.1) == ()


def test_eliminated_and_internal_points_raise_no_questions() -> None:
    unsure = (replace(cut(0.1), kept=False), replace(cut(0.1), internal=True))
    (question,) = asked((*unsure, cut(0.9)), (FIRST, SECOND), UNSURE - 0.1)
    assert question.facts["confidence"] == 0.9


def test_empty_and_unknown_steps_are_named_and_optional_ones_are_not() -> None:
    found = asked((cut(0.99),), (FIRST, replace(SECOND, primitive=None, character="down")))
    assert [(q.reason, q.about) for q in found] == [
        ("never_shown", "go left"),
        ("never_introduced", ""),
    ]
    assert found[1].facts["character"] == "down"


def test_gaps_are_told() -> None:
    found = asked((cut(0.99),), (FIRST, SECOND), gap=True)
    assert [question.reason for question in found] == ["gap"]


def test_the_step_likeliest_left_out_is_asked_for_even_where_a_part_may_be_it() -> None:
    shown, evidence = given()
    parts = (FIRST, SECOND)

    def named(chances: dict[str, float]) -> list[tuple[str, str, object, object]]:
        found = questions(TASK, shown, evidence, (cut(0.99),), parts, 1.0, chances)
        return [(q.reason, q.about, q.facts["from_s"], q.facts["to_s"]) for q in found]

    first, second = (DOUBTED, "go up", 0.0, 1.0), (DOUBTED, "go left", 1.0, 2.0)
    assert named({"go up": 0.3, "go left": 0.05}) == [first]
    assert named({"go up": 0.9, "go left": 0.2}) == [first]
    # Which of like steps was left out, nobody can tell: both are asked about.
    assert named({"go up": 0.6, "go left": 0.4}) == [first, second]
    assert named({"go up": 0.1, "go left": 0.05, "wave": 0.9}) == []


def test_what_a_part_is_assigned_to_is_never_said_not_to_be_found() -> None:
    shown, evidence = given()
    found = questions(TASK, shown, evidence, (), (FIRST,), 1.0, {"go up": 0.5, "go left": 1.0})
    assert [(q.reason, q.about) for q in found] == [("never_shown", "go left"), (DOUBTED, "go up")]
    assert (found[0].facts["introduced"], found[0].facts["shown"]) == (3, 1)


def test_a_step_nobody_introduced_is_asked_about_though_all_was_taken_for_others() -> None:
    shown, evidence = given()

    def named(*unheard: tuple[float, float, float]) -> list[tuple[object, object]]:
        parts = (FIRST, SECOND)
        found = questions(TASK, shown, evidence, (cut(0.99),), parts, unheard=unheard)
        assert {one.reason for one in found} <= {"never_introduced"}
        return [(one.facts["from_s"], one.facts["to_s"]) for one in found]

    assert named((0.0, 0.6, UNHEARD + 0.1)) == [(0.0, 0.6)]
    assert named((0.0, 0.6, UNHEARD - 0.05)) == []
    # Where two places are as likely, nobody can tell; a third is much less so.
    places = (0.0, 0.6, 0.5), (1.2, 1.8, 0.4), (0.6, 1.2, 0.1)
    assert named(*places) == [(0.0, 0.6), (1.2, 1.8)]


def test_a_part_taken_for_no_step_is_asked_about_once() -> None:
    shown, evidence = given()
    parts = (FIRST, replace(SECOND, primitive=None))
    places = ((0.9, 2.0, 0.7), (0.0, 0.9, 0.3))
    found = questions(TASK, shown, evidence, (cut(0.99),), parts, unheard=places)
    spans = [(q.facts["from_s"], q.facts["to_s"]) for q in found if q.reason == "never_introduced"]
    assert spans == [(1.0, 2.0), (0.0, 0.9)]
