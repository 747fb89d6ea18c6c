"""What is known, told on request: the plan, the cuts, the path, corrections, where things are."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

from assistant.dialogue.asking import PRACTICE, places, tell
from assistant.dialogue.conditions import expected, plain_conditions
from assistant.dialogue.correcting import plain_feedback, speed_of
from assistant.dialogue.directions import direction_of
from assistant.dialogue.knowledge import Knowledge
from assistant.dialogue.reviewing import read_back
from assistant.dialogue.state import Dialogue, Pending, Reviewing
from assistant.dialogue.turn import Turn, line, plain_action, plain_tree
from assistant.model.feedback import Feedback
from assistant.model.lesson import Lesson
from assistant.model.robot_acts import About, RobotAct
from assistant.model.task import primitives
from assistant.model.teacher_acts import Again, Show


def show(dialogue: Dialogue, act: Show) -> Turn:
    """Tell what is known of one matter."""
    lesson = dialogue.known.lesson
    match act.what:
        case "tree":
            told = _tree(dialogue)
        case "setup":
            where = places(dialogue.known)
            told = line("told", "setup", setup=dialogue.known.setup.name, places=where)
        case "lessons":
            topic = "lessons" if dialogue.saved else "no_lessons"
            told = line("told", topic, names=list(dialogue.saved))
        case "corrections":
            told = _corrections(dialogue.known)
        case "plan" | "conditions":
            told = _plan(dialogue, act.what)
        case _ if lesson is None:
            told = line("error", "nothing_learned")
        case "segmentation":
            told = replace(read_back(dialogue.known), act="told")
        case "trajectory":
            told = _trajectory(lesson)
            if isinstance(dialogue.state, Reviewing) and lesson.path is not None:
                question = line("ask", "replay_now", asked="ready")
                pending = Pending("ready", question, (Again(),))
                return tell(replace(dialogue, pending=pending), told)
    return tell(dialogue, told)


def _tree(dialogue: Dialogue) -> RobotAct:
    known = dialogue.known
    if not known.root.parts:
        return line("told", "no_tree")
    tree = plain_tree(replace(known.root, name=known.name))
    return line("told", "tree", about=About(known.name), tree=tree)


def _corrections(known: Knowledge) -> RobotAct:
    given = plain_corrections(known)
    topic = "corrections" if given else "no_corrections"
    return line("told", topic, corrections=given, count=len(given))


def plain_corrections(known: Knowledge) -> list[dict[str, Any]]:
    """Return the corrections that stand as plain values."""
    return [_correction(known, one) for one in known.lesson.feedback] if known.lesson else []


def _correction(known: Knowledge, feedback: Feedback) -> dict[str, Any]:
    """Return a correction as plain values, with the teacher's word for where it goes."""
    told = plain_feedback(feedback)
    goes = feedback.kind in ("translate", "rotate")
    return told | ({"direction": direction_of(known, feedback)} if goes else {})


def _plan(dialogue: Dialogue, what: str) -> RobotAct:
    known = dialogue.known
    steps = []
    for leaf in primitives(known.task.tree):
        before, until = expected(known, leaf)
        steps.append(
            {
                "name": leaf.name,
                "action": plain_action(leaf.action),
                "before": plain_conditions(before),
                "until": plain_conditions(until),
            }
        )
    pace = PRACTICE.slow if dialogue.pace == "slow" else PRACTICE.normal
    return line("told", what if steps else "no_tree", steps=steps, speed=pace * speed_of(known))


def _trajectory(lesson: Lesson) -> RobotAct:
    path = lesson.path
    if path is None:
        return line("error", "no_path")
    duration = float(path.t_s[-1] - path.t_s[0])
    return line("told", "trajectory", duration_s=round(duration, 1), stations=len(lesson.stations))
