"""What is seen decides whether a condition holds."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from assistant.geometry import IDENTITY, Array, compose, pose_from_mm_deg
from assistant.model.conditions import CONDITIONS, Condition, ConditionKind
from assistant.model.motion import HandPath, HandStop
from assistant.model.placing import BESIDE_M
from assistant.model.scene import Body, Scene
from assistant.model.setup import Place, Setup
from assistant.ports import ArmLook
from assistant.session.conditions import (
    Surroundings,
    Unmet,
    expectations,
    first_unmet,
    holds,
    still_to_come,
)
from tests.session.test_practice import learned

BLOCK = Body("block")
TARGET = Body("target", size_mm=(60.0, 40.0, 0.0), mass_kg=0.0)
SCENE = Scene(bodies={"block": BLOCK, "target": TARGET})
SETUP = Setup(
    places={
        "block": Place("body", (500.0, 200.0, 240.0)),
        "target": Place("body", (500.0, -200.0, 240.0), (0.0, 0.0, 40.0)),
    }
)
GRASP = SCENE.hand_pose("block", SETUP.places["block"])
RELEASE = SCENE.hand_pose("target", SETUP.places["target"])


def back(pose: Array, by_m: float) -> Array:
    return compose(pose, np.array([-by_m, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0]))


def way() -> HandPath:
    """Towards the block, grasp, over the target, down, release, back."""
    poses = [back(GRASP, 0.2), back(GRASP, 0.08), GRASP, GRASP]
    poses += [up(RELEASE, 0.1), RELEASE, RELEASE, back(RELEASE, 0.08)]
    stops = (
        HandStop(2, "grasp", "block", "block", 1, 3),
        HandStop(6, "release", "block", "target", 4, 7),
    )
    opening = np.array([0.08, 0.08, 0.08, 0.04, 0.04, 0.04, 0.08, 0.08])
    t_s = np.arange(8.0)
    return HandPath(t_s, np.array(poses), opening, np.zeros(8, dtype=np.int64), stops)


def up(pose: Array, by_m: float) -> Array:
    return np.array([pose[0], pose[1], pose[2] + by_m, *pose[3:]])


AROUND = Surroundings(SCENE, SETUP, way(), 0.08)


def look(hand: Array, opening_m: float = 0.08, held: str = "", block: Array = GRASP) -> ArmLook:
    """The block is told by where the flange would grasp it."""
    base = compose(block, pose_from_mm_deg((134.1, 0.0, -60.0), (0.0, 0.0, 0.0)))
    bodies = {"block": base, "target": SCENE.body_pose("target", SETUP.places["target"])}
    return ArmLook(np.zeros(6), hand, opening_m, held, bodies, True, 1.0)


FAR = back(GRASP, 0.2)
CARRIED = up(RELEASE, 0.1)
CASES = {
    "hand open": (Condition("hand", "open"), look(FAR), look(FAR, 0.03)),
    "hand closed": (Condition("hand", "closed"), look(FAR, 0.03), look(FAR)),
    "closed on something wide": (
        Condition("hand", "closed"),
        look(GRASP, 0.07, "block"),
        look(GRASP, 0.07),
    ),
    "held": (Condition("held", "block"), look(GRASP, 0.04, "block"), look(GRASP, 0.04)),
    "held another": (
        Condition("held", "block"),
        look(GRASP, 0.04, "block"),
        look(GRASP, 0.04, "cup"),
    ),
    "docked": (Condition("docked", "block"), look(back(GRASP, 0.08)), look(FAR)),
    "docked, turned": (
        Condition("docked", "block"),
        look(GRASP),
        look(compose(GRASP, pose_from_mm_deg((0, 0, 0), (0, 0, 20)))),
    ),
    "on": (
        Condition("on", "block", "target"),
        look(RELEASE, block=RELEASE),
        look(RELEASE, block=up(RELEASE, 0.01)),
    ),
    "aligned": (
        Condition("aligned", "block", "target"),
        look(RELEASE, block=RELEASE),
        look(RELEASE, block=compose(RELEASE, pose_from_mm_deg((0, 3, 0), (0, 0, 0)))),
    ),
    "above": (
        Condition("above", "block", "target"),
        look(CARRIED, 0.04, "block", CARRIED),
        look(GRASP, 0.04, "block"),
    ),
    "above, but down already": (
        Condition("above", "block", "target"),
        look(CARRIED, 0.04, "block", CARRIED),
        look(RELEASE, 0.04, "block", RELEASE),
    ),
    "clear": (
        Condition("clear", "block"),
        look(back(RELEASE, 0.08), block=RELEASE),
        look(RELEASE, block=RELEASE),
    ),
    "clear, but held": (
        Condition("clear", "block"),
        look(FAR),
        look(FAR, 0.04, "block", FAR),
    ),
}


@pytest.mark.parametrize("case", CASES)
def test_each_kind_is_judged_by_what_is_seen(case: str) -> None:
    condition, met, unmet = CASES[case]
    assert holds(condition, AROUND, met)
    assert not holds(condition, AROUND, unmet)


def test_every_kind_has_a_case() -> None:
    assert {condition.kind for condition, _, _ in CASES.values()} == set(CONDITIONS)


@pytest.mark.parametrize("kind", [kind for kind in CONDITIONS if kind not in ("hand", "clear")])
def test_nothing_holds_of_what_is_nowhere(kind: ConditionKind) -> None:
    condition = Condition(kind, "ghost", "nowhere")
    assert not holds(condition, AROUND, look(GRASP))


@given(st.floats(-0.02, 0.02), st.floats(-0.02, 0.02))
def test_a_corrected_place_is_where_things_belong(x_m: float, y_m: float) -> None:
    shift = np.array([x_m, y_m, 0.0, 0.0, 0.0, 0.0, 1.0])
    grasp, release = AROUND.path.stops
    stops = (grasp, replace(release, shift=tuple(shift.tolist())))
    around = replace(AROUND, path=replace(AROUND.path, stops=stops))
    moved = compose(RELEASE, shift)
    assert holds(Condition("aligned", "block", "target"), around, look(moved, block=moved))


@pytest.mark.parametrize(
    ("shown", "held"),
    [((0.9, 0.0), True), ((4.0, 0.0), False), ((0.0, 3.0), False)],
)
def test_in_line_is_as_shown_only_if_that_was_in_line(
    shown: tuple[float, float], held: bool
) -> None:
    """What lies as it was shown, but was not shown in line, is not called so."""
    beside = compose(RELEASE, pose_from_mm_deg((0.0, shown[0], 0.0), (0.0, 0.0, shown[1])))
    path = np.array(AROUND.path.path)
    path[6] = beside
    around = replace(AROUND, path=replace(AROUND.path, path=path))
    aligned = Condition("aligned", "block", "target")
    again = compose(beside, pose_from_mm_deg((0.0, 0.5, 0.0), (0.0, 0.0, 0.0)))
    assert holds(aligned, around, look(again, block=again)) == held
    slipped = compose(beside, pose_from_mm_deg((0.0, 2.0, 0.0), (0.0, 0.0, 0.0)))
    assert not holds(aligned, around, look(beside, block=slipped))
    assert holds(aligned, around, look(beside, block=RELEASE))


@given(st.floats(0.0, 0.2), st.floats(0.0, 2.0 * np.pi))
def test_above_ends_three_centimeters_beside(away_m: float, heading: float) -> None:
    aside = (away_m * np.cos(heading), away_m * np.sin(heading), 0.1)
    place = AROUND.scene.body_pose("target", SETUP.places["target"])
    seen = replace(look(CARRIED, 0.04, "block"), bodies={"block": _over(place, aside)})
    held = holds(Condition("above", "block", "target"), AROUND, seen)
    assert held == (away_m < BESIDE_M) or abs(away_m - BESIDE_M) < 1e-9


def _over(place: Array, by_m: tuple[float, float, float]) -> Array:
    return np.array([*(place[:3] + np.array(by_m)), *place[3:]])


def test_the_opening_of_a_path_that_never_closes_is_judged_by_the_hand() -> None:
    never = replace(AROUND.path, gripper_m=np.full(8, 0.08))
    around = replace(AROUND, path=never)
    assert holds(Condition("hand", "open"), around, look(FAR))
    assert holds(Condition("hand", "closed"), around, look(FAR, 0.01))


def test_the_first_unmet_condition_is_told_with_what_is_found_instead() -> None:
    before = (Condition("held", "block"), Condition("hand", "closed"))
    conditions = ((before, (Condition("hand", "closed"),)),)
    found = first_unmet(conditions, 0, "before", AROUND, look(FAR))
    assert found is not None
    assert (found.condition, found.when, found.found) == (before[0], "before", "")
    ending = first_unmet(conditions, 0, "until", AROUND, look(FAR))
    assert ending is not None
    assert (ending.when, ending.found) == ("until", "open")
    assert first_unmet(conditions, -1, "before", AROUND, look(FAR)) is None
    assert first_unmet(conditions, 0, "until", AROUND, look(FAR, 0.01)) is None


def test_what_is_announced_is_what_is_demanded() -> None:
    above = (Condition("above", "block", "target"),)
    task = learned("pick_and_place")
    assert task.learned is not None
    until = {**task.learned.until, "move up object": above}
    seen = replace(task, learned=replace(task.learned, until=until))
    assert expectations(seen)[2][1] == above


@pytest.mark.parametrize(
    ("condition", "next_at", "comes"),
    [
        (Condition("above", "block", "target"), 3, True),
        (Condition("above", "block", "target"), 1, False),
        (Condition("above", "block", "cup"), 3, False),
        (Condition("held", "block"), 3, False),
    ],
)
def test_only_what_the_next_step_begins_with_may_still_come(
    condition: Condition, next_at: int, comes: bool
) -> None:
    path = replace(AROUND.path, primitive_at=np.array([0, 1, 2, 3, 3, 3, 4, 4]))
    assert still_to_come(Unmet(condition, 2, "until"), next_at, path) == comes


def test_on_a_body_that_was_moved_is_where_that_body_is() -> None:
    lower = Body("lower", size_mm=(80.0, 60.0, 70.0))
    scene = Scene(bodies={"block": BLOCK, "lower": lower})
    setup = Setup(places={"lower": Place("body", (0.0, 0.0, 240.0))})
    around = Surroundings(scene, setup, replace(AROUND.path, stops=()), 0.08)
    below = np.array([0.4, 0.1, 0.24, *IDENTITY[3:]])
    seen = replace(look(FAR), bodies={"lower": below, "block": up(below, 0.07)})
    assert holds(Condition("on", "block", "lower"), around, seen)
    assert not holds(Condition("on", "block", "lower"), around, look(FAR))
