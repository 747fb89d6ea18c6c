"""What newcomers say beside the question: who they are, where they stand, a name given late."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import replace

from assistant.dialogue.adding import plan_corrected
from assistant.dialogue.asking import ask, proceed, tell
from assistant.dialogue.cut_words import recut
from assistant.dialogue.doing_otherwise import does_at_once, does_otherwise
from assistant.dialogue.goal_words import regoaled
from assistant.dialogue.helping import help_line
from assistant.dialogue.introduction import MOST_PARTS, all_understood
from assistant.dialogue.keeping import fresh_wanted, leave_wanted
from assistant.dialogue.knowledge import Knowledge
from assistant.dialogue.naming import alike, is_lone_verb, listed_steps, tidy_name
from assistant.dialogue.no_things import no_thing, sized
from assistant.dialogue.plan_words import (
    added,
    called,
    order_freed,
    removed,
    shown_again,
    swapped,
)
from assistant.dialogue.replying import in_state
from assistant.dialogue.several import told_several
from assistant.dialogue.shapes import told_shape
from assistant.dialogue.shown_wrongly import shown_wrongly
from assistant.dialogue.sizes import told_size
from assistant.dialogue.sketch import Sketch, at, counted, put, with_parts
from assistant.dialogue.slips import slip
from assistant.dialogue.splitting import split_into
from assistant.dialogue.state import (
    AwaitingShow,
    Closed,
    Dialogue,
    Introducing,
    Opening,
    Thinking,
    Watching,
)
from assistant.dialogue.structure import rename
from assistant.dialogue.things import things_in
from assistant.dialogue.turn import Turn, Words, changed, first, line, say
from assistant.language.asides import (
    after,
    introduced_person,
    is_greeting,
    is_puzzled,
    is_thanks,
    mended,
    recounted,
    taught,
)
from assistant.language.hints import hints, matter, mentions
from assistant.model import teacher_acts as acts

LONGEST_FAREWELL = 6
"""Words of a goodbye; more tell something else, too."""


def aside(dialogue: Dialogue, words: Words, meant: Iterable[acts.TeacherAct]) -> Turn | None:
    """Answer what was said beside the question, or None where it was to the point."""
    if dialogue.busy or isinstance(dialogue.state, Opening | Closed | Watching | Thinking):
        return None
    calm = replace(dialogue, misses=0)
    for reply in _REPLIES:
        turn = reply(calm, words, tuple(meant))
        if turn is not None:
            return turn
    return None


def _person(dialogue: Dialogue, words: Words, _: tuple[acts.TeacherAct, ...]) -> Turn | None:
    """Greet a teacher who tells a name; it is not the task's."""
    name, rest = introduced_person(
        words.text, dialogue.language, sure=not _asks(dialogue, "task_name")
    )
    if not name:
        return None
    told = line("told", "nice_to_meet", name=name)
    opened = after(rest, "naming", dialogue.language) or taught(rest, dialogue.language)
    vague = alike(opened, hints("no_taught", dialogue.language))
    if opened and not vague and _asks(dialogue, "task_name"):
        said = say(dialogue, told)[1]
        return first(said, in_state(dialogue, acts.Inform(opened), replace(words, text=opened)))
    return tell(dialogue, told)


def _courtesy(dialogue: Dialogue, words: Words, meant: tuple[acts.TeacherAct, ...]) -> Turn | None:
    if is_greeting(words.text, dialogue.language):
        return tell(dialogue, line("told", "hello"))
    said = words.text.split()
    farewell = len(said) <= LONGEST_FAREWELL and "?" not in words.text
    if farewell and mentions(words.text, hints("farewells", dialogue.language)):
        return leave_wanted(dialogue)
    unknown = all(isinstance(act, acts.Unknown | acts.Inform) for act in meant)
    if unknown and is_thanks(words.text, dialogue.language):
        return tell(dialogue, line("told", "welcome"))
    return None


def _late(dialogue: Dialogue, words: Words, _: tuple[acts.TeacherAct, ...]) -> Turn | None:
    """Take a name, a goal or a thing that is told while something else is asked."""
    state = dialogue.state
    if not isinstance(state, Introducing) or dialogue.pending is not None:
        return None
    known = dialogue.known
    part = "naming_task" if state.asked in ("subtask_name", "actions", "which") else "naming"
    name = mended(after(words.text, part, dialogue.language), dialogue.language)
    if not name and state.asked == "task_name":
        name = taught(words.text, dialogue.language)
        if alike(name, hints("no_taught", dialogue.language)):
            # "I want to teach you something" is just what the question is about.
            return ask(dialogue)
    if name and state.asked == "task_name":
        return in_state(dialogue, acts.Inform(name), replace(words, text=name))
    if name and known.name:
        return rename(dialogue, known.name, tidy_name(name))
    return (
        _late_thing(dialogue, state, words)
        or _early_steps(dialogue, state, words)
        or _late_count(dialogue, state, words)
    )


