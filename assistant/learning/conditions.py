"""Before- and until-conditions of primitives, as a demonstration shows them (paper III-C c).

States of the hand, of what is held and of what rests on what, followed through the episodes
in the order shown; a state a primitive changes is its until-condition, a state it needs its
before-condition.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from assistant.geometry import IDENTITY, Array, compose, inverse, relative
from assistant.model.conditions import Condition
from assistant.model.lesson import Station
from assistant.model.motion import Indices
from assistant.model.placing import BESIDE_M, in_line, is_above
from assistant.model.scene import Body, Scene
from assistant.model.task import Primitive

Conditions = Mapping[str, tuple[Condition, ...]]

_ENDING = 2
"""A primitive that ends so many samples before a docking pose ends there."""
_BESIDE_M = BESIDE_M / 2.0
"""A demonstration that ends this far beside a place is well within what counts as above it."""


@dataclass(frozen=True, slots=True)
class Inferred:
    """Conditions by the primitives' names.

    Parameters
    ----------
    before, until : mapping of name to tuple of Condition
    changing : frozenset of str
        Primitives in which a key state changes.
    """

    before: Conditions
    until: Conditions
    changing: frozenset[str]


def inferred(
    leaves: Sequence[Primitive],
    path: Array,
    primitive_at: Indices,
    stations: Sequence[Station],
    scene: Scene | None = None,
) -> Inferred:
    """Return the conditions that held before and after each primitive shown.

    Parameters
    ----------
    leaves : sequence of Primitive
    path : array, shape (n, 7)
    primitive_at : array of int, shape (n,)
    stations : sequence of Station
    scene : Scene, optional
        Tells how large what was let go is.
    """
    before: dict[str, tuple[Condition, ...]] = {}
    until: dict[str, tuple[Condition, ...]] = {}
    changing: set[str] = set()
    for position in dict.fromkeys(int(at) for at in primitive_at if at >= 0):
        samples = np.flatnonzero(primitive_at == position)
        name = leaves[position].name
        acted = [one for one in stations if one.primitive == name]
        docked = _docked(stations, samples, acted)
        held = _held(stations, int(samples[0]), acted)
        before[name] = _state(held)
        cleared = _cleared(stations, samples, acted)
        until[name] = (
            *(_after(one) for one in acted),
            *(_aligned(one) for one in acted if _is_aligned(one, stations, scene or Scene())),
            *docked,
            *cleared,
            *(() if acted or docked else _above(stations, path, primitive_at, samples, held)),
        )
        if acted or docked or cleared:
            changing.add(name)
    return Inferred(before, until, frozenset(changing))


def _held(stations: Sequence[Station], begin: int, acted: Sequence[Station]) -> str:
    others = [one for one in stations if one not in acted and one.kind != "touch"]
    done = [one for one in others if one.at <= begin]
    return done[-1].object if done and done[-1].kind == "grasp" else ""


def _state(held: str) -> tuple[Condition, ...]:
    return (Condition("held", held),) if held else (Condition("hand", "open"),)


def _after(station: Station) -> Condition:
    if station.kind == "grasp":
        return Condition("held", station.object)
    if station.kind == "release":
        return Condition("on", station.object, station.frame)
    return Condition("docked", station.frame)


def _is_aligned(station: Station, stations: Sequence[Station], scene: Scene) -> bool:
    """Return whether what was let go lay in line, by the measure practice is judged by."""
    if station.kind != "release":
        return False
    grasps = [s for s in stations if (s.kind, s.object) == ("grasp", station.object)]
    before = [s.hand_in_frame for s in grasps if s.at < station.at]
    # How it sat in the hand when it was grasped is how it was let go.
    moved = compose(station.hand_in_frame, inverse(before[-1] if before else IDENTITY))
    body = scene.bodies.get(station.object, Body(station.object))
    place = inverse(body.hand_in_body)
    return in_line(body, compose(moved, place), place, station.frame)


def _aligned(station: Station) -> Condition:
    return Condition("aligned", station.object, station.frame)


def _docked(
    stations: Sequence[Station], samples: Indices, acted: Sequence[Station]
) -> tuple[Condition, ...]:
    """Return that the hand docks, if the primitive ends between docking and acting."""
    end = int(samples[-1])
    return tuple(
        Condition("docked", one.frame)
        for one in stations
        if one not in acted and one.docking_at - _ENDING <= end <= one.at
    )


def _cleared(
    stations: Sequence[Station], samples: Indices, acted: Sequence[Station]
) -> tuple[Condition, ...]:
    """Return that the hand has let go and gone away, if that is what the primitive does."""
    if acted:
        return ()
    return tuple(
        Condition("clear", one.object)
        for one in stations
        if one.kind == "release" and samples[0] <= one.left_at <= samples[-1]
    )


def _above(
    stations: Sequence[Station],
    path: Array,
    primitive_at: Indices,
    samples: Indices,
    held: str,
) -> tuple[Condition, ...]:
    """Return that what is held is above its place, if that is where the primitive ends.

    A demonstration that merely passed by is told from it by what follows: the next primitive
    leads down to the place, and nowhere beside it.
    """
    end = int(samples[-1])
    later = [one for one in stations if one.at > end and one.kind == "release"]
    if not held or not later:
        return ()
    docking = later[0].docking_at
    if len(set(primitive_at[end + 1 : docking + 1 - _ENDING].tolist())) > 1:
        return ()
    seen = relative(later[0].frame_to_world, path[end : docking + 1])
    gap = seen[:, :3] - later[0].hand_in_frame[:3]
    beside = np.hypot(gap[:, 0], gap[:, 1])
    over = bool(np.all(is_above(gap)) and np.all(beside < _BESIDE_M))
    return (Condition("above", held, later[0].frame),) if over else ()
