"""All acts of a teacher as one type."""

from __future__ import annotations

from assistant.model.teacher_acts.motion import (
    AdjustLast,
    AdjustSpeed,
    Again,
    Gripper,
    NewSetup,
    Pause,
    Resume,
    Rotate,
    SetPose,
    Start,
    Stop,
    Translate,
)
from assistant.model.teacher_acts.structure import (
    AddSubtask,
    Assign,
    Merge,
    MoveCut,
    Optional,
    Ordered,
    RemoveSubtask,
    Rename,
    Required,
    Split,
    Unordered,
)
from assistant.model.teacher_acts.talk import (
    Affirm,
    Approve,
    BeBrief,
    BeThorough,
    Compare,
    Cue,
    Deny,
    Explain,
    GoBack,
    Help,
    Inform,
    KeyState,
    Load,
    Quit,
    Redo,
    RepeatLine,
    Save,
    Show,
    Undo,
    Unknown,
)

TeacherAct = (
    Inform
    | Affirm
    | Deny
    | Cue
    | KeyState
    | AdjustSpeed
    | Translate
    | Rotate
    | Gripper
    | Start
    | Pause
    | Resume
    | Stop
    | Again
    | Approve
    | GoBack
    | Undo
    | Redo
    | AdjustLast
    | RepeatLine
    | Help
    | Show
    | Explain
    | Rename
    | Optional
    | Required
    | Unordered
    | Ordered
    | AddSubtask
    | RemoveSubtask
    | Merge
    | Split
    | MoveCut
    | Assign
    | SetPose
    | NewSetup
    | BeBrief
    | BeThorough
    | Save
    | Load
    | Compare
    | Quit
    | Unknown
)
