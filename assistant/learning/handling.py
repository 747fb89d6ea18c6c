"""What the hand does in a stretch, against what it was said to do (paper III-B (b))."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from assistant.geometry import Array
from assistant.learning.stretches import Stretches
from assistant.model.settings import SegmentationSettings
from assistant.model.task import Primitive, Task

_LEAVES = ("depart", "up")
_GOING = ("approach", "to")
_SURELY = (("up", True), ("depart", False))
"""Ways of leaving that tell whether something is in the hand: raising a thing, leaving a target."""


def handled(
    leaf: Primitive,
    task: Task,
    between: Stretches,
    seen: bool,
    told: frozenset[str],
    settings: SegmentationSettings,
) -> Array:
    """Return whether the gripper did what the action says, and nothing else, in log odds.

    Parameters
    ----------
    leaf : Primitive
    task : Task
    between : Stretches
    seen : bool
        Whether the gripper was recorded.
    told : frozenset of str
        What the hand is said to do anywhere in the task: close, open.
    settings : SegmentationSettings

    Returns
    -------
    handled : array, shape (n, n)
    """
    given = settings.decoding
    score = np.zeros_like(between.lasting_s)
    if not seen:
        return score
    if leaf.action.verb == "hand":
        other = "open" if leaf.action.way == "close" else "close"
        wanted = between.inside[leaf.action.way] + between.at_end[leaf.action.way]
        wrong = between.inside[other] + between.at_end[other]
        return np.asarray(
            np.where(wanted == 1, given.event, -given.event)
            - given.event * np.maximum(wanted - 1, 0.0)
            - given.event * wrong
        )
    for kind in ("close", "open"):
        score -= given.event * between.inside[kind]
        score += 0.5 * given.event * _ends_so(leaf, task, kind, told) * between.at_end[kind]
    return score


def _ends_so(leaf: Primitive, task: Task, kind: str, told: frozenset[str]) -> float:
    """Return whether a motion ends in what the hand does: 1 if so, 0 if it may, else -1."""
    if kind in told:
        return -1.0
    known = task.object(leaf.action.object or "")
    if leaf.action.verb == "free":
        # Nobody knows what the hand does in what only its name tells.
        return 0.0 if known is None else 1.0 if _where(known.role) == kind else 0.0
    if known is None or leaf.action.verb == "turn" or leaf.action.way in _LEAVES:
        return -1.0
    if _where(known.role) == kind:
        # Taking and letting go may be part of getting there; who tells one tells the other, too.
        return -1.0 if told else 1.0
    # Going to a thing takes it; where it is moved itself, as down, it may be let go there.
    return -1.0 if leaf.action.way in _GOING or known.role == "target" else 0.0


def acted(leaves: Sequence[Primitive], between: Stretches) -> Array:
    """Return where a stretch ends in what the hand did and no step of its own tells, 0 or 1."""
    told = {leaf.action.way for leaf in leaves if leaf.action.verb == "hand"}
    ends = [between.at_end[kind] for kind in ("close", "open") if kind not in told]
    return np.minimum(sum(ends, np.zeros_like(between.lasting_s)), 1.0)


def untold(leaves: Sequence[Primitive], task: Task, between: Stretches) -> Array:
    """Return where a stretch ends in what the hand did more often than it was said to.

    Parameters
    ----------
    leaves : sequence of Primitive
    task : Task
    between : Stretches

    Returns
    -------
    untold : array, shape (n, n)
        0 or 1.
    """
    told = frozenset(leaf.action.way for leaf in leaves if leaf.action.verb == "hand")
    acts = np.zeros_like(between.lasting_s)
    for kind in ("close", "open"):
        means = [
            leaf.action.way == kind
            if leaf.action.verb == "hand"
            else _ends_so(leaf, task, kind, told) >= 0.0
            for leaf in leaves
        ]
        done = between.inside[kind][0, -1] + between.at_end[kind][0, -1]
        if done > sum(means):
            acts = np.maximum(acts, np.minimum(between.at_end[kind], 1.0))
            # After the last thing the hand did, it may rest to the end.
            acts[:, -1] = np.maximum(acts[:, -1], np.minimum(between.inside[kind][:, -1], 1.0))
    return np.asarray(acts)


def _where(role: str) -> str:
    return {"object": "close", "target": "open"}.get(role, "")


def held_before(leaves: Sequence[Primitive], task: Task) -> dict[str, bool]:
    """Return whether each primitive begins with something in the hand, as far as it is told.

    Where nobody speaks of the hand, going to an object ends in closing it, to a target in opening.
    Who leaves a target has let go there, and who raises an object has it in the hand, whatever
    else was told before.
    """
    found: dict[str, bool] = {}
    held: bool | None = None
    for leaf in leaves:
        known = task.object(leaf.action.object or "")
        ends = {"object": True, "target": False}.get(known.role) if known else None
        leaving = leaf.action.way in _LEAVES
        if (leaf.action.way, ends) in _SURELY:
            held = ends
        if held is not None:
            found[leaf.name] = held
        if ends is not None and not leaving:
            held = ends
    return found


def carrying(leaves: Sequence[Primitive], task: Task) -> dict[str, bool]:
    """Return the primitives that bring what the hand was told to take to a target: it is closed.

    Parameters
    ----------
    leaves : sequence of Primitive
    task : Task
    """
    found: dict[str, bool] = {}
    taken = False
    for leaf in leaves:
        known = task.object(leaf.action.object or "")
        going = leaf.action.verb == "move" and leaf.action.way in _GOING
        if taken and going and known is not None and known.role == "target":
            found[leaf.name] = True
        if leaf.action.verb == "hand":
            taken = leaf.action.way == "close" and bool(leaf.action.object)
    return found


def goals(leaves: Sequence[Primitive], task: Task) -> frozenset[str]:
    """Return the primitives about where something is brought: a target, or what it is put on."""
    found, held = set(), ""
    for leaf in leaves:
        name = leaf.action.object or ""
        known = task.object(name)
        if known is not None and (known.role == "target" or held not in ("", name)):
            found.add(leaf.name)
        if leaf.action.verb == "hand":
            held = name if leaf.action.way == "close" else ""
    return frozenset(found)


def otherwise(between: Stretches, held: bool | None) -> Array:
    """Return where a stretch begins with a hand that is not as told, shape (n,)."""
    if held is None:
        return np.zeros(len(between.at_s))
    return np.asarray(between.held != held, dtype=float)


def reaching(leaves: Sequence[Primitive]) -> frozenset[str]:
    """Return the primitives of the hand that bring it there, too: no other is said to do so.

    Who tells the way to one thing as a step of its own tells the way to the other, too: where it
    is missing, it was forgotten.
    """
    brought, found, led = False, [], set()
    for leaf in leaves:
        if leaf.action.verb == "hand" and leaf.action.object:
            if brought:
                led.add(leaf.action.way)
            else:
                found.append(leaf)
        gone = leaf.action.way in _LEAVES or leaf.action.verb in ("hand", "turn")
        brought = not gone
    return frozenset(leaf.name for leaf in found if leaf.action.way not in led)
