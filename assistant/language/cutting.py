"""Where a line may be cut into clauses of one act each, judged by how the clauses are read."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from itertools import combinations, pairwise
from math import inf, log

from assistant.language.answers import OPEN
from assistant.language.learned import Learned, learned
from assistant.language.parsing import Hearing
from assistant.language.words import Words

_MOST_CUTS = 5
_SHORTEST = 2
_ALONE = frozenset(
    ("unknown", "inform", "explain", "key_state", "affirm", "deny", "approve", "cue")
)
_SURE = log(0.5)
"""How likely both halves are at least of a line that is likely one act."""


@dataclass(frozen=True, slots=True)
class Cut:
    """Clauses as they are read, with how likely they are together."""

    clauses: tuple[Learned, ...]
    mean_log: float
    least_log: float
    marked: float


def cuts(words: Words, hearing: Hearing) -> list[Cut]:
    """Return the likeliest ways to cut a line into two or three clauses."""
    places = _places(words, hearing)
    read: dict[tuple[int, int], Learned | None] = {}
    found: list[Cut] = []
    for count in (1, 2):
        ways = [
            one
            for one in (_read(words, way, read, hearing) for way in combinations(places, count))
            if one
        ]
        found.extend(sorted(ways, key=lambda one: -one.mean_log)[: 3 - count])
    return found


def _places(words: Words, hearing: Hearing) -> list[int]:
    """Return where a clause may begin."""
    joints = hearing.book.little["cut_joints"]
    return [
        at
        for at in range(1, len(words))
        if words[at].broken or (words[at].text in joints and at + 1 < len(words))
    ][:_MOST_CUTS]


def sure_cuts(words: Words, chances: Mapping[str, float], hearing: Hearing) -> list[Cut]:
    """Return the likeliest way to cut a line in two whose halves are both surely acts.

    Words that tell one act surely may drown those of another, "drop it, and add one", but in
    names, texts and talk.
    """
    likeliest = max(chances, key=chances.__getitem__).partition(" ")[0]
    if hearing.listening.asked in OPEN or likeliest in _ALONE:
        return []
    places = _places(words, hearing)
    ways = [(at,) for at in places if _SHORTEST <= at <= len(words) - _SHORTEST]
    read: dict[tuple[int, int], Learned | None] = {}
    found = [one for one in (_read(words, way, read, hearing, _SURE) for way in ways) if one]
    sure = [one for one in found if _unlike(one)]
    return sorted(sure, key=lambda one: -one.mean_log)[:1]


def _unlike(cut: Cut) -> bool:
    return len({str(one.act) for one in cut.clauses}) == len(cut.clauses)


def _read(
    words: Words,
    way: tuple[int, ...],
    read: dict[tuple[int, int], Learned | None],
    hearing: Hearing,
    least: float = -inf,
) -> Cut | None:
    """Return the clauses a line is cut into; None if one cannot be read, or not so likely."""
    clauses: list[Learned] = []
    for span in pairwise((0, *way, len(words))):
        if span not in read:
            read[span] = _best(words[slice(*span)], hearing)
        clause = read[span]
        if clause is None or clause.act_log + clause.slots_log < least:
            return None
        clauses.append(clause)
    logs = [one.act_log + one.slots_log for one in clauses]
    marked = sum(words[at].broken for at in way) / len(way)
    return Cut(tuple(clauses), sum(logs) / len(logs), min(logs), marked)


def _best(words: Words, hearing: Hearing) -> Learned | None:
    while len(words) > 1 and words[0].text in hearing.book.little["cut_joints"]:
        words = words[1:]
    readings = learned(words, hearing, most=2)
    if not readings or readings[0].label == "unknown":
        return None
    return max(readings, key=lambda one: one.act_log + one.slots_log)
