"""The other one was meant: the second-best reading, or the other of two candidates."""

from __future__ import annotations

from dataclasses import replace

from assistant.dialogue.asking import tell
from assistant.dialogue.correcting import Correction
from assistant.dialogue.doubting import doubted, is_guess
from assistant.dialogue.finding import find, name_at, spoken_of
from assistant.dialogue.going_back import resettled
from assistant.dialogue.listening import beneath, listening
from assistant.dialogue.placing import thing_named
from assistant.dialogue.state import Dialogue, Other
from assistant.dialogue.turn import Turn, Words, line
from assistant.language.actions import mentioned_objects
from assistant.language.asides import after
from assistant.language.hints import hints, mentions
from assistant.language.second import second_reading
from assistant.language.understanding import understand
from assistant.model import teacher_acts as acts


def wants_other(dialogue: Dialogue, text: str) -> bool:
    """Whether the teacher means the other of two things, and there is one."""
    kept = dialogue.other
    there = is_guess(dialogue.pending) or (kept is not None and kept.acts)
    return bool(there) and mentions(text, hints("other_one", dialogue.language))


def named_other(dialogue: Dialogue, text: str) -> acts.TeacherAct | None:
    """Return what was just done, done where "no, I meant the green one" says; None if unclear."""
    told = after(text, "meant", dialogue.language)
    kept = dialogue.other
    if not told or kept is None or kept.done is None or dialogue.pending is not None:
        return None
    if isinstance(kept.done, acts.SetPose):
        thing = thing_named(dialogue.known, told)
        return replace(kept.done, object=thing) if thing else None
    if isinstance(kept.done, acts.Translate | acts.Rotate | acts.Gripper | acts.AdjustSpeed):
        otherwise = _change_meant(dialogue, told, kept.done)
        if otherwise is not None:
            return otherwise
        step = _step_meant(dialogue, told, kept.done.where)
        return replace(kept.done, where=acts.Where(step, "during")) if step else None
    return None


def _change_meant(dialogue: Dialogue, told: str, done: Correction) -> acts.TeacherAct | None:
    """Return a correction of the same kind at the same place: "no, I meant down"."""
    now = replace(listening(dialogue), stage="practice", asked="satisfied")
    language = dialogue.language
    # "right" alone may be a yes; "more right" is not.
    texts = (told, *(more.format(told=told) for more in hints("meant_more", language)))
    read = (understand(text, now, language).acts for text in texts)
    single = (meant[0] for meant in read if len(meant) == 1)
    only = next((one for one in single if type(one) is type(done)), None)
    if not isinstance(only, Correction) or only.where is not None:
        return None
    only = _as_far(only, done)
    # A pace of all the task belongs to no step.
    return replace(only, where=done.where if done.where and done.where.subtask else None)


def _as_far(only: Correction, done: Correction) -> Correction:
    """Return a correction as large as the one before it, where it tells no size of its own."""
    if isinstance(only, acts.Translate) and isinstance(done, acts.Translate):
        plain = only.distance_m is None and only.degree is None
        return replace(only, distance_m=done.distance_m, degree=done.degree) if plain else only
    if isinstance(only, acts.Rotate) and isinstance(done, acts.Rotate):
        plain = only.angle_deg is None and only.degree is None
        return replace(only, angle_deg=done.angle_deg, degree=done.degree) if plain else only
    return only


def _step_meant(dialogue: Dialogue, told: str, done: acts.Where | None) -> str:
    """Return the step a teacher names by its name, or by what is grasped or let go in it."""
    known = dialogue.known
    stations = known.lesson.stations if known.lesson is not None else ()
    kinds = {one.kind for one in stations if done is not None and one.primitive == done.subtask}
    things = mentioned_objects(told, known.objects or (), known.language)
    alike = [one.primitive for one in stations if one.kind in kinds and one.object in things]
    index = find(known, told)
    if index is not None:
        return name_at(known, index)
    return spoken_of(dialogue, told) or (alike[0] if len(alike) == 1 else "")


def guessed_other(dialogue: Dialogue) -> Turn:
    """Read back the second-best reading of a sentence whose best one was not meant."""
    pending, below = dialogue.pending, beneath(dialogue)
    free = replace(dialogue, pending=None, misses=1)
    second = None
    if pending is not None and below is not None and pending.words:
        second = pending.other or second_reading(
            pending.words, below, pending.acts, dialogue.language
        )
    if second is None or pending is None:
        return tell(free, line("told", "say_it_otherwise"))
    return doubted(free, second, Words(pending.words))


def taken_back(dialogue: Dialogue, other: Other) -> Turn:
    """Take back what was done with the first of two candidates."""
    free = replace(dialogue, pending=None, other=None)
    if len(dialogue.past) <= other.depth:
        return free, ()
    before = dialogue.past[other.depth]
    back = replace(free, known=before.known, past=dialogue.past[: other.depth], future=())
    turn = resettled(dialogue.known, back, line("done", "undone", what=before.label))
    return turn[0], tuple(turn[1][:1])


def remembered(before: Dialogue, turn: Turn) -> Turn:
    """Return the turn; what was the other candidate before it is forgotten."""
    after = turn[0]
    if after.other is None or after.other is not before.other:
        return turn
    return replace(after, other=None), turn[1]
