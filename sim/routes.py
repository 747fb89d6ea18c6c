"""Ways around for the free stretches of a path: what leaves the limits or would touch.

A stretch is kept where it can be. Its bad part is replaced by a smooth joint motion between
samples before and after it; if that does not do, the stretch is lifted; and if that does not
either, a way is searched among random joint angles (seeded, so that it is always the same).
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass, replace
from itertools import chain, islice

import numpy as np

from assistant.geometry import Array, rotate_vector
from sim import a465
from sim.branches import JUMP_RAD, SINGULAR_RAD, answers
from sim.kinematics import Flags, forward, limit_margin, wrist_of
from sim.search import filled, searched

FAST = 1.4
"""A free part that asks for more than this share of a joint's speed is led around: near the
wrist's singularity joints would spin while the hand hardly moves."""
LIFTS_M = (0.0, 0.05, 0.10, 0.16, 0.24)
PADS = (0.12, 0.35, 1.0)
"""How far a joint motion reaches beyond the bad part, as a share of what is left."""
LONGER, LATER_S = 1.25, 1.0
"""A way around that lasts longer than this is taken only if there is no quicker one."""
COARSE = 12
STEEP_RAD = 0.3
"""More than this between samples is a leap: the hand would not pass where it was checked."""
SEARCHES = 4
"""Pairs of ends between which a way is searched before giving up."""

Gap = Callable[[Array], Array]
"""Gives for joints, shape (m, 6), how far they are from touching anything, shape (m,)."""


@dataclass(frozen=True, slots=True, eq=False)
class Stretch:
    """A free stretch to be led from fixed joints to fixed joints.

    Parameters
    ----------
    u_s : array, shape (m,)
    poses : array, shape (m, 7)
    branch : int
    start, end : array, shape (6,)
        Joints of the first and last sample, which are kept.
    gap : callable
    hand_speed_m_s : float
    """

    u_s: Array
    poses: Array
    branch: int
    start: Array
    end: Array
    gap: Gap
    hand_speed_m_s: float = 0.25


def route(stretch: Stretch, kept: Array) -> tuple[Array, str] | None:
    """Return joints for a stretch, shape (m, 6), and how it was done; None if nothing helps.

    `kept` are the joints of the path as it is, NaN where there are none.
    """
    enough = LONGER * (stretch.u_s[-1] - stretch.u_s[0]) + LATER_S
    best: tuple[float, Array, str] | None = None
    for inner, head, tail in chain([(stretch, kept[:0], kept[:0])], _narrowed(stretch)):
        base = kept if inner is stretch else answers(inner.poses).q[:, stretch.branch]
        for how, q, checked in _ways(inner, base):
            if not (checked or _good(inner, q)):
                continue
            whole = np.concatenate([head, q, tail])
            lasts = _lasts(stretch, whole)
            if lasts <= enough:
                return whole, how
            if best is None or lasts < best[0]:
                best = (lasts, whole, how)
        if best is not None:
            return best[1:]
    return _search(stretch)


def _lasts(stretch: Stretch, q: Array) -> float:
    joints = np.max(np.abs(np.diff(q, axis=0)) / a465.SPEEDS, axis=1)
    hand = np.linalg.norm(np.diff(forward(q)[:, :3], axis=0), axis=1) / stretch.hand_speed_m_s
    return float(np.sum(np.maximum(np.maximum(joints, hand), np.diff(stretch.u_s))))


def _search(stretch: Stretch) -> tuple[Array, str] | None:
    whole = (stretch, stretch.start[None][:0], stretch.start[None][:0])
    for inner, head, tail in islice(chain([whole], _narrowed(stretch)), SEARCHES):
        found = searched(inner.start, inner.end, inner.gap, len(inner.u_s))
        if found is not None:
            return np.concatenate([head, found, tail]), "searched"
    return None


