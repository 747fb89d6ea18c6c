"""What one demonstration taught: cuts, episodes, docking poses, learned path (paper III)."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from types import MappingProxyType
from typing import Literal

import numpy as np

from assistant.geometry import Array
from assistant.model.conditions import Condition
from assistant.model.demonstration import frozen_array
from assistant.model.feedback import Feedback


@dataclass(frozen=True, slots=True)
class SegmentationPoint:
    """A place where the demonstration may be cut (paper III-A).

    Parameters
    ----------
    at_s : float
        On the recording's clock.
    confidence : float
        Probability in [0, 1] that a cut belongs here.
    votes : mapping of signal name to vote
    kept : bool
        False for an eliminated point.
    internal : bool
        Kept, but inside one primitive (the diamond of the paper's Fig. 4).
    """

    at_s: float
    confidence: float
    votes: Mapping[str, float]
    kept: bool = True
    internal: bool = False


@dataclass(frozen=True, slots=True)
class Episode:
    """One segment of the demonstration and the primitive it was assigned to.

    Parameters
    ----------
    from_s, to_s : float
    primitive : str or None
        Name of the primitive; None for a step nobody introduced.
    probability : float
        Of this assignment.
    character : str
        Main motion in the robot's frame, such as "down", "turn left", "rest"; may be empty.
    """

    from_s: float
    to_s: float
    primitive: str | None
    probability: float
    character: str = ""


@dataclass(frozen=True, slots=True)
class Question:
    """What the robot should ask before it goes on.

    Parameters
    ----------
    asked : str
        As in the contract: ``missing_step``, ``confirm_segmentation``, ``order``, ...
    about : str
        Name of the node or thing concerned; may be empty.
    reason : str
        A stable key from which speech is made, such as ``never_closed``.
    facts : mapping
        What the sentence needs: numbers, names.
    """

    asked: str
    about: str
    reason: str
    facts: Mapping[str, object] = field(default_factory=lambda: MappingProxyType({}))


@dataclass(frozen=True, slots=True)
class Segmentation:
    """All that cutting and assigning found.

    Parameters
    ----------
    points : tuple of SegmentationPoint
        Kept and dropped, in the order of time.
    episodes : tuple of Episode
    cue_lag_s : float or None
        How late the teacher's cues come; None without cues.
    questions : tuple of Question
        What remains to be asked.
    vote_t_s : array, shape (n,)
    vote : array, shape (n,)
        v(t) at those instants; empty where no votes were kept. Source: paper III-A, eq. (2).
    signal_votes : mapping of array, shape (n,)
        What each signal gave to it.
    """

    points: tuple[SegmentationPoint, ...]
    episodes: tuple[Episode, ...]
    cue_lag_s: float | None
    questions: tuple[Question, ...] = ()
    vote_t_s: Array = field(default_factory=lambda: np.zeros(0), compare=False)
    vote: Array = field(default_factory=lambda: np.zeros(0), compare=False)
    signal_votes: Mapping[str, Array] = field(
        default_factory=lambda: MappingProxyType({}), compare=False
    )

    @property
    def cuts_s(self) -> tuple[float, ...]:
        """The cuts between primitives, start and end excluded."""
        return tuple(point.at_s for point in self.points if point.kept and not point.internal)


@dataclass(frozen=True, slots=True, eq=False)
class Station:
    """A grasp or release within the learned path, in the frame of its object or target.

    Frames follow the paper's reading of Table I: the frame of an object or target is the
    flange when it grasps or releases there as told by the setup, so a carried object's frame
    moves with the flange, and a released object can be the target of a later release.

    Parameters
    ----------
    kind : {"grasp", "release", "touch"}
        ``touch``: a place reached without the gripper (pushing, pouring, wiping).
    object : str
        The object grasped or let go.
    frame : str
        Whose frame it is: the object for a grasp, the target for a release.
    primitive : str
        The primitive that contains it.
    at, docking_at : int
        Samples of the learned path: hand closes or opens, and docking pose reached.
    left_at : int
        Sample where the hand has left the station again and its frame lets go.
    frame_to_world : array, shape (7,)
        In the demonstration.
    hand_in_frame, docking_in_frame : array, shape (7,)
        At `at` and at `docking_at`.
    """

    kind: Literal["grasp", "release", "touch"]
    object: str
    frame: str
    primitive: str
    at: int
    docking_at: int
    left_at: int
    frame_to_world: Array
    hand_in_frame: Array
    docking_in_frame: Array

    def __post_init__(self) -> None:
        for name in ("frame_to_world", "hand_in_frame", "docking_in_frame"):
            object.__setattr__(self, name, frozen_array(getattr(self, name)))


@dataclass(frozen=True, slots=True, eq=False)
class LearnedPath:
    """The generalized path in the world frame (paper III-C b, eq. 5), evenly sampled.

    Parameters
    ----------
    t_s : array, shape (n,)
    path : array, shape (n, 7)
    gripper_m : array, shape (n,), or None
    primitive_at : array of int, shape (n,)
        For each sample the position of its primitive among the tree's leaves, -1 for none.
    """

    t_s: Array
    path: Array
    gripper_m: Array | None
    primitive_at: np.ndarray[tuple[int], np.dtype[np.int64]]

    def __post_init__(self) -> None:
        object.__setattr__(self, "t_s", frozen_array(self.t_s))
        object.__setattr__(self, "path", frozen_array(self.path))
        if self.gripper_m is not None:
            object.__setattr__(self, "gripper_m", frozen_array(self.gripper_m))


@dataclass(frozen=True, slots=True, eq=False)
class Lesson:
    """Everything that has been learned for a task.

    Parameters
    ----------
    segmentation : Segmentation
    path : LearnedPath or None
        None where nothing can be carried out (the hand was not recorded).
    stations : tuple of Station
        In the order of the path.
    before, until : mapping of primitive name to conditions
        As inferred (paper III-C c); what the teacher told stands in the tree.
    sources : tuple of str
        File names of the demonstrations learned from.
    feedback : tuple of Feedback
        Corrections in the order given; undone ones are not here.
    speed : float
        Factor of the demonstration's speed, 1 as shown.
    approach_axis : str
        Of the hand.
    jerk_m_s3 : float or None
        Root mean square of the smoothed demonstration's jerk, before docking was straightened
        and rests were made; None where it was not measured.
    """

    segmentation: Segmentation
    path: LearnedPath | None
    stations: tuple[Station, ...] = ()
    before: Mapping[str, tuple[Condition, ...]] = field(
        default_factory=lambda: MappingProxyType({})
    )
    until: Mapping[str, tuple[Condition, ...]] = field(default_factory=lambda: MappingProxyType({}))
    sources: tuple[str, ...] = ()
    feedback: tuple[Feedback, ...] = ()
    speed: float = 1.0
    approach_axis: str = "x"
    jerk_m_s3: float | None = None
