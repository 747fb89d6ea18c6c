"""One task shown several times by one teacher, with the habits of either generator.

The teacher tells a sequence; whether its parts may come in another order, and whether lifting
may be left out, shows only in what is done from one demonstration to the next. Where the hand
docks is the teacher's intention, which each demonstration misses a little.
"""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Literal

import numpy as np

from assistant.geometry import Array
from assistant.model.demonstration import Demonstration
from assistant.model.setup import Place, Setup
from assistant.model.task import Action, Primitive, Subtask, Task, TaskObject
from tests.generators import generator_a, generator_b
from tests.generators.shown import Habit, Shown, spoken_cues

THINGS = ("cup", "jar")
_BEFORE_M, _ABOVE_M, _MISSED_M, _MISSED_RAD = 0.045, 0.035, 0.004, 0.02
_LEFT_OUT, _OTHER_ORDER = 0.4, 0.5


@dataclass(frozen=True, slots=True, eq=False)
class Several:
    """Demonstrations of one task.

    Parameters
    ----------
    task : Task
        As introduced: in sequence, nothing optional.
    shows : tuple of Shown
    docking : mapping of "grasp" or "release" to array, shape (3,)
        Where the hand docks, seen from where it acts.
    any_order : bool
        The parts may come in any order.
    optional : frozenset of str
        Primitives that may be left out.
    """

    task: Task
    shows: tuple[Shown, ...]
    docking: dict[str, Array]
    any_order: bool
    optional: frozenset[str]


@dataclass(slots=True)
class Hand:
    """One of the two kinds of motion, behind the same few words."""

    kind: Literal["A", "B"]
    habit: Habit
    rng: np.random.Generator
    cuts: list[float] = field(default_factory=list)
    names: list[str] = field(default_factory=list)
    play: generator_a.Play = field(init=False)
    track: generator_b.Track = field(init=False)
    speed: float = field(init=False)
    acted_s: float | None = None

    def __post_init__(self) -> None:
        start = np.array([0.406, 0.0, 0.6, 0.0, 0.0, 0.0])
        slow = {"fluent": 1.0, "slow": 4.0, "keys": 1.0}[self.habit]
        step_s = {"fluent": 0.02, "slow": 0.1, "keys": 0.02}[self.habit]
        self.play = generator_a.Play(self.rng, slow, here=start, at_s=0.5 * slow)
        self.track = generator_b.Track(self.rng, slow, step_s, start[:3], start[3:])
        self.speed = float(self.rng.uniform(0.12, 0.22)) / slow**1.4
        self.track.stand(0.5 * slow)

    def begin(self, name: str) -> None:
        """Begin a primitive: where the hand has acted, or in the middle of a rest."""
        if self.names:
            pause = 0.0 if self.rng.random() < 0.2 else float(self.rng.uniform(0.15, 0.9))
            rest = self.play.rest if self.kind == "A" else self.track.stand
            at_s = self.acted_s
            self.cuts.append(rest(pause * self.play.scale) if at_s is None else at_s)
        self.acted_s = None
        self.names.append(name)

    def go(self, there: Array, share: float = 1.0) -> None:
        missed = np.array([_MISSED_M] * 3 + [_MISSED_RAD] * 3) * self.rng.normal(size=6)
        there = there + (missed if share == 1.0 else 0.25 * missed)
        if self.kind == "A":
            self.play.go(there, share * self.speed)
        else:
            self.track.go(there[:3], there[3:], share * self.speed, careful=share < 1.0)

    def act(self, opening_m: float) -> None:
        self.acted_s = self.play.hand(opening_m) if self.kind == "A" else self.track.grip(opening_m)

    def shown(self, task: Task, places: dict[str, Place], lag_s: float) -> Shown:
        if self.kind == "A":
            self.play.rest(0.5 * self.play.scale)
            recording, warp = generator_a._sampled(self.play, self.habit)
        else:
            self.track.stand(0.5 * self.track.slow)
            recording, warp = generator_b._recorded(self.track, self.habit)
        cuts = [float(np.interp(cut, *warp)) for cut in self.cuts]
        cues = spoken_cues(cuts, float(recording.t_s[-1]), self.rng, lag_s)
        demonstration = Demonstration(recording, cues, setup=Setup(places=places))
        return Shown(demonstration, task, tuple(cuts), tuple(self.names))


