"""Sentences made of patterns: ways to say what is said seldom, with names and numbers put in.

A pattern is a line of `tests/language/corpus/patterns.yaml`, written like a line of a corpus.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping
from typing import cast

import numpy as np

from assistant.model.listening import Listening
from assistant.model.teacher_acts import Asked
from assistant.plain_yaml import read_file
from tests.benchmarks.bench_language import CORPUS, STAGES, Row, act_of

_CHOICE = re.compile(r"\(([^()]*)\)")
_MISSING = re.compile(r"\[([^\[\]]*)\]")
_SLOT = re.compile(r"\{(\w+)\}")
_SMALL = ("zero", "one", "two", "three", "four", "five", "six", "seven", "eight", "nine")
_PLACES = ("", "first", "second", "third", "fourth", "fifth", "sixth", "seventh", "eighth", "ninth")
_SHORT = ("", "1st", "2nd", "3rd", "4th", "5th", "6th", "7th", "8th", "9th")
_WAYS: Mapping[str, tuple[str, ...]] = {
    "left": ("left", "to the left", "leftwards", "more left", "over to the left"),
    "right": ("right", "to the right", "rightwards", "more right", "over to the right"),
    "up": ("up", "upwards", "higher", "higher up"),
    "down": ("down", "downwards", "lower", "deeper"),
    "forward": ("forward", "forwards", "ahead", "to the front"),
    "backward": ("back", "backward", "backwards", "further back"),
}
_TURNS: Mapping[str, tuple[str, ...]] = {
    "left": ("left", "to the left"),
    "right": ("right", "to the right"),
    "clockwise": ("clockwise",),
    "counterclockwise": ("counterclockwise", "anticlockwise", "counter clockwise"),
    "up": ("up", "upwards"),
    "down": ("down", "downwards"),
    "forward": ("forward", "forwards"),
    "backward": ("backward", "backwards"),
}
_SIDES: Mapping[str, tuple[int, int]] = {
    "left": (1, 1),
    "right": (1, -1),
    "back": (0, -1),
    "forward": (0, 1),
}
_UNITS: tuple[tuple[tuple[str, ...], float], ...] = (
    (("mm", "millimetres", "millimeters", "mil"), 0.001),
    (("cm", "centimetres", "centimeters", "centimetre"), 0.01),
    (("inches", "inch"), 0.0254),
)


class _Filler:
    """What stands in the slots of one sentence."""

    def __init__(self, rng: np.random.Generator, names: Mapping[str, list[str]]) -> None:
        self._rng = rng
        self.told: dict[str, str] = {}
        self.meant: dict[str, str] = {}
        for slots, page in (("ABC", "steps"), ("OPQ", "things"), ("TU", "tasks"), ("G", "goals")):
            for slot, name in zip(slots, rng.permutation(names[page])[: len(slots)], strict=True):
                self.told[slot] = self.meant[slot] = str(name)
        self._count()
        self._measure()
        self._direct()

    def _one(self, options: tuple[str, ...]) -> str:
        return str(options[self._rng.integers(len(options))])

    def _count(self) -> None:
        number, other = (int(n) for n in self._rng.permutation(np.arange(2, 10))[:2])
        self.told["num"] = self._one((_SMALL[number], str(number)))
        self.told["other"] = self._one((_SMALL[other], str(other)))
        self.told["nth"] = self._one((_PLACES[number], _PLACES[number], _SHORT[number]))
        self.meant["num"] = self.meant["nth"] = str(number)

    def _measure(self) -> None:
        rng = self._rng
        size, (units, scale) = int(rng.integers(2, 10)), _UNITS[rng.integers(len(_UNITS))]
        self.told["mm"] = f"{self._one((_SMALL[size], str(size)))} {self._one(units)}"
        self.meant["m"] = f"{size * scale:.6g}"
        self._step_mm = size * scale * 1e3
        angle = int(rng.choice([2, 3, 4, 5, 8, 10, 15, 20, 30, 45]))
        self.told["turn"] = f"{angle} {self._one(('degrees', 'deg'))}"
        self.meant["deg"] = str(angle)
        tenths = int(rng.integers(11, 200))
        whole, rest = divmod(tenths, 10)
        self.told["time"] = (
            f"{whole}.{rest} {self._one(('seconds', 's', 'sec'))}" if rest else f"{whole} seconds"
        )
        self.meant["s"] = f"{whole}.{rest}" if rest else str(whole)
        place = [int(n) for n in rng.integers(-40, 60, 3) * 10]
        self.told["place"] = ", ".join(map(str, place))
        self.meant["xyz"] = ",".join(map(str, place))

    def _direct(self) -> None:
        way, other = (str(one) for one in self._rng.permutation(list(_WAYS))[:2])
        self.told |= {"dirtext": self._one(_WAYS[way]), "other_dir": other}
        turn = self._one(tuple(_TURNS))
        self.told["rottext"], self.meant["rot"] = self._one(_TURNS[turn]), turn
        side = self._one(tuple(_SIDES))
        axis, sign = _SIDES[side]
        moved = [0.0, 0.0, 0.0]
        moved[axis] = sign * self._step_mm
        self.told["side"] = side
        self.meant |= {"dir": way, "by": ",".join(f"{one:.6g}" for one in moved)}


def made(copies: int = 6, seed: int = 11) -> Iterator[Row]:
    """Yield sentences of each pattern, the same for the same seed."""
    rng = np.random.default_rng(seed)
    names = {page: _split(page, text) for page, text in _pages("names")}
    for page, lines in _pages("patterns"):
        for line in lines.splitlines():
            text, stages, asked, acts = (part.strip() for part in line.rsplit("|", 3))
            for _ in range(max(copies, len(text.split("/")) // 2)):
                filler = _Filler(rng, names)
                said = " ".join(_filled(_way(text, rng), filler.told).replace(" ,", ",").split())
                where = Listening(
                    stage=STAGES[stages[rng.integers(len(stages))]],
                    asked=cast("Asked", asked or None),
                )
                told = _filled(acts, filler.meant)
                yield Row(page, said, where, [act_of(part) for part in told.split(" ; ")])


def _pages(name: str) -> Iterator[tuple[str, str]]:
    yield from cast("Mapping[str, str]", read_file(CORPUS / f"{name}.yaml")[0].value).items()


def _split(page: str, text: str) -> list[str]:
    mark = ";" if page == "goals" else ","
    return [one.strip() for one in text.replace("\n", " ").split(mark)]


def _way(text: str, rng: np.random.Generator) -> str:
    """Return one way to say a pattern."""

    def chosen(match: re.Match[str]) -> str:
        ways = match[1].split("/")
        return ways[rng.integers(len(ways))]

    def kept(match: re.Match[str]) -> str:
        return chosen(match) if rng.random() < 0.4 else ""

    return _CHOICE.sub(chosen, _MISSING.sub(kept, text))


def _filled(text: str, slots: Mapping[str, str]) -> str:
    return _SLOT.sub(lambda match: slots[match[1]], text)
