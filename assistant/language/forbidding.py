"""What is forbidden is not wanted: "don't go on" goes on with nothing, it stops."""

from __future__ import annotations

from assistant.language.frames import classes_of
from assistant.language.parsing import Hearing, Parse, texts_of
from assistant.language.phrasebook import Phrase
from assistant.language.trusting import FREE_ANSWERS
from assistant.language.words import Words
from assistant.model.teacher_acts import (
    Assign,
    Deny,
    Inform,
    Resume,
    Start,
    Stop,
    TeacherAct,
)

_MOST_BEHIND = 2
"""Words behind a not that are all of what is not to be begun: "do not start yet"."""


def obeyed(acts: tuple[TeacherAct, ...], words: Words, hearing: Hearing) -> tuple[TeacherAct, ...]:
    """Return the acts with a stop where they go on though a not stands before the going on.

    What is not to be begun is no start: a no where the robot asked whether it may begin.

    Parameters
    ----------
    acts : tuple of TeacherAct
        As read; what learned readings go by are the words alone, and those are of going on.
    words : tuple of Word
        The line without fillers.
    hearing : Hearing
    """
    texts = texts_of(words)
    asks = bool(texts) and texts[0] in hearing.book.little["open_questions"]
    behind = [] if asks else _behind_not(words, hearing)
    if any(_begins_going(tail, hearing) for tail in behind):
        acts = _instead(acts, (Resume, Start), Stop())
    if any(len(tail) <= _MOST_BEHIND and texts[-len(tail) :] == tail for tail in behind):
        asked = hearing.listening.asked == "ready"
        acts = _instead(acts, (Start,), Deny() if asked else Stop())
    return acts


def _instead(
    acts: tuple[TeacherAct, ...], forbidden: tuple[type[TeacherAct], ...], other: TeacherAct
) -> tuple[TeacherAct, ...]:
    """Return acts with another in place of those forbidden, each once."""
    kept = (other if isinstance(act, forbidden) else act for act in acts)
    return tuple(dict.fromkeys(kept))


def _behind_not(words: Words, hearing: Hearing) -> list[Phrase]:
    """Return what stands behind each not, up to where the speaker pauses."""
    found = []
    for at, word in enumerate(words[:-1]):
        if word.text in hearing.book.little["not"]:
            ends = (n for n in range(at + 1, len(words)) if words[n].broken)
            tail = words[at + 1 : next(ends, len(words))]
            found += [texts_of(tail)] if tail else []
    return found


def _begins_going(texts: Phrase, hearing: Hearing) -> bool:
    """Tell words that begin with a word or two of going on: "go on", "weitermachen"."""
    if _goes_on(texts[:1], hearing):
        return True
    return _goes_on(texts[:2], hearing) and not _goes_on(texts[1:2], hearing)


def _goes_on(texts: Phrase, hearing: Hearing) -> bool:
    return "go_on" in classes_of(texts, hearing.language)


def turned(acts: tuple[TeacherAct, ...], weighed: Parse, words: Words, hearing: Hearing) -> bool:
    """Tell a reading that turns a line by a not: "and does not wobble" without its not.

    So does one that takes the name a not rules out: "part two is grip, not carry" is no carry.
    """
    one, other = acts[0], weighed.acts[0]
    negating = hearing.book.little["not"]
    if isinstance(one, Inform) and isinstance(other, Inform):
        wanting = hearing.listening.asked in FREE_ANSWERS
        told, whole = (set(str(act.value).lower().split()) for act in (one, other))
        return wanting and bool(negating & whole) and not negating & told
    if not isinstance(one, Assign) or not isinstance(other, Assign):
        return False
    return one.subtask != other.subtask and one.subtask in _ruled_out(words, negating)


def _ruled_out(words: Words, negating: frozenset[str]) -> str:
    """Return what stands behind the last not of a line, up to where the speaker pauses."""
    last = max((at for at, word in enumerate(words) if word.text in negating), default=len(words))
    behind = words[last + 1 :]
    end = next((at for at, word in enumerate(behind) if word.broken), len(behind))
    return " ".join(word.said for word in behind[:end])
