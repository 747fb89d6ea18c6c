"""Lines in, lines out: for pipes and for terminals that can do no more.

From a pipe the arm runs to rest before the next line is heard, so that a prepared
conversation always goes the same way; at a terminal it moves while the teacher types.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable

from assistant.language.hints import page
from assistant.model.robot_acts import RobotAct
from assistant.session import halting
from assistant.session.acting import leave
from assistant.session.heartbeat import Heartbeat
from assistant.session.loop import Session
from assistant.shells.beating import beating
from assistant.shells.beside import Beside, Words
from assistant.shells.pacing import RealClock, Ticker
from assistant.shells.showing import Showing
from assistant.shells.wrapping import wrapped


class PlainShell:
    """Talks in plain lines.

    Parameters
    ----------
    write : callable
        Takes one line of output.
    pace : float
        How many simulated seconds pass in a real one, at a terminal.
    width : int, optional
        Lines are broken to; a pipe gets them whole.
    """

    def __init__(
        self, write: Callable[[str], None], pace: float = 1.0, width: int | None = None
    ) -> None:
        self._pace, self._width = pace, width
        self._write = write
        self._showing = Showing(self._hint)
        self._error: BaseException | None = None
        self._names: dict[str, str] = page("terminal", "english")["names"]

    def attach(self, session: Session) -> None:
        """Take note of the language of a session that is about to begin."""
        self._names = page("terminal", session.language)["names"]

    def out(self, line: RobotAct, text: str) -> None:
        """Say a robot line."""
        if self._width is None:
            self._write(f"{self._names['robot']}: {text}")
            return
        for one in wrapped(text, self._width, before=f"{self._names['robot']}: "):
            self._write(one)

    def _hint(self, text: str) -> None:
        """Write what is no line of the robot's, wrapped where there is a width."""
        for one in [text] if self._width is None else wrapped(text, self._width):
            self._write(one)

    def run(
        self,
        session: Session,
        lines: Iterable[str],
        *,
        live: bool,
        beside: Beside | None = None,
    ) -> None:
        """Hold the conversation until the robot leaves or the input ends.

        Parameters
        ----------
        session : Session
        lines : iterable of str
        live : bool
            The arm moves in real time beside the input; else it rests before each line.
        beside : Beside, optional
            What listens beside; the input has ended only when it has heard everything too.
        """
        ticker = Ticker(session, self._fail, self._pace)
        if live:
            heart = Heartbeat(RealClock())
            session.in_touch = heart.alive
            lines = beating(lines, heart.beat, session.raw)
            ticker.start()
        if beside is not None:
            beside.begin(session, lambda words: self._heard(session, ticker, words))
        try:
            for line in lines:
                session.raw(line)
                with ticker.lock:
                    self._take(session, line.strip())
                if not live:
                    session.rest()
                if session.left or self._error is not None:
                    break
            if beside is not None and self._error is None:
                # From here on it is the voice that can stop the arm.
                session.in_touch = lambda: True
                beside.finish()
        except KeyboardInterrupt:
            with ticker.lock:
                session.halt(halting.KEY)
                self._write("(stopped)")
        finally:
            ticker.stop()
        if self._error is not None:
            raise self._error
        leave(session, tells=True)

    def _take(self, session: Session, line: str) -> None:
        if line and not self._showing.take(session, line):
            session.hear(line)
        self._showing.offer(session)

    def _heard(self, session: Session, ticker: Ticker, words: Words) -> None:
        with ticker.lock:
            if session.left:
                return
            self._write(f"{self._names['you']}: {words.text}")
            if not self._showing.take(session, words.text):
                session.hear(words.text, by_voice=True, sure=words.sure, ago_s=words.ago_s)
            self._showing.offer(session)

    def _fail(self, error: BaseException) -> None:
        self._error = error
