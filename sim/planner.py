"""Turns a path of the hand into a checked motion of the A465, or says why it cannot be.

One joint branch is chosen for the whole task from its exact stretches; free stretches that
leave the limits, spin the wrist or would touch something are led around; the demonstration's
own timing is kept and slowed smoothly where a limit binds. Everything is checked before
anything moves: reach, limits, collisions of arm, hand and carried body, speeds.

Without a look the plan may choose the joints of the robot start among those that hold the
start's pose (`JointPath.q[0]`); with a look it begins exactly at the measured joints, whatever
branch they are on, and knows what the hand holds.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass, replace

import numpy as np

from assistant.geometry import Array
from assistant.model.motion import HandPath, HandStop, Indices, JointPath, Refusal
from assistant.model.scene import Scene
from assistant.model.setup import Setup
from assistant.ports import ArmLook
from sim import a465
from sim.branches import (
    JUMP_RAD,
    STRAIGHT_RAD,
    Answers,
    answers,
    candidates,
    forbidden,
    joint_refusal,
    needed,
    place_name,
    shared_turn,
    steadied,
)
from sim.collision import Touch
from sim.fine_path import FinePath, joined, moved, refine, relaxed
from sim.kinematics import Flags, forward, limit_margin
from sim.phases import Phase, overlap, phases
from sim.routes import Stretch, route
from sim.timing import Timed, timed
from sim.touching import in_touch

ENOUGH = 1.4
"""A motion that lasts no longer than this share of the path's own time is good enough."""
EASINGS: tuple[tuple[str, ...], ...] = ((), ("release",), ("release", "grasp", "touch"))
"""Kinds of stops whose departures may bend, tried in this order."""
NEARER_M = 0.001
"""Between the samples that were kept clear the motion may come so much nearer to things."""
END_LIFTS_M = np.array([0.12, 0.08, 0.16, 0.05, 0.02])
"""A hand that cannot end where it should goes up so far from the last place it can take."""


@dataclass(frozen=True, slots=True, eq=False)
class _Work:
    """What is known of a task while it is planned."""

    fine: FinePath
    stops: tuple[HandStop, ...]
    found: Answers
    phases: tuple[Phase, ...]
    start: Array | None
    hand_speed_m_s: float


class A465Planner:
    """The Planner port for the A465."""

    def plan(
        self, path: HandPath, scene: Scene, setup: Setup, look: ArmLook | None = None
    ) -> JointPath | Refusal:
        """Return a motion within reach, limits, speeds and free of collision, or why not.

        Parameters
        ----------
        path : HandPath
            A whole task, or what is left of one.
        scene, setup
            What things look like and where they were told to be.
        look : ArmLook, optional
            Where the arm is, what it holds and where bodies are seen; without it the motion
            begins at the setup's robot start with every body where it was told.
        """
        if look is None and (refusal := overlap(scene, setup, path.stops)):
            return refusal
        path = replace(path, stops=in_touch(path.stops))
        fine = joined(refine(path), setup_start(scene, setup) if look is None else look.hand)
        start = None if look is None else np.array(look.q)
        speed = scene.hand_speed_m_s
        around = phases(fine, scene, setup, look)
        work = _Work(fine, fine.stops, answers(fine.poses), around, start, speed)
        refused = []
        for eased in EASINGS:
            # Where a departure cannot be kept as it was shown, it may bend once the hand is off;
            # a body just grasped is lifted as shown if that can be.
            fine = relaxed(work.fine, eased) if eased else work.fine
            if eased and fine.stops == work.fine.stops:
                continue
            done = _planned(replace(work, fine=fine))
            if isinstance(done, JointPath):
                return done
            refused.append(done)
        return refused[0]


def _planned(work: _Work) -> JointPath | Refusal:
    flags = needed(work.fine, work.start is None)
    lasts_s = float(work.fine.u_s[-1] - work.fine.u_s[0])
    best: JointPath | None = None
    refusals = []
    for branch in candidates(work.found, flags, work.start):
        done = _on_branch(work, branch)
        if isinstance(done, Refusal):
            refusals.append(done)
        elif best is None or done.t_s[-1] < best.t_s[-1]:
            best = done
        if best is not None and best.t_s[-1] <= ENOUGH * lasts_s:
            break
    if best is not None:
        return best
    return refusals[0] if refusals else forbidden(work.found, flags, work.fine)


