"""A hand that carries out a task in a scene as a person would, with spoken cues; seeded."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import Literal

import numpy as np

from assistant.model.demonstration import Demonstration, Recording, Spoken
from assistant.model.scene import Scene
from assistant.model.setup import Setup
from assistant.model.task import Task, primitives
from assistant.ports import HandSample
from sim.a465 import GRIPPER
from sim.hands.grasping import within_reach
from sim.hands.habits import Habits
from sim.hands.motion import RATE_HZ, Shown, move
from sim.hands.recorded import spoken_samples
from sim.hands.route import Leg, route

NEXT = ("then", "next step", "next", "and then", "now")
LAST = ("finally", "last step", "then")


class ScriptedHand:
    """The Hand port: shows a task as a teacher with habits would.

    Parameters
    ----------
    task : Task
        The tree to carry out.
    scene : Scene
    setup : Setup
        Where things are.
    seed : int
        Same seed, same demonstration.
    cues : "auto" or sequence of Spoken
        ``auto``: at the transitions, late as this teacher is.
    habits : Habits, optional
        Otherwise drawn with the seed.
    rate_hz : float
        50 by default; 2 is the paper's sampling.
    """

    def __init__(
        self,
        task: Task,
        scene: Scene,
        setup: Setup,
        seed: int = 0,
        cues: Literal["auto"] | Sequence[Spoken] = "auto",
        habits: Habits | None = None,
        rate_hz: float = RATE_HZ,
    ) -> None:
        self.setup = setup
        scene = within_reach(scene, setup)
        habits = habits or Habits.of_seed(seed)
        random = np.random.default_rng([seed, 0])
        legs = route(task, scene, setup, habits.retreat_m)
        start = setup.robot_start.pose
        shown = move(start, GRIPPER.open_m, legs, habits, random)
        self.cuts_s = _cuts(legs, shown)
        """Where the primitives really change, in s."""
        voice = np.random.default_rng([seed, 2])
        end_s = (len(shown.poses) - 1) / RATE_HZ
        auto = _auto_cues(self.cuts_s, len(primitives(task.tree)), habits, voice, end_s)
        self.cues = auto if isinstance(cues, str) else tuple(cues)
        told = _key_states(legs, shown, habits, voice) if isinstance(cues, str) else ()
        self.key_states = told
        self.recording = _recording(shown, rate_hz)

    def samples(self) -> Iterator[HandSample]:
        """Yield the samples with what is said."""
        recording, spoken = self.recording, (*self.cues, *self.key_states)
        yield from spoken_samples(recording.t_s, recording.path, recording.gripper_m, spoken)

    def demonstration(self) -> Demonstration:
        """Return the whole demonstration at once."""
        return Demonstration(
            self.recording, self.cues, self.key_states, self.setup, "x", "scripted"
        )


def _recording(shown: Shown, rate_hz: float) -> Recording:
    every = max(1, round(RATE_HZ / rate_hz))
    t_s = np.arange(len(shown.poses)) / RATE_HZ
    path, openings = np.array(shown.poses), np.array(shown.openings)
    return Recording(t_s[::every], path[::every], openings[::every])


def _cuts(legs: Sequence[Leg], shown: Shown) -> tuple[float, ...]:
    """Return the middle of the rest between two primitives, or the gripper's instant there."""
    cuts = []
    for k, leg in enumerate(legs[:-1]):
        if legs[k + 1].primitive == leg.primitive:
            continue
        first = k - 1 if legs[k - 1].kind == "grip" else k
        begin = shown.leg_ends[first - 1] if first else 0
        end = shown.leg_ends[first]
        cuts.append((begin + end) / 2.0 / RATE_HZ)
    return tuple(cuts)


def _auto_cues(
    cuts_s: Sequence[float],
    count: int,
    habits: Habits,
    random: np.random.Generator,
    end_s: float,
) -> tuple[Spoken, ...]:
    cues = []
    if count > 1:
        cues.append(Spoken(round(float(random.uniform(0.1, 0.4)), 2), "first step"))
    for k, cut in enumerate(cuts_s):
        late = habits.cue_lag_s + random.normal(0.0, habits.cue_jitter_s)
        word = LAST if k == len(cuts_s) - 1 else NEXT
        says = str(random.choice(word))
        if random.uniform() >= habits.cue_missing:
            cues.append(Spoken(round(float(np.clip(cut + late, 0.0, end_s)), 2), says))
        if random.uniform() < habits.cue_false:
            cues.append(Spoken(round(float(random.uniform(0.0, end_s)), 2), "then"))
    return tuple(sorted(cues, key=lambda cue: cue.at_s))


def _key_states(
    legs: Sequence[Leg], shown: Shown, habits: Habits, random: np.random.Generator
) -> tuple[Spoken, ...]:
    told = []
    for leg, end in zip(legs, shown.leg_ends, strict=True):
        if leg.says and random.uniform() < habits.key_states:
            told.append(Spoken(round(end / RATE_HZ + float(random.uniform(0.1, 0.5)), 2), leg.says))
    return tuple(told)
