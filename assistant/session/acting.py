"""Steps a program or a transcript takes as the teacher: showing the task, letting time pass."""

from __future__ import annotations

import json
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

from assistant.errors import WorkFailed
from assistant.files.demonstrations import read_demonstration
from assistant.files.transcripts import transcript_of
from assistant.language.hints import page
from assistant.model.robot_acts import RobotAct
from assistant.model.transcript import Demonstrate, Step, Wait
from assistant.plain_yaml import read_text
from assistant.ports import Hand, HandSample
from assistant.session import halting
from assistant.session.loop import Session


def one_step(told: Mapping[str, Any]) -> Step:
    """Return the transcript step a mapping stands for.

    Raises
    ------
    BadInput
        If it stands for none.
    """
    # A transcript of one step is checked like any other, with the same messages.
    play = {"format": "transcript/1", "title": "one step", "steps": [told]}
    return transcript_of(read_text(json.dumps(play, ensure_ascii=False), "input")[0]).steps[0]


def wait(session: Session, step: Wait) -> None:
    """Let simulated time pass: seconds, or until the arm rests."""
    if step.seconds is None:
        session.rest()
    else:
        session.pass_s(step.seconds)


def demonstrate(session: Session, step: Demonstrate, base: Path) -> None:
    """Show the task.

    Parameters
    ----------
    session : Session
    step : Demonstrate
    base : Path
        The folder a recording's path is relative to.

    Raises
    ------
    WorkFailed
        If the robot is not at the point of watching.
    """
    if session.watching is None and session.listening.stage == "demonstration":
        # The robot still asks whether to begin.
        session.hear(_for_teacher(session, "begin"))
    if session.watching is None:
        raise WorkFailed(
            f"the robot is not watching (stage {session.listening.stage}, "
            f"asked {session.listening.asked}); introduce the task first"
        )
    step = _found(step, base)
    mover = session.mover
    hand = session.equipment.hand(step, session.dialogue.known.task, mover.scene, mover.setup)
    session.watch(_InOwnWords(hand, page("terminal", session.language)["scripted"]))
    if session.watching is not None:
        if step.cues or step.key_states:
            session.watching.declare(step.cues or (), step.key_states)
        session.end_recording(keep=True)


@dataclass(frozen=True, slots=True)
class _InOwnWords:
    """A hand whose ready-made cues are said in the session's language."""

    hand: Hand
    words: Mapping[str, str]

    def samples(self) -> Iterator[HandSample]:
        """Yield the hand's samples."""
        for sample in self.hand.samples():
            if not sample.said:
                yield sample
                continue
            told = (self.words.get(one, one) for one in sample.said.split(", "))
            yield replace(sample, said=", ".join(told))


def _found(step: Demonstrate, base: Path) -> Demonstrate:
    """Return the step with its file's whole path, and what a demonstration file says was said."""
    if step.recording is None:
        return step
    path = (base / step.recording).resolve()
    if path.suffix not in (".yaml", ".yml") or step.cues or step.key_states:
        return replace(step, recording=str(path))
    shown = read_demonstration(path)
    return replace(step, recording=str(path), cues=shown.cues, key_states=shown.key_states)


def wants_to_leave(session: Session) -> bool:
    """End the conversation as "quit" does; return whether it goes on, with a question perhaps.

    Whoever closes the line once more instead of answering is gone.
    """
    pending = session.dialogue.pending
    if pending is not None and pending.leave:
        return False
    session.hear(_for_teacher(session, "quit"))
    return not session.left and session.dialogue.pending is not None


def leave(session: Session, why: str = halting.NOBODY, *, tells: bool = False) -> None:
    """End the conversation because nobody is there any more: stop, then quit.

    What was not saved stays in the journal and can be resumed.

    Parameters
    ----------
    session : Session
    why : str
    tells : bool
        Somebody may still read it: unsaved work is told to be kept, as the question whether to
        save it gets no answer.
    """
    if session.moving:
        session.halt(why)
        session.rest()
    if not session.left:
        session.hear(_for_teacher(session, "quit"))
    if tells and not session.left and not session.journal.trouble:
        session.tell(RobotAct("report", "left_unsaved"))


def _for_teacher(session: Session, what: str) -> str:
    """Return what is said for the teacher, in the session's language."""
    return str(page("terminal", session.language)["for_teacher"][what])
