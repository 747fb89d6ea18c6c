"""How sure a reading is: a logistic model of what the reading looks like.

Grammars know how many words they explained, the model of likelihoods whether the words sound
like the act; neither alone tells how often a reading is right. The weights are fitted by
`tests/benchmarks/fit_confidence.py` on speakers and words that were withheld.
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass
from functools import cache
from pathlib import Path
from typing import Any, Literal, cast, get_args

from assistant.language.answers import OPEN
from assistant.language.frames import frames
from assistant.language.parsing import ACTING, GUESSED, Hearing, Parse, texts_of
from assistant.language.phrasebook import LANGUAGES
from assistant.language.seeking import Chances, chance, label_of
from assistant.language.words import Words
from assistant.model.teacher_acts import (
    AdjustSpeed,
    Again,
    Gripper,
    Inform,
    Rotate,
    Translate,
    Unknown,
    act_to_json,
)
from assistant.plain_yaml import read_file

Trait = Literal[
    "always", "score", "chance", "rival", "margin", "agreed", "sentence", "motion", "frame",
    "named", "answer", "sought", "mended", "several", "mixed", "names", "clear_names", "long_names",
    "odd_names", "strange", "words", "repaired", "unknown", "open",
]  # fmt: skip
TRAITS: tuple[Trait, ...] = get_args(Trait)
_NAMES = ("subtask", "name", "old", "new", "first", "second", "subtasks", "before", "after")
# Corrections are often said together, and the practice asked for with them.
_JOINED = (AdjustSpeed, Translate, Rotate, Gripper, Again)
_OBJECTION, _CERTAIN = 0.72, 0.985
_RIVALED = -0.4
"""Where the words are that much likelier to tell another act, no reading is sure."""
_LEAST = 1e-4
_SURE = 0.995


@dataclass(frozen=True, slots=True)
class Reading:
    """A reading with what it was made from.

    Parameters
    ----------
    words, heard : tuple of Word
        As said without fillers, and after repair.
    chances : mapping
        How likely each label is; empty for a language without a model.
    """

    parse: Parse
    words: Words
    heard: Words
    chances: Chances
    hearing: Hearing


def sureness(reading: Reading) -> float:
    """Return how sure a reading is: what the grammar explained, unless the model objects.

    A reading the grammar is sure of is doubted where it is right less often than not; one it
    is not sure of is believed where it is right nearly always.
    """
    parse = reading.parse
    weights = _weights(reading.hearing.language)
    if not weights or not reading.chances or parse.exact or isinstance(parse.acts[0], Inform):
        return parse.score
    if _names_known(reading) or _consenting(reading):
        return parse.score
    told = traits(reading)
    if told["margin"] < _RIVALED:
        return min(parse.score, GUESSED)
    odds = sum(weights[name] * value for name, value in told.items())
    right = 1 / (1 + math.exp(-odds))
    if parse.score >= ACTING and right < _OBJECTION:
        return min(parse.score, GUESSED)
    return max(parse.score, ACTING) if right >= _CERTAIN else parse.score


def _consenting(reading: Reading) -> bool:
    """Whether yes and praise are the only rivals: after a question they say the same."""
    ours = {label_of(act) for act in reading.parse.acts}
    first = max(reading.chances, key=lambda one: reading.chances[one])
    return ours | {first} <= {"affirm", "approve"}


def _names_known(reading: Reading) -> bool:
    """Whether a name is one the task knows: it was not cut out of the line by chance."""
    told = act_to_json(reading.parse.acts[0])
    names = {str(one) for key in _NAMES for one in _each(told.get(key))}
    return bool(names & set(reading.hearing.listening.subtasks))


@cache
def _weights(language: str) -> Mapping[Trait, float]:
    path = Path(__file__).parent / LANGUAGES[language.lower()] / "confidence.yaml"
    if not path.exists():
        return {}
    page = cast("Mapping[str, Any]", read_file(path)[0].value)
    return {name: float(page["weights"][name]) for name in TRAITS}


def traits(reading: Reading) -> Mapping[Trait, float]:
    """Return what a reading looks like."""
    parse, chances = reading.parse, reading.chances
    ours = {label_of(act) for act in parse.acts}
    likely = chance(parse.acts, chances)
    rival = max((p for one, p in chances.items() if one not in ours), default=0.0)
    score = min(max(parse.score, 1 - _SURE), _SURE)
    found: dict[Trait, float] = {
        "always": 1.0,
        "score": math.log(score / (1 - score)),
        "chance": math.log(max(likely, _LEAST)),
        "rival": math.log(max(rival, _LEAST)),
        "margin": likely - rival,
        "agreed": float(likely > 0.5),
        "sentence": float(parse.how == "sentence"),
        "motion": float(parse.how == "motion"),
        "frame": float(parse.how == "frame"),
        "named": float(parse.how in ("named", "unseconded")),
        "answer": float(parse.how == "answer"),
        "sought": float(parse.how == "sought"),
        "mended": float(parse.how in ("mended", "partly", "request")),
        "several": float(len(parse.acts) > 1),
        "mixed": float(len(parse.acts) > 1 and not all(isinstance(a, _JOINED) for a in parse.acts)),
        "repaired": float(texts_of(reading.words) != texts_of(reading.heard)),
        "unknown": float(isinstance(parse.acts[0], Unknown)),
        "open": float(reading.hearing.listening.asked in OPEN),
        "words": min(len(reading.heard), 20) / 10,
    }
    return {**found, **_named(reading)}


def _named(reading: Reading) -> dict[Trait, float]:
    """Return what the names look like, and how many words nobody knows are left beside them."""
    book, language = reading.hearing.book, reading.hearing.language
    known = frames(language)
    endings = known.name_endings if known else ()
    told = act_to_json(reading.parse.acts[0])
    names = [str(one) for key in _NAMES for one in _each(told.get(key))]
    own = {word for name in names for word in name.lower().split()}
    own |= {word for one in _each(told.get("value")) for word in str(one).lower().split()}
    clear = [any(w.endswith(endings) for w in name.split()) if endings else True for name in names]
    strange = sum(
        word.text.isalpha()
        and word.text not in book.vocabulary
        and word.said not in own
        and word.text not in own
        for word in reading.heard
    )
    return {
        "names": float(bool(names)),
        "clear_names": float(bool(names) and all(clear)),
        "long_names": float(any(len(name.split()) > 2 for name in names)),
        "odd_names": float(bool(own & book.impure)),
        "strange": min(strange, 4.0),
    }


def _each(value: Any) -> list[Any]:
    if value is None or value == "":
        return []
    return list(value) if isinstance(value, list | tuple) else [value]
