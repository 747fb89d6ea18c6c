"""transcript/1 as forms: steps of one key each, read like a play."""

from __future__ import annotations

from typing import Annotated, Any, Literal, TypeAlias

from pydantic import BeforeValidator, Discriminator, Field, Tag, model_validator

from assistant.files.demonstrations import SpokenForm
from assistant.files.forms import (
    Form,
    Name,
    NotNegative,
    Text,
    Whole,
    as_list,
    as_mapping,
    as_number,
    as_text,
    by_shape,
    exactly_one,
    or_nothing,
)
from assistant.files.setups import SetupForm
from assistant.model.robot_acts import RobotActName
from assistant.model.teacher_acts import Asked

JsonValue: TypeAlias = Any


def _nothing(value: Any) -> Any:
    return {} if value is None or value is True else value


def _no_steps(value: Any) -> Any:
    return () if value is None else value


class TeacherForm(Form):
    """What the teacher says, and what the recognizer makes of it."""

    says: Text
    heard: Text | None = None
    at_s: NotNegative | None = Field(None, description="seconds into the running motion")
    by_voice: Annotated[float, Field(ge=0.0, le=1.0)] | None = Field(
        None, description="how surely it was heard, where it was spoken"
    )


class AboutForm(Form):
    """The node of the tree a line concerns."""

    name: Name | Literal[""]
    index: tuple[Whole, ...]


class RobotForm(Form):
    """A line of the robot by its meaning; only what is listed must agree."""

    act: RobotActName | None = None
    asked: Asked | None = None
    topic: Text | None = None
    about: (
        Annotated[Annotated[Text, as_text] | Annotated[AboutForm, as_mapping], by_shape] | None
    ) = None
    slots: dict[str, JsonValue] = Field(default_factory=dict)
    words: Text | None = None


class DemonstrateForm(Form):
    """The task is shown: by a recording or by the scripted hand."""

    model_config = exactly_one("recording", "hand")
    recording: Name | None = None
    hand: Literal["scripted"] | None = None
    seed: Whole | None = None
    cues: Annotated[
        Annotated[Literal["auto"], as_text] | Annotated[tuple[SpokenForm, ...], as_list], by_shape
    ] = ()
    key_states: tuple[SpokenForm, ...] = ()

    @model_validator(mode="after")
    def _one_source(self) -> DemonstrateForm:
        if (self.recording is None) == (self.hand is None):
            raise ValueError("nobody or two show it; either recording: FILE.csv or hand: scripted")
        if self.recording is not None and (self.seed is not None or self.cues == "auto"):
            raise ValueError("a recording has no seed; seed and cues: auto go with hand: scripted")
        return self


class SetupChoiceForm(SetupForm):
    """A setup by file, or told in full."""

    file: Name | None = None

    @model_validator(mode="after")
    def _one_way(self) -> SetupChoiceForm:
        if self.file is not None and len(self.model_fields_set) > 1:
            raise ValueError("more than a file; file: stands alone")
        return self


RobotLineForm = Annotated[
    Annotated[Text, as_text] | Annotated[RobotForm, as_mapping],
    by_shape,
    BeforeValidator(_nothing),
]
SetupLineForm = Annotated[
    Annotated[Name, as_text] | Annotated[SetupChoiceForm, as_mapping], by_shape
]


class NoteStep(Form):
    """A remark for the reader."""

    note: Text


class TeacherStep(Form):
    """The teacher says something."""

    teacher: Annotated[Annotated[Text, as_text] | Annotated[TeacherForm, as_mapping], by_shape]


class RobotStep(Form):
    """One line of the robot: its words, a /pattern/, or its meaning."""

    model_config = or_nothing("robot")
    robot: RobotLineForm


class RobotMaybeStep(Form):
    """At most one such line."""

    model_config = or_nothing("robot?")
    robot: RobotLineForm = Field(alias="robot?")


class RobotAnyStep(Form):
    """Any number of such lines."""

    model_config = or_nothing("robot*")
    robot: RobotLineForm = Field(alias="robot*")


class RobotSomeStep(Form):
    """At least one such line."""

    model_config = or_nothing("robot+")
    robot: RobotLineForm = Field(alias="robot+")


class WaitStep(Form):
    """Simulated seconds pass, or until the arm rests."""

    wait: Annotated[
        Annotated[NotNegative, as_number] | Annotated[Literal["rest"], as_text], by_shape
    ]


class DemonstrateStep(Form):
    """The task is shown."""

    demonstrate: DemonstrateForm


class SetupStepForm(Form):
    """The things on the table are rearranged: a name, a file, or told in full."""

    setup: SetupLineForm


class ExpectStep(Form):
    """Values of the session's public view by dotted path."""

    expect: dict[str, JsonValue]


class RestartStep(Form):
    """The program dies and starts again with what was flushed."""

    model_config = or_nothing("restart")
    restart: Annotated[dict[str, JsonValue], BeforeValidator(_nothing)]


class HappenedStep(Form):
    """What the arm, learning or a check answered (in journals)."""

    happened: dict[str, JsonValue]


def _key_of(step: Any) -> str | None:
    if not isinstance(step, dict):
        return str(step)[:60]
    return str(next(iter(step))) if len(step) >= 1 else None


AnyStep = (
    NoteStep
    | TeacherStep
    | RobotStep
    | RobotMaybeStep
    | RobotAnyStep
    | RobotSomeStep
    | WaitStep
    | DemonstrateStep
    | SetupStepForm
    | ExpectStep
    | RestartStep
    | HappenedStep
)

StepForm = Annotated[
    Annotated[NoteStep, Tag("note")]
    | Annotated[TeacherStep, Tag("teacher")]
    | Annotated[RobotStep, Tag("robot")]
    | Annotated[RobotMaybeStep, Tag("robot?")]
    | Annotated[RobotAnyStep, Tag("robot*")]
    | Annotated[RobotSomeStep, Tag("robot+")]
    | Annotated[WaitStep, Tag("wait")]
    | Annotated[DemonstrateStep, Tag("demonstrate")]
    | Annotated[SetupStepForm, Tag("setup")]
    | Annotated[ExpectStep, Tag("expect")]
    | Annotated[RestartStep, Tag("restart")]
    | Annotated[HappenedStep, Tag("happened")],
    Discriminator(_key_of),
]


class TranscriptFile(Form):
    """transcript/1."""

    model_config = or_nothing("steps")
    format: Literal["transcript/1"]
    title: Text
    setup: SetupLineForm | None = None
    arm: Literal["pybullet", "kinematic"] = "kinematic"
    task: Name | None = None
    language: Literal["english", "german", "en", "de"] = "english"
    steps: Annotated[tuple[StepForm, ...], BeforeValidator(_no_steps)]
