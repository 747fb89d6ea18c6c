"""The question each state has open, and going on to the next state."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

from assistant.dialogue import introduction
from assistant.dialogue.effects import Check, Learn
from assistant.dialogue.knowledge import Knowledge
from assistant.dialogue.runs import Run
from assistant.dialogue.sketch import Sketch, leaves, walk
from assistant.dialogue.state import (
    AwaitingShow,
    Dialogue,
    Introducing,
    Ran,
    Ready,
    Reviewing,
    Running,
    Thinking,
    Watching,
)
from assistant.dialogue.turn import Turn, about, first, line, plain_place, say, then
from assistant.model.lesson import Question
from assistant.model.robot_acts import About, RobotAct
from assistant.model.settings import PracticeSettings
from assistant.model.task import Index
from assistant.model.teacher_acts import Asked, Stage

PRACTICE = PracticeSettings()
UNSURE = "unsure_cut"
"""Why learning asks about a cut that it has only little faith in."""


def stage(dialogue: Dialogue) -> Stage:
    """Return where the dialogue stands, in the contract's words."""
    match dialogue.state:
        case AwaitingShow() | Watching():
            return "demonstration"
        case Thinking() | Reviewing():
            return "learning"
        case Ready() | Running() | Ran():
            return "practice"
        case _:
            return "introduction"


def question(dialogue: Dialogue) -> RobotAct | None:
    """Return what the robot has asked and waits to be told, if anything."""
    if dialogue.pending is not None:
        return dialogue.pending.line
    known = dialogue.known
    task = About(known.name)
    match dialogue.state:
        case Introducing() as state:
            return introduction.question(known, state)
        case AwaitingShow(step) if step:
            return line("ask", "ready_step", asked="ready", about=task, name=step)
        case AwaitingShow():
            topic = "ready_again" if known.demonstrations else "ready_to_watch"
            return line("ask", topic, asked="ready", about=task, task=known.name)
        case Reviewing(questions):
            return review_question(known, questions[0] if questions else None)
        case Ready():
            return _ready(dialogue)
        case Ran():
            return line("ask", "satisfied", asked="satisfied", about=task, pace=dialogue.pace)
        case _:
            return None


def _ready(dialogue: Dialogue) -> RobotAct:
    speed = PRACTICE.slow if dialogue.pace == "slow" else PRACTICE.normal
    topic = f"ready_{dialogue.pace}" if not dialogue.agreed else "ready_agreed"
    if topic == "ready_slow" and dialogue.runs:
        topic = "ready_slow_again"
    run = dialogue.run
    # What a replay was refused for was told then; practice is checked and told of anew.
    refused = run is not None and run.setup == dialogue.known.setup and run.purpose != "replay"
    if dialogue.refusal is not None and refused:
        topic = "ready_refused"
    return line(
        "ask",
        topic,
        asked="ready",
        about=About(dialogue.known.name),
        speed=speed,
        setup=dialogue.known.setup.name,
        places=places(dialogue.known),
    )


def review_question(known: Knowledge, open_question: Question | None) -> RobotAct:
    """Return a question of learning as a line; with none open, whether all of it is right."""
    if open_question is None:
        task = About(known.name)
        asked_of_all: Asked = "confirm_segmentation"
        unsure = unsure_ends(known)
        return line("confirm", "segmentation", asked=asked_of_all, about=task, unsure=unsure)
    asked: Any = open_question.asked
    act: Any = "confirm" if asked in ("confirm_segmentation", "optional", "order") else "ask"
    index = index_of(known, open_question.about)
    return RobotAct(
        act,
        f"{asked}.{open_question.reason}",
        asked,
        About(open_question.about, index),
        {**open_question.facts, "name": open_question.about},
    )


def unsure_ends(known: Knowledge) -> list[str]:
    """Return the names of the steps whose end the robot is not sure of."""
    found = known.lesson.segmentation.questions if known.lesson is not None else ()
    return [one.about for one in found if one.reason == UNSURE and one.about]


def index_of(known: Knowledge, name: str) -> Index:
    """Return the position of the node of that name; () if there is none."""
    return next((index for index, node in walk(known.root) if index and node.name == name), ())


def places(known: Knowledge) -> dict[str, Any]:
    """Return where the task's things are, as plain values."""
    told = known.setup.places
    named = [one.name for one in known.objects or ()] or list(told)
    return {name: plain_place(told[name]) for name in named if name in told}


def ask(dialogue: Dialogue) -> Turn:
    """Say the open question, if there is one."""
    asked = question(dialogue)
    return say(dialogue, asked) if asked is not None else (dialogue, ())


