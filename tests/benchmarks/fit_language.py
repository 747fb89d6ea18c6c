"""Fit the model of which act words tell, and print how well it knows speakers it has not seen.

run: python -m tests.benchmarks.fit_language [--write] [--show] [CORPUS to withhold ...]
"""

from __future__ import annotations

import itertools
import sys
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any, cast, get_args
from unittest.mock import patch
from zlib import crc32

import numpy as np
from numpy.typing import NDArray
from scipy.optimize import minimize
from scipy.sparse import csr_matrix

from assistant.language import likelihood
from assistant.language.nets import Net, context_of, packed, told_beside
from assistant.language.phrasebook import LANGUAGES, phrasebook
from assistant.language.repair import respelled
from assistant.language.similarity import spelled_out
from assistant.language.words import told as surface_of
from assistant.model.listening import Listening
from assistant.model.teacher_acts import STAGES, Asked
from assistant.plain_yaml import read_file
from tests.benchmarks import act_net, net_fitting, slot_clauses
from tests.benchmarks.aligning import prepared
from tests.benchmarks.bench_language import CORPUS, FILES, FRESH, SURE, Row, rows
from tests.benchmarks.joined_nets import joined_acts
from tests.benchmarks.patterns import made

_PENALTY = 0.3
_SPEAKER = 1.0
_TEMPLATE = 0.35
_PATTERN = 0.3
_RENAMED = 0.4
_BY_KIND = frozenset(
    ("inform", "rename", "optional", "required", "unordered", "ordered", "add_subtask")
) | {"remove_subtask", "merge", "split", "assign", "set_pose", "save", "load", "compare"}
"""Acts that how their slots are told tells whole."""
_SEEDS = (1, 2, 3)
_SEEN, _EPOCHS = 1.2, 12
"""How often the net sees an example that counts one, and how often it sees them all."""


@dataclass(frozen=True)
class Example:
    """Words with the labels they stand for, and how much they count."""

    speaker: str
    text: str
    listening: Listening
    labels: tuple[str, ...]
    weight: float


def spoken(files: Iterable[str]) -> Iterator[Example]:
    """Yield the sentences of corpora, in the words understanding goes about."""
    for file in files:
        for row in rows(file if file.endswith(".yaml") else f"{file}.yaml"):
            yield _example(file, row, _SPEAKER)


def patterned() -> Iterator[Example]:
    """Yield sentences made of patterns."""
    return (_example("patterns", row, _PATTERN) for row in made())


def renamed(files: Sequence[str]) -> Iterator[Example]:
    """Yield sentences of corpora with names of other speakers: no act is told by a name."""
    rng = np.random.default_rng(7)
    for one in slot_clauses.renamed(list(slot_clauses.clauses(files)), rng):
        told = "inform" if one.kind == "inform many" else one.kind
        if told in _BY_KIND:
            text = surface_of(one.words)
            yield Example(one.speaker, text, one.listening, (told,), _RENAMED)


def _example(source: str, row: Row, weight: float) -> Example:
    told = ({k: _whole(v) for k, v in act.items()} for act in row.acts)
    labels = tuple(dict.fromkeys(likelihood.label(str(act["act"]), act) for act in told))
    return Example(f"{source}/{row.speaker}", row.text, row.listening, labels, weight)


def chatted() -> Iterator[Example]:
    """Yield what people say around a robot that is not meant for it, in every stage in turn."""
    page = cast("Mapping[str, str]", read_file(CORPUS / "chat.yaml")[0].value)
    for speaker, lines in page.items():
        for line, stage in zip(lines.splitlines(), itertools.cycle(STAGES), strict=False):
            yield Example(f"chat/{speaker}", line, Listening(stage=stage), ("unknown",), _SPEAKER)


def _whole(value: Any) -> Any:
    return int(value) if isinstance(value, float) and value.is_integer() else value


def written(language: str) -> Iterator[Example]:
    """Yield what the phrasebook's templates stand for, each template counting little."""
    rng = np.random.default_rng(5)
    for text, sentence in spelled_out(language, rng):
        stages: list[Any] = sorted(sentence.stages) or list(STAGES)
        asked: list[Any] = sorted(sentence.asked - {"none"}) or [None]
        slots = dict(sentence.slots)
        if sentence.extra == "number":
            slots["which"] = 2
        told = likelihood.label(sentence.act, slots)
        stage, question = rng.integers(len(stages)), rng.integers(len(asked))
        where = Listening(stage=stages[stage], asked=asked[question])
        yield Example("phrasebook", text, where, (told,), _TEMPLATE)


def matrix(examples: Sequence[Example], language: str) -> csr_matrix:
    """Return the features of examples, one row each."""
    book = phrasebook(language)
    at, columns = [0], list[int]()
    values: list[float] = []
    for one in examples:
        words = prepared(one.text, one.listening, book)
        told = likelihood.features(
            tuple(w.text for w in words),
            tuple(w.text for w in respelled(words, book, ())),
            one.listening,
            language,
        )
        columns.extend(crc32(f.encode()) % likelihood.BUCKETS for f in told)
        values.extend(likelihood.scales(told).tolist())
        at.append(len(columns))
    shape = (len(examples), likelihood.BUCKETS)
    return csr_matrix((np.array(values), np.array(columns), np.array(at)), shape=shape)


