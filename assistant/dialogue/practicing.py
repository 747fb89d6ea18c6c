"""Practice: check, move, announce, perceive, halt, and agree in the end (paper III-D b)."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

from assistant.dialogue import reviewing
from assistant.dialogue.asking import PRACTICE, ask, begin_run, check, index_of, places, tell
from assistant.dialogue.conditions import expected, missing, plain_conditions
from assistant.dialogue.effects import Arrange, GoOn, Halt, Keep, Move
from assistant.dialogue.events import Arranged, Checked, Halted
from assistant.dialogue.state import (
    Dialogue,
    Ran,
    Ready,
    Run,
    Running,
    RunResult,
    Thinking,
    Watching,
)
from assistant.dialogue.turn import (
    Turn,
    changed,
    first,
    line,
    plain_action,
    say,
    then,
)
from assistant.model.motion import ArmReport, Refusal
from assistant.model.robot_acts import About, RobotAct
from assistant.model.task import Primitive, primitives


NAMED = ("no_setup",)
"""Refusals that have a sentence of their own."""


def checked(dialogue: Dialogue, event: Checked) -> Turn:
    """Move only now, and only if this very run was accepted."""
    run = dialogue.run
    if event.refusal is not None:
        return refused(dialogue, event.refusal)
    if dialogue.arm != "checking" or run is None or event.setup != run.setup:
        return dialogue, ()
    if run.purpose == "look":
        return ask(replace(dialogue, state=Ready(), arm="rest"))
    known = dialogue.known
    moving = replace(
        dialogue, state=Running(), arm="moving", run=replace(run, checked=True), refusal=None
    )
    slow = run.pace == "slow"
    speed = PRACTICE.slow if slow else PRACTICE.normal
    effect = Move(known.task, run.setup, speed, pause_before_primitives=slow, anew=run.anew)
    told = [line("report", "detour", note=event.note)] if event.note else []
    if slow and not run.anew:
        told.insert(0, line("report", "starting_slow", about=About(known.name), speed=speed))
    return then(say(moving, *told), effect)


def refused(dialogue: Dialogue, refusal: Refusal) -> Turn:
    """Tell what cannot be done, by how much, and what would help; nothing moves."""
    told = refusal_line("refuse", refusal)
    kept = replace(dialogue, refusal=refusal)
    if dialogue.run is not None and dialogue.run.purpose == "replay":
        return first(say(kept, told)[1], reviewing.replayed(kept))
    if dialogue.arm in ("moving", "paused", "stopped") and not _at_rest_state(dialogue):
        return say(replace(kept, arm="stopped"), told)
    if isinstance(dialogue.state, Running | Ready | Ran):
        return tell(replace(kept, state=Ready(), arm="rest"), told)
    return tell(kept, told)


def _at_rest_state(dialogue: Dialogue) -> bool:
    return not isinstance(dialogue.state, Running)


def refusal_line(act: Any, refusal: Refusal) -> RobotAct:
    """Return a line with everything a refusal tells."""
    topic = refusal.reason if refusal.what or not refusal.where else f"{refusal.reason}.only"
    if refusal.where in NAMED:
        topic = refusal.where
    return RobotAct(
        act,
        topic,
        slots=_refusal_slots(refusal),
    )


def _refusal_slots(refusal: Refusal) -> dict[str, Any]:
    return dict(
        reason=refusal.reason,
        where=refusal.where,
        what=refusal.what,
        amount=round(refusal.amount, 1) or None,
        unit=refusal.unit,
        hint=refusal.hint,
    )


def reported(dialogue: Dialogue, report: ArmReport) -> Turn:
    """Take what the arm tells of its motion."""
    run = dialogue.run
    if run is None or dialogue.arm == "rest":
        return dialogue, ()
    match report.kind:
        case "primitive":
            return _primitive(dialogue, run, report)
        case "perceived":
            return _perceived(dialogue, run, report)
        case "unmet":
            return _unmet(dialogue, report)
        case "halted":
            return _halted(dialogue, run, report)
        case _:
            return _finished(dialogue, run, report)


def _primitive(dialogue: Dialogue, run: Run, report: ArmReport) -> Turn:
    at_work = replace(dialogue, run=replace(run, primitive_at=report.primitive_at))
    if run.pace != "slow" or dialogue.arm != "moving":
        return at_work, ()
    leaf = leaf_at(dialogue, report.primitive_at)
    said = () if leaf is None else say(at_work, announcement(dialogue, leaf))[1]
    # A replay does not wait before its primitives; going on does no harm there.
    return at_work, (*said, GoOn()) if run.purpose == "practice" else said


def leaf_at(dialogue: Dialogue, position: int) -> Primitive | None:
    """Return the primitive at a position among the tree's leaves."""
    leaves = primitives(dialogue.known.task.tree)
    return leaves[position] if 0 <= position < len(leaves) else None


