"""A session killed at any instant goes on with nothing lost."""

from __future__ import annotations

import os
import signal
from pathlib import Path
from typing import Any

import pytest

from assistant.files import transcripts
from assistant.files.demonstrations import read_demonstration
from assistant.files.transcripts import read_transcript
from assistant.model.transcript import Happened, Restart, Step, TeacherLine
from assistant.session import journal as journal_module
from assistant.session.loop import Session
from assistant.session.opening import resume_session
from assistant.session.past import newest_session
from assistant.session.watching import Watching
from tests.session.lessons import Heard, hold, opened, opening


def outcome(session: Session) -> dict[str, Any]:
    """What was learned, without what tells how often the session was interrupted."""
    view = session.dialogue_view
    names = ("task", "feedback", "speed", "saved_as", "agreed", "facing")
    return {name: view[name] for name in names} | {"cuts_s": view["lesson"]["cuts_s"]}


@pytest.fixture(scope="module")
def whole(tmp_path_factory: pytest.TempPathFactory) -> tuple[dict[str, Any], int]:
    """The outcome of a lesson that nobody interrupts, and how many steps its journal has."""
    home = tmp_path_factory.mktemp("whole")
    session = opened(home)
    hold(session)
    session.close()
    steps = read_transcript(home / "sessions" / "1" / "journal.yaml").steps
    return outcome(session), len(steps)


def die() -> None:
    os.kill(os.getpid(), signal.SIGKILL)


def kill_at_step(number: int, torn: float) -> None:
    """Die while the given step is written; that share of its text reaches the disk."""
    append, count = transcripts.append_step, 0

    def append_or_die(path: Path, step: Step) -> None:
        nonlocal count
        count += 1
        if count < number:
            append(path, step)
            return
        before = path.stat().st_size
        append(path, step)
        after = path.stat().st_size
        os.truncate(path, before + round(torn * (after - before)))
        die()

    vars(journal_module)["append_step"] = append_or_die


def kill_at_sample(number: int) -> None:
    see, count = Watching.see, 0

    def see_or_die(watching: Watching, sample: Any) -> None:
        nonlocal count
        count += 1
        see(watching, sample)
        if count == number:
            die()

    # Never undone: what is killed needs nothing back.
    pytest.MonkeyPatch().setattr(Watching, "see", see_or_die)


def in_a_process_of_its_own(home: Path, prepare: Any) -> None:
    """Hold the lesson in a child that is killed by SIGKILL."""
    child = os.fork()
    if child == 0:
        try:
            prepare()
            hold(opened(home))
        finally:
            os._exit(0)
    _, status = os.waitpid(child, 0)
    assert os.WIFSIGNALED(status)
    assert os.WTERMSIG(status) == signal.SIGKILL


def resumed(home: Path, heard: Heard | None = None) -> Session:
    return resume_session(opening(home, heard), newest_session(home / "sessions"))


@pytest.mark.parametrize(
    ("part", "torn"),
    [
        (0.0, 0.3),
        (0.02, 0.4),
        (0.3, 1.0),
        (0.5, 0.0),
        (0.6, 0.6),
        (0.7, 1.0),
        (0.85, 0.5),
        (0.99, 0.0),
    ],
)
def test_killed_while_writing(
    tmp_path: Path, whole: tuple[dict[str, Any], int], part: float, torn: float
) -> None:
    expected, count = whole
    in_a_process_of_its_own(tmp_path, lambda: kill_at_step(round(part * count) or 1, torn))
    told = teacher_lines(tmp_path)
    session = resumed(tmp_path)
    assert not session.moving
    assert teacher_lines(tmp_path)[: len(told)] == told
    hold(session)
    session.close()
    assert outcome(session) == expected


def teacher_lines(home: Path) -> list[str]:
    path = home / "sessions" / "1" / "journal.yaml"
    steps = read_transcript(path, resume=True).steps
    return [step.says for step in steps if isinstance(step, TeacherLine)]


def test_killed_while_the_task_is_shown(tmp_path: Path) -> None:
    in_a_process_of_its_own(tmp_path, lambda: kill_at_sample(300))
    heard = Heard()
    session = resumed(tmp_path, heard)
    assert session.watching is not None
    assert len(session.watching.samples) == 300
    assert [cue.say for cue in session.watching.cues][:1] == ["first step"]
    assert heard.topics == ["report.resumed_recording"]
    session.hear("finished")
    session.close()
    kept = read_demonstration(session.journal.folder / "demonstration_1.yaml")
    assert len(kept.recording.t_s) == 300
    assert kept.cues[0].say == "first step"


def test_killed_again_and_again(tmp_path: Path, whole: tuple[dict[str, Any], int]) -> None:
    expected, count = whole
    in_a_process_of_its_own(tmp_path, lambda: kill_at_step(count // 4, 1.0))
    for step in (5, 9, 13):
        child = os.fork()
        if child == 0:
            try:
                kill_at_step(step, 0.3)
                hold(resumed(tmp_path))
            finally:
                os._exit(0)
        os.waitpid(child, 0)
    session = resumed(tmp_path)
    hold(session)
    session.close()
    assert outcome(session) == expected
    steps = read_transcript(tmp_path / "sessions" / "1" / "journal.yaml").steps
    assert sum(isinstance(step, Restart) for step in steps) >= 2


def test_a_resumed_session_computes_and_moves_nothing(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    session = opened(tmp_path)
    hold(session)
    session.close()
    monkeypatch.setattr("assistant.learning.lesson.learn", forbidden)
    monkeypatch.setattr("assistant.learning.adaptation.adapt", forbidden)
    monkeypatch.setattr("sim.kinematic_arm.KinematicArm.start", forbidden)
    again = resumed(tmp_path)
    assert outcome(again) == outcome(session)
    again.close()


def forbidden(*args: object, **more: object) -> None:
    raise AssertionError("nothing may be computed or moved")


def test_a_journal_tells_results(tmp_path: Path) -> None:
    session = opened(tmp_path)
    hold(session)
    session.close()
    steps = read_transcript(tmp_path / "sessions" / "1" / "journal.yaml").steps
    kinds = {next(iter(step.result)) for step in steps if isinstance(step, Happened)}
    assert {"begun", "shown", "learned", "checked", "arm", "arranged", "kept"} <= kinds
