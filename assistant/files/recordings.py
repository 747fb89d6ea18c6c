"""Recordings as CSV: ``t_s,x_m,y_m,z_m,qx,qy,qz,qw,gripper_m``, with ``#`` for comments.

Repeated times stay (learning handles them); quaternions nearly of length 1 are made so, and a
quaternion that flips its sign is turned back, since both mean the same rotation. What cannot
be meant, such as NaN or time running backward, is refused with its line.
"""

from __future__ import annotations

import io
import re
from collections.abc import Collection, Iterable, Sequence
from itertools import islice
from pathlib import Path
from typing import Protocol

import numpy as np

from assistant.errors import BadInput, Problem
from assistant.files.columns import COLUMNS, columns_of
from assistant.files.writing import write_text
from assistant.geometry import Array, quat_continuous, quat_normalize
from assistant.model.demonstration import Recording
from assistant.plain_yaml import text_of

MOST_BYTES = 256_000_000
MOST_PROBLEMS = 20
FEWEST_SAMPLES = 3
FARTHEST_M = 20.0
WIDEST_M = 1.0
SELDOM_S = 5.0
"""Samples mostly farther apart than this, in s, show no motion: their times are told otherwise."""
NEARLY_UNIT = 0.05
"""A quaternion this far from length 1 is rounding of a log; beyond, it is something else."""
EXACTLY_UNIT = 1e-12
SAMPLES = "one line a sample, as many numbers as columns"
Numbers = np.ndarray[tuple[int], np.dtype[np.int64]]


def read_recording(path: Path) -> Recording:
    """Return the recording of a CSV file.

    Raises
    ------
    BadInput
        With each line that cannot be used: what is wrong and what would be right.
    """
    return recording_of(text_of(path, MOST_BYTES), str(path))


def recording_of(text: str, file: str) -> Recording:
    """Return the recording a CSV text tells; `file` is its name for messages."""
    header, after = _header(text, file)
    order = columns_of(header.split(","), f"{file}:{after}")
    rows, bad = _table(text, file, after, len(order))
    unreadable = {each.where for each in bad}
    return checked_recording(rows[:, np.argsort(order)], _Lines(text, file, after, unreadable), bad)


class Places(Protocol):
    """Tells where a row of a recording stands."""

    file: str

    def where(self, rows: list[int]) -> list[str]:
        """Return where rows counted from 0 are, for messages."""
        ...


class _Lines:
    """Finds the line of a row; looked for only when there is something to complain about."""

    def __init__(self, text: str, file: str, after: int, left_out: Collection[str] = ()) -> None:
        self.text, self.file, self.after, self.left_out = text, file, after, left_out

    def where(self, rows: list[int]) -> list[str]:
        """Return ``file:line`` of rows counted from 0."""
        every = (f"{self.file}:{number}" for number, _ in _data_lines(self.text, self.after))
        known = [where for where in every if where not in self.left_out]
        return [known[row] for row in rows]


def _header(text: str, file: str) -> tuple[str, int]:
    """Return the first line that is no comment, and its number."""
    for number, line in enumerate(io.StringIO(text), start=1):
        bare = line.split("#", 1)[0].strip()
        if bare:
            return bare, number
    raise BadInput.one(f"{file}:1", "the file is empty", f"begin with {','.join(COLUMNS)}")


def _data_lines(text: str, after: int) -> Iterable[tuple[int, str]]:
    lines = enumerate(io.StringIO(text), start=1)
    for number, line in islice(lines, after, None):
        bare = line.split("#", 1)[0].strip()
        if bare:
            yield number, bare


def _table(text: str, file: str, after: int, columns: int) -> tuple[Array, list[Problem]]:
    """Return the numbers below the header, shape (n, columns), and what is wrong with lines.

    What lines that cannot be read would have told is left out.
    """
    start = _offset_after(text, after)
    if next(iter(_data_lines(text, after)), None) is None:
        raise BadInput.one(f"{file}:{after}", "there are no samples below the header", SAMPLES)
    try:
        table = np.loadtxt(io.StringIO(text[start:]), delimiter=",", ndmin=2)
    except ValueError:
        table = np.empty((0, 0))
    if table.shape[1] == columns:
        return table, []
    return _readable(text, file, after, columns)


def _readable(text: str, file: str, after: int, columns: int) -> tuple[Array, list[Problem]]:
    """Return the numbers of the lines that can be read, and complaints about the others."""
    problems, rows = [], []
    for number, line in _data_lines(text, after):
        cells = line.split(",")
        what = _why_bad(cells, columns)
        if what:
            right = f"{columns} numbers separated by commas, as in the header"
            problems.append(Problem(f"{file}:{number}", what, right))
        else:
            rows.append([float(cell) for cell in cells])
    return np.array(rows, dtype=float).reshape(len(rows), columns), problems


def _offset_after(text: str, lines: int) -> int:
    offset = 0
    for _ in range(lines):
        offset = text.find("\n", offset) + 1 or len(text)
    return offset


def _why_bad(cells: list[str], columns: int) -> str:
    if len(cells) != columns:
        return f"{len(cells)} values"
    for cell in cells:
        try:
            float(cell)
        except ValueError:
            return f"{cell.strip()[:40]!r} is not a number"
        if "_" in cell:
            return f"{cell.strip()[:40]!r} is not a number"
    return ""


