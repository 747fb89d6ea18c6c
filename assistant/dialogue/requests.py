"""Requests known by their words: a look ahead, the way home, things swapped, a kept task."""

from __future__ import annotations

import re
from dataclasses import replace

from assistant.dialogue.advice import followed
from assistant.dialogue.asking import ask, begin_run, tell
from assistant.dialogue.beside import rearranged, restored, told_beside
from assistant.dialogue.doubting import without_guess
from assistant.dialogue.effects import Home
from assistant.dialogue.finding import find, name_at
from assistant.dialogue.keeping import (
    answer_unsaved,
    discard_wanted,
    known_as,
    load,
    save,
    write_down,
)
from assistant.dialogue.knowledge import Knowledge
from assistant.dialogue.naming import tidy_name
from assistant.dialogue.practicing import UNTIL, new_setup
from assistant.dialogue.spots import anywhere
from assistant.dialogue.state import Dialogue, Introducing, Pending, Ran, Ready, Running, Watching
from assistant.dialogue.taking_back import numbered
from assistant.dialogue.turn import Turn, Words, line, say, then
from assistant.geometry import pose_to_mm_deg
from assistant.language.actions import mentioned_objects
from assistant.language.asides import after
from assistant.language.hints import hints, matter, mentions
from assistant.model.setup import Place
from assistant.model.task import primitives
from assistant.model.teacher_acts import Again, Save

LONGEST_DRAWN = 6
"""Words of a wish for just any arrangement."""
LONGEST_SAVED = 4
"""Words of a name told alone to save under; more are a sentence."""


def requested(dialogue: Dialogue, words: Words) -> Turn | None:
    """Do what is asked for in words that mean one thing only; None where they do not."""
    if dialogue.busy or isinstance(dialogue.state, Watching):
        return None
    calm = replace(dialogue, misses=0)
    for reply in (_kept_task, _saved_as, _written_down):
        turn = reply(calm, words)
        if turn is not None:
            return turn
    if not isinstance(dialogue.state, Ready | Running | Ran):
        return numbered(calm, words) or told_beside(calm, words) or anywhere(calm, words)
    calm = without_guess(calm)
    for reply in _AT_REST:
        turn = reply(calm, words)
        if turn is not None:
            return turn
    return None


def _rewind(dialogue: Dialogue, words: Words) -> Turn | None:
    """Nothing runs backwards: offer to begin anew, and to pause where the teacher wants to be."""
    told = after(words.text, "rewind", dialogue.language)
    if not told:
        return None
    step = _moment(dialogue, told)
    question = line("confirm", UNTIL if step else "begin_anew", asked="ready", name=step)
    return ask(replace(dialogue, pending=Pending("ready", question, (Again(),), words.text)))


def _moment(dialogue: Dialogue, told: str) -> str:
    """Return the motion after which it was as told: "the block was picked up"; empty if unclear.

    It is called by its name, or by what was grasped or let go in it.
    """
    known, language = dialogue.known, dialogue.language
    leaves = [leaf.name for leaf in primitives(known.task.tree)]
    index = find(known, told)
    if index is not None and name_at(known, index) in leaves:
        return name_at(known, index)
    kind = matter(told, "moments", language)
    things = mentioned_objects(told, known.objects or (), language)
    stations = known.lesson.stations if known.lesson is not None else ()
    hits = [one for one in stations if one.kind == kind]
    named = [one for one in hits if one.object in things or one.frame in things] or hits
    return named[0].primitive if len({one.primitive for one in named}) == 1 else ""


def _kept_task(dialogue: Dialogue, words: Words) -> Turn | None:
    """Load, compare or delete a kept task that is called by its name."""
    name = known_as(dialogue, after(words.text, "go_on_with", dialogue.language))
    if name:
        return load(dialogue, name)
    other = known_as(dialogue, after(words.text, "compare_with", dialogue.language))
    if other:
        return load(dialogue, other, comparing=True)
    untold = isinstance(dialogue.state, Introducing) and not dialogue.known.root.parts
    told = after(words.text, "compare_with", dialogue.language)
    if (
        told
        and dialogue.saved
        and not untold
        and not mentions(told, hints("saved_version", dialogue.language))
    ):
        return load(dialogue, told, comparing=True)
    told = after(words.text, "delete_task", dialogue.language)
    doomed = known_as(dialogue, told)
    if doomed:
        return discard_wanted(dialogue, doomed)
    if not told or not mentions(told, hints("version_words", dialogue.language)):
        return None
    lost = line("error", "no_such_task", name=tidy_name(told), names=list(dialogue.saved))
    return tell(dialogue, lost)


