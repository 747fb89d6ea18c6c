"""Why, how, and show: answers from the lesson's own data."""

from __future__ import annotations

import re
from dataclasses import replace
from typing import Any

from assistant.dialogue.agreeing import disagreement
from assistant.dialogue.asking import PRACTICE, index_of, places, question, tell
from assistant.dialogue.conditions import expected, plain_conditions
from assistant.dialogue.correcting import plain_feedback, speed_of
from assistant.dialogue.directions import direction_of
from assistant.dialogue.finding import find
from assistant.dialogue.reporting import refusal_line
from assistant.dialogue.reviewing import read_back
from assistant.dialogue.state import Dialogue, Knowledge, Pending, Reviewing
from assistant.dialogue.turn import Turn, line, node_or_blank, plain_action, plain_tree
from assistant.language.hints import hints, matter, mentions
from assistant.model.feedback import Feedback
from assistant.model.lesson import Episode, Lesson, SegmentationPoint
from assistant.model.robot_acts import About, RobotAct
from assistant.model.task import primitives
from assistant.model.teacher_acts import Again, Explain, Show


def explain(dialogue: Dialogue, act: Explain) -> Turn:
    """Answer a why or how question."""
    topic = matter(act.text, "explain", dialogue.language)
    lesson = dialogue.known.lesson
    named = _named(dialogue, act.text)
    told: RobotAct | None = None
    if topic == "refusal" and dialogue.refusal is not None:
        told = refusal_line("explain", dialogue.refusal)
    elif topic == "agreement":
        told = disagreement(dialogue) or line("explain", "agreed")
    elif topic == "pace" and not named:
        told = _pace(dialogue)
    elif topic == "now":
        told = _now(dialogue)
    elif topic == "next":
        told = _next(dialogue)
    elif topic == "detour" and dialogue.run is not None and dialogue.run.note:
        told = line("explain", "detour", note=dialogue.run.note)
    elif topic == "stop" and dialogue.arm in ("stopped", "paused"):
        told = _why_halted(dialogue)
    elif (
        topic == "learned"
        and lesson is None
        and mentions(act.text, hints("questions", dialogue.language))
    ):
        told = line("error", "nothing_learned")
    elif lesson is not None:
        told = _from_lesson(dialogue, lesson, topic, named, act.text)
    return tell(dialogue, told or _why_asked(dialogue))


def _from_lesson(
    dialogue: Dialogue, lesson: Lesson, topic: str, named: str, text: str
) -> RobotAct | None:
    if topic == "sure":
        return _how_sure(lesson)
    if topic == "cut":
        return _cut(dialogue, lesson, named, text)
    if topic in ("assignment", "refusal") or named:
        return _assignment(dialogue, lesson, named, text)
    if topic == "learned":
        return _summary(dialogue, lesson)
    return None


def _named(dialogue: Dialogue, text: str) -> str:
    """Return the name of the primitive a question mentions; empty if none."""
    lowered = text.lower()
    leaves = [leaf.name for leaf in primitives(dialogue.known.task.tree)]
    inside = [name for name in leaves if name.lower() in lowered]
    if inside:
        return max(inside, key=len)
    index = find(dialogue.known, text)
    name = node_or_blank(dialogue.known.root, index).name if index else ""
    return name if name in leaves else ""


def _number(text: str) -> float | None:
    found = re.search(r"\d+(?:\.\d+)?", text)
    return float(found.group()) if found else None


def _ordinal(dialogue: Dialogue, text: str) -> int | None:
    ordinals: dict[str, int] = hints("ordinals", dialogue.language)
    found = (ordinals[word] for word in re.findall(r"[^\W\d_]+", text.lower()) if word in ordinals)
    return next(found, None)


def _cut(dialogue: Dialogue, lesson: Lesson, named: str, text: str) -> RobotAct:
    points = [point for point in lesson.segmentation.points if point.kept]
    at_s = _number(text)
    if named:
        ends = [one.to_s for one in lesson.segmentation.episodes if one.primitive == named]
        at_s = ends[-1] if ends else at_s
    if not points:
        return line("explain", "no_cuts")
    if at_s is None:
        cuts = [_point(point) for point in points if not point.internal]
        return line("explain", "cuts", cuts=cuts, count=len(cuts))
    wanted = at_s
    nearest = min(points, key=lambda point: abs(point.at_s - wanted))
    return line("explain", "cut", about=_about(dialogue, named), **_point(nearest))


def _point(point: SegmentationPoint) -> dict[str, Any]:
    voters = sorted(point.votes, key=lambda name: -point.votes[name])
    return {
        "at_s": round(point.at_s, 2),
        "confidence": round(point.confidence, 2),
        "signals": [name for name in voters if point.votes[name] > 0.01],
    }


def _about(dialogue: Dialogue, name: str) -> About | None:
    return About(name, index_of(dialogue.known, name)) if name else None


def _assignment(dialogue: Dialogue, lesson: Lesson, named: str, text: str) -> RobotAct | None:
    episodes = lesson.segmentation.episodes
    number = _number(text) or _ordinal(dialogue, text)
    chosen = [(at, one) for at, one in enumerate(episodes, 1) if named and one.primitive == named]
    if not chosen and number is not None and 1 <= number <= len(episodes):
        chosen = [(int(number), episodes[int(number) - 1])]
    if not chosen:
        return line("explain", "never_seen", name=named) if named else None
    at, one = max(chosen, key=lambda pair: pair[1].to_s - pair[1].from_s)
    return line("explain", "assignment", about=_about(dialogue, named), **_episode(at, one))


def _episode(at: int, one: Episode) -> dict[str, Any]:
    return {
        "episode": at,
        "name": one.primitive or "",
        "from_s": round(one.from_s, 1),
        "to_s": round(one.to_s, 1),
        "character": one.character,
        "probability": round(one.probability, 2),
    }


def _how_sure(lesson: Lesson) -> RobotAct:
    cuts = [point for point in lesson.segmentation.points if point.kept and not point.internal]
    episodes = lesson.segmentation.episodes
    weakest = min(cuts, key=lambda point: point.confidence, default=None)
    least = min(episodes, key=lambda one: one.probability, default=None)
    if weakest is None or least is None:
        return line("explain", "no_cuts")
    return line(
        "explain",
        "sure",
        at_s=round(weakest.at_s, 1),
        confidence=round(weakest.confidence, 2),
        name=least.primitive or "",
        probability=round(least.probability, 2),
    )


def _summary(dialogue: Dialogue, lesson: Lesson) -> RobotAct:
    return line(
        "explain",
        "learned",
        task=dialogue.known.name,
        count=len(primitives(dialogue.known.task.tree)),
        cuts=len(lesson.segmentation.cuts_s),
        things=list(dict.fromkeys(station.frame for station in lesson.stations)),
        corrections=len(lesson.feedback),
    )
