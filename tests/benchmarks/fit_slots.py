"""Fit the tagger of slots, and print how well it knows slots of speakers it has not seen.

run: python -m tests.benchmarks.fit_slots [--write] [--show]
"""

from __future__ import annotations

import sys
from collections import Counter
from collections.abc import Sequence
from pathlib import Path
from typing import get_args

import numpy as np
from numpy.typing import NDArray
from scipy.sparse import csr_matrix

from assistant.language import tagging
from assistant.language.nets import Net, context_of, packed, told_beside
from assistant.language.parsing import Hearing
from assistant.language.phrasebook import LANGUAGES, phrasebook
from assistant.language.repair import respelled
from assistant.language.tagging import BUCKETS, TAGS, TAKES, Chain, Tagged
from assistant.language.traits import word_traits
from assistant.language.words import Words
from assistant.model.teacher_acts import STAGES, Asked
from tests.benchmarks import net_fitting, tag_net
from tests.benchmarks.bench_language import FILES, FRESH
from tests.benchmarks.joined_nets import joined_tags
from tests.benchmarks.patterns import made
from tests.benchmarks.slot_clauses import Clause, clauses, clauses_of, renamed

_BATCH, _EPOCHS, _RATE = 48, 4, 0.05
_NET_EPOCHS, _SEEDS = 6, (1, 2)
_DECAY = 1e-4
_KEPT = 0.5
"""The share of traits that count in a step: no single one is leaned on."""
_COPIES = 2
_NEVER = np.float32(-1e4)
_FOLDS = 5
Scores = NDArray[np.float32]
Sequenced = tuple[NDArray[np.int64], NDArray[np.int64], NDArray[np.int64]]


def sequence(one: Clause) -> Sequenced:
    """Return the rows of the weights for each word, the tags, and the tags allowed."""
    book = phrasebook()
    traits = word_traits(respelled(one.words, book, ()), Hearing(book, one.listening))
    tags = np.array(tagging.tags_of_spans(one.spans, len(one.words)))
    return tagging.rows(traits, one.kind), tags, np.unique(tagging.ways_of(one.kind).tags)


def fitted(clauses: Sequence[Clause], seed: int = 3, *, net: bool = False) -> Chain:
    """Return weights by stochastic gradients (AdaGrad) of the likelihood of the tags.

    Parameters
    ----------
    net : bool
        Whether a net of English words seconds them.
    """
    rng = np.random.default_rng(seed)
    more = [one for _ in range(_COPIES) for one in renamed(clauses, rng)]
    told = [sequence(one) for one in [*clauses, *more]]
    count = len(TAGS)
    weights, steps = (np.zeros((size, count), np.float32) for size in (BUCKETS, count))
    seen, stepped = (np.full_like(one, 1e-4) for one in (weights, steps))
    sizes = np.array([len(tags) for _, tags, _ in told])
    for _ in range(_EPOCHS):
        order = np.argsort(sizes + rng.random(len(sizes)) * 3)
        batches = [order[at : at + _BATCH] for at in range(0, len(order), _BATCH)]
        rng.shuffle(batches)
        for batch in batches:
            slope, turn = _slopes([told[at] for at in batch], weights, steps, rng)
            slope += _DECAY * len(batch) * weights
            seen += slope**2
            weights -= _RATE * slope / np.sqrt(seen)
            stepped += turn**2
            steps -= _RATE * turn / np.sqrt(stepped)
    return Chain(weights, steps, net_of([*clauses, *more]) if net else None)


def net_of(clauses: Sequence[Clause]) -> Net:
    """Return the net fitted on clauses."""
    kinds = sorted(one for one, slots in TAKES.items() if slots)
    context = (
        *(f"?{one}" for one in (None, *get_args(Asked))),
        *(f"!{one}" for one in STAGES),
        *(f"={one}" for one in kinds),
    )
    empty, book = Net({}, context), phrasebook()
    told, wanted, allowed = [], [], np.zeros((len(clauses), len(TAGS)), bool)
    for n, one in enumerate(clauses):
        words = respelled(one.words, book, ())
        marks = [(w.broken, not w.said, w.text[:1].isdigit()) for w in words]
        beside = told_beside(one.listening.asked, one.listening.stage, one.kind)
        texts = [w.text for w in words]
        told.append(
            net_fitting.told(
                texts, "english", context_of(beside, empty), np.array(marks, np.float32)
            )
        )
        wanted.append(np.array(tagging.tags_of_spans(one.spans, len(words))))
        allowed[n, tagging.ways_of(one.kind).tags] = True
    return joined_tags(
        [tag_net.fitted_net(told, wanted, allowed, context, _NET_EPOCHS, seed) for seed in _SEEDS]
    )


