"""What stands where and what is in the hand while a path is carried out."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, field
from itertools import combinations

import numpy as np
from numpy.typing import NDArray

from assistant.geometry import Array, compose, inverse
from assistant.model.motion import HandStop, Refusal
from assistant.model.scene import Scene
from assistant.model.setup import Setup
from assistant.ports import ArmLook
from sim.collision import BESIDE_M, Touch, fixed_things, too_near, touches
from sim.fine_path import FinePath
from sim.kinematics import Flags, forward
from sim.resting import Carried, Standing, carried_body
from sim.shapes import body_box, boxes_apart
from sim.touching import contents, push_begin, pushed, pushes

OVERLAP_M = 0.002
"""Told places may overlap by so much: people measure to the millimetre."""

LEANS_RAD = (np.deg2rad(15.0), np.deg2rad(30.0))
"""What could be spilled leans no more than so much further on a way around; rather not so much."""
LEANING_M = 0.1
"""A rad too much counts as so far within a thing."""

Bodies = Mapping[str, Array]


@dataclass(frozen=True, slots=True, eq=False)
class Phase:
    """Samples `first` to `last` of a path, between which nothing is grasped or let go."""

    first: int
    last: int
    things: tuple[Standing, ...]
    carried: Carried | None
    stops: tuple[HandStop, ...]
    marks: frozenset[str]
    """Bodies that only mark a place: what is put there may enter them."""
    excused: Mapping[tuple[str, str], float] = field(default_factory=dict)

    def touches(self, q: Array, gripper_m: Array, samples: NDArray[np.int64]) -> Touch:
        """Return how near joints, shape (m, 6), at samples of the path come to anything."""
        allowed, resting = self._allowed(samples), self._resting(samples)
        return touches(q, gripper_m, self.things, self.carried, allowed, self.excused, resting)

    def gaps(self, gripper_m: float, shown: Array) -> Iterator[Callable[[Array], Array]]:
        """Yield what `gap` returns, ever less strict about how far what is carried leans."""
        carried = self.carried
        if carried is None or not carried.upright:
            yield self.gap(gripper_m)
            return
        most_rad = float(np.max(carried.tilt(shown)))
        for further_rad in LEANS_RAD:
            yield self.gap(gripper_m, most_rad + further_rad)

    def gap(self, gripper_m: float, leans_rad: float = np.inf) -> Callable[[Array], Array]:
        """Return how far joints, shape (m, 6), are from touching anything at all, shape (m,).

        On a free way; what was carried there may rest where it was taken up. It leans no
        further than is said.
        """
        carried = self.carried

        def apart(q: Array) -> Array:
            opening = np.full(len(q), gripper_m)
            gap = touches(q, opening, self.things, carried, None, self.excused).gap
            if carried is None or leans_rad >= np.pi:
                return gap
            return np.minimum(gap, LEANING_M * (leans_rad - carried.tilt(forward(q))))

        return apart

    def _resting(self, samples: NDArray[np.int64]) -> Flags:
        # Where it is taken up or put down, and where it is at first and in the end.
        resting = (samples <= self.first) | (samples >= self.last)
        for stop in self.stops:
            resting |= (samples >= stop.docking_at) & (samples <= stop.left_at)
        return resting

    def _allowed(self, samples: NDArray[np.int64]) -> dict[tuple[str, str], Flags]:
        allowed: dict[tuple[str, str], Flags] = {}
        for stop in self.stops:
            near = (samples >= stop.docking_at) & (samples <= stop.left_at)
            pairs = [("fingers", stop.object), ("carried", stop.frame), ("carried", stop.object)]
            if stop.frame in self.marks:
                pairs += [(part, stop.frame) for part in ("palm", "fingers", "arm")]
            if stop.kind == "touch":
                pairs += [(part, stop.object) for part in ("palm", "arm")]
                pairs += [(part, thing.name) for part in ("carried",) for thing in self.things]
            for pair in pairs:
                allowed[pair] = allowed.get(pair, np.zeros(len(samples), dtype=bool)) | near
        return allowed


def bodies_at(scene: Scene, setup: Setup, look: ArmLook | None) -> dict[str, Array]:
    """Return where each known body's base is: as told, or as a sensor tells."""
    seen = look.bodies if look else {}
    told = {name: scene.body_pose(name, place) for name, place in setup.places.items()}
    known = {name: pose for name, pose in {**told, **seen}.items() if name in scene.bodies}
    carried_along = contents(scene, known)
    return {name: pose for name, pose in known.items() if name not in carried_along}


