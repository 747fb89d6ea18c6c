"""The words a language counts with, read from its phrasebook."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any, cast

from assistant.language.lists import Phrase, by_first_word, pairs
from assistant.language.numbers import Kind, NumberWords


def glued(told: str, tens: Mapping[str, int], ones: Mapping[str, int]) -> Mapping[str, float]:
    """Return numbers that are written as one word, such as "fünfundzwanzig", "zweieinhalb".

    Parameters
    ----------
    told : str
        The digits as they stand in front, the word between, hundred, and "and a half", parted
        by slashes; empty for a language that writes numbers apart.
    """
    if not told:
        return {}
    fronts, joint, hundred, half = (part.split() for part in told.split("/"))
    front = {word: value for value, word in enumerate(fronts, start=1)}
    below = {f"{f}{joint[0]}{t}": a + b for f, a in front.items() for t, b in tens.items()}
    small = {**ones, **tens, **below}
    found = {word: float(value) for word, value in below.items()}
    for head, count in (("", 1), *front.items()):
        found[f"{head}{hundred[0]}"] = 100.0 * count
        for word, value in small.items():
            found[f"{head}{hundred[0]}{word}"] = 100.0 * count + value
            found[f"{head}{hundred[0]}{joint[0]}{word}"] = 100.0 * count + value
    halves = {**front, **{word: value for word, value in ones.items() if value > 1}}
    return found | {f"{word}{half[0]}": value + 0.5 for word, value in halves.items()}


def number_words(told: Mapping[str, Any]) -> NumberWords:
    """Return the words a language counts with, from the part `numbers` of its phrasebook."""
    ones = {word: value for value, word in enumerate(told["ones"].split())}
    tens = {word: 10 * value for value, word in enumerate(told["tens"].split(), start=2)}
    ordinals = {
        word + ending: value
        for value, word in enumerate(told["ordinals"].split(), start=1)
        for ending in ("", *told.get("ordinal_endings", "").split())
    }
    units: dict[str, tuple[Kind, float]] = {}
    for key, names in pairs(told["units"]):
        kind, factor = key.split(":")
        for name in names.split(","):
            units[name.strip()] = (cast("Kind", kind.strip()), float(factor))
    fractions = {key: float(value) for key, value in pairs(told["fractions"])}
    units |= {
        f"{part}{name}": (kind, fractions[part] * factor)
        for part in told.get("glued_units", "").split()
        for name, (kind, factor) in units.items()
    }
    whole = glued(told.get("glued", ""), tens, ones)
    also: dict[Phrase, float] = {(word,): value for word, value in whole.items()}
    also |= {tuple(key.split()): float(value) for key, value in pairs(told["also"])}
    words = {name: frozenset(told[name].split()) for name in ("hundred", "a", "point", "minus")}
    begun = by_first_word(also)
    return NumberWords(
        ones=ones,
        tens=tens,
        also=also,
        begun=begun,
        ordinals=ordinals,
        fractions=fractions,
        units=units,
        hundred=words["hundred"],
        joiners=frozenset(told["and"].split()),
        articles=words["a"],
        points=words["point"],
        minus=words["minus"],
        within=frozenset(told.get("within", "").split()),
        of=frozenset(told.get("of", "").split()),
        unit_joints=frozenset(told.get("unit_joints", "").split()),
        begins=frozenset().union(ones, tens, begun, fractions, *words.values()),
    )
