"""Answers wrapped in words nobody listed: what is named stands behind an anchor or at an end."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise

from assistant.language.phrasebook import Phrase, Phrasebook
from assistant.language.words import OWNER, Words
from assistant.model.teacher_acts import Asked

NAMES: frozenset[Asked] = frozenset(("task_name", "subtask_name", "which", "missing_step", "body"))
LONGEST_NAME = 6


def loosened(words: Words, asked: Asked, book: Phrasebook) -> Words:
    """Return the words an answer is about; all of them if nothing shows which."""
    if asked in NAMES:
        return _name(_marked(words, book), book)
    if asked in ("objects", "actions"):
        words = headed(words, book)
    return _bodies(words, book) if asked == "objects" else words


def said_of(words: Words, asked: Asked, book: Phrasebook) -> Words:
    """Return what "what we want in the end is ..." or "the whole point of it is that ..." says."""
    texts = _texts(words)
    doing = [at for at in range(1, len(texts) - 1) if texts[at + 1].endswith(book.little.doing)]
    if asked in ("task_name", "subtask_name") and any(_copula(words, at, book) for at in doing):
        return words[max(at for at in doing if _copula(words, at, book)) + 1 :]
    heading = next((at for at in range(1, min(len(words), 4)) if words[at].broken), 0)
    headings = {word for phrase in book.wrapping.get("goal_nouns", ()) for word in phrase}
    headed = (
        bool(headings & set(texts[:heading]))
        and set(texts[:heading]) <= headings | book.little["items_begin"]
    )
    if asked == "goal" and headed:
        return words[heading:]
    aside = next((at for at in range(1, len(words)) if words[at].broken), 0)
    if asked == "goal" and aside and _clause_of(texts[aside:], asked, book) and len(words) > 8:
        words, texts = words[aside:], texts[aside:]
    begun = _clause_of(texts, asked, book)
    copulas = [at for at in range(begun, len(texts) - 1) if begun and _copula(words, at, book)]
    if not copulas or not begun:
        return words
    at = (copulas[0] if asked not in NAMES else copulas[-1]) + 1
    at += texts[at - 1] in book.little["future"] and texts[at] in book.little["be"]
    leads = {phrase[0] for phrase in book.wrapping.get("leads", ())}
    while at < len(words) - 1 and texts[at] in leads:
        at += 1
    return words[at:]


def _clause_of(texts: Phrase, asked: Asked, book: Phrasebook) -> int:
    """Return from where on a copula ends the clause that leads to the answer; 0 if none does."""
    whats = {phrase[0] for phrase in book.wrapping.get("whats", ())}
    goals = book.wrapping.get("goal_nouns", ()) if asked == "goal" else ()
    for at in range(min(3, len(texts) - 1)):
        begins = texts[at + 1] in book.little["clause_subjects"]
        if texts[at] in whats and (begins or texts[at] not in book.little["everything"]):
            return at + 2
        noun = next((one for one in goals if texts[at : at + len(one)] == one), None)
        if noun is not None:
            return at + len(noun)
    return 0


def _copula(words: Words, at: int, book: Phrasebook) -> bool:
    """Tell an "is" that has no "you" or "it" before it, which would begin a new clause."""
    texts, little = _texts(words), book.little
    future = texts[at] in little["future"] and texts[at + 1] in little["be"]
    told = future or texts[at] in little["copulas"]
    alone = words[at].broken or texts[at - 1] not in little["clause_subjects"]
    return told and alone and texts[at + 1] not in little["about"]


def _marked(words: Words, book: Phrasebook) -> Words:
    """Return what follows the mark in "task name: cable routing"."""
    nouns = {phrase[0] for phrase in book.wrapping["name_nouns"]}
    cut = next((at for at in range(1, min(len(words), 6)) if words[at].broken), 0)
    told = {word.text.removesuffix(OWNER) for word in words[:cut]} & nouns
    return words[cut:] if told else words


def headed(words: Words, book: Phrasebook) -> Words:
    """Return what follows "the objects in question are", or "objects:"."""
    nouns = {phrase[0] for phrase in book.wrapping["list_nouns"]}
    copulas = {phrase[0] for phrase in book.wrapping["copulas"]}
    texts = _texts(words)
    for at in range(1, min(len(words) - 1, 9)):
        if words[at].broken and at < 5 and texts[at - 1] in nouns:
            return words[at:]
        if texts[at] in copulas and set(texts[:at]) & nouns and not words[at + 1].broken:
            return words[at + 1 :]
    return words


def _name(words: Words, book: Phrasebook) -> Words:
    """Return what follows the last anchor, or what no wrapping leads up to."""
    anchored = _after_anchor(words, book)
    wraps = book.leading_words("wraps")
    parts = _parts(anchored)
    while len(parts) > 1 and all(word.text in wraps for word in parts[0]):
        parts = parts[1:]
        anchored = tuple(word for part in parts for word in part)
    if len(parts) > 1:
        tailed = [part for part in parts[1:] if _tail(part, book.wrapping["tails"])]
        aside = (
            len(parts[0]) <= LONGEST_NAME
            and parts[1][0].text in wraps | book.little["meant_for_yes"]
        )
        anchored = parts[0] if tailed or aside else anchored
    tail = _tail(anchored, book.wrapping["tails"])
    if 0 < tail < len(anchored):
        anchored = anchored[:-tail]
    return _unwrapped(anchored, book)


def _after_anchor(words: Words, book: Phrasebook) -> Words:
    texts = _texts(words)
    for at in range(len(texts) - 1, 0, -1):
        for phrase in book.wrapping["anchors"]:
            anchored = at >= len(phrase) and texts[at - len(phrase) : at] == phrase
            if anchored and not set(texts[at:]) <= book.little["pointing_alone"]:
                return words[at:]
    return words


def _unwrapped(words: Words, book: Phrasebook) -> Words:
    """Take words of wrapping off the front, articles only where more of it follows."""
    wraps = book.leading_words("wraps")
    at = 0
    for n, word in enumerate(words[:-1]):
        if word.text in wraps:
            at = n + 1
        elif word.text not in book.little["articles"]:
            break
    return _without_noun(words[at:], book)


def _without_noun(words: Words, book: Phrasebook) -> Words:
    """Take a noun for tasks off the front: "sequence mat rolling"."""
    nouns = {phrase[0] for phrase in book.wrapping["task_nouns"]}
    return words[1:] if len(words) > 2 and words[0].text in nouns else words


def _parts(words: Words) -> list[Words]:
    """Return the stretches between commas and other marks."""
    breaks = [0, *(at for at in range(1, len(words)) if words[at].broken), len(words)]
    return [words[a:b] for a, b in pairwise(breaks)]


def _tail(words: Words, tails: Sequence[Phrase]) -> int:
    texts = _texts(words)
    return next((len(phrase) for phrase in tails if texts[-len(phrase) :] == phrase), 0)


def _bodies(words: Words, book: Phrasebook) -> Words:
    """Return the things of "what we have got here, you know, is a can and a pot"."""
    uses, after = book.leading_words("uses"), book.leading_words("after_items")
    texts = _texts(words)
    articles, one = book.little["items_begin"], book.little["one_item"]
    starts = [at for at in range(1, len(texts)) if texts[at] in articles and texts[at - 1] in uses]
    if not starts and texts[0] in book.leading_words("clause_starts"):
        starts = [at for at in range(1, min(8, len(texts))) if texts[at] in articles]
    if starts and not any(text in articles - one for text in texts[: starts[0]]):
        words, texts = words[starts[0] :], texts[starts[0] :]
    end = next((at for at in range(2, len(texts)) if texts[at] in after), len(texts))
    return words[:end] if not set(texts[end:]) & articles else words


def _texts(words: Words) -> Phrase:
    return tuple(word.text for word in words)
