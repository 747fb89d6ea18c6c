"""Lines whose speaker takes something back: "add it after cutting, no, I mean before cutting".

What comes behind the mark of taking back replaces the end of what came before it: from the
last word that is the same as its first word, or of the same kind (`Phrasebook.contrary`).
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from assistant.language.parsing import Hearing, texts_of
from assistant.language.phrasebook import Phrase
from assistant.language.tags import tags_of
from assistant.language.words import Word, Words

LONGEST_TAKEN_BACK = 12
"""Words before the mark that may be replaced."""


def mended(words: Words, hearing: Hearing) -> Iterator[Words]:
    """Yield the lines that may be left, the likeliest first."""
    texts = texts_of(words)
    marks, kept = hearing.book.correction, hearing.book.not_taken_back
    little = hearing.book.little
    for at in range(len(words) - 1, 0, -1):
        begun = hearing.book.correction_begun.get(texts[at], ())
        phrase = next((one for one in begun if texts[at : at + len(one)] == one), None)
        if phrase is None or words[at - 1].text in little["making_nouns"]:
            continue
        if any(texts[at : at + len(one)] == one for one in kept):
            continue
        at_end = at + len(phrase) == len(words)
        between = not at_end and _alike(words[at - 1], words[at + len(phrase)], hearing)
        if not (words[at].broken or len(phrase) > 1 or at_end or between):
            continue
        if at_end and len(phrase) == 1 and phrase[0] in little["tags"]:
            # At the end they ask for consent: "go a bit up, no".
            continue
        before, behind = words[:at], without_marks(words[at + len(phrase) :], marks)
        before = _without_marks_behind(before, marks)
        if not before:
            continue
        if behind:
            yield from _replaced(before, behind, hearing)
        elif any(word.broken for word in before[1:]):
            cut = max(n for n in range(1, len(before)) if before[n].broken)
            yield from _replaced(before[:cut], before[cut:], hearing)


def without_marks(words: Words, marks: Sequence[Phrase]) -> Words:
    """Take further marks off the front, and one off the end: "sorry, slower I meant"."""
    texts = texts_of(words) or ("",)
    for phrase in marks:
        if phrase[0] != texts[0] and phrase[-1] != texts[-1]:
            continue
        size = len(phrase)
        if len(words) > size and texts[:size] == phrase:
            return without_marks(words[size:], marks)
        if len(words) > size and texts[-size:] == phrase:
            return without_marks(words[:-size], marks)
    return words


def _without_marks_behind(words: Words, marks: Sequence[Phrase]) -> Words:
    texts = texts_of(words)
    for phrase in marks:
        if len(words) > len(phrase) and texts[-len(phrase) :] == phrase:
            return _without_marks_behind(words[: -len(phrase)], marks)
    return words


def _replaced(before: Words, behind: Words, hearing: Hearing) -> Iterator[Words]:
    first = behind[0]
    amount, again = _amount(before, hearing), _amount(behind, hearing)
    bare = _bare_number(behind, hearing)
    if amount and bare:
        # "down two millimetres, wait, make it three": the unit told before holds.
        yield (*before[: amount[0]], *behind, *before[amount[0] + bare :])
    if amount and not again:
        yield (*before[slice(*amount)], *behind)
    if amount and again and again[0] == 0:
        yield (*before[: amount[0]], *behind[: again[1]], *before[amount[1] :], *behind[again[1] :])
    least = max(-1, len(before) - 1 - LONGEST_TAKEN_BACK)
    for at in range(len(before) - 1, least, -1):
        if _alike(before[at], first, hearing):
            yield (*before[:at], _unbroken(first, before[at]), *behind[1:])
    little = hearing.book.little
    referring = len(behind) > 2 and behind[0].text in little["pointing"]
    if referring and behind[1].text in little["being"]:
        # "the second piece is lifting, no, it is lowering": what "it" is stands before.
        yield from _replaced(before, behind[1:], hearing)
    yield behind


def _amount(words: Words, hearing: Hearing) -> tuple[int, int] | None:
    """Return where it is told how far or how much, which holds unless it is told again."""
    at = 0
    for tag in tags_of(texts_of(words), hearing.book, hearing.names):
        end = at + len(tag.words)
        measured = tag.quantity is not None and tag.quantity.kind in ("m", "deg")
        if measured or tag.kind in ("little", "much"):
            return at, end
        at = end
    return None


def _bare_number(words: Words, hearing: Hearing) -> int:
    """Return how many words a number without a unit has that is all there is; else none."""
    found = hearing.book.numbers.quantity(texts_of(words), 0)
    bare = found is not None and found.kind == "" and found.end == len(words)
    return len(words) if bare else 0


def _unbroken(word: Word, place: Word) -> Word:
    return Word(word.text, word.said, place.broken)


def _alike(old: Word, new: Word, hearing: Hearing) -> bool:
    if old.text == new.text:
        return True
    book = hearing.book
    if any(old.text in group and new.text in group for group in book.contrary):
        return True
    counted = book.numbers
    number = counted.number((old.text,), 0) and counted.number((new.text,), 0)
    return bool(number or (counted.ordinal((old.text,), 0) and counted.ordinal((new.text,), 0)))
