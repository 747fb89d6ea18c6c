"""The mouse as a hand on the arm's hand: it follows while a button is held, and no longer."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass

from prompt_toolkit.mouse_events import MouseButton, MouseEvent, MouseEventType

from assistant.session.equipment import DrivenHand
from assistant.shells.driving_picture import Sight

CHARACTERS = 2
"""A cell of a picture is so many characters wide."""


@dataclass(frozen=True, slots=True)
class Area:
    """Where a picture is on the screen, in lines and characters of the view."""

    sight: Sight
    line: int
    column: int

    def holds(self, line: int, column: int) -> bool:
        """Whether a character belongs to the picture."""
        down, right = line - self.line, column - self.column
        inside = 0 <= right < CHARACTERS * self.sight.columns
        return inside and 0 <= down < self.sight.rows


class Grip:
    """Takes the mouse's events.

    The button is the clutch: pressed in a picture it grips the hand, which then follows the
    pointer in that picture's plane, cell by cell at the usual speed; let go, the hand stops.

    Parameters
    ----------
    hand : DrivenHand
    areas : callable
        Where the pictures are now.
    """

    def __init__(self, hand: DrivenHand, areas: Callable[[], Sequence[Area]]) -> None:
        self._hand, self._areas = hand, areas
        self._held: Area | None = None
        self._last = (0, 0)

    @property
    def holds(self) -> bool:
        """Whether the mouse holds the hand."""
        return self._held is not None

    def take(self, event: MouseEvent) -> bool:
        """Take an event; return whether it concerned the hand."""
        place = (event.position.y, event.position.x)
        if self._held is not None and self._let_go(event):
            self._held = None
            self._hand.release()
            return True
        if self._held is not None and event.event_type is MouseEventType.MOUSE_MOVE:
            self._follow(self._held, place)
            return True
        if event.event_type is MouseEventType.MOUSE_DOWN:
            area = next((one for one in self._areas() if one.holds(*place)), None)
            self._held, self._last = area, place
            return area is not None
        return self._held is not None

    def _let_go(self, event: MouseEvent) -> bool:
        # Let go beyond the terminal's edge, the button is seen to be up when the pointer is back.
        moved_free = event.event_type is MouseEventType.MOUSE_MOVE
        free = moved_free and event.button in (MouseButton.NONE, MouseButton.UNKNOWN)
        return free or event.event_type is MouseEventType.MOUSE_UP

    def _follow(self, area: Area, place: tuple[int, int]) -> None:
        # Beyond the picture's edge the hand waits for the pointer to come back.
        if not area.holds(*place):
            return
        down, right = place[0] - self._last[0], (place[1] - self._last[1]) / CHARACTERS
        self._last = place
        if down or right:
            self._hand.lead(area.sight.move_m(down, right))
