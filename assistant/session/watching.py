"""Watching a demonstration: samples come in, stream to disk, and are whole at any instant.

Source: paper II-B; the samples of a killed session are read back and kept.
"""

from __future__ import annotations

import csv
import itertools
from collections.abc import Iterable
from dataclasses import dataclass, field, replace
from pathlib import Path

import numpy as np

from assistant.dialogue.events import Event, Heard, Shown
from assistant.files.recordings import FEWEST_SAMPLES
from assistant.geometry import Array
from assistant.model.demonstration import Demonstration, Recording, Spoken
from assistant.model.listening import Understanding
from assistant.model.setup import Setup
from assistant.model.teacher_acts import Cue, KeyState
from assistant.ports import HandSample

HEADER = "t_s,x_m,y_m,z_m,qx,qy,qz,qw,gripper_m"


@dataclass(slots=True)
class Watching:
    """A demonstration while it is being shown.

    Parameters
    ----------
    path : Path or None
        The CSV file samples stream to; None where nothing can be written.
    """

    path: Path | None
    samples: list[HandSample] = field(default_factory=list)
    cues: list[Spoken] = field(default_factory=list)
    key_states: list[Spoken] = field(default_factory=list)
    trouble: str = ""
    _offset_s: float = 0.0

    @property
    def now_s(self) -> float:
        """The recording's clock."""
        return self.samples[-1].t_s if self.samples else 0.0

    @property
    def shown_s(self) -> float:
        """The last instant on the hand's own clock; before zero where nothing was shown."""
        return self.samples[-1].t_s - self._offset_s if self.samples else -1.0

    def said_s(self, event: Event) -> float:
        """Return when words began on the recording's clock; anything else happens now."""
        ago_s = event.ago_s if isinstance(event, Heard) else 0.0
        return max(self.now_s - ago_s, 0.0)

    def go_on(self) -> None:
        """Let the next hand's clock continue where the last one's ended."""
        step = self.samples[-1].t_s - self.samples[-2].t_s if len(self.samples) > 1 else 0.02
        self._offset_s = self.now_s + step if self.samples else 0.0

    def see(self, sample: HandSample) -> None:
        """Take a sample and put it on disk."""
        sample = replace(sample, t_s=sample.t_s + self._offset_s)
        self.samples.append(sample)
        if self.path is None or self.trouble:
            return
        try:
            self._write(self.path, sample)
        except OSError as error:
            self.trouble = f"{self.path}: {error.strerror}"

    def take_back(self, to_s: float) -> None:
        """Forget what was shown, and said, from an instant of the hand's clock on."""
        to_s += self._offset_s
        self.samples = [one for one in self.samples if one.t_s < to_s - 1e-9]
        self.cues = [one for one in self.cues if one.at_s < to_s]
        self.key_states = [one for one in self.key_states if one.at_s < to_s]
        if self.path is None or self.trouble:
            return
        try:
            self.path.unlink(missing_ok=True)
            for sample in self.samples:
                self._write(self.path, sample)
        except OSError as error:
            self.trouble = f"{self.path}: {error.strerror}"

    def hear(self, text: str, understood: Understanding, at_s: float | None = None) -> None:
        """Keep words that mark a transition or a key state."""
        spoken = Spoken(self.now_s if at_s is None else at_s, text)
        if any(isinstance(act, Cue) for act in understood.acts):
            self.cues.append(spoken)
        if any(isinstance(act, KeyState) for act in understood.acts):
            self.key_states.append(spoken)

    def declare(self, cues: Iterable[Spoken], key_states: Iterable[Spoken]) -> None:
        """Take words told beforehand as what they were told to be, at their exact times."""
        self.cues = [replace(cue, at_s=cue.at_s + self._offset_s) for cue in cues]
        self.key_states = [replace(one, at_s=one.at_s + self._offset_s) for one in key_states]

    def _write(self, path: Path, sample: HandSample) -> None:
        numbers = [sample.t_s, *(float(x) for x in sample.pose)]
        if sample.gripper_m is not None:
            numbers.append(float(sample.gripper_m))
        new = not path.exists()
        with path.open("a", encoding="utf-8") as file:
            if new:
                columns = HEADER if sample.gripper_m is not None else HEADER.rsplit(",", 1)[0]
                file.write(columns + "\n")
            file.write(",".join(repr(number) for number in numbers) + "\n")

    def shown(self, setup: Setup) -> Shown:
        """Return what was shown as an event; too few samples are no demonstration."""
        if len(self.samples) < FEWEST_SAMPLES:
            return Shown(None, "too_short")
        return Shown(self.demonstration(setup, self.path.name if self.path else "live"))

    def demonstration(self, setup: Setup, source: str) -> Demonstration:
        """Return what has been seen and heard so far."""
        return Demonstration(
            recording(self.samples), tuple(self.cues), tuple(self.key_states), setup, source=source
        )


def recording(samples: list[HandSample]) -> Recording:
    """Return samples as arrays; the gripper is unknown if any sample does not know it."""
    openings = [sample.gripper_m for sample in samples]
    gripper: Array | None = None
    if None not in openings:
        gripper = np.array([opening for opening in openings if opening is not None])
    path = np.array([sample.pose for sample in samples]).reshape(-1, 7)
    return Recording(np.array([sample.t_s for sample in samples]), path, gripper)


def read_back(path: Path) -> list[HandSample]:
    """Return the whole samples of a recording that may end in a torn line."""
    if not path.is_file():
        return []
    lines = path.read_text(encoding="utf-8").split("\n")
    # What follows the last line break was cut off while being written.
    whole = lines[1:-1]
    return [_sample(row) for row in csv.reader(itertools.takewhile(bool, whole))]


def _sample(row: list[str]) -> HandSample:
    numbers = [float(text) for text in row]
    opening = numbers[8] if len(numbers) > 8 else None
    return HandSample(numbers[0], np.array(numbers[1:8]), opening)