def _saved_as(dialogue: Dialogue, words: Words) -> Turn | None:
    """Save under a name that is told whole: "save it as version one"."""
    name = tidy_name(after(words.text, "save_as", dialogue.language))
    pending = dialogue.pending
    if pending is not None and pending.asked == "unsaved":
        name = name or tidy_name(after(words.text, "yes_as", dialogue.language))
        name = name or _bare_name(pending, words.text, dialogue.language)
        return answer_unsaved(dialogue, Save(name)) if name else None
    just_saved = any((said.act, said.topic) == ("done", "saved") for said in dialogue.said)
    if just_saved and not name:
        # "No, call it tower two": the version just saved was to have that name.
        name = tidy_name(after(words.text, "naming", dialogue.language))
    if not name or pending is not None or not dialogue.known.name:
        return None
    return save(dialogue, name)


def _bare_name(pending: Pending, text: str, language: str) -> str:
    """Return the name that is told alone where another one was offered; empty for other talk."""
    name = tidy_name(text)
    told = re.findall(r"[^\W_]+", name.lower())
    other = set(hints("no_names_to_save", language))
    asks = "?" in text or pending.line.topic == "discard"
    return "" if asks or not 0 < len(told) <= LONGEST_SAVED or other & set(told) else name


def _written_down(dialogue: Dialogue, words: Words) -> Turn | None:
    """Write a record of the task that people can read."""
    state = dialogue.state
    naming = isinstance(state, Introducing) and state.asked != "confirm_tree"
    if naming or not mentions(words.text, hints("write_down", dialogue.language)):
        return None
    return write_down(dialogue)


def _pointed(dialogue: Dialogue, words: Words) -> Turn | None:
    """Tell who points somewhere that the robot cannot see it, and what it would need."""
    if re.search(r"\d", words.text) or not mentions(
        words.text, hints("pointing", dialogue.language)
    ):
        return None
    return tell(dialogue, line("told", "cannot_see"))


def _look_ahead(dialogue: Dialogue, words: Words) -> Turn | None:
    """Check a run and tell it, without moving."""
    if (
        not mentions(words.text, hints("dry_run", dialogue.language))
        or dialogue.known.lesson is None
    ):
        return None
    checking = begin_run(replace(dialogue, arm="rest"), look=True)[0]
    run = checking.run and replace(checking.run, purpose="dry")
    dry = replace(checking, run=run)
    return dry, begin_run(replace(dialogue, arm="rest"), look=True)[1]


def _home(dialogue: Dialogue, words: Words) -> Turn | None:
    """Bring the hand back to where the arrangement has it start, at rest or after a stop."""
    if not mentions(words.text, hints("home", dialogue.language)):
        return None
    if dialogue.arm not in ("rest", "stopped", "paused"):
        return None
    going = replace(dialogue, state=Ready(), arm="homing", pending=None)
    return then(say(going, line("announce", "home")), Home(dialogue.known.setup))


def _drawn(dialogue: Dialogue, words: Words) -> Turn | None:
    """Draw another arrangement for who wants just any."""
    short = len(words.text.split()) <= LONGEST_DRAWN
    if not short or not mentions(words.text, hints("at_random", dialogue.language)):
        return None
    return new_setup(dialogue)


def _swapped(dialogue: Dialogue, words: Words) -> Turn | None:
    """Put two things in each other's place and look whether they can be reached there."""
    if not mentions(words.text, hints("swap", dialogue.language)):
        return None
    known = dialogue.known
    placed = [one for one in known.objects or () if one.name in known.setup.places]
    told = mentioned_objects(words.text, placed, dialogue.language) if len(placed) > 2 else ()
    names = told[:2] if len(told) > 1 else tuple(one.name for one in placed)
    if len(names) != 2 or any(name not in known.scene.bodies for name in names):
        return tell(dialogue, line("error", "swap_which", names=[one.name for one in placed]))
    setup = replace(known.setup, name="swapped", places=_exchanged(known, names[0], names[1]))
    return rearranged(dialogue, setup)


def _exchanged(known: Knowledge, one: str, other: str) -> dict[str, Place]:
    """Return the places with two things exchanged; each keeps its own height."""
    told = known.setup.places
    lying = {}
    for name in (one, other):
        xyz, rpy = pose_to_mm_deg(known.scene.body_pose(name, told[name]))
        lying[name] = [round(float(value), 3) for value in (*xyz, *rpy)]
    new = dict(told)
    for name, its in ((one, lying[other]), (other, lying[one])):
        turned = (lying[name][3], lying[name][4], its[5])
        new[name] = Place("body", (its[0], its[1], lying[name][2]), turned)
    return new


_AT_REST = (
    followed,
    numbered,
    _rewind,
    restored,
    _swapped,
    told_beside,
    _pointed,
    _look_ahead,
    _home,
    _drawn,
)
"""What is asked for in practice, in the order in which words are looked at."""
