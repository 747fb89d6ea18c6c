"""The columns of a recording, and what to say about others."""

from __future__ import annotations

from assistant.errors import BadInput, Problem

COLUMNS = ("t_s", "x_m", "y_m", "z_m", "qx", "qy", "qz", "qw", "gripper_m")
NEEDED = COLUMNS[:-1]
LONGEST, MOST = 40, 40
"""Of names and columns that are looked at; a file with more is something else."""
LEAVE_OUT = "leave it out"
_SCALES = {"mm": "divide by 1000", "cm": "divide by 100", "um": "divide by 1e6"}
_TIMES = {"ms": "divide by 1000", "us": "divide by 1e6", "ns": "divide by 1e9"}
_OTHER_NAMES = {
    **dict.fromkeys(("t", "time", "timestamp", "time_s", "seconds"), "t_s"),
    **{axis: f"{axis}_m" for axis in "xyz"},
    **{f"{word}_{axis}": f"{axis}_m" for axis in "xyz" for word in ("pos", "position", "p")},
    **{f"{word}_{axis}": f"q{axis}" for axis in "xyzw" for word in ("q", "quat", "quaternion")},
    **dict.fromkeys(("gripper", "grip", "width", "opening", "gripper_width"), "gripper_m"),
}


def columns_of(header: list[str], where: str) -> list[int]:
    """Return for each column of a file its position in `COLUMNS`.

    Raises
    ------
    BadInput
        With every column that is missing, twice there, or of another name or unit.
    """
    names = [name.strip().strip('"').strip()[:LONGEST] for name in header[:MOST]]
    if any(_is_number(name) for name in names) or (len(names) == 1 and names[0] not in COLUMNS):
        raise BadInput.one(where, _no_header(names), f"the first line is {','.join(COLUMNS)}")
    unknown = [name for name in dict.fromkeys(names) if name not in COLUMNS]
    if all(name in unknown and _meant(name) == LEAVE_OUT for name in names):
        raise BadInput.one(where, "this is no recording", f"the first line is {','.join(COLUMNS)}")
    problems = [Problem(where, f"column {name!r} is not known", _meant(name)) for name in unknown]
    twice = sorted({name for name in names if names.count(name) > 1})
    problems += [Problem(where, f"column {name!r} stands there twice", "once") for name in twice]
    missing = [name for name in NEEDED if name not in names]
    if missing:
        right = f"the first line is {','.join(COLUMNS)}"
        problems.append(Problem(where, f"missing: {', '.join(missing)}", right))
    if problems:
        raise BadInput(problems)
    return [COLUMNS.index(name) for name in names]


def _no_header(names: list[str]) -> str:
    if len(names) > 1:
        return "there is no header"
    for separator, told in ((";", "semicolons"), ("\t", "tabs")):
        if separator in names[0]:
            return f"columns are separated by {told}, not by commas"
    return "this is no recording"


def _meant(name: str) -> str:
    """Return what to do about a column with another name or unit."""
    low = name.lower()
    stem, _, unit = low.rpartition("_")
    meant = _OTHER_NAMES.get(stem, stem)
    if unit in _SCALES and meant in COLUMNS:
        return f"{meant} in metres: {_SCALES[unit]}"
    if unit in _TIMES and meant == "t_s":
        return f"t_s in seconds: {_TIMES[unit]}"
    if low in _OTHER_NAMES:
        other = _OTHER_NAMES[low]
        unit = {"s": " (in seconds)", "m": " (in metres)"}.get(other.rpartition("_")[2], "")
        return f"call it {other}{unit}"
    if low in COLUMNS:
        return f"call it {low}"
    return LEAVE_OUT


def _is_number(text: str) -> bool:
    try:
        float(text)
    except ValueError:
        return False
    return True
