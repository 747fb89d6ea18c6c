"""Numbers and quantities in words: "two and a half centimetres", "a quarter turn", "-248.6"."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import Literal

Kind = Literal["m", "deg", "ratio", "s", ""]
_DIGITS = re.compile(r"[+-]?(?:\d+(?:\.\d*)?|\.\d+)$")
_DIGIT_STARTS = frozenset("0123456789+-.")
_LONGEST = 6
_ORDINAL = re.compile(r"(\d+)(?:st|nd|rd|th)$")


@dataclass(frozen=True, slots=True)
class Quantity:
    """A number with the kind of its unit: metres, degrees, a ratio, seconds, or none."""

    value: float
    kind: Kind
    end: int
    unit: float = 0.0


@dataclass(frozen=True, eq=False)
class NumberWords:
    """The words a language counts with."""

    ones: Mapping[str, int]
    tens: Mapping[str, int]
    also: Mapping[tuple[str, ...], float]
    begun: Mapping[str, tuple[tuple[str, ...], ...]]
    ordinals: Mapping[str, int]
    fractions: Mapping[str, float]
    units: Mapping[str, tuple[Kind, float]]
    hundred: frozenset[str]
    joiners: frozenset[str]
    articles: frozenset[str]
    points: frozenset[str]
    minus: frozenset[str]
    within: frozenset[str]
    of: frozenset[str]
    unit_joints: frozenset[str]
    begins: frozenset[str]

    def number(self, words: Sequence[str], at: int) -> tuple[float, int] | None:
        """Return the number that begins at `at` and where it ends."""
        if at >= len(words) or not self._begins(words[at]):
            return None
        if words[at] in self.minus:
            found = self.number(words, at + 1)
            return None if found is None else (-found[0], found[1])
        phrase = self._phrase(words, at)
        found = None if phrase and len(phrase) > 1 else self._fraction_of(words, at)
        found = found or self._whole(words, at)
        return None if found is None else self._and_fraction(words, *found)

    def start(self, words: Sequence[str], at: int) -> int:
        """Return where the number begins that a place is within: the "one" of "one point five"."""
        for begun in range(max(0, at - _LONGEST), at):
            found = self.number(words, begun)
            if found is not None and found[1] > at:
                return begun
        return at

    def _begins(self, word: str) -> bool:
        """Tell quickly whether a number can begin with a word."""
        return word in self.begins or word[:1] in _DIGIT_STARTS

    def quantity(self, words: Sequence[str], at: int) -> Quantity | None:
        """Return the number with its unit; "half an inch", "a quarter turn", "an inch"."""
        if at >= len(words) or not (self._begins(words[at]) or words[at] in self.units):
            return None
        found = self.number(words, at)
        if found is None:
            bare = self.units.get(words[at]) if at < len(words) and len(words[at]) > 3 else None
            if bare and bare[0] == "m":
                whole = self._with_fraction_behind(words, bare, 1.0, at + 1)
                return whole if whole.end > at + 1 else None
            unit = self.units.get(words[at + 1]) if at + 1 < len(words) else None
            if unit and unit[0] in ("m", "s") and words[at] in self.articles:
                return self._with_fraction_behind(words, unit, 1.0, at + 2)
            return None
        value, end = found
        while end < len(words) and words[end] in self.unit_joints:
            one = set(words[end + 1 : end + 2]) & self.unit_joints & self.articles
            following = end + 1 + (words[end] in self.of and bool(one))
            if following < len(words) and words[following] in self.units:
                end = following
                break
            return Quantity(value, "", found[1])
        unit = self.units.get(words[end]) if end < len(words) else None
        if unit is None:
            return Quantity(value, "", found[1])
        return self._with_fraction_behind(words, unit, value, end + 1)

    def _with_fraction_behind(
        self, words: Sequence[str], unit: tuple[Kind, float], value: float, end: int
    ) -> Quantity:
        """Read on: "an inch and a half", "one inch and three quarters"."""
        part = self._fraction_behind(words, end)
        if part is not None and (part[1] >= len(words) or words[part[1]] not in self.within):
            value, end = value + part[0], part[1]
        return Quantity(value * unit[1], unit[0], end, unit[1])

    def _fraction_behind(self, words: Sequence[str], at: int) -> tuple[float, int] | None:
        """Return the fraction behind a joining word: "and a half", "and three quarters"."""
        if at + 1 >= len(words) or words[at] not in self.joiners:
            return None
        if words[at + 1].startswith("0.") and _DIGITS.match(words[at + 1]):
            return float(words[at + 1]), at + 2
        start = at + 2 if words[at + 1] in self.articles else at + 1
        part = self.fractions.get(words[start]) if start < len(words) else None
        if part is not None:
            return part, start + 1
        count = self.ones.get(words[at + 1])
        part = self.fractions.get(words[at + 2]) if at + 2 < len(words) else None
        if count is None or part is None or count * part >= 1:
            return None
        return count * part, at + 3

    def ordinal(self, words: Sequence[str], at: int) -> tuple[int, int] | None:
        """Return the place ("third", "3rd") at `at` and where it ends."""
        if at >= len(words):
            return None
        match = _ORDINAL.match(words[at]) if words[at][:1] in _DIGIT_STARTS else None
        if match:
            return int(match.group(1)), at + 1
        place = self.ordinals.get(words[at])
        return None if place is None else (place, at + 1)

    def number_ends(self, words: Sequence[str], at: int) -> Iterator[int]:
        """Yield where a number at `at` ends, as templates want it."""
        found = self._whole(words, at)
        if found is not None:
            yield found[1]

    def ordinal_ends(self, words: Sequence[str], at: int) -> Iterator[int]:
        """Yield where an ordinal at `at` ends, as templates want it."""
        found = self.ordinal(words, at)
        if found is not None:
            yield found[1]

    def _fraction_of(self, words: Sequence[str], at: int) -> tuple[float, int] | None:
        """Read "half", "a quarter", "three quarters"."""
        start = at + 1 if at < len(words) and words[at] in self.articles else at
        part = self.fractions.get(words[start]) if start < len(words) else None
        if part is not None:
            return self._part_of(words, part, start + 1)
        count = self._whole(words, at)
        if count is None or count[1] >= len(words):
            return None
        part = self.fractions.get(words[count[1]])
        return None if part is None else (count[0] * part, count[1] + 1)

    def _part_of(self, words: Sequence[str], part: float, end: int) -> tuple[float, int]:
        """Read on: "half of ninety" is forty five."""
        counted = end + 1 < len(words) and words[end] in self.of
        whole = self._whole(words, end + 1) if counted else None
        return (part, end) if whole is None else (part * whole[0], whole[1])

    def _and_fraction(self, words: Sequence[str], value: float, end: int) -> tuple[float, int]:
        """Read on after a whole number: "and a half", "point five"."""
        if end < len(words) and words[end] in self.points and value % 1 == 0:
            digits = ""
            at = end + 1
            while at < len(words) and (words[at] in self.ones or words[at].isdecimal()):
                digits += str(self.ones.get(words[at], words[at]))
                at += 1
            if digits:
                return float(f"{value:.0f}.{digits}"), at
        part = self._fraction_behind(words, end)
        if part is not None:
            return value + part[0], part[1]
        # "1 1/2 inch" is split into a whole number and a share.
        if value >= 1 and end < len(words) and words[end].startswith("0.") and value % 1 == 0:
            share = float(words[end]) if _DIGITS.match(words[end]) else 0.0
            return (value + share, end + 1) if share else (value, end)
        return value, end

    def _whole(self, words: Sequence[str], at: int) -> tuple[float, int] | None:
        phrase = self._phrase(words, at)
        if phrase is not None:
            return self.also[phrase], at + len(phrase)
        if at < len(words) and _DIGITS.match(words[at]):
            return self._digits(words, at)
        if at + 1 < len(words) and words[at] in self.points and words[at + 1] in self.ones:
            return self._and_fraction(words, 0.0, at)
        return self._spelled(words, at)

    def _phrase(self, words: Sequence[str], at: int) -> tuple[str, ...] | None:
        """Return the longest phrase for a number that begins at `at`: "half a dozen"."""
        begun = self.begun.get(words[at], ()) if at < len(words) else ()
        return next((p for p in begun if tuple(words[at : at + len(p)]) == p), None)

    def _digits(self, words: Sequence[str], at: int) -> tuple[float, int]:
        if at + 1 < len(words) and words[at + 1] in self.hundred:
            return float(words[at]) * 100.0, at + 2
        return float(words[at]), at + 1

    def _spelled(self, words: Sequence[str], at: int) -> tuple[float, int] | None:
        """Read "twenty five", "a hundred and ten"."""
        total, end, seen = 0.0, at, False
        small = self._below_hundred(words, at)
        if small is not None:
            total, end, seen = float(small[0]), small[1], True
        elif at + 1 < len(words) and words[at] in self.articles and words[at + 1] in self.hundred:
            total, end = 1.0, at + 1
        if end < len(words) and words[end] in self.hundred:
            total, end, seen = (total or 1.0) * 100.0, end + 1, True
            start = end + 1 if end < len(words) and words[end] in self.joiners else end
            rest = self._below_hundred(words, start)
            # In "four hundred, one hundred" the one begins another number.
            if rest is not None and not (rest[0] < 10 and self._hundred_at(words, rest[1])):
                total, end = total + rest[0], rest[1]
        return (total, end) if seen else None

    def _below_hundred(self, words: Sequence[str], at: int) -> tuple[int, int] | None:
        if at >= len(words):
            return None
        tens = self.tens.get(words[at])
        if tens is None:
            ones = self.ones.get(words[at])
            return None if ones is None else (ones, at + 1)
        more = self.ones.get(words[at + 1]) if at + 1 < len(words) else None
        more = None if self._hundred_at(words, at + 2) else more
        return (tens + more, at + 2) if more is not None and 0 < more < 10 else (tens, at + 1)

    def _hundred_at(self, words: Sequence[str], at: int) -> bool:
        return at < len(words) and words[at] in self.hundred

    def listed(self, words: Sequence[str]) -> float | None:
        """Return the number that all of the words tell digit by digit: "five five zero".

        "Four ten" is 410 and "five thirty three" 533, as people read out numbers.
        """
        sign = -1.0 if words and words[0] in self.minus else 1.0
        words = words[1:] if sign < 0 else words
        if not words or words[0] not in self.ones or self.ones[words[0]] > 9:
            return None
        if len(words) > 1 and all(self.ones.get(word, 10) < 10 for word in words):
            return sign * float("".join(str(self.ones[word]) for word in words))
        rest = self._below_hundred(words, 1)
        if rest is None or rest[0] < 10 or rest[1] != len(words):
            return None
        return sign * (self.ones[words[0]] * 100.0 + rest[0])
