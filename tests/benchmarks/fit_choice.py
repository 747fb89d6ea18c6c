"""Fit which reading of a line is chosen and how sure it is, on speakers that were withheld.

For each share of the speakers both learned models are fitted on all others. What the rules
read stands in ``first_readings.json.gz``: their readings of these sentences before anybody
tuned rules on them, since rules that were tuned on a sentence are right about it too often.
Speakers are withheld once more to print how right and how sure the choices are.

run: python -m tests.benchmarks.fit_choice [--write] [--kept FILE]
"""

from __future__ import annotations

import gzip
import json
import math
import pickle
import sys
from collections.abc import Callable, Collection, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any
from unittest.mock import patch

import numpy as np
from numpy.typing import NDArray
from scipy.optimize import minimize

from assistant.language import choosing, likelihood
from assistant.language.choosing import candidates, plain, ranking, sure_looks
from assistant.language.looks import Candidate, Looks
from assistant.language.parsing import Hearing, Parse
from assistant.language.phrasebook import LANGUAGES, phrasebook
from assistant.language.repair import respelled
from assistant.language.seeking import chances_of
from assistant.model.teacher_acts import Stop, act_from_json, act_to_json
from tests.benchmarks import fit_language, fit_slots, slot_clauses
from tests.benchmarks.aligning import prepared
from tests.benchmarks.bench_language import FILES, FRESH, Row, rows, same
from tests.benchmarks.patterns import made

FIRST = Path(__file__).parent / "first_readings.json.gz"
FOLDS, INNER = 3, 5
WRONG = 0.005
"""The share of all sentences that may be wrong and sure."""
_GROWN = 0.2
"""What the rules are worth more than when they were first read: they were extended since."""
_PENALTY, _SURE_PENALTY = 3.0, 1.0
Array = NDArray[np.float64]


@dataclass(frozen=True)
class Line:
    """A sentence with its readings, and which of them are right."""

    speaker: str
    row: Row
    pool: list[Candidate]
    right: list[bool]


def lines(folds: int = FOLDS) -> Iterator[Line]:
    """Yield the sentences of fresh speakers as models read them that never heard them."""
    said = list(fit_language.spoken(FRESH))
    known = [*fit_language.spoken(FILES), *fit_language.chatted(), *fit_language.patterned()]
    known += [*fit_language.written("english"), *fit_language.renamed(FILES)]
    more = list(fit_language.renamed(FRESH))
    clauses = list(slot_clauses.clauses(FRESH))
    old = [*slot_clauses.clauses(FILES), *slot_clauses.clauses_of("patterns", made())]
    speakers = sorted({one.speaker for one in said})
    np.random.default_rng(5).shuffle(speakers)
    first = json.loads(gzip.decompress(FIRST.read_bytes()))
    for fold in range(folds):
        held = set(speakers[fold::folds])
        others = (e for e in (*said, *more) if e.speaker not in held)
        acts = fit_language.model_of([*known, *others])
        told = [*old, *(c for c in clauses if c.speaker not in held)]
        slots = fit_slots.fitted(told, net=True)
        with (
            patch.object(likelihood, "model", lambda language, kept=acts: kept),
            patch("assistant.language.learned.chain", lambda language, kept=slots: kept),
        ):
            yield from readings(FRESH, held, first)
        print(f"  {fold + 1} of {folds} shares", flush=True)


