"""What a teacher sees while driving the hand: the way to each thing, by word and by key."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from assistant.dialogue.reporting import refusal_line
from assistant.geometry import Array, compose, quat_to_rpy, relative
from assistant.language.speech import phrase
from assistant.model.motion import ArmReport, Refusal
from assistant.model.scene import Scene
from assistant.ports import ArmLook

NEAR_MM, NEAR_DEG = 4.0, 3.0
"""So near the hand is there."""
WAYS = (("w", "s"), ("a", "d"), ("r", "f"))
"""Keys for more and less of x, y and z in the robot's base frame."""
TURNS = ("q", "e")
ROWS, COLUMNS = 9, 21
MARGIN_MM = 60.0
MIRRORED = {"w": "s", "s": "w", "a": "d", "d": "a"}
"""Facing the robot, the teacher's directions are the other way round."""


@dataclass(frozen=True, slots=True)
class Gap:
    """How far the hand is from where it grasps, or releases at, a thing.

    Parameters
    ----------
    name : str
    xyz_mm : array, shape (3,)
        Along the axes of the robot's base.
    yaw_deg : float
    held : bool
    """

    name: str
    xyz_mm: Array
    yaw_deg: float
    held: bool = False

    @property
    def there(self) -> bool:
        """Whether the hand is where it should be."""
        far = float(np.abs(self.xyz_mm).max())
        return not self.held and far < NEAR_MM and abs(self.yaw_deg) < NEAR_DEG


def gaps(look: ArmLook, scene: Scene) -> tuple[Gap, ...]:
    """Return the gaps to all things that are somewhere, in the order of the scene."""
    return tuple(
        _gap(look, name, compose(look.bodies[name], body.hand_in_body))
        for name, body in scene.bodies.items()
        if name in look.bodies
    )


def _gap(look: ArmLook, name: str, goal: Array) -> Gap:
    yaw = float(quat_to_rpy(relative(look.hand, goal)[3:])[2])
    away_mm = 1000.0 * (goal[:3] - look.hand[:3])
    return Gap(name, away_mm, float(np.rad2deg(yaw)), held=look.held == name)


def key_for(key: str, *, facing: bool) -> str:
    """Return the key that moves the robot the way a teacher's key means, and the reverse."""
    return MIRRORED.get(key, key) if facing else key


def gap_line(gap: Gap, words: Mapping[str, Any], *, facing: bool, holding: bool) -> str:
    """Return the way to a thing: "to the block   154 mm forward (w)   ..."."""
    head = str(words["to"]).format(name=gap.name)
    if gap.held:
        return f"{head}   {words['held']}"
    if gap.there:
        act = words["open_now" if holding else "close_now"]
        return f"{head}   {words['there']}: {act}"
    return "   ".join((head, *_steps(gap, words, facing=facing)))


def _steps(gap: Gap, words: Mapping[str, Any], *, facing: bool) -> Iterator[str]:
    ways = words["keys"]
    for away, keys in zip(gap.xyz_mm, WAYS, strict=True):
        key = key_for(keys[0 if away > 0 else 1], facing=facing)
        if round(abs(away)):
            yield str(words["step"]).format(mm=round(abs(away)), way=ways[key], key=key)
    if round(abs(gap.yaw_deg)):
        key = TURNS[0 if gap.yaw_deg > 0 else 1]
        yield str(words["turn"]).format(deg=round(abs(gap.yaw_deg)), way=ways[key], key=key)


def in_the_way(trouble: Refusal | ArmReport, words: Mapping[str, Any], language: str) -> str:
    """Return in words why the hand does not go on."""
    if isinstance(trouble, Refusal):
        return phrase(refusal_line("refuse", trouble), language)
    return str(words["faults"][trouble.text]).format(name=trouble.object)


def marks(names: Iterable[str]) -> dict[str, str]:
    """Return a letter for each name that no other name has."""
    chosen: dict[str, str] = {}
    for name in names:
        letters = (*(letter for letter in name.upper() if letter.isalpha()), *"0123456789")
        chosen[name] = next((each for each in letters if each not in chosen.values()), "*")
    return chosen


@dataclass(frozen=True, slots=True)
class Overhead:
    """A small view from above, of characters; what is far from the teacher is up.

    Parameters
    ----------
    low_mm, high_mm : array, shape (2,)
        The part of the table that is seen, x and y in the robot's base frame.
    facing : bool
        Whether the teacher faces the robot.
    """

    low_mm: Array
    high_mm: Array
    facing: bool

    @classmethod
    def around(cls, look: ArmLook, all_gaps: Sequence[Gap], *, facing: bool) -> Overhead:
        """Return the view that holds the hand and all it can go to, with some margin."""
        here = 1000.0 * look.hand[:2]
        points = np.array([here, *(here + gap.xyz_mm[:2] for gap in all_gaps)])
        return cls(points.min(axis=0) - MARGIN_MM, points.max(axis=0) + MARGIN_MM, facing)

    def drawn(self, look: ArmLook, all_gaps: Sequence[Gap]) -> tuple[str, ...]:
        """Return lines; ``+`` is the hand, over a letter it is where it grasps or lets go."""
        here = 1000.0 * look.hand[:2]
        letters = marks(gap.name for gap in all_gaps)
        picture = [["."] * COLUMNS for _ in range(ROWS)]
        spots = [(letters[gap.name], here + gap.xyz_mm[:2]) for gap in all_gaps if not gap.held]
        for mark, point in (*spots, ("+", here)):
            row, column = self._cell(point)
            picture[row][column] = mark
        return tuple(" ".join(line) for line in picture)

    def _cell(self, point: Array) -> tuple[int, int]:
        # Seen from behind the robot, x grows upward and y to the left.
        share = (self.high_mm - point) / (self.high_mm - self.low_mm)
        share = np.clip(1.0 - share if self.facing else share, 0.0, 1.0)
        return round(float(share[0]) * (ROWS - 1)), round(float(share[1]) * (COLUMNS - 1))
