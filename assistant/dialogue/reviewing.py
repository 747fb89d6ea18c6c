"""What was learned is told and gone through: questions first, then the whole (paper III-B)."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

from assistant.dialogue.asking import UNSURE, ask, index_of, introduced, tell
from assistant.dialogue.bodies import WIDEST_MM, too_wide
from assistant.dialogue.effects import Replay
from assistant.dialogue.events import Learned
from assistant.dialogue.gripped import met
from assistant.dialogue.knowledge import Knowledge
from assistant.dialogue.missed import missed
from assistant.dialogue.naming import alike, is_no_step, tidy_name
from assistant.dialogue.runs import Run
from assistant.dialogue.sketch import at, put
from assistant.dialogue.state import AwaitingShow, Dialogue, Reviewing, Running, Thinking
from assistant.dialogue.turn import Turn, changed, line, say, then
from assistant.dialogue.unnamed import introduced_late, names_new_step, no_step_of_its_own
from assistant.model import teacher_acts as acts
from assistant.model.lesson import Lesson, Question
from assistant.model.robot_acts import About, RobotAct

SLOW_REPLAY = 0.5
_DOUBTED = "doubtfully_shown"
"""Why learning asks whether a step was shown though it took a part for it."""

_WORTH_A_WORD_S = 5.0


def learned(dialogue: Dialogue, event: Learned) -> Turn:
    """Tell what was understood of the demonstration, or why nothing was."""
    if not isinstance(dialogue.state, Thinking):
        return dialogue, ()
    known = dialogue.known
    if event.lesson is None:
        fewer = _without_last(dialogue)
        waiting = replace(changed(dialogue, "demonstration", fewer), state=AwaitingShow())
        slots = {**event.facts, "reason": event.why_not}
        wide = too_wide(known) if event.why_not == "never_closed" else ""
        if wide:
            slots |= {"thing": wide, "most_mm": WIDEST_MM}
        return tell(waiting, RobotAct("error", f"not_learned.{event.why_not}", slots=slots))
    fault = missed(known, event.lesson)
    if fault is not None:
        forgotten = changed(dialogue, "demonstration", _without_last(dialogue))
        return tell(replace(forgotten, state=AwaitingShow()), fault)
    lesson = carried_over(known.lesson, event.lesson)
    # A lesson follows from what the teacher did last: undo takes back that, and the lesson too.
    after = replace(
        dialogue, known=with_lesson(known, lesson), clean=(), unsaved=True, agreed=False
    )
    questions = open_questions(lesson, known)
    reviewing = replace(after, state=Reviewing(questions), pace="slow")
    return tell(reviewing, read_back(after.known))


def _without_last(dialogue: Dialogue) -> Knowledge:
    """Return what is known without what was shown last; a step's old stretch is back again."""
    known, before = dialogue.known, dialogue.past[-1].known if dialogue.past else None
    if before is not None and len(before.demonstrations) == len(known.demonstrations):
        return before
    return replace(known, demonstrations=known.demonstrations[:-1])


def open_questions(lesson: Lesson, known: Knowledge) -> tuple[Question, ...]:
    """Return what is asked one by one; unsure cuts are told with the question about the whole."""
    return tuple(
        one
        for one in lesson.segmentation.questions
        if one.reason != UNSURE and (one.asked, one.about) not in known.declined
    )


def carried_over(old: Lesson | None, new: Lesson) -> Lesson:
    """Return the new lesson with the corrections of the old one that still have a place."""
    if old is None:
        return new
    return replace(new, feedback=old.feedback, speed=old.speed)


def with_lesson(known: Knowledge, lesson: Lesson) -> Knowledge:
    """Return what is known after learning; things nobody placed are where the hand met them."""
    for station in lesson.stations:
        if station.frame not in known.setup.places and station.frame:
            known = met(known, station.frame, station.frame_to_world)
    return replace(known, lesson=lesson, learned_root=known.root, reviewed=False)


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
        waited_s=_waited_s(lesson) if lesson else None,
        shown=len(known.demonstrations) if len(known.demonstrations) > 1 else None,
    )


def _waited_s(lesson: Lesson) -> int | None:
    """Return how long the teacher stood still and the robot will not, if worth a word."""
    found, path = lesson.segmentation.episodes, lesson.path
    if path is None or not found:
        return None
    left_out_s = found[-1].to_s - found[0].from_s - float(path.t_s[-1])
    return round(left_out_s) if left_out_s >= _WORTH_A_WORD_S else None


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
        case acts.Deny() if head is not None and head.asked in ("optional", "order"):
            declined = (*dialogue.known.declined, (head.asked, head.about))
            known = replace(dialogue.known, declined=declined)
            return next_question(changed(dialogue, "declined", known), state)
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
    questions = open_questions(known.lesson, known) if known.lesson else ()
    state = Reviewing(questions if not known.reviewed else ())
    at_rest = replace(dialogue, state=state, arm="rest")
    if known.reviewed:
        return introduced(at_rest)
    return ask(at_rest)