def announcement(dialogue: Dialogue, leaf: Primitive) -> RobotAct:
    """Return what is told before a primitive: name, conditions, action, expected changes."""
    known = dialogue.known
    before, until = expected(known, leaf)
    changes = tuple(one for one in until if one not in before and one.kind != "docked")
    return line(
        "announce",
        "primitive",
        about=About(leaf.name, index_of(known, leaf.name)),
        name=leaf.name,
        before=plain_conditions(before),
        until=plain_conditions(until),
        action=plain_action(leaf.action),
        expect=plain_conditions(changes),
    )


def _perceived(dialogue: Dialogue, run: Run, report: ArmReport) -> Turn:
    held = {"held": report.object, "on": ""}.get(report.text, run.held)
    seen = (*run.perceived, (report.text, report.object))
    after = replace(dialogue, run=replace(run, perceived=seen, held=held))
    if run.pace != "slow" or dialogue.arm != "moving":
        return after, ()
    leaf = leaf_at(dialogue, run.primitive_at)
    about = About(leaf.name, index_of(dialogue.known, leaf.name)) if leaf else None
    told = line(
        "perceived",
        report.text or "change",
        about=about,
        object=report.object,
        target=report.target,
        at_s=round(report.at_s, 1),
    )
    return say(after, told)


def _unmet(dialogue: Dialogue, report: ArmReport) -> Turn:
    if dialogue.arm not in ("moving", "paused"):
        return dialogue, ()
    leaf = leaf_at(dialogue, report.primitive_at)
    name = leaf.name if leaf else dialogue.known.name
    told = line(
        "stopped",
        f"unmet.{report.text}",
        about=About(name, index_of(dialogue.known, name)),
        name=name,
        condition=report.text,
        object=report.object,
        target=report.target,
    )
    return say(replace(dialogue, arm="stopped", clean=()), told)


def _halted(dialogue: Dialogue, run: Run, report: ArmReport) -> Turn:
    held = report.object or run.held
    known_run = replace(run, held=held, height_mm=report.height_mm)
    after = replace(dialogue, run=known_run)
    if dialogue.arm != "moving":
        return after, ()
    return stopped(after, report.text)


def halted(dialogue: Dialogue, event: Halted) -> Turn:
    """Take a halt from outside the dialogue: a stop word, a key, a closed window."""
    if dialogue.arm not in ("moving", "checking", "paused"):
        return dialogue, ()
    return stopped(dialogue, event.why)


def stopped(dialogue: Dialogue, why: str) -> Turn:
    """Tell that the arm stands still and why; it waits for a new start."""
    return say(replace(dialogue, arm="stopped", pending=None), line("stopped", "stop", why=why))


def _finished(dialogue: Dialogue, run: Run, report: ArmReport) -> Turn:
    if dialogue.arm != "moving":
        return dialogue, ()
    if run.purpose == "replay":
        return reviewing.replayed(dialogue)
    lacking = missing(dialogue.known, run)
    result = RunResult(run.setup, run.pace, run.corrected, not lacking, lacking, report.alignments)
    clean = (*dialogue.clean, result) if result.complete and not run.corrected else ()
    after = replace(
        dialogue,
        state=Ran(),
        arm="rest",
        runs=(*dialogue.runs, result),
        clean=clean,
        run=replace(run, checked=False),
    )
    told = line(
        "done",
        "run",
        about=About(dialogue.known.name),
        setup=run.setup.name,
        duration_s=round(report.at_s, 1),
        alignments=[_plain(one) for one in report.alignments],
    )
    return tell(after, told)


