"""The ``learned`` section of task/1 as forms: everything of a `Lesson`, arrays as rows.

Numbers are written exactly, so that reading gives the same lesson.
"""

from __future__ import annotations

from typing import Any, Literal

from pydantic import Field

from assistant.files.forms import (
    Count,
    Form,
    Name,
    Number,
    Positive,
    Probability,
    Text,
    Triple,
    Truth,
)
from assistant.files.tree_forms import ConditionForm

Pose = tuple[Number, Number, Number, Number, Number, Number, Number]
Rows = list[list[Number]]
Axis = Literal["x", "y", "z", "-x", "-y", "-z"]
PATH_COLUMNS = ("t_s", "x_m", "y_m", "z_m", "qx", "qy", "qz", "qw")


class PointForm(Form):
    """A place where the demonstration may be cut."""

    at_s: Number
    confidence: Probability
    votes: dict[Name, Number] = Field(default_factory=dict)
    kept: Truth = True
    internal: Truth = False


class EpisodeForm(Form):
    """One segment and its primitive."""

    from_s: Number
    to_s: Number
    primitive: Name | None
    probability: Probability
    character: Text = ""


class QuestionForm(Form):
    """What the robot should ask before it goes on."""

    asked: Name
    about: Text = ""
    reason: Text = ""
    facts: dict[Text, Any] = Field(default_factory=dict)


class CurvesForm(Form):
    """The votes over time, one row an instant: time, sum, then each signal's vote."""

    columns: tuple[Text, ...] = Field(description="t_s, vote, then the names of the signals")
    rows: Rows


class StationForm(Form):
    """A grasp or release within the path; poses are x, y, z in m, then quaternion x, y, z, w."""

    kind: Literal["grasp", "release", "touch"]
    object: Name
    frame: Name
    primitive: Text
    at: Count = Field(description="row of the path, counted from 0")
    docking_at: Count
    left_at: Count
    frame_to_world: Pose
    hand_in_frame: Pose
    docking_in_frame: Pose


class ConditionsForm(Form):
    """Conditions of one primitive as inferred from what was shown."""

    before: tuple[ConditionForm, ...] = ()
    until: tuple[ConditionForm, ...] = ()


class FeedbackForm(Form):
    """One correction, with the teacher's words."""

    kind: Literal["translate", "rotate", "speed", "hand"]
    words: Text
    primitive: Text = ""
    when: Literal["before", "during", "after"] = "during"
    frame: Text = ""
    offset_m: Triple = (0.0, 0.0, 0.0)
    turn_rad: Triple = (0.0, 0.0, 0.0)
    factor: Positive = 1.0
    hand: Literal["open", "close"] | None = None


class PathForm(Form):
    """The generalized path in the world frame."""

    columns: tuple[Text, ...] = Field(
        description="t_s, x_m, y_m, z_m, qx, qy, qz, qw, gripper_m if known, primitive "
        "(its position among the tree's leaves, counted from 0; -1 for none)"
    )
    rows: Rows


class LearnedForm(Form):
    """What has been learned from demonstrations."""

    demonstrations: tuple[Text, ...] = ()
    approach_axis: Axis = "x"
    speed: Positive = Field(1.0, description="factor of the demonstration's speed")
    jerk_m_s3: Positive | None = Field(
        None, description="root mean square of the smoothed demonstration's jerk"
    )
    cue_lag_s: Number | None = None
    points: tuple[PointForm, ...] = ()
    episodes: tuple[EpisodeForm, ...] = ()
    questions: tuple[QuestionForm, ...] = ()
    conditions: dict[Name, ConditionsForm] = Field(default_factory=dict)
    docking: tuple[StationForm, ...] = ()
    feedback: tuple[FeedbackForm, ...] = ()
    path: PathForm | None = None
    votes: CurvesForm | None = None
