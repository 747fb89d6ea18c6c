"""What `learn` and `demo` tell of a lesson, for programs and for people."""

from __future__ import annotations

from typing import Any

from assistant.errors import WorkFailed
from assistant.model.lesson import Episode, Lesson, Question, SegmentationPoint, Station
from assistant.model.task import Task, walk


def learn_values(task: Task) -> dict[str, Any]:
    """Return the fields of `learn` but its time; the task must have been learned.

    Raises
    ------
    WorkFailed
        If it has not.
    """
    lesson = task.learned
    if lesson is None:
        raise WorkFailed(f"{task.name!r} has not been learned yet; demonstrate it first")
    found = lesson.segmentation
    return {
        "segmentation_points_s": [round(at, 6) for at in found.cuts_s],
        "episodes": [_episode(one) for one in found.episodes],
        "points": [_point(one) for one in found.points],
        "cue_lag_s": found.cue_lag_s,
        "docking": docking_values(lesson),
        "questions": [
            {"asked": one.asked, "about": one.about, "text": question_text(task, one)}
            for one in found.questions
        ],
    }


def docking_values(lesson: Lesson) -> list[dict[str, Any]] | None:
    """Return each grasp and release with its docking pose; None if the hand is unknown."""
    if lesson.path is None:
        return None
    return [_docking(one, lesson.path.t_s.tolist()) for one in lesson.stations]


def question_text(task: Task, question: Question) -> str:
    """Return the robot's sentence for a question of learning."""
    from assistant.language.speech import phrase
    from assistant.model.robot_acts import About, RobotAct, RobotActName

    confirms = ("confirm_segmentation", "optional", "order")
    act: RobotActName = "confirm" if question.asked in confirms else "ask"
    index = next((at for at, node in walk(task.tree) if at and node.name == question.about), ())
    slots = {**question.facts, "name": question.about}
    topic = f"{question.asked}.{question.reason}"
    return phrase(RobotAct(act, topic, None, About(question.about, index), slots))


def tell_lesson(task: Task, wall_s: float) -> None:
    """Print what was learned, for people."""
    from assistant.shells.telling import terminal, view

    console = terminal()
    console.print(view(task))
    for question in task.learned.segmentation.questions if task.learned else ():
        console.print(f"I would ask: {question_text(task, question)}", markup=False)
    console.print(f"learned in {wall_s:.3f} s")


def _episode(one: Episode) -> dict[str, Any]:
    return {
        "from_s": round(one.from_s, 6),
        "to_s": round(one.to_s, 6),
        "primitive": one.primitive,
        "probability": round(one.probability, 6),
    }


def _point(one: SegmentationPoint) -> dict[str, Any]:
    return {
        "at_s": round(one.at_s, 6),
        "confidence": round(one.confidence, 6),
        "votes": {name: round(float(vote), 6) for name, vote in one.votes.items()},
        "kept": one.kept,
        "internal": one.internal,
    }


def _docking(station: Station, t_s: list[float]) -> dict[str, Any]:
    return {
        "kind": station.kind,
        "object": station.object,
        "frame": station.frame,
        "primitive": station.primitive,
        "at_s": round(t_s[station.at], 6),
        "docking_at_s": round(t_s[station.docking_at], 6),
        "hand_in_frame": station.hand_in_frame.tolist(),
        "docking_in_frame": station.docking_in_frame.tolist(),
    }
