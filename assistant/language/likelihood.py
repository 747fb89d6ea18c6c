"""How likely each act is from the words alone: a linear model over words, pairs and letters.

It knows nothing of slots and acts on nothing by itself. It seconds or doubts what the grammar
read, and says which act to look for where the grammar read none. The weights are fitted by
`tests/benchmarks/fit_language.py` and shipped as ``likelihood.npz`` of a language.
"""

from __future__ import annotations

import itertools
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import cache
from pathlib import Path
from typing import Any
from zlib import crc32

import numpy as np
from numpy.typing import NDArray

from assistant.language.frames import classes_of
from assistant.language.phrasebook import LANGUAGES, Phrase
from assistant.model.listening import Listening

BUCKETS = 1 << 13
"""Features are kept by a hash of their text."""
_CHARS = 4


@dataclass(frozen=True, slots=True, eq=False)
class Model:
    """A linear model.

    Parameters
    ----------
    labels : tuple of str
        An act with what its closed slot holds: "gripper open", "show tree", "undo".
    weights : array, shape (BUCKETS, labels)
    """

    labels: tuple[str, ...]
    weights: NDArray[np.float32]


@cache
def model(language: str) -> Model | None:
    """Return the model of a language, read once; None if it has none."""
    path = Path(__file__).parent / LANGUAGES[language.lower()] / "likelihood.npz"
    if not path.exists():
        return None
    with np.load(path) as file:
        weights = file["weights"].astype(np.float32) * float(file["scale"])
        return Model(tuple(str(one) for one in file["labels"]), weights)


def likelihoods(
    said: Phrase, respelled: Phrase, listening: Listening, language: str = "english"
) -> Mapping[str, float]:
    """Return the probability of each label, which sum to one; empty without a model.

    Parameters
    ----------
    said, respelled : tuple of str
        The words as heard, and with their spelling repaired.
    """
    known = model(language)
    if known is None:
        return {}
    told = features(said, respelled, listening, language)
    rows = known.weights[[crc32(one.encode()) % BUCKETS for one in told]]
    scores = (rows * scales(told)[:, None]).sum(axis=0)
    odds = np.exp(scores - scores.max())
    return dict(zip(known.labels, (odds / odds.sum()).tolist(), strict=True))


def features(said: Phrase, respelled: Phrase, listening: Listening, language: str) -> list[str]:
    """Return what the model looks at: words, pairs, letters, classes of words, the question."""
    words = ("<", *respelled, ">")
    asked = listening.asked or "none"
    pairs = [f"{a} {b}" for a, b in itertools.pairwise(words)]
    threes = [f"{a} {b} {c}" for a, b, c in zip(words, words[1:], words[2:], strict=False)]
    # Of a word whose spelling was repaired the repaired letters tell, not the slip.
    letter_words = respelled if len(respelled) == len(said) else said
    letters = [
        f"#{padded[at : at + _CHARS]}"
        for padded in (f"<{word}>" for word in letter_words)
        for at in range(max(1, len(padded) - _CHARS + 1))
    ]
    classes = [f"@{name}" for name in classes_of(respelled, language)]
    context = [f"?{asked}", f"!{listening.stage}", f"?!{asked} {listening.stage}"]
    place = [f"{asked}: {word}" for word in respelled] if listening.asked else []
    return [*context, *words, *pairs, *threes, *classes, *place, *letters]


def scales(told: Sequence[str]) -> NDArray[np.float32]:
    """Return what each feature counts: a long sentence is no surer than a short one."""
    context = np.array([one.startswith(("?", "!")) for one in told])
    letters = np.array([one.startswith("#") for one in told])
    count = max(1, int((~context & ~letters).sum()))
    found = np.where(letters, 1.5 / np.sqrt(max(1, letters.sum())), 3.0 / np.sqrt(count))
    return np.where(context, 1.0, found).astype(np.float32)


def label(act: str, slots: Mapping[str, Any]) -> str:
    """Return the label of an act: with the slot that takes one of few values."""
    for name in ("what", "stage", "command", "change"):
        if name in slots and act not in ("set_pose",):
            return f"{act} {slots[name]}"
    if act in ("adjust_speed", "adjust_last"):
        return f"{act} factor"
    if act == "cue":
        which = slots.get("which")
        return f"cue {which if isinstance(which, str) else 'number'}"
    if act == "move_cut":
        return f"move_cut {slots.get('direction', 'at')}"
    return act
