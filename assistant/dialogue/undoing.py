"""The last change taken back, and brought again."""

from __future__ import annotations

from dataclasses import replace

from assistant.dialogue.asking import tell
from assistant.dialogue.changing import corrected, told_of
from assistant.dialogue.going_back import resettled
from assistant.dialogue.knowledge import Knowledge
from assistant.dialogue.sketch import names
from assistant.dialogue.state import Change, Dialogue, Ready
from assistant.dialogue.turn import Turn, changed, line, say, snapshot


def undo(dialogue: Dialogue) -> Turn:
    """Take the last change back."""
    if not dialogue.past:
        return tell(dialogue, line("error", "nothing_to_undo"))
    change = dialogue.past[-1]
    future = (*dialogue.future, snapshot(dialogue, change.label))
    return _turned_to(dialogue, change, dialogue.past[:-1], future, "undone")


def redo(dialogue: Dialogue) -> Turn:
    """Bring back what was taken back."""
    if not dialogue.future:
        return _taken_back(dialogue) or tell(dialogue, line("error", "nothing_to_redo"))
    change = dialogue.future[-1]
    past = (*dialogue.past, snapshot(dialogue, change.label))
    return _turned_to(dialogue, change, past, dialogue.future[:-1], "redone")


def _taken_back(dialogue: Dialogue) -> Turn | None:
    """Bring back the corrections that were taken out of the list last; None if none were."""
    last = dialogue.past[-1] if dialogue.past else None
    if last is None or last.label != "corrections":
        return None
    lost = _corrections(last.known, dialogue.known)
    if not lost:
        return None
    told = line("done", "correction_redone", names=lost)
    return told_of(corrected(changed(dialogue, "corrections", last.known)), told)


def _turned_to(
    dialogue: Dialogue,
    change: Change,
    past: tuple[Change, ...],
    future: tuple[Change, ...],
    topic: str,
) -> Turn:
    before = dialogue.known
    small = change.label in ("correction", "facing")
    if dialogue.busy and not small:
        return say(dialogue, line("error", "while_moving"))
    after = replace(
        dialogue,
        known=change.known,
        past=past,
        future=future,
        clean=(),
        agreed=False,
        unsaved=True,
        pending=None,
    )
    names_told = _named(before, change, back=topic == "redone")
    said = line("done", topic, what=change.label, names=names_told)
    if small:
        return told_of(corrected(after), said)
    if after.arm == "checking":
        after = replace(after, arm="rest", state=Ready())
    return resettled(before, after, said, change.questions)


def _named(before: Knowledge, change: Change, *, back: bool) -> list[str]:
    """Return the steps, or corrections, that came or went with a change."""
    if change.label in ("correction", "corrections"):
        lost, won = _corrections(before, change.known), _corrections(change.known, before)
        return (won or lost) if back else (lost or won)
    if change.label not in ("subtask_name", "steps", "added", "removed"):
        return []
    here, there = names(before.root), names(change.known.root)
    return [name for name in (*here, *there) if (name in here) != (name in there)]


def _corrections(known: Knowledge, other: Knowledge) -> list[str]:
    """Return the words of the corrections of one that the other has not."""
    given, theirs = ((one.lesson.feedback if one.lesson else ()) for one in (known, other))
    return [one.words for one in given if one not in theirs]
