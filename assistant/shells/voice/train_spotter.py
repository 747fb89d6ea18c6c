"""Train the stop spotter's classifier on synthesized voices, on people and on noise.

Run ``python -m assistant.shells.voice.train_spotter`` where espeak-ng and flite are installed;
``--piper``, ``--kokoro`` and ``--people`` bring livelier voices and people who do not say stop.
The weights shipped were made with Piper's en_US-joe-medium, 14 mixed Kokoro voices, and as
people half of the recordings (those whose name's SHA-256 is even) of Picovoice's
speech-to-intent benchmark (Apache-2.0) and the words other than stop of eleven speakers of
Speech Commands (CC BY 4.0), and clips of Common Voice (CC0); `NOTICE.md` beside the weights
names those they are owed to. Speakers of the benchmarks are never trained on.
"""

from __future__ import annotations

import argparse
import sys
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from math import sqrt
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from assistant.shells.voice.sound import RATE_HZ, Samples
from assistant.shells.voice.spotter import HOP, WEIGHTS, Embedder, Features, stacked
from assistant.shells.voice.training_sounds import (
    by_engines,
    by_kokoro,
    by_people,
    by_piper,
    placed,
)

COPIES = 5
PIPER_SPEAKERS = 10
THRESHOLDS = (0.5, 0.7, 0.8, 0.9, 0.95)


@dataclass(frozen=True, slots=True, eq=False)
class Examples:
    """Stacked embeddings, what each is an example of (1 for stop), and the clip it is from.

    Parameters
    ----------
    features : array, shape (n, 288)
    labels : array, shape (n,)
        1 where stop has just been said, 0 where it was not said; -1 in between.
    clips : array of int, shape (n,)
    late_s : array, shape (n,)
        Since the end of the clip's speech.
    """

    features: Features
    labels: NDArray[np.float32]
    clips: NDArray[np.int64]
    late_s: NDArray[np.float64]


def examples(
    sentences: Iterator[tuple[bool, Samples]], embed: Embedder, rng: np.random.Generator
) -> Examples:
    """Return embeddings around the ends of sentences, in rooms of several noises.

    Parameters
    ----------
    sentences : iterator of (bool, array)
        Whether it says stop, and its sound.
    embed : Embedder
    rng : Generator
    """
    rows: list[Features] = []
    labels: list[NDArray[np.float32]] = []
    clips: list[NDArray[np.int64]] = []
    lates: list[NDArray[np.float64]] = []
    for is_stop, samples in sentences:
        for _ in range(COPIES if is_stop else 1):
            noisy, ends_s = placed(samples, rng)
            found = stacked(embed(noisy))
            # The last row ends with the sound; each one before ends 80 ms earlier.
            steps = HOP * np.arange(len(found))[::-1]
            late_s = (len(noisy) - steps) / RATE_HZ - ends_s
            rows.append(found)
            labels.append(_labels(late_s, is_stop))
            clips.append(np.full(len(late_s), len(clips)))
            lates.append(late_s)
    told = (np.concatenate(labels), np.concatenate(clips), np.concatenate(lates))
    return Examples(np.concatenate(rows), *told)


def _labels(late_s: NDArray[np.float64], is_stop: bool) -> NDArray[np.float32]:
    if not is_stop:
        return np.zeros(len(late_s), dtype=np.float32)
    sure = (late_s > -0.05) & (late_s < 0.32)
    unsure = (late_s > -0.4) & (late_s < 0.5) & ~sure
    return np.where(sure, 1.0, np.where(unsure, -1.0, 0.0)).astype(np.float32)


def train(told: Examples, rng: np.random.Generator, steps: int = 4000) -> dict[str, Any]:
    """Return weights of one hidden layer fitted by Adam on balanced batches."""
    mean, scale = told.features.mean(axis=0), told.features.std(axis=0) + 1e-6
    rows = (told.features - mean) / scale
    sides = [np.flatnonzero(told.labels == label) for label in (0.0, 1.0)]
    size = rows.shape[1]
    weights = [rng.standard_normal((size, 32)) / np.sqrt(size), np.zeros(32),
               rng.standard_normal(32) / np.sqrt(32), np.zeros(())]  # fmt: skip
    first = [np.zeros_like(w) for w in weights]
    second = [np.zeros_like(w) for w in weights]
    for step in range(1, steps + 1):
        picked = np.concatenate([rng.choice(sides[0], 192), rng.choice(sides[1], 64)])
        noisy = rows[picked] + 0.1 * rng.standard_normal((256, size))
        slopes = _slopes(weights, noisy, told.labels[picked])
        for at, slope in enumerate(slopes):
            first[at] = 0.9 * first[at] + 0.1 * slope
            second[at] = 0.999 * second[at] + 0.001 * slope**2
            rate = 1e-3 * np.sqrt(1 - 0.999**step) / (1 - 0.9**step)
            weights[at] = weights[at] - rate * first[at] / (np.sqrt(second[at]) + 1e-8)
    named = zip(("w1", "b1", "w2", "b2"), weights, strict=True)
    return {"mean": mean, "scale": scale, **{k: w.astype(np.float32) for k, w in named}}


