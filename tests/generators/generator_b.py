"""Human-like demonstrations, second kind: log-normal strokes along curved ways.

Other habits than the first kind: strokes have the skewed bell of the kinematic theory of
rapid movements; ways are arcs; the teacher idles before and after, looks for the thing near
the end of an approach, holds still in mid-air without reason, seldom rests between lifting
and carrying, and closes the hand while it still settles. Tasks also turn, pour and push.
"""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np

from assistant.geometry import Array, quat_from_rotvec, quat_from_rpy, quat_multiply
from assistant.model.demonstration import Demonstration, Recording
from assistant.model.setup import Place, Setup
from assistant.model.task import Action, Primitive, Subtask, Task, TaskObject
from tests.generators.shown import Habit, Shown, spoken_cues

_WIDE_M, _NARROW_M = 0.085, 0.03
_FREED = 0.6


@dataclass(slots=True)
class Track:
    """Speed-built motion: rows of place and rotation vector at a fixed fine step."""

    rng: np.random.Generator
    slow: float
    step_s: float
    place: Array
    turn: Array
    rows: list[Array] = field(default_factory=list)
    hand: list[float] = field(default_factory=list)
    opening_m: float = _WIDE_M

    @property
    def now_s(self) -> float:
        return len(self.rows) * self.step_s

    def stand(self, lasting_s: float) -> float:
        """Hold still with a slow sway; return the middle."""
        begin = self.now_s
        for _ in range(max(int(lasting_s / self.step_s), 1)):
            self._keep()
        return 0.5 * (begin + self.now_s)

    def stroke(self, place: Array, turn: Array, mean_speed: float) -> None:
        """Go along an arc with a log-normal speed profile."""
        way, spin = place - self.place, turn - self.turn
        length = float(np.linalg.norm(way)) + 0.12 * float(np.linalg.norm(spin))
        lasting = max(length / mean_speed, 0.5 * self.slow)
        count = max(int(lasting / self.step_s), 4)
        x = np.linspace(1e-3, 1.0, count)
        sharp = self.rng.uniform(0.35, 0.55)
        bell = np.exp(-0.5 * ((np.log(x) - np.log(0.38)) / sharp) ** 2) / x
        bell -= bell[-1] * x
        share = np.cumsum(np.maximum(bell, 0.0))
        share /= share[-1]
        side = np.cross(way, self.rng.normal(size=3))
        side *= self.rng.uniform(0.0, 0.12) * np.linalg.norm(way) / (np.linalg.norm(side) + 1e-9)
        start, begin = self.place.copy(), self.turn.copy()
        for s in share:
            self.place = start + s * way + np.sin(np.pi * s) * side
            self.turn = begin + s * spin
            self._keep()

    def go(self, place: Array, turn: Array, mean_speed: float, *, careful: bool = False) -> None:
        """Go somewhere: perhaps with an aimless halt on the way, perhaps feeling for the end."""
        if np.linalg.norm(place - self.place) > 0.12 and self.rng.random() < 0.25:
            middle = self.place + self.rng.uniform(0.3, 0.7) * (place - self.place)
            self.stroke(middle, 0.5 * (turn + self.turn), mean_speed)
            self.stand(self.rng.uniform(0.1, 0.5) * self.slow)
        if careful and self.rng.random() < 0.6:
            miss = self.rng.normal(0.0, 0.006, 3)
            self.stroke(place + miss, turn, mean_speed)
            self.stand(self.rng.uniform(0.05, 0.2) * self.slow)
            self.stroke(place, turn, 0.04 / self.slow)
        else:
            self.stroke(place, turn, mean_speed)

    def grip(self, opening_m: float) -> float:
        """Let the gripper run while the hand settles; return the instant of half its travel."""
        self.stand(self.rng.uniform(0.15, 0.5) * self.slow)
        lasting = self.rng.uniform(0.25, 0.9)
        count = max(int(lasting / self.step_s), 1)
        begin, start = self.now_s, self.opening_m
        for k in range(count):
            self.opening_m = start + (opening_m - start) * (k + 1) / count
            self._keep()
        self.stand(self.rng.uniform(0.1, 0.6) * self.slow)
        return begin + 0.5 * count * self.step_s

    def _keep(self) -> None:
        self.rows.append(np.concatenate([self.place, self.turn]))
        self.hand.append(self.opening_m)


@dataclass(slots=True)
class Story:
    """Primitives and cuts as they come about."""

    track: Track
    speed: float
    leaves: list[Primitive] = field(default_factory=list)
    cuts: list[float] = field(default_factory=list)

    def begin(self, name: str, action: Action, cut_s: float | None = None) -> None:
        """Begin a primitive; the cut lies in the middle of a rest unless an instant is given."""
        if self.leaves:
            rng, track = self.track.rng, self.track
            if cut_s is None:
                pause = rng.uniform(0.05, 0.9) if rng.random() < 0.8 else 0.0
                cut_s = track.stand(pause * track.slow)
            self.cuts.append(cut_s)
        self.leaves.append(Primitive(name, action))


