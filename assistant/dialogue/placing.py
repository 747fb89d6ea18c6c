"""Where things are, told in words and read back (issue: setups by talk)."""

from __future__ import annotations

import re
from dataclasses import replace
from typing import Any, Literal

from assistant.dialogue.asking import ask, begin_run, places, proceed, tell
from assistant.dialogue.effects import Arrange
from assistant.dialogue.knowledge import Knowledge
from assistant.dialogue.state import Dialogue, Introducing, Pending, Ran, Ready, Running
from assistant.dialogue.things import known_name
from assistant.dialogue.turn import Turn, Words, changed, first, line, plain_place, say, with_other
from assistant.language.actions import mentioned_objects
from assistant.language.hints import hints, matter, mentions
from assistant.model import teacher_acts as acts
from assistant.model.scene import Scene
from assistant.model.setup import Place, Triple

Kind = Literal["hand", "body"]
STANDS_MM = 15.0


def set_pose(dialogue: Dialogue, act: acts.SetPose, words: str, *, sure: bool) -> Turn:
    """Put a thing where the teacher says; numbers that were not typed are confirmed first."""
    if dialogue.busy:
        return say(dialogue, line("error", "while_moving"))
    known, thing = dialogue.known, thing_meant(dialogue, act)
    if not thing:
        told = line("error", "no_such_thing", thing=act.object, names=_things(known))
        return tell(dialogue, told)
    if known.facing is None and act.by_mm is not None and any(act.by_mm[:2]):
        question = line("ask", "facing", asked="facing")
        return ask(replace(dialogue, pending=Pending("facing", question, (act,), words)))
    place = new_place(known, thing, act, words)
    if place is None:
        return tell(dialogue, line("error", "no_place", thing=thing))
    told = line("read_back", "place", thing=thing, place=plain_place(place))
    if not sure:
        question = line("confirm", "place", asked="did_you_mean", **told.slots)
        return tell(replace(dialogue, pending=Pending("did_you_mean", question, (act,), words)))
    done = placed(dialogue, thing, place, by_mm=list(act.by_mm) if act.by_mm else None)
    others = [one.name for one in known.objects or () if one.name != thing]
    other = (replace(act, object=others[0]),) if len(others) == 1 else ()
    return with_other(dialogue, done[0], other, Words(words), act), done[1]


def thing_meant(dialogue: Dialogue, act: acts.SetPose) -> str:
    """Return the thing a place is told of: the one named, else the one asked about."""
    thing = thing_named(dialogue.known, act.object)
    if not thing and act.object.lower() in hints("pronouns", dialogue.language):
        thing = pointed_at(dialogue)
    if thing or not isinstance(dialogue.state, Introducing):
        return thing
    # "A flat box 12 by 12 by 1" tells a size, however much it looks like a place.
    sized = matter(act.object, "shapes", dialogue.language)
    return "" if sized else dialogue.state.thing


def pointed_at(dialogue: Dialogue) -> str:
    """Return the thing that "it" is: the one in the way, or moved last, else what is carried."""
    carried = [one.name for one in dialogue.known.objects or () if one.role == "object"]
    return _refused(dialogue) or _last_moved(dialogue) or (carried[0] if len(carried) == 1 else "")


def _refused(dialogue: Dialogue) -> str:
    """Return the one thing at which a run was refused; the robot advises to move "it"."""
    refusal, things = dialogue.refusal, dialogue.known.objects or ()
    if refusal is None or not isinstance(dialogue.state, Ready):
        return ""
    named = [one.name for one in things if one.name in refusal.where]
    return named[0] if len(named) == 1 else ""


def _last_moved(dialogue: Dialogue) -> str:
    """Return the one thing that the last change put elsewhere; empty if none, or several."""
    before = dialogue.past[-1] if dialogue.past else None
    if before is None or before.label != "setup":
        return ""
    was, now = before.known.setup.places, dialogue.known.setup.places
    moved = [name for name, place in now.items() if was.get(name) != place]
    return moved[0] if len(moved) == 1 else ""


def placed(dialogue: Dialogue, thing: str, place: Place, **how: Any) -> Turn:
    """Put a thing somewhere, tell it, and look whether the arm can reach it there.

    `how` tells what the place was told by: another thing, or how far from where it was.
    """
    setup = dialogue.known.setup
    moved = replace(setup, name="told", places={**setup.places, thing: place})
    known = replace(dialogue.known, setup=moved)
    after = replace(changed(dialogue, "setup", known, clean=dialogue.clean), pending=None)
    told = line("read_back", "place", thing=thing, place=plain_place(place), **how)
    arrange = Arrange(moved, known.scene)
    said = (*say(after, told)[1], arrange)
    if isinstance(dialogue.state, Ready | Ran | Running):
        return first(said, begin_run(replace(after, state=Ready(), arm="rest"), look=True))
    if isinstance(dialogue.state, Introducing):
        return first(said, proceed(after))
    return first(said, tell(after))


