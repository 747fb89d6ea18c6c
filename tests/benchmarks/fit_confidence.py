"""Fit how sure a reading is, on speakers and words that were withheld.

For each share of the speakers the model of acts is fitted on all others, and a part of the
phrasebook is taken away, so that words nobody listed occur as they do in life. What the
readings then look like, and whether they were right, gives the weights of a logistic model.

run: python -m tests.benchmarks.fit_confidence [--write] [--folds N]
"""

from __future__ import annotations

import random
import re
import sys
from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path
from typing import Any
from unittest.mock import patch

import numpy as np
from numpy.typing import NDArray
from scipy.optimize import minimize
from scipy.sparse import csr_matrix

from assistant.language import frames as frames_module
from assistant.language import likelihood
from assistant.language import phrasebook as phrasebook_module
from assistant.language.confidence import TRAITS, Reading, Trait, traits
from assistant.language.understanding import read
from assistant.model.teacher_acts import act_to_json
from assistant.plain_yaml import read_file
from tests.benchmarks.bench_language import FILES, SURE, Row, rows, same
from tests.benchmarks.fit_language import Example, fitted, matrix, spoken, targets, written

WITHHELD, COMMON = 0.35, 0.4
"""Shares of the phrasebook's ways: taken away of the rarer ones; common ones, which stay."""
KEPT = frozenset(
    [
        *("numbers", "little", "frames", "dialect", "contractions", "vocatives", "contrary"),
        *("not_taken_back", "correction", "format"),
    ]
)
"""Parts of the phrasebook of which nothing is withheld."""
PENALTY = 0.3
TEMPLATES = 0.2
"""Share of the phrasebook's own sentences learned from; all would take long."""


@dataclass(frozen=True)
class Seen:
    """A reading of a sentence: what it looks like and whether it is right."""

    speaker: str
    text: str
    told: Mapping[Trait, float]
    right: bool


def withheld(book: Any, rng: random.Random) -> Any:
    """Return a page of the phrasebook with some of its ways left out."""
    if isinstance(book, dict):
        return {k: v if k in KEPT else withheld(v, rng) for k, v in book.items()}
    if isinstance(book, list):
        return [withheld(one, rng) for one in book]
    if isinstance(book, str) and "|" in book:
        return re.sub(r"\(([^()\[\]]+)\)", lambda found: f"({_thinned(found[1], '|', rng)})", book)
    if isinstance(book, str) and book.count(",") > 8:
        return _thinned(book, ",", rng)
    return book


def _thinned(text: str, mark: str, rng: random.Random) -> str:
    # The first ways of a list are the commonest; it is the rare ones nobody thinks of.
    ways = text.split(mark)
    common = max(2, int(COMMON * len(ways)))
    kept = [way for way in ways[common:] if rng.random() > WITHHELD]
    return mark.join([*ways[:common], *kept])


def unseen(folds: int) -> Iterator[Seen]:
    """Yield readings of every speaker by models that know neither him nor all the words.

    Whole sentences of the phrasebook are left out: they are as sure as it says.
    """
    rng = random.Random(3)
    told = [one for one in written("english") if rng.random() < TEMPLATES]
    everything = [*spoken(FILES), *told]
    known = matrix(everything, "english")
    speakers = sorted({one.speaker for one in everything} - {"phrasebook"})
    random.Random(1).shuffle(speakers)
    sentences = [(f"{file}/{row.speaker}", row) for file in FILES for row in rows(f"{file}.yaml")]
    for fold in range(folds):
        out = set(speakers[fold::folds])
        kept = [at for at, one in enumerate(everything) if one.speaker not in out]
        model = _model([everything[at] for at in kept], known[kept])
        with _withheld(model, random.Random(100 + fold)):
            for speaker, row in sentences:
                if speaker in out:
                    reading = read(row.text, row.listening)
                    if not reading.parse.exact:
                        yield _seen(speaker, row, reading)


def _model(examples: list[Example], known: csr_matrix) -> likelihood.Model:
    labels = tuple(sorted({told for one in examples for told in one.labels}))
    weights = np.array([one.weight for one in examples])
    told = fitted(known, targets(examples, labels), weights)
    return likelihood.Model(labels, told.astype(np.float32))


