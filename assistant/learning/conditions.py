"""Before- and until-conditions of primitives, as a demonstration shows them (paper III-C c).

States of the hand, of what is held and of what rests on what, followed through the episodes
in the order shown; a state a primitive changes is its until-condition, a state it needs its
before-condition.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from assistant.geometry import Array, relative
from assistant.model.conditions import Condition
from assistant.model.lesson import Station
from assistant.model.motion import Indices
from assistant.model.task import Primitive

Conditions = Mapping[str, tuple[Condition, ...]]

_ALIGNED_M, _ALIGNED_RAD = 0.005, np.deg2rad(3.0)
_ABOVE_M, _BESIDE_M = 0.01, 0.03


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
) -> Inferred:
    """Return the conditions that held before and after each primitive shown.

    Parameters
    ----------
    leaves : sequence of Primitive
    path : array, shape (n, 7)
    primitive_at : array of int, shape (n,)
    stations : sequence of Station
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
            *(_aligned(one) for one in acted if _is_aligned(one)),
            *docked,
            *cleared,
            *(() if acted or docked else _above(stations, path, samples, held)),
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


def _is_aligned(station: Station) -> bool:
    away = float(np.linalg.norm(station.hand_in_frame[:2]))
    turn = 2.0 * float(np.arccos(min(abs(float(station.hand_in_frame[6])), 1.0)))
    return station.kind == "release" and away < _ALIGNED_M and turn < _ALIGNED_RAD


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
        if one not in acted and one.docking_at - 2 <= end <= one.at
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
    stations: Sequence[Station], path: Array, samples: Indices, held: str
) -> tuple[Condition, ...]:
    later = [one for one in stations if one.at > samples[-1] and one.kind == "release"]
    if not held or not later:
        return ()
    seen = relative(later[0].frame_to_world, path[int(samples[-1])])
    gap = seen[:3] - later[0].hand_in_frame[:3]
    over = gap[2] > _ABOVE_M and float(np.hypot(gap[0], gap[1])) < _BESIDE_M
    return (Condition("above", held, later[0].frame),) if over else ()
