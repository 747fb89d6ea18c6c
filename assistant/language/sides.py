"""Which side of an answer holds it: of a contrast, of an "is", or of what was left out.

"What you overlooked was wiping", "wiping is the one you don't have", "you dropped wiping" and
"wiping got missed" all name the wiping. The sides that only play a part in the talk ("the one
I mean", "that") are told by the words they begin with.
"""

from __future__ import annotations

from itertools import pairwise

from assistant.language.phrasebook import Phrase, Phrasebook
from assistant.language.words import Words
from assistant.model.teacher_acts import Asked

LONGEST_SIDE = 6


def told_side(words: Words, asked: Asked, book: Phrasebook) -> Words:
    """Return the words of an answer that name something; all if nothing shows which."""
    words = _uncontrasted(words, book)
    if asked == "body":
        return _described(words, book)
    if asked == "missing_step":
        words = _left_out(words, book)
    if asked == "which":
        words = _named_again(_meant(words, book), book)
    named = _without_clause(_clefted(_equated(words, book), book), book)
    if asked != "missing_step":
        return named
    begun = len(named) > 1 and named[0].text in book.leading_words("being")
    return _without_noun(named[begun:], book)


def _without_noun(words: Words, book: Phrasebook) -> Words:
    """Return "retract" for "retract step"; "third step" stays whole."""
    texts = _texts(words)
    placed = texts[0] in book.leading_words("part_modifiers") or book.numbers.ordinal(texts, 0)
    if len(words) > 1 and not placed and texts[-1] in book.leading_words("step_nouns"):
        return words[:-1]
    return words


def _meant(words: Words, book: Phrasebook) -> Words:
    """Return the thing of "I am meaning the socket", "I was on about the socket"."""
    texts = _texts(words)
    for at in range(1, len(words) - 1):
        for phrase in book.wrapping.get("meaning", ()):
            end = at + len(phrase)
            told = texts[at:end] == phrase and end < len(words)
            if told and set(texts[:at]) <= book.leading_words("subjects") | book.leading_words(
                "auxiliaries"
            ):
                return words[end:]
    return words


def _named_again(words: Words, book: Phrasebook) -> Words:
    """Return what is told again in full: "the blue one, the blue cup"."""
    last = _last_part(words)
    before = _texts(words[: len(words) - len(last)])
    vague = bool(before) and before[-1] in book.leading_words("part_nouns")
    return last if vague and last[0].text in book.leading_words("part_modifiers") else words


def _uncontrasted(words: Words, book: Phrasebook) -> Words:
    """Return "fork" for "fork not knife", "not the knife, the fork", "fork instead of knife"."""
    texts = _texts(words)
    being = book.leading_words("being") | book.leading_words("auxiliaries")
    if texts[0] in book.little["not"]:
        cut = next((at for at in range(2, len(words)) if words[at].broken), 0)
        return words[cut + (texts[cut] in book.little["but"]) :] if cut else words
    for at in range(1, len(words) - 1):
        for phrase in book.wrapping.get("contrasts", ()):
            told = texts[at : at + len(phrase)] == phrase and texts[at - 1] not in being
            if (
                told
                and not _is_part(words[:at], book)
                and len(words) - at - len(phrase) <= LONGEST_SIDE
            ):
                return words[:at]
    return words


def _equated(words: Words, book: Phrasebook) -> Words:
    """Return the side of "is" that is not only a part of the talk: "the one I mean"."""
    texts, being = _texts(words), book.leading_words("being")
    places = [at for at in range(1, len(words) - 1) if texts[at] in being]
    for at in reversed(places):
        left, right = words[:at], words[at + 1 :]
        part = _is_part(left, book) or _is_part(_last_clause(left, book), book)
        if part and not _is_part(right, book) and not _hangs(right, book):
            return right
    for at in places:
        left, right = words[:at], words[at + 1 :]
        told = _is_part(right, book) and not _is_part(left, book) and not _names(right, book)
        if told and not set(_texts(left)) <= book.leading_words("pronouns") | book.leading_words(
            "wraps"
        ):
            return _without_pronoun(left, book)
    return words


def _clefted(words: Words, book: Phrasebook) -> Words:
    """Return the thing of "it is the drain that you want", "was the drain that stayed out"."""
    texts, being = _texts(words), book.leading_words("being")
    begun = 2 if texts[0] in book.leading_words("pronouns") and texts[1:2] else 1
    if texts[begun - 1] not in being:
        return words
    relative = book.leading_words("clause_begins") - book.leading_words("asides_begin")
    leads = {word for phrase in book.answer_words["heads"] for word in phrase}
    leads |= book.leading_words("parts_begin") | book.leading_words("wraps")
    for at in range(begun + 1, len(words) - 1):
        if texts[at] in relative and not set(texts[begun:at]) <= leads:
            return words[begun:at]
    return words


