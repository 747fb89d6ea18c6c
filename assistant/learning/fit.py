"""How well a stretch of the demonstration fits a primitive: P(S|E) of paper III-B, in log odds.

Factors as in the paper: (a) the motion's character against the action, (b) salient events
(the gripper's), (c) the objects involved, where their places are known.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from assistant.geometry import Array, rotate_vector
from assistant.learning.candidates import Evidence
from assistant.learning.handling import (
    carrying,
    goals,
    handled,
    held_before,
    otherwise,
    reaching,
)
from assistant.learning.stretches import Stretches
from assistant.model.demonstration import Demonstration
from assistant.model.directions import WAYS
from assistant.model.settings import SegmentationSettings
from assistant.model.task import Primitive, Task, TaskObject, primitives


def fits(
    task: Task,
    demonstration: Demonstration,
    evidence: Evidence,
    between: Stretches,
    settings: SegmentationSettings,
) -> Array:
    """Return the log odds of each stretch as each primitive, shape (n, n, leaves)."""
    leaves = primitives(task.tree)
    places = known_places(task, demonstration, evidence)
    moved = _after_moving(leaves)
    usual_s = float(between.at_s[-1] - between.at_s[0]) / max(len(leaves), 1)
    seen = demonstration.recording.gripper_m is not None
    told = frozenset(leaf.action.way for leaf in leaves if leaf.action.verb == "hand")
    reach, ends = reaching(leaves), goals(leaves, task)
    holding = {} if not seen else carrying(leaves, task) if told else held_before(leaves, task)
    alike = {
        known.name: [places[one.name] for one in task.objects if _rival(known, one, places)]
        for known in task.objects
    }
    scores = [
        _character(leaf, leaf.name in ends, between, seen, leaf.name in reach, settings)
        + handled(leaf, task, between, seen, told, settings)
        - settings.decoding.event * otherwise(between, holding.get(leaf.name))[:, None]
        + _objects(leaf, {} if leaf.name in moved else places, leaf.name in ends, between, settings)
        + _elsewhere(leaf, {} if leaf.name in moved else places, alike, between, settings)
        + _lasting(leaf, between, usual_s, settings)
        for leaf in leaves
    ]
    return np.stack(scores, axis=-1)


def known_places(task: Task, demonstration: Demonstration, evidence: Evidence) -> dict[str, Array]:
    """Return where things are as flange places, from the setup or else from the gripper.

    Source: contract, demonstration: an object is where the hand closed on it, a target where
    it opened. Without told places this holds for the introduced order of the things.
    """
    places = {
        name: place.pose[:3]
        for name, place in demonstration.setup.places.items()
        if place.kind == "hand" and task.object(name) is not None
    }
    smoothed = evidence.smoothed
    moved = {"close": "object", "open": "target"}
    for kind, role in moved.items():
        at = [e.at_s for e in evidence.events if e.kind == kind]
        names = _in_order(task, role)
        if len(at) != len(names) or any(name in places for name in names):
            continue
        for name, instant in zip(names, at, strict=True):
            row = int(np.clip(np.searchsorted(smoothed.t_s, instant), 0, len(smoothed.t_s) - 1))
            places[name] = smoothed.path[row, :3]
    return places


def _after_moving(leaves: Sequence[Primitive]) -> frozenset[str]:
    """Return the primitives about a thing that has been carried off from its told place."""
    taken: set[str] = set()
    found = set()
    for leaf in leaves:
        name = leaf.action.object or ""
        if name in taken and leaf.action.way not in ("depart", "up"):
            found.add(leaf.name)
        if leaf.action.way == "close":
            taken.add(name)
    return frozenset(found)


def _in_order(task: Task, role: str) -> list[str]:
    names: list[str] = []
    for leaf in primitives(task.tree):
        known = task.object(leaf.action.object or "")
        if known is not None and known.role == role and known.name not in names:
            names.append(known.name)
    return names


def _character(
    leaf: Primitive,
    ends_there: bool,
    between: Stretches,
    seen: bool,
    reaches: bool,
    settings: SegmentationSettings,
) -> Array:
    """Return (a), whether the motion looks like the action."""
    given = settings.decoding
    far = np.linalg.norm(between.ways, axis=-1)
    share = far / between.extent_m
    still = -given.still * np.exp(-share / 0.03)
    if reaches:
        return np.asarray(-given.idle * np.exp(-share / 0.03))
    if leaf.action.verb == "hand":
        # The way from docking to grasp or release: short, and without a turn (III-C a).
        turned = np.minimum(np.linalg.norm(between.turns, axis=-1) / 0.2, 3.0)
        wide = -given.wide * np.maximum(share - 0.2, 0.0) - given.turned * turned
        wide -= given.idle * np.exp(-share / 0.03)
        return np.asarray(wide if seen else wide - 0.5 * given.wide * share)
    if leaf.action.verb == "turn":
        # Who only turns goes nowhere.
        wide = 0.5 * given.wide * np.maximum(share - 0.3, 0.0)
        return np.asarray(given.turning * _turning(leaf.action.way, between) - wide)
    if leaf.action.verb == "free":
        # Wiping wanders, and so may whatever only its name tells.
        return np.asarray(still)
    axis = WAYS.get(leaf.action.way)
    # One step goes one way: what wanders or comes back is two.
    still -= given.straight * between.longer
    # Who is said to go some way, or to a thing, goes somewhere; taking the thing may be all that
    # is left of it, where nobody sees the hand.
    if axis is not None or seen:
        still -= (given.idle - given.still) * np.exp(-share / 0.03)
    if axis is None:
        return np.asarray(still)
    along = between.ways @ np.array(axis) / (far + 0.03 * between.extent_m)
    if ends_there:
        # "Down to the target" says where the way ends: it may come from the side.
        return np.asarray(given.direction * np.maximum(along, 0.0) + still)
    # A thing goes the way that is said; a hand that only leaves may go aside.
    weight = given.thing_astray if leaf.action.object else given.astray
    astray = weight * np.maximum(given.clear_along - along, 0.0)
    return np.asarray(given.direction * along - astray + still)


def _turning(way: str, between: Stretches) -> Array:
    size = np.linalg.norm(between.turns, axis=-1)
    approach = rotate_vector(between.quats, np.array([1.0, 0.0, 0.0]))
    lateral = rotate_vector(between.quats, np.array([0.0, 1.0, 0.0]))
    axes = {
        "left": np.array([[0.0, 0.0, 1.0]]),
        "right": np.array([[0.0, 0.0, -1.0]]),
        "up": -lateral,
        "down": lateral,
        "forward": np.array([[0.0, 1.0, 0.0]]),
        "backward": np.array([[0.0, -1.0, 0.0]]),
        "clockwise": approach,
        "counterclockwise": -approach,
    }
    axis = np.broadcast_to(axes[way], (*between.quats.shape[:1], 3))
    along = np.sum(between.turns * axis[:, None, :], axis=-1)
    return np.asarray(np.clip(1.3 * along / (size + 0.1), -1.0, 1.0))


def _objects(
    leaf: Primitive,
    places: dict[str, Array],
    ends_there: bool,
    between: Stretches,
    settings: SegmentationSettings,
) -> Array:
    """Return (c), whether the hand goes where the thing is, or leaves from there."""
    place = places.get(leaf.action.object or "")
    if place is None:
        return np.zeros_like(between.lasting_s)
    gap = np.linalg.norm(between.xyz - place, axis=-1) / (0.2 * between.extent_m)
    close = 2.0 * np.exp(-0.5 * gap**2) - 1.0
    weight = settings.decoding.nearing
    if leaf.action.way in ("depart", "up"):
        return np.broadcast_to(weight * close[:, None], between.lasting_s.shape).copy()
    if leaf.action.verb == "hand":
        return np.asarray(0.5 * weight * (close[None, :] + close[:, None]))
    if not (ends_there or leaf.action.way in ("approach", "to")):
        # What is pushed aside, or lowered, ends where nobody said.
        return np.zeros_like(between.lasting_s)
    return np.broadcast_to(weight * close[None, :], between.lasting_s.shape).copy()


def _rival(known: TaskObject, other: TaskObject, places: dict[str, Array]) -> bool:
    return other.role == known.role and other.name in places


def _elsewhere(
    leaf: Primitive,
    places: dict[str, Array],
    alike: dict[str, list[Array]],
    between: Stretches,
    settings: SegmentationSettings,
) -> Array:
    """Return whether the hand acts at another thing of the kind, rather than at this one."""
    name = leaf.action.object or ""
    if leaf.action.verb != "hand" or name not in places or len(alike[name]) < 2:
        return np.zeros_like(between.lasting_s)
    given = settings.decoding

    def off(place: Array) -> Array:
        gap = np.linalg.norm(between.xyz - place, axis=-1) / given.at_thing_m
        return np.asarray(np.minimum(gap**2, 1.0))

    nearest = np.min([off(place) for place in alike[name]], axis=0)
    told = -given.elsewhere * (off(places[name]) - nearest)
    return np.broadcast_to(told[None, :], between.lasting_s.shape)


def _lasting(
    leaf: Primitive, between: Stretches, usual_s: float, settings: SegmentationSettings
) -> Array:
    """Return whether it lasts as such a step does, and long enough to be one (P(E), III-A)."""
    usual = usual_s * (0.5 if leaf.action.verb == "hand" else 1.1)
    lasting = np.maximum(between.lasting_s, 1e-3)
    off = np.log(lasting / usual)
    short = np.where(lasting < settings.validity.least_s, -3.0, 0.0)
    return np.asarray(-0.5 * settings.decoding.lasting * off**2 + short)
