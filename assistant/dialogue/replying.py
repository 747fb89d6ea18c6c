"""What an act means in the state the dialogue is in: an answer, a start, a yes or a no."""

from __future__ import annotations

import re
from dataclasses import replace

from assistant.dialogue import agreeing, practicing, reviewing, showing
from assistant.dialogue.answers import answer
from assistant.dialogue.asking import ask, introduced, proceed, tell
from assistant.dialogue.bodies import ASSUMED_MM, with_body
from assistant.dialogue.finding import name_at
from assistant.dialogue.introduction import all_understood, with_action
from assistant.dialogue.naming import (
    Value,
    as_said,
    is_nothing,
    is_odd,
    name_and_steps,
    text_of,
    tidy,
)
from assistant.dialogue.placing import set_pose
from assistant.dialogue.plain_answers import WORDS_COUNT, tells_action
from assistant.dialogue.state import (
    AwaitingShow,
    Dialogue,
    Introducing,
    Pending,
    Ran,
    Ready,
    Reviewing,
    Running,
    Thinking,
)
from assistant.dialogue.turn import Turn, Words, changed, first, line, say
from assistant.model import teacher_acts as acts
from assistant.model.task import Action

_MAY_BE_NONE = ("goal", "objects", "actions", "body")
"""Questions that "nothing" answers; a name is none of them."""
SENTENCE = 5
"""Words of an answer about things; a longer one is read as a sentence."""


def in_state(dialogue: Dialogue, act: acts.TeacherAct, words: Words) -> Turn:
    """Answer what depends on the state."""
    match dialogue.state:
        case Introducing() as state:
            return _introducing(dialogue, state, act, words)
        case AwaitingShow():
            return _awaiting(dialogue, act)
        case Reviewing() as state:
            return reviewing.review(dialogue, state, act, words.text)
        case Ready() | Running() | Ran():
            return _practicing(dialogue, act)
        case Thinking():
            return say(dialogue, line("told", "thinking"))
        case _:
            return dialogue, ()


def _introducing(
    dialogue: Dialogue, state: Introducing, act: acts.TeacherAct, words: Words
) -> Turn:
    place = _place(state, act, words)
    if place is not None:
        return set_pose(dialogue, place, words.text, sure=words.sure or not words.by_voice)
    value = _value(dialogue, state, act, words)
    if value is not None and state.asked == "task_name" and not words.sure:
        name = name_and_steps(text_of(value), dialogue.language)[0]
        if is_odd(name, dialogue.language):
            return _odd_name(dialogue, act, name, words)
    if value is not None and state.asked in _MAY_BE_NONE and is_nothing(value, dialogue.language):
        return _none(dialogue, state)
    if value is not None:
        return _answered(dialogue, state, value)
    match act:
        case acts.Affirm() | acts.Approve() | acts.Start() if state.asked == "confirm_tree":
            return introduced(_confirmed(dialogue))
        case acts.Affirm() | acts.Approve() if state.named and state.asked == "subtask_count":
            return _answered(dialogue, state, len(state.named))
        case acts.Deny() if state.asked == "confirm_tree":
            return say(dialogue, line("told", "change_tree"))
        case acts.Deny():
            return _none(dialogue, state)
        case acts.Again() | acts.Start() | acts.Resume():
            return tell(dialogue, line("error", "not_introduced"))
        case _:
            return tell(dialogue, line("error", "not_an_answer"))


def _odd_name(dialogue: Dialogue, act: acts.TeacherAct, name: str, words: Words) -> Turn:
    """Ask whether the task is really to be called that."""
    question = line("confirm", "odd_name", asked="task_name", name=name)
    pending = Pending("task_name", question, (act,), words.text)
    return ask(replace(dialogue, pending=pending))


def _place(state: Introducing, act: acts.TeacherAct, words: Words) -> acts.SetPose | None:
    """Return the place told where one was asked for, by bare numbers or of "it"."""
    if state.asked != "pose" or not isinstance(act, acts.Inform):
        return None
    found = [float(one) for one in re.findall(r"-?\d+(?:\.\d+)?", words.text)]
    if len(found) < 3:
        return None
    turned = (0.0, 0.0, found[3]) if len(found) == 4 else None
    return acts.SetPose(state.thing, (found[0], found[1], found[2]), turned)


def _confirmed(dialogue: Dialogue) -> Dialogue:
    known = replace(dialogue.known, tree_confirmed=True)
    return changed(dialogue, "confirmed", known, clean=dialogue.clean)


