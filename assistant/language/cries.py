"""A cry to stop among other cries: "ahhh, stop it, you will smash it", "abeg stop am o".

At rest a stop is a clause of its own: nothing but a call stands before it, and behind it only
what is to stop, whom one calls, or what is about to happen. "My bus stop is far" is none.
"""

from __future__ import annotations

from collections.abc import Iterator
from itertools import pairwise

from assistant.language.families import row_of
from assistant.language.parsing import Hearing, texts_of
from assistant.language.phrasebook import Phrasebook
from assistant.language.stopping import has_stop_word, stop_words
from assistant.language.words import Word, Words

_LONGEST_CALL = 2


def cried(words: Words, hearing: Hearing) -> bool:
    """Tell whether a clause of a line cries stop."""
    book = hearing.book
    if set(texts_of(words)) & book.chat or not book.answer_words.get("stop_tails"):
        return False
    if not any(_stops(word, hearing) for word in words):
        return False
    parts = tuple(_clauses(words))
    return any(_cries(part, hearing, alone=len(parts) == 1) for part in parts)


def _clauses(words: Words) -> Iterator[Words]:
    cuts = [at for at in range(1, len(words)) if words[at].broken]
    for start, end in pairwise((0, *cuts, len(words))):
        yield words[start:end]


def _cries(words: Words, hearing: Hearing, *, alone: bool) -> bool:
    """Tell a cry; "whoa there, slow it down" is none, for more than a stop follows."""
    book, within = hearing.book, stop_words(hearing.language).within
    for at in range(min(_LONGEST_CALL + 1, len(words))):
        plain = (words[at].text,) not in book.answer_words["stop_cries"]
        if _stops(words[at], hearing):
            if not (alone or plain or any(part in words[at].text for part in within)):
                return False
            return _followed(words[at + 1 :], hearing)
        if not _calls(words[at], book):
            return False
    return False


def _stops(word: Word, hearing: Hearing) -> bool:
    """Tell a stop word, misspelled as well: a word that means something else is none."""
    cries = hearing.book.answer_words["stop_cries"]
    known = (word.text,) in cries or word.text in stop_words(hearing.language).stops
    return known or (
        _unheard(word, hearing.book)
        and not row_of(word.text, hearing.language)
        and has_stop_word(word.text, hearing.language)
    )


def _calls(word: Word, book: Phrasebook) -> bool:
    """Tell what is only called out: "ahhh", "please", "robot"."""
    calm = any(word.text in phrase for phrase in book.answer_words["stop_calm"])
    called = word.text in book.empty | book.polite | book.no | book.yes
    named = (word.text,) in book.vocatives[1] or _tails(word, book)
    return not calm and (called or named or _unheard(word, book))


def _followed(words: Words, hearing: Hearing) -> bool:
    """Tell what may stand behind a stop: what stops, who, and then a warning."""
    book, texts = hearing.book, texts_of(words)
    warnings = book.answer_words["stop_warnings"]
    for at, word in enumerate(words):
        if any(texts[at : at + len(one)] == one for one in warnings):
            return True
        called = (word.text,) in book.vocatives[1] or (at > 0 and _unheard(word, book))
        if not (called or _tails(word, book) or _stops(word, hearing)):
            return False
    return True


def _tails(word: Word, book: Phrasebook) -> bool:
    tails = book.answer_words["stop_tails"]
    return (word.text,) in tails or (word.said,) in tails


def _unheard(word: Word, book: Phrasebook) -> bool:
    return word.text not in book.vocabulary and word.text not in book.real
