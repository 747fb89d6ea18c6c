"""A small lesson and a teacher who drives `step` directly, for the tests of the dialogue."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass, field
from typing import Any, Literal

import numpy as np

from assistant.dialogue import effects as fx
from assistant.dialogue import events as ev
from assistant.dialogue.machine import begin, step
from assistant.dialogue.state import Dialogue
from assistant.model import teacher_acts as acts
from assistant.model.conditions import Condition
from assistant.model.demonstration import Demonstration, Recording
from assistant.model.lesson import (
    Episode,
    LearnedPath,
    Lesson,
    Question,
    Segmentation,
    SegmentationPoint,
    Station,
)
from assistant.model.listening import Understanding
from assistant.model.motion import Alignment, ArmReport, ReportKind
from assistant.model.robot_acts import RobotAct
from assistant.model.scene import Body, Scene
from assistant.model.setup import Place, Setup
from assistant.model.task import Action, Primitive, Subtask, Task, TaskObject
from assistant.session.meaning import meant

STEPS = (
    "approach object",
    "grasp object",
    "move up object",
    "move object down to target",
    "place object on target",
)
SCENE = Scene(bodies={"block": Body("block"), "target": Body("target", mass_kg=0.0)})
SETUP = Setup(
    places={
        "block": Place("hand", (560.3, 196.8, 396.7)),
        "target": Place("hand", (588.8, -201.7, 403.0), (0.0, 0.0, 90.0)),
    }
)


def moved(name: str, by_mm: float) -> Setup:
    """Return a setup with the target elsewhere."""
    place = Place("hand", (588.8 - by_mm, -201.7, 403.0))
    return Setup(name=name, places={**SETUP.places, "target": place})


def demonstration() -> Demonstration:
    """Return a demonstration that nobody will look into."""
    t_s = np.linspace(0.0, 10.0, 11)
    path = np.tile(np.array([0.4, 0.0, 0.6, 0.0, 0.0, 0.0, 1.0]), (11, 1))
    return Demonstration(Recording(t_s, path, np.full(11, 0.08)), setup=SETUP)


def lesson(questions: tuple[Question, ...] = (), steps: Iterable[str] = STEPS) -> Lesson:
    """Return what such a demonstration might have taught."""
    names = tuple(steps)
    episodes = tuple(
        Episode(2.0 * at, 2.0 * at + 2.0, name, 0.9, "down") for at, name in enumerate(names)
    )
    points = tuple(
        SegmentationPoint(one.to_s, 0.8 + 0.01 * one.to_s, {"gripper": 0.9, "voice": 0.2})
        for one in episodes[:-1]
    )
    t_s = np.linspace(0.0, 10.0, 11)
    path = demonstration().recording.path
    learned = LearnedPath(t_s, path, np.full(11, 0.08), np.repeat(np.arange(5), [3, 2, 2, 2, 2]))
    stations = (
        _station("grasp", "block", names[min(1, len(names) - 1)]),
        _station("release", "target", names[-1]),
    )
    until = {
        "grasp object": (Condition("held", "block"),),
        "place object on target": (Condition("on", "block", "target"),),
    }
    found = Segmentation(points, episodes, 0.6, questions)
    return Lesson(found, learned, stations, {}, until)


def _station(kind: Literal["grasp", "release"], frame: str, primitive: str) -> Station:
    pose = SCENE.hand_pose(frame, SETUP.places[frame])
    own = np.array([0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0])
    return Station(kind, "block", frame, primitive, 5, 4, 6, pose, own, own)


def tree_task(learned: Lesson | None = None) -> Task:
    """Return pick-and-place as a file would give it."""
    pick = Subtask(
        "pick up object",
        (
            Primitive(STEPS[0], Action("move", "approach", "block")),
            Primitive(STEPS[1], Action("hand", "close", "block")),
            Primitive(STEPS[2], Action("move", "up", "block"), optional=True),
        ),
    )
    place = Subtask(
        "place object",
        (
            Primitive(STEPS[3], Action("move", "down", "target")),
            Primitive(STEPS[4], Action("hand", "open", "target")),
        ),
    )
    things = (TaskObject("block", "object"), TaskObject("target", "target"))
    return Task("pick and place", Subtask("pick and place", (pick, place)), "done", things, learned)


@dataclass
class Lessons:
    """A teacher at the machine; `effects` and `lines` hold what the last event led to."""

    dialogue: Dialogue = field(default_factory=begin)
    effects: tuple[fx.Effect, ...] = ()
    every: list[fx.Effect] = field(default_factory=list)
    steps: tuple[str, ...] = STEPS
    groups: tuple[str, str] = ("pick up object", "place object")

    def happen(self, event: ev.Event) -> Lessons:
        self.dialogue, self.effects = step(self.dialogue, event)
        self.every.extend(self.effects)
        return self

    def hear(
        self, *meant: acts.TeacherAct, text: str = "", sure: float = 1.0, voice: bool = False
    ) -> Lessons:
        understood = Understanding(meant, sure, text)
        return self.happen(ev.Heard(text, understood, voice, sure if voice else 1.0))

    def tell(self, value: str | int | tuple[str, ...]) -> Lessons:
        return self.hear(acts.Inform(value), text=str(value))

    @property
    def lines(self) -> list[RobotAct]:
        return [one.line for one in self.effects if isinstance(one, fx.Say)]

    @property
    def topics(self) -> list[str]:
        return [f"{one.act}.{one.topic}" for one in self.lines]

    @property
    def asked(self) -> str | None:
        asked = [one.asked for one in self.lines if one.asked]
        return asked[-1] if asked else None

    @property
    def things(self) -> tuple[TaskObject, ...]:
        return self.dialogue.known.objects or ()

    def did(self, kind: type[fx.Effect]) -> bool:
        return any(isinstance(one, kind) for one in self.effects)

    def open(self, task: Task | None = None, saved: tuple[str, ...] = ()) -> Lessons:
        return self.happen(ev.Begun(SCENE, SETUP, task, saved))

    def introduce(self) -> Lessons:
        self.open()
        self.tell("pick and place").tell("the block rests on the target")
        self.tell(("block", "target")).tell(2).tell(self.groups[0]).tell(self.groups[1])
        self.tell(3)
        for name in self.steps[:3]:
            self.tell(name)
        self.tell(2).tell(self.steps[3]).tell(self.steps[4])
        if self.asked == "subtask_count":
            self.tell(0)
        return self

    def confirmed(self) -> Lessons:
        return self.introduce().hear(acts.Affirm())

    def learned(self, *questions: Question) -> Lessons:
        self.confirmed().hear(acts.Start()).hear(acts.Approve())
        self.happen(ev.Shown(demonstration()))
        return self.happen(ev.Learned(lesson(questions, self.steps)))

    def ready(self) -> Lessons:
        return self.learned().hear(acts.Affirm())

    def moving(self) -> Lessons:
        self.hear(acts.Start())
        return self.happen(ev.Checked(self.dialogue.known.setup, None, 12.0))

    def report(self, kind: ReportKind, at: int = -1, **told: Any) -> Lessons:
        return self.happen(ev.ArmReported(ArmReport(kind, 1.0, at, **told)))

    def finish(self) -> Lessons:
        for at in range(5):
            self.report("primitive", at)
            if at == 0:
                self.report("perceived", at, text="docked", object="block")
            if at == 1:
                self.report("perceived", at, text="held", object="block")
        self.report("perceived", 4, text="on", object="block", target="target")
        alignment = Alignment("block", "target", 0.04, 0.02)
        return self.happen(ev.ArmReported(ArmReport("finished", 9.0, 4, alignments=(alignment,))))

    def run(self) -> Lessons:
        return self.moving().finish()

    def agreed(self) -> Lessons:
        self.ready().run().hear(acts.Affirm())
        self.happen(ev.Arranged(moved("two", 30.0), SCENE))
        self.happen(ev.Checked(self.dialogue.known.setup, None, 9.0))
        return self.run().hear(acts.Approve())


def said(teacher: Lessons, text: str) -> Lessons:
    """Let a teacher say something that is understood as the program understands it."""
    dialogue = teacher.dialogue
    found = meant(dialogue, text, 1.0, dialogue.language)
    return teacher.hear(*found.acts, text=text, sure=found.confidence)
