"""A recording as the teacher's hand: it is shown again, sample by sample, with its words."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from assistant.geometry import Array
from assistant.model.demonstration import Demonstration, Spoken
from assistant.ports import HandSample


class RecordedHand:
    """The Hand port over a demonstration that was recorded before."""

    def __init__(self, demonstration: Demonstration) -> None:
        self.demonstration = demonstration

    def samples(self) -> Iterator[HandSample]:
        """Yield the samples in order, each with what was said since the one before."""
        shown = self.demonstration
        spoken = (*shown.cues, *shown.key_states)
        recording = shown.recording
        yield from spoken_samples(recording.t_s, recording.path, recording.gripper_m, spoken)


def spoken_samples(
    t_s: Array, path: Array, gripper_m: Array | None, spoken: Sequence[Spoken]
) -> Iterator[HandSample]:
    """Yield samples of a recording with words attached to the first sample not before them.

    Words said within the same sample are joined by a comma; words after the last sample belong
    to it.
    """
    waiting = sorted(spoken, key=lambda words: words.at_s)
    last = len(t_s) - 1
    for k in range(len(t_s)):
        said: list[str] = []
        while waiting and (waiting[0].at_s <= t_s[k] or k == last):
            said.append(waiting.pop(0).say)
        opening = None if gripper_m is None else float(gripper_m[k])
        yield HandSample(float(t_s[k]), path[k], opening, ", ".join(said))