def proceed(dialogue: Dialogue) -> Turn:
    """Go where knowledge now leads and ask what is open there."""
    if isinstance(dialogue.state, Introducing):
        state = introduction.need(dialogue.known)
        if state is None:
            return introduced(dialogue)
        return ask(replace(dialogue, state=state))
    return ask(dialogue)


def introduced(dialogue: Dialogue) -> Turn:
    """Leave the introduction: watch, learn anew, or go on practicing."""
    known = dialogue.known
    outdated = known.lesson is None or not same_motions(known)
    if outdated and known.demonstrations:
        return learn(dialogue)
    if known.lesson is None:
        return ask(replace(dialogue, state=AwaitingShow()))
    if outdated:
        # A kept task holds what was learned, not what was shown: nothing can be learned anew.
        return tell(replace(dialogue, state=AwaitingShow()), line("told", "must_be_shown"))
    if not known.reviewed:
        return ask(replace(dialogue, state=Reviewing()))
    return ask(replace(dialogue, state=Ready()))


def same_motions(known: Knowledge) -> bool:
    """Whether the lesson was learned with the single motions that are known now."""
    return known.learned_root is None or _motions(known.learned_root) == _motions(known.root)


def _motions(root: Sketch) -> list[tuple[str, object]]:
    return [(node.name, node.action) for _, node in leaves(root)]


def settle(dialogue: Dialogue, *lines: RobotAct) -> Turn:
    """Say something, then go where a change of the tree leads.

    Back to the introduction while something is unknown, to learning where the motions are
    others now, else on with the question that was open.
    """
    known = dialogue.known
    missing = introduction.need(known)
    if isinstance(dialogue.state, Introducing) or missing is not None:
        going = replace(dialogue, state=Introducing("confirm_tree"), arm="rest", pending=None)
        return first(say(going, *lines)[1], proceed(going))
    if known.demonstrations and known.lesson is not None and not same_motions(known):
        return first(say(dialogue, *lines)[1], learn(replace(dialogue, arm="rest")))
    if known.lesson is not None and not same_motions(known):
        return first(say(dialogue, *lines)[1], introduced(replace(dialogue, arm="rest")))
    return tell(dialogue, *lines)


def learn(dialogue: Dialogue) -> Turn:
    """Learn from what was shown."""
    known = dialogue.known
    if introduction.need(replace(known, tree_confirmed=True)) is not None:
        return proceed(replace(dialogue, state=Introducing("confirm_tree")))
    known = _fitting(known)
    dialogue = replace(dialogue, known=known)
    effect = Learn(known.task, known.demonstrations, known.cuts_s, known.assigned)
    thinking = replace(dialogue, state=Thinking(), pending=None)
    return then(say(thinking, line("report", "learning", about=About(known.name))), effect)


def _fitting(known: Knowledge) -> Knowledge:
    """Return what is known with the cuts and parts told by hand only as far as they still fit.

    Parts of a step that is gone are free again. Where a step is new that has no part yet, all
    are: its own must be found.
    """
    now = {node.name for _, node in leaves(known.root)}
    before = {node.name for _, node in leaves(known.learned_root or known.root)}
    if now - before - {name for _, name in known.assigned}:
        return replace(known, cuts_s=None, assigned=())
    return replace(known, assigned=tuple(one for one in known.assigned if one[1] in now))


def begin_run(dialogue: Dialogue, *, look: bool = False) -> Turn:
    """Check the setup; motion starts when the check is accepted, a look only checks."""
    known = dialogue.known
    run = Run(known.setup, dialogue.pace, "look" if look else "practice")
    checking = replace(dialogue, state=Running(), arm="checking", run=run, pending=None)
    return checking, (check(checking),)


def check(dialogue: Dialogue, *, anew: bool = False) -> Check:
    """Return the check for the setup that is known now."""
    known = dialogue.known
    speed = PRACTICE.slow if dialogue.pace == "slow" else PRACTICE.normal
    return Check(known.task, known.setup, known.scene, speed, anew=anew)


def tell(dialogue: Dialogue, *lines: RobotAct) -> Turn:
    """Say something, then ask again what was open."""
    return first(say(dialogue, *lines)[1], ask(dialogue))


__all__ = [
    "about",
    "ask",
    "begin_run",
    "check",
    "index_of",
    "introduced",
    "learn",
    "places",
    "proceed",
    "question",
    "review_question",
    "same_motions",
    "settle",
    "stage",
    "tell",
]
