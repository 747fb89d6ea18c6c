"""Lessons kept under a name: "do you remember the lesson we named tidy up, please load it".

The name stands behind a mark such as "called", or is set off behind a noun for a lesson; which
of saving, loading and comparing is meant, the verb tells, wherever it stands.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from assistant.language.frames import frames
from assistant.language.parsing import LIKELY, NAMED, Hearing, Parse, texts_of
from assistant.language.phrasebook import Phrase, Phrasebook
from assistant.language.words import Words, said
from assistant.model.teacher_acts import Compare, Load, Save

LONGEST_NAME = 6
_ACTS: Mapping[str, type[Compare | Load | Save]] = {"compare": Compare, "load": Load, "save": Save}


def kept(words: Words, hearing: Hearing) -> Parse | None:
    """Return what is to be done with the lesson of a name; None if none is told."""
    if not hearing.book.keeping or frames(hearing.language) is None:
        return None
    texts = texts_of(words)
    for start, end in _marks(texts, words, hearing.book):
        name = _name(words[end:], hearing.book)
        behind = set(texts[end + len(name) : end + len(name) + 1])
        if not name or behind & hearing.book.little["and"]:
            continue
        kind = _kind(texts[:start], texts[end + len(name) :], hearing.book)
        if kind is None:
            continue
        beside = {*texts[:start], *texts[end + len(name) :]}
        strange = sum(text not in hearing.book.keeping_words for text in beside)
        return Parse((_ACTS[kind](said(name)),), (LIKELY, NAMED, 0.7)[min(strange, 2)], "named")
    return None


def _marks(texts: Phrase, words: Words, book: Phrasebook) -> Iterator[tuple[int, int]]:
    """Yield where a mark stands and the name begins: a listed phrase, else a comma."""
    nouns, told = book.keeping["nouns"], set(texts)
    for phrase in book.keeping["marks"]:
        if phrase[0] not in told:
            continue
        for at in range(len(texts) - len(phrase), 0, -1):
            if texts[at : at + len(phrase)] == phrase:
                yield at, at + len(phrase)
    for at in range(1, len(texts)):
        if words[at].broken and (texts[at - 1],) in nouns:
            yield at, at
    for phrase in book.keeping["against"]:
        if phrase[0] not in told:
            continue
        for at in range(1, len(texts) - len(phrase)):
            if texts[at : at + len(phrase)] == phrase:
                yield at, at + len(phrase)


def _kind(before: Phrase, behind: Phrase, book: Phrasebook) -> str | None:
    """Return what a verb asks for: comparing before loading, loading before saving."""
    for kind in _ACTS:
        for part in (before, behind):
            if any(_holds(part, phrase) for phrase in book.keeping[kind]):
                return kind
    return None


def _holds(texts: Phrase, phrase: Phrase) -> bool:
    size = len(phrase)
    return any(texts[at : at + size] == phrase for at in range(len(texts) - size + 1))


def _name(words: Words, book: Phrasebook) -> Words:
    """Return the name a line goes on with, up to a mark or what is said of it."""
    texts = texts_of(words)
    while words and (texts[0],) in book.keeping["leads"]:
        words, texts = words[1:], texts[1:]
    end = next((at for at in range(1, len(words)) if words[at].broken), len(words))
    for phrase in book.keeping["behind"]:
        size = len(phrase)
        cut = next((at for at in range(1, end - size + 1) if texts[at : at + size] == phrase), end)
        end = min(end, cut)
    odd = texts[:end] in book.keeping["nouns"] or (
        end == 1 and texts[0] in book.little["no_lesson"]
    )
    fit = 0 < end <= LONGEST_NAME and not odd
    return words[:end] if fit else ()
