"""Parts of files in plain words, for records and for showing."""

from __future__ import annotations

from collections.abc import Iterable

import numpy as np

from assistant.model.conditions import Condition
from assistant.model.feedback import Feedback
from assistant.model.task import Primitive
from assistant.model.transcript import (
    Demonstrate,
    Expect,
    Happened,
    Near,
    Note,
    Restart,
    RobotLine,
    SetupChoice,
    SetupStep,
    TeacherLine,
    Wait,
)

_TIMES = {"one": "", "maybe": " (perhaps)", "any": " (any number)", "some": " (once or more)"}


def action_words(primitive: Primitive) -> str:
    """Return what a primitive does, such as "move approach: block"."""
    action = primitive.action
    way = action.way if action.verb == "free" else f"{action.verb} {action.way}"
    return f"{way}: {action.object}" if action.object else way


def condition_words(condition: Condition) -> str:
    """Return a condition, such as "block on target"."""
    thing, target = condition.object or "it", condition.target or "it"
    match condition.kind:
        case "hand":
            return f"hand {thing}"
        case "docked":
            return f"docked at {thing}"
        case "held":
            return f"{thing} in the hand"
        case "on":
            return f"{thing} on {target}"
        case "aligned":
            return f"{thing} aligned with {target}"
        case "above":
            return f"{thing} above {target}"
        case "clear":
            return f"clear of {thing}"


def conditions_words(primitive: Primitive) -> str:
    """Return before- and until-conditions; empty if there are none."""
    told = [
        f"{word} {', '.join(map(condition_words, conditions))}"
        for word, conditions in (("before:", primitive.before), ("until:", primitive.until))
        if conditions
    ]
    return "; ".join(told)


def feedback_words(feedback: Feedback) -> str:
    """Return a correction with the teacher's words and what it changed."""
    match feedback.kind:
        case "translate":
            change = f"moved by ({numbers_words(1000.0 * x for x in feedback.offset_m)}) mm"
        case "rotate":
            turned = (float(np.rad2deg(x)) for x in feedback.turn_rad)
            change = f"turned by ({numbers_words(turned)}) deg"
        case "speed":
            change = f"speed times {feedback.factor:.2f}"
        case "hand":
            change = f"hand {feedback.hand}"
    where = f" {feedback.when} {feedback.primitive}" if feedback.primitive else ""
    frame = f" (moves with {feedback.frame})" if feedback.frame else ""
    return f'"{feedback.words}": {change}{where}{frame}'


def one_line(text: str) -> str:
    """Return a text on one line, without signs that a terminal would obey."""
    return " ".join("".join(sign if sign.isprintable() else " " for sign in text).split())


def numbers_words(values: Iterable[float]) -> str:
    """Return numbers with one digit behind the point."""
    return ", ".join(f"{round(value, 1) + 0.0:.1f}" for value in values)


def teacher_words(step: TeacherLine) -> str:
    """Return what the teacher says, and how it is heard."""
    heard = f" [heard: {step.heard}]" if step.heard is not None else ""
    at = f" [at {step.at_s:g} s]" if step.at_s is not None else ""
    return f"{step.says}{heard}{at}"


def robot_words(step: RobotLine) -> str:
    """Return what is expected of the robot's line."""
    said = ""
    if step.words is not None or step.pattern is not None:
        said = f'"{step.words}"' if step.words is not None else f"/{step.pattern}/"
    meaning = [str(part) for part in (step.act, step.asked, step.topic) if part]
    if step.about:
        meaning.append(f"about {step.about if isinstance(step.about, str) else step.about.name}")
    meaning += [f"{name} {value_words(value)}" for name, value in step.slots.items()]
    told = " ".join(filter(None, [said, ", ".join(meaning)])) or "anything"
    return told + _TIMES[step.times]


def stage_direction(
    step: Note | Wait | Demonstrate | SetupStep | Expect | Restart | Happened,
) -> str:
    """Return what happens between the lines of a play."""
    match step:
        case Note():
            return step.text
        case Wait():
            return "until the arm rests" if step.seconds is None else f"{step.seconds:g} s pass"
        case Demonstrate():
            by = step.recording or f"the scripted hand, seed {step.seed}"
            return f"the task is shown: {by}"
        case SetupStep():
            return f"things are rearranged: {choice_words(step.choice)}"
        case Expect():
            told = (f"{path} is {value_words(value)}" for path, value in step.values.items())
            return f"now {'; '.join(told)}"
        case Restart():
            return "the program dies and starts again"
        case Happened():
            return f"happened: {', '.join(step.result)}"


def choice_words(choice: SetupChoice) -> str:
    """Return which setup is meant."""
    return choice.name or choice.file or (choice.setup.name if choice.setup else "")


def value_words(value: object) -> str:
    """Return an expected value."""
    return f"{value.near:g} within {value.within:g}" if isinstance(value, Near) else str(value)
