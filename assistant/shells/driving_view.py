"""What a teacher sees while driving the hand: the way to each thing, by word and by key."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from assistant.dialogue.reporting import refusal_line
from assistant.geometry import (
    Array,
    compose,
    quat_to_rpy,
    relative,
    rotate_vector,
    transform_points,
)
from assistant.language.speech import in_words, phrase
from assistant.model.motion import ArmReport, Refusal
from assistant.model.placing import is_round
from assistant.model.scene import Body, Scene
from assistant.model.task import TaskObject
from assistant.ports import ArmLook

NEAR_MM, NEAR_DEG = 0.5, 0.4
"""So near the hand is there: what is let go then lies in line, as practice measures it."""
WAYS = (("w", "s"), ("a", "d"), ("r", "f"))
"""Keys for more and less of x, y and z in the robot's base frame."""
TURNS = ("q", "e")
WRIST = ("joint 4", "joint 6")
"""What winds up is right again where the hand points down."""
BEND = "joint 5"
"""High up it is bent most by a hand that points down."""
ELBOW = "joint 3"
"""It ends where the arm is folded up; stretched, the hand is out of reach before."""
DOWNWARD = -0.9
"""A hand whose approach goes so far down cannot be tilted out of the way."""
MIRRORED = {"w": "s", "s": "w", "a": "d", "d": "a"}
"""Facing the robot, the teacher's directions are the other way round."""


@dataclass(frozen=True, slots=True)
class Gap:
    """How far the fingers are from where they grasp, or release at, a thing.

    Parameters
    ----------
    name : str
        Empty for where the step that is shown again ended.
    xyz_mm : array, shape (3,)
        Along the axes of the robot's base.
    yaw_deg : float
    held : bool
    """

    name: str
    xyz_mm: Array
    yaw_deg: float
    held: bool = False

    @property
    def there(self) -> bool:
        """Whether the hand is where it should be."""
        far = float(np.abs(self.xyz_mm).max())
        return not self.held and far < NEAR_MM and abs(self.yaw_deg) < NEAR_DEG


def gaps(look: ArmLook, scene: Scene, tip: Array) -> tuple[Gap, ...]:
    """Return the gaps to all things that are somewhere, in the order of the scene.

    Parameters
    ----------
    look : ArmLook
    scene : Scene
    tip : array, shape (7,)
        The point between the fingers, seen from the flange: the hand turns about it.
    """
    known = [name for name in scene.bodies if name in look.bodies]
    return tuple(_gap_to(look, scene, name, tip) for name in known)


def _gap_to(look: ArmLook, scene: Scene, name: str, tip: Array) -> Gap:
    body, pose, held = scene.bodies[name], look.bodies[name], scene.bodies.get(look.held)
    round_one = is_round(body) or (held is not None and is_round(held))
    gap = _gap(look, name, compose(pose, body.hand_in_body), tip)
    if held is not None and look.held in look.bodies and _bears(body, name, look.held):
        # What matters is where the thing in the hand comes to stand, however it was taken.
        base = look.bodies[look.held]
        top = transform_points(pose, np.array([0.0, 0.0, body.size_mm[2] / 1000.0]))
        turn_deg = float(np.rad2deg(quat_to_rpy(relative(base, pose)[3:])[2]))
        gap = replace(gap, xyz_mm=1000.0 * (top - base[:3]), yaw_deg=turn_deg)
    return replace(gap, yaw_deg=0.0) if round_one else gap


def _bears(body: Body, name: str, held: str) -> bool:
    """Whether what is held is put on top of a thing."""
    return name != held and body.mass_kg == 0.0 and not any(body.hole_mm)


