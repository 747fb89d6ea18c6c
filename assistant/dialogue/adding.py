"""A plan corrected as people talk: "you forgot to let go", "move away comes last", "swap the two".

Only while the plan is read back: elsewhere such words answer other questions.
"""

from __future__ import annotations

import re
from collections.abc import Iterable

from assistant.dialogue.finding import find
from assistant.dialogue.naming import begins_or_ends_with_verb, tidy
from assistant.dialogue.sketch import Sketch
from assistant.dialogue.state import Dialogue, Introducing
from assistant.dialogue.structure import edit
from assistant.dialogue.turn import Turn, Words
from assistant.language.asides import after
from assistant.language.hints import hints, mentions
from assistant.model import teacher_acts as acts


def plan_corrected(
    dialogue: Dialogue, words: Words, _: Iterable[acts.TeacherAct] = ()
) -> Turn | None:
    """Add a step at an end of the plan, put one there, or exchange two; None for other talk."""
    state, parts = dialogue.state, dialogue.known.root.parts
    if not isinstance(state, Introducing) or state.asked != "confirm_tree" or not parts:
        return None
    if dialogue.pending is not None or "?" in words.text:
        return None
    if mentions(words.text, hints("swap", dialogue.language)):
        return _swapped(dialogue, words.text, parts)
    name, first = _told(dialogue, words.text)
    named = [one for one in parts if one.name and mentions(words.text, (one.name.lower(),))]
    # "First approach, then grasp" orders two steps and adds none.
    if not name or len(named) > 1:
        return None
    known = find(dialogue.known, name)
    end = parts[0].name if first else parts[-1].name
    if known is not None and len(known) == 1:
        mine = parts[known[0] - 1].name
        order = (mine, end) if first else (end, mine)
        return edit(dialogue, acts.Ordered(*order)) if mine != end else None
    if known is not None or not begins_or_ends_with_verb(name, dialogue.language):
        return None
    beside = {"before": end} if first else {"after": end}
    return edit(dialogue, acts.AddSubtask(name, **beside))


def _told(dialogue: Dialogue, text: str) -> tuple[str, bool]:
    """Return the step that is told to come, and whether it comes first; ``""`` if none is."""
    for part, first in (("comes_first", True), ("comes_last", False)):
        ends = "|".join(re.escape(one) for one in hints(part, dialogue.language))
        found = re.match(rf"(.+?)\s+(?:{ends})\W*$", text, re.IGNORECASE)
        if found:
            return tidy(found.group(1), dialogue.language), first
    for part, first in (("adds_first", True), ("adds_last", False)):
        rest = after(text, part, dialogue.language)
        if rest:
            return tidy(rest, dialogue.language), first
    return "", False


def _swapped(dialogue: Dialogue, text: str, parts: tuple[Sketch, ...]) -> Turn | None:
    """Exchange two steps that follow each other."""
    two = _two(dialogue, text.lower(), len(parts))
    if two is None or two[1] != two[0] + 1:
        return None
    return edit(dialogue, acts.Ordered(parts[two[1] - 1].name, parts[two[0] - 1].name))


def _two(dialogue: Dialogue, text: str, count: int) -> tuple[int, int] | None:
    """Return the numbers of the two steps a text names, the earlier first."""
    numbers = {**hints("ordinals", dialogue.language), **hints("numbers", dialogue.language)}
    said = [numbers.get(word, 0) for word in re.findall(r"[^\W\d_]+", text)]
    told = [number for number in said if number]
    told += [int(one) for one in re.findall(r"\d+", text)]
    if mentions(text, hints("last_two", dialogue.language)) or (count == 2 and not told):
        told = [count - 1, count]
    elif told == [1, 2] or len(told) == 1:
        told = [1, 2] if told[0] <= 2 else []
    if len(told) != 2 or not all(1 <= one <= count for one in told) or told[0] == told[1]:
        return None
    return min(told), max(told)
