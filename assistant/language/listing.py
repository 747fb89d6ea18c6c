"""Lists in answers: things and motions, at commas, at joining words, or one after the other."""

from __future__ import annotations

from collections.abc import Iterator

from assistant.language.phrasebook import Phrase, Phrasebook
from assistant.language.words import Words, said
from assistant.model.teacher_acts import Asked

_MOST_IN_NAME = 4


def items(words: Words, asked: Asked, book: Phrasebook) -> tuple[str, ...]:
    """Return what a list names, articles and wrapping taken off."""
    parts = [part for part in _parts(words, asked, book) if part]
    heads = {word for phrase in book.answer_words["item_heads"] for word in phrase}
    parts = [part for part in parts if not {word.text for word in part} <= heads] or parts
    named = [_item(part, asked, book) for part in _uncounted(parts, book)]
    if asked == "objects":
        named = [one for part in named for one in _apart(part, book)]
    found = (said(_without_articles(part, book)) for part in named if part)
    return tuple(dict.fromkeys(one for one in found if one))


def steps(words: Words, book: Phrasebook) -> tuple[str, ...]:
    """Return the steps a line names one after the other; none if it is not plainly a list."""
    texts = _texts(words)
    joints = book.wrapping.get("step_joints", ())
    joined = any(texts[at : at + len(one)] == one for at in range(1, len(texts)) for one in joints)
    if not joined and not any(word.broken for word in words[1:]):
        return ()
    parts = [_item(part, "actions", book) for part in _parts(words, "subtask_name", book) if part]
    names = [part for part in parts if part]
    talk = _one(book, "being") | _one(book, "pronouns") | _one(book, "subjects")
    talk |= _one(book, "calling") | book.impure
    odd = any(len(name) > _MOST_IN_NAME or talk & set(_texts(name)) for name in names)
    told = tuple(said(_without_articles(name, book)) for name in names)
    alike = len(set(told)) < len(told)
    return () if len(names) < 2 or odd or alike or not all(told) else told


def _parts(words: Words, asked: Asked, book: Phrasebook) -> Iterator[Words]:
    """Yield the stretches between marks, joining words, and articles that begin anew."""
    texts = _texts(words)
    joints = book.answer_words["list_joints"]
    if asked == "subtask_name" and len([w for w in words[1:] if w.broken]) == 0:
        # "pick and place" is one step where nothing else tells a list.
        joints = tuple(book.wrapping.get("step_joints", ()))
    start = at = 0
    while at < len(words):
        joint = next((one for one in joints if texts[at : at + len(one)] == one), None)
        if joint is not None:
            yield words[start:at]
            at = start = at + len(joint)
            continue
        if at > start and (words[at].broken or _begins(texts, at, asked, book)):
            yield words[start:at]
            start = at
        at += 1
    yield words[start:]


def _begins(texts: Phrase, at: int, asked: Asked, book: Phrasebook) -> bool:
    """Tell an article or a "to" that begins the next of a list said without a pause."""
    if asked == "actions":
        return texts[0] == "to" and texts[at] == "to"
    articles, prepositions = _one(book, "articles"), _one(book, "prepositions")
    return (
        asked == "objects"
        and texts[at] in articles
        and texts[at - 1] not in (prepositions | articles | _one(book, "uses"))
    )


def _uncounted(parts: list[Words], book: Phrasebook) -> list[Words]:
    """Drop "two cups" before "a red cup and a blue cup"."""
    first, rest = parts[0], parts[1:]
    number = book.numbers.number(_texts(first), 0)
    counted = number is not None and number[0] > 1 and len(first) > number[1]
    kind = first[-1].text.removesuffix("s")
    if counted and sum(kind in {word.text for word in part} for part in rest) > 1:
        return rest
    return parts


def _item(words: Words, asked: Asked, book: Phrasebook) -> Words:
    words = _unled(words, asked, book)
    words = _without_heads(words, book)
    beginning = _one(book, "clause_begins") if asked == "objects" else frozenset[str]()
    cut = next((at for at in range(1, len(words)) if words[at].text in beginning), len(words))
    return words[:cut]


def _unled(words: Words, asked: Asked, book: Phrasebook) -> Words:
    """Take what leads to the thing off: "you will be dealing with a brick"."""
    texts = _texts(words)
    if asked != "objects":
        return words
    leading = _one(book, "uses") | _one(book, "wraps") | _one(book, "pronouns")
    leading |= _one(book, "subjects") | _one(book, "list_nouns") | _one(book, "copulas")
    articles = _one(book, "articles")
    start = next((at for at in range(1, len(texts)) if texts[at] in articles), 0)
    return words[start:] if start and set(texts[:start]) <= leading else words


def _without_heads(words: Words, book: Phrasebook) -> Words:
    heads = (*book.answer_words["item_heads"], *book.wrapping.get("item_adverbs", ()))
    changed = True
    while changed and len(words) > 1:
        changed = False
        texts = _texts(words)
        for phrase in heads:
            if len(phrase) < len(words) and texts[: len(phrase)] == phrase:
                words, changed = words[len(phrase) :], True
                break
    return words


def _apart(words: Words, book: Phrasebook) -> Iterator[Words]:
    """Yield the things of "plate fork knife" and "red cup blue cup"; one that is plainly one."""
    texts = _texts(words)
    things, qualities = _one(book, "things"), _one(book, "qualities")
    carriers = _one(book, "carriers")
    start = 0
    for at in range(1, len(words)):
        before, here = texts[at - 1], texts[at]
        split = here in qualities and before not in qualities
        both = before.removesuffix("s") in things and here.removesuffix("s") in things
        split = split or (both and here not in carriers)
        if split and not set(texts) & _one(book, "prepositions"):
            yield words[start:at]
            start = at
    yield words[start:]


def _without_articles(words: Words, book: Phrasebook) -> Words:
    articles = ("a", "an", "the")
    return tuple(word for word in words if word.text not in articles) or words


def _one(book: Phrasebook, name: str) -> frozenset[str]:
    return frozenset(phrase[0] for phrase in book.wrapping.get(name, ()) if len(phrase) == 1)


def _texts(words: Words) -> Phrase:
    return tuple(word.text for word in words)
