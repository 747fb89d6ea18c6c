"""Fit the second reading of German, and print how well it knows speakers it has not seen.

There are few German sentences, so that the choice between readings begins with the weights of
English and moves from them only where German speakers say so. What the rules read stands in
``first_readings_german.json.gz``: their readings before anybody tuned rules on them.

run: python -m tests.benchmarks.fit_german [--write] [--kept FILE]
"""

from __future__ import annotations

import gzip
import json
import math
import pickle
import sys
from collections.abc import Iterator, Mapping, Sequence
from pathlib import Path
from typing import Any
from unittest.mock import patch

import numpy as np
from scipy.optimize import minimize

from assistant.language import choosing, likelihood, tagging
from assistant.language.little_words import LANGUAGES
from assistant.language.looks import Looks
from assistant.language.parsing import Hearing
from assistant.language.phrasebook import phrasebook
from assistant.language.repair import respelled
from assistant.language.tagging import Chain
from assistant.language.traits import word_traits
from tests.benchmarks import fit_language, fit_slots
from tests.benchmarks.fit_choice import Array, Line, chosen, readings, sure_at
from tests.benchmarks.german_examples import (
    FRESH,
    LANGUAGE,
    OLD,
    answers,
    spoken_clauses,
    template_clauses,
)
from tests.benchmarks.slot_clauses import Clause

FIRST = Path(__file__).parent / "first_readings_german.json.gz"
FOLDER = Path(likelihood.__file__).parent / LANGUAGE
FOLDS, INNER = 3, 6
WRONG = 0.005
"""The share of all sentences that may be wrong and sure."""
EXACT_FROM = 0.5
"""From which likelihood a sentence of the phrasebook is trusted: of 46 such, 45 were right."""
_PENALTY, _SURE_PENALTY = 5.0, 30.0
"""How far weights keep to those of English: how sure choices are hangs little on the language."""
_GROWN, _OTHERS_GROWN = 0.5, 0.2
"""The rules were extended since their first readings, those of English less."""


def sequence(one: Clause) -> fit_slots.Sequenced:
    """Return the rows of the weights for each word, the tags, and the tags allowed."""
    words = respelled(one.words, phrasebook(LANGUAGE), ())
    traits = word_traits(words, Hearing(phrasebook(LANGUAGE), one.listening, LANGUAGE))
    tags = np.array(tagging.tags_of_spans(one.spans, len(one.words)))
    return tagging.rows(traits, one.kind), tags, np.unique(tagging.ways_of(one.kind).tags)


def models(held: set[str]) -> tuple[likelihood.Model, Chain]:
    """Return both models, fitted on all but the speakers held."""
    examples = [*fit_language.spoken(OLD), *fit_language.written(LANGUAGE)]
    examples += [one for one in fit_language.spoken(FRESH) if one.speaker not in held]
    named = list(answers(np.random.default_rng(2)))
    examples += [_told(one) for one in named]
    labels = sorted({told for one in examples for told in one.labels})
    weights = fit_language.fitted(
        fit_language.matrix(examples, LANGUAGE),
        fit_language.targets(examples, labels),
        np.array([one.weight for one in examples]),
    )
    clauses = [*spoken_clauses(OLD), *template_clauses(np.random.default_rng(1)), *named]
    clauses += [one for one in spoken_clauses(FRESH) if one.speaker not in held]
    with patch.object(fit_slots, "sequence", sequence):
        chain = fit_slots.fitted(clauses)
    return likelihood.Model(tuple(labels), weights.astype(np.float32)), chain


def _told(one: Clause) -> fit_language.Example:
    """Return an answer as an example of its act, worth as much as a template."""
    text = " ".join(word.text for word in one.words)
    return fit_language.Example(one.speaker, text, one.listening, ("inform",), _TEMPLATE)


_TEMPLATE = 0.35


def lines() -> Iterator[Line]:
    """Yield the sentences of fresh speakers as models read them that never heard them."""
    speakers = sorted({one.speaker for one in fit_language.spoken(FRESH)})
    np.random.default_rng(5).shuffle(speakers)
    first = json.loads(gzip.decompress(FIRST.read_bytes()))
    for fold in range(FOLDS):
        held = set(speakers[fold::FOLDS])
        acts, slots = models(held)
        with (
            patch.object(likelihood, "model", lambda language, kept=acts: kept),
            patch("assistant.language.learned.chain", lambda language, kept=slots: kept),
        ):
            yield from readings(FRESH, held, first, LANGUAGE)
        print(f"  {fold + 1} of {FOLDS} shares", flush=True)


def _near(
    kept: Mapping[str, float], looks: Sequence[Looks], slopes: Any, penalty: float
) -> dict[str, float]:
    """Return the weights that fit best among those near others."""
    names = sorted({name for one in looks for name in one} | set(kept))
    told = np.array([[one.get(name, 0.0) for name in names] for one in looks])
    prior = np.array([kept.get(name, 0.0) for name in names])

    def loss(weights: Array) -> tuple[float, Array]:
        missed, slope = slopes(told @ weights)
        off = weights - prior
        return float(missed + penalty / 2 * off @ off), told.T @ slope + penalty * off

    found = minimize(loss, prior.copy(), jac=True, method="L-BFGS-B")
    return {name: round(float(one), 3) for name, one in zip(names, found.x, strict=True)}


