"""A second reading of a clause, learned from sentences: its act, and the words of its slots.

It shares with the grammar only the readers of numbers, of places and of how much; which act a
clause is and which words are its names it knows from sentences people said.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import Any, cast

from assistant.language.answers import LISTS
from assistant.language.edges import is_cut_short
from assistant.language.frames import frames
from assistant.language.likelihood import likelihoods
from assistant.language.motion import degree_of, factor_of
from assistant.language.parsing import Hearing, texts_of
from assistant.language.placed import posed
from assistant.language.repair import respelled
from assistant.language.runs import named_text
from assistant.language.step_places import unfinished
from assistant.language.tagging import TAKES, Tagged, chain, seconded, tagging, unparted
from assistant.language.traits import NO_TRAITS, word_traits
from assistant.language.words import OWNER, Words, said, told
from assistant.model.teacher_acts import ACTS, TeacherAct, Where

LEAST, MOST = 0.05, 4
"""Acts are looked for that are likelier, this many at most."""
_LEAST = 1e-6
_CLOSED = {
    "adjust_speed": "change",
    "adjust_last": "change",
    "gripper": "command",
    "show": "what",
    "go_back": "stage",
    "translate": "direction",
    "rotate": "direction",
    "move_cut": "direction",
}
_OWN = frozenset(("new", "name", "value", "object"))
_LISTS = frozenset(("subtasks",))


@dataclass(frozen=True, slots=True)
class Learned:
    """An act with the logarithms of how likely it is and of how likely its slots are."""

    act: TeacherAct
    label: str
    act_log: float
    slots_log: float


def learned(
    words: Words,
    hearing: Hearing,
    chances: Mapping[str, float] | None = None,
    also: Sequence[str] = (),
    most: int = MOST,
) -> list[Learned]:
    """Return the readings of a clause, likeliest acts first; none without a model.

    Parameters
    ----------
    chances : mapping, optional
        How likely each label is, where that is known already.
    also : sequence of str
        Labels to read the clause as though they be unlikely.
    """
    known = chain(hearing.language)
    if known is None or not words:
        return []
    spelled = respelled(words, hearing.book, hearing.listening.objects)
    if chances is None:
        told = texts_of(words), texts_of(spelled)
        chances = likelihoods(*told, hearing.listening, hearing.language)
    likely = sorted((label for label, p in chances.items() if p >= LEAST), key=chances.__getitem__)
    labels = dict.fromkeys((*likely[: -most - 1 : -1], *(one for one in also if one in chances)))
    kinds = [(label, kind) for label in labels for kind in kinds_of(label, hearing)]
    telling = any(TAKES.get(kind) for _, kind in kinds)
    traits = word_traits(spelled, hearing) if telling else NO_TRAITS
    seen = seconded(spelled, hearing.listening, hearing.language, known) if telling else None
    found: list[Learned] = []
    for label, kind in kinds:
        spread = tagging(traits, kind, known, seen)
        act = made(label, kind, spread.spans, words, spelled, hearing) if spread else None
        if spread is not None and act is not None:
            logs = (math.log(max(p, _LEAST)) for p in (chances[label], spread.probability))
            found.append(Learned(act, label, *logs))
    return found


def kinds_of(label: str, hearing: Hearing) -> Iterator[str]:
    """Return the kinds of act a label stands for, as their slots are told."""
    asked = hearing.listening.asked
    if label == "inform":
        if asked in LISTS:
            yield "inform many"
            return
        yield "inform"
        if asked == "subtask_name":
            yield "inform many"
    elif label in TAKES:
        yield label
    else:
        yield label.partition(" ")[0]


def made(
    label: str, kind: str, spans: Tagged, words: Words, spelled: Words, hearing: Hearing
) -> TeacherAct | None:
    """Return the act with its slots; None if one that it needs cannot be read."""
    name, _, closed = label.partition(" ")
    listed = kind == "inform many" and hearing.listening.asked == "subtask_name"
    if listed and unparted(spans, words, hearing.book.little["step_joints"]):
        return None
    slots: dict[str, Any] = {}
    if name in _CLOSED and closed not in ("factor", "at"):
        slots[_CLOSED[name]] = closed
    for slot, start, end in spans:
        if slot.startswith("where_"):
            when = cast("Any", slot.removeprefix("where_"))
            end = start + len(unfinished(words[start:end], hearing.book))
            slots["where"] = Where(_name(words, (start, end), hearing), when)
        elif slot in _LISTS:
            slots[slot] = (*slots.get(slot, ()), _name(words, (start, end), hearing))
        elif slot in _OWN:
            part = _bare(words[start:end], hearing)
            if hearing.listening.asked == "goal":
                text = told(_whole(part, words[:end], hearing))
            else:
                text = said(part).removesuffix(OWNER)
            slots[slot] = (*slots.get(slot, ()), text) if kind == "inform many" else text
        elif slot != "amount":
            slots[slot] = _name(words, (start, end), hearing)
    amount = next(((a, b) for slot, a, b in spans if slot == "amount"), None)
    filler = _FILLERS.get(name)
    if filler is not None and not filler(label, slots, amount, words, spelled, hearing):
        return None
    if name == "set_pose":
        return posed(str(slots.get("object", "")), spelled, hearing)
    if any(value in ("", ()) for value in slots.values()) or _told_twice(slots):
        return None
    try:
        return cast("Callable[..., TeacherAct]", ACTS[name])(**slots)
    except TypeError:
        return None


def _told_twice(slots: Mapping[str, Any]) -> bool:
    """Tell one name in two places, where another is meant: no step comes before itself."""
    pairs = (slots.get("first"), slots.get("second")), (slots.get("old"), slots.get("new"))
    return any(one is not None and one == other for one, other in pairs)


def _name(words: Words, span: tuple[int, int], hearing: Hearing) -> str:
    """Return the name a stretch tells: "it" behind a lone verb belongs to it, "let go of it"."""
    start, end = span
    lone = end - start == 1 and end + 1 < len(words) and not words[end].broken
    little = hearing.book.little
    if lone and words[end].text in little["pronoun"]:
        end += words[end + 1].text in little["behind_pronoun"]
    known = frames(hearing.language)
    if known is not None and is_cut_short(start, end, words, known):
        end += 1
    behind = texts_of(words[end : end + 2])
    if len(behind) == 2 and behind[0] in little["owned_by"] and behind[1] in little["pronoun"]:
        end += 2
    return named_text(words, (start, end), hearing).removesuffix(OWNER)


def _whole(part: Words, until: Words, hearing: Hearing) -> Words:
    """Return a goal with its article, which a sentence keeps and a name does not."""
    begun = len(until) - len(part)
    led = part and begun and until[-len(part) :] == part
    there = led and until[begun - 1].text in hearing.book.little["articles"]
    return until[begun - 1 :] if there else part


def _bare(words: Words, hearing: Hearing) -> Words:
    articles = hearing.book.little["answers_articles"]
    while len(words) > 1 and words[0].text in articles:
        words = words[1:]
    return words


_Slots = dict[str, Any]
_Span = tuple[int, int] | None


def _value(span: _Span, spelled: Words, hearing: Hearing) -> tuple[float, str] | None:
    if span is None:
        return None
    numbers = hearing.book.numbers
    marked = max(at for at in range(span[0] + 1) if at == 0 or spelled[at].broken)
    texts = texts_of(spelled[marked : span[1]])
    texts = texts[numbers.start(texts, span[0] - marked) :]
    quantity = numbers.quantity(texts, 0)
    if quantity is not None:
        return quantity.value, quantity.kind
    place = numbers.ordinal(texts, 0)
    if place is not None:
        return float(place[0]), ""
    unit = numbers.units.get(texts[0])
    behind = numbers.number(texts, 1) if unit else None
    return (behind[0], unit[0]) if behind and unit else None


def _moved(
    label: str, slots: _Slots, span: _Span, words: Words, spelled: Words, hearing: Hearing
) -> bool:
    found = _value(span, spelled, hearing)
    turning = label.startswith("rotate")
    if found is not None:
        value, kind = found
        if kind not in (("deg", "ratio", "") if turning else ("m",)):
            return False
        slots["angle_deg" if turning else "distance_m"] = float(f"{abs(value):.9g}")
        return True
    if span is not None:
        return False
    slots["degree"] = degree_of(_without_where(slots, spelled), hearing.book)
    return True


def _without_where(slots: _Slots, spelled: Words) -> tuple[str, ...]:
    where = slots.get("where")
    own = set(where.subtask.split()) if isinstance(where, Where) and where.subtask else set()
    return tuple(w.text for w in spelled if w.text not in own)


def _paced(
    label: str, slots: _Slots, span: _Span, words: Words, spelled: Words, hearing: Hearing
) -> bool:
    if label.endswith("factor"):
        texts = texts_of(spelled)
        slots["factor"] = factor_of(texts, hearing.book)
        if slots["factor"] is None:
            found = _value(span, spelled, hearing)
            slots["factor"] = found[0] if found else None
        return slots["factor"] is not None and slots["factor"] > 0
    slots["degree"] = degree_of(_without_where(slots, spelled), hearing.book)
    return True


def _last(
    label: str, slots: _Slots, span: _Span, words: Words, spelled: Words, hearing: Hearing
) -> bool:
    if label.endswith("factor"):
        found = _value(span, spelled, hearing)
        if found is None or found[1] not in ("", "ratio"):
            return False
        slots["factor"] = found[0]
    elif not label.endswith("opposite"):
        slots["degree"] = degree_of(texts_of(spelled), hearing.book)
    return True


def _counted(
    label: str, slots: _Slots, span: _Span, words: Words, spelled: Words, hearing: Hearing
) -> bool:
    kind = label.partition(" ")[0]
    if label in ("cue first", "cue next", "cue last"):
        slots["which"] = label.partition(" ")[2]
        return True
    if label == "inform" or (kind == "move_cut" and not label.endswith("at")):
        return True
    found = _value(span, spelled, hearing)
    if found is None:
        return False
    slot = {"cue": "which", "inform": "value", "assign": "episode", "move_cut": "at_s"}[kind]
    whole = slot != "at_s"
    if whole and found[0] != int(found[0]):
        return False
    slots[slot] = int(found[0]) if whole else found[0]
    return True


def _texted(
    label: str, slots: _Slots, span: _Span, words: Words, spelled: Words, hearing: Hearing
) -> bool:
    slots["text"] = said(words)
    return bool(slots["text"])


_FILLERS: Mapping[str, Callable[[str, _Slots, _Span, Words, Words, Hearing], bool]] = {
    "translate": _moved,
    "rotate": _moved,
    "adjust_speed": _paced,
    "adjust_last": _last,
    "cue": _counted,
    "inform": _counted,
    "assign": _counted,
    "move_cut": _counted,
    "explain": _texted,
    "key_state": _texted,
}