def _narrowed(stretch: Stretch) -> Iterator[tuple[Stretch, Array, Array]]:
    """Yield shorter stretches between straight ways out of the start and into the end."""
    count = len(stretch.u_s) // 5
    ins = [stretch.end[None][:0], *_straights(stretch, stretch.poses[-1], stretch.end, count)]
    outs = [stretch.start[None][:0], *_straights(stretch, stretch.poses[0], stretch.start, count)]
    for tail in ins:
        for head in outs:
            if len(head) + len(tail) == 0:
                continue
            part = slice(len(head), len(stretch.u_s) - len(tail))
            start = head[-1] if len(head) else stretch.start
            end = tail[-1] if len(tail) else stretch.end
            inner = replace(
                stretch, u_s=stretch.u_s[part], poses=stretch.poses[part], start=start, end=end
            )
            yield inner, head, tail[::-1]


def _straights(stretch: Stretch, pose: Array, q: Array, count: int) -> Iterator[Array]:
    """Yield free straight ways, shape (count, 6), from joints at a pose back or up."""
    approach = rotate_vector(pose[3:], np.array([1.0, 0.0, 0.0]))
    for way in (-0.06 * approach, -0.12 * approach, np.array([0.0, 0.0, 0.10])):
        s = np.linspace(0.0, 1.0, count + 1)
        poses = np.repeat(pose[None], count + 1, axis=0)
        poses[:, :3] += (s**3 * (10.0 - 15.0 * s + 6.0 * s * s))[:, None] * way
        joints = answers(poses).q[:, stretch.branch]
        joints[0] = q
        steps = np.abs(np.diff(joints, axis=0)).max(axis=1)
        if np.all(steps < JUMP_RAD) and _good(stretch, joints):
            yield joints[:-1]


