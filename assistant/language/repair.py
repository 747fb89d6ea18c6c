"""Repairs spelling word by word, and puts back words that sound the same.

Whole sentences are never compared loosely: only a word that is in no list is replaced, and
only by the one vocabulary word near it.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping
from functools import lru_cache

from rapidfuzz import process
from rapidfuzz.distance import OSA

from assistant.language.bends import put_together, relettered, unbent_word
from assistant.language.little_words import LittleWords
from assistant.language.phrasebook import Phrasebook
from assistant.language.words import Word, Words

_SHORTEST = 4


def respelled(words: Words, book: Phrasebook, names: Iterable[str]) -> Words:
    """Return the words with misspelled ones replaced by the vocabulary's."""
    more = frozenset(part for name in names for part in name.lower().split())
    known = book.vocabulary | more if more else book.vocabulary
    return tuple(
        Word(_known_word(word.text, known, book), word.said, word.broken)
        if word.text.isalpha() and word.text not in known and word.text not in book.real
        else word
        for word in words
    )


def _known_word(text: str, known: frozenset[str], book: Phrasebook) -> str:
    """Return the known word that a text is bent from or a slip of; itself if there is none."""
    bent = unbent_word(text, known, book.bends)
    if bent or (book.bends.heads and put_together(text, known | book.real)):
        return bent or text
    nearest = _nearest(text, known, book.little)
    if nearest != text:
        return nearest
    lettered = relettered(text, book.bends)
    return text if lettered == text else _nearest(lettered, known, book.little)


def without_slips(words: Words, book: Phrasebook) -> Words:
    """Return the words with slips of little words put right, in names as well."""
    found, typos = [], book.little.typos
    for at, word in enumerate(words):
        if word.text in typos and word.text not in book.vocabulary:
            step = _is_step(words, at, book)
            right = book.little.first("step") if step else typos[word.text]
            found.append(Word(right, right, word.broken))
        else:
            found.append(_whole(word, book))
    return tuple(found)


def _is_step(words: Words, at: int, book: Phrasebook) -> bool:
    """Tell "stp" beside a count from a hurried "stop": "1st stp", "stp 2"."""
    if words[at].text not in book.little["hurried_step"]:
        return False
    texts = tuple(word.text for word in words)
    before = book.numbers.ordinal(texts, at - 1) if at > 0 else None
    if before is not None and before[1] == at:
        return True
    behind = book.numbers.number(texts, at + 1)
    return behind is not None and behind[1] == len(words)


def _whole(word: Word, book: Phrasebook) -> Word:
    """Return "going" for "goin" and "goin'": a letter that people leave out at the end."""
    stem = word.text.removesuffix("'")
    unknown = stem not in book.vocabulary and stem not in book.real
    if len(stem) < _SHORTEST or not unknown:
        return word
    for ending in book.little.doing:
        whole = f"{stem}{ending[-1]}"
        if stem.endswith(ending[:-1]) and whole in book.vocabulary:
            return Word(whole, word.said, word.broken)
    return word


@lru_cache(maxsize=4096)
def _nearest(text: str, known: frozenset[str], little: LittleWords) -> str:
    once = _unstretched(text)
    if once in known:
        return once
    if text in little.typos:
        return little.typos[text]
    if not _VOWELS & set(text) and len(text) >= _SHORTEST - 1:
        whole = _skeletons(known).get(text, ())
        if len(whole) == 1:
            return whole[0]
    return text if len(text) < _SHORTEST else _corrected(text, known)


def _corrected(text: str, known: frozenset[str]) -> str:
    """Return the one word of the vocabulary that a slip makes a text of; itself if none is."""
    far = 1 if len(text) < 7 else 2
    sizes = range(max(_SHORTEST - 1, len(text) - far), len(text) + far + 1)
    long = [word for size in sizes for word in _by_length(known).get(size, ())]
    near = process.extract(text, long, scorer=OSA.distance, score_cutoff=far, limit=None)
    letters = sorted(text)
    ranked = sorted(
        (_strangeness(text, word, distance, letters), word) for word, distance, _ in near
    )
    if not ranked or ranked[0][0] > far + 0.8:
        return text
    if len(ranked) > 1 and ranked[1][0] - ranked[0][0] < 0.1:
        return text
    return ranked[0][1]


@lru_cache(maxsize=32)
def _by_length(known: frozenset[str]) -> Mapping[int, tuple[str, ...]]:
    """Return the words by how long they are: no slip makes a word much longer."""
    found: dict[int, list[str]] = {}
    for word in known:
        found.setdefault(len(word), []).append(word)
    return {size: tuple(words) for size, words in found.items()}


