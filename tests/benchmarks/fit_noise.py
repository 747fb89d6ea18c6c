"""Where the weights for loud rooms come from: what makes the right meaning likeliest.

Sentences of the corpus, words alone and chat are said by voices of which none is reported, in
noises of which none is reported, at 8 to 20 dB; how teachers word things is counted without these
sentences. The weights are those under which the right meanings are likeliest among all that may
have been said, none of it included, held small by a ridge. How they do is told for sentences they
were not fitted on, by the least share that is acted on.

run: python -m tests.benchmarks.fit_noise [--count N] [--kept DIR]
"""

from __future__ import annotations

import argparse
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, fields
from itertools import islice
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray
from scipy.optimize import minimize

from assistant.language.answers import OPEN
from assistant.model.listening import Listening
from assistant.model.teacher_acts import act_to_json
from assistant.shells.voice import wording
from assistant.shells.voice.choosing import Chooser, Said
from assistant.shells.voice.deciding import Heard, Reading, nothing_heard
from assistant.shells.voice.hearing import Hearing
from assistant.shells.voice.in_noise import Evident, InNoise, Weights
from assistant.shells.voice.recognizers import installed
from assistant.shells.voice.sound import Samples
from tests.benchmarks.bench_language import same
from tests.benchmarks.bench_voice import KEPT
from tests.benchmarks.fit_wording import TEACHERS, said
from tests.benchmarks.remembered import Remembered
from tests.benchmarks.voice_clips import CHAT, FILES, PRACTICE, WORDS, lines, word_meaning
from tests.benchmarks.voices import Speaker, noise, noisy, placed, spoken

SENTENCES = ("tuning", "tuning4", "tuning2", "talk3")
SPEAKERS = (
    Speaker("alpha", "kokoro", "jf_alpha"),
    Speaker("joe low", "piper", pitch=0.93, slowness=0.95),
    Speaker("tebukuro", "kokoro", "jf_tebukuro"),
    Speaker("joe high", "piper", pitch=1.12, slowness=1.1, liveliness=0.8),
    Speaker("tebukuro quick", "kokoro", "jf_tebukuro", slowness=0.85),
    Speaker("alpha slow", "kokoro", "jf_alpha", slowness=1.1),
)
ROOMS = ("white", "babble", "music", "babble", "fan")
LOUD_DB = (8.0, 10.0, 10.0, 12.0, 15.0, 20.0)
EACH_WORD = 6
RIDGE = 1.0
PARTS = 8
SHARES = (0.5, 0.55, 0.6, 0.65, 0.7)
Vector = NDArray[np.float64]


@dataclass(frozen=True, slots=True, eq=False)
class Case:
    """All that may have been said in a clip.

    Parameters
    ----------
    text : str
        What was.
    features : array, shape (n, k)
    right : array of bool, shape (n,)
        Whether words mean what was said; the last stands for none of the others.
    kinds : tuple
        What each means; None for nothing.
    """

    text: str
    features: Vector
    right: NDArray[np.bool_]
    kinds: tuple[object, ...]


class Noting(InNoise):
    """Notes what there was to choose from."""

    noted: Evident | None = None

    def choose(self, said: Said) -> Heard:
        """Note it and choose nothing."""
        self.noted = self.evident(said)
        return nothing_heard("")


