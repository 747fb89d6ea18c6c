"""Fitting of the net that tells which act a clause is."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from assistant.language.families import vectors
from assistant.language.nets import ACT_WINDOWS, OWN, Net, Scores, windows
from tests.benchmarks.net_fitting import (
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
    random,
    softmax,
    taken,
    unwindowed,
)

_WIDE, _INNER = (48, 80, 96), 128


def act_weights(rng: np.random.Generator, wide: int, context: int, labels: int) -> Slopes:
    """Return the weights a net of acts begins with."""
    found = {"own": np.asarray(rng.normal(size=(OWN, OWN_WIDE)) * 0.3, np.float32)}
    found["own"][0] = 0.0
    for width, count in zip(ACT_WINDOWS, _WIDE, strict=True):
        found[f"see{width}"] = random(rng, width * (wide + OWN_WIDE), count)
        found[f"see{width}_from"] = np.zeros(count, np.float32)
    found["inner"], found["label"] = (
        random(rng, sum(_WIDE) + context, _INNER),
        random(rng, _INNER, labels),
    )
    found["inner_from"] = np.zeros(_INNER, np.float32)
    found["label_from"] = np.zeros(labels, np.float32)
    return {**found, "context": np.zeros((context, labels), np.float32)}


def act_slopes(
    one: Batch, wanted: Scores, weights: Slopes, known: Scores, rng: np.random.Generator
) -> Slopes:
    """Return the slopes of a batch's loss for the net of acts."""
    many, size = one.own.shape
    heard = np.asarray(rng.random((many, size, 1)) > UNHEARD, np.float32)
    given = taken(one, weights, known, heard)
    peaks, tops, seen = [], [], []
    for width in ACT_WINDOWS:
        edge = min(width - 1, 1)
        cols = windows(given, width, edge)
        shown = cols @ weights[f"see{width}"]
        within = one.real.sum(axis=1)[:, None] + 2 * edge - width + 1
        shown[np.arange(shown.shape[1])[None, :] >= within] = NEVER
        top = shown.argmax(axis=1)
        peak = np.take_along_axis(shown, top[:, None], 1)[:, 0] + weights[f"see{width}_from"]
        peaks.append(peak)
        tops.append(top)
        seen.append(cols)
    keep = kept(rng, (many, sum(_WIDE)))
    high = np.concatenate(peaks, axis=1)
    outer = np.concatenate([np.maximum(high, 0.0) * keep, one.context], axis=1)
    inner = outer @ weights["inner"] + weights["inner_from"]
    keep_inner = kept(rng, inner.shape)
    bright = np.maximum(inner, 0.0) * keep_inner
    scores = bright @ weights["label"] + weights["label_from"] + one.context @ weights["context"]
    slope = (softmax(scores) - wanted) / np.float32(many)
    found = {"label": bright.T @ slope, "label_from": slope.sum(axis=0)}
    found["context"] = one.context.T @ slope
    back = slope @ weights["label"].T * keep_inner * (inner > 0)
    found["inner"], found["inner_from"] = outer.T @ back, back.sum(axis=0)
    below = (back @ weights["inner"].T)[:, : sum(_WIDE)] * keep * (high > 0)
    into = np.zeros_like(given)
    at = 0
    for width, top, cols in zip(ACT_WINDOWS, tops, seen, strict=True):
        count = top.shape[1]
        part, at = below[:, at : at + count], at + count
        spread = np.zeros((*cols.shape[:2], count), np.float32)
        np.put_along_axis(spread, top[:, None], part[:, None], 1)
        flat = spread.reshape(-1, count)
        found[f"see{width}"] = cols.reshape(len(flat), -1).T @ flat
        found[f"see{width}_from"] = part.sum(axis=0)
        into += unwindowed(spread @ weights[f"see{width}"].T, width, min(width - 1, 1), size)
    own = slice(known.shape[1], known.shape[1] + OWN_WIDE)
    return {**found, "own": own_slope(one, into[..., own] * heard)}


def fitted_net(
    told_of: Sequence[Told],
    wanted: Scores,
    counts: NDArray[np.float64],
    context: tuple[str, ...],
    epochs: int,
    seed: int = 1,
) -> Net:
    """Return a net of acts fitted on clauses with their shares of labels."""
    rng, known = np.random.default_rng(seed), vectors("english")
    start = act_weights(rng, known.shape[1], len(context), wanted.shape[1])

    def slopes(part: Rows, weights: Slopes, rng: np.random.Generator) -> Slopes:
        return act_slopes(batch([told_of[n] for n in part]), wanted[part], weights, known, rng)

    sizes = np.array([len(one.own) for one in told_of])
    return Net(descended(start, sizes, counts, slopes, epochs, rng), context)
