"""Where a demonstration grasps and releases, and which object or target that concerns.

Each time the hand closes or opens around something is paired with the primitive of the tree
that tells it; the frame is the object's for a grasp, the target's for a release (paper III-C).
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Literal

import numpy as np

from assistant.geometry import IDENTITY, Array, compose, inverse, pose_to_mm_deg, relative
from assistant.learning.signals import GripperEvent
from assistant.model.demonstration import Demonstration
from assistant.model.lesson import Episode
from assistant.model.scene import Scene
from assistant.model.setup import Place
from assistant.model.task import Primitive, Task, primitives


@dataclass(frozen=True, slots=True)
class Visit:
    """A grasp or release seen in the demonstration.

    Parameters
    ----------
    kind : {"grasp", "release", "touch"}
    at_s : float
    primitive : str
        Empty if no primitive tells of it.
    object, frame : str
        As in `assistant.model.lesson.Station`.
    """

    kind: Literal["grasp", "release", "touch"]
    at_s: float
    primitive: str
    object: str
    frame: str


def visits(
    task: Task, events: Sequence[GripperEvent], episodes: Sequence[Episode]
) -> tuple[Visit, ...]:
    """Return grasps and releases in order; opening an empty hand is none."""
    leaves = primitives(task.tree)
    found: list[Visit] = []
    held = ""
    used: set[str] = set()
    for event in events:
        if event.kind == "open" and not held:
            continue
        leaf = _leaf(event, leaves, episodes, used)
        position = leaves.index(leaf) if leaf else _position(event.at_s, leaves, episodes)
        name = leaf.name if leaf else leaves[position].name if leaves else ""
        if leaf:
            used.add(leaf.name)
        if event.kind == "close" and leaf and _closes_empty(task, leaf, leaves):
            continue
        if event.kind == "close":
            held = _object(task, leaves, leaf, position, found)
            found.append(Visit("grasp", event.at_s, name, held, held))
        else:
            frame = _target(task, leaves, leaf, position, held)
            found.append(Visit("release", event.at_s, name, held, frame))
            held = ""
    return tuple(found)


def touches(
    task: Task, episodes: Sequence[Episode], acted: Sequence[Visit] = ()
) -> tuple[Visit, ...]:
    """Return the places reached without the gripper: ends of motions to a named thing.

    Parameters
    ----------
    task : Task
    episodes : sequence of Episode
    acted : sequence of Visit
        Grasps and releases; beside them only free motions reach places of their own. What is
        held, or else was touched last, is the object of a free motion at a target.
    """
    leaves = {leaf.name: leaf for leaf in primitives(task.tree)}
    found: list[Visit] = []
    touched = ""
    for episode in episodes:
        leaf = leaves.get(episode.primitive or "")
        name = leaf.action.object if leaf else None
        if leaf is None or not name or leaf.action.verb not in ("move", "free"):
            continue
        if leaf.action.way in ("depart", "up") or leaf.name in {one.primitive for one in acted}:
            continue
        if leaf.action.verb == "free" or not acted:
            before = [visit for visit in acted if visit.at_s <= episode.from_s]
            held = before[-1].object if before and before[-1].kind == "grasp" else ""
            pushed = touched if _role(task, name) == "target" else ""
            thing = held or pushed or name
            found.append(Visit("touch", episode.to_s, leaf.name, thing, name))
            touched = thing if _role(task, thing) == "object" else touched
    return tuple(found)


def frames(
    found: Sequence[Visit], hands: Array, demonstration: Demonstration, scene: Scene | None
) -> Array:
    """Return the frame of each visit in the world, in the demonstration, shape (visits, 7).

    Parameters
    ----------
    found : sequence of Visit
    hands : array, shape (visits, 7)
        The flange at each.
    demonstration : Demonstration
        Places it does not tell are where the hand closed or opened.
    scene : Scene, optional
        Relates bodies to hands.
    """
    look = scene or Scene()
    now = {
        name: look.hand_pose(name, place)
        for name, place in demonstration.setup.places.items()
        if place.kind == "hand" or name in look.bodies
    }
    in_hand: dict[str, Array] = {}
    out = np.empty((len(found), 7))
    for k, (visit, hand) in enumerate(zip(found, hands, strict=True)):
        if visit.frame not in now:
            now[visit.frame] = _unknown(visit, hand, in_hand, look)
        out[k] = now[visit.frame]
        if visit.kind == "grasp":
            in_hand[visit.object] = relative(hand, out[k])
        elif visit.kind == "release":
            # From now on its frame stays where the hand let go, and others may be put on it.
            now[visit.object] = compose(hand, in_hand.pop(visit.object, IDENTITY))
    return out


def told_for_hand(demonstration: Demonstration, scene: Scene | None) -> Demonstration:
    """Return a demonstration whose places are told as flange poses, as far as the scene tells."""
    if scene is None:
        return demonstration
    places = {
        name: _for_hand(scene, name, place) for name, place in demonstration.setup.places.items()
    }
    return replace(demonstration, setup=replace(demonstration.setup, places=places))


def _for_hand(scene: Scene, name: str, place: Place) -> Place:
    if place.kind == "hand" or name not in scene.bodies:
        return place
    xyz, rpy = (tuple(row.tolist()) for row in pose_to_mm_deg(scene.hand_pose(name, place)))
    return Place("hand", xyz, rpy)


def _unknown(visit: Visit, hand: Array, in_hand: dict[str, Array], scene: Scene) -> Array:
    below, above = scene.bodies.get(visit.frame), scene.bodies.get(visit.object)
    if visit.kind != "release" or below is None or above is None or below.mass_kg <= 0.0:
        return hand
    # Put on a body that can be carried itself: its base lies its own height further down.
    carried = compose(hand, in_hand.get(visit.object, IDENTITY))
    base = compose(carried, inverse(above.hand_in_body))
    base[2] -= below.size_mm[2] / 1000.0
    return compose(base, below.hand_in_body)


def _leaf(
    event: GripperEvent,
    leaves: Sequence[Primitive],
    episodes: Sequence[Episode],
    used: set[str],
) -> Primitive | None:
    """Return the primitive that tells of an event: the nearest episode's, else the next."""
    telling = {
        leaf.name: leaf
        for leaf in leaves
        if leaf.action.verb == "hand" and leaf.action.way == event.kind and leaf.name not in used
    }
    shown = [episode for episode in episodes if episode.primitive in telling]
    if shown:
        nearest = min(
            shown, key=lambda part: max(part.from_s - event.at_s, event.at_s - part.to_s, 0.0)
        )
        return telling[str(nearest.primitive)]
    return next(iter(telling.values()), None)


