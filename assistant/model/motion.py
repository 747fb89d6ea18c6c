"""Paths the hand or the joints are to follow, and why one cannot be followed."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

import numpy as np

from assistant.geometry import Array
from assistant.model.demonstration import frozen_array

Indices = np.ndarray[tuple[int], np.dtype[np.int64]]


@dataclass(frozen=True, slots=True)
class HandStop:
    """A sample of a path where the hand rests while the gripper acts, or must be exact.

    Parameters
    ----------
    at : int
        Sample of the path.
    kind : {"grasp", "release", "touch"}
    object, frame : str
        As in `assistant.model.lesson.Station`.
    docking_at, left_at : int
        The constrained stretch around it, in samples.
    shift : 7 numbers
        How the teacher's corrections moved it, a pose within `frame`.
    """

    at: int
    kind: Literal["grasp", "release", "touch"]
    object: str
    frame: str
    docking_at: int
    left_at: int
    shift: tuple[float, ...] = (0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0)


@dataclass(frozen=True, slots=True, eq=False)
class HandPath:
    """What adaptation hands to the arm: the flange's path for one setup, timed for the hand.

    Parameters
    ----------
    t_s : array, shape (n,)
        From 0, increasing; the hand's speed limit is kept, joints are not known here.
    path : array, shape (n, 7)
        Flange in the base frame.
    gripper_m : array, shape (n,)
        Opening commanded at each sample.
    primitive_at : array of int, shape (n,)
        Position among the tree's leaves, -1 for none.
    stops : tuple of HandStop
        In order.
    """

    t_s: Array
    path: Array
    gripper_m: Array
    primitive_at: Indices
    stops: tuple[HandStop, ...] = ()

    def __post_init__(self) -> None:
        for name in ("t_s", "path", "gripper_m"):
            object.__setattr__(self, name, frozen_array(getattr(self, name)))


@dataclass(frozen=True, slots=True, eq=False)
class JointPath:
    """A checked motion of the arm, one sample a control tick.

    Parameters
    ----------
    t_s : array, shape (n,)
    q : array, shape (n, 6)
        Joint angles in rad.
    gripper_m : array, shape (n,)
    primitive_at : array of int, shape (n,)
    stops : tuple of HandStop
        With samples of this path.
    joint_margin_deg : float
        Least distance to a joint limit.
    peak_joint_speed_ratio : float
        Greatest joint speed over its limit.
    peak_hand_speed_m_s : float
    note : str
        What was changed on the way ("went around post"); may be empty.
    """

    t_s: Array
    q: Array
    gripper_m: Array
    primitive_at: Indices
    stops: tuple[HandStop, ...]
    joint_margin_deg: float
    peak_joint_speed_ratio: float
    peak_hand_speed_m_s: float
    note: str = ""

    def __post_init__(self) -> None:
        for name in ("t_s", "q", "gripper_m"):
            object.__setattr__(self, name, frozen_array(getattr(self, name)))


@dataclass(frozen=True, slots=True)
class Refusal:
    """Why a motion is not begun.

    Parameters
    ----------
    reason : str
        ``reach``, ``joint_limit``, ``collision``, ``setup`` (things overlap), ``speed``.
    where : str
        The pose or primitive that fails, in the task's words.
    what : str
        The joint ("joint 5") or body ("table") concerned; may be empty.
    amount, unit : float, str
        By how much: mm or deg.
    hint : str
        A key for what would help: ``closer``, ``farther``, ``turn``, ``turn_left``,
        ``turn_right``, ``lower``, ``higher``, ``clear``; ``nothing`` if none of them does.
    by : float
        How much of it: mm or deg; 0 if that was not looked for.
    """

    reason: Literal["reach", "joint_limit", "collision", "setup", "speed"]
    where: str
    what: str = ""
    amount: float = 0.0
    unit: Literal["mm", "deg", ""] = ""
    hint: str = ""
    by: float = 0.0

    def __str__(self) -> str:
        by = f" by {self.amount:.1f} {self.unit}" if self.unit else ""
        what = f" ({self.what})" if self.what else ""
        return f"{self.reason} at {self.where}{what}{by}"


@dataclass(frozen=True, slots=True)
class Alignment:
    """How well a released object lies on its target (Table I).

    Parameters
    ----------
    object, target : str
    distance_mm, angle_deg : float
        Of the worst corner and of the edges from where the teacher wants them.
    x_mm, y_mm : float
        Of its base's middle from the place the setup tells, to the front and to the left:
        a correction told there is seen in it.
    """

    object: str
    target: str
    distance_mm: float
    angle_deg: float
    x_mm: float = 0.0
    y_mm: float = 0.0


@dataclass(frozen=True, slots=True)
class Measure:
    """How well something was done that corners and edges do not tell.

    Parameters
    ----------
    kind : str
        ``depth`` of an object in a hole; ``edge``, how far a pushed object's edge is from a line;
        ``covered``, how much of a mark was wiped; ``inside``, how many of the balls lie in a cup.
    object, target : str
    value : float
    unit : str
    good : bool
        Whether that counts as success.
    """

    kind: Literal["depth", "edge", "covered", "inside"]
    object: str
    target: str
    value: float
    unit: str
    good: bool

    def __str__(self) -> str:
        return f"{self.kind} of {self.object} at {self.target}: {self.value:.1f} {self.unit}"


GOING_ON = "going_on"
"""Why an arm came to rest that has been told meanwhile what to do next."""


ReportKind = Literal["primitive", "perceived", "unmet", "halted", "finished"]


@dataclass(frozen=True, slots=True)
class ArmReport:
    """What the arm tells while or after it moves.

    Parameters
    ----------
    kind : str
        ``primitive`` (one begins), ``perceived`` (a state was seen to change), ``unmet`` (a
        condition does not hold; the run is halted), ``halted`` (stop or pause took effect),
        ``finished``.
    at_s : float
        Simulated time since the motion began.
    primitive_at : int
        Position among the tree's leaves; -1 for none.
    text : str
        For ``perceived`` and ``unmet`` a condition's key, such as ``held``, or what else went
        wrong (``contact``, ``tracking``, ``slipped``); for ``halted`` why, or `GOING_ON`.
    object, target : str
        For ``perceived`` and ``unmet``; for ``halted`` and ``finished`` `object` is what the
        hand holds.
    alignments : tuple of Alignment
        For ``finished``.
    measures : tuple of Measure
        For ``finished``: what tells success where alignment does not, or not alone.
    height_mm : float or None
        For ``halted`` and ``finished``, where `object` is held: how far its base is above what
        is below it.
    when : str
        For ``unmet`` conditions of a primitive: ``before`` or ``until``; empty for what the arm
        itself noticed on its way.
    found : str
        For ``unmet``: how the hand is, or what it holds, instead.
    amount : float or None
        For ``unmet``, text ``slipped``: how far `object` is from its place in the hand, in `unit`.
    unit : str
        ``mm`` or ``deg``.
    """

    kind: ReportKind
    at_s: float
    primitive_at: int = -1
    text: str = ""
    object: str = ""
    target: str = ""
    alignments: tuple[Alignment, ...] = ()
    height_mm: float | None = None
    measures: tuple[Measure, ...] = ()
    when: Literal["", "before", "until"] = ""
    found: str = ""
    amount: float | None = None
    unit: str = ""
