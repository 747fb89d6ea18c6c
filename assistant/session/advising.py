"""What would help where a setup is refused: tried before it is told.

The planner says what fails first and which way would ease it. Here the thing concerned is put
elsewhere, ever further that way and then other ways, until the task can be done with it, or
until only another thing is left to blame. What does not help is not advised.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace
from typing import Literal

from assistant.dialogue.advice import CLEAR, concerned, moved, names_thing, place_of
from assistant.learning.adaptation import AdaptationPlan, adapt
from assistant.model.bearing import lifts_mm
from assistant.model.motion import Refusal
from assistant.model.scene import Scene
from assistant.model.setup import Place, Setup
from assistant.ports import Planner

Help = Literal["closer", "farther", "turn_left", "turn_right", "higher"]
Advice = tuple[str, float]
"""What would help, and by how many mm or deg."""

FARTHER_MM = (25.0, 50.0, 75.0, 100.0, 125.0, 150.0, 175.0, 200.0, 225.0, 250.0, 275.0, 300.0)
TURNS_DEG = (15.0, 30.0, 45.0, 60.0, 90.0, 120.0, 180.0)
HIGHER_MM = (25.0, 50.0, 75.0, 100.0, 150.0, 200.0, 300.0)
AMOUNTS: Mapping[Help, tuple[float, ...]] = {
    "closer": FARTHER_MM,
    "farther": FARTHER_MM,
    "turn_left": TURNS_DEG,
    "turn_right": TURNS_DEG[:-1],
    "higher": HIGHER_MM,
}
FIRST: Mapping[str, tuple[Help, ...]] = {
    "closer": ("closer",),
    "farther": ("farther",),
    "turn": ("turn_left", "turn_right"),
    "higher": ("higher",),
}
"""What is tried first, by what the planner said."""
NOTHING, FROM_ABOVE = "nothing", "from_above"


def advised(
    refusal: Refusal,
    plan: AdaptationPlan,
    scene: Scene,
    setup: Setup,
    planner: Planner,
    speed: float = 1.0,
) -> Refusal:
    """Return a refusal with what was found to help, `nothing` if nothing tried does.

    Parameters
    ----------
    refusal : Refusal
        Of `plan` in this scene and setup; where it has no hint, nothing is looked for.
    plan : AdaptationPlan
    scene, setup
    planner : Planner
    speed : float
        Factor of the demonstration's speed.
    """

    def outcome(other_scene: Scene, other: Setup) -> Refusal | None:
        path = adapt(plan, other_scene, other, speed=speed)
        found = planner.plan(path, other_scene, other)
        return found if isinstance(found, Refusal) else None

    thing = concerned(refusal, setup)
    if refusal.hint == CLEAR and (cleared := without(refusal.what, scene, setup, plan)) is not None:
        left = outcome(*cleared)
        if left is None or not _about(left, (thing, refusal.what)):
            return refusal
    if not thing or not refusal.hint:
        return refusal
    partly: Advice | None = None
    for how, by in _tried(refusal, place_of(setup, thing), lifts_mm(scene, setup, thing)):
        left = outcome(scene, moved(setup, thing, how, by))
        if left is None:
            return replace(refusal, hint=how, by=by)
        if partly is None and not _about(left, (thing,)):
            partly = how, by
    overlap = refusal.reason == "setup" and refusal.what in setup.places
    slides = refusal.where == f"way to {refusal.what}"
    otherwise = CLEAR if overlap else FROM_ABOVE if slides else NOTHING
    hint, by = partly or (otherwise, 0.0)
    return replace(refusal, hint=hint, by=by)


def without(
    what: str, scene: Scene, setup: Setup, plan: AdaptationPlan
) -> tuple[Scene, Setup] | None:
    """Return scene and setup with a thing cleared away; None if it cannot be, or is needed."""
    needed = {name for station in plan.stations for name in (station.object, station.frame)}
    if what in setup.places and what not in needed:
        left = {name: place for name, place in setup.places.items() if name != what}
        return scene, replace(setup, places=left)
    obstacles = tuple(one for one in scene.obstacles if one.name != what)
    return (replace(scene, obstacles=obstacles), setup) if obstacles != scene.obstacles else None


def _tried(refusal: Refusal, place: Place, lifts: Sequence[float]) -> Iterator[Advice]:
    first = FIRST.get(refusal.hint, ())
    reach_mm = math.hypot(*place.xyz_mm[:2])
    for ways in (first, tuple(how for how in AMOUNTS if how not in (*first, "higher"))):
        # Ways that are as good as one another are tried together, the least change first.
        tried = sorted((by, how) for how in ways for by in AMOUNTS[how])
        # Where something there would carry it, just so high: it neither floats nor falls.
        tried = [(by, "higher") for by in lifts if "higher" in ways] + tried
        yield from ((how, by) for by, how in tried if how != "closer" or by < reach_mm)


def _about(refusal: Refusal, things: Sequence[str]) -> bool:
    return any(
        thing and (names_thing(refusal.where, thing) or refusal.what == thing) for thing in things
    )
