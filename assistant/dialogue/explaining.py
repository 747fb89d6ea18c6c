"""Why and how: answers from the lesson's own data."""

from __future__ import annotations

import re
from typing import Any

from assistant.dialogue.agreeing import disagreement
from assistant.dialogue.asking import index_of, tell
from assistant.dialogue.finding import find, spoken_of
from assistant.dialogue.reporting import refusal_line
from assistant.dialogue.state import Dialogue, Ran, Ready, Running
from assistant.dialogue.turn import Turn, line, node_or_blank
from assistant.dialogue.whereabouts import doing_next, doing_now, pace, why_asked, why_still
from assistant.dialogue.why_cut import why_cut
from assistant.language.hints import hints, matter, mentions
from assistant.model.lesson import Episode, Lesson
from assistant.model.robot_acts import About, RobotAct
from assistant.model.task import primitives
from assistant.model.teacher_acts import Explain

ACTS = {"grasp": "close", "release": "open"}
SAME_S = 0.05
"""An episode ends at a cut that is so near."""


def explain(dialogue: Dialogue, act: Explain) -> Turn:
    """Answer a why or how question."""
    topic = matter(act.text, "explain", dialogue.language)
    named = _named(dialogue, act.text)
    if not named and topic in ("sure", "cut", "assignment"):
        named = spoken_of(dialogue, act.text)
    told = _of_the_moment(dialogue, topic, named, act.text)
    lesson = dialogue.known.lesson
    if told is None and lesson is not None:
        told = _from_lesson(dialogue, lesson, topic, named, act.text)
    return tell(dialogue, told or why_asked(dialogue))


def _of_the_moment(dialogue: Dialogue, topic: str, named: str, text: str) -> RobotAct | None:
    """Answer what does not come from the lesson; None for the rest."""
    match topic:
        case "refusal" | "detour":
            return _way_taken(dialogue, topic, named)
        case "agreement":
            return disagreement(dialogue) or line("explain", "agreed")
        case "pace" if not named:
            return pace(dialogue)
        case "now":
            return doing_now(dialogue)
        case "next":
            return doing_next(dialogue)
        case "stop":
            return why_still(dialogue)
        case "learned" if dialogue.known.lesson is None:
            asked = mentions(text, hints("questions", dialogue.language))
            return line("error", "nothing_learned") if asked else None
        case _:
            return None


def _way_taken(dialogue: Dialogue, topic: str, named: str) -> RobotAct | None:
    """Tell why a run was refused, or went another way than shown; or that it was not."""
    if topic == "refusal" and dialogue.refusal is not None:
        return refusal_line("explain", dialogue.refusal)
    practicing = isinstance(dialogue.state, Ready | Ran | Running)
    if not practicing or named or dialogue.run is None:
        return None
    if topic == "refusal":
        return line("explain", "no_refusal")
    note = dialogue.run.note
    return line("explain", "detour", note=note) if note else line("explain", "no_detour")


def _from_lesson(
    dialogue: Dialogue, lesson: Lesson, topic: str, named: str, text: str
) -> RobotAct | None:
    if topic == "sure":
        return _how_sure_of(dialogue, lesson, named) if named else _how_sure(lesson)
    if topic == "cut":
        return why_cut(dialogue, lesson, named, text)
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
    slots = _episode(at, one) | {"event": _event(lesson, one.primitive)}
    return line("explain", "assignment", about=_about(dialogue, named), **slots)


def _event(lesson: Lesson, name: str | None) -> dict[str, str] | None:
    """Return what the hand did in a step, as an action in plain values; None if nothing."""
    did = [one for one in lesson.stations if one.primitive == name and one.kind in ACTS]
    return {"hand": ACTS[did[0].kind], "object": did[0].frame} if did else None


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


def _how_sure_of(dialogue: Dialogue, lesson: Lesson, name: str) -> RobotAct:
    """Tell how sure it is that a step was shown, and where it ends."""
    found = lesson.segmentation
    parts = [one for one in found.episodes if one.primitive == name]
    if not parts:
        return line("explain", "never_seen", name=name)
    last = parts[-1]
    ends = [one for one in found.points if one.kept and abs(one.at_s - last.to_s) < SAME_S]
    slots = _episode(found.episodes.index(last) + 1, last)
    slots["confidence"] = round(ends[0].confidence, 2) if ends else None
    return line("explain", "sure_of", about=_about(dialogue, name), **slots)


def _summary(dialogue: Dialogue, lesson: Lesson) -> RobotAct:
    return line(
        "explain",
        "learned",
        task=dialogue.known.name,
        count=len(primitives(dialogue.known.task.tree)),
        names=[leaf.name for leaf in primitives(dialogue.known.task.tree)],
        cuts=len(lesson.segmentation.cuts_s),
        things=list(dict.fromkeys(station.frame for station in lesson.stations)),
        corrections=len(lesson.feedback) or None,
    )
