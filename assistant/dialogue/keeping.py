"""Saving, loading, comparing, leaving: nothing learned is lost without a question."""

from __future__ import annotations

import re
from dataclasses import replace

from assistant.dialogue import introduction
from assistant.dialogue.asking import ask, introduced, tell
from assistant.dialogue.comparing import comparison
from assistant.dialogue.effects import Arrange, Discard, Halt, Keep, Leave, Load, WriteDown
from assistant.dialogue.events import Kept, Loaded
from assistant.dialogue.fresh import fresh
from assistant.dialogue.knowledge import Knowledge
from assistant.dialogue.sketch import from_tree
from assistant.dialogue.state import After, Closed, Dialogue, Pending
from assistant.dialogue.turn import Turn, changed, first, line, say, then
from assistant.model import teacher_acts as acts
from assistant.model.robot_acts import About
from assistant.model.task import Task

EXISTS = "exists"
"""Why a task is not kept where another one, saved elsewhere meanwhile, has its name."""


def save(dialogue: Dialogue, name: str | None) -> Turn:
    """Keep the task; ask before what is kept under that name is overwritten by anything else."""
    known = dialogue.known
    wanted = name or dialogue.saved_as or known.name
    wanted = known_as(dialogue, wanted) or wanted
    if not wanted:
        return tell(dialogue, line("error", "nothing_to_save"))
    mine = wanted == dialogue.saved_as
    if wanted in dialogue.saved and (not mine or dialogue.unsaved):
        topic = "overwrite_own" if mine else "overwrite"
        question = line("confirm", topic, asked="unsaved", name=wanted)
        pending = Pending(
            "unsaved", question, keep_name=wanted, leave=dialogue.leaving, after=dialogue.after
        )
        return ask(replace(dialogue, pending=pending))
    return dialogue, (Keep(known.task, wanted, overwrite=wanted in dialogue.saved),)


def kept(dialogue: Dialogue, event: Kept) -> Turn:
    """Tell that the task is saved, or why it is not."""
    if event.discarded:
        return _discarded(dialogue, event)
    if event.record is not None:
        return _written(dialogue, event, event.record)
    if event.why_not == EXISTS:
        there = tuple(dict.fromkeys((*dialogue.saved, event.name)))
        return save(replace(dialogue, saved=there, saved_as=""), event.name)
    if event.why_not:
        told = line("error", "not_saved", name=event.name, reason=event.why_not)
        return tell(replace(dialogue, leaving=False, after=("", ""), pending=None), told)
    saved = tuple(dict.fromkeys((*dialogue.saved, event.name)))
    after = replace(dialogue, saved=saved, saved_as=event.name, unsaved=False)
    # What was shown and never came to its end may not be what was meant.
    tried = not dialogue.known.demonstrations or any(one.complete for one in dialogue.runs)
    unproven = None if tried else after.known.name
    about = About(after.known.name)
    told = line("done", "saved", about=about, name=event.name, unproven=unproven)
    if after.leaving:
        return first(say(after, told)[1], leave(after))
    if after.after[0]:
        return first(say(after, told)[1], _go_after(after))
    return tell(after, told)


def _go_after(dialogue: Dialogue) -> Turn:
    """Do what waited until unsaved work was seen to."""
    what, name = dialogue.after
    free = replace(dialogue, after=("", ""), pending=None)
    return fresh(free) if what == "fresh" else (free, (Load(name),))


def write_down(dialogue: Dialogue) -> Turn:
    """Have the task written down for people to read."""
    known = dialogue.known
    return dialogue, (WriteDown(known.task, dialogue.saved_as or known.name),)


def _written(dialogue: Dialogue, event: Kept, record: str) -> Turn:
    if event.why_not:
        told = line("error", "not_written", name=event.name, reason=event.why_not)
        return tell(dialogue, told)
    return tell(dialogue, line("done", "written", name=event.name, path=record))


