"""Where the weights of what speaks for words come from: what makes the right meaning likeliest.

Sentences are those of the tuned group, with words alone and chat, in loud rooms of four kinds,
said by voices of which none is reported; how teachers word things is counted without these
sentences. The weights are those under which the right meanings are likeliest among all that may
have been said, held to those shipped by a ridge; how they do is told for sentences and for voices
they were not fitted on. Names, lists and a word or two are left out: there the sound decides.

run: python -m tests.benchmarks.fit_weighing [--count N] [--kept DIR]
"""

from __future__ import annotations

import argparse
from collections.abc import Iterator, Sequence
from dataclasses import asdict, astuple, dataclass
from itertools import islice
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray
from scipy.optimize import minimize

from assistant.model.listening import Listening, Understanding
from assistant.model.teacher_acts import act_to_json
from assistant.shells.voice import wording
from assistant.shells.voice.choosing import Chooser
from assistant.shells.voice.deciding import ASKABLE, Heard, Reading, is_unknown, nothing_heard
from assistant.shells.voice.hearing import Hearing
from assistant.shells.voice.recognizers import installed
from assistant.shells.voice.said import Said
from assistant.shells.voice.sound import Samples
from assistant.shells.voice.weighing import COMMANDS, Weights, nothing_of_these
from tests.benchmarks.bench_language import same
from tests.benchmarks.bench_voice import KEPT
from tests.benchmarks.fit_wording import REPORTED, TEACHERS, said
from tests.benchmarks.remembered import Remembered
from tests.benchmarks.voice_clips import CHAT, FILES, PRACTICE, WORDS, lines, word_meaning
from tests.benchmarks.voices import Speaker, noise, noisy, placed, spoken

SPEAKERS = (
    Speaker("joe deep", "piper", pitch=0.9, liveliness=0.8),
    Speaker("alpha", "kokoro", "jf_alpha", slowness=0.9),
    Speaker("slt", "flite", "slt"),
    Speaker("joe bright", "piper", pitch=1.07, slowness=0.95, liveliness=0.5),
    Speaker("tebukuro", "kokoro", "jf_tebukuro"),
    Speaker("joe slow", "piper", slowness=1.2, liveliness=0.9),
    Speaker("f2", "espeak-ng", "en-us+f2"),
    Speaker("alpha slow", "kokoro", "jf_alpha", slowness=1.1),
)
ROOMS = ("white", "babble", "music", "fan")
LOUD_DB = (10, 10, 15)
RIDGE = 2.0
PARTS = 8
SURE_SHARES = (0.6, 0.7, 0.8)
Vector = NDArray[np.float64]
Line = tuple[str, Listening, list[dict[str, Any]]]


@dataclass(frozen=True, slots=True, eq=False)
class Case:
    """All that may have been said in a clip.

    Parameters
    ----------
    text, speaker : str
    features : array, shape (n, 14)
    right : array of bool, shape (n,)
        Whether words mean what was said; the last stands for none of the others.
    kinds : tuple
        What each means; None for nothing.
    """

    text: str
    speaker: str
    features: Vector
    right: NDArray[np.bool_]
    kinds: tuple[object, ...]


@dataclass(frozen=True, slots=True)
class Settled:
    """Whether the likeliest meaning is one, its share, and whether it is right."""

    means: bool
    share: float
    right: bool


class Noting(Chooser):
    """Notes what there was to choose from."""

    noted: Said | None = None

    def choose(self, said: Said) -> Heard:
        """Note it and choose nothing."""
        self.forget()
        self.noted = said
        return nothing_heard("")


