"""Lines that name what they are about first: "the drip, take it out again".

The pronoun of what follows stands for what was named: put in its place, the line is read as
if it had been said at once. The like holds where a clause only leads to another: "what I tell
everybody is that wiping comes first".
"""

from __future__ import annotations

from collections.abc import Iterator
from functools import cache

from assistant.language.clauses import clause
from assistant.language.frames import Frames, frames
from assistant.language.parsing import LIKELY, Hearing, Parse, texts_of
from assistant.language.phrasebook import Phrasebook
from assistant.language.words import Words
from assistant.model.teacher_acts import (
    AddSubtask,
    AdjustSpeed,
    Assign,
    Merge,
    MoveCut,
    Optional,
    Ordered,
    RemoveSubtask,
    Rename,
    Required,
    Resume,
    Rotate,
    Split,
    TeacherAct,
    Translate,
    Unordered,
    act_name,
)

STRUCTURE: tuple[type[TeacherAct], ...] = (
    AddSubtask,
    Assign,
    Merge,
    MoveCut,
    Optional,
    Ordered,
    RemoveSubtask,
    Rename,
    Required,
    Split,
    Unordered,
)
_CORRECTIONS = (AdjustSpeed, Translate, Rotate)
_LONGEST_START = 5
_LONGEST_TOPIC, _LEAST, _LESS = 7, 0.7, 0.04


def topical(words: Words, hearing: Hearing) -> Parse | None:
    """Return what a line means whose topic stands before it; only what changes the task."""
    known = frames(hearing.language)
    if known is None or len(words) < 3:
        return None
    best: Parse | None = None
    for line in (*_led_to(words, known, hearing), *_put_in(words, known, hearing)):
        found = clause(line, hearing)
        if found is None or found.score < _LEAST or not _is_told(found.acts):
            continue
        if best is None or found.score - _LESS > best.score:
            best = Parse(found.acts, min(found.score, LIKELY) - _LESS, "mended")
    return best


def going_on(words: Words, hearing: Hearing) -> Parse | None:
    """Read "go on, but slower": a pause is over, and what comes is corrected."""
    joints = frames(hearing.language)
    goes_on = joints.small("but") if joints else frozenset[str]()
    resuming = _resuming(hearing.book)
    for at in range(1, min(len(words) - 1, _LONGEST_START)):
        if not words[at].broken and words[at].text not in goes_on:
            continue
        if not any(word.text in resuming for word in words[:at]):
            continue
        first = clause(words[:at], hearing)
        rest = words[at:]
        while len(rest) > 1 and rest[0].text in goes_on:
            rest = rest[1:]
        if first is None or first.acts != (Resume(),) or first.score < LIKELY:
            continue
        second = clause(rest, hearing)
        told = second is not None and second.score >= LIKELY
        if second is not None and told and isinstance(second.acts[0], _CORRECTIONS):
            return Parse((Resume(), *second.acts), min(first.score, second.score))
    return None


@cache
def _resuming(book: Phrasebook) -> frozenset[str]:
    """Return the words by which sentences begin that say to go on, asides not counted."""
    told = [one for one in book.sentences if one.act == act_name(Resume())]
    return frozenset(word for one in told for words in one.needed[:1] for word in words)


def _is_told(acts: tuple[TeacherAct, ...]) -> bool:
    """Tell one act that changes the task, and what of it."""
    return len(acts) == 1 and isinstance(acts[0], STRUCTURE) and acts[0] != Unordered()


def _led_to(words: Words, known: Frames, hearing: Hearing) -> Iterator[Words]:
    """Yield what follows "I must insist that" and "what I say is that"."""
    texts = texts_of(words)
    leading = known.small("saying") | known.small("stating")
    for at in range(2, min(len(words) - 2, 12)):
        if texts[at] in hearing.book.little["that"] and set(texts[:at]) & leading:
            yield words[at + 1 :]
        if words[at].broken and texts[at] in known.small("requests"):
            yield words[at:]


def _put_in(words: Words, known: Frames, hearing: Hearing) -> Iterator[Words]:
    """Yield the lines in which the topic stands where its pronoun stood."""
    breaks = [at for at in range(1, len(words) - 1) if words[at].broken]
    for cut in breaks[:1]:
        topic = _topic(words[:cut], known)
        if topic is None:
            continue
        for start in breaks:
            rest = words[start:]
            if _holds(rest, topic):
                yield rest
            for at, size in _pronouns(rest, known):
                yield (*rest[:at], *topic, *rest[at + size :])


def _holds(words: Words, part: Words) -> bool:
    """Tell whether the words of a part stand in a line again."""
    texts, told = texts_of(words), texts_of(part)
    return any(texts[at : at + len(told)] == told for at in range(len(texts)))


def _topic(words: Words, known: Frames) -> Words | None:
    """Return the name a line begins with: what "I've changed my mind about wave" is about."""
    abouts = [at for at in range(len(words) - 1) if words[at].text in known.small("abouts")]
    named = words[abouts[-1] + 1 :] if abouts else words
    talk = known.small("subjects") | known.small("no_topic")
    if not named or len(named) > _LONGEST_TOPIC or talk & {word.text for word in named}:
        return None
    return named


def _pronouns(words: Words, known: Frames) -> Iterator[tuple[int, int]]:
    """Yield where pronouns stand and how long they are: "it", "that one", "those two"."""
    texts = texts_of(words)
    for at in range(len(words)):
        if texts[at] in known.small("standing_for"):
            longer = texts[at + 1 : at + 2] and texts[at + 1] in known.small("ones")
            yield at, 2 if longer else 1