_VOWELS = frozenset("aeiou")


@lru_cache(maxsize=32)
def _skeletons(known: frozenset[str]) -> Mapping[str, tuple[str, ...]]:
    """Return short words by their consonants, as hurried people write them: "hld", "skp"."""
    found: dict[str, list[str]] = {}
    for word in known:
        if _SHORTEST <= len(word) <= _SHORTEST + 2:
            bare = word[0] + "".join(char for char in word[1:] if char not in _VOWELS)
            found.setdefault(bare, []).append(word)
    return {bare: tuple(sorted(words)) for bare, words in found.items()}


def _strangeness(text: str, word: str, distance: float, letters: list[str]) -> float:
    """Return how unlikely a slip is: swapped and doubled letters and a kept first are likely."""
    swapped = 0.0 if sorted(word) == letters or _single(word) == _single(text) else 0.5
    first = 0.0 if word[0] == text[0] else 0.6
    return swapped + distance + first + (0.0 if word[-1] == text[-1] else 0.2)


def _single(text: str) -> str:
    """Return a word with doubled letters once."""
    return "".join(char for at, char in enumerate(text) if at == 0 or text[at - 1] != char)


def _unstretched(text: str) -> str:
    """Return the word without letters repeated for emphasis: "stoooop"."""
    kept = ""
    for char in text:
        if not kept.endswith(char * 2) or kept == "":
            kept += char
    return _single(text) if kept != text else text


def rejoined(words: Words, book: Phrasebook) -> Words:
    """Return the words with those put together that were heard apart: "lo her", "bee for"."""
    found: list[Word] = []
    at = 0
    while at < len(words):
        pair = words[at : at + 2]
        whole = "".join(word.text for word in pair)
        meant = ""
        if len(pair) == 2 and whole.isalpha() and not pair[1].broken and len(whole) > _SHORTEST:
            article = pair[0].text in book.little["articles"] and whole not in book.vocabulary
            told = all(word.text in book.vocabulary for word in pair)
            plain = told and whole not in book.vocabulary and pair[0].text in book.empty
            meant = "" if article or plain else _sounding(whole, book.vocabulary)
        if meant:
            found.append(Word(meant, " ".join(w.said for w in pair if w.said), words[at].broken))
            at += 2
        else:
            found.append(words[at])
            at += 1
    return tuple(found)


@lru_cache(maxsize=4096)
def _sounding(text: str, known: frozenset[str]) -> str:
    far = 1 if len(text) < 6 else 2
    told = ((OSA.distance(text, word), word) for word in _by_sound(known).get(_sound(text), ()))
    alike = [(distance, word) for distance, word in told if distance <= far]
    return min(alike)[1] if alike else ""


@lru_cache(maxsize=32)
def _by_sound(known: frozenset[str]) -> Mapping[str, tuple[str, ...]]:
    """Return the words by how they sound, but for the short ones."""
    found: dict[str, list[str]] = {}
    for word in known:
        if len(word) >= _SHORTEST:
            found.setdefault(_sound(word), []).append(word)
    return {sound: tuple(words) for sound, words in found.items()}


_SOUNDS = str.maketrans("cqgjzxdbv", "kkkksstpf")
_SILENT = re.compile(r"[aeiouyhw]+")


@lru_cache(maxsize=4096)
def _sound(word: str) -> str:
    """Return the consonants of a word as they sound, doubled ones once."""
    plain = word.replace("ph", "f").replace("gh", "").replace("ck", "k").translate(_SOUNDS)
    bare = _SILENT.sub("", plain)
    return _single(bare)


def homophones(words: Words, book: Phrasebook) -> Words:
    """Return the words with those replaced that recognizers take for others."""
    texts = tuple([word.text for word in words])
    found: list[Word] = []
    at = 0
    while at < len(words):
        size = next(
            (
                size
                for size in (4, 3, 2, 1)
                if at + size <= len(words) and texts[at : at + size] in book.homophones
            ),
            0,
        )
        if not size:
            found.append(words[at])
            at += 1
            continue
        meant = book.homophones[tuple(word.text for word in words[at : at + size])]
        said = " ".join(word.said for word in words[at : at + size] if word.said)
        found.append(Word(meant[0], said, words[at].broken))
        found.extend(Word(one, "") for one in meant[1:])
        at += size
    return tuple(found)