def _good(stretch: Stretch, q: Array) -> bool:
    if np.any(np.isnan(q)) or limit_margin(q).min() < 0.0:
        return False
    if np.abs(np.diff(q, axis=0)).max(initial=0.0) > STEEP_RAD:
        return False
    # Most ways that touch something do so at one of a few samples: they are looked at first.
    coarse = q[1 + COARSE // 2 : -1 : COARSE]
    if len(coarse) and not np.all(stretch.gap(coarse) >= 0.0):
        return False
    inside = filled(q)[1:-1]
    return len(inside) == 0 or bool(np.all(stretch.gap(inside) >= 0.0))


def bad_samples(stretch: Stretch, q: Array) -> Flags:
    """Return where joints, shape (m, 6), leave limits, jump, spin or touch, shape (m,)."""
    bad = ~(limit_margin(q) >= 0.0)
    steps = np.abs(np.diff(q, axis=0)) / np.diff(stretch.u_s)[:, None] / a465.SPEEDS
    fast = ~(steps.max(axis=1) <= FAST)
    bad[1:] |= fast
    bad[:-1] |= fast
    known = np.logical_not(np.isnan(q).any(axis=1))
    # The ends are given: what they may touch is known to who gave them.
    known[[0, -1]] = False
    bad[known] |= stretch.gap(q[known]) < 0.0
    return _with_singular(bad, np.abs(q[:, 4]) < SINGULAR_RAD)


def _with_singular(bad: Flags, singular: Flags) -> Flags:
    # A rest in the singularity is as good as the motion out of it: both are led anew.
    edges = np.diff(np.concatenate([[0], singular.astype(int), [0]]))
    bad = np.array(bad)
    for first, end in zip(np.flatnonzero(edges > 0), np.flatnonzero(edges < 0), strict=True):
        if bad[max(first - 1, 0) : end + 1].any():
            bad[first:end] = True
    return bad


def _ways(stretch: Stretch, kept: Array) -> Iterator[tuple[str, Array, bool]]:
    """Yield how, joints, and whether these were found good already."""
    for lift in LIFTS_M:
        how = "" if lift == 0.0 else "lifted"
        base = kept if lift == 0.0 else _lifted(stretch, lift)
        base = _with_ends(stretch, base)
        bad = bad_samples(stretch, base)
        if not bad.any():
            yield how, base, True
            continue
        for pad in PADS:
            yield how or "led around", _bridged(stretch, base, bad, pad), False


def _with_ends(stretch: Stretch, q: Array) -> Array:
    q = np.array(q)
    q[0], q[-1] = stretch.start, stretch.end
    return q


def _lifted(stretch: Stretch, lift: float) -> Array:
    s = (stretch.u_s - stretch.u_s[0]) / (stretch.u_s[-1] - stretch.u_s[0])
    up, down = _smoothstep(s / 0.35), _smoothstep((1.0 - s) / 0.35)
    poses = np.array(stretch.poses)
    poses[:, 2] += lift * up * down
    return answers(_within_reach(poses)).q[:, stretch.branch]


def _within_reach(poses: Array) -> Array:
    shoulder = np.array([0.0, 0.0, a465.BASE_M])
    arm = wrist_of(poses) - shoulder
    far = np.linalg.norm(arm, axis=1)
    pull = np.maximum(far - a465.REACH_M, 0.0) / far
    inside = np.array(poses)
    inside[:, :3] -= pull[:, None] * arm
    return inside


def _smoothstep(s: Array) -> Array:
    s = np.clip(s, 0.0, 1.0)
    return np.asarray(s**3 * (10.0 - 15.0 * s + 6.0 * s * s))


def _bridged(stretch: Stretch, q: Array, bad: Flags, pad: float) -> Array:
    out = np.array(q)
    for first, end in _bridges(bad, pad):
        span = stretch.u_s[first : end + 1]
        out[first : end + 1] = _hermite(span, q, (first, end), _velocity(stretch, q, bad))
    return out


def _bridges(bad: Flags, pad: float) -> list[tuple[int, int]]:
    """Return good samples between which each bad run is bridged, `pad` of the room around."""
    last = len(bad) - 1
    edges = np.diff(np.concatenate([[0], bad.astype(int), [0]]))
    begins, ends = np.flatnonzero(edges > 0).tolist(), (np.flatnonzero(edges < 0) - 1).tolist()
    found: list[tuple[int, int]] = []
    for k, (begin, end) in enumerate(zip(begins, ends, strict=True)):
        before = ends[k - 1] if k else 0
        after = begins[k + 1] if k + 1 < len(begins) else last
        first = max(begin - 1, 0) - int(pad * max(begin - 1 - before, 0))
        final = min(end + 1, last) + int(pad * max(after - end - 1, 0))
        if found and first <= found[-1][1]:
            first = found.pop()[0]
        found.append((first, final))
    return found


def _velocity(stretch: Stretch, q: Array, bad: Flags) -> Callable[[int], Array]:
    def at(sample: int) -> Array:
        # A motion in course goes on; where the path is bad or at its end it stands still.
        near = slice(max(sample - 1, 0), sample + 2)
        if sample in (0, len(q) - 1) or bad[near].any():
            return np.zeros(q.shape[1])
        span = stretch.u_s[sample + 1] - stretch.u_s[sample - 1]
        return np.asarray((q[sample + 1] - q[sample - 1]) / span)

    return at


def _hermite(
    u_s: Array, q: Array, ends: tuple[int, int], velocity: Callable[[int], Array]
) -> Array:
    span = u_s[-1] - u_s[0]
    s = ((u_s - u_s[0]) / span)[:, None]
    start, end = q[ends[0]], q[ends[1]]
    leave, arrive = velocity(ends[0]) * span, velocity(ends[1]) * span
    # The quintic with given ends and speeds, and no acceleration at its ends.
    rise = s**3 * (10.0 - 15.0 * s + 6.0 * s**2)
    begin = s - s**3 * (6.0 - 8.0 * s + 3.0 * s**2)
    finish = s**3 * (-4.0 + 7.0 * s - 3.0 * s**2)
    return np.asarray(start + (end - start) * rise + leave * begin + arrive * finish)
