"""What may be seen of the dialogue from outside: plain values by dotted paths."""

from __future__ import annotations

from dataclasses import asdict, replace
from typing import Any

from assistant.dialogue.asking import PRACTICE, places, question, stage
from assistant.dialogue.correcting import plain_feedback, speed_of
from assistant.dialogue.knowledge import Knowledge
from assistant.dialogue.runs import RunResult
from assistant.dialogue.state import Dialogue
from assistant.dialogue.turn import plain_action, plain_condition, plain_tree
from assistant.model.lesson import Lesson
from assistant.model.task import primitives

EPISODE = ("from_s", "to_s", "primitive", "probability", "character")
POINT = ("at_s", "confidence", "kept", "internal")
STATION = ("kind", "object", "frame")


def public_view(dialogue: Dialogue) -> dict[str, Any]:
    """Return plain values for transcripts' ``expect``, programs and status lines.

    ``stage``, ``asked``, ``step_shown`` (the one shown again), ``task.{name, goal, objects, tree,
    primitives}``, ``lesson.{cuts_s, episodes, points, questions, cue_lag_s, stations}``,
    ``feedback``, ``speed``, ``pace``, ``setup``, ``motion`` (rest, checking, moving, paused,
    stopped), ``at`` (the primitive being carried out), ``refused``, ``runs``, ``agreed``,
    ``saved``, ``unsaved``, ``undo``, ``redo``.
    """
    known = dialogue.known
    asked = question(dialogue)
    return {
        "stage": stage(dialogue),
        "asked": asked.asked if asked is not None else None,
        "state": type(dialogue.state).__name__.lower(),
        "step_shown": getattr(dialogue.state, "step", ""),
        "task": _task(known),
        "primitives": [leaf.name for leaf in primitives(known.task.tree)],
        "demonstrations": len(known.demonstrations),
        "lesson": _lesson(known.lesson) if known.lesson is not None else None,
        "feedback": _feedback(known),
        "speed": round(speed_of(known), 6),
        "facing": known.facing,
        **_practice(dialogue),
        "saved": list(dialogue.saved),
        "saved_as": dialogue.saved_as,
        "unsaved": dialogue.unsaved,
        "brief": dialogue.brief,
        "undo": dialogue.past[-1].label if dialogue.past else None,
        "redo": dialogue.future[-1].label if dialogue.future else None,
    }


def _practice(dialogue: Dialogue) -> dict[str, object]:
    known, refusal = dialogue.known, dialogue.refusal
    return {
        "pace": dialogue.pace,
        "pace_factor": PRACTICE.slow if dialogue.pace == "slow" else PRACTICE.normal,
        "setup": {"name": known.setup.name, "places": places(known)},
        "motion": dialogue.arm,
        "at": _at(dialogue),
        "refused": str(refusal) if refusal is not None else None,
        "runs": [_run(one) for one in dialogue.runs],
        "agreed": dialogue.agreed,
    }


def _feedback(known: Knowledge) -> list[dict[str, Any]]:
    return [plain_feedback(one) for one in known.lesson.feedback] if known.lesson else []


def _task(known: Knowledge) -> dict[str, Any]:
    leaves = primitives(known.task.tree)
    return {
        "name": known.name,
        "goal": known.goal,
        "objects": {one.name: one.role for one in known.objects or ()},
        "tree": plain_tree(replace(known.root, name=known.root.name or known.name)),
        "primitives": [
            {
                "name": leaf.name,
                "action": plain_action(leaf.action),
                "optional": leaf.optional,
                "before": [plain_condition(one) for one in leaf.before],
                "until": [plain_condition(one) for one in leaf.until],
            }
            for leaf in leaves
        ],
        "confirmed": known.tree_confirmed,
    }


def _lesson(lesson: Lesson) -> dict[str, Any]:
    found = lesson.segmentation
    return {
        "cuts_s": [round(at_s, 4) for at_s in found.cuts_s],
        "cue_lag_s": found.cue_lag_s,
        "episodes": [_slots(one, EPISODE) for one in found.episodes],
        "questions": [{"asked": one.asked, "about": one.about} for one in found.questions],
        "points": [_slots(one, POINT) for one in found.points],
        "stations": [_slots(one, STATION) for one in lesson.stations],
        "path": lesson.path is not None,
    }


def _slots(value: object, names: tuple[str, ...]) -> dict[str, Any]:
    return {name: getattr(value, name) for name in names}


def _at(dialogue: Dialogue) -> str | None:
    run = dialogue.run
    leaves = primitives(dialogue.known.task.tree)
    if run is None or dialogue.arm in ("rest", "homing") or not 0 <= run.primitive_at < len(leaves):
        return None
    return leaves[run.primitive_at].name


def _run(result: RunResult) -> dict[str, Any]:
    return {
        "setup": result.setup.name,
        "pace": result.pace,
        "corrected": result.corrected,
        "complete": result.complete,
        "missing": list(result.missing),
        "alignments": [asdict(one) for one in result.alignments],
        "measures": [asdict(one) for one in result.measures],
    }