def _plain(alignment: Any) -> dict[str, Any]:
    return {
        "object": alignment.object,
        "target": alignment.target,
        "distance_mm": round(alignment.distance_mm, 3),
        "angle_deg": round(alignment.angle_deg, 3),
    }


def stop(dialogue: Dialogue) -> Turn:
    """Halt whatever is going on; grip and knowledge are kept."""
    match dialogue.arm:
        case "moving" | "checking" | "paused":
            turn = stopped(replace(dialogue, state=Running()), "you said stop")
            return first((Halt("stop"),), turn)
        case _ if isinstance(dialogue.state, Thinking | Watching):
            return first((Halt("stop"),), say(dialogue, line("told", "still")))
        case _:
            return say(dialogue, line("told", "still"))


def pause(dialogue: Dialogue) -> Turn:
    """Halt for a while; going on needs only a word."""
    if dialogue.arm == "moving":
        return first((Halt("pause"),), say(replace(dialogue, arm="paused"), line("told", "paused")))
    if dialogue.arm == "checking":
        return stop(dialogue)
    return say(dialogue, line("told", "still"))


def resume(dialogue: Dialogue) -> Turn:
    """Go on after a pause; after a stop only a start will do."""
    if dialogue.arm == "stopped":
        return say(dialogue, line("told", "say_start"))
    if dialogue.arm == "paused":
        return go_on(dialogue)
    if dialogue.arm in ("moving", "checking"):
        return say(dialogue, line("told", "moving_already"))
    return tell(dialogue, line("error", "not_now"))


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
    if dialogue.arm in ("moving", "checking"):
        return say(dialogue, line("told", "moving_already"))
    if dialogue.arm in ("paused", "stopped") and dialogue.run is not None:
        if not dialogue.run.checked:
            return begin_run(dialogue)
        return go_on(dialogue)
    return begin_run(dialogue)


def again(dialogue: Dialogue) -> Turn:
    """Put things back and carry out the setup from its beginning."""
    if dialogue.arm in ("moving", "checking"):
        return say(dialogue, line("told", "moving_already"))
    return begin_run(replace(dialogue, arm="rest"))


def satisfied(dialogue: Dialogue) -> Turn:
    """Take the teacher's yes: on to normal speed, or to agreement."""
    known = About(dialogue.known.name)
    if dialogue.arm in ("moving", "checking"):
        return say(dialogue, line("told", "glad"))
    at_rest = replace(dialogue, arm="rest", state=Ready())
    if dialogue.pace == "slow" and dialogue.runs and not dialogue.agreed:
        return ask(replace(at_rest, pace="normal"))
    lacks = disagreement(dialogue)
    if lacks is not None:
        return tell(at_rest, lacks)
    agreed = replace(at_rest, agreed=True)
    told = line("done", "agreed", about=known, task=dialogue.known.name)
    if not agreed.unsaved and agreed.saved_as:
        return say(agreed, told)
    name = agreed.saved_as or dialogue.known.name
    if name in agreed.saved and name != agreed.saved_as:
        return tell(agreed, told, line("told", "save_by_name", name=name))
    return then(say(agreed, told), Keep(dialogue.known.task, name, overwrite=bool(agreed.saved_as)))


def disagreement(dialogue: Dialogue) -> RobotAct | None:
    """Return why the robot does not agree yet that the task is learned, or None if it does."""
    runs = dialogue.clean
    setups = len({_key(one) for one in runs})
    if setups >= PRACTICE.agreed_after:
        return None
    last = dialogue.runs[-1] if dialogue.runs else None
    if last is not None and last.missing:
        return line("explain", "not_perceived", missing=list(last.missing))
    wanted = PRACTICE.agreed_after
    return line("explain", "not_agreed", setups=setups, wanted=wanted, more=wanted - setups)


def _key(result: RunResult) -> tuple[Any, ...]:
    return (result.setup.robot_start, *sorted(result.setup.places.items(), key=lambda one: one[0]))


def new_setup(dialogue: Dialogue) -> Turn:
    """Ask for an arrangement nobody has seen."""
    if dialogue.arm in ("moving", "checking"):
        return say(dialogue, line("error", "while_moving"))
    known = dialogue.known
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
