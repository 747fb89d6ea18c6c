"""What recognizers made of a clip, kept in a folder: what follows them is measured in seconds.

A recognizer takes most of a benchmark's time and gives the same readings for the same sound and
hot words, so its readings are kept once made, with the processor's time they took.
"""

from __future__ import annotations

import hashlib
import json
import time
from collections.abc import Sequence
from pathlib import Path

import numpy as np

from assistant.shells.voice.recognized import Recognized, Recognizer, Rereader, Weigher
from assistant.shells.voice.sound import Samples


class Remembered:
    """A recognizer whose readings are looked up before they are made.

    Parameters
    ----------
    recognizer : Recognizer
    folder : Path
    """

    def __init__(self, recognizer: Recognizer, folder: Path) -> None:
        self._recognizer = recognizer
        self.name = recognizer.name
        self._file = folder / f"{''.join(filter(str.isalnum, self.name))}.jsonl"
        self._known: dict[str, tuple[tuple[Recognized, ...], float]] = {}
        self.took_s: list[float] = []
        if self._file.is_file():
            for line in self._file.read_text().splitlines():
                key, took_s, readings = json.loads(line)
                self._known[key] = (tuple(Recognized(*one) for one in readings), took_s)

    def recognize(
        self, samples: Samples, hot_words: Sequence[str] = (), *, loud: bool = False
    ) -> tuple[Recognized, ...]:
        """Return the readings, made now or earlier; `took_s` gains the time they took."""
        key = _key(samples, (*hot_words, "loud") if loud else hot_words)
        if key not in self._known:
            began_s = time.process_time()
            readings = self._recognizer.recognize(samples, hot_words, loud=loud)
            self._keep(key, readings, time.process_time() - began_s)
        readings, took_s = self._known[key]
        self.took_s.append(took_s)
        return readings

    def reread(self, samples: Samples) -> tuple[Recognized, ...]:
        """Return what else may have been read, made now or earlier; none where it cannot tell."""
        if not isinstance(self._recognizer, Rereader):
            return ()
        key = _key(samples, ("reread",))
        if key not in self._known:
            began_s = time.process_time()
            readings = self._recognizer.reread(samples)
            self._keep(key, readings, time.process_time() - began_s)
        readings, took_s = self._known[key]
        self.took_s[-1] += took_s
        return readings

    def likelihoods(
        self, samples: Samples, phrases: Sequence[str], *, loud: bool = False
    ) -> tuple[float, ...]:
        """Return how well phrases explain the sound, asking only about those not asked before."""
        kind = "loud likelihood" if loud else "likelihood"
        keys = [_key(samples, (kind, phrase)) for phrase in phrases]
        new = [phrase for key, phrase in zip(keys, phrases, strict=True) if key not in self._known]
        if new:
            assert isinstance(self._recognizer, Weigher)
            began_s = time.process_time()
            told = self._recognizer.likelihoods(samples, new, loud=loud)
            took_s = (time.process_time() - began_s) / len(new)
            for phrase, likelihood in zip(new, told, strict=True):
                one = (Recognized(phrase, round(likelihood, 3)),)
                self._keep(_key(samples, (kind, phrase)), one, took_s)
        self.took_s[-1] += sum(self._known[key][1] for key in keys)
        return tuple(self._known[key][0][0].sure for key in keys)

    def _keep(self, key: str, readings: tuple[Recognized, ...], took_s: float) -> None:
        self._known[key] = (readings, took_s)
        line = json.dumps([key, took_s, [[one.text, one.sure] for one in readings]])
        self._file.parent.mkdir(parents=True, exist_ok=True)
        with self._file.open("a") as file:
            file.write(f"{line}\n")


def _key(samples: Samples, words: Sequence[str]) -> str:
    rounded = np.round(np.asarray(samples) * 32767).astype(np.int16)
    return hashlib.sha256(rounded.tobytes() + "|".join(words).encode()).hexdigest()[:24]
