"""Whether words plainly answer the open question, however sure the understanding is of them."""

from __future__ import annotations

from assistant.dialogue.finding import find
from assistant.dialogue.naming import (
    is_nothing,
    just_as_many,
    listed_steps,
    number_of,
    tidy,
    tidy_name,
)
from assistant.dialogue.sketch import at
from assistant.dialogue.state import Dialogue, Introducing, Reviewing
from assistant.dialogue.things import things_in
from assistant.dialogue.unnamed import names_new_step
from assistant.language.actions import mentioned_objects, read_action
from assistant.language.asides import recounted
from assistant.language.bodies import read_body
from assistant.language.slips import stands
from assistant.model import teacher_acts as acts

SHORTEST_GOAL = 3
"""Words of a goal that is taken however it is worded: it is read back with the plan."""

SHORT_STEP, LONGEST_STEP = 4, 8
"""Words of a step's name that is taken as said, and of one that may be."""

WORDS_COUNT = (acts.Translate, acts.Rotate, acts.Gripper, acts.AddSubtask, acts.Rename)
"""Acts whose words answer a question for a name or an action: "move up" is a name there."""

_LENGTHS = (acts.Inform, acts.Unknown, acts.Translate, acts.Rotate, acts.AddSubtask)
"""Acts that words about a size are taken for: "15 cm across and 12 high" goes nowhere."""


def answers_by_words(dialogue: Dialogue, act: acts.TeacherAct) -> bool:
    """Whether an act is only words here: "move up" names a step that has no name yet."""
    state = dialogue.state
    if not isinstance(state, Introducing) or not isinstance(act, WORDS_COUNT):
        return False
    if isinstance(act, acts.AddSubtask):
        return state.asked == "subtask_name" and act.after is None and act.before is None
    if isinstance(act, acts.Rename):
        # "it is called pick and place" names what has no name yet.
        unnamed = find(dialogue.known, act.old) is None
        return unnamed and state.asked in ("task_name", "subtask_name")
    return state.asked in ("subtask_name", "actions")


def told_steps(
    dialogue: Dialogue, text: str, meant: tuple[acts.TeacherAct, ...]
) -> tuple[str, ...]:
    """Return the steps where the teacher answers a question about steps with a list of them."""
    state = dialogue.state
    if not isinstance(state, Introducing) or state.named:
        return ()
    answering = all(
        isinstance(
            act,
            acts.Inform
            | acts.Unknown
            | acts.AddSubtask
            | acts.Ordered
            | acts.Translate
            | acts.Gripper,
        )
        for act in meant
    )
    if not answering or state.asked not in ("subtask_count", "subtask_name"):
        return ()
    named = state.asked == "subtask_name"
    parts = at(dialogue.known.root, state.index[:-1]).parts
    return listed_steps(text, len(parts) - state.index[-1] + 1 if named else 2, dialogue.language)


def counted_steps(
    dialogue: Dialogue, text: str, meant: tuple[acts.TeacherAct, ...]
) -> tuple[acts.TeacherAct, ...]:
    """Return the number and the steps of "three steps: fetch it, bring it and put it down"."""
    state = dialogue.state
    if not isinstance(state, Introducing) or state.asked != "subtask_count" or state.named:
        return ()
    if not all(isinstance(act, acts.Inform | acts.Unknown | acts.AddSubtask) for act in meant):
        return ()
    head, _, tail = text.partition(":") if ":" in text else text.partition(",")
    count = recounted(head, dialogue.language)
    steps = listed_steps(tail, count or 2, dialogue.language)
    steps = steps or just_as_many(tail, count or 0, dialogue.language)
    return (acts.Inform(count), acts.Inform(steps)) if count and steps else ()


def tells_body(dialogue: Dialogue, meant: tuple[acts.TeacherAct, ...]) -> bool:
    """Whether words are taken for a shape and size; without a size the robot only asks for it."""
    state, pending = dialogue.state, dialogue.pending
    if not isinstance(state, Introducing) or state.asked != "body" or pending is not None:
        return False
    return all(isinstance(act, _LENGTHS) for act in meant)


