"""What was learned is told and gone through: questions first, then the whole (paper III-B)."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

from assistant.dialogue.asking import UNSURE, ask, index_of, introduced, learn, tell
from assistant.dialogue.bodies import WIDEST_MM, standing, too_wide
from assistant.dialogue.effects import Replay
from assistant.dialogue.events import Learned
from assistant.dialogue.knowledge import Knowledge
from assistant.dialogue.naming import alike, is_no_step, tidy_name
from assistant.dialogue.runs import Run
from assistant.dialogue.sketch import at, put
from assistant.dialogue.state import AwaitingShow, Dialogue, Reviewing, Running, Thinking
from assistant.dialogue.turn import Turn, changed, first, line, say, then
from assistant.dialogue.unnamed import introduced_late, names_new_step, no_step_of_its_own
from assistant.model import teacher_acts as acts
from assistant.model.lesson import Lesson, Question
from assistant.model.robot_acts import About, RobotAct

SLOW_REPLAY = 0.5
_DOUBTED = "doubtfully_shown"
"""Why learning asks whether a step was shown though it took a part for it."""


def learned(dialogue: Dialogue, event: Learned) -> Turn:
    """Tell what was understood of the demonstration, or why nothing was."""
    if not isinstance(dialogue.state, Thinking):
        return dialogue, ()
    known = dialogue.known
    if event.lesson is None:
        fewer = _without_last(dialogue)
        waiting = replace(
            changed(dialogue, "demonstration", fewer),
            state=AwaitingShow(),
            learn_why=event.why_not,
        )
        slots = {**event.facts, "reason": event.why_not}
        wide = too_wide(known) if event.why_not == "never_closed" else ""
        if wide:
            slots |= {"thing": wide, "most_mm": WIDEST_MM}
        return tell(waiting, RobotAct("error", f"not_learned.{event.why_not}", slots=slots))
    lesson = carried_over(known.lesson, event.lesson)
    # A lesson follows from what the teacher did last: undo takes back that, and the lesson too.
    after = replace(
        dialogue, known=with_lesson(known, lesson), clean=(), unsaved=True, agreed=False
    )
    questions = open_questions(lesson)
    reviewing = replace(after, state=Reviewing(questions), pace="slow")
    return tell(reviewing, read_back(after.known))


def _without_last(dialogue: Dialogue) -> Knowledge:
    """Return what is known without what was shown last; a step's old stretch is back again."""
    known, before = dialogue.known, dialogue.past[-1].known if dialogue.past else None
    if before is not None and len(before.demonstrations) == len(known.demonstrations):
        return before
    return replace(known, demonstrations=known.demonstrations[:-1])


def open_questions(lesson: Lesson) -> tuple[Question, ...]:
    """Return what is asked one by one; unsure cuts are told with the question about the whole."""
    return tuple(one for one in lesson.segmentation.questions if one.reason != UNSURE)


def carried_over(old: Lesson | None, new: Lesson) -> Lesson:
    """Return the new lesson with the corrections of the old one that still have a place."""
    if old is None:
        return new
    return replace(new, feedback=old.feedback, speed=old.speed)


def with_lesson(known: Knowledge, lesson: Lesson) -> Knowledge:
    """Return what is known after learning; things nobody placed are where the hand met them."""
    places = dict(known.setup.places)
    for station in lesson.stations:
        if station.frame not in places and station.frame:
            places[station.frame] = standing(known, station.frame, station.frame_to_world)
    setup = replace(known.setup, places=places)
    return replace(known, lesson=lesson, learned_root=known.root, reviewed=False, setup=setup)


def read_back(known: Knowledge) -> RobotAct:
    """Return the line that tells the episodes and what they were taken for."""
    lesson = known.lesson
    found = lesson.segmentation.episodes if lesson else ()
    episodes: list[dict[str, Any]] = [
        {
            "episode": number,
            "primitive": one.primitive or "",
            "from_s": round(one.from_s, 2),
            "to_s": round(one.to_s, 2),
            "probability": round(one.probability, 2),
        }
        for number, one in enumerate(found, start=1)
    ]
    lag = lesson.segmentation.cue_lag_s if lesson else None
    return line(
        "read_back",
        "episodes",
        about=About(known.name),
        count=len(episodes),
        episodes=episodes,
        cue_lag_s=None if lag is None else round(lag, 1),
    )


