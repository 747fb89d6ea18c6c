"""Cues that count: "now we are entering into step number two", "so, on to the fourth one"."""

from __future__ import annotations

from assistant.language.parsing import GUESSED, LIKELY, NAMED, SURE, Hearing, Parse, texts_of
from assistant.language.phrasebook import Phrase, Phrasebook
from assistant.language.words import Words
from assistant.model.teacher_acts import Cue

LONGEST = 14


def counted_cue(words: Words, hearing: Hearing) -> Parse | None:
    """Return the step a teacher who demonstrates comes to by its number or its place."""
    book, texts = hearing.book, texts_of(words)
    if hearing.listening.stage != "demonstration" or not book.cueing or len(words) > LONGEST:
        return None
    found = next((one for at in range(len(texts)) if (one := _at(texts, at, book))), None)
    if found is None:
        return None
    cue, start, end = found
    beside = (*texts[:start], *texts[end:])
    strange = sum(text not in book.cueing["beside"] for text in beside)
    return Parse((cue,), (SURE, GUESSED, NAMED)[strange]) if strange <= _MOST_STRANGE else None


_MOST_STRANGE = 2


def _at(texts: Phrase, at: int, book: Phrasebook) -> tuple[Cue, int, int] | None:
    """Return the cue at a place: "fifth step", "step five", "number five", "last step"."""
    nouns, numbers = book.cueing["nouns"], book.numbers
    sounding = book.homophones.get(texts[at : at + 1], texts[at : at + 1])
    placed = numbers.ordinal(texts, at) or numbers.ordinal((*texts[:at], *sounding), at)
    if placed is not None and texts[placed[1] : placed[1] + 1] and texts[placed[1]] in nouns:
        return Cue("first" if placed[0] == 1 else placed[0]), at, placed[1] + 1
    if texts[at] in book.cueing["last"] and texts[at + 1 : at + 2] and texts[at + 1] in nouns:
        return Cue("last"), at, at + 2
    counting = texts[at] in nouns or texts[at] in book.cueing["number"]
    start = at + 1
    while counting and start < len(texts) and texts[start] in book.cueing["number"]:
        start += 1
    counted = numbers.number(_sounded(texts, start, book), start) if counting else None
    if counted is not None and counted[0] >= 1 and counted[0] % 1 == 0:
        return Cue(int(counted[0])), at, counted[1]
    return None


def _sounded(texts: Phrase, at: int, book: Phrasebook) -> Phrase:
    """Return the words with the one at a place as the number it sounds like: "step won"."""
    meant = book.homophones.get(texts[at : at + 1], ())
    if len(meant) == 1 and meant[0] in book.numbers.ones and at == len(texts) - 1:
        return (*texts[:at], meant[0])
    return texts


def surer(best: Parse | None, counted: Parse | None) -> Parse | None:
    """Return a counted cue rather than a plain one: "now to the fourth step" is no mere next."""
    if counted is None or counted.score <= NAMED - 0.1:
        return best
    plain = best is not None and isinstance(best.acts[0], Cue) and len(best.acts) == 1
    if best is None or plain:
        return counted
    return best if best.score >= LIKELY or best.score > counted.score else counted
