"""Spoken corrections become feedback: how much, at which primitive, in which frame (III-D b).

Source: design, safety: steps of 5, 2, 15 mm and 3, 1, 10 degrees, speed by a fifth; steps
shrink when the teacher goes back and forth; large ones are read back first.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from assistant.dialogue.directions import (
    frame_quat,
    in_frame,
    move_in_world,
    station_of,
    turn_in_world,
)
from assistant.dialogue.knowledge import Knowledge
from assistant.model import teacher_acts as acts
from assistant.model.feedback import Feedback, When
from assistant.model.settings import SafetySettings

SAFETY = SafetySettings()
LEAST_STEP_M = 0.0005
LEAST_STEP_DEG = 0.25
SPEEDS = (0.1, 3.0)
"""Bounds of the whole task's speed as a factor of the demonstration's."""

Correction = acts.Translate | acts.Rotate | acts.AdjustSpeed | acts.Gripper


@dataclass(frozen=True, slots=True)
class Place:
    """The part of the task a correction belongs to."""

    primitive: str = ""
    when: When = "during"


def amount(act: Correction) -> float:
    """Return how far a correction goes before shrinking: m, degrees, or a factor."""
    match act:
        case acts.Translate():
            steps = (SAFETY.step_m, SAFETY.little_step_m, SAFETY.much_step_m)
            return abs(act.distance_m) if act.distance_m is not None else _step(act.degree, steps)
        case acts.Rotate():
            turns = (SAFETY.step_deg, SAFETY.little_step_deg, SAFETY.much_step_deg)
            return abs(act.angle_deg) if act.angle_deg is not None else _step(act.degree, turns)
        case acts.AdjustSpeed():
            return _speed_factor(act)
        case _:
            return 0.0


def _step(degree: acts.Degree | None, steps: tuple[float, float, float]) -> float:
    return steps[0] if degree is None else steps[1] if degree == "little" else steps[2]


def _speed_factor(act: acts.AdjustSpeed) -> float:
    if act.factor is not None and act.factor > 0:
        return act.factor
    step = SAFETY.speed_step
    step = {"little": step / 2, "much": step * 2}.get(act.degree or "", step)
    return 1.0 + step if act.change == "faster" else 1.0 - step


def too_much(act: Correction, *, by_voice: bool) -> bool:
    """Whether a correction is read back and asked about before it counts."""
    if isinstance(act, acts.Translate):
        told = act.distance_m is not None
        return amount(act) > SAFETY.confirm_beyond_m + 1e-12 or (told and by_voice)
    if isinstance(act, acts.Rotate):
        told = act.angle_deg is not None
        return amount(act) > SAFETY.confirm_beyond_deg + 1e-9 or (told and by_voice)
    return isinstance(act, acts.AdjustSpeed) and act.factor is not None and by_voice


def feedback_from(known: Knowledge, act: Correction, words: str, place: Place) -> Feedback:
    """Return a correction with its words, primitive and frame, its step shrunk if need be."""
    station = station_of(known, place.primitive)
    frame = station.frame if station else ""
    primitive = place.primitive or (station.primitive if station else "")
    made: dict[str, Any] = {"words": words, "primitive": primitive, "when": place.when}
    match act:
        case acts.Translate(direction):
            length = amount(act) * math.copysign(1.0, act.distance_m or 1.0)
            vector = length * move_in_world(direction, known.facing)
            offset = in_frame(known, station, vector)
            return _shrunk(known, Feedback("translate", frame=frame, offset_m=offset, **made), act)
        case acts.Rotate(direction):
            angle = math.radians(amount(act) * math.copysign(1.0, act.angle_deg or 1.0))
            axis = turn_in_world(direction, known.facing, frame_quat(known, station))
            turn = in_frame(known, station, angle * axis)
            return _shrunk(known, Feedback("rotate", frame=frame, turn_rad=turn, **made), act)
        case acts.AdjustSpeed():
            # Speed is the whole task's unless a primitive is named.
            return Feedback("speed", words, place.primitive, place.when, factor=amount(act))
        case acts.Gripper(command):
            return Feedback("hand", frame=frame, hand=command, **made)


def _shrunk(known: Knowledge, made: Feedback, act: acts.Translate | acts.Rotate) -> Feedback:
    """Halve a plain step that goes back against the last one, so that it does not swing."""
    exact = act.distance_m if isinstance(act, acts.Translate) else act.angle_deg
    last = _last_alike(known, made)
    if exact is not None or last is None:
        return made
    before, now = _vector(last), _vector(made)
    opposite = float(before @ now) < -0.9 * np.linalg.norm(before) * np.linalg.norm(now)
    bound = 0.5 * float(np.linalg.norm(before))
    least = LEAST_STEP_M if made.kind == "translate" else math.radians(LEAST_STEP_DEG)
    length = float(np.linalg.norm(now))
    if not opposite or length <= bound:
        return made
    return scaled(made, max(bound, min(least, length)) / length)


def _last_alike(known: Knowledge, made: Feedback) -> Feedback | None:
    given = known.lesson.feedback if known.lesson else ()
    same = (
        one
        for one in reversed(given)
        if (one.kind, one.frame, one.primitive) == (made.kind, made.frame, made.primitive)
    )
    return next(same, None)


def _vector(feedback: Feedback) -> Any:
    told = feedback.offset_m if feedback.kind == "translate" else feedback.turn_rad
    return np.array(told)


def scaled(feedback: Feedback, factor: float) -> Feedback:
    """Return a correction that goes `factor` times as far; negative turns it around."""
    dx, dy, dz = feedback.offset_m
    rx, ry, rz = feedback.turn_rad
    return replace(
        feedback,
        offset_m=(dx * factor, dy * factor, dz * factor),
        turn_rad=(rx * factor, ry * factor, rz * factor),
        factor=feedback.factor**factor,
    )


def parallel(one: Feedback, other: Feedback) -> bool:
    """Whether two corrections of one kind go along the same line, either way."""
    first, second = _vector(one), _vector(other)
    lengths = float(np.linalg.norm(first) * np.linalg.norm(second))
    return abs(float(first @ second)) > 0.9 * lengths


def summed(feedbacks: Sequence[Feedback]) -> Feedback:
    """Return one correction that goes as far as several of one kind and frame together."""
    offset = np.sum([one.offset_m for one in feedbacks], axis=0)
    turn = np.sum([one.turn_rad for one in feedbacks], axis=0)
    return replace(
        feedbacks[-1],
        offset_m=(float(offset[0]), float(offset[1]), float(offset[2])),
        turn_rad=(float(turn[0]), float(turn[1]), float(turn[2])),
    )


def size(feedback: Feedback) -> float:
    """Return how far a correction goes: mm, degrees or percent."""
    match feedback.kind:
        case "translate":
            return float(np.linalg.norm(feedback.offset_m)) * 1000.0
        case "rotate":
            return math.degrees(float(np.linalg.norm(feedback.turn_rad)))
        case "speed":
            return 100.0 * (feedback.factor - 1.0)
        case _:
            return 0.0


def adjusted(feedback: Feedback, act: acts.AdjustLast) -> tuple[Feedback, bool]:
    """Return the correction that follows from changing the last one.

    Returns
    -------
    feedback : Feedback
    in_place : bool
        True: it stands instead of the last one; False: it comes on top.
    """
    if act.factor is not None:
        return scaled(feedback, act.factor), True
    if act.change == "opposite":
        return scaled(feedback, -1.0), True
    if act.change == "less":
        return scaled(feedback, 0.8 if act.degree == "little" else 0.5), True
    share = {"little": 0.4, "much": 2.0}.get(act.degree or "", 1.0)
    return scaled(feedback, share), False


def speed_of(known: Knowledge) -> float:
    """Return the whole task's speed as a factor of the demonstration's."""
    lesson = known.lesson
    if lesson is None:
        return 1.0
    factors = [one.factor for one in lesson.feedback if one.kind == "speed" and not one.primitive]
    return lesson.speed * float(np.prod(factors)) if factors else lesson.speed


def plain_feedback(feedback: Feedback) -> dict[str, Any]:
    """Return a correction as plain values, in mm, degrees and factors."""
    told: dict[str, Any] = {"kind": feedback.kind, "words": feedback.words}
    told["primitive"] = feedback.primitive
    told["when"] = feedback.when
    told["frame"] = feedback.frame
    match feedback.kind:
        case "translate":
            told["offset_mm"] = [round(1000.0 * one, 3) for one in feedback.offset_m]
        case "rotate":
            told["turn_deg"] = [round(math.degrees(one), 3) for one in feedback.turn_rad]
        case "speed":
            told["factor"] = round(feedback.factor, 4)
        case _:
            told["hand"] = feedback.hand
    told["size"] = round(size(feedback), 2)
    return told
