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
    leading = heads | _leading(book) - book.leading_words("list_nouns")
    empty = [_is_lead(part, leading if asked == "objects" else heads, heads) for part in parts]
    parts = [part for part, led in zip(parts, empty, strict=True) if not led] or parts
    named = [_item(part, asked, book) for part in _uncounted(parts, book)]
    if asked == "objects":
        named = [one for part in named for one in _apart(part, book)]
    found = (said(_without_articles(part, book)) for part in named if part)
    return tuple(dict.fromkeys(one for one in found if one))


def _is_lead(part: Words, leading: frozenset[str] | set[str], heads: set[str]) -> bool:
    """Tell a part that only leads to a thing; of one word it may be a thing, as "can" is."""
    texts = {word.text for word in part}
    return texts <= heads or (len(part) > 1 and texts <= leading)


def steps(words: Words, book: Phrasebook) -> tuple[str, ...]:
    """Return the steps a line names one after the other; none if it is not plainly a list."""
    texts = _texts(words)
    joints = book.wrapping.get("step_joints", ())
    joined = any(texts[at : at + len(one)] == one for at in range(1, len(texts)) for one in joints)
    if not joined and not any(word.broken for word in words[1:]):
        return ()
    parts = [_item(part, "actions", book) for part in _parts(words, "subtask_name", book) if part]
    names = [part for part in parts if part]
    talk = (
        book.leading_words("being")
        | book.leading_words("pronouns")
        | book.leading_words("subjects")
    )
    talk |= book.leading_words("calling") | book.impure
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
        if at > start and (words[at].broken or _begins(words, start, at, asked, book)):
            yield words[start:at]
            start = at
        at += 1
    yield words[start:]


def _begins(words: Words, start: int, at: int, asked: Asked, book: Phrasebook) -> bool:
    """Tell an article or a "to" that begins the next of a list said without a pause."""
    texts = _texts(words)
    if asked == "actions":
        last = max((n for n in range(len(texts) - 1) if texts[n] in book.little["and"]), default=-1)
        to = book.little["to"]
        return texts[at] in to and texts[last + 1] in to
    articles = book.leading_words("articles")
    if asked != "objects" or texts[at] not in articles or set(texts[start:at]) <= _leading(book):
        return False
    held = (
        book.leading_words("prepositions")
        | articles
        | book.leading_words("uses")
        | book.leading_words("copulas")
    )
    return texts[at - 1] not in held


def _leading(book: Phrasebook) -> frozenset[str]:
    """Return the words that lead to a thing: "you will be dealing with"."""
    names = ("uses", "wraps", "pronouns", "subjects", "list_nouns", "copulas", "item_adverbs")
    return frozenset().union(*(book.leading_words(name) for name in names))


def _uncounted(parts: list[Words], book: Phrasebook) -> list[Words]:
    """Drop "two cups" before "a red cup and a blue cup"."""
    if not parts:
        # Nothing but joining words was heard.
        return parts
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
    beginning = book.leading_words("clause_begins") if asked == "objects" else frozenset[str]()
    cut = next((at for at in range(1, len(words)) if words[at].text in beginning), len(words))
    words, texts = words[:cut], _texts(words[:cut])
    for phrase in book.wrapping.get("being_there", ()) if asked == "objects" else ():
        if len(phrase) < len(words) and texts[-len(phrase) :] == phrase:
            return words[: -len(phrase)]
    return words


def _unled(words: Words, asked: Asked, book: Phrasebook) -> Words:
    """Take what leads to the thing off: "you will be dealing with a brick"."""
    texts = _texts(words)
    if asked != "objects":
        return words
    articles = book.leading_words("articles")
    start = next((at for at in range(1, len(texts)) if texts[at] in articles), 0)
    holding = (
        texts[start - 1] in book.leading_words("copulas") - book.leading_words("being")
        if start
        else False
    )
    return words[start:] if start and (holding or set(texts[:start]) <= _leading(book)) else words


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
    things, qualities = book.leading_words("things"), book.leading_words("qualities")
    carriers = book.leading_words("carriers")
    bare = len(words) > 2 and {text.removesuffix("s") for text in texts} <= things
    start = 0
    for at in range(1, len(words)):
        before, here = texts[at - 1], texts[at]
        split = here in qualities and before not in qualities
        both = before.removesuffix("s") in things and here.removesuffix("s") in things
        split = split or (both and (here not in carriers or bare))
        if split and not set(texts) & book.leading_words("prepositions"):
            yield words[start:at]
            start = at
    yield words[start:]


def _without_articles(words: Words, book: Phrasebook) -> Words:
    articles = book.little["articles"]
    return tuple(word for word in words if word.text not in articles) or words


def _texts(words: Words) -> Phrase:
    return tuple(word.text for word in words)
