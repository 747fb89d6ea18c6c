"""Words nobody listed that come of words that are: as a dialect sounds, bent, or put together.

"gsogt" is "gesagt" as it is spoken in places, "anzuheben" is "anheben" behind what wants it done,
"Ablaufbaum" is a tree. A language whose phrasebook tells no such ways has none.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from functools import lru_cache
from typing import Any

from assistant.language.lists import pairs

_SHORTEST = 4
_DEEPEST = 3
_EDGES = "<", ">"


@dataclass(frozen=True, slots=True)
class Bends:
    """How unknown words come of known ones.

    Parameters
    ----------
    letters : tuple of (str, str)
        Letters typed for others: "ae" for "ä".
    sounds : tuple of (str, str)
        How a dialect sounds, and what is written; "<" and ">" are the edges of a word.
    within : str
        What stands inside a verb that is wanted: "an-zu-heben"; empty for none.
    verbs : tuple of str
        How verbs end that have it.
    heads : frozenset of str
        Words that tell what a compound is by its end.
    asked : frozenset of str
        Who is asked politely to do what stands before: "kippen Sie" is "kippe".
    """

    letters: tuple[tuple[str, str], ...] = ()
    sounds: tuple[tuple[str, str], ...] = ()
    within: str = ""
    verbs: tuple[str, ...] = ()
    heads: frozenset[str] = frozenset()
    asked: frozenset[str] = frozenset()


def bends_of(told: Mapping[str, Any]) -> Bends:
    """Return the ways to bend that a phrasebook tells in its part `bends`."""
    return Bends(
        tuple(pairs(told.get("letters", ""))),
        tuple(pairs(told.get("sounds", ""))),
        told.get("within", ""),
        tuple(told.get("verbs", "").split()),
        frozenset(told.get("heads", "").split()),
        frozenset(told.get("asked", "").split()),
    )


@lru_cache(maxsize=4096)
def unbent_word(text: str, known: frozenset[str], bends: Bends) -> str:
    """Return the known word that an unknown one comes of; empty if it comes of none."""
    if len(text) < _SHORTEST:
        return ""
    lettered = relettered(text, bends)
    if lettered in known:
        return lettered
    wanted = _without_within(lettered, bends)
    if wanted in known:
        return wanted
    return _as_spoken(lettered, known, bends) or _head(lettered, bends)


def put_together(text: str, known: frozenset[str]) -> bool:
    """Tell a word of two known ones, which is no slip of a third: "unter-tasse"."""
    cuts = range(_SHORTEST, len(text) - _SHORTEST + 1)
    return any(text[:at] in known and text[at:] in known for at in cuts)


def relettered(text: str, bends: Bends) -> str:
    """Return a word with the letters that others were typed for."""
    for typed, meant in bends.letters:
        text = text.replace(typed, meant)
    return text


def _without_within(text: str, bends: Bends) -> str:
    """Return "anheben" for "anzuheben"; empty where nothing stands inside."""
    at = text.find(bends.within, 2) if bends.within else -1
    verb = text[at + len(bends.within) :]
    fits = at > 0 and len(verb) >= _SHORTEST - 1 and verb.endswith(bends.verbs)
    return text[:at] + verb if fits else ""


def _as_spoken(text: str, known: frozenset[str], bends: Bends) -> str:
    """Return the one known word that fewest ways of speaking make a word of."""
    begin, end = _EDGES
    told, seen = [f"{begin}{text}{end}"], {text}
    for _ in range(_DEEPEST if bends.sounds else 0):
        told = [one for one in dict.fromkeys(_once(told, bends)) if one not in seen]
        seen |= set(told)
        found = {one.strip("<>") for one in told} & known
        if found:
            return found.pop() if len(found) == 1 else ""
    return ""


def _once(words: list[str], bends: Bends) -> Iterator[str]:
    """Yield words with one sound more put as it is written."""
    for word in words:
        for sound, written in bends.sounds:
            at = word.find(sound)
            while at >= 0:
                yield word[:at] + written + word[at + len(sound) :]
                at = word.find(sound, at + 1)


def _head(text: str, bends: Bends) -> str:
    """Return what a compound is: "baum" of "ablaufbaum"."""
    cuts = range(_SHORTEST - 1, len(text) - _SHORTEST + 1)
    return next((text[at:] for at in cuts if text[at:] in bends.heads), "")