def setup_start(scene: Scene, setup: Setup) -> Array:
    """Return the flange pose, shape (7,), at a setup's robot start."""
    return scene.hand_pose("", setup.robot_start)


def _on_branch(work: _Work, branch: int) -> JointPath | Refusal:
    q = np.array(work.found.q[:, branch])
    q[0] = _start_joints(work, branch)
    q[-1] = _end_joints(work, branch)
    q = steadied(q)
    ends = work.fine.constrained
    ends[[0, -1]] = True
    refusal = _touched(work, q, ends)
    if refusal is not None:
        return refusal
    notes: list[str] = []
    for first, last in work.fine.free_stretches():
        part = slice(first, last + 1)
        found = (route(one, q[part]) for one in _stretches(work, branch, q, first, last))
        way = next((one for one in found if one is not None), None)
        if way is None:
            return _blocked(work, q, first, last)
        notes.append(_note(work, q, first, last) if way[1] else "")
        q[part] = way[0]
    if np.abs(np.diff(q, axis=0)).max(initial=0.0) > JUMP_RAD:
        # The arm stands on another branch, and nothing lies between it and an exact stretch.
        return Refusal("joint_limit", place_name(work.fine, 0), "joint 4", hint="turn")
    return _finished(work, q, "; ".join(filter(None, notes)))


def _start_joints(work: _Work, branch: int) -> Array:
    if work.start is not None:
        return work.start
    q = work.found.q[0, branch]
    # Both signs of the wrist meet in its singularity: the first motion then chooses.
    return shared_turn(q) if abs(q[4]) < STRAIGHT_RAD else q


def _end_joints(work: _Work, branch: int) -> Array:
    """Return the last joints; where the path's own end cannot be held, those of a lifted hand."""
    margin = work.found.margin[:, branch]
    if margin[-1] >= 0.0:
        return np.asarray(work.found.q[-1, branch])
    last = int(np.flatnonzero(margin >= 0.0)[-1])
    lifted = np.repeat(work.fine.poses[last : last + 1], len(END_LIFTS_M), axis=0)
    lifted[:, 2] += END_LIFTS_M
    ends = answers(lifted)
    able = np.flatnonzero(ends.margin[:, branch] >= 0.0)
    # Where no lift can be done either, the hand stays at the last place it can take.
    return np.asarray(ends.q[able[0], branch] if len(able) else work.found.q[last, branch])


def _stretches(work: _Work, branch: int, q: Array, first: int, last: int) -> Iterator[Stretch]:
    """Yield a free stretch, what is carried being kept upright ever less strictly."""
    fine, part = work.fine, slice(first, last + 1)
    phase = next(p for p in work.phases if p.first <= first and last <= p.last)
    for gap in phase.gaps(float(np.max(fine.gripper_m[part])), fine.poses[part]):
        ends = q[first], q[last]
        yield Stretch(fine.u_s[part], fine.poses[part], branch, *ends, gap, work.hand_speed_m_s)


def _touched(work: _Work, q: Array, flags: Flags) -> Refusal | None:
    """Return what is touched first at the flagged samples, shape (g,)."""
    for phase in work.phases:
        chosen = phase.first + np.flatnonzero(flags[phase.first : phase.last + 1])
        if len(chosen) == 0:
            continue
        touch = phase.touches(q[chosen], work.fine.gripper_m[chosen], chosen)
        if not touch.free:
            return _collision(work.fine, phase, touch, int(chosen[touch.worst]))
    return None


def _collision(fine: FinePath, phase: Phase, touch: Touch, sample: int) -> Refusal:
    deep = 1000.0 * max(-float(touch.gap[touch.worst]), 0.0)
    # A table cannot be cleared away: what stands on it is too low for the hand.
    table = any(thing.bears and thing.name == touch.thing for thing in phase.things)
    hint = "higher" if table else "clear"
    return Refusal("collision", place_name(fine, sample), touch.thing, deep, "mm", hint)


