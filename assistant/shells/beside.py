"""What listens beside a typed shell, and the words it hears."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Protocol

from assistant.session.loop import Session


@dataclass(frozen=True, slots=True)
class Words:
    """Words that were heard, not typed.

    Parameters
    ----------
    text : str
    sure : float
        How surely they were recognized, in [0, 1].
    ago_s : float
        How long ago the first of them began.
    """

    text: str
    sure: float
    ago_s: float


class Beside(Protocol):
    """Listens beside typing, from the time the session is open."""

    def begin(self, session: Session, take: Callable[[Words], None]) -> None:
        """Begin to hear for a session; words are given to `take` in another thread."""
        ...

    def finish(self) -> None:
        """Wait until everything there is to hear has been heard."""
        ...
