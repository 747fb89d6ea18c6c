"""What recognizers share: the port, and words in one form whatever recognizer wrote them."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from typing import Protocol, runtime_checkable

from assistant.shells.voice.sound import Samples

FEWEST_LETTERS = 3
"""So many letters on end are a word that is spelled."""
FEWEST_REPEATED, REPEATS = 10, 4.0
"""Words of a text, and how often on average each of them stands there, from which it is a loop."""


@dataclass(frozen=True, slots=True)
class Recognized:
    """Words, lower case and without punctuation, empty for none; and how sure of them it is."""

    text: str
    sure: float = 1.0


class Recognizer(Protocol):
    """Turns the sound of one utterance into words."""

    name: str

    def recognize(
        self, samples: Samples, hot_words: Sequence[str] = (), *, loud: bool = False
    ) -> tuple[Recognized, ...]:
        """Return what may have been said, the likeliest first; nothing for no words.

        In a loud room, that is with `loud`, more care may be worth its time.
        """
        ...


@runtime_checkable
class Weigher(Protocol):
    """A recognizer that can tell how well given words explain a sound."""

    def likelihoods(
        self, samples: Samples, phrases: Sequence[str], *, loud: bool = False
    ) -> tuple[float, ...]:
        """Return a natural logarithm for each phrase; `loud` as where it was recognized."""
        ...


@runtime_checkable
class Rereader(Protocol):
    """A recognizer that can tell what else it may have read."""

    def reread(self, samples: Samples) -> tuple[Recognized, ...]:
        """Return the likeliest few readings, which takes longer than `recognize`."""
        ...


def is_loop(text: str) -> bool:
    """Tell whether a text is a few words over and over: what recognizers make of noise.

    Nobody says "no" ten times on end to answer a question.
    """
    words = text.split()
    return len(words) >= FEWEST_REPEATED and len(words) >= REPEATS * len(set(words))


def merged(readings: Iterable[tuple[str, float]]) -> tuple[Recognized, ...]:
    """Return readings of the same words as one, the likeliest first; none of no words.

    Parameters
    ----------
    readings : iterable of words and how likely they are
    """
    odds: dict[str, float] = {}
    for words, likely in readings:
        odds[words] = odds.get(words, 0.0) + likely
    ranked = sorted(odds.items(), key=lambda item: -item[1])
    return tuple(Recognized(words, min(sure, 1.0)) for words, sure in ranked if words)


def plain_words(text: str) -> str:
    """Return recognized text in lower case without punctuation, apostrophes kept."""
    kept = "".join(
        letter if letter.isalnum() or letter in "'.-%" else " " for letter in text.lower()
    )
    words = (word.strip(".-'") for word in kept.replace("-", " ").split())
    return _unspelled([word for word in words if word])


def _unspelled(words: Sequence[str]) -> str:
    """Return words with what was spelled letter by letter put together."""
    told: list[str] = []
    letters: list[str] = []
    for word in (*words, ""):
        if len(word) == 1 and word.isalpha():
            letters.append(word)
            continue
        told += ["".join(letters)] if len(letters) >= FEWEST_LETTERS else letters
        told += [word] if word else []
        letters = []
    return " ".join(told)