def generate(seed: int, habit: Habit = "fluent") -> Shown:
    """Return one demonstration of a task made up from the seed."""
    rng = np.random.default_rng([seed, 22])
    slow = {"fluent": 1.0, "slow": 5.0, "keys": 1.5}[habit]
    step_s = {"fluent": 0.02, "slow": 0.1, "keys": 0.02}[habit]
    start = np.array([0.4, 0.0, 0.55]) + rng.normal(0.0, 0.03, 3)
    track = Track(rng, slow, step_s, start, np.zeros(3))
    story = Story(track, rng.uniform(0.12, 0.3) / slow**1.4)
    track.stand(rng.uniform(0.3, 1.5) * slow)
    kind = str(rng.choice(["carry", "carry", "stack", "pour", "push"]))
    told = {"carry": _carry, "stack": _stack, "pour": _pour, "push": _push}[kind](story)
    track.stand(rng.uniform(0.3, 1.5) * slow)
    recording, warp = _recorded(track, habit)
    cuts = [float(np.interp(cut, *warp)) for cut in story.cuts]
    cues = spoken_cues(cuts, float(recording.t_s[-1]), rng)
    bodies, places = told
    setup = Setup(places=places if rng.random() < 0.5 else {})
    # Drawn apart, so that what is shown does not depend on how it was introduced. Where nobody
    # tells where things are, nobody can tell which of two came first.
    freed = bool(setup.places) and np.random.default_rng([seed, 23]).random() < _FREED
    parts = _freed(story.leaves) if freed else tuple(story.leaves)
    task = Task(kind, Subtask(kind, parts), objects=bodies)
    shown = Demonstration(recording, cues, setup=setup, source=f"b {habit} {seed}")
    return Shown(shown, task, tuple(cuts), tuple(leaf.name for leaf in story.leaves))


Told = tuple[tuple[TaskObject, ...], dict[str, Place]]


def _freed(leaves: list[Primitive]) -> tuple[Subtask | Primitive, ...]:
    """Return two things' leaves as parts of any order, the one shown last told first."""
    of = {k: tuple(leaf for leaf in leaves if leaf.name.endswith(k)) for k in ("1", "2")}
    if not of["2"]:
        return tuple(leaves)
    parts = (Subtask("the other", of["2"]), Subtask("the one", of["1"]))
    rest = tuple(leaf for leaf in leaves if leaf not in of["1"] + of["2"])
    return (Subtask("both", parts, order="any"), *rest)


def _spot(rng: np.random.Generator, side: float) -> tuple[Array, Array]:
    place = np.array([rng.uniform(0.4, 0.62), side * rng.uniform(0.08, 0.3), 0.3])
    return place, np.array([0.0, 0.0, rng.uniform(-0.7, 0.7)])


def _told(place: Array, turn: Array) -> Place:
    x, y, z = (1000.0 * place).tolist()
    return Place("hand", (x, y, z), (0.0, 0.0, float(np.rad2deg(turn[2]))))


def _fetch(story: Story, thing: str, place: Array, turn: Array, cut_s: float | None) -> float:
    """Approach a thing from above and close on it; return the instant of closing."""
    story.begin(f"reach for {thing}", Action("move", "approach", thing), cut_s)
    above = place + np.array([0.0, 0.0, story.track.rng.uniform(0.05, 0.1)])
    story.track.go(above, turn, story.speed, careful=True)
    story.begin(f"grab {thing}", Action("hand", "close", thing))
    story.track.go(place, turn, 0.5 * story.speed, careful=True)
    return story.track.grip(_NARROW_M)


def _deliver(story: Story, thing: str, onto: str, place: Array, turn: Array, cut: float) -> float:
    """Raise the thing, carry it and let it go; return the instant of opening."""
    rng, track = story.track.rng, story.track
    up = np.array([0.0, 0.0, rng.uniform(0.08, 0.16)])
    story.begin(f"raise {thing}", Action("move", "up", thing), cut)
    track.go(track.place + up, track.turn, story.speed)
    story.begin(f"move over {onto} with {thing}", Action("move", "to", onto))
    over = np.array([place[0], place[1], track.place[2]])
    track.go(over, turn, story.speed, careful=True)
    story.begin(f"let go of {thing}", Action("hand", "open", onto))
    track.go(place, turn, 0.6 * story.speed, careful=True)
    return track.grip(_WIDE_M)


def _carry(story: Story) -> Told:
    rng = story.track.rng
    things = int(rng.choice([1, 1, 2]))
    places: dict[str, Place] = {}
    bodies: list[TaskObject] = []
    cut: float | None = None
    for k in range(1, things + 1):
        thing, onto = f"cup{k}", f"mat{k}"
        here, there = _spot(rng, 1.0), _spot(rng, -1.0)
        places |= {thing: _told(*here), onto: _told(*there)}
        bodies += [TaskObject(thing, "object"), TaskObject(onto, "target")]
        closed = _fetch(story, thing, *here, cut)
        cut = _deliver(story, thing, onto, *there, closed)
    if rng.random() < 0.7:
        story.begin("go home", Action("move", "up"), cut)
        track = story.track
        track.go(track.place + np.array([-0.05, 0.0, 0.2]), np.zeros(3), story.speed)
    return tuple(bodies), places