def thing_named(known: Knowledge, text: str) -> str:
    """Return the name of the thing a text refers to; empty if none."""
    things = known.objects or ()
    named = known_name(text, known.scene, known.language)
    if named in known.scene.bodies or any(one.name == named for one in things):
        return named
    if named in known.setup.places:
        return named
    found = mentioned_objects(text, things, known.language)
    return found[0] if len(found) == 1 else ""


def _things(known: Knowledge) -> list[str]:
    return [one.name for one in known.objects or ()] or list(known.scene.bodies)


def new_place(known: Knowledge, thing: str, act: acts.SetPose, words: str) -> Place | None:
    """Return the place told; None if it is relative to a place nobody told.

    People measure bodies; "the hand at the block" tells the place as the paper does. What a
    place is of stays as it was where the words leave it open.
    """
    old = known.setup.places.get(thing)
    kind: Kind = old.kind if old is not None else "body"
    if mentions(words, hints("place_of", known.language)["hand"]):
        kind = "hand"
    elif mentions(words, hints("place_of", known.language)["body"]):
        kind = "body"
    elif act.position_mm is not None:
        kind = _likely_kind(known.scene, thing, act.position_mm, kind)
    was: Triple = old.rpy_deg if old is not None else (0.0, 0.0, 0.0)
    turned = _turned(act, was, words, known.language)
    if act.position_mm is not None:
        xyz_mm = _on_a_table(known, act.position_mm) if kind == "body" else act.position_mm
        return Place(kind, xyz_mm, turned)
    if old is None:
        return None
    dx, dy, dz = _from_robot(known, act.by_mm or (0.0, 0.0, 0.0))
    x, y, z = old.xyz_mm
    return Place(old.kind, (x + dx, y + dy, z + dz), turned)


def _on_a_table(known: Knowledge, xyz_mm: Triple) -> Triple:
    """Return a place that was measured a little too low, so that it is in a table, on top of it."""
    x, y, z = xyz_mm
    top = top_mm(known, x, y)
    return (x, y, top) if top is not None and 0.0 < top - z < STANDS_MM else xyz_mm


def top_mm(known: Knowledge, x: float, y: float) -> float | None:
    """Return how high the table is there; None where none is."""
    tops = [
        table.xyz_mm[2] + table.size_mm[2]
        for table in known.scene.tables
        if abs(x - table.xyz_mm[0]) <= table.size_mm[0] / 2.0
        and abs(y - table.xyz_mm[1]) <= table.size_mm[1] / 2.0
    ]
    return max(tops, default=None)


def _turned(act: acts.SetPose, was: Triple, words: str, language: str) -> Triple:
    """Return how a thing is turned: as told, or by so much further than it was."""
    if act.rpy_deg is None:
        return was
    told = words.lower()
    by = act.position_mm is None and mentions(told, hints("turning_by", language))
    if not by or re.search(rf"\b(?:{'|'.join(hints('turning_to', language))})\s+-?\d", told):
        return act.rpy_deg
    roll, pitch, yaw = (a + b for a, b in zip(was, act.rpy_deg, strict=True))
    return (roll, pitch, (yaw + 180.0) % 360.0 - 180.0)


def _likely_kind(scene: Scene, thing: str, xyz_mm: Triple, kind: Kind) -> Kind:
    """Return whether a body or a hand is meant: the one with which the body stands on a table.

    Where neither does, or both do, the kind stays as it was.
    """
    tops = [table.xyz_mm[2] + table.size_mm[2] for table in scene.tables]
    kinds: tuple[Kind, Kind] = ("hand", "body")
    standing = [
        one
        for one in kinds
        if any(
            abs(1000.0 * float(scene.body_pose(thing, Place(one, xyz_mm))[2]) - top) < STANDS_MM
            for top in tops
        )
    ]
    return standing[0] if len(standing) == 1 else kind


def _from_robot(known: Knowledge, by_mm: Triple) -> Triple:
    """Return a displacement as the robot sees it: mirrored if the teacher faces it."""
    if known.facing != "facing":
        return by_mm
    return (-by_mm[0], -by_mm[1], by_mm[2])


__all__ = [
    "new_place",
    "placed",
    "places",
    "pointed_at",
    "set_pose",
    "thing_meant",
    "thing_named",
    "top_mm",
]
