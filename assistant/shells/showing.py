"""Ways to show a task at a terminal: keys, a scripted hand, or a recording; offered when due."""

from __future__ import annotations

import os
import re
from collections.abc import Callable, Mapping
from dataclasses import replace
from pathlib import Path

from assistant.errors import AssistantError, BadInput, Problem
from assistant.language.hints import page
from assistant.language.wording import in_own_words
from assistant.model.transcript import Demonstrate
from assistant.session.acting import demonstrate
from assistant.session.loop import Session

OFFER = ("offer", "offer_keys", "offer_scripted", "offer_file")
"""What a newcomer needs to know when the robot begins to watch: keys of ``terminal.yaml``."""
CONTROL_S, SLOWEST_S = 0.02, 1.0


class Showing:
    """Takes lines that say how the task is shown.

    Parameters
    ----------
    write : callable
        Takes one line of output.
    keys : bool
        Whether there are keys to drive the hand with.
    """

    def __init__(self, write: Callable[[str], None], *, keys: bool = False) -> None:
        self._write = write
        self._keys = keys
        self._offered: object = None

    def offer(self, session: Session) -> None:
        """Tell how the task can be shown, once when the robot begins to watch."""
        if session.watching is None or session.watching is self._offered:
            return
        self._offered = session.watching
        words = page("terminal", session.language)
        for line in OFFER:
            if self._keys or line != "offer_keys":
                self._write(words[line])

    def by_keys(self, session: Session, line: str) -> float | None:
        """Return every how many seconds a hand driven by keys is to be recorded.

        None where the line does not ask for keys, or they cannot be used now. The paper's
        period is 0.5 s (IV-A).
        """
        asked = _asked("keys", line, session.language)
        if not asked or not self._keys or session.watching is None:
            return None
        period = float((asked.group(1) or str(CONTROL_S)).replace(",", "."))
        return min(max(period, CONTROL_S), SLOWEST_S)

    def take(self, session: Session, line: str) -> bool:
        """Show the task if the line says how; return whether it did."""
        if session.watching is None:
            return False
        scripted = _asked("scripted", line, session.language)
        try:
            if scripted:
                seed = round(float((scripted.group(1) or "0").replace(",", ".")))
                demonstrate(session, Demonstrate(seed=seed, cues=None), Path())
            elif line.endswith((".csv", ".yaml", ".yml")):
                path = Path(line).expanduser()
                demonstrate(session, Demonstrate(recording=str(path)), Path())
            elif os.sep in line and Path(line).expanduser().is_dir():
                self._write(page("terminal", session.language)["folder"].format(path=line))
            else:
                return False
        except BadInput as error:
            self._write("\n".join(told_problem(one, session.language) for one in error.problems))
        except AssistantError as error:
            self._write(str(error))
        return True


def told_problem(problem: Problem, language: str) -> str:
    """Return what is wrong with a file as the language tells it, where it has words for that."""
    known: Mapping[str, str] = page("terminal", language)["problems"]
    what, right = (in_own_words(told, known) for told in (problem.what, problem.right))
    return str(replace(problem, what=what, right=right))


def ways_to_show(way: str, language: str) -> list[str]:
    """Return the words by which a way to show a task is asked for, the one to offer first."""
    words: list[str] = page("terminal", language)["showing"][way]
    return words


def _asked(way: str, line: str, language: str) -> re.Match[str] | None:
    """Return the match of a line that asks for a way to show, perhaps with a number behind."""
    words = "|".join(re.escape(one) for one in ways_to_show(way, language))
    return re.fullmatch(rf"(?:{words})(?: (\d*[.,]?\d+) ?s?)?", line.strip(), re.IGNORECASE)