def unplaced(
    objects: Sequence[TaskObject], look: ArmLook, words: Mapping[str, Any], *, closed: bool
) -> tuple[str, ...]:
    """Return a line for each thing whose place is yet to be taken from what is shown.

    Parameters
    ----------
    objects : sequence of TaskObject
    look : ArmLook
    words : mapping
        Of driving.
    closed : bool
        Whether the hand has closed on something: then it matters where it opens.
    """
    now = "target" if closed else "object"
    lost = (one for one in objects if one.name not in look.bodies and one.role == now)
    return tuple(str(words["unplaced"][one.role]).format(name=one.name) for one in lost)


def above_table(look: ArmLook, scene: Scene, tip: Array) -> float | None:
    """Return how far below the point between the fingers a table's top is, in mm."""
    x, y, z = 1000.0 * compose(look.hand, tip)[:3]
    tops = [
        table.xyz_mm[2] + table.size_mm[2]
        for table in scene.tables
        if abs(x - table.xyz_mm[0]) <= table.size_mm[0] / 2.0
        and abs(y - table.xyz_mm[1]) <= table.size_mm[1] / 2.0
    ]
    below = [float(z - top) for top in tops if top < z]
    return min(below) if below else None


def end_gap(look: ArmLook, goal: Array, tip: Array) -> Gap:
    """Return the gap to where the step that is shown again ended.

    Parameters
    ----------
    look : ArmLook
    goal : array, shape (7,)
        The flange there.
    tip : array, shape (7,)
    """
    return _gap(look, "", goal, tip)


def _gap(look: ArmLook, name: str, goal: Array, tip: Array) -> Gap:
    away_mm = 1000.0 * (compose(goal, tip)[:3] - compose(look.hand, tip)[:3])
    turn_deg = _turn_deg(look.hand, goal, 360.0 if look.held else 180.0)
    return Gap(name, away_mm, turn_deg, held=bool(name) and look.held == name)


def _turn_deg(hand: Array, goal: Array, whole_deg: float) -> float:
    """Return how far to turn about the vertical until the fingers close along the same line.

    However a hand leans. Empty, it grasps either way round: half a turn is a whole one then.
    """
    across, wanted = (rotate_vector(one[3:], np.array([0.0, 1.0, 0.0])) for one in (hand, goal))
    angle = np.rad2deg(np.arctan2(wanted[1], wanted[0]) - np.arctan2(across[1], across[0]))
    return float((angle + whole_deg / 2.0) % whole_deg - whole_deg / 2.0)


def key_for(key: str, *, facing: bool) -> str:
    """Return the key that moves the robot the way a teacher's key means, and the reverse."""
    return MIRRORED.get(key, key) if facing else key


def gap_line(gap: Gap, words: Mapping[str, Any], *, facing: bool, holding: bool) -> str:
    """Return the way to a thing: "to the block   154 mm forward (w)   ..."."""
    head = str(words["to"]).format(name=gap.name) if gap.name else str(words["to_end"])
    if gap.held:
        return f"{head}   {words['held']}"
    if gap.there and not gap.name:
        return f"{head}   {words['there']}: {words['end_now']}"
    if gap.there:
        act = words["open_now" if holding else "close_now"]
        return f"{head}   {words['there']}: {act}"
    return "   ".join((head, *_steps(gap, words, facing=facing)))


def way_line(head: str, gap: Gap, words: Mapping[str, Any], *, facing: bool) -> str:
    """Return the way to a place as words and keys behind what it is; empty where the hand is."""
    steps = tuple(_steps(gap, words, facing=facing))
    return "   ".join((head, *steps)) if steps else ""


def points_down(look: ArmLook) -> bool:
    """Whether the hand points down."""
    return bool(rotate_vector(look.hand[3:], np.array([1.0, 0.0, 0.0]))[2] < DOWNWARD)


