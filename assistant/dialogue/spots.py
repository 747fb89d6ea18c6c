"""A place for a thing that nobody has put anywhere yet: near, free, and well reached."""

from __future__ import annotations

import math
from dataclasses import replace

from assistant.dialogue.asking import ask
from assistant.dialogue.knowledge import Knowledge
from assistant.dialogue.placing import placed, top_mm
from assistant.dialogue.state import Dialogue, Introducing, Pending
from assistant.dialogue.turn import Turn, Words, line, plain_place
from assistant.language.hints import hints, mentions
from assistant.model import teacher_acts as acts
from assistant.model.setup import Place

AHEAD_MM, ASIDE_MM = 450.0, (150.0, 0.0, 250.0)
"""Seen from the arm's base; what is carried is taken from its left and brought to its right."""
GAP_MM = 60.0
"""Between two things, so that the fingers have room."""
SPOT = "place_offered"
"""The question whether a thing shall stand where the robot offers."""


def spot(known: Knowledge, thing: str) -> Place | None:
    """Return where a thing can well stand; None where no table has room, or its size is unknown."""
    role = next((one.role for one in known.objects or () if one.name == thing), "object")
    side = 1.0 if role == "object" else -1.0
    if thing not in known.scene.bodies:
        return None
    for y in (sign * side * far for far in ASIDE_MM for sign in (1.0, -1.0)):
        top = top_mm(known, AHEAD_MM, y)
        if top is not None and _free(known, thing, AHEAD_MM, y):
            return Place("body", (AHEAD_MM, y, top))
    return None


def _free(known: Knowledge, thing: str, x: float, y: float) -> bool:
    """Whether nothing else stands so near that the fingers would have no room."""
    scene = known.scene
    for name, place in known.setup.places.items():
        if name == thing or name not in scene.bodies:
            continue
        at_mm = 1000.0 * scene.body_pose(name, place)[:2]
        halves = [math.hypot(*scene.bodies[one].size_mm[:2]) / 2.0 for one in (name, thing)]
        if math.hypot(at_mm[0] - x, at_mm[1] - y) < sum(halves) + GAP_MM:
            return False
    return True


def offered(dialogue: Dialogue, thing: str) -> Turn | None:
    """Ask whether a thing shall stand where it is well reached; None where no such place is."""
    place = spot(dialogue.known, thing)
    if place is None:
        return None
    question = line("confirm", SPOT, asked="did_you_mean", thing=thing, place=plain_place(place))
    put = acts.SetPose(thing, position_mm=place.xyz_mm)
    return ask(replace(dialogue, pending=Pending("did_you_mean", question, (put,))))


def anywhere(dialogue: Dialogue, words: Words) -> Turn | None:
    """Take a place for the thing asked about from who leaves it to the robot; else None."""
    state = dialogue.state
    if not isinstance(state, Introducing) or state.asked != "pose":
        return None
    place = spot(dialogue.known, state.thing)
    if place is None or not mentions(words.text, hints("anywhere", dialogue.language)):
        return None
    return placed(dialogue, state.thing, place)
