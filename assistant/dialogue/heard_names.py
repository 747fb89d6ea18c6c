"""Names heard by voice are read back before they are taken: "red block: right?".

A recognizer writes the words it knows, and a name may be any word. What is asked for is said
again, spelled letter by letter, or typed. Of whatever else gives the plan its shape, such as the
number of steps, only what was not heard surely is read back: "two" sounds like "ten".
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from assistant.dialogue.asking import ask
from assistant.dialogue.events import Heard
from assistant.dialogue.naming import action_words
from assistant.dialogue.plain_answers import answers_by_words
from assistant.dialogue.state import Dialogue, Introducing, Pending
from assistant.dialogue.things import things_in
from assistant.dialogue.turn import Turn, Words, line
from assistant.language.actions import mentioned_objects, read_action
from assistant.model import teacher_acts as acts
from assistant.model.settings import SafetySettings

TOPIC = "heard_names"
SAFETY = SafetySettings()
SHAPING = ("objects", "subtask_count", "subtask_name", "actions", "body")
"""Questions whose answers give the plan its shape."""


def misheard(event: Heard) -> bool:
    """Whether words came by voice and may have been others."""
    return event.by_voice and event.sure < SAFETY.act_confidence


def to_read_back(
    dialogue: Dialogue, event: Heard, meant: Sequence[acts.TeacherAct]
) -> tuple[str, ...]:
    """Return what of an answer heard by voice is read back before it is taken."""
    if not event.by_voice:
        return ()
    return new_names(dialogue, meant) or _doubtful(dialogue, event, meant)


def _doubtful(
    dialogue: Dialogue, event: Heard, meant: Sequence[acts.TeacherAct]
) -> tuple[str, ...]:
    state = dialogue.state
    # A step of one part is rare, and "one" sounds like "none".
    rare = any(isinstance(act, acts.Inform) and act.value in (1, "1") for act in meant)
    doubtful = misheard(event) or rare
    if not doubtful or not isinstance(state, Introducing) or _asks_otherwise(dialogue):
        return ()
    answers = all(isinstance(act, acts.Inform) or answers_by_words(dialogue, act) for act in meant)
    return (event.text.strip(),) if answers and state.asked in SHAPING else ()


def new_names(dialogue: Dialogue, meant: Sequence[acts.TeacherAct]) -> tuple[str, ...]:
    """Return the names among answers to a question for names that the robot does not know."""
    state = dialogue.state
    if not isinstance(state, Introducing) or _asks_otherwise(dialogue):
        return ()
    told = [act.value for act in meant if isinstance(act, acts.Inform)]
    if not told or len(told) != len(meant):
        return ()
    values = [text for value in told for text in (value if isinstance(value, tuple) else (value,))]
    names = [text for text in values if isinstance(text, str)]
    match state.asked:
        case "task_name":
            return tuple(names)
        case "objects":
            scene = dialogue.known.scene
            things = things_in(tuple(names), scene, dialogue.language)
            return tuple(thing.name for thing in things if thing.name not in scene.bodies)
        case "subtask_name":
            return tuple(one for one in names if not _tells_all(dialogue, one))
        case _:
            return ()


def _tells_all(dialogue: Dialogue, name: str) -> bool:
    """Whether a step's name is an action, and besides what it is done with, nothing else.

    "approach object" is; of "approach and project" the robot knows half the words.
    """
    known, language = dialogue.known, dialogue.language
    if read_action(name, (), language).action is None:
        return False
    if mentioned_objects(name, known.objects or (), language):
        return True
    rest = name.lower().split()
    return all(word in action_words(language) for word in rest)


def read_back(
    dialogue: Dialogue, meant: tuple[acts.TeacherAct, ...], names: Sequence[str], words: Words
) -> Turn:
    """Read names back and wait for a yes."""
    question = line("confirm", TOPIC, asked="did_you_mean", names=list(names))
    return ask(replace(dialogue, pending=Pending("did_you_mean", question, meant, words.text)))


def _asks_otherwise(dialogue: Dialogue) -> bool:
    return dialogue.pending is not None and dialogue.pending.line.topic != TOPIC
