"""Which words of a sentence hold its slots: what a tagger of slots is fitted on.

Slot texts are stretches of the sentence once articles are dropped, numbers are read by the
reader of quantities. What cannot be found is counted, not guessed.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from itertools import pairwise
from typing import Any

from assistant.language.fillers import without_fillers
from assistant.language.phrasebook import Phrasebook
from assistant.language.repair import without_slips
from assistant.language.tagging import SLOTS, Tagged
from assistant.language.words import Words, words_of
from assistant.model.listening import Listening
from tests.benchmarks.bench_language import Row

_ARTICLES = frozenset(("the", "a", "an"))
_AMOUNTS = ("distance_m", "angle_deg", "factor", "at_s", "episode", "which")
_ANY = "*"


@dataclass(frozen=True)
class Aligned:
    """A sentence with the stretches of words that hold the slots of each act.

    Parameters
    ----------
    spans : tuple of tuple of (slot, start, end)
        One tuple an act; None where some slot of the act was not found.
    """

    row: Row
    words: Words
    spans: tuple[Tagged | None, ...]


def aligned(row: Row, book: Phrasebook, missed: Counter[str]) -> Aligned:
    """Return a sentence with its slots found."""
    words = prepared(row.text, row.listening, book)
    taken: set[int] = set()
    found: list[Tagged | None] = []
    behind = 0
    for act in row.acts:
        spans = _spans(act, words, taken, behind, book, missed, row.listening.asked)
        found.append(spans)
        for _, start, end in spans or ():
            taken |= set(range(start, end))
            behind = max(behind, start)
    return Aligned(row, words, tuple(found))


def prepared(text: str, listening: Listening, book: Phrasebook) -> Words:
    """Return the words as understanding goes about them."""
    words = words_of(text, book.contractions)
    return without_slips(without_fillers(words, listening.asked, book), book)


def _spans(
    act: Mapping[str, Any],
    words: Words,
    taken: set[int],
    behind: int,
    book: Phrasebook,
    missed: Counter[str],
    asked: str | None,
) -> Tagged | None:
    """Return where the slots of an act stand; None if one is nowhere."""
    wanted = sorted(_wanted(act, asked), key=lambda one: -len(str(one[1])))
    used, found = set(taken), []
    for slot, value in wanted:
        options = list(_places(slot, value, words, book))
        free = [one for one in options if not used & set(range(*one))]
        later = [one for one in free if one[0] >= behind]
        if not free:
            missed[f"{act['act']} {slot}"] += 1
            return None
        chosen = _chosen(slot, later or free, words)
        used |= set(range(*chosen))
        found.append((slot, *chosen))
    return tuple(sorted(found, key=lambda one: one[1]))


def _wanted(act: Mapping[str, Any], asked: str | None) -> Iterator[tuple[str, Any]]:
    name = act["act"]
    for key, value in act.items():
        if key == "where":
            if "subtask" in value:
                yield f"where_{value.get('when', 'during')}", value["subtask"]
        elif key in _AMOUNTS and not isinstance(value, str):
            if not (name == "cue" and value == 1.0):
                yield "amount", value
        elif key == "value" and isinstance(value, float):
            yield "amount", value
        elif key in SLOTS and value != _ANY and not (key == "value" and value == _ANY):
            for one in [value] if asked == "goal" and key == "value" else _each(value):
                yield key, one


def _each(value: Any) -> list[Any]:
    if isinstance(value, str) and "," in value:
        return [one.strip() for one in value.split(",")]
    return list(value) if isinstance(value, list) else [value]


def _places(slot: str, value: Any, words: Words, book: Phrasebook) -> Iterator[tuple[int, int]]:
    if slot == "amount":
        yield from _amounts(float(value), words, book)
        return
    wanted = [w.text for w in words_of(str(value), book.contractions)]
    if len(wanted) > 1 and wanted[0] in _ARTICLES:
        wanted = wanted[1:]
    kept = [at for at, word in enumerate(words) if word.text not in _ARTICLES]
    texts = [word.text for word in words]
    size = len(wanted)
    for at in range(len(words) - size + 1):
        if texts[at : at + size] == wanted:
            yield at, at + size
    bare = [w for w in wanted if w not in _ARTICLES]
    for n in range(len(kept) - len(bare) + 1):
        places = kept[n : n + len(bare)]
        if bare and [texts[at] for at in places] == bare:
            span = places[0], places[-1] + 1
            if span[1] - span[0] != size:
                yield span


def _amounts(value: float, words: Words, book: Phrasebook) -> Iterator[tuple[int, int]]:
    texts = [word.text for word in words]
    longest = -1
    for at in range(len(texts)):
        if at < longest:
            continue
        quantity = book.numbers.quantity(texts, at)
        place = book.numbers.ordinal(texts, at)
        for told, end in (
            (quantity.value, quantity.end) if quantity else (None, 0),
            (float(place[0]), place[1]) if place else (None, 0),
        ):
            if told is None:
                continue
            near = abs(abs(told) - abs(value)) <= 0.01 * max(abs(value), 1e-9)
            ratio = any(
                abs(one - value) <= 0.01 * value for one in (1 + told, 1 - told) if value > 0
            )
            flipped = told != 0 and abs(1 / told - value) <= 0.01 * abs(value)
            if near or (slot_is_ratio(told, value) and (ratio or flipped)):
                yield at, end
                longest = end
                break


def slot_is_ratio(told: float, value: float) -> bool:
    """Tell whether a told number may be a factor in disguise: "30 % slower" is 0.7."""
    return 0 < value <= 10 and 0 < abs(told) <= 10


def _chosen(slot: str, options: Sequence[tuple[int, int]], words: Words) -> tuple[int, int]:
    """Return the last place: who corrects himself says the right one last."""
    if slot in ("first", "old", "subtask", "where_during", "where_before", "where_after"):
        return options[0]
    return options[-1]


def clauses_of(one: Aligned, cuts: Sequence[int]) -> list[tuple[Words, Tagged | None]]:
    """Return the stretches between cuts with the slots that stand in them."""
    found = []
    for (start, end), spans in zip(pairwise((0, *cuts, len(one.words))), one.spans, strict=True):
        shifted = (
            None
            if spans is None or any(not start <= a < b <= end for _, a, b in spans)
            else tuple((slot, a - start, b - start) for slot, a, b in spans)
        )
        found.append((one.words[start:end], shifted))
    return found
