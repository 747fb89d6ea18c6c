"""Clauses of one act with the words that hold its slots, and the same with other names."""

from __future__ import annotations

from collections import Counter, defaultdict
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from assistant.language import tagging
from assistant.language.answers import LISTS
from assistant.language.likelihood import label
from assistant.language.phrasebook import phrasebook
from assistant.language.tagging import Tagged
from assistant.language.words import Word, Words
from assistant.model.listening import Listening
from tests.benchmarks.aligning import aligned
from tests.benchmarks.bench_language import Row, rows

_ANY = "*"


@dataclass(frozen=True)
class Clause:
    """A clause of one act with its slots; `kind` is how they are told."""

    speaker: str
    words: Words
    listening: Listening
    kind: str
    spans: Tagged


def kind_of(act: Mapping[str, Any], asked: str | None) -> str:
    """Return how the slots of an act are told."""
    told = label(act["act"], act)
    if told != "inform":
        return told if told in tagging.TAKES else str(act["act"])
    listed = isinstance(act["value"], list) or "," in str(act["value"])
    return "inform many" if asked != "goal" and (asked in LISTS or listed) else told


def clauses(files: Sequence[str], missed: Counter[str] | None = None) -> Iterator[Clause]:
    """Yield the sentences of corpora that are one act each, where its slots are found."""
    for file in files:
        yield from clauses_of(file, rows(f"{file}.yaml"), missed)


def clauses_of(
    source: str, said: Iterable[Row], missed: Counter[str] | None = None
) -> Iterator[Clause]:
    """Yield those of some sentences that are one act each, where its slots are found."""
    book, missing = phrasebook(), Counter[str]() if missed is None else missed
    for row in said:
        one = aligned(row, book, missing)
        kind = kind_of(row.acts[0], row.listening.asked)
        free = kind == "inform" and row.acts[0]["value"] == _ANY
        if free or len(one.spans) > 1 or one.spans[0] is None or not tagging.TAKES.get(kind):
            continue
        yield Clause(f"{source}/{row.speaker}", one.words, row.listening, kind, one.spans[0])


def renamed(clauses: Sequence[Clause], rng: np.random.Generator) -> Iterator[Clause]:
    """Yield clauses with names of other speakers in their slots."""
    pool = defaultdict[str, list[Words]](list)
    for one in clauses:
        for slot, start, end in one.spans:
            pool[_pool(one, slot)].append(one.words[start:end])
    for one in clauses:
        named = any(slot != "amount" for slot, _, _ in one.spans)
        if not named or one.listening.asked == "goal":
            continue
        words: list[Word] = []
        spans: list[tuple[str, int, int]] = []
        at = 0
        for slot, start, end in one.spans:
            words.extend(one.words[at:start])
            new = one.words[start:end]
            if slot != "amount":
                others = pool[_pool(one, slot)]
                new = others[rng.integers(len(others))]
                new = (Word(new[0].text, new[0].said, one.words[start].broken), *new[1:])
            spans.append((slot, len(words), len(words) + len(new)))
            words.extend(new)
            at = end
        words.extend(one.words[at:])
        yield Clause(one.speaker, tuple(words), one.listening, one.kind, tuple(spans))


def _pool(one: Clause, slot: str) -> str:
    """Return what a name is a name of: only names of the same are exchanged."""
    if slot == "value":
        return f"value {one.listening.asked}"
    if one.kind in ("save", "load", "compare"):
        return "lesson"
    return slot if slot in ("object", "amount") else "step"