def _note(work: _Work, kept: Array, first: int, last: int) -> str:
    """Return why a free stretch was led anew; nothing for a wrist that merely was spared a spin."""
    inside = np.arange(first + 1, last)
    known = inside[~np.isnan(kept[inside]).any(axis=1)]
    where = place_name(work.fine, first + 1)
    where = f"on the {where}" if where.startswith("way") else "at the end"
    phase = next(p for p in work.phases if p.first <= first and last <= p.last)
    if len(known):
        touch = phase.touches(kept[known], work.fine.gripper_m[known], known)
        if not touch.free:
            return f"going around {touch.thing} {where}"
    if len(known) < len(inside) or limit_margin(kept[known]).min(initial=np.inf) < 0.0:
        return f"staying within the arm's reach {where}"
    return ""


def _blocked(work: _Work, q: Array, first: int, last: int) -> Refusal:
    """Return why a free stretch cannot be passed: what it touches, else a joint."""
    flags = np.zeros(len(q), dtype=bool)
    flags[first : last + 1] = ~np.isnan(q[first : last + 1]).any(axis=1)
    touched = _touched(work, q, flags)
    if touched is not None:
        return touched
    beyond = np.abs(q[first : last + 1]) - a465.LIMITS
    if not flags[first : last + 1].all():
        return Refusal("reach", place_name(work.fine, first + 1), hint="closer")
    sample, joint = np.unravel_index(int(np.argmax(beyond)), beyond.shape)
    by = max(math.degrees(float(beyond[sample, joint])), 0.0)
    where = place_name(work.fine, first + 1)
    return joint_refusal(where, int(joint), by)


def _finished(work: _Work, q: Array, note: str) -> JointPath | Refusal:
    fine = work.fine
    result = timed(fine.u_s, q, forward(q)[:, :3], work.hand_speed_m_s)
    margin = limit_margin(result.q)
    if margin.min() < 0.0:
        return _beyond(fine, result, int(np.argmin(margin)))
    ticks = np.minimum(np.searchsorted(result.u_s, fine.u_s - 1e-9), len(result.u_s) - 1)
    owner = np.clip(np.searchsorted(fine.u_s, result.u_s, side="right") - 1, 0, len(q) - 1)
    if (refusal := _touched_on_the_way(work, result, owner)) is not None:
        return refusal
    speeds = np.abs(np.diff(result.q, axis=0)) * a465.CONTROL_HZ
    steps = np.linalg.norm(np.diff(forward(result.q)[:, :3], axis=0), axis=1)
    return JointPath(
        result.t_s,
        result.q,
        np.interp(result.u_s, fine.u_s, fine.gripper_m),
        fine.primitive_at[owner],
        tuple(moved(stop, ticks) for stop in work.stops),
        math.degrees(float(margin.min())),
        float(np.max(speeds / a465.SPEEDS, initial=0.0)),
        float(np.max(steps, initial=0.0) * a465.CONTROL_HZ),
        note,
    )


def _touched_on_the_way(work: _Work, result: Timed, owner: Indices) -> Refusal | None:
    """Return what the motion comes too near to at its ticks, each after a sample of the path."""
    gripper_m = work.fine.openings()[owner]
    for phase in work.phases:
        chosen = np.flatnonzero((owner >= phase.first) & (owner <= phase.last))
        if len(chosen) == 0:
            continue
        touch = phase.touches(result.q[chosen], gripper_m[chosen], owner[chosen])
        if float(touch.gap[touch.worst]) < -NEARER_M:
            return _collision(work.fine, phase, touch, int(owner[chosen[touch.worst]]))
    return None


def _beyond(fine: FinePath, result: Timed, tick: int) -> Refusal:
    over = np.abs(result.q[tick]) - a465.LIMITS
    joint = int(np.argmax(over))
    where = place_name(fine, int(np.searchsorted(fine.u_s, result.u_s[tick])))
    by = math.degrees(float(over[joint]))
    return joint_refusal(where, joint, by)
