"""Single corrections taken back and brought again, by their number or by their words."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from assistant.dialogue.asking import tell
from assistant.dialogue.changing import corrected
from assistant.dialogue.doubting import without_guess
from assistant.dialogue.finding import find
from assistant.dialogue.knowledge import Knowledge
from assistant.dialogue.picking import Picked, described, picked
from assistant.dialogue.recounting import plain_corrections
from assistant.dialogue.state import Dialogue
from assistant.dialogue.turn import Turn, Words, changed, line
from assistant.dialogue.undoing import redo
from assistant.language.hints import hints, mentions
from assistant.model.feedback import Feedback
from assistant.model.robot_acts import RobotAct

LABELS = ("correction", "corrections")
"""Changes that are of corrections alone."""


def numbered(dialogue: Dialogue, words: Words) -> Turn | None:
    """Take back or bring again the corrections a sentence tells; None if it tells none."""
    text, language = words.text.lower(), dialogue.language
    if dialogue.known.lesson is None:
        return None
    named = mentions(text, hints("corrections", language))
    verbs: list[str] = hints("bring_back", language)
    # "Again" alone asks for another run.
    surely = [verb for verb in verbs if verb not in hints("bring_back_only_named", language)]
    free = without_guess(dialogue)
    if mentions(text, verbs if named else surely):
        return _brought(free, picked(text, language), named=named)
    if mentions(text, hints("take_back", language)):
        return _taken(free, picked(text, language), text, named=named)
    return None


def given(known: Knowledge) -> tuple[Feedback, ...]:
    """Return the corrections that stand."""
    return known.lesson.feedback if known.lesson is not None else ()


def _taken(dialogue: Dialogue, meant: Picked, text: str, *, named: bool) -> Turn | None:
    now = given(dialogue.known)
    if meant.words:
        return _taken_by_words(dialogue, meant, text)
    if not named and not now:
        return None
    last_change = dialogue.past[-1].label if dialogue.past else ""
    if meant.last and not meant.numbers and (last_change == "correction" or not named):
        # What was done last is what is taken back, and brought again, by a plain "undo".
        return None
    wanted = meant.of(len(now))
    if not wanted and not (named and meant.every):
        return None
    lost = [number for number in wanted if not 1 <= number <= len(now)]
    if lost or not now:
        told = line("error", "no_such_correction", number=(lost or [1])[0], count=len(now))
        return tell(dialogue, told)
    return _without(dialogue, wanted)


def _taken_by_words(dialogue: Dialogue, meant: Picked, text: str) -> Turn | None:
    """Take back the one correction the words are said of; of several ask which."""
    if find(dialogue.known, text) is not None:
        # A step of that name is spoken of.
        return None
    now = given(dialogue.known)
    fitting = described(dialogue.known, now, meant.words)
    if not fitting:
        return None
    told = meant.of(len(fitting))
    if told and max(told) <= len(fitting):
        fitting = [fitting[number - 1] for number in told]
    elif len(fitting) > 1:
        return tell(dialogue, _which(dialogue.known, fitting))
    return _without(dialogue, fitting)


def _which(known: Knowledge, numbers: Sequence[int]) -> RobotAct:
    listed = plain_corrections(known)
    fitting = [listed[number - 1] | {"number": number} for number in numbers]
    return line("error", "which_correction", corrections=fitting, number=numbers[0])


def _without(dialogue: Dialogue, numbers: Sequence[int]) -> Turn:
    now = given(dialogue.known)
    left = tuple(one for number, one in enumerate(now, 1) if number not in numbers)
    gone = [now[number - 1].words for number in numbers]
    told = line("done", "correction_undone", names=gone, left=len(left))
    return tell(_with(dialogue, left), told)


def _brought(dialogue: Dialogue, meant: Picked, *, named: bool) -> Turn | None:
    """Bring back what stood at a number, or is described, the last time that it stood."""
    number = meant.numbers[0] if len(meant.numbers) == 1 else None
    if number is None and not meant.words:
        plain = not meant.numbers
        return redo(dialogue) if plain and (named or _lost(dialogue)) else None
    now = given(dialogue.known)
    for change in reversed((*dialogue.past, *dialogue.future)):
        then = given(change.known)
        at = number
        if meant.words:
            found = described(change.known, then, meant.words)
            gone = [one for one in found if then[one - 1] not in now]
            at = gone[-1] if gone else None
        if at is not None and 1 <= at <= len(then) and then[at - 1] not in now:
            back = (*now[: at - 1], then[at - 1], *now[at - 1 :])
            told = line("done", "correction_redone", names=[then[at - 1].words])
            return tell(_with(dialogue, back), told)
    return tell(dialogue, line("error", "nothing_to_redo")) if named else None


def _lost(dialogue: Dialogue) -> bool:
    """Whether corrections were taken back by the last change, or by an undo just now."""
    changes = (dialogue.future or dialogue.past)[-1:]
    return any(change.label in LABELS for change in changes)


def _with(dialogue: Dialogue, feedback: tuple[Feedback, ...]) -> Dialogue:
    lesson = dialogue.known.lesson
    if lesson is None:
        return dialogue
    known = replace(dialogue.known, lesson=replace(lesson, feedback=feedback))
    return corrected(changed(dialogue, "corrections", known))
