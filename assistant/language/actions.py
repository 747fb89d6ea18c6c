"""What action a teacher's words tell of: "approach the block", "close the hand" (paper II-A).

Names of primitives often imply their action; `Reading.sure` says whether the robot may take
it as told (and read it back) or has to ask.
"""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

from assistant.language.hints import hints, mentions, phrase_pattern
from assistant.language.slips import without_slips
from assistant.model.task import Action, TaskObject

_TO_TARGET = (("hand", "open"), ("move", "down"), ("move", "to"))


@dataclass(frozen=True, slots=True)
class Reading:
    """What was found in some words.

    Parameters
    ----------
    action : Action or None
    sure : bool
        Whether the words name one plain motion and nothing that is usually several.
    mentioned : tuple of str
        Names of known objects, in the order said.
    """

    action: Action | None
    sure: bool
    mentioned: tuple[str, ...] = ()


def read_action(text: str, objects: Sequence[TaskObject], language: str = "english") -> Reading:
    """Return the action that some words tell of.

    Parameters
    ----------
    text : str
        A name ("grasp block") or an answer ("close the hand").
    objects : sequence of TaskObject
        Those the task is about; "object" and "target" stand for the only one of their role.
    """
    text = without_slips(text, [one.name for one in objects], language)
    mentioned = mentioned_objects(text, objects, language)
    plain = _best(text, hints("actions", language))
    guess = _best(text, hints("guesses", language))
    entry = plain if plain is not None and (guess is None or _first(plain, guess)) else guess
    if entry is None:
        return Reading(None, False, mentioned)
    verb, way = entry[1]["verb"], entry[1]["way"]
    there = _led_to(text, mentioned, objects, language) if (verb, way) in _TO_TARGET else None
    action = Action(verb, way, there or _concerned(verb, way, mentioned, objects))
    return Reading(action, entry is plain and not _is_compound(text, language), mentioned)


def mentioned_objects(
    text: str, objects: Sequence[TaskObject], language: str = "english"
) -> tuple[str, ...]:
    """Return the names of the objects a text mentions, in the order said."""
    names = [word for one in objects for word in called_things(one.name, language)]
    lowered = without_slips(text, names, language).lower()
    found: dict[str, int] = {}
    called = [(word, one) for one in objects for word in called_things(one.name, language)]
    for word, known in sorted(called, key=lambda pair: -len(pair[0])):
        hit = phrase_pattern(word).search(lowered)
        if hit and known.name not in found:
            found[known.name] = hit.start()
            # A longer name takes its words away, so that "blue block" is not also "block".
            lowered = lowered[: hit.start()] + "#" * len(hit.group()) + lowered[hit.end() :]
    for word, name in _telling_apart([one.name for one in objects]).items():
        hit = phrase_pattern(word).search(lowered)
        if hit and name not in found:
            found[name] = hit.start()
    for role, generic in hints("generic", language).items():
        alike = [known.name for known in objects if known.role == role]
        hits = [phrase_pattern(word).search(lowered) for word in generic]
        starts = [hit.start() for hit in hits if hit]
        if len(alike) == 1 and starts and alike[0] not in found:
            found[alike[0]] = min(starts)
    return tuple(sorted(found, key=lambda name: found[name]))


def _telling_apart(names: Sequence[str]) -> dict[str, str]:
    """Return other words that mean one thing: "red" is the red of two blocks, "box" the blue box.

    What a thing is comes last in its name.
    """
    heads = [name.lower().split()[-1] for name in names if name]
    sole = {name.lower().split()[-1]: name for name in names if len(name.split()) > 1}
    sole = {head: name for head, name in sole.items() if heads.count(head) == 1}
    told = {
        name: name.lower().split()[:-1]
        for name in names
        if name and heads.count(name.lower().split()[-1]) > 1
    }
    every = [word for words in told.values() for word in words]
    apart = {word: name for name, words in told.items() for word in words if every.count(word) == 1}
    return {**sole, **apart}


def called_things(name: str, language: str = "english") -> tuple[str, ...]:
    """Return the words a thing may be called by: its own name, and what teachers say for it."""
    told: dict[str, list[str]] = hints("things", language)
    return (name.lower(), *(word.lower() for word in told.get(name.lower(), ())))


def role_of(name: str, language: str = "english") -> str:
    """Return ``target`` for names such as "plate" or "drop zone", else ``object``."""
    return "target" if mentions(name, hints("targets", language)) else "object"


def _is_compound(text: str, language: str) -> bool:
    start = text.lower().strip()
    hits = (phrase_pattern(phrase).match(start) for phrase in hints("compound", language))
    bare = (hit for hit in hits if hit)
    # "open" alone names several things; "open the hand" does not.
    return any(not _is_hand(start, hit.group()) for hit in bare)


def _is_hand(text: str, verb: str) -> bool:
    return verb in ("open", "close") and text != verb


def _best(
    text: str, entries: list[dict[str, Any]]
) -> tuple[tuple[int, int], dict[str, Any]] | None:
    lowered = text.lower()
    found: list[tuple[tuple[int, int], dict[str, Any]]] = []
    for entry in entries:
        for phrase in entry["phrases"]:
            hit = phrase_pattern(phrase).search(lowered)
            if hit:
                found.append(((hit.start(), -len(phrase.replace("...", "").split())), entry))
    return min(found, key=lambda one: one[0], default=None)


def _first(one: tuple[tuple[int, int], Any], other: tuple[tuple[int, int], Any]) -> bool:
    return one[0] <= other[0]


def _led_to(
    text: str, mentioned: Sequence[str], objects: Sequence[TaskObject], language: str
) -> str | None:
    """Return the thing a text says to go to: "down to the red block", whatever its role."""
    to, articles = (
        "|".join(map(re.escape, hints(part, language))) for part in ("to_words", "articles")
    )
    apart = _telling_apart([one.name for one in objects])
    roles: dict[str, str] = {one.name: one.role for one in objects}
    generic: dict[str, list[str]] = hints("generic", language)
    for name in reversed(mentioned):
        own = [word for word, known in apart.items() if known == name]
        own += generic.get(roles[name], [])
        called = "|".join(map(re.escape, (*called_things(name, language), *own)))
        led = rf"\b(?:{to})\s+(?:(?:{articles})\s+)*(?:{called})\b"
        if re.search(led, text, re.IGNORECASE):
            return name
    return None


def _concerned(
    verb: str, way: str, mentioned: Sequence[str], objects: Sequence[TaskObject]
) -> str | None:
    """Return the object or target an action concerns: where it goes, or what it takes."""
    roles = {known.name: known.role for known in objects}
    to_target = (verb, way) in _TO_TARGET
    if to_target:
        if len(mentioned) > 1:
            return mentioned[-1]
        alone = [name for name, role in roles.items() if role == "target"]
        if verb == "hand" and len(alone) == 1:
            return alone[0]
        # "Carry it over" and "lower the cup" go to where things are put.
        if mentioned and roles[mentioned[0]] == "object" and len(alone) == 1:
            return alone[0]
    if mentioned:
        return mentioned[0]
    carried = [name for name, role in roles.items() if role == "object"]
    return carried[0] if len(carried) == 1 and not to_target else None
