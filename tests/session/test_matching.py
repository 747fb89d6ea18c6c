from __future__ import annotations

from types import MappingProxyType

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from assistant.model.robot_acts import About, RobotAct, RobotActName
from assistant.model.transcript import Near, RobotLine
from assistant.session.matching import Said, account, difference, look_up, mismatch

ANY = RobotLine("any")
PLAYED: tuple[RobotActName, ...] = ("report", "ask", "done")


def said(
    act: RobotActName = "report", topic: str = "x", text: str = "Hello.", **slots: object
) -> Said:
    return Said(RobotAct(act, topic, slots=MappingProxyType(slots)), text)


ASK = Said(RobotAct("ask", "name", "task_name", About("place", (1, 2))), "What is it called?")


def test_each_line_needs_its_step() -> None:
    lines = [RobotLine(act="report", line=3), RobotLine(act="ask", line=4)]
    assert account(lines, [said(), ASK], 9) is None


@pytest.mark.parametrize(
    ("steps", "count", "fits"),
    [
        ([RobotLine("any")], 0, True),
        ([RobotLine("any")], 3, True),
        ([RobotLine("some")], 0, False),
        ([RobotLine("some")], 3, True),
        ([RobotLine("maybe")], 0, True),
        ([RobotLine("maybe")], 1, True),
        ([RobotLine("maybe")], 2, False),
        ([RobotLine("one")], 0, False),
        ([RobotLine("one")], 1, True),
        ([RobotLine("one")], 2, False),
        ([RobotLine("any"), RobotLine("one")], 4, True),
        ([RobotLine("some"), RobotLine("some"), RobotLine("one")], 2, False),
        ([RobotLine("some"), RobotLine("some"), RobotLine("one")], 3, True),
        ([], 1, False),
    ],
)
def test_how_many_lines_a_step_stands_for(steps: list[RobotLine], count: int, fits: bool) -> None:
    assert (account(steps, [said()] * count, 1) is None) == fits


def test_any_lines_give_way_to_the_step_that_follows() -> None:
    lines = [said(), said(), ASK]
    assert account([ANY, RobotLine(asked="task_name")], lines, 1) is None
    assert account([ANY, RobotLine(asked="goal")], lines, 1) is not None


@settings(max_examples=40)
@given(st.lists(st.sampled_from(PLAYED), max_size=6))
def test_a_play_written_down_fits_itself(acts: list[RobotActName]) -> None:
    lines = [said(act) for act in acts]
    assert account([RobotLine(act=act) for act in acts], lines, 1) is None
    assert account([ANY], lines, 1) is None


def test_a_difference_tells_the_line_and_both_sides() -> None:
    found = account([RobotLine(act="done", line=7)], [ASK], 8)
    assert found is not None
    assert found.line == 7
    assert "expected act 'done', got 'ask'" in found.why
    assert "What is it called?" in found.why


def test_too_much_said_is_told_with_the_line_after() -> None:
    found = account([RobotLine(act="ask", line=7)], [ASK, said(text="And more.")], 8)
    assert found is not None
    assert found.line == 8
    assert "And more." in found.why


@pytest.mark.parametrize(
    ("step", "fits"),
    [
        (RobotLine(about="place"), True),
        (RobotLine(about=About("place", (1, 2))), True),
        (RobotLine(about=About("place", (2,))), False),
        (RobotLine(about="pick"), False),
        (RobotLine(words="What is it called?"), True),
        (RobotLine(words="what"), False),
        (RobotLine(act="ask", topic="name", words="Its name, please?"), True),
        (RobotLine(act="ask", words="Its name, please?"), False),
        (RobotLine(pattern="^what.*called"), True),
        (RobotLine(pattern="named"), False),
        (RobotLine(topic="name"), True),
        (RobotLine(topic="goal"), False),
    ],
)
def test_a_line_is_matched_by_what_is_given(step: RobotLine, fits: bool) -> None:
    assert (mismatch(step, ASK) == "") == fits


def test_only_slots_listed_must_agree() -> None:
    line = said(distance_mm=0.21, names=("a", "b"), where={"x": 1, "y": 2})
    assert not mismatch(RobotLine(slots={"distance_mm": Near(0.2, 0.05)}), line)
    assert not mismatch(RobotLine(slots={"names": ["a", "b"], "where": {"y": 2}}), line)
    assert "within 0.001" in mismatch(RobotLine(slots={"distance_mm": Near(0.2, 0.001)}), line)
    assert "expected 1 items" in mismatch(RobotLine(slots={"names": ["a"]}), line)
    assert "x: expected 3, got 1" in mismatch(RobotLine(slots={"where": {"x": 3}}), line)
    assert "got None" in mismatch(RobotLine(slots={"missing": 1}), line)


def test_dotted_paths_count_from_one() -> None:
    view = {"runs": [{"mm": 1.0}, {"mm": 2.0}], "arm": {"held": ""}}
    assert look_up(view, "runs.1.mm") == 1.0
    assert look_up(view, "runs.-1.mm") == 2.0
    assert look_up(view, "arm.held") == ""
    for missing in ("runs.0.mm", "runs.3", "runs.x", "arm.held.more", "nothing"):
        assert look_up(view, missing) is None


def test_near_wants_a_number() -> None:
    assert difference(Near(1.0, 0.1), "one")
    assert not difference(Near(1.0, 0.1), 1.05)
