"""What is told to move, or to be elsewhere, waits until an arm that brakes has come to rest.

A stop, or a condition that is not met, discards what would move. Where things are told to be is
no motion: that is not taken back.
"""

from __future__ import annotations

from dataclasses import replace

from assistant.dialogue import effects as wanted
from assistant.dialogue.events import ArmReported, Event
from assistant.model.motion import GOING_ON, ArmReport


class Latch:
    """Keeps effects, in their order, until the arm stands."""

    def __init__(self) -> None:
        self._kept: tuple[wanted.Effect, ...] = ()

    def keeps(self, effect: wanted.Effect) -> bool:
        """Keep an effect that has to wait for rest; tell whether it was kept.

        Nor are things looked at before they are where they are told to be.
        """
        follows = isinstance(effect, wanted.Check) and any(map(_arranges, self._kept))
        if not (_moves(effect) or _arranges(effect) or follows):
            return False
        self._kept = (*self._kept, effect)
        return True

    def clear(self) -> None:
        """Forget all, for everything was put in place anew."""
        self._kept = ()

    def discard(self) -> None:
        """Forget what would move."""
        self._kept = tuple(filter(_arranges, self._kept))

    def released(self, event: Event) -> tuple[wanted.Effect, ...]:
        """Return what was kept, once the dialogue has heard that the arm stands."""
        if not isinstance(event, ArmReported) or event.report.text != GOING_ON:
            return ()
        kept, self._kept = self._kept, ()
        return kept

    def before(self, reports: tuple[ArmReport, ...]) -> tuple[ArmReport, ...]:
        """Return the reports of an end, which is none of what was kept to come after it."""
        if any(report.kind == "unmet" for report in reports):
            # Who said it did not know what went wrong.
            self.discard()
        if not self._kept:
            return reports
        *before, last = reports
        return (*before, replace(last, kind="halted", text=GOING_ON))


def _arranges(effect: wanted.Effect) -> bool:
    return isinstance(effect, wanted.Arrange)


def _moves(effect: wanted.Effect) -> bool:
    """Whether an effect moves the arm, or is planned from where it stands."""
    if isinstance(effect, wanted.GoOn | wanted.Check):
        return effect.anew
    begins = wanted.Move | wanted.Replay | wanted.SetHand | wanted.Jog | wanted.Home
    return isinstance(effect, begins)
