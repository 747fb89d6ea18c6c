"""Which joint branch can hold the exact stretches of a task, or which joint forbids them.

The stretches around grasps and releases must be followed exactly, all on one branch, so they
choose it; between them the arm may go as it likes.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

from assistant.geometry import Array
from assistant.model.motion import HandStop, Refusal
from sim import a465
from sim.fine_path import FinePath
from sim.kinematics import BRANCHES, Flags, inverse_all, limit_margin, wrist_of

JUMP_RAD = 0.5
"""Joints of one branch that differ by more between samples are not one motion."""
NARROW_RAD = math.radians(3.0)
"""A branch that comes so close to a limit is taken only if the others are a second slower."""
SINGULAR_RAD = math.radians(1.0)
"""Below this angle of joint 5 the wrist is near its singularity."""
STRAIGHT_RAD = 1e-6
"""Below this angle of joint 5 joints 4 and 6 may share their turn: the hand stays in place."""


@dataclass(frozen=True, slots=True, eq=False)
class Answers:
    """The joints of a fine path on all branches.

    Parameters
    ----------
    q : array, shape (g, 8, 6)
    margin : array, shape (g, 8)
        To the nearest limit in rad; minus infinity out of reach.
    """

    q: Array
    margin: Array


def answers(poses: Array) -> Answers:
    """Return the joints on all branches for flange poses, shape (g, 7)."""
    q = np.ascontiguousarray(inverse_all(poses))
    margin = limit_margin(q)
    return Answers(q, np.where(np.isnan(margin), -np.inf, margin))


def needed(fine: FinePath, start_free: bool) -> Flags:
    """Return the samples, shape (g,), that must be on the chosen branch."""
    flags = fine.constrained
    # A small step must end where it was asked to; the last departure of a task may be bent.
    flags[-1] = flags[-1] or (not fine.stops and fine.primitive_at[-1] < 0)
    flags[0] = flags[0] or start_free
    return flags


def candidates(found: Answers, flags: Flags, start: Array | None) -> list[int]:
    """Return the branches that hold all needed samples, the easiest first.

    Ease is the time the joints need between the exact stretches (a wrist that would have to
    turn the long way round shows here), and a share for samples beyond the limits.
    """
    able = [b for b in range(BRANCHES) if _holds(found, flags, b)]
    wrong = np.mean(found.margin < 0, axis=0)
    least = np.min(np.where(flags[:, None], found.margin, np.inf), axis=0)
    held = np.flatnonzero(flags)

    def effort(branch: int) -> float:
        q = found.q[held, branch]
        if start is not None:
            q = np.concatenate([start[None], q])
        elif abs(q[0, 4]) < STRAIGHT_RAD:
            q = np.concatenate([shared_turn(q[0])[None], q[1:]])
        travel = np.sum(np.max(np.abs(np.diff(q, axis=0)) / a465.SPEEDS, axis=1))
        return float(travel + 2.0 * wrong[branch] + (least[branch] < NARROW_RAD))

    return sorted(able, key=effort)


def shared_turn(q: Array) -> Array:
    """Return the same posture of a singular wrist with joints 4 and 6 sharing their turn."""
    half = math.remainder(q[3] + q[5], 2 * math.pi) / 2
    return np.array([q[0], q[1], q[2], half, q[4], half])


def _holds(found: Answers, flags: Flags, branch: int) -> bool:
    if np.any(found.margin[flags, branch] < 0):
        return False
    both = flags[1:] & flags[:-1]
    steps = np.abs(np.diff(found.q[:, branch], axis=0)).max(axis=1)
    return bool(np.all(steps[both] < JUMP_RAD))


def forbidden(found: Answers, flags: Flags, fine: FinePath) -> Refusal:
    """Return why no branch holds all needed samples: the best branch's worst place."""
    least = np.where(flags[:, None], found.margin, np.inf).min(axis=0)
    branch = int(np.argmax(least))
    if not np.isfinite(least[branch]):
        return _out_of_reach(fine, _told(flags & ~np.isfinite(found.margin).any(axis=1), fine))
    beyond = _told(flags & (found.margin[:, branch] < 0.0), fine)
    if not beyond.any():
        return _turned_through(found, flags, fine)
    sample = int(np.argmin(np.where(beyond, found.margin[:, branch], np.inf)))
    over = np.abs(found.q[sample, branch]) - a465.LIMITS
    joint = int(np.argmax(over))
    by = math.degrees(float(over[joint]))
    return joint_refusal(place_name(fine, sample), joint, by)