def low_line(lowest: tuple[str, float], look: ArmLook, tip: Array, words: Mapping[str, Any]) -> str:
    """Return how near the table the hand is, and where over it, seen from the robot.

    Parameters
    ----------
    lowest : tuple of str and float
        What of arm and hand is nearest above a table, and how far in mm.
    look : ArmLook
    tip : array, shape (7,)
    words : mapping
        Of driving.
    """
    low, (part, mm) = words["low"], lowest
    x, y = (1000.0 * compose(look.hand, tip)[:2]).tolist()
    side = low["left" if y > 0 else "right"]
    return str(low["line"]).format(
        part=low["parts"][part], mm=round(mm), x=round(x), y=round(abs(y)), side=side
    )


def _steps(gap: Gap, words: Mapping[str, Any], *, facing: bool) -> Iterator[str]:
    ways = words["keys"]
    for away, keys in zip(gap.xyz_mm, WAYS, strict=True):
        key = key_for(keys[0 if away > 0 else 1], facing=facing)
        if abs(away) >= NEAR_MM:
            yield str(words["step"]).format(mm=max(round(abs(away)), 1), way=ways[key], key=key)
    if abs(gap.yaw_deg) >= NEAR_DEG:
        key = TURNS[0 if gap.yaw_deg > 0 else 1]
        yield str(words["turn"]).format(deg=max(round(abs(gap.yaw_deg)), 1), way=ways[key], key=key)


def in_the_way(
    trouble: Refusal | ArmReport,
    words: Mapping[str, Any],
    language: str,
    held: str = "",
    *,
    facing: bool = False,
    touching: str = "",
    down: bool = False,
) -> str:
    """Return in words why the hand does not go on.

    Parameters
    ----------
    trouble : Refusal or ArmReport
    words : mapping
        Of driving.
    language : str
    held : str
        What the hand holds: put down, it touches something.
    facing : bool
        Whether the teacher faces the robot.
    touching : str
        What of arm and hand would touch something.
    down : bool
        Whether the hand points down.
    """
    if isinstance(trouble, Refusal):
        if trouble.what == ELBOW and trouble.reason == "speed":
            # Stretched, the elbow has no speed left.
            trouble = Refusal("reach", trouble.where)
        told = phrase(refusal_line("refuse", trouble), language)
        if trouble.what == ELBOW:
            away = key_for("w", facing=facing)
            return f"{told} {str(words['folded']).format(key=away)}"
        if trouble.reason == "collision":
            part = f"{touching}_down" if down and touching in ("palm", "arm") else touching
            return f"{told} {words['touching'].get(part, '')}".strip()
        if trouble.reason == "reach":
            return f"{told} {str(words['far']).format(key=key_for('s', facing=facing))}"
        if trouble.what == BEND and down:
            return f"{told} {words['bent']}"
        return f"{told} {words['wound']}" if trouble.what in WRIST else told
    put_down = bool(held) and trouble.text == "contact"
    template = words["put_down"] if put_down else words["faults"][trouble.text]
    thing, in_hand = (in_words(one, language) if one else "" for one in (trouble.object, held))
    return str(template).format(name=thing, held=in_hand)


def step_line(view: Mapping[str, Any], cues: Sequence[str], words: Mapping[str, Any]) -> str:
    """Return which step is being shown and what to press when the next one begins.

    Parameters
    ----------
    view : mapping
        Of the dialogue, with the task's primitives.
    cues : sequence of str
        What the teacher said so far to mark transitions.
    words : mapping
        Of driving.
    """
    names = [str(leaf["name"]) for leaf in view["task"]["primitives"]]
    keys, told = {cue: key for key, cue in words["cues"].items()}, words["steps"]
    first = str(words["cues"]["1"])
    # Who does not mark the beginning marks the first transition first.
    number = len(cues) + (not cues or first not in cues[0].lower())
    if view["step_shown"]:
        return str(told["only"]).format(name=view["step_shown"])
    if not names:
        return ""
    if not cues:
        return str(told["begin"]).format(name=names[0], key=keys[first])
    if number >= len(names):
        return str(told["last"]).format(number=len(names), count=len(names), name=names[-1])
    return str(told["now"]).format(
        number=number, count=len(names), name=names[number - 1], then=names[number]
    )
