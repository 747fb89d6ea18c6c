"""What is between the fingers of a driven hand, as far as anybody can know it.

On an empty table things are where the teacher shows them to be. Where they are known, or their
size is, a hand that closes where none of them can be is told so at once.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from assistant.dialogue.bodies import ASSUMED_MM
from assistant.dialogue.knowledge import Knowledge
from assistant.geometry import Array, compose, inverse, transform_points
from assistant.language.speech import in_words
from assistant.model.scene import Scene
from assistant.ports import ArmLook, HandSample

MISSED_MM = 12.0
"""Fingers that are so far above a thing, or beside it, hold nothing of it."""
SHUT_M = 0.010


@dataclass(frozen=True, slots=True)
class Missed:
    """A thing that is not between the fingers, and how far it is from them, in mm.

    Parameters
    ----------
    name : str
    below, beside : float
        From the point between the fingers to the thing's top, and to its side; 0 for within.
    tall : float
        How high a thing is that stands somewhere on the table; 0 where its place is known.
    """

    name: str
    below: float
    beside: float
    tall: float = 0.0


class Closings:
    """Where the hand closed: first in what is shown, and last, which what it holds goes by."""

    def __init__(self) -> None:
        self.first: Array | None = None
        self.last: Array | None = None
        self._stale = False

    def see(self, look: ArmLook, samples: Sequence[HandSample], *, returning: bool) -> None:
        """Take where the hand is now.

        Parameters
        ----------
        look : ArmLook
        samples : sequence of HandSample
            Shown so far.
        returning : bool
            Whether something is being taken back: then what was shown changes.
        """
        shut = bool(look.held) or look.gripper_m < SHUT_M
        self.last = None if not shut else look.hand if self.last is None else self.last
        if self._stale and not returning:
            closed = (one.pose for one in samples if (one.gripper_m or 0.0) < SHUT_M)
            self.first = next(closed, None)
        elif self.first is None:
            self.first = self.last
        self._stale = returning


def taken(known: Knowledge, look: ArmLook, scene: Scene, tip: Array) -> str | Missed:
    """Return what a closed hand holds: a thing's name, what it missed, or nothing known.

    Parameters
    ----------
    known : Knowledge
        What was told of the things.
    look : ArmLook
    scene : Scene
        With the tables.
    tip : array, shape (7,)
        The point between the fingers, seen from the flange.
    """
    if look.held or look.gripper_m >= SHUT_M:
        return look.held
    things = [one.name for one in known.objects or () if one.role == "object"]
    lost = [name for name in things if name not in look.bodies]
    at = compose(look.hand, tip)[:3]
    if lost:
        return _somewhere(known, lost[0], at, scene)
    missed = [_missed(known.scene, name, look, at) for name in things if name in known.scene.bodies]
    return min(missed, key=lambda one: one.below + one.beside, default="")


def _somewhere(known: Knowledge, name: str, at: Array, scene: Scene) -> str | Missed:
    """Return a thing whose place is to be where the hand closed, if it can stand there."""
    body = known.scene.bodies.get(name)
    tops = [table.xyz_mm[2] + table.size_mm[2] for table in scene.tables]
    if body is None or not tops or body.size_mm == ASSUMED_MM:
        return name
    above = 1000.0 * float(at[2]) - max(tops)
    if above <= body.size_mm[2] + MISSED_MM:
        return name
    return Missed(name, above - body.size_mm[2], 0.0, body.size_mm[2])


def _missed(scene: Scene, name: str, look: ArmLook, at: Array) -> Missed:
    seen = 1000.0 * transform_points(inverse(look.bodies[name]), at)
    size = np.array(scene.bodies[name].size_mm)
    outside = np.maximum(np.abs(seen[:2]) - size[:2] / 2.0, 0.0)
    below = float(seen[2] - size[2]) if seen[2] > size[2] else 0.0
    return Missed(name, below, float(np.linalg.norm(outside)))


def width_mm(known: Knowledge, name: str) -> float | None:
    """Return how wide a thing is between the fingers; None where nobody told."""
    body = known.scene.bodies.get(name)
    return None if body is None else float(body.size_mm[1])


def missed_line(missed: Missed, words: Mapping[str, Any], language: str) -> str:
    """Return in words that a thing is not between the fingers, and where it is."""
    name, told = in_words(missed.name, language), words["missed"]
    if missed.tall:
        where = str(told["tall"]).format(tall=round(missed.tall), mm=round(missed.below), name=name)
    else:
        apart = (("below", missed.below), ("beside", missed.beside))
        where = " ".join(str(told[key]).format(mm=round(mm)) for key, mm in apart if mm >= 1.0)
        where = str(told["where"]).format(name=name, where=where) if where else ""
    return " ".join(filter(None, (str(told["nothing"]), where, str(told["help"]))))


def left_over(held: str | Missed, known: Knowledge, words: Mapping[str, Any], language: str) -> str:
    """Return in words what a showing that ends leaves open; empty if nothing.

    A thing that is still held where there is a place for it, or that never was.
    """
    if isinstance(held, Missed):
        return f"{missed_line(held, words, language)} {words['esc_again']}"
    if not held or all(one.role != "target" for one in known.objects or ()):
        return ""
    still = str(words["still_held"]).format(name=in_words(held, language))
    return f"{still} {words['esc_again']}"