def _turned_through(found: Answers, flags: Flags, fine: FinePath) -> Refusal:
    """Return which joint would have to turn through its limits within an exact stretch."""
    both = flags[1:] & flags[:-1]
    fit = np.flatnonzero(np.all((found.margin >= 0.0) | ~flags[:, None], axis=0))
    turns = np.where(both[:, None, None], np.abs(np.diff(found.q[:, fit], axis=0)), 0.0)
    least = int(np.argmin(turns.max(axis=(0, 2))))
    sample, joint = np.unravel_index(int(np.argmax(turns[:, least])), turns[:, least].shape)
    first = last = int(sample)
    while first > 0 and flags[first - 1]:
        first -= 1
    while last < len(flags) - 1 and flags[last + 1]:
        last += 1
    way = np.unwrap(found.q[first : last + 1, fit[least], joint])
    by = math.degrees(float(np.max(np.abs(way)) - a465.LIMITS[joint]))
    return joint_refusal(place_name(fine, int(sample)), int(joint), max(by, 0.0))


def joint_refusal(where: str, joint: int, by_deg: float) -> Refusal:
    """Return the refusal of a place for a joint, counted from 0, with what would help."""
    # A shoulder at its end reaches too far, an elbow at its end folds too much.
    hint = {1: "closer", 2: "farther"}.get(joint, "turn")
    return Refusal("joint_limit", where, f"joint {joint + 1}", by_deg, "deg", hint)


def _told(failing: Flags, fine: FinePath) -> Flags:
    # A grasp or release that fails is told rather than a place on the way to it.
    keys = np.zeros(len(failing), dtype=bool)
    keys[[stop.at for stop in fine.stops]] = True
    return failing & keys if np.any(failing & keys) else failing


def _out_of_reach(fine: FinePath, failing: Flags) -> Refusal:
    shoulder = np.array([0.0, 0.0, a465.BASE_M])
    far = np.linalg.norm(wrist_of(fine.poses) - shoulder, axis=1)
    beyond = far - (a465.UPPER_ARM_M + a465.FOREARM_M)
    short = a465.FOREARM_M - a465.UPPER_ARM_M - far
    sample = int(np.argmax(np.where(failing, np.maximum(beyond, short), -np.inf)))
    by, hint = float(beyond[sample]), "closer"
    if short[sample] > by:
        by, hint = float(short[sample]), "farther"
    return Refusal("reach", place_name(fine, sample), "", 1000.0 * max(by, 0.0), "mm", hint)


def steadied(q: Array) -> Array:
    """Return joints, shape (g, 6), whose joint 4 keeps still while the wrist is singular."""
    straight = np.abs(q[:, 4]) < STRAIGHT_RAD
    if not straight[1:].any():
        return q
    steady = np.array(q)
    for k in 1 + np.flatnonzero(straight[1:]):
        total = q[k, 3] + q[k, 5]
        steady[k, 3] = steady[k - 1, 3]
        steady[k, 5] = math.remainder(total - steady[k, 3], 2 * math.pi)
    return steady


def place_name(fine: FinePath, sample: int) -> str:
    """Return in the task's words where on its path a sample is."""
    if not fine.stops:
        return "start" if sample == 0 else "path"
    # Where one stretch begins with the end of another, the later one has moved what is there.
    near = min(reversed(fine.stops), key=lambda stop: _away(stop, sample))
    if _away(near, sample) == 0:
        return stop_name(near)
    if sample == 0:
        return "start"
    after = [stop for stop in fine.stops if stop.at >= sample]
    return f"way to {after[0].frame}" if after else "end"


def _away(stop: HandStop, sample: int) -> int:
    return max(stop.docking_at - sample, sample - stop.left_at, 0)


def stop_name(stop: HandStop) -> str:
    """Return a grasp or release in the task's words."""
    if stop.kind == "release":
        return f"release at {stop.frame}"
    # What is in the hand is brought somewhere: only elsewhere would that place be reached.
    return f"{stop.kind} of {stop.frame if stop.kind == 'touch' else stop.object}"