def _slopes(
    weights: Sequence[NDArray[np.float64]], rows: NDArray[np.float64], labels: NDArray[np.float32]
) -> list[NDArray[np.float64]]:
    w1, b1, w2, b2 = weights
    hidden = np.maximum(rows @ w1 + b1, 0.0)
    error = (1.0 / (1.0 + np.exp(-(hidden @ w2 + b2))) - labels) / len(labels)
    back = np.outer(error, w2) * (hidden > 0)
    decay = 1e-4
    return [
        rows.T @ back + decay * w1,
        back.sum(axis=0),
        hidden.T @ error + decay * w2,
        error.sum(),
    ]


def report(told: Examples, weights: dict[str, Any]) -> str:
    """Return misses and false alarms by clip, with their intervals, and how late stops are."""
    hidden = np.maximum((told.features - weights["mean"]) / weights["scale"] @ weights["w1"]
                        + weights["b1"], 0.0)  # fmt: skip
    scores = 1.0 / (1.0 + np.exp(-(hidden @ weights["w2"] + weights["b2"])))
    said = {int(clip) for clip in told.clips[told.labels != 0.0]}
    return "\n".join(_at(threshold, told, scores, said) for threshold in THRESHOLDS)


def _at(threshold: float, told: Examples, scores: NDArray[Any], said: set[int]) -> str:
    over = scores >= threshold
    every = {int(clip) for clip in told.clips}
    spotted = {int(clip) for clip in told.clips[over]}
    first = {clip: float(told.late_s[over & (told.clips == clip)].min()) for clip in said & spotted}
    late_s = float(np.median(list(first.values()))) if first else float("nan")
    missed = _share(len(said - spotted), len(said))
    false = _share(len(spotted - said), len(every - said))
    return f"at {threshold:.2f}: missed {missed}, false {false}, median {late_s:+.2f} s late"


def _share(count: int, total: int) -> str:
    """Return a share with Wilson's 95 % interval."""
    z, share = 1.96, count / total
    middle = (share + z * z / (2 * total)) / (1 + z * z / total)
    half = z * sqrt(share * (1 - share) / total + z * z / (4 * total**2)) / (1 + z * z / total)
    return f"{count}/{total} ({max(middle - half, 0.0):.3f} to {middle + half:.3f})"


def main() -> int:
    """Train, tell how voices kept apart are heard, write the weights."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--out", type=Path, default=WEIGHTS)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--threshold", type=float, default=0.9)
    parser.add_argument("--steps", type=int, default=4000)
    parser.add_argument("--piper", type=Path, metavar="MODEL", help="a Piper model file")
    parser.add_argument("--kokoro", type=int, default=0, metavar="N", help="so many mixed voices")
    parser.add_argument(
        "--people", type=Path, nargs="*", default=[], metavar="DIR", help="speech without stop"
    )
    args = parser.parse_args()
    rng = np.random.default_rng(args.seed)
    embed = Embedder()
    told = examples(_all_said(args, rng), embed, rng)
    weights = train(told, rng, args.steps)
    np.savez(args.out, threshold=np.float32(args.threshold), **weights)
    kept_apart = examples(by_engines(True, rng), embed, rng)
    sys.stderr.write(f"espeak-ng and flite kept apart:\n{report(kept_apart, weights)}\n")
    return 0


def _all_said(args: argparse.Namespace, rng: np.random.Generator) -> Iterator[tuple[bool, Samples]]:
    yield from by_engines(False, rng)
    if args.piper is not None:
        yield from by_piper(args.piper, PIPER_SPEAKERS, rng)
    yield from by_kokoro(args.kokoro, rng)
    yield from by_people(args.people)


if __name__ == "__main__":
    raise SystemExit(main())