def _slopes(
    part: Sequence[Sequenced], weights: Scores, steps: Scores, rng: np.random.Generator
) -> tuple[Scores, Scores]:
    """Return the slopes of a batch's loss: forward and backward over padded chains."""
    many, size, count = len(part), max(len(tags) for _, tags, _ in part), len(TAGS)
    wide = part[0][0].shape[1]
    real, tags = np.zeros((many, size), bool), np.zeros((many, size), np.int64)
    never = np.full((many, 1, count), _NEVER)
    for n, (_, tag, free) in enumerate(part):
        real[n, : len(tag)], tags[n, : len(tag)] = True, tag
        never[n, 0, free] = 0.0
    index = np.concatenate([row for row, _, _ in part]).ravel()
    data = (rng.random(index.size) < _KEPT).astype(np.float32) / np.float32(_KEPT)
    ends = np.arange(0, index.size + 1, wide)
    looks = csr_matrix((data, index, ends), shape=(len(ends) - 1, BUCKETS))
    emitted = np.zeros((many, size, count), np.float32)
    emitted[real] = looks @ weights
    emitted += never
    bound = np.where(_follows(), steps, _NEVER)
    ahead, behind, total = _passes(emitted, bound, real)
    share = np.exp(ahead + behind - total[:, None, None])
    turn = np.zeros((count, count), np.float32)
    for t in range(1, size):
        here = real[:, t]
        later = (emitted[:, t] + behind[:, t])[:, None, :] - total[:, None, None]
        turn += np.exp((ahead[:, t - 1, :, None] + bound + later)[here]).sum(axis=0)
        np.add.at(turn, (tags[here, t - 1], tags[here, t]), -1.0)
    share[np.arange(many)[:, None], np.arange(size)[None, :], tags] -= 1.0
    return np.asarray(looks.T @ share[real], dtype=np.float32), turn


def _passes(
    emitted: Scores, bound: Scores, real: NDArray[np.bool_]
) -> tuple[Scores, Scores, Scores]:
    """Return what leads to each tag, what follows it, and all together."""
    size = emitted.shape[1]
    ahead, behind = np.zeros_like(emitted), np.zeros_like(emitted)
    begins = np.array([_NEVER if tag.startswith("I-") else 0.0 for tag in TAGS], np.float32)
    ahead[:, 0] = emitted[:, 0] + begins
    for t in range(1, size):
        new = _summed(ahead[:, t - 1, :, None] + bound, 1) + emitted[:, t]
        ahead[:, t] = np.where(real[:, t, None], new, ahead[:, t - 1])
    for t in range(size - 2, -1, -1):
        ways = bound + (emitted[:, t + 1] + behind[:, t + 1])[:, None, :]
        behind[:, t] = np.where(real[:, t + 1, None], _summed(ways, 2), 0.0)
    return ahead, behind, _summed(ahead[:, -1], 1)


def _summed(ways: Scores, axis: int) -> Scores:
    """Return the logarithm of sums of exponentials."""
    top = ways.max(axis=axis, keepdims=True)
    told = np.squeeze(top, axis) + np.log(np.exp(ways - top).sum(axis=axis))
    return np.asarray(told, dtype=np.float32)


def _follows() -> NDArray[np.bool_]:
    """Return which tag may follow which: what goes on must have begun."""
    found = np.ones((len(TAGS), len(TAGS)), dtype=bool)
    for n, tag in enumerate(TAGS):
        if tag.startswith("I-"):
            found[:, n] = [one[2:] == tag[2:] for one in TAGS]
    return found


def report(chain: Chain, unseen: Sequence[Clause]) -> None:
    """Print how many clauses have all their slots right, their act being given."""
    book, wrong = phrasebook(), Counter[str]()
    for one in unseen:
        traits = word_traits(respelled(one.words, book, ()), Hearing(book, one.listening))
        seen = tagging.seconded(respelled(one.words, book, ()), one.listening, "english", chain)
        got = tagging.tagging(traits, one.kind, chain, seen)
        told, meant = _said(got.spans if got else (), one.words), _said(one.spans, one.words)
        wrong[one.kind] += told != meant
        if told != meant and "--show" in sys.argv:
            words = " ".join(w.text for w in one.words)
            print(f"  {words} [{one.kind} {one.listening.asked}] {meant} not {told}")
    right = 1 - wrong.total() / len(unseen)
    print(f"{len(unseen)} clauses, slots right {right:.3f}; wrong {wrong.most_common(6)}")


def _said(spans: Tagged, words: Words) -> list[tuple[str, str]]:
    articles = ("the", "a", "an")
    return [
        (slot, " ".join(w.said for w in words[a:b] if w.text not in articles))
        for slot, a, b in spans
    ]


def write(chain: Chain) -> None:
    """Write the weights in steps of a 127th of nearly the largest; those below count nothing."""
    told = np.abs(chain.weights[chain.weights != 0])
    limit = float(np.quantile(told, 0.9995))
    path = Path(tagging.__file__).parent / LANGUAGES["english"] / "slots.npz"
    steps = np.trunc(np.clip(chain.weights, -limit, limit) / limit * 127).astype(np.int8)
    net = packed(chain.net, "net") if chain.net else {}
    told = {"weights": steps, "scale": limit / 127, "steps": chain.steps, **net}
    np.savez_compressed(path, allow_pickle=False, **told)
    print(f"{path.name}: {path.stat().st_size} bytes")


def main() -> None:
    """Fit on all speakers to write, or with a share of the fresh ones withheld."""
    missed = Counter[str]()
    old, fresh = list(clauses(FILES, missed)), list(clauses(FRESH, missed))
    old += clauses_of("patterns", made(), missed)
    print(f"{len(old) + len(fresh)} clauses; slots not found {dict(missed)}")
    if "--write" in sys.argv:
        write(fitted([*old, *fresh], net=True))
        return
    held = set(sorted({one.speaker for one in fresh})[::_FOLDS])
    known = [*old, *(one for one in fresh if one.speaker not in held)]
    chain = fitted(known, net=True)
    report(chain, [one for one in fresh if one.speaker in held])


if __name__ == "__main__":
    main()
