"""Why the demonstration is cut at an instant, or why it is not: signals, times, and how sure."""

from __future__ import annotations

import re
from collections.abc import Sequence
from typing import Any

from assistant.dialogue.asking import index_of
from assistant.dialogue.state import Dialogue
from assistant.dialogue.turn import line
from assistant.language.hints import hints
from assistant.model.lesson import Lesson, SegmentationPoint
from assistant.model.robot_acts import About, RobotAct

MEANT_S = 0.6
"""A cut so near to a time that a teacher tells is the one that is meant."""
LEAST_VOTE = 0.01


def why_cut(dialogue: Dialogue, lesson: Lesson, named: str, text: str) -> RobotAct:
    """Tell why there is a cut at a time or at the end of a step; without either, tell all cuts."""
    points = [point for point in lesson.segmentation.points if point.kept]
    cuts = [point for point in points if not point.internal]
    if not points:
        return line("explain", "no_cuts")
    at_s = told_s(text, dialogue.language)
    ends = [one.to_s for one in lesson.segmentation.episodes if named and one.primitive == named]
    number = _numbered(text, dialogue.language)
    if ends:
        at_s = ends[-1]
    elif at_s is None and number is not None and number <= len(cuts):
        at_s = cuts[number - 1].at_s
    if at_s is None:
        return line("explain", "cuts", cuts=[_told(point) for point in cuts], count=len(cuts))
    meant = _nearest(points, at_s)
    if not ends and abs(meant.at_s - at_s) > MEANT_S:
        return _why_not(lesson, cuts, at_s)
    about = About(named, index_of(dialogue.known, named)) if named else None
    return line("explain", "cut", about=about, **_told(meant))


def told_s(text: str, language: str) -> float | None:
    """Return the time a question tells, in s; None if it tells none."""
    found = re.search(r"\d+(?:[.,]\d+)?", text)
    if found:
        return float(found.group().replace(",", "."))
    numbers: dict[str, int] = hints("numbers", language)
    words = re.findall(r"[^\W\d_]+", text.lower())
    # "That one" is no time.
    return next((float(numbers[word]) for word in words if numbers.get(word, 0) > 1), None)


def _numbered(text: str, language: str) -> int | None:
    """Return which cut a question counts to, from 1; None if it counts none."""
    ordinals: dict[str, int] = hints("ordinals", language)
    words = re.findall(r"[^\W\d_]+", text.lower())
    return next((ordinals[word] for word in words if word in ordinals), None)


def _why_not(lesson: Lesson, cuts: Sequence[SegmentationPoint], at_s: float) -> RobotAct:
    """Tell that there is no cut at a time, where the nearest are, and what speaks for one there."""
    before = [round(point.at_s, 2) for point in cuts if point.at_s < at_s]
    after = [round(point.at_s, 2) for point in cuts if point.at_s >= at_s]
    slots: dict[str, Any] = {
        "at_s": at_s,
        "before_s": before[-1] if before else None,
        "after_s": after[0] if after else None,
    }
    away = [point for point in lesson.segmentation.points if not point.kept]
    told = [
        point for point in away if abs(point.at_s - at_s) <= MEANT_S and _told(point)["signals"]
    ]
    if not told:
        return line("explain", "no_cut_at", **slots)
    near = _nearest(told, at_s)
    return line("explain", "no_cut_though", **{**_told(near), **slots, "near_s": near.at_s})


def _nearest(points: Sequence[SegmentationPoint], at_s: float) -> SegmentationPoint:
    return min(points, key=lambda point: abs(point.at_s - at_s))


def _told(point: SegmentationPoint) -> dict[str, Any]:
    voters = sorted(point.votes, key=lambda name: -point.votes[name])
    return {
        "at_s": round(point.at_s, 2),
        "confidence": round(point.confidence, 2),
        "signals": [name for name in voters if point.votes[name] > LEAST_VOTE],
    }
