"""Several answers in one line: "stacking, two steps, grab and place" tells a name, how many, which.

A count and a list of just as many names behind it stand for each other, so that what neither
would tell surely by itself is sure.
"""

from __future__ import annotations

from collections.abc import Iterator

from assistant.language.actions import read_action
from assistant.language.answers import answer, trimmed
from assistant.language.listing import items
from assistant.language.parsing import LIKELY, Hearing, Parse, texts_of
from assistant.language.phrasebook import Phrasebook
from assistant.language.words import Words, said
from assistant.model.teacher_acts import Inform, Unknown

_TOLD = 0.93
_LONGEST_NAME = 4
_FEWEST, _MOST, _FEWEST_ALONE = 2, 12, 3
_NEAR = 4
"""Words behind a number among which the list begins: "four bits in all, ..."."""
_LEADING = 2
"""Words that may lead to a list: "they are"."""


def counted(words: Words, hearing: Hearing) -> Parse | None:
    """Return a count and the steps that are listed behind it, with the name told before."""
    asked, book = hearing.listening.asked, hearing.book
    if asked not in ("subtask_count", "task_name"):
        return None
    for start, end, count in _counts(words, book):
        listed = _listed(words[end:], count, book)
        if not listed:
            continue
        told = (Inform(count), Inform(listed))
        if asked == "subtask_count":
            return Parse(told, _TOLD, "answer")
        name = answer(words[:start], "task_name", book) if start else None
        if name is not None and words[start].broken:
            return Parse((name, *told), _TOLD, "answer")
    return _listed_alone(words, hearing) if asked == "subtask_count" else None


def _listed_alone(words: Words, hearing: Hearing) -> Parse | None:
    """Return the steps that are listed where their number was asked for.

    The first tells an action, as most do: "goodness, how many?" is none.
    """
    marks = sum(word.broken for word in words[1:])
    listed = _listed(words, marks + 1, hearing.book) if marks + 1 >= _FEWEST_ALONE else ()
    acting = [read_action(one, (), hearing.language).action is not None for one in listed]
    told = acting[:1] == [True] and sum(acting) > len(acting) / 2
    return Parse((Inform(listed),), _TOLD, "answer") if told else None


def only_counted(words: Words, hearing: Hearing) -> Parse | None:
    """Return that a number alone names nothing where things or motions were asked for."""
    asked, book = hearing.listening.asked, hearing.book
    if asked not in ("objects", "actions"):
        return None
    texts = tuple(t for t in texts_of(words) if t not in book.little["counted"] | book.empty)
    number = book.numbers.number(texts, 0) if texts else None
    alone = number is not None and number[1] == len(texts) and number[0] != 1
    return Parse((Unknown(),), LIKELY) if alone else None


def _counts(words: Words, book: Phrasebook) -> Iterator[tuple[int, int, int]]:
    """Yield where numbers of steps stand, what is counted included, and how many they tell."""
    texts = texts_of(words)
    for at in range(len(words)):
        number = book.numbers.number(texts, at)
        if number is None or number[0] != int(number[0]) or not _FEWEST <= number[0] <= _MOST:
            continue
        near = range(number[1], min(number[1] + _NEAR, len(words)))
        noun = next((n + 1 for n in near if texts[n] in book.little["counted"]), None)
        end = noun or next((n for n in near if words[n].broken), None)
        if end is not None:
            yield at, end, int(number[0])


def _listed(words: Words, count: int, book: Phrasebook) -> tuple[str, ...]:
    """Return just as many names as were counted; none if others are listed."""
    talk = book.no | book.yes | book.little["or"] - book.little["and"]
    being = book.leading_words("being")
    if talk & set(texts_of(words)) or being & set(texts_of(words[_LEADING:])):
        return ()
    for told in (words, trimmed(words, book)):
        for found in (items(told, "actions", book), _unmarked(told, book)) if told else ():
            short = all(len(name.split()) <= _LONGEST_NAME for name in found)
            if len(found) == count and short and not _numbers(found, book):
                return found
    return ()


def _unmarked(words: Words, book: Phrasebook) -> tuple[str, ...]:
    """Return the names of a list said without marks: "scan grab swing and put down"."""
    joints = book.little["and"]
    if any(word.broken for word in words[1:]):
        return ()
    last = max((at for at, word in enumerate(words) if word.text in joints), default=0)
    alone = [word for word in words[:last] if word.text not in joints]
    little = book.impure | book.empty | book.leading_words("pronouns")
    if not alone or little & {word.text for word in alone}:
        return ()
    names = (*((word,) for word in alone), words[last + 1 :])
    return tuple(name for name in map(said, names) if name)


def _numbers(names: tuple[str, ...], book: Phrasebook) -> bool:
    """Tell numbers counted on fingers: "four: one, two, three, four"."""
    words = {word for name in names for word in name.split()}
    return any(book.numbers.number((word,), 0) for word in words - book.numbers.articles)