def several(seed: int, count: int, kind: Literal["A", "B"], habit: Habit = "fluent") -> Several:
    """Return a task made up from the seed, shown so many times; fewer are the first of more."""
    rng = np.random.default_rng([seed, 33])
    any_order, optional = bool(rng.random() < 0.5), bool(rng.random() < 0.5)
    lag_s = float(rng.uniform(0.1, 1.8))
    tree = Subtask("tidy up", tuple(_bring(thing) for thing in THINGS))
    bodies = [TaskObject(thing, "object") for thing in THINGS]
    bodies += [TaskObject(f"{thing} place", "target") for thing in THINGS]
    task = Task("tidy up", tree, objects=tuple(bodies))
    shows = []
    for k in range(count):
        hand = Hand(kind, habit, np.random.default_rng([seed, k, 34]))
        order = THINGS[::-1] if any_order and hand.rng.random() < _OTHER_ORDER else THINGS
        places: dict[str, Place] = {}
        for thing in order:
            lifts = not (optional and hand.rng.random() < _LEFT_OUT)
            places |= _brought(hand, thing, lifts=lifts)
        shows.append(hand.shown(task, places, lag_s))
    docking = {"grasp": np.array([-_BEFORE_M, 0, 0]), "release": np.array([0, 0, _ABOVE_M])}
    lifts_told = frozenset(f"lift {thing}" for thing in THINGS)
    return Several(task, tuple(shows), docking, any_order, lifts_told if optional else frozenset())


def _bring(thing: str) -> Subtask:
    onto = f"{thing} place"
    leaves = (
        Primitive(f"approach {thing}", Action("move", "approach", thing)),
        Primitive(f"grasp {thing}", Action("hand", "close", thing)),
        Primitive(f"lift {thing}", Action("move", "up", thing)),
        Primitive(f"carry {thing}", Action("move", "to", onto)),
        Primitive(f"put down {thing}", Action("hand", "open", onto)),
    )
    return Subtask(f"bring {thing}", leaves)


def _brought(hand: Hand, thing: str, *, lifts: bool) -> dict[str, Place]:
    rng = hand.rng
    near = np.array([rng.uniform(0.42, 0.6), rng.uniform(0.1, 0.28), 0.3, 0, 0, 0])
    far = np.array([rng.uniform(0.42, 0.6), rng.uniform(-0.28, -0.1), 0.3, 0, 0, 0])
    near[5], far[5] = rng.uniform(-0.6, 0.6, 2)
    back = _BEFORE_M * np.array([np.cos(near[5]), np.sin(near[5]), 0, 0, 0, 0])
    rise = np.array([0, 0, rng.uniform(0.08, 0.14), 0, 0, 0])
    above = np.array([0, 0, _ABOVE_M, 0, 0, 0])
    hand.begin(f"approach {thing}")
    hand.go(near - back)
    hand.begin(f"grasp {thing}")
    hand.go(near, 0.5)
    hand.act(generator_a.CLOSED_M)
    if lifts:
        hand.begin(f"lift {thing}")
        hand.go(near + rise)
    hand.begin(f"carry {thing}")
    hand.go(far + above)
    hand.begin(f"put down {thing}")
    hand.go(far, 0.5)
    hand.act(generator_a.OPEN_M)
    return {thing: _place(near), f"{thing} place": _place(far)}


def _place(pose: Array) -> Place:
    xyz, rpy = (1000.0 * pose[:3]).tolist(), np.rad2deg(pose[3:]).tolist()
    return Place("hand", (xyz[0], xyz[1], xyz[2]), (rpy[0], rpy[1], rpy[2]))