def answers_plainly(dialogue: Dialogue, meant: tuple[acts.TeacherAct, ...], text: str) -> bool:
    """Whether words plainly answer, by what they tell: an action, a size, a number, a place."""
    if _tells_place(dialogue, meant) or _leaves_as_it_is(dialogue, meant):
        return True
    named = (isinstance(act, acts.Inform) or answers_by_words(dialogue, act) for act in meant)
    if not meant or not all(named):
        return False
    if dialogue.pending is not None:
        return dialogue.pending.asked == "facing" and bool(stands(text, dialogue.language))
    state = dialogue.state
    if isinstance(state, Reviewing):
        return names_new_step(state) and "?" not in text
    if not isinstance(state, Introducing):
        return False
    values = tuple(value for act in meant for value in _values(act))
    match state.asked:
        case "body":
            return read_body(text, dialogue.language, state.thing).size_mm is not None
        case "objects" if state.index:
            known = dialogue.known.objects or ()
            return len(mentioned_objects(text, known, dialogue.language)) == 1 and "?" not in text
        case "objects":
            scene = dialogue.known.scene
            things = things_in(values, scene, dialogue.language)
            return bool(things) and all(thing.name in scene.bodies for thing in things)
        case "goal":
            return "?" not in text and len(text.split()) >= SHORTEST_GOAL
        case "subtask_count":
            none = values == ("0",) and is_nothing(tidy_name(text), dialogue.language)
            return none or values == (str(number_of(text, dialogue.language)),)
        case "subtask_name":
            return tells_action(text, dialogue.language)
        case asked:
            # What the robot has no word for is done as shown, and read back with the plan.
            return asked == "actions"


def in_own_words(
    dialogue: Dialogue, meant: tuple[acts.TeacherAct, ...], text: str
) -> tuple[acts.TeacherAct, ...]:
    """Return a step's name that was made out unsurely as it was said, if that tells a motion.

    "Close the hand" is not just "close", and "take the block" no "block".
    """
    state, only = dialogue.state, meant[0] if len(meant) == 1 else None
    if not isinstance(state, Introducing) or state.asked != "subtask_name":
        return meant
    values = _values(only) if isinstance(only, acts.Inform) else ()
    said = tidy(text, dialogue.language)
    size = len(said.split())
    if len(values) != 1 or "?" in text or not 1 < size <= LONGEST_STEP:
        return meant
    short = size <= SHORT_STEP or not tells_action(values[0], dialogue.language)
    return (acts.Inform(said),) if short and tells_action(said, dialogue.language) else meant


def _leaves_as_it_is(dialogue: Dialogue, meant: tuple[acts.TeacherAct, ...]) -> bool:
    """Whether who was about to leave says "wait", which changes nothing."""
    leaving = dialogue.pending is not None and dialogue.pending.leave
    return leaving and meant == (acts.Pause(),)


def _tells_place(dialogue: Dialogue, meant: tuple[acts.TeacherAct, ...]) -> bool:
    """Whether three numbers answer where the thing asked about is; they are read back."""
    state, only = dialogue.state, meant[0] if len(meant) == 1 else None
    if not isinstance(state, Introducing) or state.asked != "pose" or dialogue.pending is not None:
        return False
    if not isinstance(only, acts.SetPose) or only.position_mm is None:
        return False
    return only.object.lower() in ("", state.thing.lower())


def _values(act: acts.TeacherAct) -> tuple[str, ...]:
    value = act.value if isinstance(act, acts.Inform) else ()
    return value if isinstance(value, tuple) else (str(value),)


def tells_action(text: str, language: str) -> bool:
    """Whether words tell a motion that the robot has a word for."""
    return read_action(text, (), language).action is not None