def fitted(
    features: csr_matrix, targets: NDArray[np.float64], weights: NDArray[np.float64]
) -> NDArray[np.float64]:
    """Return the weights of a multinomial logistic regression with a ridge penalty."""
    size = features.shape[1], targets.shape[1]

    def loss(flat: NDArray[np.float64]) -> tuple[float, NDArray[np.float64]]:
        told = flat.reshape(size)
        scores = features @ told
        scores -= scores.max(axis=1, keepdims=True)
        odds = np.exp(scores)
        odds /= odds.sum(axis=1, keepdims=True)
        missed = -(weights[:, None] * targets * np.log(odds + 1e-12)).sum()
        slope = features.T @ (weights[:, None] * (odds - targets)) + _PENALTY * told
        return float(missed + _PENALTY * (told**2).sum() / 2), slope.ravel()

    start = np.zeros(size[0] * size[1])
    found = minimize(loss, start, jac=True, method="L-BFGS-B", options={"maxiter": 70})
    return np.asarray(found.x).reshape(size)


def model_of(examples: Sequence[Example]) -> likelihood.Model:
    """Return the model fitted on examples."""
    labels = sorted({told for one in examples for told in one.labels})
    weights = np.array([one.weight for one in examples])
    told = fitted(matrix(examples, "english"), targets(examples, labels), weights)
    return likelihood.Model(tuple(labels), told.astype(np.float32), net_of(examples, labels))


def net_of(examples: Sequence[Example], labels: Sequence[str]) -> Net:
    """Return the net fitted on examples; those that count little are seen seldom."""
    context = (*(f"?{one}" for one in (None, *get_args(Asked))), *(f"!{one}" for one in STAGES))
    empty, book = Net({}, context), phrasebook("english")
    taken = [
        net_fitting.told(
            [w.text for w in respelled(prepared(one.text, one.listening, book), book, ())],
            "english",
            context_of(told_beside(one.listening.asked, one.listening.stage), empty),
        )
        for one in examples
    ]
    counts = np.minimum(1.0, np.array([one.weight for one in examples]) * _SEEN)
    wanted = targets(examples, labels).astype(np.float32)
    return joined_acts(
        [act_net.fitted_net(taken, wanted, counts, context, _EPOCHS, seed) for seed in _SEEDS]
    )


def targets(examples: Sequence[Example], labels: Sequence[str]) -> NDArray[np.float64]:
    """Return the labels of examples, a row of shares each."""
    place = {one: at for at, one in enumerate(labels)}
    found = np.zeros((len(examples), len(labels)))
    for row, one in enumerate(examples):
        for told in one.labels:
            found[row, place[told]] = 1 / len(one.labels)
    return found


def told_by(model: likelihood.Model, examples: Sequence[Example]) -> NDArray[np.float64]:
    """Return the probability of each label for each example."""
    book, found = phrasebook("english"), []
    with patch.object(likelihood, "model", lambda language: model):
        for one in examples:
            words = prepared(one.text, one.listening, book)
            told = tuple(w.text for w in words), tuple(w.text for w in respelled(words, book, ()))
            odds = likelihood.likelihoods(*told, one.listening)
            found.append([odds[label] for label in model.labels])
    return np.array(found)


def report(model: likelihood.Model, unseen: Sequence[Example]) -> None:
    """Print how well acts of sentences that were not learned from are known."""
    odds, labels = told_by(model, unseen), model.labels
    best = [labels[at] for at in odds.argmax(axis=1)]
    acts = [{told.split()[0] for told in one.labels} for one in unseen]
    right = np.array([one.split()[0] in told for one, told in zip(best, acts, strict=True)])
    sure = odds.max(axis=1) > SURE
    wrong = (sure & ~right).mean()
    print(f"acts right {right.mean():.3f}, sure {sure.mean():.2f}, sure and wrong {wrong:.4f}")
    if "--show" in sys.argv:
        for one, told, good in zip(unseen, best, right, strict=True):
            if not good:
                print(f"  {one.text!r} [{one.listening.asked}]: {one.labels}, not {told}")


def write(weights: NDArray[Any], labels: Sequence[str], net: Net | None = None) -> None:
    """Write the weights in steps of a 127th of the largest."""
    scale = float(np.abs(weights).max() / 127)
    told = packed(net, "net") if net else {}
    path = Path(likelihood.__file__).parent / LANGUAGES["english"] / "likelihood.npz"
    steps = np.round(weights / scale).astype(np.int8)
    np.savez_compressed(
        path, allow_pickle=False, labels=np.array(labels), weights=steps, scale=scale, **told
    )
    print(f"{path.name}: {path.stat().st_size} bytes")


def main() -> None:
    """Fit on all corpora but those named, and print how well these are known."""
    tested = [one for one in sys.argv[1:] if not one.startswith("-")]
    learned = [*spoken(one for one in (*FILES, *FRESH) if one not in tested), *chatted()]
    learned += [*patterned(), *written("english")]
    learned += renamed([one for one in (*FILES, *FRESH) if one not in tested])
    unseen = list(spoken(tested))
    print(f"{len(learned)} examples", flush=True)
    model = model_of(learned)
    if unseen:
        report(model, [one for one in unseen if set(one.labels) <= set(model.labels)])
    if "--write" in sys.argv:
        write(model.weights, model.labels, model.net)


if __name__ == "__main__":
    main()
