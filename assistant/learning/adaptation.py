"""Carry a learned path to another setup (paper III-D a).

`plan_adaptation` does once for a lesson what does not depend on the setup; `adapt` does the
rest; `adapted_path` is its core on arrays alone.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from assistant.errors import BadInput, Problem
from assistant.geometry import Array, compose, quat_from_rotvec, quat_multiply, rotate_vector
from assistant.learning.amendments import Bend
from assistant.learning.blending import azimuth_turned, eq6_way, two_frame_way
from assistant.learning.preparing import AdaptationPlan, plan_adaptation
from assistant.learning.rigid import Floats, Rows, composed, inverted, placed
from assistant.learning.timing import bounded_times
from assistant.learning.ways import smooth_way
from assistant.model.demonstration import sealed
from assistant.model.lesson import Station
from assistant.model.motion import HandPath
from assistant.model.scene import Scene
from assistant.model.setup import Place, Setup

__all__ = ["AdaptationPlan", "adapt", "adapted_path", "frames_in", "plan_adaptation"]


def adapt(
    plan: AdaptationPlan,
    scene: Scene,
    setup: Setup,
    *,
    start: Array | None = None,
    speed: float = 1.0,
) -> HandPath:
    """Return the path of the hand for a setup, timed for the hand.

    Parameters
    ----------
    plan : AdaptationPlan
    scene : Scene
    setup : Setup
    start : array, shape (7,), optional
        Where the hand is; the setup's robot start if not given.
    speed : float
        Factor of the lesson's own speed.

    Raises
    ------
    BadInput
        If the setup lacks a place, or the speed is not above zero.

    Notes
    -----
    In every setup the hand moves no faster than the scene allows, nor faster than the
    demonstration's greatest speed (`least_m_s` if that is less) times `speed`, and turns no
    faster than `plan.turn_rad_s`. No way between stations takes less time than the lesson's own
    divided by `speed`; within one that grew, so that slowing down makes it longer, steps may be
    shorter (`plan.hurry`), elsewhere none is; none while the gripper acts is shorter than the
    lesson's own.
    """
    if not speed > 0.0:
        raise BadInput.one("speed", f"{speed:g}", "a factor above 0, such as 0.5")
    told = setup.robot_start
    begin = placed(told.xyz_mm, told.rpy_deg) if start is None else np.asarray(start).tolist()
    path = _path(plan, _frames(plan, scene, setup), begin)
    settings, steps_s, hurry = plan.settings, plan.steps_s, plan.hurry
    if speed != 1.0:
        hurry = replace(hurry, greatest_m_s2=hurry.greatest_m_s2 * speed * speed)
        steps_s = np.where(plan.resting, steps_s / min(speed, 1.0), steps_s / speed)
    most_m_s = max(settings.speed_share * plan.peak_m_s, settings.least_m_s) * speed
    t_s = bounded_times(
        steps_s,
        path,
        min(scene.hand_speed_m_s, most_m_s),
        plan.turn_rad_s,
        plan.brake,
        hurry,
    )
    return HandPath(sealed(t_s), sealed(path), plan.gripper_m, plan.primitive_at, plan.stops)


def adapted_path(plan: AdaptationPlan, frames: Array, start: Array) -> Array:
    """Return the path, shape (n, 7), for frames given as arrays.

    Parameters
    ----------
    plan : AdaptationPlan
    frames : array, shape (stations, 7)
        Each station's frame in the world.
    start : array, shape (7,)
        Where the hand is.
    """
    return _path(plan, frames.tolist(), start.tolist())


def _path(plan: AdaptationPlan, frames: Rows, start: Floats) -> Array:
    moves = _moves(plan, frames, start)
    scheme = plan.settings.scheme
    path = smooth_way(plan.ways, moves) if scheme == "smooth" else _printed(plan, moves, start)
    for bend in plan.bends:
        _bent(path, bend, frames)
    return path


def _printed(plan: AdaptationPlan, stretch_moves: Rows, start: Floats) -> Array:
    """Return the path of one of the schemes near to the paper's."""
    moves, scheme = np.array(stretch_moves), plan.settings.scheme
    at_stations = moves[1 : 1 + len(plan.stations)]
    if scheme == "two_frame":
        return two_frame_way(plan.ways.path, moves, plan.ways.held)
    if not plan.stations:
        return compose(moves[0], plan.ways.path)
    learned = plan.ways.path
    turned = azimuth_turned(learned, moves, plan.ways.held) if scheme == "azimuth" else learned
    return eq6_way(turned, learned, at_stations, np.array(start), plan.weights)


def frames_in(plan: AdaptationPlan, scene: Scene, setup: Setup) -> Array:
    """Return each station's frame in a setup, shape (stations, 7).

    An object that has been released is from then on where the hand let go of it.
    """
    return np.array(_frames(plan, scene, setup)).reshape(-1, 7)


def _frames(plan: AdaptationPlan, scene: Scene, setup: Setup) -> Rows:
    now: dict[str, list[float]] = {}
    in_hand: dict[str, Floats] = {}
    out: Rows = []
    for k, (station, hand_in_frame) in enumerate(zip(plan.stations, plan.hands, strict=True)):
        if (frame := now.get(station.frame)) is None:
            if station.frame not in setup.places:
                raise _missing(plan.stations, setup, station.frame)
            frame = now[station.frame] = _hand(scene, station.frame, setup.places[station.frame])
        out.append(frame)
        if station.kind == "grasp":
            in_hand[station.object] = hand_in_frame
        elif station.kind == "release" and station.object in in_hand:
            held = in_hand.pop(station.object)
            if any(later.frame == station.object for later in plan.stations[k + 1 :]):
                # The frame as seen from the hand went with the hand until it let go.
                now[station.object] = composed(composed(frame, hand_in_frame), inverted(held))
    return out


def _hand(scene: Scene, name: str, place: Place) -> list[float]:
    """Return the same as `Scene.hand_pose`, in plain floats."""
    told = placed(place.xyz_mm, place.rpy_deg)
    body = scene.bodies.get(name)
    if place.kind == "hand" or body is None:
        return told
    return composed(told, placed(body.grasp_xyz_mm, body.grasp_rpy_deg))


def _moves(plan: AdaptationPlan, frames: Rows, start: Floats) -> Rows:
    begin = composed(start, plan.start_back)
    moves = [begin]
    moves += [composed(frame, back) for frame, back in zip(frames, plan.back, strict=True)]
    return [*moves, begin] if plan.ends_with_start else moves


def _bent(path: Array, bend: Bend, frames: Rows) -> None:
    """Add a correction to a path that is still being made."""
    offset, turn = bend.offset_m, bend.turn_rad
    if bend.station >= 0:
        quat = np.array(frames[bend.station][3:])
        offset, turn = rotate_vector(quat, offset), rotate_vector(quat, turn)
    inside = slice(bend.begin, bend.end)
    path[inside, :3] += bend.weight[:, None] * offset
    turns = quat_from_rotvec(bend.weight[:, None] * turn)
    path[inside, 3:] = quat_multiply(turns, path[inside, 3:])


def _missing(stations: Sequence[Station], setup: Setup, first: str) -> BadInput:
    """Return that places are missing: the first, and of all things that no hand put there."""
    put: set[str] = set()
    missing = [first]
    for station in stations:
        if station.frame not in setup.places and station.frame not in put | set(missing):
            missing.append(station.frame)
        if station.kind == "release":
            put.add(station.object)
    return BadInput(
        [Problem(setup.name, f"no place for {name!r}", "add it to places") for name in missing]
    )
