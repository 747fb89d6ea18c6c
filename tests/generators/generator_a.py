"""Human-like demonstrations, first kind: sums of minimum-jerk submovements with rests.

Written from what is known of people's reaching, not from what the segmenter looks for: a
motion is one large submovement and one or two small corrections that overlap it; the hand
rests, hesitates in the middle of things, trembles and drifts; transitions are sometimes a
rest and sometimes run into each other. With keys, the hand goes in equal steps along axes.
"""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np

from assistant.geometry import Array, quat_from_rpy
from assistant.model.demonstration import Demonstration, Recording
from assistant.model.setup import Place, Setup
from assistant.model.task import Action, Primitive, Subtask, Task, TaskObject
from tests.generators.shown import Habit, Shown, spoken_cues

OPEN_M, CLOSED_M = 0.08, 0.04


@dataclass(slots=True)
class Play:
    """What happens, written down as it is made up: submovements, ramps of the gripper, cuts."""

    rng: np.random.Generator
    scale: float
    at_s: float = 0.0
    here: Array = field(default_factory=lambda: np.zeros(6))
    moves: list[tuple[float, float, Array]] = field(default_factory=list)
    ramps: list[tuple[float, float, float]] = field(default_factory=list)
    rests: list[tuple[float, float]] = field(default_factory=list)

    def go(self, there: Array, speed_m_s: float) -> None:
        """Reach a pose (xyz, rpy) by a main submovement and corrections that overlap it."""
        way = there - self.here
        length = float(np.linalg.norm(way[:3]) + 0.1 * np.linalg.norm(way[3:]))
        parts = [1.0]
        if length > 0.03 and self.rng.random() < 0.7:
            first = self.rng.uniform(0.8, 1.08)
            parts = [first, 1.0 - first]
        if length > 0.08 and self.rng.random() < 0.3:
            parts = [0.45, parts[0] - 0.45, *parts[1:]]
        start = self.at_s
        for part in parts:
            lasting = max(abs(part) * length / speed_m_s * 1.5, 0.35 * self.scale)
            bend = self.rng.normal(0.0, 0.02 * length, 6) * np.array([1, 1, 1, 0, 0, 0])
            self.moves.append((start, lasting, part * way))
            self.moves.append((start, 0.6 * lasting, bend))
            self.moves.append((start + 0.4 * lasting, 0.6 * lasting, -bend))
            self.at_s = start + lasting
            if abs(part) > 0.3 and part != parts[-1] and self.rng.random() < 0.15:
                start = self.at_s + self.rng.uniform(0.15, 0.6) * self.scale
            else:
                start = start + lasting * self.rng.uniform(0.62, 0.85)
            self.at_s = max(self.at_s, start)
        self.at_s = max(at + lasting for at, lasting, _ in self.moves)
        self.here = there.copy()

    def rest(self, lasting_s: float) -> float:
        """Rest, and return the middle of the rest."""
        self.rests.append((self.at_s, self.at_s + lasting_s))
        self.at_s += lasting_s
        return self.at_s - lasting_s / 2.0

    def hand(self, opening_m: float) -> float:
        """Move the gripper during a rest, and return the instant of half its travel."""
        self.at_s += self.rng.uniform(0.1, 0.5) * self.scale
        ramp = self.rng.uniform(0.2, 0.6) * min(self.scale, 2.0)
        self.ramps.append((self.at_s, ramp, opening_m))
        middle = self.at_s + ramp / 2.0
        self.at_s += ramp + self.rng.uniform(0.1, 0.4) * self.scale
        return middle


