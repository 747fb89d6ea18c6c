"""The teacher moves a cut, or gives a part to another step: it is learned anew (paper III-B)."""

from __future__ import annotations

from dataclasses import replace

from assistant.dialogue.asking import ask, index_of, learn, tell
from assistant.dialogue.finding import name_at
from assistant.dialogue.sketch import at, leaves
from assistant.dialogue.state import Dialogue, Pending
from assistant.dialogue.turn import Turn, changed, first, line, say
from assistant.model import teacher_acts as acts
from assistant.model.lesson import Lesson
from assistant.model.task import Index

STEP_S = 0.5
"""How far a cut is moved where nobody says how far."""


def move_cut(dialogue: Dialogue, act: acts.MoveCut) -> Turn:
    """Learn again with one cut elsewhere, the one that ends a step."""
    lesson = dialogue.known.lesson
    names = [one.primitive for one in lesson.segmentation.episodes] if lesson else []
    if lesson is None or act.subtask not in names[:-1] or not index_of(dialogue.known, act.subtask):
        return tell(dialogue, line("error", "no_such_cut", name=act.subtask))
    last = max(number for number, name in enumerate(names[:-1]) if name == act.subtask)
    if act.at_s is not None:
        return put_cut(dialogue, lesson, last, act.at_s)
    return put_cut(dialogue, lesson, last, stepped(lesson, last, later=act.direction == "later"))


def put_cut(dialogue: Dialogue, lesson: Lesson, cut: int, at_s: float) -> Turn:
    """Learn again with one cut at another time.

    Parameters
    ----------
    dialogue : Dialogue
    lesson : Lesson
    cut : int
        After which part it comes, from 0.
    at_s : float
        In s of the demonstration.
    """
    before, after = lesson.segmentation.episodes[cut : cut + 2]
    name = before.primitive
    if not before.from_s < at_s < after.to_s:
        low, high = before.from_s, after.to_s
        told = line("error", "cut_outside", name=name, part=cut + 1, from_s=low, to_s=high)
        return tell(dialogue, told)
    cuts = list(cuts_of(lesson))
    cuts[cut] = at_s
    known = replace(dialogue.known, cuts_s=tuple(cuts), assigned=_as_assigned(lesson))
    told = line("done", "cut_moved", name=name, from_s=before.to_s, to_s=at_s, part=cut + 1)
    return first(say(dialogue, told)[1], learn(changed(dialogue, "cut", known)))


def cuts_of(lesson: Lesson) -> tuple[float, ...]:
    """Return the times between the parts, in s."""
    return tuple(one.to_s for one in lesson.segmentation.episodes[:-1])


def stepped(lesson: Lesson, cut: int, *, later: bool) -> float:
    """Return the time of a cut half a second on or back, less where a part is short."""
    before, after = lesson.segmentation.episodes[cut : cut + 2]
    room = after.to_s - after.from_s if later else before.to_s - before.from_s
    by_s = min(STEP_S, room / 2)
    return before.to_s + (by_s if later else -by_s)


def _as_assigned(lesson: Lesson) -> tuple[tuple[int, str], ...]:
    found = enumerate(lesson.segmentation.episodes, start=1)
    return tuple((number, one.primitive) for number, one in found if one.primitive)


def assign(dialogue: Dialogue, act: acts.Assign, index: Index) -> Turn:
    """Learn again with one part given to another step; of a whole with parts, ask to which."""
    lesson = dialogue.known.lesson
    count = len(lesson.segmentation.episodes) if lesson else 0
    if lesson is None or not 1 <= act.episode <= count:
        return tell(dialogue, line("error", "no_such_episode", episode=act.episode, count=count))
    node, name = at(dialogue.known.root, index), name_at(dialogue.known, index)
    if node.parts:
        return _which_of(dialogue, act, name, [leaf.name for _, leaf in leaves(node)])
    fixed = dict(_as_assigned(lesson)) | {act.episode: name}
    known = replace(dialogue.known, cuts_s=cuts_of(lesson), assigned=tuple(sorted(fixed.items())))
    told = line("done", "assigned", episode=act.episode, name=name)
    return first(say(dialogue, told)[1], learn(changed(dialogue, "assigned", known)))


def _which_of(dialogue: Dialogue, act: acts.Assign, whole: str, names: list[str]) -> Turn:
    """Ask to which motion of a whole a part belongs: a whole has no motion of its own."""
    question = line("ask", "which_part", asked="which", names=names, whole=whole, part=act.episode)
    meant = replace(act, subtask=whole)
    return ask(replace(dialogue, pending=Pending("which", question, (meant,), whole)))
