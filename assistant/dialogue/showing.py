"""While the teacher shows the task: watch, keep quiet, know when it is over (paper II-B)."""

from __future__ import annotations

from dataclasses import replace

from assistant.dialogue.asking import ask, learn, tell
from assistant.dialogue.effects import EndRecording, Halt, Record, SetHand
from assistant.dialogue.events import Shown
from assistant.dialogue.knowledge import Knowledge
from assistant.dialogue.one_step import shown_step
from assistant.dialogue.state import AwaitingShow, Dialogue, Pending, Watching
from assistant.dialogue.turn import Turn, changed, line, say, then
from assistant.model import teacher_acts as acts
from assistant.model.demonstration import Demonstration
from assistant.model.robot_acts import About


def watch(dialogue: Dialogue) -> Turn:
    """Begin to record the teacher's hand."""
    step = dialogue.state.step if isinstance(dialogue.state, AwaitingShow) else ""
    watching = replace(dialogue, state=Watching(step=step), pending=None)
    told = line("report", "watching", about=About(dialogue.known.name))
    return then(say(watching, told), Record())


FORGET = "forget_earlier"
"""The question whether what was shown before is to be forgotten."""


def begin(dialogue: Dialogue) -> Turn:
    """Watch; what was shown before and led to nothing good is asked about first."""
    state, known = dialogue.state, dialogue.known
    whole = isinstance(state, AwaitingShow) and not state.step
    failed = dialogue.refusal is not None or dialogue.runs or dialogue.halt is not None
    if not (whole and known.demonstrations and failed) or dialogue.clean:
        return watch(dialogue)
    question = line("confirm", FORGET, asked="ready", about=About(known.name))
    return ask(replace(dialogue, pending=Pending("ready", question)))


def begun(dialogue: Dialogue, act: acts.TeacherAct) -> Turn | None:
    """Watch after a yes or no to whether what was shown before is forgotten; undo brings it back.

    None where the teacher went on to something else.
    """
    free = replace(dialogue, pending=None)
    match act:
        case acts.Affirm() | acts.Approve():
            return watch(_without_earlier(free))
        case acts.Deny():
            return watch(free)
        case acts.Start():
            return tell(dialogue, line("told", "yes_or_no"))
        case _:
            return None


def _without_earlier(dialogue: Dialogue) -> Dialogue:
    known = replace(dialogue.known, demonstrations=(), cuts_s=None, assigned=(), reviewed=False)
    return changed(dialogue, "demonstration", known)


def while_watching(dialogue: Dialogue, act: acts.TeacherAct) -> Turn:
    """Answer what is said during a demonstration; markers and chat are met with silence."""
    match act:
        case acts.Approve() | acts.Affirm():
            over = replace(dialogue, state=Watching("learn", _step(dialogue)))
            return over, (EndRecording(keep=True),)
        case acts.Stop():
            over = replace(dialogue, state=Watching("ask", _step(dialogue)))
            told = line("stopped", "while_shown")
            return first_halt(then(say(over, told), EndRecording(keep=True)))
        case acts.Again() | acts.GoBack("demonstration") | acts.Deny() | acts.Undo():
            return _start_over(dialogue)
        case acts.Gripper(command):
            return dialogue, (SetHand(command),)
        case acts.Pause():
            return say(dialogue, line("told", "waiting"))
        case _:
            return dialogue, ()


def first_halt(turn: Turn) -> Turn:
    """Return the turn with a stop of the arm before anything else."""
    return turn[0], (Halt("stop"), *turn[1])


def _start_over(dialogue: Dialogue) -> Turn:
    waiting = replace(dialogue, state=AwaitingShow(_step(dialogue)))
    told = tell(waiting, line("report", "start_over"))
    return told[0], (EndRecording(keep=False), *told[1])


def _step(dialogue: Dialogue) -> str:
    return dialogue.state.step if isinstance(dialogue.state, Watching) else ""


def shown(dialogue: Dialogue, event: Shown) -> Turn:
    """Take what was shown; learn from it unless it was broken off."""
    if not isinstance(dialogue.state, Watching):
        return dialogue, ()
    ending, step = dialogue.state.ending, dialogue.state.step
    waiting = replace(dialogue, state=AwaitingShow(step))
    if event.demonstration is None:
        return tell(waiting, line("error", "not_shown", reason=event.why_not))
    if step:
        return shown_step(waiting, step, event.demonstration)
    known = with_demonstration(dialogue.known, event.demonstration)
    kept = changed(waiting, "demonstration", known)
    if ending == "ask":
        whole = line("confirm", "whole_demonstration", asked="satisfied")
        return ask(replace(kept, pending=Pending("satisfied", whole, (acts.Approve(),))))
    return learn(kept)


def with_demonstration(known: Knowledge, shown: Demonstration) -> Knowledge:
    """Return what is known with one more demonstration and the places it told."""
    places = {**known.setup.places, **shown.setup.places}
    return replace(
        known,
        demonstrations=(*known.demonstrations, shown),
        cuts_s=None,
        assigned=(),
        reviewed=False,
        setup=replace(known.setup, places=places),
    )
