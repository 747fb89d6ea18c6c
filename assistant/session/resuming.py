"""Going on with a journal: what was told, shown and found out is fed back; nothing moves.

Events are fed to the dialogue again and their effects are not carried out. What the last
events still owed (a learning that was under way, lines not said yet) is then done; motion
is never taken up again, only told of.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field, replace

from assistant.dialogue import effects as wanted
from assistant.dialogue import events
from assistant.dialogue.machine import step
from assistant.dialogue.state import Dialogue
from assistant.model.transcript import Happened, Restart, RobotLine, Step, TeacherLine
from assistant.session.happenings import from_happened
from assistant.session.loop import Session
from assistant.session.watching import Watching, read_back

ANSWERS: dict[type, type] = {
    wanted.Learn: events.Learned,
    wanted.Check: events.Checked,
    wanted.Keep: events.Kept,
    wanted.Load: events.Loaded,
    wanted.Discard: events.Kept,
    wanted.EndRecording: events.Shown,
    wanted.Arrange: events.Arranged,
}
"""Which event answers which effect."""


@dataclass(slots=True)
class Fed:
    """What is left to do after a journal has been fed back.

    Attributes
    ----------
    lines : list of Say
        Of the last event; those already said are taken off.
    owed : list of Effect
        Whose answers are missing.
    recorded_s : float or None
        How much of a demonstration was being watched; None if none was.
    before_leaving : Dialogue or None
        Where the conversation stood when the teacher left it.
    """

    lines: list[wanted.Say] = field(default_factory=list)
    owed: list[wanted.Effect] = field(default_factory=list)
    recorded_s: float | None = None
    before_leaving: Dialogue | None = None


def feed(session: Session, steps: Sequence[Step]) -> Fed:
    """Bring a fresh session to where the journal ends, moving and computing nothing."""
    fed = Fed()
    for past in steps:
        if isinstance(past, RobotLine) and fed.lines:
            fed.lines.pop(0)
        if isinstance(past, Restart):
            _reopen(session, fed)
        event = _event(session, past)
        if event is not None:
            _take(session, fed, event, past)
    _reopen(session, fed)
    if motion_pending(session):
        fed.owed = [one for one in fed.owed if not isinstance(one, wanted.Check)]
    if session.watching is not None:
        fed.recorded_s = session.watching.now_s
        session.watching.go_on()
    return fed


def _reopen(session: Session, fed: Fed) -> None:
    """Take back that the teacher left, or was about to: the conversation goes on."""
    dialogue = fed.before_leaving or session.dialogue
    if session.left or (dialogue.pending is not None and dialogue.pending.leave):
        session.dialogue = replace(dialogue, pending=None, leaving=False)
        fed.lines = []
    session.left, fed.before_leaving = False, None


def motion_pending(session: Session) -> bool:
    """Return whether the arm was moving, halted on its way, or about to move."""
    dialogue = session.dialogue
    looking = dialogue.run is not None and dialogue.run.purpose == "look"
    halted_midway = dialogue.in_motion or dialogue.arm == "paused"
    return halted_midway or (dialogue.arm == "checking" and not looking)


def _event(session: Session, past: Step) -> events.Event | None:
    if isinstance(past, TeacherLine):
        sure = 1.0 if past.by_voice is None else past.by_voice
        understood = session.understood(past.text, sure)
        return events.Heard(past.text, understood, past.by_voice is not None, sure)
    if isinstance(past, Happened):
        return from_happened(past.result, session.journal.folder)
    return None


def _take(session: Session, fed: Fed, event: events.Event, past: Step) -> None:
    if session.watching is not None and isinstance(event, events.Heard):
        at_s = past.at_s if isinstance(past, TeacherLine) else None
        session.watching.hear(event.text, event.understanding, at_s)
    _settle(session, fed, event)
    before = session.dialogue
    session.dialogue, effects = step(session.dialogue, event)
    fed.lines = [effect for effect in effects if isinstance(effect, wanted.Say)]
    for effect in effects:
        _owe(session, fed, effect)
    if session.left and fed.before_leaving is None:
        fed.before_leaving = before


def _settle(session: Session, fed: Fed, event: events.Event) -> None:
    answered = next((one for one in fed.owed if isinstance(event, ANSWERS[type(one)])), None)
    if answered is not None:
        fed.owed.remove(answered)
        session.workplace.drawn += isinstance(answered, wanted.Arrange)
    match event:
        case events.Begun() | events.Arranged() | events.Checked(refusal=None):
            session.mover.setup = event.setup
            if not isinstance(event, events.Checked):
                session.mover.scene = event.scene
        case events.Shown():
            session.watching = None
        case _:
            pass


def _owe(session: Session, fed: Fed, effect: wanted.Effect) -> None:
    if isinstance(effect, wanted.Record):
        session.recordings += 1
        path = session.journal.folder / f"recording_{session.recordings}.csv"
        session.watching = Watching(path, read_back(path))
    elif isinstance(effect, wanted.EndRecording) and not effect.keep:
        session.watching = None
    elif isinstance(effect, wanted.Arrange):
        session.mover.scene = effect.scene or session.mover.scene
        session.mover.setup = effect.setup or session.mover.setup
        if effect.random:
            fed.owed.append(effect)
    elif isinstance(effect, wanted.Leave):
        session.left = True
    elif type(effect) in ANSWERS:
        fed.owed.append(effect)