def _discarded(dialogue: Dialogue, event: Kept) -> Turn:
    if event.why_not:
        told = line("error", "not_discarded", name=event.name, reason=event.why_not)
        return tell(dialogue, told)
    left = tuple(one for one in dialogue.saved if one != event.name)
    mine = dialogue.saved_as == event.name
    after = replace(dialogue, saved=left, saved_as="" if mine else dialogue.saved_as)
    after = replace(after, unsaved=after.unsaved or mine)
    return tell(after, line("done", "discarded", name=event.name))


def discard_wanted(dialogue: Dialogue, name: str) -> Turn:
    """Ask before a kept task is deleted."""
    question = line("confirm", "discard", asked="unsaved", name=name)
    return ask(replace(dialogue, pending=Pending("unsaved", question, keep_name=name)))


def known_as(dialogue: Dialogue, name: str) -> str:
    """Return the name a task is kept under, capitals and blanks aside; empty if it is not."""
    plain = _plain(name)
    return next((one for one in dialogue.saved if plain and _plain(one) == plain), "")


def _plain(name: str) -> str:
    return " ".join(re.findall(r"[^\W_]+", name.lower()))


def load(dialogue: Dialogue, name: str | None, *, comparing: bool = False) -> Turn:
    """Read a kept task; without a name tell which there are."""
    if dialogue.busy:
        return say(dialogue, line("error", "while_moving"))
    if not dialogue.saved:
        return tell(dialogue, line("error", "nothing_saved"))
    found = [one for one in (known_as(dialogue, name or ""),) if one]
    if name is None:
        mine = known_as(dialogue, dialogue.saved_as)
        found = [mine] if mine and comparing else list(dialogue.saved[:1])
        if len(dialogue.saved) > 1 and not (mine and comparing):
            return tell(dialogue, line("error", "which_task", names=list(dialogue.saved)))
    if not found:
        told = line("error", "no_such_task", name=name or "", names=list(dialogue.saved))
        return tell(dialogue, told)
    unsaved = dialogue.unsaved and dialogue.known.name and not comparing
    if unsaved:
        return ask_to_save(dialogue, "unsaved.other", after=("load", found[0]))
    return replace(dialogue, comparing=comparing), (Load(found[0]),)


def loaded(dialogue: Dialogue, event: Loaded) -> Turn:
    """Go on with a task that was read, or compare it with the present one."""
    at_rest = replace(dialogue, comparing=False)
    if event.task is None:
        told = line("error", "not_loaded", name=event.name, reason=event.why_not)
        return tell(at_rest, told)
    if dialogue.comparing:
        return tell(at_rest, comparison(dialogue.known, event.name, event.task))
    known = taken_up(dialogue.known, event.task)
    after = changed(at_rest, "loaded", known)
    fresh = replace(after, saved_as=event.name, unsaved=False, pace="normal", pending=None)
    told = line("done", "loaded", about=About(known.name), name=event.name)
    return first(say(fresh, told)[1], resumed(fresh))


def taken_up(known: Knowledge, task: Task) -> Knowledge:
    """Return what is known once a task is taken from a file."""
    root = replace(from_tree(task.tree), name=task.tree.name or task.name)
    return replace(
        known,
        name=task.name,
        goal=task.goal,
        objects=task.objects,
        root=root,
        tree_confirmed=bool(root.parts),
        demonstrations=(),
        cuts_s=None,
        assigned=(),
        lesson=task.learned,
        learned_root=root if task.learned is not None else None,
        reviewed=task.learned is not None,
    )


def resumed(dialogue: Dialogue) -> Turn:
    """Ask what is open for a task that was taken up."""
    state = introduction.need(dialogue.known)
    if state is not None:
        return ask(replace(dialogue, state=state, arm="rest"))
    return introduced(replace(dialogue, arm="rest"))


