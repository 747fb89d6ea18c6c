"""What parts of understanding share: a parse, what a clause is heard with, its bare words."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field

from assistant.language.phrasebook import Phrase, Phrasebook
from assistant.language.words import Word, Words
from assistant.model.listening import Listening
from assistant.model.teacher_acts import TeacherAct

SURE, LIKELY, ACTING, GUESSED, NAMED, DOUBTFUL, GUESS = 0.96, 0.9, 0.85, 0.8, 0.78, 0.6, 0.4

AGAIN = "again"
"""How a correction is read that is to be tried at once."""


@dataclass(frozen=True, slots=True)
class Parse:
    """Acts with how far their words are explained, and by what: it tells how sure they are."""

    acts: tuple[TeacherAct, ...]
    score: float
    how: str = "sentence"

    @property
    def exact(self) -> bool:
        """Whether it is one whole sentence of the phrasebook, or one with a no or an again."""
        return self.how in ("denied", AGAIN) or self._whole

    @property
    def _whole(self) -> bool:
        return self.how == "sentence" and len(self.acts) == 1 and self.score >= SURE


@dataclass(frozen=True, slots=True)
class Hearing:
    """What understanding a clause needs beside its words; what was read is kept."""

    book: Phrasebook
    listening: Listening
    language: str = "english"
    clauses: dict[Words, Parse | None] = field(default_factory=dict, compare=False)
    sentences: dict[Words, Parse | None] = field(default_factory=dict, compare=False)

    @property
    def names(self) -> frozenset[str]:
        """Words of the names of known objects."""
        return frozenset(w for name in self.listening.objects for w in name.lower().split())


@dataclass(frozen=True, slots=True)
class Reading:
    """A reading with what it was made from.

    Parameters
    ----------
    words, heard : tuple of Word
        As said without fillers, and after repair.
    chances : mapping
        How likely each label of an act is; empty for a language without a model.
    """

    parse: Parse
    words: Words
    heard: Words
    chances: Mapping[str, float]
    hearing: Hearing


def texts_of(words: Sequence[Word]) -> Phrase:
    """Return the words as they are compared."""
    return tuple([word.text for word in words])


def bared(words: Words, book: Phrasebook) -> Iterator[Words]:
    """Yield the clause as it is, then with courtesies taken off its ends, step by step."""
    seen: set[tuple[int, int]] = set()
    starts = [0]
    while (cut := _head(words[starts[-1] :], book)) and len(starts) < 6:
        starts.append(starts[-1] + cut)
    ends = [len(words)]
    while (cut := _tail(words[: ends[-1]], book)) and len(ends) < 5:
        ends.append(ends[-1] - cut)
    for end in ends:
        for start in starts:
            if start < end and (start, end) not in seen:
                seen.add((start, end))
                yield words[start:end]
                doing = start and words[start - 1].text in book.little["doing"]
                if doing and words[start].text.endswith(book.little.doing):
                    yield (_base(words[start], book), *words[start + 1 : end])


def undressed(words: Words, book: Phrasebook) -> Iterator[Words]:
    """Yield what a request asks for, without the words it is dressed in: "might you be ..."."""
    asked = set()
    for at in range(1, len(words)):
        before = words[at - 1].text
        if before not in book.polite:
            return
        asked |= {before} & book.addressed
        if asked and words[at].text not in book.polite:
            yield words[at:]
        if asked and words[at].text.endswith(book.little.doing):
            yield (_base(words[at], book), *words[at + 1 :])
        if asked and words[at].text in book.little["letting"]:
            yield words[at:]


def _base(word: Word, book: Phrasebook) -> Word:
    """Return "move" for "moving", as it follows "would you mind"."""
    ending = next(one for one in book.little.doing if word.text.endswith(one))
    stem = word.text.removesuffix(ending)
    for form in (stem, f"{stem}e", stem[:-1]):
        if form in book.vocabulary:
            return Word(form, word.said, word.broken)
    return word


def _head(words: Words, book: Phrasebook) -> int:
    texts = texts_of(words)
    for size in range(min(8, len(words) - 1), 0, -1):
        if texts[:size] in book.opening:
            return size
    if len(words) > 1 and words[1].broken and texts[0] in book.little["content"]:
        return 1
    return 0


def _tail(words: Words, book: Phrasebook) -> int:
    texts = texts_of(words)
    for size in range(min(7, len(words) - 1), 0, -1):
        if texts[-size:] in book.closing:
            return size
    return 0