def _is_part(words: Words, book: Phrasebook) -> bool:
    """Tell words that only say what part is played: "what you forgot", "the missing one"."""
    texts = _texts(words)
    if not texts:
        return False
    if texts[0] in book.leading_words("parts_begin"):
        return True
    modifiers, nouns = book.leading_words("part_modifiers"), book.leading_words("part_nouns")
    at = 0
    while (
        at < len(texts) - 1
        and texts[at] in modifiers
        and texts[at + 1] not in book.little["is_or_was"]
    ):
        at += 1
    if texts[at] not in nouns or (at == 0 and texts[0] not in book.little["one"]):
        return False
    if at + 1 == len(texts) or texts[at + 1] in book.leading_words("part_tails"):
        return True
    of = texts[at + 1] in book.leading_words("part_of")
    return of and at + 2 < len(texts) and texts[at + 2] in book.leading_words("part_whole")


def _names(words: Words, book: Phrasebook) -> bool:
    """Tell words that lead to a name: "what I would call dropping in"."""
    texts = _texts(words)
    anchors = book.wrapping["anchors"]
    return any(texts[at : at + len(one)] == one for at in range(len(texts) - 1) for one in anchors)


def _hangs(words: Words, book: Phrasebook) -> bool:
    """Tell "missing" of "the one that is missing", which ends no answer."""
    return words[0].text in book.leading_words("lacked") | book.leading_words("hanging")


def _last_clause(words: Words, book: Phrasebook) -> Words:
    """Return the clause that leads to "is": behind "and" or a mark and a part of the talk."""
    joints = book.little["last_clause"]
    cuts = [at + 1 for at in range(1, len(words) - 1) if words[at].text in joints]
    return words[max(cuts, default=0) :]


def _without_pronoun(words: Words, book: Phrasebook) -> Words:
    if len(words) > 1 and words[-1].text in book.leading_words("pronouns"):
        return words[:-1]
    return words


def _left_out(words: Words, book: Phrasebook) -> Words:
    """Return what was left out: behind "you dropped", or before "got missed"."""
    texts = _texts(words)
    for at in range(len(words)):
        for phrase in book.wrapping.get("lacks", ()):
            end = at + len(phrase)
            if texts[at:end] == phrase and end < len(words) and not words[end].broken:
                return _object(words[end:], book)
    for at in range(1, len(words)):
        for phrase in book.wrapping.get("lacked", ()):
            if texts[at : at + len(phrase)] == phrase and at + len(phrase) == len(words):
                return _subject(words[:at], book)
    return words


def _object(words: Words, book: Phrasebook) -> Words:
    cut = next((at for at in range(1, len(words)) if words[at].broken), len(words))
    found = words[:cut]
    if len(found) > 1 and found[-1].text in book.leading_words("lack_ends"):
        found = found[:-1]
    return found


def _subject(words: Words, book: Phrasebook) -> Words:
    helping = book.leading_words("auxiliaries") | book.leading_words("being")
    while len(words) > 1 and words[-1].text in helping:
        words = words[:-1]
    return _without_pronoun(words, book)


def _without_clause(words: Words, book: Phrasebook) -> Words:
    """Drop what follows a mark and begins anew: "wiping, that is what I would say"."""
    subjects = book.leading_words("pronouns") | book.leading_words("subjects")
    subjects |= book.leading_words("asides_begin")
    leads = {word for phrase in book.answer_words["heads"] for word in phrase}
    for at in range(1, len(words) - 1):
        if words[at].broken and words[at].text in subjects and not _names(words[at:], book):
            led = {word.text for word in words[:at]} <= book.leading_words(
                "wraps"
            ) | subjects | leads
            return words if led else words[:at]
    return words


def _described(words: Words, book: Phrasebook) -> Words:
    """Return what a body is like: before "this is the plate", or behind "the plate is"."""
    texts, being = _texts(words), book.leading_words("being")
    for at in range(1, len(words) - 1):
        if texts[at] in book.leading_words("pronouns") and texts[at + 1] in being:
            return _last_part(words[:at])
    places = [at for at in range(1, min(len(words) - 1, LONGEST_SIDE)) if texts[at] in being]
    named = places and texts[0] in book.leading_words("part_modifiers")
    words = words[places[0] + 1 :] if named else words
    texts = _texts(words)
    for phrase in book.wrapping.get("pointing", ()):
        if texts[-len(phrase) :] == phrase and len(phrase) < len(words):
            return words[: -len(phrase)]
    return words


def _last_part(words: Words) -> Words:
    cuts = [0, *(at for at in range(1, len(words)) if words[at].broken), len(words)]
    start, end = list(pairwise(cuts))[-1]
    return words[start:end]


def _texts(words: Words) -> Phrase:
    return tuple(word.text for word in words)