def leave_wanted(dialogue: Dialogue) -> Turn:
    """End the session; with unsaved work only after a question."""
    halting = (Halt("stop"),) if dialogue.can_halt else ()
    still = replace(dialogue, arm="stopped" if halting else dialogue.arm)
    if not (still.unsaved and still.known.name):
        return first(halting, leave(still))
    return first(halting, ask_to_save(still, "unsaved", leave=True))


def fresh_wanted(dialogue: Dialogue) -> Turn:
    """Begin another task, after asking what becomes of this one if it is not saved."""
    if not (dialogue.unsaved and dialogue.known.name):
        return fresh(dialogue)
    return ask_to_save(dialogue, "unsaved.other", after=("fresh", ""))


def ask_to_save(
    dialogue: Dialogue, topic: str, *, leave: bool = False, after: After = ("", "")
) -> Turn:
    """Ask whether unsaved work is to be saved first, and say so if that replaces what is kept.

    Parameters
    ----------
    topic : str
        ``unsaved`` at the end, ``unsaved.other`` before something else.
    """
    mine = known_as(dialogue, dialogue.saved_as)
    name = mine or dialogue.known.name
    topic = {"unsaved": "unsaved.again"}.get(topic, f"{topic}_again") if mine else topic
    question = line("ask", topic, asked="unsaved", name=name)
    # Who says yes to this is not asked once more whether it may be replaced.
    pending = Pending("unsaved", question, keep_name=mine, leave=leave, after=after)
    return ask(replace(dialogue, pending=pending))


def leave(dialogue: Dialogue) -> Turn:
    """Say goodbye and end the session."""
    closed = replace(dialogue, state=Closed(), pending=None, leaving=False)
    return then(say(closed, line("told", "goodbye")), Leave())


def answer_unsaved(dialogue: Dialogue, act: acts.TeacherAct) -> Turn | None:
    """Answer "save it first?" or "overwrite it?"; None if this was no answer to it."""
    pending = dialogue.pending
    if pending is None:
        return None
    if pending.line.topic == "discard":
        return _answer_discard(dialogue, pending.keep_name, act)
    free = replace(dialogue, pending=None, leaving=pending.leave, after=pending.after)
    # "Save it first?" may be denied and the rest is done; "replace it?" leaves all as it was.
    first_asked = pending.line.topic.startswith("unsaved")
    match act:
        case acts.Save(None) if pending.keep_name and first_asked:
            return free, (Keep(free.known.task, pending.keep_name, overwrite=True),)
        case acts.Affirm() | acts.Approve() if pending.keep_name:
            return free, (Keep(free.known.task, pending.keep_name, overwrite=True),)
        case acts.Affirm() | acts.Approve():
            return save(free, None)
        case acts.Save(name):
            return save(free, name or pending.keep_name or None)
        case acts.Inform(value) if pending.keep_name and isinstance(value, str):
            return save(free, value)
        case acts.Deny() | acts.Quit() if pending.leave and first_asked:
            return leave(free)
        case acts.Deny() if pending.after[0] and first_asked:
            return _go_after(free)
        case acts.Deny():
            stays = replace(free, leaving=False, after=("", ""))
            return tell(stays, line("told", "not_saved"))
        case acts.Pause() | acts.Resume() | acts.Undo() if pending.leave:
            # "Wait": who asked to leave stays.
            return tell(replace(free, leaving=False, after=("", "")), line("told", "as_it_was"))
        case _:
            return None


def _answer_discard(dialogue: Dialogue, name: str, act: acts.TeacherAct) -> Turn | None:
    free = replace(dialogue, pending=None)
    match act:
        case acts.Affirm() | acts.Approve():
            return free, (Discard(name),)
        case acts.Deny():
            return tell(free, line("told", "as_it_was"))
        case _:
            return None


def arrange_if_changed(before: Knowledge, dialogue: Dialogue) -> Turn:
    """Put things where they are now known to be, if that is elsewhere than before."""
    known = dialogue.known
    if (known.setup, known.scene) == (before.setup, before.scene):
        return dialogue, ()
    return dialogue, (Arrange(known.setup, known.scene),)
