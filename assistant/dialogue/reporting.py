"""What checks and the arm tell: refusals, announcements, perceived changes, the end (III-D b)."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

from assistant.dialogue import reviewing
from assistant.dialogue.asking import PRACTICE, index_of, tell
from assistant.dialogue.conditions import expected, missing, plain_conditions
from assistant.dialogue.effects import GoOn, Move
from assistant.dialogue.events import Checked
from assistant.dialogue.looking_ahead import asked_s, looked, told_dry
from assistant.dialogue.measuring import result_slots
from assistant.dialogue.practicing import not_home, pause_there, stopped
from assistant.dialogue.runs import Run, RunResult
from assistant.dialogue.state import Dialogue, Ran, Ready, Running
from assistant.dialogue.turn import (
    Turn,
    first,
    line,
    plain_action,
    say,
    then,
)
from assistant.model.conditions import Condition
from assistant.model.motion import GOING_ON, ArmReport, Refusal
from assistant.model.robot_acts import About, RobotAct
from assistant.model.task import Index, Primitive, primitives

NAMED = ("no_setup", "given_up")
"""Refusals that have a sentence of their own."""


def checked(dialogue: Dialogue, event: Checked) -> Turn:
    """Move only now, and only if this very run was accepted."""
    run = dialogue.run
    if event.refusal is not None:
        return refused(dialogue, event.refusal)
    if dialogue.arm != "checking" or run is None or event.setup != run.setup:
        return dialogue, ()
    if run.purpose == "look":
        return looked(dialogue)
    if run.purpose == "dry":
        return told_dry(dialogue, event)
    known, longer_s = dialogue.known, asked_s(dialogue, event.duration_s)
    moving = replace(
        dialogue,
        state=Running(),
        arm="moving",
        run=replace(run, checked=True, note=event.note, asked_s=longer_s),
        refusal=None,
    )
    slow = run.pace == "slow"
    speed = PRACTICE.slow if slow else PRACTICE.normal
    effect = Move(known.task, run.setup, speed, pause_before_primitives=slow, anew=run.anew)
    told = [line("report", "detour", note=event.note)] if event.note and slow else []
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
        new = dialogue.refusal != refusal
        blamed = _blamed(dialogue) if new else ()
        return tell(replace(kept, state=Ready(), arm="rest"), told, *blamed)
    return tell(kept, told)


def _blamed(dialogue: Dialogue) -> tuple[RobotAct, ...]:
    """Return a line that names the correction made just before a refusal, if there is one."""
    lesson = dialogue.known.lesson
    last = dialogue.past[-1].label if dialogue.past else ""
    if last != "correction" or lesson is None or not lesson.feedback:
        return ()
    return (line("told", "corrected_before", words=lesson.feedback[-1].words),)


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
        by=round(refusal.by) or None,
    )


def reported(dialogue: Dialogue, report: ArmReport) -> Turn:
    """Take what the arm tells of its motion."""
    run = dialogue.run
    if report.text == GOING_ON:
        # That halt was told when it was asked for, and a start has been heard since.
        return dialogue, ()
    if run is not None and report.kind in ("finished", "halted"):
        run = replace(run, held=report.object, height_mm=report.height_mm)
        dialogue = replace(dialogue, run=run)
    if dialogue.arm == "homing":
        return _homing(dialogue, report)
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
            return stopped(dialogue, report.text) if dialogue.arm == "moving" else (dialogue, ())
        case _:
            return _finished(dialogue, run, report)


def _homing(dialogue: Dialogue, report: ArmReport) -> Turn:
    """Take what is told on the way back to the start, where no run is under way."""
    match report.kind:
        case "finished":
            return tell(replace(dialogue, arm="rest"), line("done", "home", held=report.object))
        case "halted":
            return stopped(dialogue, report.text)
        case "unmet":
            told = unmet_line(report, dialogue.known.name)
            return not_home(dialogue, replace(told, topic=f"unmet_home.{report.text}"))
        case _:
            return dialogue, ()


def _primitive(dialogue: Dialogue, run: Run, report: ArmReport) -> Turn:
    at_work = replace(dialogue, run=replace(run, primitive_at=report.primitive_at))
    if 0 <= run.pause_after < report.primitive_at and dialogue.arm == "moving":
        return pause_there(at_work)
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
        going_on=plain_conditions(tuple(one for one in until if one not in changes)),
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
    told = unmet_line(report, name, index_of(dialogue.known, name))
    # What goes on after a condition had to be put right was not done by the robot alone.
    run = dialogue.run and replace(dialogue.run, interrupted=True)
    return say(replace(dialogue, arm="stopped", clean=(), run=run, halt=told), told)


def unmet_line(report: ArmReport, name: str, index: Index = ()) -> RobotAct:
    """Return what is told of a condition that is not met.

    Parameters
    ----------
    report : ArmReport
        Of kind ``unmet``.
    name : str
        Of the primitive.
    index : Index
        Where that stands in the tree.
    """
    wanted: list[dict[str, Any]] = []
    if report.when:
        kind: Any = report.text
        condition = Condition(kind, report.object or None, report.target or None)
        wanted = plain_conditions((condition,))
    return line(
        "stopped",
        f"unmet_{report.when}.{report.text}" if report.when else f"unmet.{report.text}",
        about=About(name, index),
        name=name,
        condition=report.text,
        wanted=wanted,
        found=report.found,
        amount=report.amount,
        unit=report.unit,
        object=report.object,
        target=report.target,
    )


def _finished(dialogue: Dialogue, run: Run, report: ArmReport) -> Turn:
    if dialogue.arm != "moving":
        return dialogue, ()
    if run.purpose == "replay":
        return reviewing.replayed(dialogue)
    result = _result(dialogue, run, report)
    counts = result.complete and not (run.corrected or run.interrupted)
    clean = (*dialogue.clean, result) if counts else ()
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
        asked_s=run.asked_s,
        **result_slots(report.alignments, report.measures),
    )
    return tell(after, told)


def _result(dialogue: Dialogue, run: Run, report: ArmReport) -> RunResult:
    lacking = missing(dialogue.known, run)
    return RunResult(
        run.setup,
        run.pace,
        run.corrected,
        not lacking and all(measure.good for measure in report.measures),
        lacking,
        report.alignments,
        report.measures,
    )
