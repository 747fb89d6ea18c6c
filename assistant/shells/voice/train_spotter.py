"""Train the stop spotter's classifier on synthesized voices and noise.

Run ``python -m assistant.shells.voice.train_spotter`` where espeak-ng and flite are installed
(and, for livelier voices, Piper with the model named by ``--piper``). Voices for the figures are
never trained on; Piper's are trained on for the weights that are kept, but the figures told for
them come from weights trained without any of Piper's.
"""

from __future__ import annotations

import argparse
import sys
import tempfile
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from math import sqrt
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from assistant.shells.voice.mouth import Mouth, Voice
from assistant.shells.voice.sound import RATE_HZ, Samples, read_sound, to_16k_mono
from assistant.shells.voice.spotter import HOP, WEIGHTS, Embedder, Features, stacked

COPIES = 4
STOPS = ("stop", "stop it", "stop now", "please stop", "no stop", "stop stop")
OTHERS = (
    "step", "first step", "next step", "start", "top", "shop", "stock", "star", "stuff", "spot",
    "move more left", "a bit more right", "slower", "faster", "open the hand", "close the hand",
    "yes", "no", "then", "and then", "pick up the block", "place it on the target", "stack them",
    "go back to the demonstration", "what did you say", "turn clockwise ten degrees", "up", "down",
    "it's called pick and place", "there are two subtasks", "the red block and a target", "good",
    "again", "pause", "go on", "help", "undo that", "two centimetres up", "that is right", "steep",
    "the weather is nice today", "did you see the game last night", "I need to buy some apples",
    "a story about a stone", "he studies at the station", "studio", "strap", "swap them", "drop it",
    "story", "stone", "stack", "still", "study", "store", "stand up", "the top", "a shop", "hop",
    "not", "lot", "that spot", "hot soup", "chop it", "cop", "pop", "it starts now", "step up",
)  # fmt: skip
_TRAINED_VARIANTS = (
    "", "f1", "f2", "f4", "m1", "m3", "m5", "m7", "Andrea", "Andy", "Annie", "Denis", "Gene", "Lee",
    "Linda", "Michael", "Mike", "Paul", "Pedro", "Rob", "Steph", "adam", "benjamin", "edward",
    "grandpa", "klatt2", "victor",
)  # fmt: skip
_HELD_OUT_VARIANTS = ("f3", "f5", "m2", "m4", "m6", "David", "Alicia", "belinda", "Max", "anika")
_ACCENTS = ("en-us", "en-gb", "en-gb-scotland", "en-gb-x-rp", "en-029")


_PITCHES = (0.85, 0.92, 1.06, 1.14, 1.22)
_SLOWNESSES = (0.85, 1.0, 1.2)
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

    def and_those(self, other: Examples) -> Examples:
        """Return these examples and others."""
        return Examples(
            np.concatenate([self.features, other.features]),
            np.concatenate([self.labels, other.labels]),
            np.concatenate([self.clips, other.clips + self.clips.max() + 1]),
            np.concatenate([self.late_s, other.late_s]),
        )


def voices(held_out: bool) -> tuple[Voice, ...]:
    """Return speakers of espeak-ng and flite to train on, or those kept for the figures."""
    variants = _HELD_OUT_VARIANTS if held_out else _TRAINED_VARIANTS
    told = [
        Voice(
            "espeak-ng",
            f"{_ACCENTS[at % len(_ACCENTS)]}+{variant}".rstrip("+"),
            140 + 15 * (at % 4),
        )
        for at, variant in enumerate(variants)
    ]
    flite = ("rms",) if held_out else ("slt", "awb", "kal")
    told += [Voice("flite", name, rate) for name in flite for rate in (135, 165, 195)]
    return tuple(told)


def spoken(voice: Voice, sentences: Sequence[str]) -> Iterator[Samples]:
    """Yield each sentence as this voice speaks it."""
    mouth = Mouth(voice)
    with tempfile.TemporaryDirectory() as folder:
        for sentence in sentences:
            mouth.write(sentence, Path(folder) / "spoken.wav")
            yield _bare(read_sound(Path(folder) / "spoken.wav").samples)


def spoken_by_piper(model: Any, pitch: float, slowness: float, said: str) -> Samples:
    """Return a sentence by Piper; read at another rate, its voice is higher or lower."""
    from piper import SynthesisConfig

    config = SynthesisConfig(length_scale=slowness * pitch, noise_scale=0.8, noise_w_scale=0.9)
    pieces = list(model.synthesize(said, config))
    told = np.concatenate([piece.audio_float_array for piece in pieces])
    rate_hz = round(pieces[0].sample_rate * pitch / 50) * 50
    return _bare(to_16k_mono(told, rate_hz))


