"""What the robot should ask after cutting and assigning, instead of forcing an answer."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from types import MappingProxyType

from assistant.learning.candidates import Evidence
from assistant.learning.character import character
from assistant.model.demonstration import Demonstration
from assistant.model.lesson import Episode, Question, SegmentationPoint
from assistant.model.task import Primitive, Task, primitives

UNSURE = 0.6
"""The robot asks if its confidence that all cuts are right lies below.

Between asking about every lesson that went wrong and about none that went right; the curve is
printed by `tests.benchmarks.bench_confidence`.
"""

LEFT_OUT = 0.15
"""A step that is more likely than this never shown is asked about, though a part may be it.

What was introduced is seldom left out; but who forgets a step has to be told.
"""

UNHEARD = 0.08
"""A step that nobody introduced, though all of it was taken for others, is asked about from this
chance on.
"""

RIVAL = 0.3
"""Of the likeliest's chance: what is so likely, too, is asked about with it, as nobody can tell."""

DOUBTED = "doubtfully_shown"
"""Why a step is asked about that a part is assigned to: it may never have been shown."""


def questions(
    task: Task,
    demonstration: Demonstration,
    evidence: Evidence,
    points: tuple[SegmentationPoint, ...],
    episodes: tuple[Episode, ...],
    all_right: float = 1.0,
    left_out: Mapping[str, float] = MappingProxyType({}),
    unheard: Sequence[tuple[float, float, float]] = (),
) -> tuple[Question, ...]:
    """Return the questions in the order in which they should be asked.

    Parameters
    ----------
    task : Task
    demonstration : Demonstration
    evidence : Evidence
    points : tuple of SegmentationPoint
    episodes : tuple of Episode
    all_right : float
        Probability that all cuts are right.
    left_out : mapping of str to float
        Probabilities that primitives were never shown, though episodes are assigned to them.
    unheard : sequence of (float, float, float)
        From when to when, in s, steps nobody introduced may lie, and how likely they do; it may
        be that every episode is assigned to a primitive. The likeliest first.
    """
    leaves = primitives(task.tree)
    seen = {episode.primitive for episode in episodes}
    doubted = _doubted(leaves, left_out)
    counts: dict[str, object] = {"introduced": len(leaves), "shown": len(episodes)}
    found = [
        _ask("missing_step", leaf.name, "never_shown", counts)
        for leaf in leaves
        if leaf.name not in seen and not leaf.optional
    ]
    found += [
        _ask("confirm_segmentation", e.primitive, DOUBTED, {"from_s": e.from_s, "to_s": e.to_s})
        for e in episodes
        if e.primitive in doubted
    ]
    unnamed = [(e.from_s, e.to_s, e.character) for e in episodes if e.primitive is None]
    unnamed += [
        (from_s, to_s, character(evidence.smoothed, from_s, to_s))
        for from_s, to_s in _unheard(unheard)
        if not any(a < 0.5 * (from_s + to_s) < b for a, b, _ in unnamed)
    ]
    found += [
        _ask(
            "missing_step",
            "",
            "never_introduced",
            {**counts, "from_s": from_s, "to_s": to_s, "character": told},
        )
        for from_s, to_s, told in unnamed
    ]
    if all_right < UNSURE:
        found += _unsure(points, episodes)
    found += _hand(demonstration, evidence)
    found += [
        _ask("confirm_segmentation", "", "gap", {"from_s": a, "to_s": b})
        for a, b in evidence.smoothed.gaps_s
    ]
    return tuple(found)


def _doubted(leaves: Sequence[Primitive], left_out: Mapping[str, float]) -> set[str]:
    """Return the primitives that may have been left out; which of like ones, nobody can tell."""
    chances = {leaf.name: left_out.get(leaf.name, 0.0) for leaf in leaves if not leaf.optional}
    least = max(LEFT_OUT, RIVAL * max(chances.values(), default=0.0))
    return {name for name, chance in chances.items() if chance > least}


def _unheard(places: Sequence[tuple[float, float, float]]) -> list[tuple[float, float]]:
    """Return where a step may lie that nobody introduced; in which of like places, is unknown."""
    least = max(UNHEARD, RIVAL * max((chance for _, _, chance in places), default=0.0))
    return [(from_s, to_s) for from_s, to_s, chance in places if chance > least]


def _unsure(points: tuple[SegmentationPoint, ...], episodes: tuple[Episode, ...]) -> list[Question]:
    """Ask about the least sure cuts, as many as are likely wrong."""
    cuts = [point for point in points if point.kept and not point.internal]
    wrong = max(round(sum(1.0 - cut.confidence for cut in cuts)), 1)
    least = sorted(cut.confidence for cut in cuts)[:wrong]
    return [
        _ask(
            "confirm_segmentation",
            before.primitive or "",
            "unsure_cut",
            {"at_s": cut.at_s, "confidence": cut.confidence, "next": after.primitive or ""},
        )
        for cut, before, after in zip(cuts, episodes[:-1], episodes[1:], strict=False)
        if cut.confidence <= least[-1]
    ]


def _hand(demonstration: Demonstration, evidence: Evidence) -> list[Question]:
    if demonstration.recording.gripper_m is None:
        return [_ask("confirm_segmentation", "hand", "no_gripper", {})]
    if evidence.events and evidence.events[-1].kind == "close":
        at_s = evidence.events[-1].at_s
        return [_ask("missing_step", "hand", "ends_holding", {"closed_s": at_s})]
    return []


def _ask(asked: str, about: str, reason: str, facts: dict[str, object]) -> Question:
    return Question(asked, about, reason, MappingProxyType(facts))
