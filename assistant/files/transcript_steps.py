"""Steps of a transcript as values: from their forms, and back to plain values."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any, assert_never

from assistant.files import transcript_forms as forms
from assistant.files.demonstrations import spoken_values
from assistant.files.setups import setup_values
from assistant.files.step_problems import NEAR, pattern_in
from assistant.model.robot_acts import About
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
    Step,
    TeacherLine,
    Times,
    Wait,
)
from assistant.plain_yaml import tidy

KEYS: dict[Times, str] = {"one": "robot", "maybe": "robot?", "any": "robot*", "some": "robot+"}
Line = str | forms.RobotForm


def step_of(form: forms.AnyStep, line: int) -> Step:
    """Return the step of a form, with the line it stands on."""
    match form:
        case forms.NoteStep():
            return Note(form.note, line)
        case forms.TeacherStep():
            return _teacher(form.teacher, line)
        case forms.RobotStep():
            return _robot("one", form.robot, line)
        case forms.RobotMaybeStep():
            return _robot("maybe", form.robot, line)
        case forms.RobotAnyStep():
            return _robot("any", form.robot, line)
        case forms.RobotSomeStep():
            return _robot("some", form.robot, line)
        case forms.WaitStep():
            return Wait(None if isinstance(form.wait, str) else form.wait, line)
        case forms.DemonstrateStep():
            return _demonstrate(form.demonstrate, line)
        case forms.SetupStepForm():
            return SetupStep(choice_of(form.setup), line)
        case forms.ExpectStep():
            return Expect(with_near(form.expect), line)
        case forms.RestartStep():
            return Restart(line)
        case forms.HappenedStep():
            return Happened(form.happened, line)
    assert_never(form)


def _teacher(form: str | forms.TeacherForm, line: int) -> TeacherLine:
    if isinstance(form, str):
        return TeacherLine(form, line=line)
    return TeacherLine(form.says, form.heard, form.at_s, form.by_voice, line)


def _robot(times: Times, form: Line, line: int) -> RobotLine:
    if isinstance(form, str):
        pattern = pattern_in(form)
        return RobotLine(times, words=None if pattern else form, pattern=pattern, line=line)
    words = form.words or None
    pattern = pattern_in(words) if words else None
    about = form.about
    return RobotLine(
        times,
        act=form.act,
        asked=form.asked,
        topic=form.topic,
        slots=with_near(form.slots),
        about=About(about.name, about.index) if isinstance(about, forms.AboutForm) else about,
        words=None if pattern else words,
        pattern=pattern,
        line=line,
    )


def _demonstrate(form: forms.DemonstrateForm, line: int) -> Demonstrate:
    cues = None if isinstance(form.cues, str) else tuple(each.spoken() for each in form.cues)
    spoken = tuple(each.spoken() for each in form.key_states)
    return Demonstrate(form.recording, form.seed or 0, cues, spoken, line)


def choice_of(form: str | forms.SetupChoiceForm) -> SetupChoice:
    """Return which setup a text or mapping names; a text with an ending is a file."""
    if isinstance(form, str):
        is_file = form.endswith((".yaml", ".yml", ".json")) or "/" in form
        return SetupChoice(file=form) if is_file else SetupChoice(name=form)
    if form.file is not None:
        return SetupChoice(file=form.file)
    if form.model_fields_set == {"name"}:
        return SetupChoice(name=form.name)
    return SetupChoice(setup=form.setup())


def with_near(values: Mapping[str, Any]) -> dict[str, Any]:
    """Return values in which each ``{near, within}`` has become a `Near`."""
    return {key: _near(value) for key, value in values.items()}


def _near(value: Any) -> Any:
    if isinstance(value, Mapping) and set(value) == NEAR:
        return Near(float(value["near"]), float(value["within"]))
    if isinstance(value, Mapping):
        return with_near(value)
    return [_near(part) for part in value] if isinstance(value, list) else value


def step_values(step: Step) -> dict[str, Any]:
    """Return a step as plain values: one key and what belongs to it."""
    match step:
        case Note():
            return {"note": step.text}
        case TeacherLine():
            return {"teacher": _teacher_values(step)}
        case RobotLine():
            return {KEYS[step.times]: _robot_values(step)}
        case Wait():
            return {"wait": "rest" if step.seconds is None else tidy(step.seconds)}
        case Demonstrate():
            return {"demonstrate": _demonstrate_values(step)}
        case SetupStep():
            return {"setup": choice_value(step.choice)}
        case Expect():
            return {"expect": plain(step.values)}
        case Restart():
            return {"restart": {}}
        case Happened():
            return {"happened": plain(step.result)}
    assert_never(step)


def _teacher_values(step: TeacherLine) -> Any:
    if step.heard is None and step.at_s is None and step.by_voice is None:
        return step.says
    at_s, sure = (None if one is None else tidy(one) for one in (step.at_s, step.by_voice))
    return _given({"says": step.says, "heard": step.heard, "at_s": at_s, "by_voice": sure})


def _robot_values(step: RobotLine) -> Any:
    words = f"/{step.pattern}/" if step.pattern is not None else step.words
    about = step.about
    if isinstance(about, About):
        told: Any = {"name": about.name, "index": list(about.index)}
    else:
        told = about
    values = _given({"act": step.act, "asked": step.asked, "topic": step.topic, "about": told})
    if step.slots:
        values["slots"] = plain(step.slots)
    if not values and words is not None:
        return words
    return values if words is None else {**values, "words": words}


def _demonstrate_values(step: Demonstrate) -> dict[str, Any]:
    cues: Any = "auto" if step.cues is None else spoken_values(step.cues)
    if step.recording is not None:
        values: dict[str, Any] = {"recording": step.recording}
    else:
        values = {"hand": "scripted", "seed": step.seed}
    if cues:
        values["cues"] = cues
    if step.key_states:
        values["key_states"] = spoken_values(step.key_states)
    return values


def choice_value(choice: SetupChoice) -> Any:
    """Return which setup is meant as plain values."""
    if choice.setup is not None:
        return setup_values(choice.setup)
    if choice.file is not None:
        looks_like_file = choice_of(choice.file).file is not None
        return choice.file if looks_like_file else {"file": choice.file}
    name = choice.name or ""
    return {"name": name} if choice_of(name).file is not None else name


def plain(value: Any) -> Any:
    """Return values of any kind as plain values for a file."""
    if isinstance(value, Near):
        return {"near": tidy(value.near), "within": tidy(value.within)}
    if isinstance(value, Mapping):
        return {str(key): plain(part) for key, part in value.items()}
    if isinstance(value, Sequence) and not isinstance(value, str):
        return [plain(part) for part in value]
    return value


def _given(values: dict[str, Any]) -> dict[str, Any]:
    return {key: value for key, value in values.items() if value is not None}
