"""Corrections are kept, adjusted, taken back and brought again; the robot says what it changed."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

from assistant.dialogue.asking import PRACTICE, ask, index_of, tell
from assistant.dialogue.correcting import (
    SPEEDS,
    Correction,
    Place,
    adjusted,
    amount,
    feedback_from,
    parallel,
    plain_feedback,
    size,
    speed_of,
    summed,
    too_much,
)
from assistant.dialogue.directions import depends_on_facing, direction_of, squeezed
from assistant.dialogue.effects import Jog, SetHand
from assistant.dialogue.elsewhere import stands_elsewhere
from assistant.dialogue.finding import acts_at, find_whole, name_at, spoken_of, unclear, way_to
from assistant.dialogue.knowledge import Knowledge
from assistant.dialogue.runs import Pace
from assistant.dialogue.sketch import at, leaves
from assistant.dialogue.state import Dialogue, Introducing, Pending, Ran, Ready, Running
from assistant.dialogue.turn import Turn, Words, changed, first, line, say, then, with_other
from assistant.model import teacher_acts as acts
from assistant.model.feedback import Feedback
from assistant.model.robot_acts import About, RobotAct
from assistant.model.task import primitives

AT_BOUND = 0.01
"""A speed this share away from its bound is there."""
SHOWN_M = 0.010
"""The small announced move that shows where the robot takes left to be."""


def correct(dialogue: Dialogue, act: Correction, words: str, *, by_voice: bool, sure: bool) -> Turn:
    """Take a spoken correction; what is large, or heard as a number, is read back first."""
    if isinstance(act, acts.Gripper) and act.where is None:
        if dialogue.arm == "homing":
            return say(dialogue, line("error", "while_moving"))
        if not dialogue.busy:
            return _hand(dialogue, act, sure=sure)
    if isinstance(dialogue.state, Introducing):
        return tell(dialogue, line("error", "not_an_answer"))
    if dialogue.known.lesson is None:
        return tell(dialogue, line("error", "nothing_to_correct"))
    elsewhere = None if sure else stands_elsewhere(dialogue, act, words)
    if elsewhere is not None:
        return elsewhere
    place = _place(dialogue, act, words)
    if place is None:
        return unclear(dialogue, act.where.subtask if act.where else "", act)
    if not sure and too_much(act, by_voice=by_voice):
        return _read_back(dialogue, act, words)
    if _facing_open(dialogue, act):
        question = line("ask", "facing", asked="facing")
        pending = Pending("facing", question, (act,), words)
        return ask(replace(dialogue, pending=pending))
    done = add(dialogue, feedback_from(dialogue.known, act, words, place))
    return _other_station(dialogue, done, act, Words(words))


def _other_station(dialogue: Dialogue, done: Turn, act: Correction, words: Words) -> Turn:
    """Keep in mind the other of two places a correction may have been meant for."""
    given = done[0].known.lesson
    if given is None or done[0].known == dialogue.known or not given.feedback:
        return done
    steps = list(dict.fromkeys(one.primitive for one in given.stations))
    at = given.feedback[-1].primitive
    other: tuple[acts.TeacherAct, ...] = ()
    if len(steps) == 2 and at in steps:
        there = acts.Where(steps[1 - steps.index(at)], "during")
        other = (replace(act, where=there),)
    here = replace(act, where=acts.Where(at, "during"))
    return with_other(dialogue, done[0], other, words, here), done[1]


def _facing_open(dialogue: Dialogue, act: Correction) -> bool:
    if dialogue.known.facing is not None:
        return False
    if isinstance(act, acts.Translate):
        return depends_on_facing("translate", act.direction)
    return isinstance(act, acts.Rotate) and depends_on_facing("rotate", act.direction)


def _read_back(dialogue: Dialogue, act: Correction, words: str) -> Turn:
    told = acts.act_to_json(act)
    question = line("confirm", "large", asked="did_you_mean", acts=[told], amount=amount(act))
    pending = Pending("did_you_mean", question, (act,), words)
    return ask(replace(dialogue, pending=pending))


def _place(dialogue: Dialogue, act: Correction, words: str) -> Place | None:
    """Return where a correction belongs: as said, else what is being done, else the end."""
    if act.where is not None:
        index = find_whole(dialogue.known, act.where.subtask)
        if index is None:
            # "when you place it" is the step that opens the hand, whatever it is called.
            meant = spoken_of(dialogue, act.where.subtask) or acts_at(dialogue, act.where.subtask)
            return Place(meant, act.where.when) if meant else None
        return Place(_leaf_under(dialogue, name_at(dialogue.known, index)), act.where.when)
    way = way_to(dialogue, words) if isinstance(act, acts.Translate) else ""
    if way:
        return Place(way, "before")
    run = dialogue.run
    leaves = primitives(dialogue.known.task.tree)
    going = isinstance(dialogue.state, Running) and run is not None
    if going and run is not None and 0 <= run.primitive_at < len(leaves):
        if isinstance(act, acts.AdjustSpeed):
            return Place()
        return Place(leaves[run.primitive_at].name)
    return Place(spoken_of(dialogue, words))


def _leaf_under(dialogue: Dialogue, name: str) -> str:
    """Return the primitive of a node in which its goal is reached; a primitive is itself.

    That is where the hand acts last, as it grasps or lets go: what follows only leaves.
    """
    known = dialogue.known
    node = at(known.root, index_of(known, name))
    names = [leaf.name for _, leaf in leaves(node)] or [node.name]
    stations = known.lesson.stations if known.lesson is not None else ()
    acted = {one.primitive for one in stations}
    return next((one for one in reversed(names) if one in acted), names[-1])


def _hand(dialogue: Dialogue, act: acts.Gripper, *, sure: bool) -> Turn:
    """Open or close the hand at rest; letting go of something above a surface is confirmed."""
    run = dialogue.run
    held = run.held if run is not None else ""
    if act.command == "open" and held and not sure:
        height = run.height_mm if run is not None else None
        topic = "open_above" if height is not None else "open_holding"
        slots: dict[str, Any] = {"object": held}
        if height is not None:
            slots["height_mm"] = round(height)
        question = line("confirm", topic, asked="did_you_mean", **slots)
        return ask(replace(dialogue, pending=Pending("did_you_mean", question, (act,))))
    after = dialogue
    if run is not None and act.command == "open":
        after = replace(dialogue, run=replace(run, held=""))
    return then(say(after, line("done", f"hand_{act.command}")), SetHand(act.command))


def add(dialogue: Dialogue, feedback: Feedback, *, instead: bool = False) -> Turn:
    """Keep a correction, on top of the others or instead of the last one, and tell it."""
    lesson = dialogue.known.lesson
    if lesson is None:
        return tell(dialogue, line("error", "nothing_to_correct"))
    given = lesson.feedback[:-1] if instead else lesson.feedback
    known = replace(dialogue.known, lesson=replace(lesson, feedback=(*given, feedback)))
    if feedback.kind == "speed" and not SPEEDS[0] <= speed_of(known) <= SPEEDS[1]:
        return _as_far_as_it_goes(dialogue, feedback, given)
    after = corrected(changed(dialogue, "correction", known))
    return told_of(after, told(known, feedback, dialogue.pace))


def _as_far_as_it_goes(dialogue: Dialogue, feedback: Feedback, given: tuple[Feedback, ...]) -> Turn:
    """Change the speed up to its bound and say that it is one; refuse where it is there."""
    now = speed_of(dialogue.known)
    least, most = (round(100 * one) for one in SPEEDS)
    lesson = dialogue.known.lesson
    before = lesson and speed_of(replace(dialogue.known, lesson=replace(lesson, feedback=given)))
    bound = SPEEDS[1] if before and before * feedback.factor > SPEEDS[1] else SPEEDS[0]
    if lesson is None or not before or feedback.primitive or abs(now / bound - 1.0) < AT_BOUND:
        return tell(
            dialogue, line("refuse", "speed_bounds", least=least, most=most, now=round(100 * now))
        )
    nearer = replace(feedback, factor=bound / before)
    kept = replace(dialogue.known, lesson=replace(lesson, feedback=(*given, nearer)))
    after = corrected(changed(dialogue, "correction", kept))
    limit = line("told", "speed_limit", least=least, most=most)
    said = say(after, told(kept, nearer, dialogue.pace))[1]
    return first(said, told_of(after, limit))


def corrected(dialogue: Dialogue) -> Dialogue:
    """Return the dialogue with its run marked as corrected."""
    run = dialogue.run
    return replace(dialogue, run=replace(run, corrected=True) if run is not None else None)


def told(known: Knowledge, feedback: Feedback, pace: Pace) -> RobotAct:
    """Return the line that says what was changed, in mm, degrees or percent."""
    primitive = feedback.primitive
    about = About(primitive, index_of(known, primitive)) if primitive else None
    slots = plain_feedback(feedback) | {"speed": round(100.0 * speed_of(known))}
    slots["size"] = round(abs(size(feedback)), 1)
    if feedback.kind in ("translate", "rotate"):
        slots["total"] = _total(known, feedback)
    topic: str = feedback.kind
    if topic in ("translate", "rotate"):
        slots["direction"] = direction_of(known, feedback)
        slots["squeezed"] = squeezed(known, feedback)
    if topic == "speed":
        topic = "faster" if feedback.factor > 1 else "slower"
        # What is practiced slowly is not as fast as the number says.
        slowly = round(100.0 * speed_of(known) * PRACTICE.slow)
        slots["slowly"] = slowly if pace == "slow" else None
        topic = f"{topic}_at" if primitive else topic
    elif topic == "hand":
        topic = f"hand_at_{feedback.hand}"
    elif not feedback.frame:
        topic = f"{topic}_world"
    return line("done", topic, about=about, **slots)


def _total(known: Knowledge, feedback: Feedback) -> float | None:
    """Return how far all corrections there go together; None where it is the only one."""
    given = known.lesson.feedback if known.lesson else ()
    alike = [
        one
        for one in given
        if (one.kind, one.frame, one.primitive)
        == (feedback.kind, feedback.frame, feedback.primitive)
        and parallel(one, feedback)
    ]
    return round(size(summed(alike)), 1) if len(alike) > 1 else None


def told_of(dialogue: Dialogue, said: RobotAct) -> Turn:
    """Tell a change of corrections and go on; while the arm moves it counts for the next run."""
    if dialogue.busy:
        return say(dialogue, said, line("told", "next_time"))
    if isinstance(dialogue.state, Running):
        return say(dialogue, said)
    if isinstance(dialogue.state, Ran):
        return tell(replace(dialogue, state=Ready()), said)
    return tell(dialogue, said)


def adjust_last(dialogue: Dialogue, act: acts.AdjustLast, words: str) -> Turn:
    """Change the last correction: more, less, half of it, the other way."""
    lesson = dialogue.known.lesson
    if lesson is None or not lesson.feedback:
        return tell(dialogue, line("error", "no_correction"))
    last = lesson.feedback[-1]
    if last.kind == "hand":
        return tell(dialogue, line("error", "no_correction"))
    feedback, instead = adjusted(last, act)
    kept = f"{last.words}, {words}" if instead and words and last.words else words or last.words
    return add(dialogue, replace(feedback, words=kept), instead=instead)


def shown_left(dialogue: Dialogue) -> Turn:
    """Show by a small move where left is taken to be, if the arm has not run yet."""
    known = dialogue.known
    if not isinstance(dialogue.state, Ready) or dialogue.runs or known.facing is None:
        return dialogue, ()
    left = -SHOWN_M if known.facing == "facing" else SHOWN_M
    return then(say(dialogue, line("announce", "left_shown")), Jog((0.0, left, 0.0)))