def readings(
    files: Iterable[str], held: Collection[str], first: Mapping[str, Any], language: str = "english"
) -> Iterator[Line]:
    """Yield the sentences of held speakers that are not plain, with their readings.

    Parameters
    ----------
    files : iterable of str
    held : collection of str
        Speakers, each with the file.
    first : mapping
        What the rules read at first, by sentence, stage and question.
    language : str
    """
    book = phrasebook(language)
    for file in files:
        for row in rows(f"{file}.yaml"):
            told = first.get(f"{row.text}|{row.listening.stage}|{row.listening.asked}")
            words = prepared(row.text, row.listening, book)
            if f"{file}/{row.speaker}" not in held or told is None or not words:
                continue
            hearing = Hearing(book, row.listening, language)
            before, weighed = (
                Parse(tuple(act_from_json(a) for a in acts), score, how)
                for acts, score, how in told
            )
            chances = chances_of(words, respelled(words, book, ()), hearing)
            if plain(weighed, chances) or Stop() in weighed.acts:
                continue
            pool = candidates(before, weighed, words, chances, hearing)
            meant = [_unhyphened(act) for act in row.acts]
            right = [same(meant, [act_to_json(a) for a in one.acts]) for one in pool]
            yield Line(f"{file}/{row.speaker}", row, pool, right)


def _unhyphened(told: Any) -> Any:
    """Return an act with names as they are read: hyphens come back to them afterwards."""
    if isinstance(told, dict):
        return {key: _unhyphened(value) for key, value in told.items()}
    if isinstance(told, list):
        return [_unhyphened(value) for value in told]
    return told.replace("-", " ") if isinstance(told, str) else told


def choice_of(lines: Sequence[Line]) -> dict[str, float]:
    """Return the weights by which a right reading is likeliest chosen."""
    told = [line for line in lines if any(line.right)]
    looks = [one.looks for line in told for one in line.pool]
    names, features = _table(looks)
    owner = np.repeat(np.arange(len(told)), [len(line.pool) for line in told])
    right = np.array([good for line in told for good in line.right], dtype=float)

    def loss(weights: Array) -> tuple[float, Array]:
        scores = features @ weights
        top = np.full(len(told), -np.inf)
        np.maximum.at(top, owner, scores)
        odds = np.exp(scores - top[owner])
        shares = odds / np.bincount(owner, odds)[owner]
        good = np.bincount(owner, shares * right)
        slope = features.T @ (shares - shares * right / good[owner])
        missed = -np.log(good + 1e-12).sum() + _PENALTY / 2 * (weights @ weights)
        return float(missed), np.asarray(slope + _PENALTY * weights)

    found = _named(names, _least(loss, len(names)))
    return {**found, "weighed": round(found["weighed"] + _GROWN, 3)}


def sureness_of(looks: Sequence[Looks], right: Sequence[bool]) -> dict[str, float]:
    """Return the weights of how sure choices are."""
    names, features = _table(looks)
    good = np.array(right, dtype=float)

    def loss(weights: Array) -> tuple[float, Array]:
        share = 1 / (1 + np.exp(-(features @ weights)))
        missed = -(good * np.log(share + 1e-12) + (1 - good) * np.log(1 - share + 1e-12)).sum()
        slope = features.T @ (share - good) + _SURE_PENALTY * weights
        return float(missed + _SURE_PENALTY / 2 * (weights @ weights)), np.asarray(slope)

    return _named(names, _least(loss, len(names)))


def _table(looks: Sequence[Looks]) -> tuple[list[str], Array]:
    names = sorted({name for one in looks for name in one})
    return names, np.array([[one.get(name, 0.0) for name in names] for one in looks])


def _least(loss: Callable[[Array], tuple[float, Array]], size: int) -> Array:
    found = minimize(loss, np.zeros(size), jac=True, method="L-BFGS-B", options={"maxiter": 300})
    return np.asarray(found.x)


def _named(names: Sequence[str], values: Array) -> dict[str, float]:
    return {name: round(float(value), 3) for name, value in zip(names, values, strict=True)}


def chosen(lines: Sequence[Line], choice: Mapping[str, float]) -> list[tuple[Looks, bool]]:
    """Return what choices look like, and which are right."""
    found = []
    for line in lines:
        ranked = ranking(line.pool, choice)
        at = next(n for n, one in enumerate(line.pool) if one is ranked[0][1])
        found.append((sure_looks(ranked), line.right[at]))
    return found


