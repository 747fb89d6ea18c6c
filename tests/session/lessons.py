"""A teacher in a few lines: answers whatever the robot asks, wherever the lesson stands."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

from assistant.cli.adapters import make_equipment
from assistant.model.robot_acts import RobotAct
from assistant.model.transcript import Demonstrate, Transcript
from assistant.session.acting import demonstrate
from assistant.session.loop import Session
from assistant.session.opening import Opening, open_session

HEAD = Transcript("a lesson", arm="kinematic")
NAMES = {
    (1,): "pick up object",
    (2,): "place object",
    (1, 1): "approach object",
    (1, 2): "grasp object",
    (1, 3): "move up object",
    (2, 1): "move object down to target",
    (2, 2): "place object on target",
}
COUNTS = {(): "two", (1,): "three", (2,): "two"}
ANSWERS = {
    "task_name": "pick and place",
    "goal": "the block rests on the target",
    "objects": "the block and the target",
    "confirm_tree": "yes",
    "confirm_segmentation": "yes",
    "optional": "yes",
    "order": "no",
    "ready": "go",
    "satisfied": "yes",
    "did_you_mean": "no",
    "actions": "open the hand at the target",
    "unsaved": "yes",
}


class Heard:
    """Remembers what the robot says."""

    def __init__(self) -> None:
        self.lines: list[tuple[RobotAct, str]] = []

    def __call__(self, line: RobotAct, text: str) -> None:
        self.lines.append((line, text))

    @property
    def topics(self) -> list[str]:
        return [f"{line.act}.{line.topic}" for line, _ in self.lines]


def opening(home: Path, heard: Heard | None = None) -> Opening:
    return Opening(make_equipment, home, heard or Heard())


def opened(home: Path, heard: Heard | None = None) -> Session:
    return open_session(opening(home, heard), HEAD)


def answer(session: Session) -> str:
    """What the teacher says to the question that is open."""
    asked = session.listening.asked
    index = index_asked(session)
    if asked == "subtask_name":
        return NAMES[index]
    if asked == "subtask_count":
        return COUNTS.get(index, "none")
    return ANSWERS[asked or "satisfied"]


def index_asked(session: Session) -> tuple[int, ...]:
    lines = [line for line in session.dialogue.said if line.about is not None]
    return lines[-1].about.index if lines and lines[-1].about is not None else ()


def lesson(session: Session, seed: int = 0) -> Iterator[None]:
    """Go on with the lesson by one step at a time until the task is saved."""
    for _ in range(200):
        if session.dialogue.saved_as:
            return
        if session.watching is not None:
            if session.watching.samples:
                session.hear("start over")
            else:
                demonstrate(session, Demonstrate(seed=seed, cues=None), Path())
        elif session.moving:
            session.rest()
        elif session.dialogue.arm in ("stopped", "paused"):
            session.hear("start")
        elif session.listening.asked == "ready" and needs_new_setup(session):
            session.hear("new setup")
            session.hear("go")
        else:
            session.hear(answer(session))
        yield
    raise AssertionError("the lesson does not come to its end")


def needs_new_setup(session: Session) -> bool:
    """The robot agrees after two different setups."""
    return session.dialogue.pace == "normal" and bool(session.dialogue.clean)


def hold(session: Session, seed: int = 0) -> None:
    for _ in lesson(session, seed):
        pass


def until_it_moves(session: Session) -> None:
    """Hold a lesson up to the moment at which the arm begins to move."""
    for _ in lesson(session):
        if session.moving:
            return
    raise AssertionError("the lesson ended and the arm never moved")
