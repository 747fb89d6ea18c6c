"""Fitting of the net that tells which slot each word of a clause is in."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from assistant.language.families import vectors
from assistant.language.nets import MARKS, OWN, TAG_REACH, Net, Scores, windows
from tests.benchmarks.net_fitting import (
    MOST,
    NEVER,
    OWN_WIDE,
    UNHEARD,
    Batch,
    Rows,
    Slopes,
    Told,
    batch,
    descended,
    kept,
    own_slope,
    product,
    random,
    softmax,
    taken,
    unwindowed,
)

_FIRST, _SECOND = 80, 80


def tag_weights(rng: np.random.Generator, wide: int, context: int, tags: int) -> Slopes:
    """Return the weights a net of tags begins with."""
    size, span = wide + OWN_WIDE + MARKS, 2 * TAG_REACH + 1
    own = np.asarray(rng.normal(size=(OWN, OWN_WIDE)) * 0.3, np.float32)
    own[0] = 0.0
    return {
        "own": own,
        "near": random(rng, span * size, _FIRST),
        "near_context": np.zeros((context, _FIRST), np.float32),
        "far": random(rng, span * _FIRST, _SECOND),
        "far_context": np.zeros((context, _SECOND), np.float32),
        "tag": random(rng, _FIRST + _SECOND + size, tags),
        "tag_context": np.zeros((context, tags), np.float32),
    }


def tag_slopes(
    one: Batch,
    wanted: Rows,
    allowed: NDArray[np.bool_],
    weights: Slopes,
    known: Scores,
    rng: np.random.Generator,
) -> Slopes:
    """Return the slopes of a batch's loss for the net of tags, `wanted` (clauses, words)."""
    many, size = one.own.shape
    span, real = 2 * TAG_REACH + 1, one.real[..., None]
    heard = np.asarray(rng.random((many, size, 1)) > UNHEARD, np.float32)
    given = taken(one, weights, known, heard)
    cols = windows(given, span, TAG_REACH)
    near = cols @ weights["near"] + (one.context @ weights["near_context"])[:, None]
    keep = kept(rng, (many, 1, _FIRST)) * real
    low = np.maximum(near, 0.0) * keep
    wider = windows(low, span, TAG_REACH)
    far = wider @ weights["far"] + (one.context @ weights["far_context"])[:, None]
    keep_far = kept(rng, (many, 1, _SECOND)) * real
    outer = np.concatenate([low, np.maximum(far, 0.0) * keep_far, given], axis=2)
    scores = outer @ weights["tag"] + (one.context @ weights["tag_context"])[:, None]
    slope = softmax(np.where(allowed[:, None], scores, NEVER))
    slope[np.arange(many)[:, None], np.arange(size)[None, :], wanted] -= 1.0
    slope = np.asarray(slope * real / np.float32(4 * many), np.float32)
    found = {"tag": product(outer, slope), "tag_context": one.context.T @ slope.sum(axis=1)}
    back = slope @ weights["tag"].T
    up = np.asarray(back[..., _FIRST : _FIRST + _SECOND] * keep_far * (far > 0), np.float32)
    found |= {"far": product(wider, up), "far_context": one.context.T @ up.sum(axis=1)}
    down = back[..., :_FIRST] + unwindowed(up @ weights["far"].T, span, TAG_REACH, size)
    low_slope = np.asarray(down * keep * (near > 0), np.float32)
    found |= {"near": product(cols, low_slope)}
    found["near_context"] = one.context.T @ low_slope.sum(axis=1)
    into = back[..., _FIRST + _SECOND :]
    into = into + unwindowed(low_slope @ weights["near"].T, span, TAG_REACH, size)
    own = slice(known.shape[1], known.shape[1] + OWN_WIDE)
    return {**found, "own": own_slope(one, into[..., own] * heard)}


def fitted_net(
    told_of: Sequence[Told],
    wanted: Sequence[Rows],
    allowed: NDArray[np.bool_],
    context: tuple[str, ...],
    epochs: int,
    seed: int = 1,
) -> Net:
    """Return a net of tags fitted on clauses with the tags of their words."""
    rng, known = np.random.default_rng(seed), vectors("english")
    start = tag_weights(rng, known.shape[1], len(context), allowed.shape[1])

    def slopes(part: Rows, weights: Slopes, rng: np.random.Generator) -> Slopes:
        one = batch([told_of[n] for n in part])
        tags = np.zeros(one.own.shape, np.int64)
        for row, n in enumerate(part):
            tags[row, : len(told_of[n].own)] = wanted[n][:MOST]
        return tag_slopes(one, tags, allowed[part], weights, known, rng)

    sizes = np.array([len(one.own) for one in told_of])
    return Net(descended(start, sizes, np.ones(len(sizes)), slopes, epochs, rng), context)
