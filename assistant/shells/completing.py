"""Completion of what can be said now: whole sentences, the task's own names, files to show."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from pathlib import Path

from prompt_toolkit.completion import CompleteEvent, Completer, Completion, PathCompleter
from prompt_toolkit.document import Document
from prompt_toolkit.history import FileHistory, History, InMemoryHistory

from assistant.language.completion import filled, suggestions
from assistant.language.hints import page
from assistant.session.loop import Session
from assistant.shells.showing import ways_to_show

SHOWN = (".csv", ".yaml", ".yml")


class Sayable(Completer):
    """Completes to what can be said now."""

    def __init__(self, session: Session) -> None:
        self._session = session
        self._files = PathCompleter(expanduser=True, file_filter=_showable)

    def get_completions(self, document: Document, event: CompleteEvent) -> Iterable[Completion]:
        """Yield sentences that go on from what is typed, names, then sentences that hold it."""
        typed = document.text_before_cursor.lstrip()
        watching = self._session.watching is not None
        known = self._known()
        language = self._session.language
        ways = [ways_to_show(way, language)[0] for way in ("keys", "scripted")] if watching else []
        known = (*ways, *known)
        lowered = typed.lower()
        first = [text for text in known if text.lower().startswith(lowered)]
        inside = [text for text in known if lowered in text.lower() and text not in first]
        yield from (Completion(text, start_position=-len(typed)) for text in first)
        if typed:
            yield from named(typed, self._names())
        yield from (Completion(text, start_position=-len(typed)) for text in inside)
        if watching and typed:
            yield from self._files.get_completions(document, event)

    def _known(self) -> tuple[str, ...]:
        """Return what can be said now; of stopping and going on only what the arm can do."""
        session = self._session
        offers = page("terminal", session.language)["offers"]
        arm = str(session.dialogue_view.get("motion"))
        there = arm if arm in offers else session.listening.stage
        known = suggestions(session.listening, session.language)
        more = filled(offers.get(there, ()), session.listening)
        ordered = (*more, *known) if arm in offers else (*known, *more)
        idle = () if session.moving or arm in offers else offers["moving_only"]
        return tuple(dict.fromkeys(text for text in ordered if text not in idle))

    def _names(self) -> tuple[str, ...]:
        listening = self._session.listening
        saved = self._session.dialogue_view.get("saved", ())
        return tuple(dict.fromkeys((*listening.subtasks, *listening.objects, *saved)))


def named(typed: str, names: Iterable[str]) -> Iterator[Completion]:
    """Yield the names that go on from the last words of what is typed."""
    lowered = typed.lower()
    starts = [at for at in range(len(typed)) if at == 0 or not typed[at - 1].isalnum()]
    for name in names:
        for at in starts:
            begun = lowered[at:]
            if begun.strip() and name.lower().startswith(begun) and name.lower() != begun:
                yield Completion(name, start_position=-len(begun))
                break


def _showable(name: str) -> bool:
    return Path(name).is_dir() or name.endswith(SHOWN)


def remembered(path: Path) -> History:
    """Return what was typed before, in this session and earlier ones."""
    try:
        path.parent.mkdir(parents=True, exist_ok=True)
        path.touch()
    except OSError:
        # Without a writable folder the history lasts as long as the session.
        return InMemoryHistory()
    return FileHistory(str(path))
