"""Two small pictures made of characters: the table from above and from where the teacher stands."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass

import numpy as np

from assistant.geometry import Array, transform_points
from assistant.language.speech import in_words
from assistant.model.scene import Body, Obstacle, Scene
from assistant.ports import ArmLook

MARGIN_MM, ABOVE_MM = 60.0, 15.0
"""Room around what must be seen, on the table and above and below."""
AHEAD_MM, ASIDE_MM = 100.0, 250.0
"""What is seen about the hand where nothing tells how far things are."""
OPEN, CLOSED, HAND, TABLE, EMPTY = "+", "*", "o", "_", "."
SHUT_M = 0.010
"""A hand that is open by less than this is drawn closed."""
Points = Array


@dataclass(frozen=True, slots=True)
class Sight:
    """Where things are seen: one picture, to scale.

    Parameters
    ----------
    up : int
        Which axis of the robot's base goes up in the picture: 0 seen from above, 2 from the side.
    low_mm : tuple of 2 floats
        Least y and least `up` that are seen.
    cell_mm : float
    rows, columns : int
    facing : bool
        Whether the teacher faces the robot.
    """

    up: int
    low_mm: tuple[float, float]
    cell_mm: float
    rows: int
    columns: int
    facing: bool

    def cells(self, points_mm: Points) -> list[tuple[int, int]]:
        """Return row and column of points, shape (n, 3); those beyond the edge stay on it."""
        across = (points_mm[:, 1] - self.low_mm[0]) / self.cell_mm
        along = (points_mm[:, self.up] - self.low_mm[1]) / self.cell_mm
        column = across if self.facing else self.columns - 1 - across
        row = along if self.facing and self.up == 0 else self.rows - 1 - along
        rows = np.clip(np.rint(row), 0, self.rows - 1).astype(int).tolist()
        columns = np.clip(np.rint(column), 0, self.columns - 1).astype(int).tolist()
        return list(zip(rows, columns, strict=True))

    def move_m(self, rows: float, columns: float) -> tuple[float, float, float]:
        """Return how far so many cells down and to the right are, along the base's axes."""
        step = self.cell_mm / 1000.0
        along = rows * step if self.facing and self.up == 0 else -rows * step
        across = columns * step if self.facing else -columns * step
        return (along, across, 0.0) if self.up == 0 else (0.0, across, along)


def sights(points_mm: Points, rows: int, columns: int, *, facing: bool) -> tuple[Sight, Sight]:
    """Return the picture from above and that from the side, of one scale, that hold points."""
    margin = np.array([MARGIN_MM, MARGIN_MM, ABOVE_MM])
    low, high = points_mm.min(axis=0) - margin, points_mm.max(axis=0) + margin
    size = high - low
    cell = float(max(size[1] / (columns - 1), size[0] / (rows - 1), size[2] / (rows - 1)))
    middle = (low + high) / 2.0
    left = float(middle[1]) - cell * (columns - 1) / 2.0
    # The table is looked at from its top upwards; what is above may have room to spare.
    lows = (float(middle[0]) - cell * (rows - 1) / 2.0, float(low[2]))
    return (
        Sight(0, (left, lows[0]), cell, rows, columns, facing),
        Sight(2, (left, lows[1]), cell, rows, columns, facing),
    )


def drawn(
    sight: Sight, look: ArmLook, scene: Scene, tip: Array, language: str = "english"
) -> tuple[str, ...]:
    """Return a picture's lines: bodies by their letters, the table's top, the hand.

    Parameters
    ----------
    sight : Sight
    look : ArmLook
    scene : Scene
    tip : array, shape (7,)
        The point between the fingers, seen from the flange: ``+``, and ``*`` of a closed hand.
    language : str
        That bodies are named in.
    """
    picture = [[EMPTY] * sight.columns for _ in range(sight.rows)]

    def put(points_mm: Points, mark: str) -> None:
        for row, column in sight.cells(points_mm):
            picture[row][column] = mark

    if sight.up == 2:
        for table in scene.tables:
            put(_top(table, sight.cell_mm), TABLE)
    letters = marks(scene.bodies, language)
    for name, pose in look.bodies.items():
        if name in scene.bodies:
            put(_filled(scene.bodies[name], pose, sight.cell_mm), letters[name])
    back = np.zeros((9, 3))
    back[:, 0] = np.linspace(0.0, float(tip[0]), 9)
    hand_mm = 1000.0 * transform_points(look.hand, back)
    put(hand_mm[:-1], HAND)
    put(hand_mm[-1:], CLOSED if _closed(look) else OPEN)
    return tuple(" ".join(line) for line in picture)


def _closed(look: ArmLook) -> bool:
    return bool(look.held) or look.gripper_m < SHUT_M


def _top(table: Obstacle, step_mm: float) -> Points:
    across = _spread(table.size_mm[1], step_mm) + table.xyz_mm[1]
    height = table.xyz_mm[2] + table.size_mm[2]
    return np.stack(
        [np.full_like(across, table.xyz_mm[0]), across, np.full_like(across, height)], 1
    )


def _filled(body: Body, pose: Array, step_mm: float) -> Points:
    """Return points in mm that fill a body, standing at a pose in m, without holes."""
    x, y, z = (_spread(edge, step_mm / 2.0) for edge in body.size_mm)
    grid = np.stack(np.meshgrid(x, y, z + body.size_mm[2] / 2.0), axis=-1).reshape(-1, 3)
    return np.asarray(1000.0 * transform_points(pose, grid / 1000.0))


def _spread(size_mm: float, step_mm: float) -> Array:
    # A little within the edges, so that a thing does not fill a cell it hardly reaches.
    return np.linspace(-0.4, 0.4, max(int(size_mm / step_mm) + 1, 2)) * size_mm


def marks(names: Iterable[str], language: str = "english") -> dict[str, str]:
    """Return a letter for each name, of what the robot calls it, that no other name has."""
    chosen: dict[str, str] = {}
    for name in names:
        told = in_words(name, language).upper()
        letters = (*(letter for letter in told if letter.isalpha()), *"0123456789")
        chosen[name] = next((each for each in letters if each not in chosen.values()), "*")
    return chosen


def seen_mm(look: ArmLook, tips: Sequence[Array], scene: Scene) -> Points:
    """Return the points, shape (n, 3), a picture must hold: the tips, and the tables' tops."""
    tops = [table.xyz_mm[2] + table.size_mm[2] for table in scene.tables]
    points = np.array([1000.0 * tip[:3] for tip in tips])
    low = points[:, 2].min()
    # A table far below is not worth the room it takes.
    shown = [top for top in tops if low - 2.0 * MARGIN_MM < top < low + MARGIN_MM]
    floor = np.array([[*points[0, :2], min([*shown, low])]])
    return np.concatenate([points, floor])


def around_mm(tip: Array, above_table_mm: float | None) -> Points:
    """Return points, shape (2, 3), about a pose of the fingers, down to a table.

    Parameters
    ----------
    tip : array, shape (7,)
    above_table_mm : float or None
        None where there is none below.
    """
    here = 1000.0 * tip[:3]
    low = here - np.array([AHEAD_MM, ASIDE_MM, above_table_mm or 0.0])
    return np.stack([low, here + np.array([AHEAD_MM, ASIDE_MM, 0.0])])
