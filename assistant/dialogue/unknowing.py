"""A teacher who does not know what to answer: the robot suggests, assumes, or does without."""

from __future__ import annotations

from dataclasses import replace

from assistant.dialogue.asking import ask, proceed, tell
from assistant.dialogue.naming import thing_names
from assistant.dialogue.replying import in_state
from assistant.dialogue.state import Dialogue, Introducing, Pending
from assistant.dialogue.turn import Turn, Words, changed, first, line, say
from assistant.language import asides
from assistant.language.hints import hints
from assistant.model import teacher_acts as acts


def unknowing(dialogue: Dialogue, text: str) -> bool:
    """Whether the teacher says not to know what the introduction asks."""
    return isinstance(dialogue.state, Introducing) and asides.unknowing(text)


def unknown_to(dialogue: Dialogue, words: Words) -> Turn:
    """Go on without the answer where that is possible, else help to find one."""
    state = dialogue.state
    free = replace(dialogue, pending=None, misses=0)
    if not isinstance(state, Introducing):
        return tell(free, line("told", "need_to_know"))
    if state.asked == "task_name":
        return _named_for_now(free)
    if state.asked == "subtask_count" and not state.index and not state.named:
        return _suggested(free, words)
    if state.asked == "objects" and not state.index:
        return _all_things(free, words)
    return in_state(free, acts.Deny(), words)


def _all_things(dialogue: Dialogue, words: Words) -> Turn:
    """Take what stands on the table for what the task needs."""
    known = dialogue.known
    there = thing_names(known.scene, known.setup)
    if not there:
        return in_state(dialogue, acts.Deny(), words)
    told = line("told", "assumed_things", things=there)
    return first(say(dialogue, told)[1], in_state(dialogue, acts.Inform(tuple(there)), words))


def _named_for_now(dialogue: Dialogue) -> Turn:
    name: str = hints("default_name")
    known = dialogue.known
    named = replace(known, name=name, root=replace(known.root, name=name))
    told = line("told", "assumed_name", name=name)
    return first(say(dialogue, told)[1], proceed(changed(dialogue, "task_name", named)))


def _suggested(dialogue: Dialogue, words: Words) -> Turn:
    """Offer the steps by which one thing usually comes to its place."""
    steps = suggested_steps(dialogue)
    if not steps:
        return tell(dialogue, line("help", "subtask_count"))
    question = line("confirm", "suggested_steps", asked="did_you_mean", names=list(steps))
    pending = Pending("did_you_mean", question, (acts.Inform(steps),), words.text)
    return ask(replace(dialogue, pending=pending))


def suggested_steps(dialogue: Dialogue) -> tuple[str, ...]:
    """Return the usual steps for one object and one target; none for other tasks."""
    things = dialogue.known.objects or ()
    carried = [one.name for one in things if one.role == "object"]
    targets = [one.name for one in things if one.role == "target"]
    if len(carried) != 1 or len(targets) != 1:
        return ()
    told: list[str] = hints("suggested_steps")
    return tuple(one.format(object=carried[0], target=targets[0]) for one in told)