@contextmanager
def _withheld(made: likelihood.Model, rng: random.Random) -> Iterator[None]:
    """Read with this model, and with a phrasebook of which a part is taken away."""

    def thin(path: Path) -> list[_Node]:
        return [_Node(withheld(node.value, rng)) for node in read_file(path)]

    with (
        patch.object(likelihood, "model", lambda language: made),
        patch.object(phrasebook_module, "read_file", thin),
        patch.object(frames_module, "read_file", thin),
    ):
        _clear()
        yield
    _clear()


@dataclass(frozen=True)
class _Node:
    value: Any


def _clear() -> None:
    phrasebook_module.phrasebook.cache_clear()
    frames_module.frames.cache_clear()


def _seen(speaker: str, row: Row, reading: Reading) -> Seen:
    right = same(row.acts, [act_to_json(act) for act in reading.parse.acts])
    return Seen(speaker, row.text, traits(reading), right)


def fit(seen: list[Seen]) -> NDArray[np.float64]:
    """Return the weights of the traits, ridge penalized."""
    told = np.array([[one.told[name] for name in TRAITS] for one in seen])
    right = np.array([one.right for one in seen], float)

    def loss(weights: NDArray[np.float64]) -> tuple[float, NDArray[np.float64]]:
        scores = told @ weights
        odds = 1 / (1 + np.exp(-scores))
        missed = -(right * np.log(odds + 1e-12) + (1 - right) * np.log(1 - odds + 1e-12)).sum()
        slope = told.T @ (odds - right) + PENALTY * weights
        return float(missed + PENALTY * (weights**2).sum() / 2), slope

    found = minimize(loss, np.zeros(len(TRAITS)), jac=True, method="L-BFGS-B")
    return np.asarray(found.x)


def surety(seen: list[Seen], weights: NDArray[np.float64]) -> NDArray[np.float64]:
    """Return how sure each reading is."""
    told = np.array([[one.told[name] for name in TRAITS] for one in seen])
    return np.asarray(1 / (1 + np.exp(-told @ weights)))


def crossed(seen: list[Seen], parts: int = 10) -> NDArray[np.float64]:
    """Return how sure each reading is by weights fitted on other speakers."""
    speakers = sorted({one.speaker for one in seen})
    part_of = {speaker: at % parts for at, speaker in enumerate(speakers)}
    found = np.zeros(len(seen))
    for part in range(parts):
        others = [one for one in seen if part_of[one.speaker] != part]
        weights = fit(others)
        ours = [at for at, one in enumerate(seen) if part_of[one.speaker] == part]
        found[ours] = surety([seen[at] for at in ours], weights)
    return found


def calibration_error(sure: NDArray[np.float64], right: NDArray[np.bool_]) -> float:
    """Return the expected calibration error over ten equal bins."""
    bins = np.minimum((sure * 10).astype(int), 9)
    gaps = [
        abs(sure[bins == b].mean() - right[bins == b].mean()) * (bins == b).mean()
        for b in range(10)
        if (bins == b).any()
    ]
    return float(sum(gaps))


def main() -> None:
    """Print the weights, calibration, and how often a sure reading is wrong."""
    folds = int(sys.argv[sys.argv.index("--folds") + 1]) if "--folds" in sys.argv else 4
    seen = list(unseen(folds))
    right = np.array([one.right for one in seen])
    sure = crossed(seen)
    print(f"{len(seen)} sentences, {WITHHELD:.0%} of rare words withheld: {right.mean():.3f} right")
    print(f"calibration error {calibration_error(sure, right):.4f}")
    for least in (0.8, 0.85, 0.9, 0.95, 0.97):
        above = sure >= least
        wrong = (above & ~right).mean()
        print(f">= {least}: {above.mean():.2f} of sentences, wrong {wrong:.4f} of all sentences")
    if "--show" in sys.argv:
        for one, told in zip(seen, sure, strict=True):
            if told >= SURE and not one.right:
                print(f"  {told:.3f} {one.speaker}: {one.text!r}")
    weights = fit(seen)
    for name, weight in zip(TRAITS, weights, strict=True):
        print(f"  {name}: {weight:.3f}")
    if "--write" in sys.argv:
        path = Path(likelihood.__file__).parent / "english" / "confidence.yaml"
        lines = [f"  {name}: {weight:.3f}" for name, weight in zip(TRAITS, weights, strict=True)]
        head = "format: confidence/1\n# Fitted by tests/benchmarks/fit_confidence.py.\nweights:\n"
        path.write_text(head + "\n".join(lines) + "\n", encoding="utf-8")


if __name__ == "__main__":
    main()