def overlap(scene: Scene, setup: Setup, stops: tuple[HandStop, ...]) -> Refusal | None:
    """Return why a setup cannot be: things inside one another, or an object on its target."""
    bodies = bodies_at(scene, setup, None)
    solid = {name: body_box(scene.bodies[name], pose) for name, pose in bodies.items()}
    solid = {name: box for name, box in solid.items() if np.all(box.half > 0)}
    tables = {table.name for table in scene.tables}
    for thing in fixed_things(scene):
        # What was told to be within a table was told too low.
        hint = "higher" if thing.name in tables else "clear"
        for name, box in solid.items():
            if thing.name != "floor" and (deep := -boxes_apart(box, thing.box)[0]) > OVERLAP_M:
                return _overlapping(name, thing.name, float(deep), hint)
    for first, second in combinations(solid, 2):
        if (deep := -boxes_apart(solid[first], solid[second])[0]) > OVERLAP_M:
            return _overlapping(first, second, float(deep))
    return _on_its_target(scene, setup, stops, bodies)


def _on_its_target(
    scene: Scene, setup: Setup, stops: tuple[HandStop, ...], bodies: Bodies
) -> Refusal | None:
    grasped = {stop.object for stop in stops if stop.kind == "grasp"}
    for stop in stops:
        name, place = stop.object, setup.places.get(stop.frame)
        if stop.kind != "release" or name not in grasped or name not in bodies or place is None:
            continue
        in_hand = inverse(scene.bodies[name].hand_in_body)
        put = body_box(scene.bodies[name], compose(scene.hand_pose(stop.frame, place), in_hand))
        now = body_box(scene.bodies[name], bodies[name])
        if (deep := -boxes_apart(now, put)[0]) > OVERLAP_M:
            return _overlapping(name, stop.frame, float(deep))
    return None


def _overlapping(first: str, second: str, deep_m: float, hint: str = "clear") -> Refusal:
    return Refusal("setup", first, second, 1000.0 * deep_m, "mm", hint)


def phases(
    fine: FinePath, scene: Scene, setup: Setup, look: ArmLook | None = None
) -> tuple[Phase, ...]:
    """Return what stands and what is carried, from grasp to release to grasp."""
    bodies = bodies_at(scene, setup, look)
    held = look.held if look else ""
    in_hand = _in_hand(scene, fine, held, bodies, look)
    bare = [name for name in bodies if not any(scene.bodies[name].hole_mm)]
    marks = frozenset(name for name in bare if scene.bodies[name].mass_kg == 0)
    found, first = [], 0
    fixed = fixed_things(scene)
    for stop in (*fine.stops, None):
        last = stop.at if stop else len(fine.u_s) - 1
        things = fixed + _standing(scene, bodies, held)
        carried = carried_body(scene, held, in_hand) if held else None
        if carried is not None:
            begin = fine.poses[first] if look is None or first else look.hand
            carried = carried.rested(np.stack([begin, fine.poses[last]]), things)
        excused: Mapping[tuple[str, str], float] = {}
        if look is not None and first == 0:
            excused = too_near(look.q, look.gripper_m, things, carried)
        found.append(Phase(first, last, things, carried, fine.stops, marks, excused))
        first = last
        if stop is not None:
            held, in_hand, bodies = _after(stop, fine, scene, held, in_hand, bodies)
    return tuple(found)


def _standing(scene: Scene, bodies: Bodies, held: str) -> tuple[Standing, ...]:
    boxes = {n: body_box(scene.bodies[n], pose) for n, pose in bodies.items() if n != held}
    return tuple(
        Standing(name, box, BESIDE_M) for name, box in boxes.items() if np.all(box.half > 0)
    )


def _in_hand(
    scene: Scene, fine: FinePath, held: str, bodies: Bodies, look: ArmLook | None
) -> Array:
    if look is not None and held in look.bodies:
        return compose(inverse(look.hand), look.bodies[held])
    return inverse(scene.bodies[held].hand_in_body) if held in scene.bodies else fine.poses[0]


def _after(
    stop: HandStop, fine: FinePath, scene: Scene, held: str, in_hand: Array, bodies: Bodies
) -> tuple[str, Array, dict[str, Array]]:
    bodies, hand = dict(bodies), fine.poses[stop.at]
    if stop.kind == "grasp":
        if stop.object in bodies:
            return stop.object, compose(inverse(hand), bodies[stop.object]), bodies
        return stop.object, in_hand, bodies
    if stop.kind == "release":
        if stop.object in scene.bodies:
            held_so = in_hand if held else inverse(scene.bodies[stop.object].hand_in_body)
            bodies[stop.object] = compose(hand, held_so)
        return "", in_hand, bodies
    if not held and stop.object in bodies and pushes(stop):
        before = fine.poses[push_begin(fine.stops, stop)]
        box = body_box(scene.bodies[stop.object], bodies[stop.object])
        bodies[stop.object] = pushed(bodies[stop.object], box, before, hand)
    return held, in_hand, bodies
