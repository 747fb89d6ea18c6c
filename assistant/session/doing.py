"""What the dialogue wants done, done: what it results in comes back as an event."""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING

from assistant.dialogue import asking, events
from assistant.dialogue import effects as wanted
from assistant.errors import BadInput, NothingLearned
from assistant.model.motion import Refusal
from assistant.session import halting, keeping

if TYPE_CHECKING:
    from assistant.session.loop import Session

NO_SETUP = "no_setup"
HAND_KEYS = {"open": "o", "close": "c"}
"""While the hand is driven by keys, words about it press the keys that mean the same."""


def do(session: Session, effect: wanted.Effect) -> None:
    """Carry out one effect; where results are fed back, only what is said."""
    if session.fed and not isinstance(effect, wanted.Say | wanted.Leave):
        return
    match effect:
        case wanted.Say():
            session.say(effect.line)
        case wanted.Record():
            session.record()
        case wanted.EndRecording():
            session.end_recording(keep=effect.keep)
        case wanted.Learn():
            session.happen(learned(session, effect))
        case wanted.Keep():
            kept = keeping.keep(
                session.library, effect.task, effect.name, overwrite=effect.overwrite
            )
            session.happen(kept)
        case wanted.Load():
            session.happen(keeping.load(session.library, effect.name))
        case wanted.Discard():
            session.happen(keeping.discard(session.library, effect.name))
        case wanted.WriteDown():
            session.happen(keeping.write_down(session.library, effect.task, effect.name))
        case wanted.Arrange():
            _arrange(session, effect)
        case wanted.Leave():
            session.left = True
        case _:
            _move(session, effect)


def _move(
    session: Session,
    effect: wanted.Check
    | wanted.Move
    | wanted.Replay
    | wanted.GoOn
    | wanted.SetHand
    | wanted.Jog
    | wanted.Home
    | wanted.Halt,
) -> None:
    mover = session.mover
    if mover.latches(effect):
        return
    refusal: Refusal | None = None
    match effect:
        case wanted.Check():
            session.happen(mover.check(effect))
        case wanted.Move():
            mover.move(effect)
        case wanted.Replay():
            refusal = mover.replay(effect)
        case wanted.GoOn():
            refusal = mover.go_on(anew=effect.anew) if mover.under_way else _from_start(session)
        case wanted.SetHand() if session.driven is not None:
            session.driven.press(HAND_KEYS[effect.command])
        case wanted.SetHand():
            refusal = mover.set_hand(effect.command)
        case wanted.Jog():
            refusal = mover.jog(effect.offset_m, effect.turn_rad)
        case wanted.Home():
            refusal = mover.home(effect.setup)
        case wanted.Halt():
            mover.halt(effect.why)
    if refusal is not None:
        session.happen(events.Checked(mover.setup, refusal))


def _from_start(session: Session) -> Refusal | None:
    """Begin a run that was under way in an earlier life of the session: all is in place again."""
    check = asking.check(session.dialogue)
    found = session.mover.check(check)
    if found.refusal is None:
        slow = session.dialogue.pace == "slow"
        session.mover.move(wanted.Move(check.task, check.setup, check.speed, slow))
    return found.refusal


def learned(session: Session, effect: wanted.Learn) -> events.Learned:
    """Learn, and tell why nothing was learned if so."""
    # Smoothing takes a second to import; a session that never learns is spared it.
    from assistant.learning.lesson import learn

    session.store.taught = effect.task
    try:
        lesson = learn(
            effect.demonstrations,
            effect.task,
            cuts_s=effect.cuts_s,
            assigned=effect.assigned,
            scene=session.mover.scene,
        )
    except NothingLearned as error:
        return events.Learned(None, error.why or str(error), error.facts)
    except BadInput as error:
        return events.Learned(None, str(error.problems[0]))
    return events.Learned(lesson)


def _arrange(session: Session, effect: wanted.Arrange) -> None:
    mover = session.mover
    if mover.moving and not mover.braking:
        mover.halt(halting.REARRANGED)
    if mover.latches(effect):
        return
    scene = effect.scene or mover.scene
    setup = effect.setup or mover.setup
    if not effect.random:
        mover.arrange(scene, setup)
        return
    session.drawn += 1
    drawn = session.equipment.new_setup(session.dialogue.known.task, scene, setup, session.drawn)
    if drawn is None:
        refusal = Refusal("setup", NO_SETUP)
        session.happen(events.Checked(setup, refusal))
        return
    drawn = replace(drawn, name=f"new {session.drawn}")
    mover.arrange(scene, drawn)
    session.happen(events.Arranged(drawn, scene))
