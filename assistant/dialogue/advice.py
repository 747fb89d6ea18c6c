"""What the robot said would help, done on a word: "do that", or its own advice repeated."""

from __future__ import annotations

import math
import re
from dataclasses import replace

from assistant.dialogue.beside import rearranged
from assistant.dialogue.knowledge import Knowledge
from assistant.dialogue.spots import spot
from assistant.dialogue.state import Dialogue, Ready
from assistant.dialogue.turn import Turn, Words
from assistant.language.hints import hints, mentions
from assistant.model.bearing import stands
from assistant.model.motion import Refusal
from assistant.model.setup import Place, Setup

LONGEST = 8
"""Words of a line that agrees to an advice; a longer one tells something else."""
MOVES = ("closer", "farther", "turn_left", "turn_right", "higher")
CLEAR, START = "clear", "start"


def followed(dialogue: Dialogue, words: Words) -> Turn | None:
    """Put things as the last refusal advised, for who says so; None for other talk."""
    refusal, text = dialogue.refusal, words.text
    # What was advised for another arrangement helps this one no more.
    looked_at = dialogue.run is not None and dialogue.run.setup == dialogue.known.setup
    if refusal is None or not looked_at or not isinstance(dialogue.state, Ready) or "?" in text:
        return None
    numbers = re.findall(r"\d+", text)
    other = any(float(one) != round(refusal.by) for one in numbers)
    if other or len(text.split()) > LONGEST:
        return None
    each: dict[str, list[str]] = hints("follows_each", dialogue.language)
    clears = refusal.reason in ("setup", "collision") and mentions(text, each[CLEAR])
    repeats = [*hints("follows", dialogue.language), *each.get(refusal.hint, [])]
    if not clears and not mentions(text, repeats):
        return None
    advice = replace(refusal, hint=CLEAR) if clears else refusal
    setup = _followed(dialogue.known, advice)
    return None if setup is None else rearranged(dialogue, setup)


def _followed(known: Knowledge, refusal: Refusal) -> Setup | None:
    """Return the setup that a refusal advised; None where it advised none that can be told."""
    setup = known.setup
    if refusal.hint in MOVES and refusal.by:
        thing = concerned(refusal, setup)
        after = moved(setup, thing, refusal.hint, refusal.by)
        # What nothing known would carry up there falls: what it stands on has to be told.
        falls = (
            refusal.hint == "higher" and thing != START and not stands(known.scene, after, thing)
        )
        return None if falls else after
    if refusal.hint != CLEAR:
        return None
    for name in (refusal.what, concerned(refusal, setup)):
        place = spot(known, name) if name in setup.places else None
        if place is not None:
            return replace(setup, places={**setup.places, name: place})
    return None


def concerned(refusal: Refusal, setup: Setup) -> str:
    """Return the thing whose place fails, or `start`; empty if it is neither."""
    named = [name for name in (START, *setup.places) if names_thing(refusal.where, name)]
    return max(named, key=len, default="")


def place_of(setup: Setup, thing: str) -> Place:
    """Return where a thing is; of none that is somewhere, where the hand starts."""
    return setup.places.get(thing, setup.robot_start)


def moved(setup: Setup, thing: str, how: str, by: float) -> Setup:
    """Return a setup with a thing put elsewhere, as the robot sees it, by so many mm or deg."""
    place = place_of(setup, thing)
    (x, y, z), (roll, pitch, yaw) = place.xyz_mm, place.rpy_deg
    match how:
        case "closer" | "farther":
            share = 1.0 + (by if how == "farther" else -by) / math.hypot(x, y)
            new = replace(place, xyz_mm=(x * share, y * share, z))
        case "higher":
            new = replace(place, xyz_mm=(x, y, z + by))
        case _:
            new_yaw = yaw + (by if how == "turn_left" else -by)
            new = replace(place, rpy_deg=(roll, pitch, math.remainder(new_yaw, 360.0)))
    if thing not in setup.places:
        return replace(setup, robot_start=new)
    return replace(setup, places={**setup.places, thing: new})


def names_thing(where: str, thing: str) -> bool:
    """Whether a pose of a refusal is one of a thing: "grasp of jar"."""
    return where == thing or where.endswith(f" {thing}")