def _closes_empty(task: Task, leaf: Primitive, leaves: Sequence[Primitive]) -> bool:
    """Return whether a step closes the hand to push with: it stays closed, and comes first.

    It names nothing, no motion has brought the hand to anything, and it is never opened again
    though a thing that could be grasped is only approached then.
    """
    at = leaves.index(leaf)
    if leaf.action.object or any(one.action.verb != "hand" for one in leaves[:at]):
        return False
    later = [one.action for one in leaves[at + 1 :]]
    if any((one.verb, one.way) == ("hand", "open") for one in later):
        return False
    return any(one.way == "approach" and _role(task, one.object) == "object" for one in later)


def _position(at_s: float, leaves: Sequence[Primitive], episodes: Sequence[Episode]) -> int:
    names = [leaf.name for leaf in leaves]
    here = [part for part in episodes if part.primitive in names and part.from_s <= at_s]
    return names.index(str(here[-1].primitive)) if here else 0


def _role(task: Task, name: str | None) -> str:
    known = task.object(name) if name else None
    return known.role if known else ""


def _object(
    task: Task,
    leaves: Sequence[Primitive],
    leaf: Primitive | None,
    position: int,
    found: Sequence[Visit],
) -> str:
    if leaf and leaf.action.object:
        return leaf.action.object
    near = [*reversed(leaves[: position + 1]), *leaves[position + 1 :]]
    named = [part.action.object for part in near if _role(task, part.action.object) == "object"]
    taken = {visit.object for visit in found}
    rest = [known.name for known in task.objects if known.role == "object"]
    candidates = [name for name in (*named, *rest) if name]
    free = [name for name in candidates if name not in taken]
    return next(iter([*free, *candidates]), "object")


def _target(
    task: Task, leaves: Sequence[Primitive], leaf: Primitive | None, position: int, held: str
) -> str:
    if leaf:
        for condition in leaf.until:
            if condition.kind in ("on", "aligned") and condition.target:
                return condition.target
        if leaf.action.object and leaf.action.object != held:
            return leaf.action.object
    for part in reversed(leaves[: position + 1]):
        if part.action.verb == "hand" and part.action.way == "close":
            break
        if part.action.object and part.action.object != held:
            return part.action.object
    targets = [known.name for known in task.objects if known.role == "target"]
    others = [known.name for known in task.objects if known.name != held]
    return next(iter([*targets, *others]), "target")