def generate(seed: int, habit: Habit = "fluent") -> Shown:
    """Return one demonstration of a task made up from the seed."""
    rng = np.random.default_rng([seed, 11])
    scale = {"fluent": 1.0, "slow": 4.0, "keys": 1.0}[habit]
    play = Play(rng, scale, here=np.array([0.406, 0.0, 0.635, 0.0, 0.0, 0.0]))
    pairs = int(rng.choice([1, 1, 2]))
    leaves: list[Primitive] = []
    cuts: list[float] = []
    places: dict[str, Place] = {}
    play.at_s = rng.uniform(0.2, 0.8) * scale
    lift, grasp, away = rng.random() < 0.8, rng.random() < 0.75, rng.random() < 0.6
    opened: float | None = None
    for pair in range(1, pairs + 1):
        block, target = f"block {pair}", f"target {pair}"
        object_at = _somewhere(rng, 1.0)
        target_at = _somewhere(rng, -1.0)
        places[block], places[target] = _place(object_at), _place(target_at)
        habits = (lift, grasp, away)
        more, opened = _pair(play, block, target, object_at, target_at, cuts, habits, opened)
        leaves += more
    play.rest(rng.uniform(0.2, 0.8) * scale)
    parts = tuple(leaves)
    bodies = [TaskObject(n, "object" if n.startswith("block") else "target") for n in places]
    task = Task("made up", Subtask("made up", parts), objects=tuple(bodies))
    recording, warp = _sampled(play, habit)
    told = [float(np.interp(cut, *warp)) for cut in cuts]
    spoken = spoken_cues(told, float(recording.t_s[-1]), rng)
    setup = Setup(places=places if rng.random() < 0.7 else {})
    shown = Demonstration(recording, spoken, setup=setup, source=f"a {habit} {seed}")
    return Shown(shown, task, tuple(told), tuple(leaf.name for leaf in parts))


def _somewhere(rng: np.random.Generator, side: float) -> Array:
    xyz = [rng.uniform(0.42, 0.6), side * rng.uniform(0.1, 0.28), rng.uniform(0.3, 0.42)]
    return np.array([*xyz, 0.0, 0.0, np.deg2rad(rng.uniform(-40, 40))])


def _place(pose: Array) -> Place:
    xyz, rpy = 1000.0 * pose[:3], np.rad2deg(pose[3:])
    return Place("hand", (xyz[0], xyz[1], xyz[2]), (rpy[0], rpy[1], rpy[2]))


def _pair(
    play: Play,
    block: str,
    target: str,
    object_at: Array,
    target_at: Array,
    cuts: list[float],
    habits: tuple[bool, bool, bool],
    opened_s: float | None,
) -> tuple[list[Primitive], float | None]:
    """Carry one block to its target; with habits (lifts, names the grasp, goes away).

    Returns the primitives, and when the hand opened if that is where the next one begins.
    """
    rng, (lift, grasp, away) = play.rng, habits
    speed = rng.uniform(0.10, 0.22) / play.scale**1.5
    leaves: list[Primitive] = []

    def between() -> None:
        pause = 0.0 if rng.random() < 0.2 else rng.uniform(0.15, 1.2) * play.scale
        cuts.append(play.rest(pause))

    if opened_s is not None:
        cuts.append(opened_s)
    back = np.array([np.cos(object_at[5]), np.sin(object_at[5]), 0, 0, 0, 0])
    docked = object_at - rng.uniform(0.03, 0.06) * back
    leaves.append(Primitive(f"approach {block}", Action("move", "approach", block)))
    play.go(docked, speed)
    if grasp:
        between()
        leaves.append(Primitive(f"grasp {block}", Action("hand", "close", block)))
    play.go(object_at, 0.5 * speed)
    cuts.append(play.hand(CLOSED_M))
    if lift:
        leaves.append(Primitive(f"lift {block}", Action("move", "up", block)))
        play.go(object_at + np.array([0, 0, rng.uniform(0.06, 0.14), 0, 0, 0]), speed)
        between()
    above = target_at + np.array([0, 0, rng.uniform(0.03, 0.05), 0, 0, 0])
    leaves.append(Primitive(f"carry {block} to {target}", Action("move", "approach", target)))
    play.go(above, speed)
    if grasp:
        between()
        leaves.append(Primitive(f"place {block} on {target}", Action("hand", "open", target)))
    play.go(target_at, 0.5 * speed)
    opened = play.hand(OPEN_M)
    if away:
        cuts.append(opened)
        leaves.append(Primitive(f"leave {target}", Action("move", "depart", target)))
        back = np.array([np.cos(target_at[5]), np.sin(target_at[5]), 0, 0, 0, 0])
        play.go(target_at - rng.uniform(0.06, 0.12) * back, speed)
        return leaves, play.rest(rng.uniform(0.15, 1.2) * play.scale)
    return leaves, opened