def _bare(samples: Samples) -> Samples:
    """Return a sentence without the silence at its ends."""
    loud = np.flatnonzero(np.abs(samples) > 0.02 * np.max(np.abs(samples)))
    return samples[loud[0] : loud[-1] + 1]


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
            found, late_s = _one(samples, embed, rng)
            rows.append(found)
            labels.append(_labels(late_s, is_stop))
            clips.append(np.full(len(late_s), len(clips)))
            lates.append(late_s)
    told = (np.concatenate(labels), np.concatenate(clips), np.concatenate(lates))
    return Examples(np.concatenate(rows), *told)


def by_engines(held_out: bool) -> Iterator[tuple[bool, Samples]]:
    """Yield every sentence by every speaker of espeak-ng and flite."""
    for voice in voices(held_out):
        sys.stderr.write(f"{voice.engine} {voice.name} {voice.words_per_minute}\n")
        for at, samples in enumerate(spoken(voice, (*STOPS, *OTHERS))):
            yield at < len(STOPS), samples


def by_piper(path: Path, changed: bool) -> Iterator[tuple[bool, Samples]]:
    """Yield every sentence by Piper, as it is or as several changed speakers."""
    from piper import PiperVoice

    model = PiperVoice.load(path)
    ways = [(1.0, slow) for slow in _SLOWNESSES]
    if changed:
        ways = [(pitch, _SLOWNESSES[at % 3]) for at, pitch in enumerate(_PITCHES)]
    for pitch, slowness in ways:
        sys.stderr.write(f"piper {pitch} {slowness}\n")
        for at, said in enumerate((*STOPS, *OTHERS)):
            yield at < len(STOPS), spoken_by_piper(model, pitch, slowness, said)


def _one(
    samples: Samples, embed: Embedder, rng: np.random.Generator
) -> tuple[Features, NDArray[np.float64]]:
    before = int(rng.uniform(1.0, 1.5) * RATE_HZ)
    after = int(0.5 * RATE_HZ)
    placed = np.concatenate([np.zeros(before), samples, np.zeros(after)])
    placed *= rng.uniform(0.05, 0.9) / np.max(np.abs(placed))
    loud = np.std(placed[before : before + len(samples)])
    noisy = placed + _noise(len(placed), rng) * loud * 10 ** rng.uniform(-2.0, -0.4)
    rows = stacked(embed(noisy.astype(np.float32)))
    # The last row ends with the sound; each one before ends 80 ms earlier.
    ends = (len(placed) - HOP * np.arange(len(rows))[::-1]) / RATE_HZ
    return rows, ends - (before + len(samples)) / RATE_HZ


def _labels(late_s: NDArray[np.float64], is_stop: bool) -> NDArray[np.float32]:
    if not is_stop:
        return np.zeros(len(late_s), dtype=np.float32)
    sure = (late_s > -0.05) & (late_s < 0.32)
    unsure = (late_s > -0.4) & (late_s < 0.5) & ~sure
    return np.where(sure, 1.0, np.where(unsure, -1.0, 0.0)).astype(np.float32)


def _noise(count: int, rng: np.random.Generator) -> NDArray[np.float64]:
    white = rng.standard_normal(count)
    if rng.random() < 0.5:
        spectrum = np.fft.rfft(white)
        spectrum /= np.sqrt(np.arange(1, len(spectrum) + 1))
        white = np.fft.irfft(spectrum, count)
    return np.asarray(white / np.std(white))


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
    parser.add_argument("--threshold", type=float, default=0.8)
    parser.add_argument("--piper", type=Path, metavar="MODEL", help="a Piper model file")
    args = parser.parse_args()
    rng = np.random.default_rng(args.seed)
    embed = Embedder()
    told = examples(by_engines(held_out=False), embed, rng)
    kept_apart = examples(by_engines(held_out=True), embed, rng)
    if args.piper is not None:
        unseen = examples(by_piper(args.piper, changed=False), embed, rng)
        without = train(told, rng)
        sys.stderr.write(f"Piper, never trained on:\n{report(unseen, without)}\n")
        told = told.and_those(examples(by_piper(args.piper, changed=True), embed, rng))
    weights = train(told, rng)
    sys.stderr.write(f"espeak-ng and flite kept apart:\n{report(kept_apart, weights)}\n")
    np.savez(args.out, threshold=np.float32(args.threshold), **weights)
    return 0


if __name__ == "__main__":
    raise SystemExit(main())
