"""The ``learned`` section of task/1: a `Lesson` from its form, and back to plain values."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np

from assistant.errors import BadInput
from assistant.files.lesson_forms import PATH_COLUMNS, LearnedForm, PathForm, StationForm
from assistant.files.lesson_problems import lesson_problems
from assistant.files.tree_forms import conditions_of, conditions_values
from assistant.geometry import Array
from assistant.model.feedback import Feedback
from assistant.model.lesson import (
    Episode,
    LearnedPath,
    Lesson,
    Question,
    Segmentation,
    SegmentationPoint,
    Station,
)
from assistant.plain_yaml import Document, tidy


def lesson_of(form: LearnedForm, document: Document, leaves: int) -> Lesson:
    """Return the lesson a form tells.

    Parameters
    ----------
    form : LearnedForm
    document : Document
        For messages.
    leaves : int
        Primitives of the tree.

    Raises
    ------
    BadInput
        With all that does not fit together.
    """
    problems = lesson_problems(form, document, leaves)
    if problems:
        raise BadInput(problems)
    conditions = form.conditions.items()
    return Lesson(
        segmentation=_segmentation(form),
        path=None if form.path is None else _path(form.path),
        stations=tuple(_station(each) for each in form.docking),
        before={name: conditions_of(each.before) for name, each in conditions if each.before},
        until={name: conditions_of(each.until) for name, each in conditions if each.until},
        sources=form.demonstrations,
        feedback=tuple(Feedback(**each.model_dump()) for each in form.feedback),
        speed=form.speed,
        approach_axis=form.approach_axis,
        jerk_m_s3=form.jerk_m_s3,
    )


def _segmentation(form: LearnedForm) -> Segmentation:
    votes = form.votes
    names = () if votes is None else votes.columns[2:]
    curves = np.zeros((0, 2)) if votes is None else _table(votes.rows, len(votes.columns))
    return Segmentation(
        points=tuple(SegmentationPoint(**each.model_dump()) for each in form.points),
        episodes=tuple(Episode(**each.model_dump()) for each in form.episodes),
        cue_lag_s=form.cue_lag_s,
        questions=tuple(
            Question(each.asked, each.about, each.reason, _frozen(each.facts))
            for each in form.questions
        ),
        vote_t_s=curves[:, 0],
        vote=curves[:, 1],
        signal_votes={name: curves[:, 2 + at] for at, name in enumerate(names)},
    )


def _frozen(value: Any) -> Any:
    """Return plain values with tuples for lists, as values of the model have them."""
    if isinstance(value, Mapping):
        return {key: _frozen(part) for key, part in value.items()}
    return tuple(_frozen(part) for part in value) if isinstance(value, list) else value


def _path(form: PathForm) -> LearnedPath:
    table = _table(form.rows, len(form.columns))
    gripper = table[:, 8] if "gripper_m" in form.columns else None
    return LearnedPath(table[:, 0], table[:, 1:8], gripper, table[:, -1].astype(np.int64))


def _table(rows: Sequence[Sequence[float]], columns: int) -> Array:
    return np.array(rows, dtype=float).reshape(len(rows), columns)


def _station(form: StationForm) -> Station:
    values = form.model_dump()
    for name in ("frame_to_world", "hand_in_frame", "docking_in_frame"):
        values[name] = np.array(values[name])
    return Station(**values)


def learned_values(lesson: Lesson) -> dict[str, Any]:
    """Return a lesson as plain values."""
    cuts = lesson.segmentation
    values: dict[str, Any] = {
        "demonstrations": list(lesson.sources),
        "approach_axis": lesson.approach_axis,
        "speed": tidy(lesson.speed),
        "jerk_m_s3": lesson.jerk_m_s3 or None,
        "cue_lag_s": cuts.cue_lag_s,
        "points": [_point_values(each) for each in cuts.points],
        "episodes": [_episode_values(each) for each in cuts.episodes],
        "questions": [_question_values(each) for each in cuts.questions],
        "conditions": _conditions_values(lesson),
        "docking": [_station_values(each) for each in lesson.stations],
        "feedback": [_feedback_values(each) for each in lesson.feedback],
        "path": None if lesson.path is None else _path_values(lesson.path),
        "votes": _curves_values(cuts) if len(cuts.vote_t_s) else None,
    }
    return {key: value for key, value in values.items() if value not in (None, [], {})}


def _point_values(point: SegmentationPoint) -> dict[str, Any]:
    values: dict[str, Any] = {"at_s": _exact(point.at_s), "confidence": _exact(point.confidence)}
    if point.votes:
        values["votes"] = {name: _exact(vote) for name, vote in point.votes.items()}
    if not point.kept:
        values["kept"] = False
    return {**values, "internal": True} if point.internal else values


def _episode_values(episode: Episode) -> dict[str, Any]:
    values: dict[str, Any] = {
        "from_s": _exact(episode.from_s),
        "to_s": _exact(episode.to_s),
        "primitive": episode.primitive,
        "probability": _exact(episode.probability),
    }
    return {**values, "character": episode.character} if episode.character else values


def _question_values(question: Question) -> dict[str, Any]:
    values: dict[str, Any] = {
        "asked": question.asked,
        "about": question.about,
        "reason": question.reason,
    }
    return {**values, "facts": plain_facts(question.facts)} if question.facts else values


def plain_facts(value: Any) -> Any:
    """Return values of the model as plain values for a file; arrays become lists."""
    if isinstance(value, Mapping):
        return {str(key): plain_facts(part) for key, part in value.items()}
    if isinstance(value, np.ndarray | np.generic):
        return value.tolist()
    if isinstance(value, Sequence) and not isinstance(value, str):
        return [plain_facts(part) for part in value]
    return value


def _conditions_values(lesson: Lesson) -> dict[str, Any]:
    names = dict.fromkeys([*lesson.before, *lesson.until])
    told: dict[str, Any] = {}
    for name in names:
        pairs = (("before", lesson.before), ("until", lesson.until))
        kept = {key: conditions_values(which[name]) for key, which in pairs if which.get(name)}
        if kept:
            told[name] = kept
    return told


def _station_values(station: Station) -> dict[str, Any]:
    return {
        "kind": station.kind,
        "object": station.object,
        "frame": station.frame,
        "primitive": station.primitive,
        "at": int(station.at),
        "docking_at": int(station.docking_at),
        "left_at": int(station.left_at),
        "frame_to_world": _row(station.frame_to_world),
        "hand_in_frame": _row(station.hand_in_frame),
        "docking_in_frame": _row(station.docking_in_frame),
    }


def _feedback_values(feedback: Feedback) -> dict[str, Any]:
    plain = Feedback(feedback.kind, feedback.words)
    values: dict[str, Any] = {"kind": feedback.kind, "words": feedback.words}
    for name in ("primitive", "when", "frame", "offset_m", "turn_rad", "factor", "hand"):
        value = getattr(feedback, name)
        if value != getattr(plain, name):
            values[name] = _row(value) if isinstance(value, tuple) else value
    return values


def _path_values(path: LearnedPath) -> dict[str, Any]:
    columns = [path.t_s[:, None], path.path]
    names = list(PATH_COLUMNS)
    if path.gripper_m is not None:
        columns.append(path.gripper_m[:, None])
        names.append("gripper_m")
    numbers = np.concatenate(columns, axis=1).tolist()
    leaves = path.primitive_at.tolist()
    rows = [[*map(tidy, row), leaf] for row, leaf in zip(numbers, leaves, strict=True)]
    return {"columns": [*names, "primitive"], "rows": rows}


def _curves_values(cuts: Segmentation) -> dict[str, Any]:
    curves = [cuts.vote_t_s, cuts.vote, *cuts.signal_votes.values()]
    rows = np.stack([np.asarray(curve, dtype=float) for curve in curves], axis=1).tolist()
    return {
        "columns": ["t_s", "vote", *cuts.signal_votes],
        "rows": [[tidy(value) for value in row] for row in rows],
    }


def _row(values: Sequence[float] | Array) -> list[float | int]:
    return [tidy(float(value)) for value in values]


def _exact(value: float) -> float | int:
    return tidy(float(value))
