"""Words that carry nothing: hesitations anywhere, and whom one speaks to at either end."""

from __future__ import annotations

from dataclasses import replace

from assistant.language.answers import LISTS, OPEN
from assistant.language.phrasebook import Phrase, Phrasebook
from assistant.language.words import Word, Words
from assistant.model.teacher_acts import Asked

_LONGEST = 7


def without_fillers(words: Words, asked: Asked | None, book: Phrasebook) -> Words:
    """Return the words without fillers; all of them if nothing else is said.

    A mark that stood before a filler stands before the next word.
    """
    kept: list[Word] = []
    broken = False
    at = 0
    while at < len(words):
        size = _filler(words, at, book)
        if size:
            broken = broken or any(word.broken for word in words[at : at + size])
            at += size
            continue
        word = words[at]
        parted = broken and not word.broken and bool(kept)
        kept.append(replace(word, broken=True) if parted else word)
        broken = False
        at += 1
    said = _unaddressed(tuple(kept) or words, asked, book)
    return said if asked in OPEN else _once_each(_uncalled(said, book), book)


def _uncalled(words: Words, book: Phrasebook) -> Words:
    """Take out whom one speaks to between two marks: "that is it, son, just right"."""
    kept = list(words)
    for at in range(len(words) - 2, 0, -1):
        called = words[at].broken and words[at + 1].broken
        if called and (words[at].text,) in book.vocatives[1]:
            del kept[at]
    return tuple(kept)


def _once_each(words: Words, book: Phrasebook) -> Words:
    """Take out little words that a hesitant speaker says again: "when it, it is, it is done"."""
    at = 0
    while at < len(words) > len({word.text for word in words}):
        for size in (3, 2, 1):
            part, again = words[at : at + size], words[at + size : at + 2 * size]
            little = all(word.text in book.stuttered for word in part)
            if len(again) == size and little and _texts(part) == _texts(again):
                words = (
                    *words[:at],
                    replace(again[0], broken=part[0].broken),
                    *words[at + size + 1 :],
                )
                at = max(-1, at - size - 1)
                break
        at += 1
    return words


def _filler(words: Words, at: int, book: Phrasebook) -> int:
    texts = tuple(word.text for word in words[at : at + _LONGEST])
    return next((n for n in range(len(texts), 0, -1) if texts[:n] in book.fillers), 0)


def _unaddressed(words: Words, asked: Asked | None, book: Phrasebook) -> Words:
    """Take whom one speaks to off both ends: "mate, go left", "go left, dear"."""
    known = book.vocatives[asked not in LISTS]
    changed = True
    while changed and len(words) > 1:
        changed = False
        for size in (3, 2, 1):
            if len(words) <= size:
                continue
            head, tail = _texts(words[:size]), _texts(words[-size:])
            if head in known and words[size].broken:
                words, changed = words[size:], True
                break
            set_off = words[-size].broken or (asked not in OPEN and tail in book.vocatives[0])
            greeted = (
                words[0].text in book.little["greetings"] and _texts(words[1 : size + 1]) in known
            )
            if greeted and len(words) > size + 1 and words[size + 1].broken:
                words, changed = words[size + 1 :], True
                break
            owned = words[-size - 1].text in book.little["owning"]
            if tail in known and set_off and not owned:
                words, changed = words[:-size], True
                break
    return words


def _texts(words: Words) -> Phrase:
    return tuple([word.text for word in words])
