"""The likest known sentence, for words no template explains; never sure of itself.

Sentences without free slots are taken from the phrasebook as examples. Words count by their
rarity, so that sharing "the" says little; what an example lacks and what it has too much both
count against it. The result is a guess to read back, never one to act on.
"""

from __future__ import annotations

import math
from collections import Counter
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import cache

from numpy.random import Generator

from assistant.language.little_words import LittleWords, little_words
from assistant.language.phrasebook import Phrase, Sentence, phrasebook
from assistant.language.templates import Choice, Node, Phrases, Slot, has_slot
from assistant.model.listening import Listening

MOST_EXAMPLES = 120
LEAST_LIKENESS = 0.56
_HIGHEST = 0.8


@dataclass(frozen=True)
class Examples:
    """Example sentences with an index from words to them."""

    sentences: tuple[tuple[frozenset[str], Sentence], ...]
    by_word: Mapping[str, tuple[int, ...]]
    weights: Mapping[str, float]


@cache
def examples(language: str) -> Examples:
    """Return the examples of a language, collected once."""
    found: dict[tuple[frozenset[str], str, str], Sentence] = {}
    for sentence in phrasebook(language).sentences:
        if has_slot(sentence.nodes) or sentence.act in ("affirm", "deny", "stop"):
            continue
        for n, phrase in enumerate(expanded(sentence.nodes)):
            phrase = tuple(_stem(word, language) for word in phrase)
            found.setdefault((frozenset(phrase), sentence.act, str(sentence.slots)), sentence)
            if n >= MOST_EXAMPLES:
                break
    pairs = tuple((words, sentence) for (words, _, _), sentence in found.items() if words)
    counts = Counter(word for words, _ in pairs for word in words)
    index: dict[str, list[int]] = {}
    for at, (words, _) in enumerate(pairs):
        for word in words:
            index.setdefault(word, []).append(at)
    weights = {word: math.log(1 + len(pairs) / (1 + n)) for word, n in counts.items()}
    return Examples(pairs, {word: tuple(ones) for word, ones in index.items()}, weights)


def likest(
    words: Phrase, listening: Listening, language: str = "english"
) -> tuple[Sentence, float] | None:
    """Return the likest example's sentence and a confidence below any that acts."""
    known = examples(language)
    stems = frozenset(_stem(word, language) for word in words)
    said = stems - little_words(language)["no_content"] or stems
    strange = max(known.weights.values()) * 0.8
    mass = sum(known.weights.get(word, strange) for word in said)
    rare = sorted(said, key=lambda word: len(known.by_word.get(word, ())))
    near = {at for word in rare[:4] for at in known.by_word.get(word, ())}
    best: tuple[float, Sentence] | None = None
    for at in near:
        example, sentence = known.sentences[at]
        if sentence.stages and listening.stage not in sentence.stages:
            continue
        if sentence.asked and (listening.asked or "none") not in sentence.asked:
            continue
        common = sum(known.weights[word] for word in example & said)
        whole = mass + sum(known.weights[word] for word in example - said)
        likeness = common / whole if whole else 0.0
        if best is None or likeness > best[0]:
            best = (likeness, sentence)
    if best is None or best[0] < LEAST_LIKENESS:
        return None
    return best[1], min(_HIGHEST, best[0])


def _stem(word: str, language: str) -> str:
    """Return a word without the endings that change nothing here."""
    for ending in little_words(language).likeness:
        if word.endswith(ending) and len(word) - len(ending) >= 3:
            return word.removesuffix(ending)
    return word


def expanded(nodes: Sequence[Node]) -> Iterator[Phrase]:
    """Yield phrases a template stands for: each choice once, the others at their first."""
    firsts = tuple(next(iter(_ways(node))) for node in nodes)
    for at, node in enumerate(nodes):
        for way in _ways(node):
            yield tuple(word for part in (*firsts[:at], way, *firsts[at + 1 :]) for word in part)


def spelled_out(language: str, rng: Generator) -> Iterator[tuple[str, Sentence]]:
    """Yield sentences the templates stand for, some names in their slots."""
    for sentence in phrasebook(language).sentences:
        for n, phrase in enumerate(
            expanded(_without_slots(sentence.nodes, rng, little_words(language)))
        ):
            yield " ".join(phrase), sentence
            if n >= MOST_EXAMPLES:
                break


def _without_slots(nodes: Sequence[Node], rng: Generator, little: LittleWords) -> tuple[Node, ...]:
    found: list[Node] = []
    for node in nodes:
        if isinstance(node, Slot):
            numbered = node.name in ("n", "nth")
            name = str(rng.choice(little.examples)) if not numbered else ""
            told = name or little.first(f"example_{node.name}")
            found.extend(told.split())
        elif isinstance(node, Choice):
            found.append(Choice(tuple(_without_slots(way, rng, little) for way in node.ways)))
        else:
            found.append(node)
    return tuple(found)


def _ways(node: Node) -> Iterator[Phrase]:
    """Yield what one element stands for; what may be missing comes first as missing."""
    if isinstance(node, str):
        yield (node,)
    elif isinstance(node, Phrases):
        yield from _tree(node.tree)
    elif isinstance(node, Choice):
        ways = sorted(node.ways, key=len)
        for way in ways:
            if len(way) <= 1:
                yield from _ways(way[0]) if way else iter(((),))
            else:
                yield from expanded(way)


def _tree(tree: Mapping[str, object]) -> Iterator[Phrase]:
    if "" in tree:
        yield ()
    for word, below in tree.items():
        if word and isinstance(below, dict):
            for rest in _tree(below):
                yield (word, *rest)