def _stack(story: Story) -> Told:
    rng = story.track.rng
    base = _spot(rng, -1.0)
    places = {"base": _told(*base)}
    bodies = [TaskObject("base", "target")]
    cut: float | None = None
    for k in (1, 2):
        here = _spot(rng, 1.0)
        places[f"brick{k}"] = _told(*here)
        bodies.append(TaskObject(f"brick{k}", "object"))
        closed = _fetch(story, f"brick{k}", *here, cut)
        top = base[0] + np.array([0.0, 0.0, 0.05 * k])
        cut = _deliver(story, f"brick{k}", "base", top, base[1], closed)
    return tuple(bodies), places


def _pour(story: Story) -> Told:
    track, rng = story.track, story.track.rng
    here, there = _spot(rng, 1.0), _spot(rng, -1.0)
    closed = _fetch(story, "jug", *here, None)
    story.begin("raise jug", Action("move", "up", "jug"), closed)
    track.go(track.place + np.array([0.0, 0.0, 0.15]), track.turn, story.speed)
    story.begin("move jug over bowl", Action("move", "to", "bowl"))
    track.go(there[0] + np.array([0.0, 0.0, 0.12]), there[1], story.speed, careful=True)
    story.begin("tip jug", Action("turn", "clockwise", "jug"))
    track.go(track.place, track.turn + np.array([1.6, 0.0, 0.0]), story.speed)
    story.begin("right jug", Action("turn", "counterclockwise", "jug"))
    track.go(track.place, track.turn - np.array([1.6, 0.0, 0.0]), story.speed)
    story.begin("put jug down", Action("move", "down", "jug"))
    track.go(here[0] + np.array([0.0, 0.05, 0.0]), here[1], story.speed, careful=True)
    opened = track.grip(_WIDE_M)
    story.begin("go back", Action("move", "backward"), opened)
    track.go(track.place - np.array([0.12, 0.0, 0.0]), track.turn, story.speed)
    bodies = (TaskObject("jug", "object"), TaskObject("bowl", "target"))
    return bodies, {"jug": _told(*here), "bowl": _told(*there)}


def _push(story: Story) -> Told:
    rng, track = story.track.rng, story.track
    here = _spot(rng, 1.0)
    track.opening_m = _WIDE_M
    story.begin("close hand", Action("hand", "close"))
    closed = track.grip(_NARROW_M)
    story.begin("go behind box", Action("move", "approach", "box"), closed)
    track.go(here[0], here[1], story.speed, careful=True)
    for name, way in (("push right", (0, -0.15, 0)), ("push forward", (0.12, 0, 0))):
        story.begin(name, Action("move", name.split()[1], "box"))
        track.go(track.place + np.array(way, dtype=float), track.turn, 0.6 * story.speed)
    story.begin("rise", Action("move", "up"))
    track.go(track.place + np.array([0.0, 0.0, rng.uniform(0.1, 0.2)]), track.turn, story.speed)
    return (TaskObject("box", "object"),), {"box": _told(*here)}


def _recorded(track: Track, habit: Habit) -> tuple[Recording, tuple[Array, Array]]:
    rng = track.rng
    rows, hand = np.array(track.rows), np.array(track.hand)
    t_s = np.arange(len(rows), dtype=np.float64) * track.step_s
    warp = (np.array([0.0, t_s[-1]]), np.array([0.0, t_s[-1]]))
    if habit == "keys":
        # Keys move the hand in jumps of a fixed size that it follows at a fixed speed.
        grid = np.array([0.008] * 3 + [0.05] * 3)
        rows = np.round(rows / grid) * grid
        for k in range(1, len(rows)):
            limit = np.array([0.0016] * 3 + [0.01] * 3)
            rows[k] = rows[k - 1] + np.clip(rows[k] - rows[k - 1], -limit, limit)
    sway = np.cumsum(rng.normal(0.0, 1.0, rows.shape), axis=0) * np.sqrt(track.step_s)
    sway -= np.linspace(0.0, 1.0, len(rows))[:, None] * sway[-1]
    size = np.array([4e-4] * 3 + [2e-3] * 3) * (0.0 if habit == "keys" else 1.0)
    shake = np.sin(2 * np.pi * rng.uniform(7.0, 11.0) * t_s[:, None] + rng.uniform(0, 6, 6))
    rows = rows + size * sway / np.sqrt(track.slow) + 0.3 * size * shake
    rows = rows + np.array([5e-5] * 3 + [3e-4] * 3) * rng.normal(size=rows.shape)
    if habit == "slow":
        keep = slice(0, None, max(round(0.5 / track.step_s), 1))
        t_s, rows, hand = t_s[keep], rows[keep], hand[keep]
    yaw = quat_from_rpy(np.stack([0 * t_s, 0 * t_s, rows[:, 5]], axis=1))
    tip = quat_from_rotvec(np.stack([rows[:, 3], rows[:, 4], 0 * t_s], axis=1))
    path = np.hstack([rows[:, :3], quat_multiply(yaw, tip)])
    return Recording(t_s, path, hand + rng.normal(0.0, 1e-4, len(t_s))), warp