def clips(count: int, folder: Path) -> Iterator[tuple[str, Listening, list[Any], Samples]]:
    """Yield what is said, where in the dialogue, what it means, and its sound."""
    FILES["fitted"] = SENTENCES
    alone = ((word, *word_meaning(word)[:2]) for word in WORDS for _ in range(EACH_WORD))
    chat: Iterator[tuple[str, Listening, list[Any]]] = ((text, PRACTICE, []) for text in CHAT)
    told = (*lines("fitted", count), *islice(alone, count), *islice(chat, count // 4))
    for at, (text, listening, acts) in enumerate(told):
        speaker = SPEAKERS[(at + at // len(SPEAKERS)) % len(SPEAKERS)]
        rng = np.random.default_rng(5000 + at)
        clip = placed(spoken(speaker, text, folder), rng)
        kind = ROOMS[int(rng.integers(len(ROOMS)))]
        sound = noisy(clip, noise(kind, len(clip), rng, folder), float(rng.choice(LOUD_DB)))
        if listening.asked not in OPEN:
            yield text, listening, acts, sound


def cases(count: int, folder: Path) -> Iterator[Case]:
    """Yield what there is to choose from in each clip."""
    quick, slow = (Remembered(one, folder) for one in installed())
    chooser = Chooser(slow)
    chooser.wording = wording.counted(said(name for name in TEACHERS if name not in SENTENCES))
    noting = Noting(chooser, quick)
    hearing = Hearing((quick, slow), in_noise=noting)
    for text, listening, acts, sound in clips(count, folder / "spoken"):
        noting.noted = None
        hearing.hear(sound, listening)
        if noting.noted is not None:
            yield case(text, acts, noting.noted)


def case(text: str, acts: list[Any], told: Evident) -> Case:
    """Return what there is to choose from in one utterance."""
    right = [
        same(acts, [act_to_json(act) for act in one.meant.acts]) if acts else one.silent
        for one in told.candidates
    ]
    # Where nothing that was thought of is right, something else was said; and so it was in chat.
    right.append(not (acts and any(right)))
    kinds = (
        None if one.silent else Reading(one.text, 1.0, one.meant, "").kind
        for one in told.candidates
    )
    return Case(text, np.array(told.features()), np.array(right), (*kinds, None))


def shares(one: Case, weights: Vector) -> Vector:
    """Return each candidate's share."""
    odds = one.features @ weights
    parts = np.exp(odds - odds.max())
    return np.asarray(parts / parts.sum())


def fitted(told: Sequence[Case]) -> Vector:
    """Return the weights under which the right meanings are likeliest."""
    scale = np.maximum(np.std(np.concatenate([one.features for one in told]), axis=0), 0.1)

    def loss(scaled: Vector) -> tuple[float, Vector]:
        total, slope = RIDGE * float(scaled @ scaled), 2.0 * RIDGE * scaled
        for one in told:
            share = shares(one, scaled / scale)
            right = share * one.right
            sure = max(float(right.sum()), 1e-12)
            total -= np.log(sure)
            slope += (share - right / sure) @ one.features / scale
        return total, slope

    found = minimize(loss, np.zeros(len(scale)), jac=True, method="L-BFGS-B")
    return np.asarray(found.x / scale, dtype=np.float64)


def settled(one: Case, weights: Vector) -> tuple[bool, float, bool]:
    """Return whether the likeliest meaning is one, its share, and whether it is right."""
    votes: dict[object, float] = {}
    share = shares(one, weights)
    for kind, part in zip(one.kinds, share, strict=True):
        votes[kind] = votes.get(kind, 0.0) + float(part)
    best = max(votes, key=lambda kind: votes[kind])
    backers = [at for at, kind in enumerate(one.kinds) if kind == best]
    right = bool(one.right[max(backers, key=lambda at: float(share[at]))])
    return best is not None, votes[best], right


def crossed(told: Sequence[Case]) -> Iterator[tuple[bool, float, bool]]:
    """Yield what each case comes to by weights fitted without its sentence."""
    texts = sorted({one.text for one in told})
    np.random.default_rng(0).shuffle(texts)
    for part in range(min(PARTS, len(texts))):
        left = set(texts[part::PARTS])
        weights = fitted([one for one in told if one.text not in left])
        yield from (settled(one, weights) for one in told if one.text in left)


def main() -> None:
    """Fit, tell how the weights do on other sentences, and print them."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--count", type=int, default=450, help="sentences")
    parser.add_argument("--kept", type=Path, default=KEPT, help="where sound and readings stay")
    args = parser.parse_args()
    told = list(cases(args.count, args.kept))
    found = list(crossed(told))
    for least in SHARES:
        sure = [right for means, share, right in found if means and share >= least]
        print(f"from {least}: acted on rightly {sum(sure)}, wrongly {len(sure) - sum(sure)}")
    print(f"of {len(told)}")
    for field, weight in zip(fields(Weights), fitted(told), strict=True):
        print(f"    {field.name}={weight:.2f},")


if __name__ == "__main__":
    main()
