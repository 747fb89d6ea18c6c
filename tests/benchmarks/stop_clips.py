"""Stops said while the arm moves: by the spotter, by recognition, by whichever is first."""

from __future__ import annotations

import statistics
import time
from collections.abc import Iterator
from dataclasses import dataclass, field
from pathlib import Path

import numpy as np

from assistant.model.listening import Listening
from assistant.model.teacher_acts import Stop
from assistant.shells.voice.clips import ClipReader
from assistant.shells.voice.foreground import foreground
from assistant.shells.voice.sound import RATE_HZ, Samples, Sound, read_sound
from assistant.shells.voice.spotter import HOP, StopSpotter
from tests.benchmarks.intervals import share
from tests.benchmarks.voice_clips import CHAT, in_rooms, recordings
from tests.benchmarks.voices import speakers

STOPS = ("stop", "stop it", "stop now", "please stop", "no stop", "stop the arm")
OTHERS = (
    "step two", "start again", "go up a bit", "the next step", "a bit more left", "first step",
    "stack the blocks", "top of the block", "slower please", "open the hand", "show me the tree",
    "he bought a stamp at the shop", *CHAT[:12],
)  # fmt: skip
MOVING = Listening(stage="practice", moving=True)
BEFORE_S, AFTER_S = 1.0, 0.8


@dataclass(slots=True)
class Tally:
    """What became of the clips of one kind."""

    spotted: list[bool] = field(default_factory=list)
    recognized: list[bool] = field(default_factory=list)
    late_s: list[float] = field(default_factory=list)
    took_s: list[float] = field(default_factory=list)

    def row(self, what: str, kind: str) -> str:
        """Return a row: missed of stops, false of others."""
        either = [a or b for a, b in zip(self.spotted, self.recognized, strict=True)]
        told = (self.spotted, self.recognized, either)
        missed = what == "missed"
        counts = (share(sum(one) if not missed else one.count(False), len(one)) for one in told)
        spotter, recognizer, both = counts
        # Noise hides where a word ends.
        clear = missed and " dB " not in kind
        late = f"{statistics.median(self.late_s):+.2f} s" if self.late_s and clear else ""
        return f"{kind:<22}{what:<8}{spotter:<26}{recognizer:<26}{both:<26}{late}"


def stops_table(group: str, folder: Path, reader: ClipReader, words: Path | None = None,
                human: Path | None = None, count: int = 97) -> None:  # fmt: skip
    """Print stops missed and other sentences taken for stop, with their intervals."""
    spotter = StopSpotter()
    tallies: dict[tuple[str, str], Tally] = {}
    for what, kind, samples in _clips(group, folder, words, human, count):
        tally = tallies.setdefault((what, kind), Tally())
        late_s, took_s = spotted(spotter, samples)
        tally.spotted.append(late_s is not None)
        tally.took_s.append(took_s)
        if late_s is not None:
            tally.late_s.append(late_s)
        heard = reader.read(Sound(samples), MOVING)
        tally.recognized.append(any(isinstance(act, Stop) for act in heard.acts))
    print(f"stops ({group})\n{'':<30}{'spotter':<26}{'recognition':<26}{'either':<26}late (median)")
    for (what, kind), tally in sorted(tallies.items()):
        print(tally.row(what, kind), flush=True)
    took_s = statistics.median(one for tally in tallies.values() for one in tally.took_s)
    print(f"late: the spotter after the end of the word; {took_s * 1000:.0f} ms of processor time")


def spotted(spotter: StopSpotter, samples: Samples) -> tuple[float | None, float]:
    """Return how long after the end of speech stop was spotted, and what a look took, in s."""
    spotter.reset()
    speech_s = foreground(samples).speech_s
    loud = np.flatnonzero(np.abs(samples) > 0.1 * np.max(np.abs(samples)))
    ends_s = BEFORE_S + (loud[-1] / RATE_HZ if len(loud) else speech_s)
    pads = (np.zeros(int(length_s * RATE_HZ), np.float32) for length_s in (BEFORE_S, AFTER_S))
    before, after = pads
    stream = np.concatenate([before, samples, after])
    began_s = time.process_time()
    looks = 0
    for at in range(0, len(stream) - HOP, HOP):
        looks += 1
        if spotter.hear(stream[at : at + HOP]):
            late_s = (at + HOP) / RATE_HZ - ends_s
            return late_s, (time.process_time() - began_s) / looks
    return None, (time.process_time() - began_s) / looks


def _clips(
    group: str, folder: Path, words: Path | None, human: Path | None, count: int
) -> Iterator[tuple[str, str, Samples]]:
    known = speakers(group)
    for at, text in enumerate((*STOPS * 3, *OTHERS)):
        what = "missed" if at < 3 * len(STOPS) else "false"
        for kind, samples in in_rooms(known[at % len(known)], text, group, folder):
            yield what, kind, samples
    for path in recordings(words) if words else ():
        what = "missed" if "stop" in (path.stem, path.parent.name) else "false"
        yield what, "people's words", read_sound(path).samples
    for path in recordings(human)[:count] if human else ():
        yield "false", "people's chat", read_sound(path).samples
