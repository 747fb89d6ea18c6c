"""Halting a run whose conditions are not met: watched at every boundary between primitives.

Source: paper III-C c; design, safety. What the arm must notice at once (contact, tracking, a
body lost from the hand) it notices itself, in every tick; here is what a task says of its own
steps. A run that crosses from one primitive to the next is looked at in that very tick.
"""

from __future__ import annotations

from dataclasses import replace

from assistant.model.motion import ArmReport
from assistant.ports import Arm
from assistant.session.conditions import (
    Expected,
    Surroundings,
    Unmet,
    When,
    first_unmet,
    still_to_come,
)

UNMET = "unmet"
"""Why the arm is stopped."""


class Heeding:
    """Ticks an arm through one run and stops it where a condition is not met.

    Parameters
    ----------
    arm : Arm
        The motion has been started.
    conditions : Expected
        Of all primitives.
    around : Surroundings
    done : int
        The primitive a run that is gone on with was in; its own beginning is past. -1 for none.
    """

    def __init__(
        self, arm: Arm, conditions: Expected, around: Surroundings, done: int = -1
    ) -> None:
        self._arm, self._conditions, self._around = arm, conditions, around
        self._unmet: Unmet | None = None
        self._next: ArmReport | None = None
        self.done = done

    def tick(self) -> tuple[ArmReport, ...]:
        """Let one control period pass and return what there is to tell.

        The first report of an unmet condition follows when the arm has come to rest.
        """
        told = tuple(told for report in self._arm.tick() for told in self._heeded(report))
        return (*told, *self._looked_again())

    def _heeded(self, report: ArmReport) -> tuple[ArmReport, ...]:
        if self._unmet is not None:
            return self._braking(report, self._unmet)
        if self._next is not None and report.text == "docked":
            return (*self._crossed(self._next, last=True), *self._heeded(report))
        if report.kind == "primitive" and report.primitive_at != self.done:
            return self._crossed(report)
        if report.kind == "finished" and (unmet := self._missed(self.done, "until")):
            # At rest already; what was measured at the end is kept.
            return (_told(report, unmet),)
        return (report,)

    def _looked_again(self) -> tuple[ArmReport, ...]:
        """Begin the next primitive, once the one before has ended as it is to end."""
        if self._next is None or self._unmet or self._missed(self.done, "until"):
            return ()
        return self._crossed(self._next)

    def _crossed(self, report: ArmReport, *, last: bool = False) -> tuple[ArmReport, ...]:
        self._next = None
        if unmet := self._missed(self.done, "until"):
            if not last and still_to_come(unmet, report.primitive_at, self._around.path):
                self._next = report
                return ()
            # The next primitive does not begin.
            self._stop(unmet)
            return ()
        self.done = -1
        if unmet := self._missed(report.primitive_at, "before"):
            self._stop(unmet)
        else:
            self.done = report.primitive_at
        return (report,)

    def _braking(self, report: ArmReport, unmet: Unmet) -> tuple[ArmReport, ...]:
        if report.kind == "halted":
            return (_told(report, unmet),)
        return () if report.kind == "primitive" else (report,)

    def _missed(self, primitive_at: int, when: When) -> Unmet | None:
        return first_unmet(self._conditions, primitive_at, when, self._around, self._arm.look())

    def _stop(self, unmet: Unmet) -> None:
        self._unmet = unmet
        self._arm.stop(UNMET)


def _told(report: ArmReport, unmet: Unmet) -> ArmReport:
    return replace(
        report,
        kind="unmet",
        primitive_at=unmet.primitive_at,
        text=unmet.condition.kind,
        object=unmet.condition.object or "",
        target=unmet.condition.target or "",
        when=unmet.when,
        found=unmet.found,
    )
