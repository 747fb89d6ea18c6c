"""Ways to say an act: the sentences of a phrasebook, compiled, and which words they need."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

from assistant.language.lists import lines
from assistant.language.templates import (
    Node,
    Reader,
    all_words,
    compiled,
    first_words,
    has_slot,
    last_words,
    needed_words,
)


@dataclass(frozen=True, slots=True)
class Sentence:
    """A way to say an act, compiled; `first` and `last` hold what it can begin and end with."""

    act: str
    slots: Mapping[str, Any]
    nodes: tuple[Node, ...]
    first: frozenset[str] | None
    last: frozenset[str] | None
    stages: frozenset[str]
    asked: frozenset[str]
    extra: str
    template: str
    needed: tuple[frozenset[str], ...]
    only: frozenset[str] | None

    def may_match(self, words: frozenset[str], last: str) -> bool:
        """Tell quickly whether words can match: all are the template's, and none it needs lacks."""
        if self.last is not None and last not in self.last:
            return False
        if self.only is not None and not words <= self.only:
            return False
        return not any(map(words.isdisjoint, self.needed))


def sentences_of(
    book: Mapping[str, Any], readers: Mapping[str, Reader], made: dict[str, Node]
) -> Iterable[Sentence]:
    """Yield the sentences of a phrasebook, each compiled."""
    for entry in book["sentences"]:
        extra = next(
            (key for key in ("text", "list", "number", "seconds", "ratio") if key in entry), ""
        )
        for line in lines(entry["say"]):
            nodes = compiled(line, book["rules"], readers, made)
            yield Sentence(
                act=entry["act"],
                slots=entry.get("slots", {}),
                nodes=nodes,
                first=first_words(nodes),
                last=last_words(nodes),
                stages=frozenset(entry.get("stage", "").split()),
                asked=frozenset(entry.get("asked", "").split()),
                extra=extra,
                template=line,
                needed=needed_words(nodes),
                only=None if has_slot(nodes) else frozenset(all_words(nodes)),
            )


def needing(sentences: Sequence[Sentence]) -> Mapping[str, tuple[int, ...]]:
    """Return where the sentences stand that need a word; ``""`` holds those that need none.

    Of the sets of words a sentence needs one of, that of the rarest words tells most quickly.
    """
    often = Counter(word for one in sentences for word in all_words(one.nodes))
    found: dict[str, list[int]] = {"": []}
    for at, sentence in enumerate(sentences):
        least = min(sentence.needed, key=lambda one: sum(often[w] for w in one), default=None)
        for word in least if least else ("",):
            found.setdefault(word, []).append(at)
    return {word: tuple(ones) for word, ones in found.items()}


def beginning(sentences: Sequence[Sentence]) -> Mapping[str, frozenset[int]]:
    """Return where the sentences stand that begin with a word; ``""`` if with any."""
    found: dict[str, set[int]] = {}
    for at, sentence in enumerate(sentences):
        for word in ("",) if sentence.first is None else sentence.first:
            found.setdefault(word, set()).add(at)
    return {word: frozenset(ones) for word, ones in found.items()}
