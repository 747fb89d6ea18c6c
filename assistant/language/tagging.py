"""Which words of a clause fill the slots of an act: a linear chain over its words.

The act is given; of all ways to spread its slots over the words the likeliest is taken, and
how likely it is tells how sure that is. A slot that holds one name is filled once, and those
an act cannot do without are filled. The weights are fitted by `tests/benchmarks/fit_slots.py`
and shipped as ``slots.npz`` of a language.

Source: conditional random fields (Lafferty, McCallum and Pereira 2001).
"""

from __future__ import annotations

import math
from collections.abc import Collection, Iterator
from dataclasses import dataclass
from functools import cache, lru_cache
from itertools import pairwise
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from assistant.language.nets import Net, Seen, seen_by, tag_scores, unpacked
from assistant.language.phrasebook import LANGUAGES
from assistant.language.traits import Hashes, mixed, named
from assistant.language.words import Words
from assistant.model.listening import Listening

SLOTS = (
    "value",
    "old",
    "new",
    "subtask",
    "subtasks",
    "first",
    "second",
    "name",
    "after",
    "before",
    "object",
    "where_before",
    "where_during",
    "where_after",
    "amount",
)
TAGS = ("O", *(f"{edge}-{slot}" for slot in SLOTS for edge in "BI"))
BUCKETS = 1 << 15
Tagged = tuple[tuple[str, int, int], ...]
_PLACED = ("where_before", "where_during", "where_after")
TAKES: dict[str, tuple[str, ...]] = {
    "inform": ("value",),
    "inform many": ("value",),
    "inform count": ("amount",),
    "rename": ("old", "new"),
    "optional": ("subtask",),
    "required": ("subtask",),
    "unordered": ("subtasks",),
    "ordered": ("first", "second"),
    "add_subtask": ("name", "after", "before"),
    "remove_subtask": ("subtask",),
    "merge": ("subtasks",),
    "split": ("subtask",),
    "move_cut": ("subtask",),
    "move_cut at": ("subtask", "amount"),
    "assign": ("amount", "subtask"),
    "set_pose": ("object",),
    "save": ("name",),
    "load": ("name",),
    "compare": ("name",),
    "cue number": ("amount",),
    "adjust_last": (),
    "adjust_last factor": ("amount",),
    "adjust_speed": _PLACED,
    "adjust_speed factor": ("amount", *_PLACED),
    "translate": ("amount", *_PLACED),
    "rotate": ("amount", *_PLACED),
    "gripper": _PLACED,
}
"""The slots of each kind of act that hold words or numbers of the sentence."""
_FREE = frozenset(("name", "after", "before", "object", *_PLACED))
_NAMED = frozenset(("add_subtask",))
_MANY = frozenset(("inform many", "merge", "unordered"))
_NEVER = -1e9
_SECOND = 0.7
"""How much the net counts beside the weights."""
Scores = NDArray[np.float32]
_State = tuple[int, tuple[int, ...]]


@dataclass(frozen=True, slots=True, eq=False)
class Chain:
    """A chain's weights.

    Parameters
    ----------
    weights : array, shape (BUCKETS, tags)
    steps : array, shape (tags, tags)
        From one tag to the next.
    net : Net or None
        Seconds the weights.
    """

    weights: Scores
    steps: Scores
    net: Net | None = None


@dataclass(frozen=True, slots=True)
class Tagging:
    """The likeliest spread of slots over words, with how likely it is."""

    spans: Tagged
    probability: float


@dataclass(frozen=True, slots=True, eq=False)
class Ways:
    """How an act may be spread over words.

    Parameters
    ----------
    tags : array, shape (states,)
        The tag of each state.
    steps : array, shape (states, states)
        Whether one may follow another.
    begins, ends : array, shape (states,)
        Whether a clause may begin or end there.
    share : array, shape (states,)
        One over how many states have the same tag.
    """

    tags: NDArray[np.int64]
    steps: NDArray[np.bool_]
    begins: NDArray[np.bool_]
    ends: NDArray[np.bool_]
    share: Scores


@cache
def chain(language: str) -> Chain | None:
    """Return the weights of a language, read once; None if it has none."""
    path = Path(__file__).parent / LANGUAGES[language.lower()] / "slots.npz"
    if not path.exists():
        return None
    with np.load(path) as file:
        scale = float(file["scale"])
        weights = file["weights"].astype(np.float32) * scale
        return Chain(weights, file["steps"].astype(np.float32), unpacked(file, "net"))


def rows(traits: Hashes, kind: str) -> NDArray[np.int64]:
    """Return the rows of the weights that count for each word, given the kind of act."""
    return np.concatenate([traits, mixed(traits, named(kind))], axis=1).astype(np.int64) % BUCKETS


@cache
def ways_of(kind: str) -> Ways:
    """Return the ways of a kind of act: which slots it has had so far is part of a state."""
    slots = TAKES[kind]
    groups = tuple(dict.fromkeys("where" if slot in _PLACED else slot for slot in slots))
    states: list[_State] = [(0, (0,) * len(groups))]
    reached: dict[_State, list[_State]] = {}
    for state in states:
        reached[state] = list(_next(state, slots, groups, kind))
        states.extend(one for one in dict.fromkeys(reached[state]) if one not in states)
    place = {state: n for n, state in enumerate(states)}
    steps = np.zeros((len(states), len(states)), dtype=bool)
    for state, following in reached.items():
        steps[place[state], [place[one] for one in following]] = True
    least = {"merge": 2, "unordered": 2}.get(kind, 1)
    needed = [
        0
        if (group in _FREE | {"where"} and not (kind in _NAMED and group == "name"))
        or (group == "amount" and kind in ("translate", "rotate"))
        else least
        for group in groups
    ]
    ends = [all(had >= need for had, need in zip(s[1], needed, strict=True)) for s in states]
    tags = np.array([s[0] for s in states])
    share = (1 / np.bincount(tags)[tags]).astype(np.float32)
    return Ways(tags, steps, steps[0], np.array(ends), share)


