"""How likely each act is from the words alone: a linear model over words, pairs and letters.

It knows nothing of slots and acts on nothing by itself. It seconds or doubts what the grammar
read, and says which act to look for where the grammar read none. The weights are fitted by
`tests/benchmarks/fit_language.py` and shipped as ``likelihood.npz`` of a language.
"""

from __future__ import annotations

import itertools
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import cache, lru_cache
from pathlib import Path
from typing import Any
from zlib import crc32

import numpy as np
from numpy.typing import NDArray

from assistant.language.families import families
from assistant.language.frames import classes_of
from assistant.language.nets import Net, act_odds, unpacked
from assistant.language.phrasebook import LANGUAGES, Phrase
from assistant.model.listening import Listening

BUCKETS = 1 << 14
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
    net : Net or None
        Seconds the linear model: labels are as likely as both say together.
    """

    labels: tuple[str, ...]
    weights: NDArray[np.float32]
    net: Net | None = None


@cache
def model(language: str) -> Model | None:
    """Return the model of a language, read once; None if it has none."""
    path = Path(__file__).parent / LANGUAGES[language.lower()] / "likelihood.npz"
    if not path.exists():
        return None
    with np.load(path) as file:
        weights = file["weights"].astype(np.float32) * float(file["scale"])
        return Model(tuple(str(one) for one in file["labels"]), weights, unpacked(file, "net"))


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
    scores = scales(told) @ np.take(known.weights, [row_of(one) for one in told], axis=0)
    odds = np.exp(scores - scores.max())
    if known.net is not None:
        second = act_odds(respelled, listening.asked, listening.stage, known.net, language)
        odds = np.sqrt(odds / odds.sum() * second)
    return dict(zip(known.labels, (odds / odds.sum()).tolist(), strict=True))


@lru_cache(maxsize=1 << 15)
def row_of(feature: str) -> int:
    """Return the row of the weights that a feature counts by."""
    return crc32(feature.encode()) % BUCKETS


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
    alike = _alike(respelled, language)
    context = [f"?{asked}", f"!{listening.stage}", f"?!{asked} {listening.stage}"]
    place = [f"{asked}: {word}" for word in respelled] if listening.asked else []
    return [*context, *words, *pairs, *threes, *classes, *place, *letters, *alike]


def _alike(words: Phrase, language: str) -> list[str]:
    """Return the families the words belong to, alone and in pairs."""
    told = [families(word, language) for word in words]
    small = ("<", *(f"f{one}" for one, _ in told), ">")
    large = ("<", *(f"g{one}" for _, one in told), ">")
    pairs = (*itertools.pairwise(small), *itertools.pairwise(large))
    return [f"~{one}" for one in (*small, *large, *(f"{a} {b}" for a, b in pairs))]


def scales(told: Sequence[str]) -> NDArray[np.float32]:
    """Return what each feature counts: a long sentence is no surer than a short one."""
    groups = [_GROUPS.get(one[:1], 0) for one in told]
    counts = np.bincount(groups, minlength=len(_MOST))
    counts[_GROUPS["?"]] = 1
    return np.take((_MOST / np.sqrt(np.maximum(1, counts))).astype(np.float32), groups)


_GROUPS = {"#": 1, "~": 2, "?": 3, "!": 3}
_MOST = np.array([3.0, 1.5, 2.0, 1.0])
"""How much features of a group count together: words, letters, families; what is asked in full."""


def label(act: str, slots: Mapping[str, Any]) -> str:
    """Return the label of an act: with the slot that takes one of few values."""
    for name in ("what", "stage", "command", "change"):
        if name in slots and act not in ("set_pose",):
            return f"{act} {slots[name]}"
    if act in ("adjust_speed", "adjust_last"):
        return f"{act} factor"
    if act in ("translate", "rotate"):
        return f"{act} {slots['direction']}"
    if act == "inform":
        value = slots.get("value")
        return "inform count" if isinstance(value, int | float) else "inform"
    if act == "cue":
        which = slots.get("which")
        return f"cue {which if isinstance(which, str) else 'number'}"
    if act == "move_cut":
        return f"move_cut {slots.get('direction', 'at')}"
    return act
