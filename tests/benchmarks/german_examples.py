"""Sentences of German that a second reading is learned from: spoken ones, and templates.

There are few spoken ones. Which act words tell is learned from the phrasebook's templates as
well; so are the slots, with names put where a template has its slots.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator, Sequence
from dataclasses import replace
from typing import Any
from unittest.mock import patch

import numpy as np

from assistant.language import likelihood, tagging
from assistant.language.little_words import little_words
from assistant.language.naming import stem
from assistant.language.phrasebook import Phrase, Phrasebook, Sentence, phrasebook
from assistant.language.similarity import expanded
from assistant.language.tagging import Tagged
from assistant.language.templates import Choice, Node, Slot
from assistant.language.words import Words, said, words_of
from assistant.model.listening import Listening
from assistant.model.teacher_acts import STAGES, Asked
from tests.benchmarks import aligning
from tests.benchmarks.bench_language import Row, rows
from tests.benchmarks.slot_clauses import Clause, kind_of

LANGUAGE = "german"
OLD = ("german", "german_ways")
"""Every rule was tuned on these."""
FRESH = (
    "german_dev",
    "german_talk",
    "german_dev1",
    "german_dev2",
    "german_dev3",
    "german_regions",
    "german_trades",
    "german_dev5",
    "german_translated",
)
"""First read before any rule was tuned on them: see ``first_readings_german.json.gz``."""
_MARK = "¤"
_MOST = 25
"""Sentences a template gives clauses for."""
_LESSONS = ("tee kochen", "tisch decken", "kisten stapeln", "version zwei", "probe", "aufräumen")
_SAMPLES = {"number": ("which", 2), "seconds": ("at_s", 3.0), "ratio": ("factor", 0.5)}


def spoken_clauses(files: Sequence[str]) -> Iterator[Clause]:
    """Yield the sentences of corpora that are one act each, where its slots are found."""
    book = phrasebook(LANGUAGE)
    articles = little_words(LANGUAGE)["articles"]
    for file in files:
        for row in rows(f"{file}.yaml"):
            with patch.object(aligning, "_ARTICLES", articles):
                one = aligning.aligned(_as_said(row, book), book, Counter())
            kind = kind_of(row.acts[0], row.listening.asked)
            told = one.spans[0] if len(one.spans) == 1 else None
            free = kind == "inform" and row.acts[0]["value"] == "*"
            if told is not None and not free and tagging.TAKES.get(kind):
                yield Clause(f"{file}/{row.speaker}", one.words, row.listening, kind, told)


def _as_said(row: Row, book: Phrasebook) -> Row:
    """Return a sentence whose names stand as they are bent in it: "roten Becher"."""
    words = aligning.prepared(row.text, row.listening, book)
    acts = [{key: _each_bent(key, value, words) for key, value in act.items()} for act in row.acts]
    return replace(row, acts=acts)


def _each_bent(slot: str, value: Any, words: Words) -> Any:
    if isinstance(value, list):
        return [_each_bent(slot, one, words) for one in value]
    if isinstance(value, dict):
        return {key: _each_bent(key, one, words) for key, one in value.items()}
    if slot not in tagging.SLOTS or not isinstance(value, str) or "," in value:
        return value
    wanted = [stem(part, LANGUAGE) for part in value.lower().split()]
    told = [stem(word.said, LANGUAGE) for word in words]
    places = (at for at in range(len(told)) if wanted and told[at : at + len(wanted)] == wanted)
    at = next(places, None)
    return value if at is None else said(words[at : at + len(wanted)])


def template_clauses(rng: np.random.Generator) -> Iterator[Clause]:
    """Yield sentences that templates with slots stand for, names in their slots."""
    for sentence in phrasebook(LANGUAGE).sentences:
        ways = [way for way in expanded(_marked(sentence.nodes)) if _MARK in " ".join(way)]
        picked = rng.permutation(len(ways))[:_MOST]
        for at in sorted(picked):
            one = _clause(sentence, ways[at], rng)
            if one is not None:
                yield one


def _marked(nodes: Sequence[Node]) -> tuple[Node, ...]:
    """Return a template with a marked word in place of each slot."""
    found: list[Node] = []
    for node in nodes:
        if isinstance(node, Slot):
            found.append(_MARK + node.name)
        elif isinstance(node, Choice):
            found.append(Choice(tuple(_marked(way) for way in node.ways)))
        else:
            found.append(node)
    return tuple(found)


def _clause(sentence: Sentence, way: Phrase, rng: np.random.Generator) -> Clause | None:
    """Return a way of a template with names in its slots; None where an act takes none."""
    texts: list[str] = []
    spans: list[tuple[str, int, int]] = []
    for word in way:
        slot = word.removeprefix(_MARK).partition(":")[0]
        for told, filler in _fillers(sentence, slot, rng) if word[0] == _MARK else [("", word)]:
            start = len(texts)
            texts.extend(filler.split())
            if told:
                spans.append((told, start, len(texts)))
    kind = _kind(sentence)
    words = words_of(" ".join(texts), {})
    fits = spans and all(slot in tagging.TAKES.get(kind, ()) for slot, _, _ in spans)
    if not fits or len(words) != len(texts):
        return None
    stages: list[Any] = sorted(sentence.stages) or list(STAGES)
    asked: list[Any] = sorted(sentence.asked - {"none"}) or [None]
    stage, question = (one[rng.integers(len(one))] for one in (stages, asked))
    where = Listening(stage=stage, asked=question)
    return Clause("phrasebook", words, where, kind, _tagged(spans))


def _tagged(spans: Sequence[tuple[str, int, int]]) -> Tagged:
    return tuple(spans)


def _fillers(sentence: Sentence, slot: str, rng: np.random.Generator) -> Iterator[tuple[str, str]]:
    """Yield what stands in a slot, with the slot each stretch fills."""
    little = little_words(LANGUAGE)
    if slot in ("n", "nth"):
        yield "amount", little.first(f"example_{slot}")
    elif slot == "x":
        yield "", little.first("so")
    elif slot == "subtasks":
        first, second = rng.choice(little.examples, 2, replace=False)
        yield from ((slot, str(first)), ("", little.first("and")), (slot, str(second)))
    else:
        kept = sentence.act in ("save", "load", "compare")
        yield (
            {"older": "old"}.get(slot, slot),
            str(rng.choice(_LESSONS if kept else little.examples)),
        )


def _kind(sentence: Sentence) -> str:
    slots = dict(sentence.slots)
    if sentence.extra in _SAMPLES:
        name, value = _SAMPLES[sentence.extra]
        slots[name] = value
    try:
        told = likelihood.label(sentence.act, slots)
    except KeyError:
        return sentence.act
    return told if told in tagging.TAKES else sentence.act


_LONG = (
    "den Block auf das Ziel stellen, Äpfel in den Korb legen, zum Block fahren, in die Kiste "
    "legen, rüber zum Ziel, hoch und rüber heben, den Deckel von der Dose nehmen, die Tasse "
    "auf den Teller stellen, vorsichtig an die Wand drücken, nach oben ziehen, zum Ziel "
    "bringen, mit der Hand zugreifen, das Glas unter den Hahn halten, Wasser in den Topf "
    "gießen, den Löffel neben die Gabel legen, runter auf das Brett, über die Kiste fahren, "
    "den Würfel packen und anheben, vor den Becher fahren, aus dem Regal holen, auf den Tisch "
    "stellen, an den Rand schieben, Brot in Scheiben schneiden, Papier in den Drucker legen, "
    "die Schraube in das Loch drehen, zurück zum Anfang, langsam absetzen, wieder loslassen, "
    "Bücher ins Regal stellen, Wäsche aus der Maschine holen, die Karte in den Umschlag "
    "stecken, das Messer zur Seite legen, zum Korb schwenken, den Stein auf die Mauer setzen, "
    "Tee in die Tasse füllen, mit dem Lappen über den Tisch wischen, die Flasche am Hals "
    "greifen, kurz warten"
)
_WRAPPED = (
    "{}, {}, {}, {}, das ist {}, dann {}, erst {}, zuerst {}, danach {}, und dann {}, als "
    "nächstes {}, zum schluss {}, als letztes {}, danach kommt {}, dann kommt {}, der schritt "
    "heißt {}, der erste schritt ist {}, zuerst muss man {}, du musst {}, nenn es {}, es "
    "heißt {}, die aufgabe heißt {}, wir nennen das {}, heute machen wir {}, ich möchte dir "
    "{} beibringen, {} heißt das, {} nennen wir das, also {}, ja {}, äh {}"
)
_NAMED: tuple[Asked, ...] = ("task_name", "subtask_name", "subtask_name", "missing_step")


def long_names() -> tuple[str, ...]:
    """Return names of several words, as people say what is done with what and where."""
    return tuple(one.strip().lower() for one in _LONG.split(","))


def answers(rng: np.random.Generator) -> Iterator[Clause]:
    """Yield long names as answers, alone and in the words people put around them."""
    wrapped = [one.strip() for one in _WRAPPED.split(",")]
    for name in long_names():
        for at in rng.choice(len(wrapped), 10, replace=False):
            before, behind = (part.split() for part in wrapped[at].split("{}"))
            named = name.split()
            words = words_of(" ".join([*before, *named, *behind]), {})
            asked = _NAMED[rng.integers(len(_NAMED))]
            where = Listening(stage="introduction", asked=asked)
            spans = (("value", len(before), len(before) + len(named)),)
            yield Clause("phrasebook", words, where, "inform", spans)