def _few(problems: Sequence[Problem]) -> list[Problem]:
    """Return problems in the order of their lines; of very many only how many there are."""
    told = sorted(problems, key=_number)
    if len(told) <= MOST_PROBLEMS:
        return told
    last, more = told[MOST_PROBLEMS - 1], len(told) - MOST_PROBLEMS
    counted = Problem(last.where, f"and {more} more problems below", "mend these first")
    return [*told[:MOST_PROBLEMS], counted]


def _number(problem: Problem) -> int:
    found = re.search(r"\d+$", problem.where)
    return int(found.group()) if found else 0


def checked_recording(table: Array, lines: Places, others: Sequence[Problem] = ()) -> Recording:
    """Return a recording from columns in the order of `COLUMNS`, or raise `BadInput`.

    Parameters
    ----------
    table : array, shape (n, 8) or (n, 9)
    lines : Places
        Of the rows.
    others : sequence of Problem
        Found already; told with the rest.
    """
    problems = [*others, *_problems(table, lines, whole=not others)]
    if problems:
        raise BadInput(_few(problems))
    quats, length = table[:, 4:8], np.linalg.norm(table[:, 4:8], axis=1, keepdims=True)
    quats = np.where(np.abs(length - 1.0) > EXACTLY_UNIT, quat_normalize(quats), quats)
    path = np.concatenate([table[:, 1:4], quat_continuous(quats)], axis=1)
    return Recording(table[:, 0], path, table[:, 8] if table.shape[1] > 8 else None)


def _problems(table: Array, lines: Places, *, whole: bool) -> list[Problem]:
    finite = np.isfinite(table).all(axis=1)
    if not finite.all():
        wrong = np.flatnonzero(~finite)
        found = _at(wrong, lines, "a value is NaN or infinite", "leave the line out")
        return found + _problems(table[finite], _Among(lines, np.flatnonzero(finite)), whole=False)
    with np.errstate(over="ignore"):
        length = np.linalg.norm(table[:, 4:8], axis=1)
    return [
        *_at(
            np.flatnonzero(np.diff(table[:, 0]) < 0) + 1,
            lines,
            "time runs backward",
            "t_s must not decrease",
        ),
        *_at(
            np.flatnonzero(np.abs(length - 1.0) > NEARLY_UNIT),
            lines,
            "the quaternion's length is not 1",
            "qx,qy,qz,qw of a rotation",
        ),
        *_too_far(table, lines),
        *_too_seldom(table, lines),
        *(_too_few(table, lines) if whole else ()),
    ]


class _Among:
    """Some rows of others, told where those are."""

    def __init__(self, lines: Places, rows: Numbers) -> None:
        self.file, self._lines, self._rows = lines.file, lines, rows

    def where(self, rows: list[int]) -> list[str]:
        """Return where rows counted from 0 are."""
        return self._lines.where(self._rows[rows].tolist())


def _too_few(table: Array, lines: Places) -> list[Problem]:
    """Complain about a recording in which hardly anything, or no time, passes."""
    last = np.array([len(table) - 1])
    if len(table) < FEWEST_SAMPLES:
        many = "1 sample" if len(table) == 1 else f"{len(table)} samples"
        return _at(last, lines, f"only {many}", f"a recording has at least {FEWEST_SAMPLES}")
    if table[0, 0] == table[-1, 0]:
        return _at(last, lines, "no time passes", "t_s in seconds of every sample")
    return []


def _too_far(table: Array, lines: Places) -> list[Problem]:
    """Complain about values that can only be millimetres."""
    far = np.flatnonzero((np.abs(table[:, 1:4]) > FARTHEST_M).any(axis=1))
    right = "x_m, y_m and z_m are in metres (is this mm?)"
    problems = _at(far[:1], lines, f"the hand is more than {FARTHEST_M:.0f} m away", right)
    if table.shape[1] > 8:
        wide = np.flatnonzero(np.abs(table[:, 8]) > WIDEST_M)
        what = f"the gripper is open by more than {WIDEST_M:.0f} m"
        problems += _at(wide[:1], lines, what, "gripper_m is in metres (is this mm?)")
    return problems


def _too_seldom(table: Array, lines: Places) -> list[Problem]:
    """Complain about times that can only be milliseconds."""
    with np.errstate(over="ignore"):
        steps_s = np.diff(table[:, 0])
    steps_s = steps_s[steps_s > 0]
    if len(steps_s) == 0 or np.median(steps_s) <= SELDOM_S:
        return []
    what = f"the samples are {np.median(steps_s):g} s apart"
    return _at(np.array([0]), lines, what, "t_s is in seconds (is this ms?)")


def _at(rows: Numbers, lines: Places, what: str, right: str) -> list[Problem]:
    if len(rows) == 0:
        return []
    return [Problem(where, what, right) for where in lines.where(rows.tolist())]


def write_recording(recording: Recording, path: Path) -> None:
    """Write a recording as CSV, every number exactly."""
    write_text(path, recording_text(recording))


def recording_text(recording: Recording) -> str:
    """Return the CSV text of a recording."""
    columns = [recording.t_s[:, None], recording.path]
    if recording.gripper_m is not None:
        columns.append(recording.gripper_m[:, None])
    rows = np.concatenate(columns, axis=1)
    header = ",".join(COLUMNS[: rows.shape[1]])
    return "\n".join([header, *(",".join(map(repr, row)) for row in rows.tolist()), ""])
