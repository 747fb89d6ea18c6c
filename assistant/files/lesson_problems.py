"""What no form of a lesson can see: short rows, times that run backward, rows not there."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from assistant.errors import Problem
from assistant.files.lesson_forms import PATH_COLUMNS, CurvesForm, LearnedForm, PathForm
from assistant.plain_yaml import Document

WITH_GRIPPER = (*PATH_COLUMNS, "gripper_m", "primitive")
WITHOUT_GRIPPER = (*PATH_COLUMNS, "primitive")
CURVES = ("t_s", "vote")
MOST_ROWS, MOST_OF_A_KIND = 20, 5
Place = list[str | int]


def lesson_problems(form: LearnedForm, document: Document, leaves: int) -> list[Problem]:
    """Return all that does not fit together in a lesson.

    Parameters
    ----------
    form : LearnedForm
    document : Document
        For messages.
    leaves : int
        Primitives of the tree.
    """
    found: list[Problem] = []
    if form.votes is not None:
        found += _of_votes(form.votes, document)
    if form.path is not None:
        found += _of_path(form.path, document, leaves)
    return [*found, *_stations_outside(form, document)]


def _of_votes(votes: CurvesForm, document: Document) -> list[Problem]:
    place: Place = ["learned", "votes"]
    if votes.columns[:2] != CURVES:
        return [_other_columns(document, place, "[t_s, vote, SIGNAL...]")]
    return _ragged(votes.rows, len(votes.columns), document, place)


def _of_path(path: PathForm, document: Document, leaves: int) -> list[Problem]:
    place: Place = ["learned", "path"]
    if path.columns not in (WITH_GRIPPER, WITHOUT_GRIPPER):
        return [_other_columns(document, place, f"[{', '.join(WITH_GRIPPER)}]")]
    ragged = _ragged(path.rows, len(path.columns), document, place)
    return ragged or _of_rows(path, document, [*place, "rows"], leaves)


def _other_columns(document: Document, place: Place, right: str) -> Problem:
    return Problem(document.where([*place, "columns"]), "other columns than known", right)


def _ragged(
    rows: Sequence[Sequence[float]], columns: int, document: Document, place: Place
) -> list[Problem]:
    wrong = [number for number, row in enumerate(rows) if len(row) != columns]
    right = f"{columns} as in columns:"
    return [
        Problem(document.where([*place, "rows", at]), f"{len(rows[at])} numbers", right)
        for at in wrong[:MOST_ROWS]
    ]


def _of_rows(path: PathForm, document: Document, place: Place, leaves: int) -> list[Problem]:
    table = np.array(path.rows, dtype=float).reshape(len(path.rows), len(path.columns))
    with np.errstate(over="ignore"):
        length = np.linalg.norm(table[:, 4:8], axis=1)
    known = np.isin(table[:, -1], range(-1, leaves))
    wrong = (
        (np.diff(table[:, 0], prepend=-np.inf) <= 0, "time does not increase", "t_s must increase"),
        (np.abs(length - 1.0) > 1e-3, "the quaternion's length is not 1", "qx, qy, qz, qw"),
        (~known, f"there is no such primitive: the tree has {leaves}", "counted from 0, or -1"),
    )
    return [
        Problem(document.where([*place, int(at)]), what, right)
        for rows, what, right in wrong
        for at in np.flatnonzero(rows)[:MOST_OF_A_KIND]
    ]


def _stations_outside(form: LearnedForm, document: Document) -> list[Problem]:
    samples = len(form.path.rows) if form.path is not None else 0
    right = "a row counted from 0" if samples else "a lesson without a path has no docking"
    return [
        Problem(
            document.where(["learned", "docking", number, key]),
            f"{key}: the path has {samples} rows",
            right,
        )
        for number, station in enumerate(form.docking)
        for key, at in (
            ("at", station.at),
            ("docking_at", station.docking_at),
            ("left_at", station.left_at),
        )
        if at >= samples
    ]
