from __future__ import annotations

from dataclasses import replace

from assistant.learning.structure import left_out_questions, order_questions
from assistant.model.lesson import Episode, Segmentation
from tests.learning.lessons import NAMES, task


def shown(*names: str) -> Segmentation:
    parts = tuple(Episode(float(k), k + 1.0, name, 1.0) for k, name in enumerate(names))
    return Segmentation((), parts, None)


def test_the_order_told_raises_no_question() -> None:
    assert order_questions(task(), [shown(*NAMES), shown(*NAMES[:2], *NAMES[3:])]) == ()


def test_another_order_is_asked_about_at_the_node_that_differs() -> None:
    other = shown(*NAMES[3:], *NAMES[:3])
    asked = order_questions(task(), [shown(*NAMES), other])
    assert [one.about for one in asked] == ["pick and place"]
    free = replace(task(), tree=replace(task().tree, order="any"))
    assert order_questions(free, [other]) == ()


def test_a_part_left_out_once_may_be_optional() -> None:
    asked = left_out_questions(task(), [shown(*NAMES), shown(*NAMES[:2], *NAMES[3:])])
    assert [(one.asked, one.about) for one in asked] == [("optional", "move up object")]
