"""The plan changed in words that mean it whatever is asked: steps added, renamed, set free.

"Add a look inside the first step" is no answer to how many parts a step has, and no name.
"""

from __future__ import annotations

import re
from collections.abc import Iterable
from functools import cache

from assistant.dialogue.asking import question
from assistant.dialogue.doubting import is_guess
from assistant.dialogue.finding import find, find_whole, name_at, unclear
from assistant.dialogue.naming import alike, tidy, tidy_name
from assistant.dialogue.one_step import wanted
from assistant.dialogue.referring import lost_number, with_names
from assistant.dialogue.sketch import names, walk
from assistant.dialogue.state import Dialogue
from assistant.dialogue.structure import add_inside, edit
from assistant.dialogue.things import bare
from assistant.dialogue.turn import Turn, Words
from assistant.language.asides import frees_order
from assistant.language.hints import hints, mentions
from assistant.model import teacher_acts as acts
from assistant.model.task import Index

MOST_LEAD = 4
"""Words between a verb of showing and the step that is to be shown."""


def added(dialogue: Dialogue, words: Words, _: Iterable[acts.TeacherAct] = ()) -> Turn | None:
    """Add a step at an end of the plan, or as part of another; None for other talk."""
    if _asks_between(dialogue) or not dialogue.known.root.parts or "?" in words.text:
        return None
    text = words.text
    return _at_end(dialogue, text) or _beside(dialogue, text) or _as_part(dialogue, text)


def removed(dialogue: Dialogue, words: Words, _: Iterable[acts.TeacherAct] = ()) -> Turn | None:
    """Take a step out that is called by its name while another name is asked for."""
    asked = question(dialogue)
    if _asks_between(dialogue) or asked is None or asked.asked not in ("subtask_name", "actions"):
        return None
    marks = _any("removes", dialogue.language)
    text = with_names(dialogue, words.text)
    told = re.match(rf"{_leads(dialogue.language)}(?:{marks})\s+(.+?)\W*$", text, re.IGNORECASE)
    name = bare(told.group(1), dialogue.language) if told else ""
    if not alike(name, names(dialogue.known.root)):
        return None
    return edit(dialogue, acts.RemoveSubtask(name))


def swapped(dialogue: Dialogue, words: Words, _: Iterable[acts.TeacherAct] = ()) -> Turn | None:
    """Exchange two steps that are called by their names; None for things and other talk."""
    if _asks_between(dialogue) or not mentions(words.text, hints("swaps_steps", dialogue.language)):
        return None
    root, text = dialogue.known.root, with_names(dialogue, words.text).lower()
    told = [(index, node.name) for index, node in walk(root) if index and node.name]
    said = [one for one in told if mentions(text, (one[1],))] or _in_part(dialogue, text)
    if len(said) != 2 or said[0][0][:-1] != said[1][0][:-1]:
        return None
    (here, one), (there, other) = said
    return edit(dialogue, acts.Ordered(other, one)) if there[-1] == here[-1] + 1 else None


def _in_part(dialogue: Dialogue, text: str) -> list[tuple[Index, str]]:
    """Return the steps that pieces of a text name by some of their words."""
    joints = "|".join(re.escape(one) for one in hints("joins", dialogue.language))
    pieces = re.split(joints, re.sub(_any("swaps_steps", dialogue.language), " ", text))
    found = [find(dialogue.known, piece) for piece in pieces if piece.strip()]
    return [(one, name_at(dialogue.known, one)) for one in sorted(filter(None, found))]


def shown_again(dialogue: Dialogue, words: Words, _: Iterable[acts.TeacherAct] = ()) -> Turn | None:
    """Watch one step again; None where none is named."""
    if _asks_between(dialogue) or dialogue.known.lesson is None or dialogue.busy:
        return None
    shows, again = _any("shows", dialogue.language), _any("once_more", dialogue.language)
    told = re.search(rf"\b(?:{shows})\s+(.+?)\s+(?:{again})\b", words.text, re.IGNORECASE)
    said = with_names(dialogue, told.group(1)).split() if told else []
    if said and said[0].lower() in hints("shows_itself", dialogue.language):
        return None
    # "You just the second step" begins with what belongs to the verb.
    rests = (
        bare(" ".join(said[at:]), dialogue.language) for at in range(min(len(said), MOST_LEAD))
    )
    index = next(filter(None, (find_whole(dialogue.known, rest) for rest in rests)), None)
    return wanted(dialogue, index) if index else None


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


def _beside(dialogue: Dialogue, text: str) -> Turn | None:
    """Add a step before or after another: "add a step before let go called wait"."""
    text = with_names(dialogue, text)
    hits = (pattern.match(text) for pattern in _besides(dialogue.language))
    found = next((hit for hit in hits if hit is not None), None)
    if found is None:
        return None
    where, name = found.group("where"), bare(found.group("name"), dialogue.language)
    if not name or not alike(bare(where, dialogue.language), names(dialogue.known.root)):
        return None
    after = found.group("after") is not None
    where = bare(where, dialogue.language)
    beside = {"after": where} if after else {"before": where}
    return edit(dialogue, acts.AddSubtask(name, **beside))


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
def _besides(language: str) -> tuple[re.Pattern[str], ...]:
    """Return patterns for a step whose name comes last, and for one whose name comes first."""
    place = rf"(?:(?P<after>{_any('after_step', language)})|(?:{_any('before_step', language)}))"
    begun = rf"{_leads(language)}(?:{_any('adds', language)})\s+"
    last = rf"(?:{_any('new_step_words', language)})\s+{place}\s+(?P<where>.+?)"
    last += rf"\s+(?:{_any('called', language)})\s+(?P<name>.+?)"
    soon = rf"{_new(language)}\s+{place}\s+(?P<where>.+?)"
    return tuple(
        re.compile(begun + told + _adds_end(language), re.IGNORECASE) for told in (last, soon)
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
