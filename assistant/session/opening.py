"""Opening a session: its folder and journal, where things are; and going on with an old one."""

from __future__ import annotations

import tempfile
from collections.abc import Callable
from dataclasses import dataclass, replace
from pathlib import Path
from types import MappingProxyType

from assistant.dialogue import asking, events
from assistant.files.finding import find_setups
from assistant.files.library import Library
from assistant.files.scenes import find_scene
from assistant.files.tasks import read_task
from assistant.language.phrasebook import phrasebook
from assistant.language.speech import check_spoken
from assistant.model.robot_acts import RobotAct
from assistant.model.scene import Scene
from assistant.model.setup import Setup
from assistant.model.transcript import Happened, Restart, SetupChoice, Transcript
from assistant.session import halting
from assistant.session.equipment import EquipmentMaker
from assistant.session.journal import Journal
from assistant.session.loop import Out, Session
from assistant.session.resuming import Fed, feed, motion_pending

FIRST_SETUP = "demonstration"


@dataclass(frozen=True, slots=True)
class Opening:
    """What every session of one program shares.

    Parameters
    ----------
    equipment : callable
        Makes arm, planner and hands.
    home : Path
        Has ``sessions`` and ``tasks`` below it.
    out : callable
        Told every robot line.
    made : callable
        Given the session before its first line, so that whoever tells lines can look at it.
    """

    equipment: EquipmentMaker
    home: Path
    out: Out
    made: Callable[[Session], None] = lambda session: None

    @property
    def sessions(self) -> Path:
        """Where journals live."""
        return self.home / "sessions"

    @property
    def library(self) -> Library:
        """The kept tasks."""
        return Library(self.home / "tasks")


def open_session(opening: Opening, header: Transcript, *, fed: bool = False) -> Session:
    """Begin a new session as a transcript's head says."""
    # A language that is not understood or spoken is told before anything is written or said.
    phrasebook(header.language)
    check_spoken(header.language)
    base = Path(header.source).parent if header.source else Path()
    scene, setup = chosen(header.setup or SetupChoice(name=FIRST_SETUP), base)
    path = base / header.task if header.task else None
    task = read_task(path) if path is not None else None
    journal = _new_journal(opening, replace(header, steps=()))
    session = _session(opening, journal, header, fed=fed)
    if not fed:
        session.begin(scene, setup, task, path)
    return session


def _begin_anew(session: Session, header: Transcript) -> None:
    """Begin a session that was killed before its first event was written."""
    scene, setup = chosen(header.setup or SetupChoice(name=FIRST_SETUP), Path())
    path = Path(header.task) if header.task else None
    session.begin(scene, setup, read_task(path) if path is not None else None, path)


def _session(opening: Opening, journal: Journal, header: Transcript, *, fed: bool) -> Session:
    equipment = opening.equipment("kinematic" if fed else header.arm)
    session = Session(equipment, journal, opening.out, opening.library, header.language, fed=fed)
    opening.made(session)
    return session


def _new_journal(opening: Opening, header: Transcript) -> Journal:
    try:
        journal = Journal(_new_folder(opening.sessions))
    except OSError as error:
        journal = Journal(Path(tempfile.gettempdir()))
        journal.fail(error)
        return journal
    journal.create(header)
    return journal


def _new_folder(sessions: Path) -> Path:
    sessions.mkdir(parents=True, exist_ok=True)
    number = max((int(path.name) for path in sessions.iterdir() if path.name.isdigit()), default=0)
    while True:
        number += 1
        try:
            (sessions / str(number)).mkdir()
        except FileExistsError:
            continue
        return sessions / str(number)


def resume_session(opening: Opening, name: str) -> Session:
    """Go on with a session that was left or killed.

    Raises
    ------
    BadInput
        If there is no such session.
    WorkFailed
        If another program has it open.
    """
    journal = Journal(opening.sessions / name)
    past = journal.resume()
    session = _session(opening, journal, past, fed=False)
    session.workplace.store.learn_names()
    if not any(isinstance(step, Happened) for step in past.steps):
        _begin_anew(session, past)
        return session
    fed = feed(session, past.steps)
    session.mover.arrange(session.mover.scene, session.mover.setup)
    journal.write(Restart())
    _go_on(session, fed)
    return session


def reopen_session(opening: Opening, session: Session) -> Session:
    """Drop a session's memory and resume it from what was flushed."""
    session.close()
    return resume_session(opening, session.journal.name)


def _go_on(session: Session, fed: Fed) -> None:
    session.tell_trouble()
    _tell_resumed(session, fed)
    for owed in (*fed.lines, *fed.owed):
        session.do(owed)
    if motion_pending(session):
        session.happen(events.Halted(halting.INTERRUPTED))


def _tell_resumed(session: Session, fed: Fed) -> None:
    slots = {} if fed.recorded_s is None else {"recorded_s": fed.recorded_s}
    topic = "resumed" if fed.recorded_s is None else "resumed_recording"
    session.tell(RobotAct("report", topic, slots=MappingProxyType(slots)))
    told_all = not fed.lines and not fed.owed and fed.recorded_s is None
    if told_all and not motion_pending(session):
        asked = asking.question(session.dialogue)
        for line in session.dialogue.said if asked is None else (asked,):
            session.tell(line)


def chosen(choice: SetupChoice, base: Path) -> tuple[Scene, Setup]:
    """Return the scene and setup a choice names.

    Raises
    ------
    BadInput
        If there is no such setup or scene.
    """
    if choice.setup is not None:
        return find_scene(choice.setup.scene, base), choice.setup
    setups, path = find_setups(choice.file or choice.name or FIRST_SETUP, base)
    return find_scene(setups[0].scene, path), setups[0]