def clips(count: int, folder: Path) -> Iterator[tuple[str, Speaker, Listening, Any, Samples]]:
    """Yield what is said, by whom, where in the dialogue, what it means, and its sound."""
    alone = ((word, *word_meaning(word)[:2]) for word in WORDS)
    chat: Iterator[Line] = ((text, PRACTICE, []) for text in CHAT)
    told = (*lines("tuned", count), *alone, *islice(chat, count // 8))
    for at, (text, listening, acts) in enumerate(told):
        speaker, rng = SPEAKERS[at % len(SPEAKERS)], np.random.default_rng(1000 + at)
        clip = placed(spoken(speaker, text, folder), rng)
        kind = ROOMS[(at // len(SPEAKERS) + at) % len(ROOMS)]
        sound = noisy(clip, noise(kind, len(clip), rng, folder), LOUD_DB[at % len(LOUD_DB)])
        yield text, speaker, listening, acts, sound


def cases(count: int, folder: Path) -> Iterator[Case]:
    """Yield what there is to choose from in each clip that is not settled before."""
    recognizers = [Remembered(one, folder) for one in installed()]
    chooser = Noting(recognizers[-1])
    withheld = {*REPORTED, *FILES["tuned"]}
    chooser.wording = wording.counted(said(name for name in TEACHERS if name not in withheld))
    hearing = Hearing(recognizers, chooser=chooser)
    for text, speaker, listening, acts, sound in clips(count, folder / "spoken"):
        chooser.noted = None
        hearing.hear(sound, listening)
        if chooser.noted is not None and chooser.noted.commanded:
            yield case(chooser, chooser.noted, text, speaker.name, acts)


def case(chooser: Chooser, noted: Said, text: str, speaker: str, acts: list[Any]) -> Case:
    """Return what there is to choose from in one utterance."""
    told = chooser.everything(noted)
    meant = [chooser.meaning(one, noted.listening) for one in told]
    nothing = [
        is_unknown(one) or (one.confidence < ASKABLE and not evidence.expected)
        for one, evidence in zip(meant, told.values(), strict=True)
    ]
    right = [
        same(acts, [act_to_json(act) for act in one.acts]) if acts else silent
        for one, silent in zip(meant, nothing, strict=True)
    ]
    kinds = [None if silent else _kind(one) for one, silent in zip(meant, nothing, strict=True)]
    features = [one.features(noted.speech_s) for one in told.values()]
    features.append(nothing_of_these(noted.doubt))
    # Where nothing that was thought of is right, something else was said.
    right.append(not any(right))
    return Case(text, speaker, np.array(features), np.array(right), (*kinds, None))


def _kind(meant: Understanding) -> object:
    return Reading("", 1.0, meant, "").kind


def shares(one: Case, weights: Vector) -> Vector:
    """Return each candidate's share."""
    odds = one.features @ weights
    parts = np.exp(odds - odds.max())
    return np.asarray(parts / parts.sum())


def fitted(told: Sequence[Case]) -> Vector:
    """Return the weights under which the right meanings are likeliest."""
    held = np.array(astuple(COMMANDS))
    scale = np.maximum(np.abs(held), 0.2)

    def loss(weights: Vector) -> tuple[float, Vector]:
        off = (weights - held) / scale
        total, slope = RIDGE * float(off @ off), 2.0 * RIDGE * off / scale
        for one in told:
            share = shares(one, weights)
            right = share * one.right
            if (sure := float(right.sum())) > 0.0:
                total -= np.log(sure)
                slope += (share - right / sure) @ one.features
        return total, slope

    found = minimize(loss, held, jac=True, method="L-BFGS-B")
    return np.asarray(found.x, dtype=np.float64)


def settled(one: Case, weights: Vector) -> Settled:
    """Return what a case comes to."""
    votes: dict[object, float] = {}
    share = shares(one, weights)
    for kind, part in zip(one.kinds, share, strict=True):
        votes[kind] = votes.get(kind, 0.0) + float(part)
    best = max(votes, key=lambda kind: votes[kind])
    backers = [at for at, kind in enumerate(one.kinds) if kind == best]
    right = bool(one.right[max(backers, key=lambda at: float(share[at]))])
    return Settled(best is not None, votes[best], right)


def crossed(told: Sequence[Case], groups: Sequence[str]) -> Iterator[Settled]:
    """Yield what each case comes to by weights fitted without its group."""
    names = sorted(set(groups))
    np.random.default_rng(0).shuffle(names)
    for part in range(min(PARTS, len(names))):
        left = set(names[part::PARTS])
        weights = fitted([one for one, name in zip(told, groups, strict=True) if name not in left])
        for one, name in zip(told, groups, strict=True):
            if name in left:
                yield settled(one, weights)


def row(title: str, found: Sequence[Settled]) -> str:
    """Return how many are right, and acted on rightly and wrongly, by how sure one must be."""
    right = sum(one.right for one in found)
    acted = "; ".join(_acted(found, least) for least in SURE_SHARES)
    return f"{title:<18}{right}/{len(found)} right; acted on rightly, wrongly: {acted}"


def _acted(found: Sequence[Settled], least: float) -> str:
    sure = [one for one in found if one.means and one.share >= least]
    right = sum(one.right for one in sure)
    return f"from {least} {right}, {len(sure) - right}"


def main() -> None:
    """Fit, tell how the weights do elsewhere, and print them."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--count", type=int, default=120, help="sentences")
    parser.add_argument("--kept", type=Path, default=KEPT, help="where sound and readings stay")
    args = parser.parse_args()
    told = list(cases(args.count, args.kept))
    shipped = np.array(astuple(COMMANDS))
    print(row("shipped", [settled(one, shipped) for one in told]))
    print(row("other sentences", list(crossed(told, [one.text for one in told]))))
    print(row("other voices", list(crossed(told, [one.speaker for one in told]))))
    weights = Weights(*(round(float(one), 2) for one in fitted(told)))
    print(", ".join(f"{name} {weight}" for name, weight in asdict(weights).items()))


if __name__ == "__main__":
    main()
