"""Words that carry nothing: hesitations anywhere, and whom one speaks to at either end."""

from __future__ import annotations

from assistant.language.answers import LISTS, OPEN
from assistant.language.phrasebook import Phrase, Phrasebook
from assistant.language.words import Word, Words
from assistant.model.teacher_acts import Asked

_LONGEST = 7
_CONFIRMING = frozenset(("confirm_tree", "confirm_segmentation", "did_you_mean", "satisfied"))


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
        kept.append(Word(word.text, word.said, True) if parted else word)
        broken = False
        at += 1
    said = _unaddressed(tuple(kept) or words, asked, book)
    return said if asked in OPEN else _once_each(_uncalled(said, book), book)


def bare_verbs(words: Words, asked: Asked | None, book: Phrasebook) -> Words:
    """Take out what stands before a verb that is wanted at the end: "bitten, langsamer zu fahren".

    Names and other answers in the teacher's own words keep it.
    """
    mark = book.bends.within
    if not mark or asked in OPEN:
        return words
    bare = tuple(word for at, word in enumerate(words) if not _marks(words, at, mark, book))
    return _ordered(bare, book)


def _ordered(words: Words, book: Phrasebook) -> Words:
    """Return "tilt it" for "kippen Sie es": whom one asks politely stands behind the verb."""
    verb = words[0].text if words else ""
    polite = len(words) > 2 and words[1].text in book.bends.asked and not words[1].broken
    if not polite or not verb.endswith(book.bends.verbs):
        return words
    stems = (verb[:-2] + "e", verb[:-2], verb[:-1])
    stem = next((one for one in stems if one in book.vocabulary), "")
    return (Word(stem, words[0].said, words[0].broken), *words[2:]) if stem else words


def _marks(words: Words, at: int, mark: str, book: Phrasebook) -> bool:
    if words[at].text != mark or words[at].broken or not 0 < at < len(words) - 1:
        return False
    verb, behind = words[at + 1].text, words[at + 2 : at + 3]
    ends = not behind or behind[0].broken or behind[0].text in book.little["joints"]
    how = book.motion.get((verb,), "move") in _WAYS_TO_MOVE and verb not in book.empty
    known = verb in book.vocabulary and (mark, verb) not in book.motion
    return ends and how and known and verb.endswith(book.bends.verbs)


_WAYS_TO_MOVE = ("move", "turn", "tilt", "raise", "lower", "advance", "retreat")


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
                    Word(again[0].text, again[0].said, part[0].broken),
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
            if head in known and words[size].broken and not _answers(head, asked, book):
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


def _answers(head: Phrase, asked: Asked | None, book: Phrasebook) -> bool:
    """Tell a yes where one was asked for: "ja" leads into any line else."""
    return asked in _CONFIRMING and head[0] in book.yes


def _texts(words: Words) -> Phrase:
    return tuple([word.text for word in words])