def choice_of(lines: Sequence[Line], kept: Mapping[str, float]) -> dict[str, float]:
    """Return the weights by which a right reading is likeliest chosen."""
    told = [line for line in lines if any(line.right)]
    owner = np.repeat(np.arange(len(told)), [len(line.pool) for line in told])
    right = np.array([good for line in told for good in line.right], dtype=float)

    def slopes(scores: Array) -> tuple[float, Array]:
        top = np.full(len(told), -np.inf)
        np.maximum.at(top, owner, scores)
        odds = np.exp(scores - top[owner])
        shares = odds / np.bincount(owner, odds)[owner]
        good = np.bincount(owner, shares * right)
        return -np.log(good + 1e-12).sum(), shares - shares * right / good[owner]

    before = {**kept, "weighed": kept["weighed"] - _OTHERS_GROWN}
    found = _near(before, [one.looks for line in told for one in line.pool], slopes, _PENALTY)
    return {**found, "weighed": round(found["weighed"] + _GROWN, 3)}


def sureness_of(
    looks: Sequence[Looks], right: Sequence[bool], kept: Mapping[str, float]
) -> dict[str, float]:
    """Return the weights of how sure choices are."""
    good = np.array(right, dtype=float)

    def slopes(scores: Array) -> tuple[float, Array]:
        share = 1 / (1 + np.exp(-scores))
        missed = good * np.log(share + 1e-12) + (1 - good) * np.log(1 - share + 1e-12)
        return -missed.sum(), share - good

    return _near(kept, looks, slopes, _SURE_PENALTY)


def withheld(lines: Sequence[Line], kept: choosing.Weights) -> list[list[tuple[Looks, bool]]]:
    """Return choices made by weights of other speakers, a list for each share of them."""
    speakers = sorted({line.speaker for line in lines})
    np.random.default_rng(1).shuffle(speakers)
    found = []
    for fold in range(INNER):
        held = set(speakers[fold::INNER])
        others = [line for line in lines if line.speaker not in held]
        here = [line for line in lines if line.speaker in held]
        found.append(chosen(here, choice_of(others, kept.choice)))
    return found


def sure_of(parts: Sequence[Sequence[tuple[Looks, bool]]], kept: choosing.Weights) -> Array:
    """Return how sure choices are, by weights fitted on the other shares of the speakers."""
    found: list[float] = []
    for at, part in enumerate(parts):
        others = [one for n, told in enumerate(parts) if n != at for one in told]
        weights = sureness_of([a for a, _ in others], [b for _, b in others], kept.sureness)
        for looks, _ in part:
            odds = sum(weights.get(name, 0.0) * value for name, value in looks.items())
            found.append(1 / (1 + math.exp(-odds)))
    return np.array(found)


def report(told: Array, good: Array) -> float:
    """Print how sure choices are; return from where few enough of the sure are wrong."""
    print(f"{len(good)} lines, chosen {good.mean():.3f}")
    for least in (0.85, 0.9, 0.93, 0.95, 0.97):
        sure = told >= least
        print(f"  {least}: sure {sure.mean():.3f}, wrong {(sure & (good == 0)).mean():.4f}")
    return sure_at(told, good != 0, WRONG)


def write(acts: likelihood.Model, slots: Chain, page: Mapping[str, Any], least: float) -> None:
    """Write both models, and the weights of the choice."""
    with patch.dict(LANGUAGES, english=LANGUAGE):
        fit_language.write(acts.weights.astype(np.float64), acts.labels)
        fit_slots.write(slots)
    text = ["format: choice/1", "# Fitted by tests/benchmarks/fit_german.py.", f"sure_at: {least}"]
    text.append(f"exact_from: {EXACT_FROM}")
    for name, told in page.items():
        text.append(f"{name}:")
        text += [f"  {key}: {value:.3f}" for key, value in told.items()]
    (FOLDER / "choice.yaml").write_text("\n".join(text) + "\n")


def main() -> None:
    """Fit, print what speakers that were withheld show, and write on demand."""
    kept = choosing.weights("english")
    assert kept is not None
    kept_in = Path(sys.argv[sys.argv.index("--kept") + 1]) if "--kept" in sys.argv else None
    if kept_in and kept_in.exists():
        found = pickle.loads(kept_in.read_bytes())
    else:
        found = list(lines())
        if kept_in:
            kept_in.write_bytes(pickle.dumps(found))
    parts = withheld(found, kept)
    apart = [one for part in parts for one in part]
    right = [good for _, good in apart]
    least = report(sure_of(parts, kept), np.array(right, dtype=float))
    sureness = sureness_of([looks for looks, _ in apart], right, kept.sureness)
    if "--write" in sys.argv:
        page = {"choice": choice_of(found, kept.choice), "sureness": sureness}
        write(*models(set()), page, least)


if __name__ == "__main__":
    main()