def _value(
    dialogue: Dialogue, state: Introducing, act: acts.TeacherAct, words: Words
) -> Value | None:
    """Return what an act answers to the open question, if it does."""
    if state.asked in ("confirm_tree", "pose"):
        return None
    if isinstance(act, acts.Inform):
        long = len(words.text.split()) > SENTENCE and not words.sure
        if state.asked == "objects" and not state.index and long:
            return words.text
        if not isinstance(act.value, str):
            return act.value
        told = as_said(act.value, words.text)
        # What the hand does is told whole: "let go of it" is not "go of it".
        naming = state.asked in ("subtask_name", "actions")
        language = dialogue.language
        lost = naming and not tells_action(told, language) and tells_action(words.text, language)
        return tidy(words.text, language) if lost else told
    if isinstance(act, acts.AddSubtask) and state.asked == "subtask_name":
        return act.name
    if isinstance(act, acts.Rename):
        return act.new if state.asked in ("task_name", "subtask_name") else None
    if isinstance(act, WORDS_COUNT) and state.asked in ("subtask_name", "actions"):
        return words.text
    return None


def _answered(dialogue: Dialogue, state: Introducing, value: Value) -> Turn:
    found = answer(dialogue.known, state, value)
    after = changed(dialogue, state.asked, found.known, clean=dialogue.clean)
    said = say(after, *found.lines)[1]
    if found.asks is not None:
        return first(said, ask(replace(after, state=found.asks)))
    return first(said, proceed(after))


def _none(dialogue: Dialogue, state: Introducing) -> Turn:
    """Take "no", "none" or "I do not know" as an answer where it is one."""
    known = dialogue.known
    match state.asked:
        case "goal":
            return proceed(changed(dialogue, "goal", replace(known, goal="")))
        case "objects" if not state.index:
            nothing = all_understood(replace(known, objects=()))
            return proceed(changed(dialogue, "objects", nothing))
        case "objects":
            # It concerns nothing the robot could be told: it is done as it is shown.
            shown = Action("free", name_at(known, state.index))
            return proceed(changed(dialogue, "actions", with_action(known, state.index, shown)))
        case "subtask_count" if not state.named:
            return _answered(dialogue, state, 0)
        case "actions":
            return _answered(dialogue, state, name_at(known, state.index))
        case "body":
            flat = any(
                one.name == state.thing and one.role == "target" for one in known.objects or ()
            )
            told = line("told", "assumed_flat" if flat else "assumed_body", thing=state.thing)
            size_mm = (*ASSUMED_MM[:2], 0.0) if flat else ASSUMED_MM
            known = with_body(known, state.thing, "box", size_mm)
            return first(say(dialogue, told)[1], proceed(changed(dialogue, "body", known)))
        case "pose":
            left = replace(known, unplaced=(*known.unplaced, state.thing))
            return proceed(changed(dialogue, "pose", left))
        case _:
            return tell(dialogue, line("told", "need_to_know"))


def _awaiting(dialogue: Dialogue, act: acts.TeacherAct) -> Turn:
    match act:
        case acts.Start() | acts.Affirm() | acts.Resume() | acts.Again():
            return showing.begin(dialogue)
        case acts.Cue():
            return showing.begin(dialogue)
        case acts.Approve() if dialogue.known.demonstrations:
            return introduced(dialogue)
        case acts.Approve():
            return showing.begin(dialogue)
        case acts.Deny():
            return say(dialogue, line("told", "take_your_time"))
        case _:
            return tell(dialogue, line("error", "not_now"))


def _practicing(dialogue: Dialogue, act: acts.TeacherAct) -> Turn:
    halted = isinstance(dialogue.state, Running) and dialogue.arm in ("paused", "stopped")
    match act:
        case acts.Start():
            return practicing.start(dialogue)
        case acts.Resume():
            return practicing.resume(dialogue)
        case acts.Again():
            return practicing.again(dialogue)
        case acts.Approve():
            return agreeing.satisfied(dialogue)
        case acts.Affirm() if isinstance(dialogue.state, Ran):
            return agreeing.satisfied(dialogue)
        case acts.Affirm() if isinstance(dialogue.state, Ready):
            return practicing.start(dialogue)
        case acts.Deny() if isinstance(dialogue.state, Ran):
            unclean = replace(dialogue, clean=())
            return say(unclean, line("told", "what_to_change"))
        case acts.Deny() if isinstance(dialogue.state, Ready):
            return say(dialogue, line("told", "take_your_time"))
        case _ if halted:
            return say(dialogue, line("told", "say_start"))
        case acts.Affirm() | acts.Deny() | acts.Cue() | acts.KeyState():
            return dialogue, ()
        case _:
            return tell(dialogue, line("error", "not_now"))
