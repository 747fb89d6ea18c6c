"""Places told by other things, as nearer to the robot, or as they were shown."""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np

from assistant.dialogue.asking import ask, begin_run, places, tell
from assistant.dialogue.directions import move_in_world
from assistant.dialogue.doubting import without_guess
from assistant.dialogue.effects import Arrange
from assistant.dialogue.knowledge import Knowledge
from assistant.dialogue.placing import placed, pointed_at
from assistant.dialogue.spots import offered
from assistant.dialogue.state import AwaitingShow, Dialogue, Introducing, Pending, Ran, Ready
from assistant.dialogue.turn import Turn, Words, changed, first, line, plain_place, say, then
from assistant.geometry import pose_to_mm_deg
from assistant.language.hints import hints, mentions
from assistant.language.relations import Relation, Side, relation
from assistant.model.setup import Place, Setup
from assistant.model.task import TaskObject
from assistant.model.teacher_acts import SetPose

GAP_MM, ROUND_MM, STEP_MM = 50.0, 10.0, 50.0
"""Between things that stand beside each other, where nobody tells how far; and for "closer"."""
SIDES: dict[Side, str] = {
    "left": "left",
    "right": "right",
    "front": "backward",
    "behind": "forward",
}


def told_beside(dialogue: Dialogue, words: Words) -> Turn | None:
    """Put a thing where a sentence tells by another thing; None where none does."""
    free = without_guess(dialogue)
    asked = isinstance(free.state, Introducing) and free.state.asked == "pose"
    placing = asked or isinstance(free.state, AwaitingShow | Ready | Ran)
    if not placing or free.pending is not None:
        return None
    known = free.known
    named = {one.name for one in known.objects or ()}
    others = tuple(TaskObject(name, "object") for name in known.scene.bodies if name not in named)
    found = relation(words.text, (*(known.objects or ()), *others), free.language)
    if found is None or not _meant_so(free, found, asked=asked):
        return None
    thing = found.thing or (_spoken_of(free) if asked or _pointed(free, words) else "")
    if not thing or thing == found.other:
        return None
    return _stood(free, replace(found, thing=thing), words)


def _meant_so(dialogue: Dialogue, found: Relation, *, asked: bool) -> bool:
    """Whether a place is told: after a run, where a thing is tells how the run went."""
    if asked:
        return True
    return found.posture == "put" or (
        found.posture == "is" and isinstance(dialogue.state, AwaitingShow | Ready)
    )


def _spoken_of(dialogue: Dialogue) -> str:
    """Return the thing a place is told of that is not named."""
    state = dialogue.state
    return state.thing if isinstance(state, Introducing) else pointed_at(dialogue)


def _pointed(dialogue: Dialogue, words: Words) -> bool:
    return mentions(words.text, hints("pronouns", dialogue.language))


def _stood(dialogue: Dialogue, found: Relation, words: Words) -> Turn:
    known = dialogue.known
    base = known.setup.places.get(_base(found))
    if base is None or found.thing not in known.scene.bodies:
        return _nowhere(dialogue, found)
    if known.facing is None and found.side in SIDES:
        question = line("ask", "facing", asked="facing")
        return ask(replace(dialogue, pending=Pending("facing", question, (), words.text)))
    place, distance_mm = _place(known, found)
    if isinstance(dialogue.state, Ran):
        told = line(
            "confirm", "place", asked="did_you_mean", thing=found.thing, place=plain_place(place)
        )
        act = SetPose(found.thing, position_mm=place.xyz_mm, rpy_deg=place.rpy_deg)
        pending = Pending("did_you_mean", told, (act,), words.text)
        return ask(replace(dialogue, pending=pending))
    far = {"beside_mm": distance_mm, "side": found.side, "other": found.other}
    nearer = {"nearer_mm": distance_mm, "nearer": found.side}
    return placed(dialogue, found.thing, place, **(far if found.other else nearer))


def _nowhere(dialogue: Dialogue, found: Relation) -> Turn:
    """Tell that a thing cannot be put beside one that is nowhere yet; offer a place for it."""
    missing, first_places = _base(found), isinstance(dialogue.state, Introducing)
    spot = offered(dialogue, found.thing) if first_places else None
    if spot is None:
        return tell(dialogue, line("error", "no_place", thing=missing))
    return first(say(dialogue, line("told", "nowhere_yet", thing=missing))[1], spot)


def _place(known: Knowledge, found: Relation) -> tuple[Place, float]:
    """Return where the middle of a thing's base is, and how far that is from the other one's."""
    scene, told = known.scene, known.setup.places
    far_mm = found.distance_mm if found.distance_mm is not None else _far_mm(known, found)
    base, _ = pose_to_mm_deg(scene.body_pose(_base(found), told[_base(found)]))
    old = told.get(found.thing)
    z, rpy = float(base[2]), (0.0, 0.0, 0.0)
    if old is not None:
        xyz, turned = pose_to_mm_deg(scene.body_pose(found.thing, old))
        z = float(xyz[2])
        rpy = (round(float(turned[0]), 1), round(float(turned[1]), 1), round(float(turned[2]), 1))
    way = _way(known, found, base)
    x, y = (round(float(base[k] + far_mm * way[k]), 1) for k in range(2))
    return Place("body", (x, y, round(z, 1)), rpy), far_mm


def _base(found: Relation) -> str:
    return found.other or found.thing


def _way(known: Knowledge, found: Relation, base: np.ndarray) -> np.ndarray:
    """Return the direction, shape (3,), in which the thing is; the robot stands at the origin."""
    if found.side in SIDES:
        return np.asarray(move_in_world(SIDES[found.side], known.facing))
    if found.side == "beside":
        # Toward the middle of the table there is more room.
        return np.array([0.0, 1.0 if base[1] < 0.0 else -1.0, 0.0])
    away = np.array([base[0], base[1], 0.0])
    outward = away / max(float(np.linalg.norm(away)), 1e-9)
    return outward if found.side == "farther" else -outward


def _far_mm(known: Knowledge, found: Relation) -> float:
    """Return how far two things that stand beside each other are from middle to middle."""
    if not found.other:
        return STEP_MM
    bodies = known.scene.bodies
    halves = [max(bodies[name].size_mm[:2]) / 2.0 for name in (found.thing, found.other)]
    return math.ceil((sum(halves) + GAP_MM) / ROUND_MM) * ROUND_MM


def restored(dialogue: Dialogue, words: Words) -> Turn | None:
    """Put everything back where it was in the last demonstration."""
    if not mentions(words.text, hints("restore_setup", dialogue.language)):
        return None
    known = dialogue.known
    shown = known.demonstrations[-1].setup if known.demonstrations else None
    if shown is None or not shown.places:
        return None
    setup = replace(shown, places={**known.setup.places, **shown.places})
    return rearranged(dialogue, setup)


def rearranged(dialogue: Dialogue, setup: Setup) -> Turn:
    """Read back a whole arrangement and look whether it can be reached; nothing moves."""
    known = dialogue.known
    at_rest = replace(dialogue, state=Ready(), arm="rest", pending=None)
    moved = changed(at_rest, "setup", replace(known, setup=setup), clean=dialogue.clean)
    said = line("read_back", "setup", setup=setup.name, places=places(moved.known))
    shown = then(say(moved, said), Arrange(setup, known.scene))
    return first(shown[1], begin_run(moved, look=True))