def _sampled(play: Play, habit: Habit) -> tuple[Recording, tuple[Array, Array]]:
    """Return the recording, and how times of the play map to times of the recording."""
    rng = play.rng
    rate_hz = 2.0 if habit == "slow" else 50.0
    t_s = np.arange(0.0, play.at_s, 1.0 / rate_hz)
    start = play.here - sum((way for _, _, way in play.moves), np.zeros(6))
    coordinates = np.tile(start, (len(t_s), 1))
    for at, lasting, way in play.moves:
        share = np.clip((t_s - at) / lasting, 0.0, 1.0)
        coordinates += (share**3 * (10 - 15 * share + 6 * share**2))[:, None] * way
    gripper = np.full(len(t_s), OPEN_M)
    for at, lasting, opening in play.ramps:
        share = np.clip((t_s - at) / lasting, 0.0, 1.0)
        gripper += share * (opening - gripper)
    warp = (np.array([0.0, play.at_s]), np.array([0.0, play.at_s]))
    if habit == "keys":
        t_s, coordinates, gripper, warp = _stop_and_go(t_s, coordinates, gripper, play)
    drift = np.cumsum(rng.normal(0.0, 1.0, (len(t_s), 6)), axis=0) / np.sqrt(max(len(t_s), 1))
    size = np.array([1e-3] * 3 + [4e-3] * 3)
    tremor_hz = rng.uniform(8.0, 12.0)
    tremble = np.sin(2 * np.pi * tremor_hz * t_s[:, None] + rng.uniform(0, 6, 6))
    if habit != "keys":
        coordinates = coordinates + size * (drift + 0.2 * tremble * rng.uniform(0.3, 1.0))
    coordinates = coordinates + 0.1 * size * rng.normal(size=coordinates.shape)
    path = np.hstack([coordinates[:, :3], quat_from_rpy(coordinates[:, 3:])])
    gripper = gripper + rng.normal(0.0, 2e-4, len(t_s))
    return Recording(t_s, path, gripper), warp


def _stop_and_go(
    t_s: Array, coordinates: Array, gripper: Array, play: Play
) -> tuple[Array, Array, Array, tuple[Array, Array]]:
    """Replay a motion with keys: equal steps along one axis at a time, with pauses between."""
    rng = play.rng
    step = np.array([0.01] * 3 + [0.06] * 3)
    rows, hands, origin = [coordinates[0].copy()], [gripper[0]], [t_s[0]]
    here = coordinates[0].copy()
    for target, hand, at in zip(coordinates[5::5], gripper[5::5], t_s[5::5], strict=False):
        far = np.abs(target - here) / step
        while np.max(far) > 1.0:
            axis = int(np.argmax(far))
            away = np.sign(target[axis] - here[axis]) * step[axis]
            for share in np.linspace(0.1, 1.0, 10):
                row = here.copy()
                row[axis] += away * share
                rows.append(row)
                hands.append(hand)
                origin.append(at)
            here[axis] += away
            for _ in range(int(rng.integers(0, 8) if rng.random() < 0.9 else rng.integers(8, 40))):
                rows.append(here.copy())
                hands.append(hand)
                origin.append(at)
            far = np.abs(target - here) / step
        for _ in range(5):
            rows.append(here.copy())
            hands.append(hand)
            origin.append(at)
    times = np.arange(len(rows), dtype=np.float64) * 0.02
    grown = np.maximum.accumulate(np.array(origin)) + 1e-9 * times
    return times, np.array(rows), np.array(hands), (grown, times)