def review(dialogue: Dialogue, state: Reviewing, act: acts.TeacherAct, words: str = "") -> Turn:
    """Answer the open question of learning."""
    head = state.questions[0] if state.questions else None
    match act:
        case acts.Affirm() | acts.Approve() | acts.Start() | acts.Inform() if head is None:
            return _reviewed(dialogue)
        case acts.Again():
            return replay(dialogue)
        case acts.Deny() if head is not None and head.reason == _DOUBTED:
            return _show_again(dialogue, head.about)
        case acts.Deny() if head is None or head.asked == "confirm_segmentation":
            return say(dialogue, line("told", "change_segmentation"))
        case acts.Affirm() | acts.Approve() if head is not None:
            return _yes(dialogue, state)
        case acts.Deny() if names_new_step(state):
            return no_step_of_its_own(dialogue, state) or next_question(dialogue, state)
        case acts.Deny():
            return next_question(dialogue, state)
        case acts.Inform(value) if head is not None:
            return _told(dialogue, state, _own_name(state, str(value), words))
        case _:
            return tell(dialogue, line("error", "not_now"))


def _own_name(state: Reviewing, value: str, words: str) -> str:
    """Return the name a teacher gives; a new step is called as said, not as a known one."""
    known = value.lower() not in words.lower()
    return tidy_name(words) if known and words and names_new_step(state) else value


def next_question(dialogue: Dialogue, state: Reviewing) -> Turn:
    """Go on to the next question of learning."""
    return ask(replace(dialogue, state=Reviewing(state.questions[1:])))


def _reviewed(dialogue: Dialogue) -> Turn:
    known = replace(dialogue.known, reviewed=True)
    return introduced(changed(dialogue, "reviewed", known))


def _yes(dialogue: Dialogue, state: Reviewing) -> Turn:
    head = state.questions[0]
    index = index_of(dialogue.known, head.about)
    root = dialogue.known.root
    if head.asked == "optional" and index:
        node = replace(at(root, index), optional=True)
        known = replace(dialogue.known, root=put(root, index, node))
        return next_question(changed(dialogue, "optional", known), state)
    if head.asked == "order":
        node = replace(at(root, index), order="any")
        known = replace(dialogue.known, root=put(root, index, node))
        return next_question(changed(dialogue, "unordered", known), state)
    if names_new_step(state):
        return tell(dialogue, line("told", "name_it"))
    if head.asked == "missing_step":
        return _show_again(dialogue, head.about)
    return next_question(dialogue, state)


def _told(dialogue: Dialogue, state: Reviewing, value: str) -> Turn:
    """Take the name of the step that was not shown: only showing it again helps."""
    head = state.questions[0]
    if head.asked != "missing_step":
        return tell(dialogue, line("error", "not_now"))
    if names_new_step(state) and is_no_step(value, dialogue.language):
        return no_step_of_its_own(dialogue, state) or next_question(dialogue, state)
    if head.reason == "never_introduced":
        from_s, to_s = (float(str(head.facts.get(key, 0.0))) for key in ("from_s", "to_s"))
        return introduced_late(dialogue, value, from_s, to_s)
    if is_no_step(value, dialogue.language):
        return next_question(dialogue, state)
    nodes = [part.primitive for part in _episodes(dialogue) if part.primitive]
    # The step that was asked about may not have been seen, though a part is assigned to it.
    if alike(value, [name for name in nodes if name != head.about]):
        return tell(dialogue, line("told", "step_was_seen", name=value))
    return _show_again(dialogue, value)


def _show_again(dialogue: Dialogue, name: str) -> Turn:
    waiting = replace(dialogue, state=AwaitingShow())
    return tell(waiting, line("told", "needs_demonstration", name=name))


