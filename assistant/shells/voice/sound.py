"""Sound as one shape: mono, 16 kHz, float32 in [-1, 1]; read from WAV and FLAC files."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from math import gcd
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from assistant.errors import BadInput, Problem

RATE_HZ = 16_000
PIECE_S = 20
Samples = NDArray[np.float32]


@dataclass(frozen=True, slots=True, eq=False)
class Sound:
    """A stretch of sound and when it began.

    Parameters
    ----------
    samples : array of float32, shape (n,)
        Mono at 16 kHz.
    from_s : float
        On the clock of whatever it was cut from.
    """

    samples: Samples
    from_s: float = 0.0

    @property
    def duration_s(self) -> float:
        """How long it is."""
        return len(self.samples) / RATE_HZ

    def cut(self, from_s: float, to_s: float) -> Sound:
        """Return a part, times counted from this sound's own beginning."""
        first, last = (max(0, round(at_s * RATE_HZ)) for at_s in (from_s, to_s))
        return Sound(self.samples[first:last], self.from_s + first / RATE_HZ)


def to_16k_mono(samples: NDArray[Any], rate_hz: int) -> Samples:
    """Return sound of any rate and number of channels as mono at 16 kHz.

    Parameters
    ----------
    samples : array, shape (n,) or (n, channels)
        In [-1, 1].
    rate_hz : int
    """
    mono = samples.mean(axis=1) if samples.ndim == 2 else samples
    if rate_hz != RATE_HZ:
        from scipy.signal import resample_poly

        common = gcd(RATE_HZ, rate_hz)
        mono = resample_poly(mono, RATE_HZ // common, rate_hz // common)
    return np.asarray(mono, dtype=np.float32)


def read_sound(path: Path) -> Sound:
    """Read a whole WAV or FLAC file of any rate and number of channels.

    Raises
    ------
    BadInput
        If the file is not there, is no sound, or holds numbers that are not finite.
    """
    pieces = [piece.samples for piece in sound_pieces(path)]
    return Sound(np.concatenate(pieces) if pieces else np.zeros(0, dtype=np.float32))


def sound_pieces(path: Path) -> Iterator[Sound]:
    """Yield a WAV or FLAC file in pieces of some seconds, so that an hour takes no more memory.

    Raises
    ------
    BadInput
        As `read_sound`.
    """
    import soundfile

    if not path.is_file():
        raise BadInput.one(str(path), "no such file", "a WAV or FLAC file")
    try:
        with soundfile.SoundFile(path) as file:
            yield from _pieces(file, path)
    except (soundfile.SoundFileError, OSError) as error:
        raise BadInput.one(str(path), "this is not a sound file", "a WAV or FLAC file") from error


def _pieces(file: Any, path: Path) -> Iterator[Sound]:
    rate_hz = file.samplerate
    from_s = 0.0
    margin = np.zeros((0, file.channels), dtype=np.float32)
    while len(read := file.read(PIECE_S * rate_hz, dtype="float32", always_2d=True)):
        if not np.all(np.isfinite(read)):
            raise BadInput.one(str(path), "samples that are not numbers", "finite samples")
        # Resampled with a margin of what came before, so that a seam is hardly heard.
        made = to_16k_mono(np.concatenate([margin, read]), rate_hz)
        piece = made[round(len(margin) * RATE_HZ / rate_hz) :]
        yield Sound(piece, from_s)
        from_s += len(piece) / RATE_HZ
        margin = read[-(rate_hz // 10) :]


def check_sounds(paths: Iterable[Path]) -> None:
    """Raise BadInput with all the files that are missing or are no sound."""
    problems: list[Problem] = []
    for path in paths:
        try:
            next(sound_pieces(path), None)
        except BadInput as error:
            problems += error.problems
    if problems:
        raise BadInput(problems)


def length_s(path: Path) -> float:
    """Return how long a sound file is, by its header; 0 if it has none that can be read."""
    import soundfile

    try:
        told = soundfile.info(path)
    except (soundfile.SoundFileError, OSError):
        return 0.0
    return float(told.frames / told.samplerate)


def write_sound(path: Path, sound: Sound) -> None:
    """Write 16 kHz mono sound as a WAV or FLAC file, by its ending."""
    import soundfile

    try:
        soundfile.write(path, sound.samples, RATE_HZ)
    except (soundfile.SoundFileError, OSError, TypeError, ValueError) as error:
        right = "a folder that can be written to, and the ending .wav or .flac"
        raise BadInput.one(str(path), "cannot write the sound", right) from error
