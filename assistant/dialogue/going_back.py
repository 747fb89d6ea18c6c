"""Back to an earlier stage, or to an earlier state of knowledge, with everything kept."""

from __future__ import annotations

from dataclasses import replace

from assistant.dialogue import introduction
from assistant.dialogue.asking import ask, introduced, proceed, tell
from assistant.dialogue.effects import Effect, Halt
from assistant.dialogue.keeping import arrange_if_changed
from assistant.dialogue.knowledge import Knowledge
from assistant.dialogue.reviewing import read_back
from assistant.dialogue.state import AwaitingShow, Dialogue, Introducing, Ready, Reviewing
from assistant.dialogue.turn import Turn, first, line, say
from assistant.model.lesson import Episode, Question
from assistant.model.robot_acts import RobotAct
from assistant.model.teacher_acts import Stage


def go_back(dialogue: Dialogue, stage: Stage, *, step: str = "") -> Turn:
    """Return to a stage; nothing that was taught is lost.

    `step` is the one to be shown again, where that is all the demonstration is for.
    """
    halting: tuple[Effect, ...] = ()
    if dialogue.can_halt:
        halting = (Halt("stop"),)
    still = replace(dialogue, arm="rest", pending=None)
    known = dialogue.known
    missing = introduction.need(replace(known, tree_confirmed=True))
    if stage == "introduction":
        again = replace(still, known=replace(known, tree_confirmed=False))
        return first(halting, proceed(replace(again, state=Introducing("confirm_tree"))))
    if missing is not None:
        told = line("error", "not_introduced" if known.lesson is None else "plan_open")
        return first(halting, first(say(still, told)[1], ask(replace(still, state=missing))))
    confirmed = replace(still, known=replace(known, tree_confirmed=True))
    if stage == "demonstration":
        return first(halting, ask(replace(confirmed, state=AwaitingShow(step))))
    if known.lesson is None:
        told = line("error", "nothing_learned")
        return first(halting, tell(replace(confirmed, state=AwaitingShow()), told))
    if stage == "learning":
        reviewing = replace(confirmed, state=Reviewing())
        return first(halting, tell(reviewing, read_back(known)))
    # Who wants to practice takes what was learned as it is.
    known = replace(confirmed.known, reviewed=True)
    return first(halting, ask(replace(confirmed, known=known, state=Ready())))


def resettled(
    before: Knowledge, dialogue: Dialogue, said: RobotAct, questions: tuple[Question, ...] = ()
) -> Turn:
    """Go where knowledge that was taken back or brought again belongs.

    `questions` are those of learning that were open when it was so.
    """
    known = dialogue.known
    moved = arrange_if_changed(before, dialogue)[1]
    told = (*say(dialogue, said)[1], *moved)
    state = introduction.need(known)
    if isinstance(dialogue.state, Introducing) or state is not None:
        going = replace(dialogue, state=Introducing("confirm_tree"), arm="rest")
        return first(told, proceed(going))
    if known.lesson is None:
        return first(told, ask(replace(dialogue, state=AwaitingShow(), arm="rest")))
    if isinstance(dialogue.state, AwaitingShow | Reviewing) or not known.reviewed:
        rested = replace(dialogue, arm="rest")
        return first(told, _gone_through_again(before, rested, questions))
    return first(told, ask(dialogue))


def _gone_through_again(
    before: Knowledge, dialogue: Dialogue, questions: tuple[Question, ...]
) -> Turn:
    """Ask what was open, and tell the parts of the demonstration where they are others now."""
    turn = introduced(dialogue)
    if not isinstance(turn[0].state, Reviewing):
        return turn
    reviewing = replace(turn[0], state=Reviewing(questions))
    if _parts(before) == _parts(dialogue.known):
        return ask(reviewing)
    return tell(reviewing, read_back(dialogue.known))


def _parts(known: Knowledge) -> tuple[Episode, ...]:
    return () if known.lesson is None else known.lesson.segmentation.episodes
