"""The plan changed in words that mean it whatever is asked: steps added, renamed, set free.

"Add a look inside the first step" is no answer to how many parts a step has, and no name.
"""

from __future__ import annotations

import re
from collections.abc import Iterable
from functools import cache

from assistant.dialogue.asking import question
from assistant.dialogue.doubting import is_guess
from assistant.dialogue.finding import find, name_at, unclear
from assistant.dialogue.naming import alike, tidy, tidy_name
from assistant.dialogue.referring import lost_number, with_names
from assistant.dialogue.sketch import names
from assistant.dialogue.state import Dialogue
from assistant.dialogue.structure import add_inside, edit
from assistant.dialogue.things import bare
from assistant.dialogue.turn import Turn, Words
from assistant.language.asides import frees_order
from assistant.language.hints import hints
from assistant.model import teacher_acts as acts
from assistant.model.task import Index


def added(dialogue: Dialogue, words: Words, _: Iterable[acts.TeacherAct] = ()) -> Turn | None:
    """Add a step at an end of the plan, or as part of another; None for other talk."""
    if _asks_between(dialogue) or not dialogue.known.root.parts or "?" in words.text:
        return None
    return _at_end(dialogue, words.text) or _as_part(dialogue, words.text)


def called(dialogue: Dialogue, words: Words, _: Iterable[acts.TeacherAct] = ()) -> Turn | None:
    """Rename a step, whatever is asked: "the second step is called fetch it"; None else.

    What is said of a step by a number that none has is told to be of no step.
    """
    if _asks_between(dialogue) or not dialogue.known.root.parts or "?" in words.text:
        return None
    lost = lost_number(dialogue, words.text)
    if lost:
        return unclear(dialogue, lost)
    marks = _any("is_called", dialogue.language)
    leads = _leads(dialogue.language)
    told = re.match(rf"{leads}(.+?)\s+(?:{marks})\s+(.+)$", words.text, re.IGNORECASE)
    if told is None:
        return None
    old = bare(with_names(dialogue, told.group(1)), dialogue.language)
    if not alike(old, names(dialogue.known.root)):
        return None
    return edit(dialogue, acts.Rename(old, tidy_name(told.group(2))))


def order_freed(dialogue: Dialogue, words: Words, _: Iterable[acts.TeacherAct] = ()) -> Turn | None:
    """Let the steps come in any order, whoever says so of all of them; None for other talk."""
    asked = question(dialogue)
    if dialogue.pending is not None or not dialogue.known.root.parts:
        return None
    if asked is None or asked.asked == "order" or not frees_order(words.text, dialogue.language):
        return None
    return edit(dialogue, acts.Unordered(()))


def _asks_between(dialogue: Dialogue) -> bool:
    """Whether a question in between is open that is more than a guess."""
    return dialogue.pending is not None and not is_guess(dialogue.pending)


def _at_end(dialogue: Dialogue, text: str) -> Turn | None:
    """Add a step first or last of all: "add move away at the end"."""
    parts = dialogue.known.root.parts
    for part, beside in (
        ("comes_first", {"before": parts[0].name}),
        ("comes_last", {"after": parts[-1].name}),
    ):
        found = _ends(part, dialogue.language).match(text)
        name = bare(found.group("name"), dialogue.language) if found else ""
        if name and all(beside.values()):
            return edit(dialogue, acts.AddSubtask(name, **beside))
    return None


def _as_part(dialogue: Dialogue, text: str) -> Turn | None:
    """Add a part to a step: "add a look inside the first step"."""
    text = with_names(dialogue, text)
    found = _inside(dialogue.language).match(text)
    if found is None:
        return None
    name, where = bare(found.group("name"), dialogue.language), found.group("where")
    index = find(dialogue.known, where)
    if not name or index is None or find(dialogue.known, name) == index:
        return None
    if found.group("soft") and not _called(dialogue, where, index):
        # "Put the block into the box" names a thing, not the step that speaks of it.
        return None
    return add_inside(dialogue, name, index)


def _called(dialogue: Dialogue, text: str, index: Index) -> bool:
    """Whether a text is a step's own name."""
    return tidy(text, dialogue.language).lower() == name_at(dialogue.known, index).lower()


@cache
def _inside(language: str) -> re.Pattern[str]:
    verbs = rf"(?:(?P<plain>{_any('adds', language)})|(?P<soft>{_any('adds_softly', language)}))"
    inside = rf"(?:{_any('inside', language)})\s+(?P<where>.+?)"
    return re.compile(
        rf"{_leads(language)}{verbs}\s+{_new(language)}\s+{inside}{_adds_end(language)}",
        re.IGNORECASE,
    )


@cache
def _ends(part: str, language: str) -> re.Pattern[str]:
    verbs, place = rf"(?:{_any('adds', language)})", rf"(?:{_any(part, language)})"
    # Some languages end with the verb's particle, before or after the place.
    return re.compile(
        rf"{_leads(language)}{verbs}\s+(?:(?P<first>{place})\s+)?{_new(language)}"
        rf"(?(first)|\s+{place}){_adds_end(language)}",
        re.IGNORECASE,
    )


def _leads(language: str) -> str:
    return rf"(?:(?:{_any('leads', language)})\b\W*)*"


def _new(language: str) -> str:
    return rf"(?:(?:{_any('new_step_words', language)})\s+)?(?P<name>.+?)"


def _adds_end(language: str) -> str:
    return rf"(?:\s+(?:{_any('adds_ends', language)}))?\W*$"


def _any(part: str, language: str) -> str:
    return "|".join(re.escape(one) for one in sorted(hints(part, language), key=len, reverse=True))
