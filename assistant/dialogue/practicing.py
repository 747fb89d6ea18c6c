"""Practice: check, move, announce, perceive, halt, and agree in the end (paper III-D b)."""

from __future__ import annotations

from dataclasses import replace

from assistant.dialogue.asking import ask, begin_run, check, places, tell
from assistant.dialogue.effects import Arrange, GoOn, Halt
from assistant.dialogue.events import Arranged, Halted
from assistant.dialogue.state import (
    Dialogue,
    Ran,
    Ready,
    Running,
    Thinking,
    Watching,
)
from assistant.dialogue.turn import (
    Turn,
    changed,
    first,
    line,
    say,
    then,
)
from assistant.model.robot_acts import RobotAct
from assistant.model.task import primitives

UNTIL = "begin_until"
"""The question whether to begin anew and pause after a step."""


def halted(dialogue: Dialogue, event: Halted) -> Turn:
    """Take a halt from outside the dialogue: a stop word, a key, a closed window."""
    return stopped(dialogue, event.why) if dialogue.can_halt else (dialogue, ())


def stopped(dialogue: Dialogue, why: str) -> Turn:
    """Tell that the arm stands still and why; it waits for a new start."""
    if dialogue.arm == "homing":
        return not_home(dialogue, line("stopped", "stop.home", why=why))
    run = dialogue.run and replace(dialogue.run, interrupted=True)
    told = line("stopped", "stop", why=why)
    return say(replace(dialogue, arm="stopped", pending=None, run=run, halt=told), told)


def not_home(dialogue: Dialogue, told: RobotAct) -> Turn:
    """Tell why the hand is not back where it starts; no run waits to be gone on with."""
    return tell(replace(dialogue, arm="rest"), told)


def stop(dialogue: Dialogue) -> Turn:
    """Halt whatever is going on; grip and knowledge are kept."""
    match dialogue.arm:
        case "homing":
            return first((Halt("stop"),), stopped(dialogue, "stop"))
        case "moving" | "checking" | "paused":
            turn = stopped(replace(dialogue, state=Running()), "stop")
            return first((Halt("stop"),), turn)
        case _ if isinstance(dialogue.state, Thinking | Watching):
            return first((Halt("stop"),), say(dialogue, line("told", "still")))
        case _:
            return say(dialogue, line("told", "still"))


def pause(dialogue: Dialogue) -> Turn:
    """Halt for a while; going on needs only a word."""
    if dialogue.arm == "moving":
        return first((Halt("pause"),), say(replace(dialogue, arm="paused"), line("told", "paused")))
    if dialogue.arm in ("checking", "homing"):
        return stop(dialogue)
    # Before anything could move, "wait" asks for time.
    practice = isinstance(dialogue.state, Ready | Ran | Running | Thinking | Watching)
    return say(dialogue, line("told", "still" if practice else "waiting"))


def begun_until(turn: Turn, asked: RobotAct) -> Turn:
    """Return the turn with its run to be paused after the step that a question named, if any."""
    dialogue = turn[0]
    if asked.topic != UNTIL or dialogue.run is None:
        return turn
    names = [leaf.name for leaf in primitives(dialogue.known.task.tree)]
    position = names.index(asked.slots["name"]) if asked.slots["name"] in names else -1
    return replace(dialogue, run=replace(dialogue.run, pause_after=position)), turn[1]


def pause_there(dialogue: Dialogue) -> Turn:
    """Pause where the teacher wanted to be once more."""
    run = dialogue.run
    leaves = primitives(dialogue.known.task.tree)
    if run is None:
        return dialogue, ()
    told = line("told", "paused_after", name=leaves[run.pause_after].name)
    paused = replace(dialogue, arm="paused", run=replace(run, pause_after=-1))
    return first((Halt("pause"),), say(paused, told))


def resume(dialogue: Dialogue) -> Turn:
    """Go on after a pause; after a stop only a start will do, at rest it begins a run."""
    if dialogue.arm == "stopped":
        return say(dialogue, line("told", "say_start"))
    if dialogue.arm == "paused":
        return go_on(dialogue)
    if dialogue.busy:
        return say(dialogue, line("told", "moving_already"))
    if any(said.act == "stopped" for said in dialogue.said):
        return tell(dialogue, line("told", "say_start"))
    return begin_run(dialogue)


def go_on(dialogue: Dialogue) -> Turn:
    """Move again from where the arm is, planned and checked anew."""
    run = dialogue.run
    if run is None:
        return begin_run(dialogue)
    if run.corrected and run.purpose == "practice":
        anew = replace(run, anew=True, setup=dialogue.known.setup)
        after = replace(dialogue, arm="checking", run=anew)
        return after, (check(after, anew=True),)
    told = line("told", "going_on")
    return then(say(replace(dialogue, arm="moving", state=Running()), told), GoOn(anew=True))


def start(dialogue: Dialogue) -> Turn:
    """Begin a run, or go on with the one that was halted."""
    if dialogue.busy:
        return say(dialogue, line("told", "moving_already"))
    if dialogue.arm in ("paused", "stopped") and dialogue.run is not None:
        if not dialogue.run.checked:
            return begin_run(dialogue)
        return go_on(dialogue)
    return begin_run(dialogue)


def again(dialogue: Dialogue) -> Turn:
    """Put things back and carry out the setup from its beginning."""
    if dialogue.busy:
        return say(dialogue, line("told", "moving_already"))
    return begin_run(replace(dialogue, arm="rest"))


def new_setup(dialogue: Dialogue) -> Turn:
    """Ask for an arrangement nobody has seen."""
    if dialogue.busy:
        return say(dialogue, line("error", "while_moving"))
    known = dialogue.known
    if known.lesson is None:
        return tell(dialogue, line("error", "nothing_learned"))
    return replace(dialogue, arm="rest"), (Arrange(known.setup, known.scene, random=True),)


def arranged(dialogue: Dialogue, event: Arranged) -> Turn:
    """Read back where things are now, and look whether they can be reached."""
    known = replace(dialogue.known, setup=event.setup, scene=event.scene)
    if known == dialogue.known:
        return dialogue, ()
    after = changed(dialogue, "setup", known, clean=dialogue.clean)
    told = line("read_back", "setup", setup=event.setup.name, places=places(after.known))
    if isinstance(dialogue.state, Ready | Ran | Running):
        at_rest = replace(after, state=Ready(), arm="rest")
        return first(say(at_rest, told)[1], begin_run(at_rest, look=True))
    return first(say(after, told)[1], ask(after))
