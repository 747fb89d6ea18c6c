"""Recordings in other dress: JSON columns, as NumPy's npz, checked like CSV."""

from __future__ import annotations

import io
import zipfile
from pathlib import Path

import numpy as np

from assistant.errors import BadInput
from assistant.files.columns import COLUMNS, columns_of
from assistant.files.forms import shape_of
from assistant.files.recordings import checked_recording
from assistant.files.writing import write_bytes
from assistant.geometry import Array
from assistant.model.demonstration import Recording
from assistant.plain_yaml import Document

MOST_BYTES = 256_000_000


class Rows:
    """Tells of a row by its number, where a file has no lines."""

    def __init__(self, file: str) -> None:
        self.file = file

    def where(self, rows: list[int]) -> list[str]:
        """Return where rows counted from 0 are."""
        return [f"{self.file}: sample {row + 1}" for row in rows]


def recording_of_columns(columns: dict[str, Array], file: str) -> Recording:
    """Return the recording of named columns, shape (n,) each, or raise `BadInput`."""
    order = columns_of(list(columns), file)
    lengths = {len(column) for column in columns.values()}
    if len(lengths) != 1:
        raise BadInput.one(file, "the columns have different lengths", "as many in each")
    table = np.stack(list(columns.values()), axis=1)[:, np.argsort(order)]
    return checked_recording(table, Rows(file))


def recording_of_json(document: Document) -> Recording:
    """Return the recording a JSON document tells as columns of numbers."""
    if document.flaws:
        raise BadInput(document.flaws)
    value = document.value
    columns: dict[str, Array] = {}
    for name, column in value.items() if isinstance(value, dict) else ():
        numbers = isinstance(column, list) and all(shape_of(x) == "a number" for x in column)
        if not numbers:
            right = "[0.0, 0.1, ...]"
            raise BadInput.one(document.where([name]), f"{name} is not a list of numbers", right)
        columns[name] = np.array(column, dtype=float)
    return recording_of_columns(columns, document.file)


def read_npz(path: Path) -> Recording:
    """Return the recording of an npz file with one array a column."""
    try:
        with zipfile.ZipFile(path) as packed:
            size = sum(each.file_size for each in packed.infolist())
        if size > MOST_BYTES:
            raise BadInput.one(str(path), f"{size / 1e6:.0f} MB when unpacked", "a smaller file")
        with np.load(path, allow_pickle=False) as arrays:
            columns = {name: np.asarray(arrays[name], dtype=float) for name in arrays.files}
    except (OSError, ValueError, zipfile.BadZipFile) as error:
        raise BadInput.one(str(path), f"no npz file ({error})", "one array a column") from error
    if any(column.ndim != 1 for column in columns.values()):
        raise BadInput.one(str(path), "an array is not a column", f"arrays {', '.join(COLUMNS)}")
    return recording_of_columns(columns, str(path))


def write_npz(recording: Recording, path: Path) -> None:
    """Write a recording as npz with one array a column."""
    names = COLUMNS if recording.gripper_m is not None else COLUMNS[:-1]
    arrays = [recording.t_s, *recording.path.T]
    if recording.gripper_m is not None:
        arrays.append(recording.gripper_m)
    packed = io.BytesIO()
    np.savez_compressed(packed, **dict(zip(names, arrays, strict=True)))
    write_bytes(path, packed.getvalue())