def _next(
    state: _State, slots: tuple[str, ...], groups: tuple[str, ...], kind: str
) -> Iterator[_State]:
    tag, had = state
    yield 0, had
    if tag:
        yield 2 * ((tag - 1) // 2) + 2, had
    for slot in slots:
        at = groups.index("where" if slot in _PLACED else slot)
        if kind in _MANY or not had[at]:
            more = (*had[:at], min(had[at] + 1, 2), *had[at + 1 :])
            yield TAGS.index(f"B-{slot}"), more


@lru_cache(maxsize=128)
def _steps(kind: str, known: Chain) -> tuple[NDArray[np.float32], NDArray[np.float64]]:
    """Return what each way from one state to the next counts, as logarithm and as factor."""
    ways = ways_of(kind)
    steps = np.where(ways.steps, known.steps[np.ix_(ways.tags, ways.tags)], np.float32(_NEVER))
    return steps, np.exp(steps.astype(np.float64))


def seconded(words: Words, listening: Listening, language: str, known: Chain) -> Seen | None:
    """Return what a chain's net sees of a clause, spelling repaired; None without a net."""
    if known.net is None:
        return None
    told = [(word.broken, not word.said, word.text[:1].isdigit()) for word in words]
    marks = np.array(told, dtype=np.float32)
    texts = [word.text for word in words]
    return seen_by(texts, marks, listening.asked, listening.stage, known.net, language)


def tagging(traits: Hashes, kind: str, known: Chain, seen: Seen | None = None) -> Tagging | None:
    """Return the likeliest slots of a kind of act in a clause; None if they cannot be told.

    Parameters
    ----------
    seen : Seen, optional
        What the net sees of the clause, see `seconded`.
    """
    if not TAKES.get(kind) or not len(traits):
        return Tagging((), 1.0)
    ways = ways_of(kind)
    told = np.take(known.weights, rows(traits, kind), axis=0)
    emitted = (np.ones(told.shape[1], np.float32) @ told)[:, ways.tags]
    if seen is not None and known.net is not None:
        second = tag_scores(seen, kind, known.net)[:, ways.tags]
        top = second.max(axis=1, keepdims=True)
        emitted += _SECOND * (second - top - np.log(_once(np.exp(second - top), ways)))
    steps, factors = _steps(kind, known)
    best = np.where(ways.begins, emitted[0], _NEVER)
    back: list[NDArray[np.int64]] = []
    for score in emitted[1:]:
        routes = best[:, None] + steps
        back.append(routes.argmax(axis=0))
        best = routes.max(axis=0) + score
    best = np.where(ways.ends, best, _NEVER)
    at = int(best.argmax())
    if best[at] < _NEVER / 2:
        return None
    path = [at]
    for came in reversed(back):
        path.append(int(came[path[-1]]))
    likely = float(best[at]) - _all_together(emitted, ways, factors)
    tags = [TAGS[ways.tags[one]] for one in reversed(path)]
    return Tagging(spans_of_tags(tags), math.exp(min(likely, 0.0)))


def _once(odds: Scores, ways: Ways) -> Scores:
    """Return the sums over tags, of which several states may share one."""
    return np.asarray((odds * ways.share).sum(axis=1, keepdims=True))


def _all_together(emitted: NDArray[np.float32], ways: Ways, factors: NDArray[np.float64]) -> float:
    """Return the logarithm of what all ways over the words count together."""
    tops = emitted.max(axis=1, keepdims=True).astype(np.float64)
    odds = np.exp(emitted - tops)
    total, scaled = odds[0] * ways.begins, float(tops.sum())
    for one in odds[1:]:
        total = total @ factors * one
        whole = float(total.sum())
        total, scaled = total / whole, scaled + math.log(whole)
    return scaled + math.log(float(total @ ways.ends))


def spans_of_tags(tags: list[str]) -> Tagged:
    """Return the stretches that tags mark."""
    found: list[tuple[str, int, int]] = []
    for at, tag in enumerate(tags):
        if tag.startswith("B-"):
            found.append((tag[2:], at, at + 1))
        elif tag.startswith("I-") and found:
            slot, start, _ = found[-1]
            found[-1] = (slot, start, at + 1)
    return tuple(found)


def tags_of_spans(spans: Tagged, size: int) -> list[int]:
    """Return the tags that mark stretches."""
    tags = [0] * size
    for slot, start, end in spans:
        for at in range(start, end):
            tags[at] = TAGS.index(f"{'B' if at == start else 'I'}-{slot}")
    return tags


def unparted(spans: Tagged, words: Words, joints: Collection[str]) -> bool:
    """Tell steps between which no mark and no joining word stands: "push the box to the line"."""
    return any(
        not any(word.broken for word in words[end : start + 1])
        and not any(word.text in joints for word in words[end:start])
        for (_, _, end), (_, start, _) in pairwise(spans)
    )