def _folds(lines: Sequence[Line], count: int) -> list[int]:
    speakers = sorted({line.speaker for line in lines})
    np.random.default_rng(1).shuffle(speakers)
    place = {one: n % count for n, one in enumerate(speakers)}
    return [place[line.speaker] for line in lines]


def withheld(lines: Sequence[Line], count: int = INNER) -> list[tuple[Looks, bool]]:
    """Return choices, each made by weights that did not know the speaker."""
    folds = _folds(lines, count)
    found = []
    for fold in range(count):
        choice = choice_of([one for one, n in zip(lines, folds, strict=True) if n != fold])
        found += chosen([one for one, n in zip(lines, folds, strict=True) if n == fold], choice)
    return found


def report(lines: Sequence[Line]) -> tuple[Array, NDArray[np.bool_]]:
    """Print how right and how sure choices are; return both for each sentence."""
    folds = _folds(lines, INNER)
    shares: list[float] = []
    right: list[bool] = []
    for fold in range(INNER):
        others = [one for one, n in zip(lines, folds, strict=True) if n != fold]
        here = [one for one, n in zip(lines, folds, strict=True) if n == fold]
        inner = withheld(others, INNER - 1)
        weights = sureness_of([a for a, _ in inner], [b for _, b in inner])
        for looks, fits in chosen(here, choice_of(others)):
            odds = sum(weights.get(name, 0.0) * value for name, value in looks.items())
            shares.append(1 / (1 + math.exp(-odds)))
            right.append(fits)
    told, good = np.array(shares), np.array(right)
    grammar = np.mean([line.right[0] for line in lines])
    oracle = np.mean([any(line.right) for line in lines])
    print(f"{len(lines)} lines; rules {grammar:.3f}, chosen {good.mean():.3f}, best {oracle:.3f}")
    for least in (0.85, 0.9, 0.93, 0.95, 0.96, 0.97, 0.98, 0.985, 0.99):
        sure = told >= least
        print(f"  {least}: sure {sure.mean():.3f}, sure and wrong {(sure & ~good).mean():.4f}")
    return told, good


def sure_at(told: Array, right: NDArray[np.bool_], most: float = WRONG) -> float:
    """Return the least probability from which no larger share of all is wrong."""
    order = np.argsort(-told)
    wrong = np.cumsum(~right[order]) / len(told)
    few = np.flatnonzero(wrong <= most)
    return round(float(told[order][few[-1]]), 4) if len(few) else 0.99


def write(choice: dict[str, float], sureness: dict[str, float], least: float) -> None:
    """Write both sets of weights."""
    path = Path(choosing.__file__).parent / LANGUAGES["english"] / "choice.yaml"
    page = ["format: choice/1", "# Fitted by tests/benchmarks/fit_choice.py.", f"sure_at: {least}"]
    for name, told in (("choice", choice), ("sureness", sureness)):
        page.append(f"{name}:")
        page += [f"  {key}: {value:.3f}" for key, value in told.items()]
    path.write_text("\n".join(page) + "\n")
    print(f"{path.name}: {path.stat().st_size} bytes")


def main() -> None:
    """Fit, print what speakers that were withheld show, and write on demand."""
    kept = Path(sys.argv[sys.argv.index("--kept") + 1]) if "--kept" in sys.argv else None
    if kept and kept.exists():
        found = pickle.loads(kept.read_bytes())
    else:
        found = list(lines())
        if kept:
            kept.write_bytes(pickle.dumps(found))
    told, right = report(found)
    inner = withheld(found)
    sureness = sureness_of([a for a, _ in inner], [b for _, b in inner])
    if "--write" in sys.argv:
        # Plain sentences are not weighed: they are sure, and hardly one of them is wrong.
        said = sum(1 for _ in fit_language.spoken(FRESH))
        write(choice_of(found), sureness, sure_at(told, right, WRONG * said / len(found)))


if __name__ == "__main__":
    main()
