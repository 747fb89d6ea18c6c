"""Acts that mean the same in every state."""

from __future__ import annotations

from dataclasses import replace

from assistant.dialogue import keeping, practicing, recutting, structure
from assistant.dialogue.asking import tell
from assistant.dialogue.changing import adjust_last, correct
from assistant.dialogue.finding import find, name_at, unclear
from assistant.dialogue.going_back import go_back
from assistant.dialogue.placing import set_pose
from assistant.dialogue.plain_answers import answers_by_words
from assistant.dialogue.state import (
    Dialogue,
)
from assistant.dialogue.turn import Turn, Words, line, say
from assistant.dialogue.undoing import redo, undo
from assistant.model import teacher_acts as acts


def general(dialogue: Dialogue, act: acts.TeacherAct, words: Words) -> Turn | None:
    """Do what means the same in every state."""
    if answers_by_words(dialogue, act):
        return None
    match act:
        case acts.Pause():
            return practicing.pause(dialogue)
        case acts.NewSetup():
            return practicing.new_setup(dialogue)
        case acts.SetPose():
            sure = words.sure or not words.by_voice
            return set_pose(dialogue, act, words.text, sure=sure)
        case acts.Translate() | acts.Rotate() | acts.AdjustSpeed() | acts.Gripper():
            return correct(dialogue, act, words.text, by_voice=words.by_voice, sure=words.sure)
        case acts.AdjustLast():
            return adjust_last(dialogue, act, words.text)
        case acts.MoveCut() | acts.Assign():
            return _recut(dialogue, act)
        case _:
            return _of_knowledge(dialogue, act)


def _of_knowledge(dialogue: Dialogue, act: acts.TeacherAct) -> Turn | None:
    """Change, bring back, keep or fetch what is known."""
    match act:
        case acts.Undo():
            return undo(dialogue)
        case acts.Redo():
            return redo(dialogue)
        case acts.GoBack(where):
            return go_back(dialogue, where)
        case acts.Save(name):
            return keeping.save(dialogue, name)
        case acts.Load(name):
            return keeping.load(dialogue, name)
        case acts.Compare(name):
            return keeping.load(dialogue, name, comparing=True)
        case (
            acts.Rename()
            | acts.Optional()
            | acts.Required()
            | acts.Unordered()
            | acts.Ordered()
            | acts.AddSubtask()
            | acts.RemoveSubtask()
            | acts.Merge()
            | acts.Split()
        ):
            return structure.edit(dialogue, act)
        case _:
            return None


def _recut(dialogue: Dialogue, act: acts.MoveCut | acts.Assign) -> Turn:
    if dialogue.busy:
        return say(dialogue, line("error", "while_moving"))
    if dialogue.known.lesson is None:
        return tell(dialogue, line("error", "nothing_learned"))
    index = find(dialogue.known, act.subtask)
    if index is None:
        return unclear(dialogue, act.subtask)
    at_rest = replace(dialogue, arm="rest")
    if isinstance(act, acts.MoveCut):
        named = replace(act, subtask=name_at(dialogue.known, index))
        return recutting.move_cut(at_rest, named)
    return recutting.assign(at_rest, act, index)