def _late_thing(dialogue: Dialogue, state: Introducing, words: Words) -> Turn | None:
    known = dialogue.known
    text = after(words.text, "things_told", dialogue.language)
    if not text or known.objects is None or state.asked in ("goal", "task_name"):
        return None
    had = {one.name for one in known.objects}
    new = tuple(one for one in things_in(text, known.scene, known.language) if one.name not in had)
    if not new:
        return None
    more: Knowledge = replace(known, objects=(*known.objects, *new))
    told = line("done", "things", names=[one.name for one in new])
    return first(say(dialogue, told)[1], proceed(changed(dialogue, "objects", more)))


def _late_count(dialogue: Dialogue, state: Introducing, words: Words) -> Turn | None:
    """Take another number of steps where the name of one is asked for."""
    count = recounted(words.text, dialogue.language)
    if state.asked != "subtask_name" or not count or count > MOST_PARTS:
        return None
    parent, known = state.index[:-1], dialogue.known
    root = put(known.root, parent, counted(at(known.root, parent), count))
    told = line("done", "counted", count=count)
    counting = changed(dialogue, "subtask_count", replace(known, root=root))
    return first(say(dialogue, told)[1], proceed(counting))


def _early_steps(dialogue: Dialogue, state: Introducing, words: Words) -> Turn | None:
    """Take the steps where they are told before they are asked for."""
    known = dialogue.known
    if state.asked not in ("objects", "body", "pose") or state.index or known.root.parts:
        return None
    steps = listed_steps(words.text, language=dialogue.language)
    if not steps or len(set(steps)) < len(steps):
        return None
    root = with_parts(known.root, tuple(Sketch(step) for step in steps))
    more = replace(known, root=root)
    if known.objects is None:
        things = things_in(words.text, known.scene, known.language)
        language = known.language
        named = tuple(one for one in things if not is_lone_verb(one.name, language, ending=True))
        # Verbs alone tell no thing: then it is still asked which there are.
        more = replace(more, objects=named if named or not things else None)
    told = line("done", "steps", names=list(steps))
    noted = changed(dialogue, "steps", all_understood(more))
    return first(say(dialogue, told)[1], proceed(noted))


def _standing(dialogue: Dialogue, words: Words, _: tuple[acts.TeacherAct, ...]) -> Turn | None:
    """Take where the teacher stands, told before it is asked."""
    if dialogue.pending is not None or not mentions(words.text, hints("stands", dialogue.language)):
        return None
    told = matter(words.text, "facing", dialogue.language)
    if not told:
        return None
    known = replace(dialogue.known, facing="facing" if told == "facing" else "own")
    standing = changed(dialogue, "facing", known, clean=dialogue.clean)
    return tell(standing, line("told", f"facing_{known.facing}"))


def _puzzled(dialogue: Dialogue, words: Words, _: tuple[acts.TeacherAct, ...]) -> Turn | None:
    how = mentions(words.text, hints("how_to_show", dialogue.language))
    if isinstance(dialogue.state, AwaitingShow) and dialogue.pending is None and how:
        return tell(dialogue, help_line(dialogue))
    if not isinstance(dialogue.state, Introducing) or not is_puzzled(words.text, dialogue.language):
        return None
    return tell(dialogue, help_line(dialogue))


def _fresh(dialogue: Dialogue, words: Words, meant: tuple[acts.TeacherAct, ...]) -> Turn | None:
    """Begin another task; at the very beginning that is what goes on anyway."""
    wanted = mentions(words.text, hints("new_task", dialogue.language))
    if not wanted or not mentions(words.text, hints("new_task_verbs", dialogue.language)):
        return None
    if _asks(dialogue, "task_name"):
        return ask(dialogue)
    return fresh_wanted(dialogue)


def _asks(dialogue: Dialogue, asked: str) -> bool:
    state = dialogue.state
    return isinstance(state, Introducing) and state.asked == asked and dialogue.pending is None


_REPLIES = (
    _person,
    _courtesy,
    recut,
    plan_corrected,
    called,
    added,
    removed,
    swapped,
    split_into,
    does_otherwise,
    does_at_once,
    shown_again,
    shown_wrongly,
    order_freed,
    told_size,
    told_shape,
    told_several,
    slip,
    no_thing,
    sized,
    regoaled,
    _late,
    _standing,
    _puzzled,
    _fresh,
)
