"""Single corrections taken back and brought again, by their number in the list."""

from __future__ import annotations

import re
from dataclasses import replace

from assistant.dialogue.asking import tell
from assistant.dialogue.changing import corrected
from assistant.dialogue.state import Dialogue, Knowledge
from assistant.dialogue.turn import Turn, Words, changed, line
from assistant.language.hints import hints, mentions
from assistant.model.feedback import Feedback


def numbered(dialogue: Dialogue, words: Words) -> Turn | None:
    """Take back or bring again the corrections that a sentence numbers; None if it does not."""
    text = words.text.lower()
    if dialogue.known.lesson is None or not mentions(text, hints("corrections", dialogue.language)):
        return None
    if mentions(text, hints("bring_back", dialogue.language)):
        return _brought(dialogue, text)
    return _taken(dialogue, text) if mentions(text, hints("take_back", dialogue.language)) else None


def _given(known: Knowledge) -> tuple[Feedback, ...]:
    return known.lesson.feedback if known.lesson is not None else ()


def _taken(dialogue: Dialogue, text: str) -> Turn | None:
    given = _given(dialogue.known)
    wanted = _numbers(dialogue, text, len(given))
    if wanted is None:
        return None
    lost = [number for number in wanted if not 1 <= number <= len(given)]
    if lost or not given:
        told = line("error", "no_such_correction", number=(lost or [1])[0], count=len(given))
        return tell(dialogue, told)
    left = tuple(one for number, one in enumerate(given, 1) if number not in wanted)
    gone = [given[number - 1].words for number in wanted]
    told = line("done", "correction_undone", names=gone, left=len(left))
    return tell(_with(dialogue, left), told)


def _brought(dialogue: Dialogue, text: str) -> Turn | None:
    """Bring back what stood at a number the last time when one more correction stood."""
    wanted = _numbers(dialogue, text, 0)
    if wanted is None or len(wanted) != 1:
        return None
    number, now = wanted[0], _given(dialogue.known)
    for change in reversed((*dialogue.past, *dialogue.future)):
        then = _given(change.known)
        if 1 <= number <= len(then) and then[number - 1] not in now:
            back = (*now[: number - 1], then[number - 1], *now[number - 1 :])
            told = line("done", "correction_redone", names=[then[number - 1].words])
            return tell(_with(dialogue, back), told)
    return tell(dialogue, line("error", "nothing_to_redo"))


def _with(dialogue: Dialogue, feedback: tuple[Feedback, ...]) -> Dialogue:
    lesson = dialogue.known.lesson
    if lesson is None:
        return dialogue
    known = replace(dialogue.known, lesson=replace(lesson, feedback=feedback))
    return corrected(changed(dialogue, "corrections", known))


def _numbers(dialogue: Dialogue, text: str, count: int) -> tuple[int, ...] | None:
    """Return which numbers a text means, of `count`; None if it tells none."""
    ordinals: dict[str, int] = hints("ordinals", dialogue.language)
    counts: dict[str, int] = hints("numbers", dialogue.language)
    words = re.findall(r"[^\W\d_]+|\d+", text)
    value = {**ordinals, **counts}
    # "the correction one" is number one, "the last two corrections" are two of them.
    told = [int(word) if word.isdigit() else value.get(word, 0) for word in words]
    numbers = [number for number in told if number > 0]
    if mentions(text, hints("latest", dialogue.language)):
        many = numbers[0] if numbers else 1
        return tuple(range(max(count - many, 0) + 1, count + 1)) if many > 1 else None
    if mentions(text, hints("every", dialogue.language)):
        return tuple(range(1, count + 1))
    return tuple(sorted(set(numbers))) or None
