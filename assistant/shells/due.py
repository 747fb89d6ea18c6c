"""Which samples of a hand driven by keys are recorded, and since when."""

from __future__ import annotations

from dataclasses import replace

from assistant.ports import HandSample

PERIOD_S = 0.02


class Due:
    """Tells which samples to record: one in every so many seconds, and all that carry words."""

    def __init__(self, every_s: float) -> None:
        self._every_s, self._next_s = every_s, 0.0

    def __call__(self, sample: HandSample) -> bool:
        """Whether this sample is to be recorded."""
        # What was taken back is shown anew.
        self._next_s = min(self._next_s, sample.t_s + self._every_s)
        if not sample.said and sample.t_s < self._next_s - PERIOD_S / 2:
            return False
        self._next_s = sample.t_s + self._every_s
        return True


class Begun:
    """Lets samples pass from when the teacher begins, on a clock that begins then.

    Whoever still reads what the keys do shows nothing.
    """

    def __init__(self) -> None:
        self._begins = False
        self._since_s: float | None = None

    def begin(self) -> None:
        """Take note that the teacher does something."""
        self._begins = True

    def __call__(self, sample: HandSample) -> HandSample | None:
        """Return a sample on the demonstration's clock; None before it begins."""
        if self._since_s is not None and sample.t_s < self._since_s:
            # Everything was taken back.
            self._since_s, self._begins = None, False
        if self._since_s is None and not (self._begins or sample.said):
            return None
        self._since_s = sample.t_s if self._since_s is None else self._since_s
        return replace(sample, t_s=sample.t_s - self._since_s)