def _episodes(dialogue: Dialogue) -> tuple[Any, ...]:
    lesson = dialogue.known.lesson
    return lesson.segmentation.episodes if lesson else ()


def replay(dialogue: Dialogue) -> Turn:
    """Show slowly with the arm what was demonstrated; it is checked like any motion."""
    known = dialogue.known
    if not known.demonstrations or known.lesson is None:
        return tell(dialogue, line("error", "nothing_shown"))
    run = Run(known.setup, "slow", "replay", checked=True)
    moving = replace(dialogue, state=Running(), arm="moving", run=run, pending=None)
    effect = Replay(known.task, known.demonstrations[-1], known.setup, SLOW_REPLAY)
    return then(say(moving, line("report", "replaying", about=About(known.name))), effect)


def replayed(dialogue: Dialogue) -> Turn:
    """Go back to the open question after a replay."""
    known = dialogue.known
    questions = open_questions(known.lesson) if known.lesson else ()
    state = Reviewing(questions if not known.reviewed else ())
    at_rest = replace(dialogue, state=state, arm="rest")
    if known.reviewed:
        return introduced(at_rest)
    return ask(at_rest)


def move_cut(dialogue: Dialogue, act: acts.MoveCut) -> Turn:
    """Learn again with one cut elsewhere."""
    lesson = dialogue.known.lesson
    cuts = list(_boundaries(lesson)) if lesson else []
    names = [one.primitive for one in lesson.segmentation.episodes] if lesson else []
    index = index_of(dialogue.known, act.subtask)
    if lesson is None or act.subtask not in names[:-1] or not index:
        return tell(dialogue, line("error", "no_such_cut", name=act.subtask))
    last = max(number for number, name in enumerate(names[:-1]) if name == act.subtask)
    step_s = _cut_step_s(lesson, last)
    at_s = act.at_s if act.at_s is not None else cuts[last] + step_s[act.direction == "later"]
    episodes = lesson.segmentation.episodes
    if not episodes[last].from_s < at_s < episodes[last + 1].to_s:
        low, high = episodes[last].from_s, episodes[last + 1].to_s
        told = line("error", "cut_outside", at_s=at_s, from_s=low, to_s=high, name=act.subtask)
        return tell(dialogue, told)
    old_s = cuts[last]
    cuts[last] = at_s
    known = replace(dialogue.known, cuts_s=tuple(cuts), assigned=_as_assigned(lesson))
    told = line("done", "cut_moved", name=act.subtask, from_s=old_s, to_s=at_s)
    return first(say(dialogue, told)[1], learn(changed(dialogue, "cut", known)))


def _boundaries(lesson: Lesson) -> tuple[float, ...]:
    return tuple(one.to_s for one in lesson.segmentation.episodes[:-1])


def _as_assigned(lesson: Lesson) -> tuple[tuple[int, str], ...]:
    found = enumerate(lesson.segmentation.episodes, start=1)
    return tuple((number, one.primitive) for number, one in found if one.primitive)


def _cut_step_s(lesson: Lesson, last: int) -> tuple[float, float]:
    """Return half a second back and forth, less where an episode is short."""
    before, after = lesson.segmentation.episodes[last : last + 2]
    return (
        -min(0.5, (before.to_s - before.from_s) / 2),
        min(0.5, (after.to_s - after.from_s) / 2),
    )


def assign(dialogue: Dialogue, act: acts.Assign, name: str) -> Turn:
    """Learn again with one episode given to another primitive."""
    lesson = dialogue.known.lesson
    count = len(lesson.segmentation.episodes) if lesson else 0
    if lesson is None or not 1 <= act.episode <= count:
        return tell(dialogue, line("error", "no_such_episode", episode=act.episode, count=count))
    fixed = dict(_as_assigned(lesson)) | {act.episode: name}
    known = replace(
        dialogue.known, cuts_s=_boundaries(lesson), assigned=tuple(sorted(fixed.items()))
    )
    told = line("done", "assigned", episode=act.episode, name=name)
    return first(say(dialogue, told)[1], learn(changed(dialogue, "assigned", known)))
