"""What is left of an answer when its wrapping is taken off: names, counts and lists."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from assistant.language.listing import items, steps
from assistant.language.phrasebook import Phrase, Phrasebook
from assistant.language.sides import told_side
from assistant.language.templates import Bound, Node, matches
from assistant.language.words import Word, Words, said, told
from assistant.language.wrappings import NAMES, headed, loosened, said_of
from assistant.model.teacher_acts import Asked, Inform

LISTS: frozenset[Asked] = frozenset(("objects", "actions"))
OPEN: frozenset[Asked] = frozenset(
    (
        "task_name",
        "goal",
        "subtask_count",
        "subtask_name",
        "objects",
        "actions",
        "missing_step",
        "which",
        "body",
        "facing",
    )
)
_KEEP_ARTICLE: frozenset[Asked] = frozenset(("task_name", "goal", "subtask_name", "facing"))


def answer(words: Words, asked: Asked, book: Phrasebook) -> Inform | None:
    """Return the answer to the question asked; None if nothing is left of it."""
    bare = trimmed(words, book)
    if asked == "subtask_count":
        return _count(bare or words, book)
    bare = trimmed(said_of(bare, asked, book), book)
    whole = bare
    if asked in NAMES:
        bare = trimmed(told_side(bare, asked, book), book)
    listed = steps(headed(bare, book), book) if asked == "subtask_name" else ()
    if listed:
        return Inform(listed)
    core = _unwrapped(bare, asked, book)
    sided = len(bare) < len(whole) and asked == "missing_step"
    if not sided and (core == bare or asked in NAMES):
        core = trimmed(loosened(core, asked, book), book)
    if not core:
        return None
    if asked in LISTS:
        found = items(core, asked, book)
        return Inform(found) if found else None
    if asked not in _KEEP_ARTICLE and len(core) > 1 and core[0].text in book.little["articles"]:
        core = core[1:]
    value = told(core) if asked == "goal" else said(core)
    return Inform(value) if value else None


def trimmed(words: Words, book: Phrasebook) -> Words:
    """Take hesitations and courtesies off both ends."""
    heads, tails = book.answer_words["heads"], book.answer_words["tails"]
    changed = True
    while changed and words:
        changed = False
        texts = _texts(words)
        for phrase in heads:
            if phrase[0] == texts[0] and _shorter(phrase, texts) and texts[: len(phrase)] == phrase:
                words, changed = words[len(phrase) :], True
                break
        texts = _texts(words)
        for phrase in tails:
            if phrase[-1] == texts[-1] and _shorter(phrase, texts) and _ends(texts, phrase):
                words, changed = words[: -len(phrase)], True
                break
    return words


def _shorter(phrase: Phrase, texts: Phrase) -> bool:
    return len(phrase) < len(texts)


def _ends(texts: Phrase, phrase: Phrase) -> bool:
    return texts[-len(phrase) :] == phrase


def wrapped(words: Words, asked: Asked, book: Phrasebook) -> bool:
    """Tell whether words are wrapped as an answer to the question."""
    return _unwrapping(words, asked, book) is not None


def _unwrapped(words: Words, asked: Asked, book: Phrasebook) -> Words:
    """Strip wrapping again and again until none is left."""
    for _ in range(4):
        best = _unwrapping(words, asked, book)
        if best is None:
            break
        words = trimmed(words[best[1] : best[2]], book)
    return words


def _unwrapping(words: Words, asked: Asked, book: Phrasebook) -> tuple[str, int, int] | None:
    """Return the value of the wrapping that explains most words."""
    texts = _texts(words)
    best: tuple[str, int, int] | None = None
    for nodes in (*book.answers.get(asked, ()), *_common(asked, book)):
        bound: Bound
        for bound in matches(nodes, texts):
            value = next((one for one in bound if one[0].startswith("value")), None)
            if value and (best is None or value[2] - value[1] < best[2] - best[1]):
                best = value
            break
    return best


def _common(asked: Asked, book: Phrasebook) -> tuple[tuple[Node, ...], ...]:
    # A goal is a whole sentence: "it is on the target" must keep its beginning.
    return () if asked == "goal" else book.answers["common"]


def _count(words: Words, book: Phrasebook) -> Inform | None:
    texts = _texts(words)
    counts = list(_counts(texts, book))
    if counts:
        # "the one and the other one, that makes five steps": what is counted stands behind.
        value = max(counts, key=lambda one: (one[1], one[0] != 1, one[2]))[0]
        value = _counted_up([one[0] for one in counts]) or value
        return Inform(0 if value == 1 and _is_none(texts, book) else value)
    if _is_none(texts, book):
        return Inform(0)
    if book.little["pairs"] & set(texts):
        return Inform(2)
    if book.little["dozens"] & set(texts):
        return Inform(12)
    return Inform(1) if texts and _single(texts, book) else None


def _single(texts: Phrase, book: Phrasebook) -> bool:
    """Tell that there is one; of a thing of other matters it is none: "may I have an ice"."""
    other = len(texts) > 1 and texts[1] in book.real - book.vocabulary
    return texts[0] in book.little["single"] and not other


def _counted_up(values: Sequence[int]) -> int:
    """Return the last of "one, two, three, so three"; 0 where nobody counts on fingers."""
    upward = all(value == at for at, value in enumerate(values[:3], start=1))
    return values[-1] if len(values) > 2 and upward else 0


def _counts(texts: Phrase, book: Phrasebook) -> Iterator[tuple[int, bool, int]]:
    """Yield whole numbers with whether steps are counted by them, and how early they are."""
    at = 0
    while at < len(texts):
        found = book.numbers.number(texts, at)
        if found is None or texts[at] in book.little["not_counted"]:
            at += 1
            continue
        if found[0] == int(found[0]) and 0 <= found[0] < 1000:
            behind = texts[found[1] : found[1] + 2]
            yield int(found[0]), bool(book.little["counted"] & set(behind)), -at
        at = found[1]


def _is_none(texts: Sequence[str], book: Phrasebook) -> bool:
    joined = f" {' '.join(texts)} "
    return any(f" {' '.join(phrase)} " in joined for phrase in book.answer_words["none"])


def _texts(words: Sequence[Word]) -> Phrase:
    return tuple(word.text for word in words)
