"""Looks for an act that the model of likelihoods expects: its slots, by what the words hold.

Grammars ask that all words be explained; here the act is given and only its slots are wanted,
so that words nobody listed may stand between. What is found is as sure as the model is.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from functools import lru_cache
from typing import Any

from assistant.language.answers import OPEN, answer
from assistant.language.framing import framed_as
from assistant.language.likelihood import label, likelihoods
from assistant.language.motion import degree_of, factor_of, read_motion
from assistant.language.parsing import Hearing, Parse, texts_of
from assistant.language.poses import read_pose
from assistant.language.words import Words, said
from assistant.model.teacher_acts import (
    ACTS,
    AdjustLast,
    AdjustSpeed,
    Cue,
    Explain,
    KeyState,
    TeacherAct,
    act_to_json,
)

LEAST_LIKELY = 0.12
"""Acts the model gives less are not looked for."""
_PLAIN = frozenset(
    (
        "affirm",
        "deny",
        "start",
        "pause",
        "resume",
        "again",
        "approve",
        "undo",
        "redo",
        "repeat_line",
        "help",
        "new_setup",
        "be_brief",
        "be_thorough",
        "quit",
        "unknown",
        "save",
        "load",
        "compare",
    )
)
_STRUCTURE = frozenset(
    (
        "rename",
        "optional",
        "required",
        "unordered",
        "ordered",
        "add_subtask",
        "remove_subtask",
        "merge",
        "split",
        "move_cut",
        "assign",
        "save",
        "load",
        "compare",
    )
)
_SOUGHT = 0.5
Chances = Mapping[str, float]


def chances_of(said_words: Words, respelled: Words, hearing: Hearing) -> Chances:
    """Return how likely each label is for a line."""
    told = texts_of(said_words), texts_of(respelled)
    return likelihoods(*told, hearing.listening, hearing.language)


def chance(acts: tuple[TeacherAct, ...], chances: Chances) -> float:
    """Return how likely acts are: those of one line together."""
    return sum(chances.get(one, 0.0) for one in {label_of(act) for act in acts})


@lru_cache(maxsize=1024)
def label_of(act: TeacherAct) -> str:
    """Return the label of an act."""
    told = act_to_json(act)
    return label(told["act"], told)


def sought(words: Words, hearing: Hearing, chances: Chances) -> Iterator[tuple[Parse, float]]:
    """Yield readings of the likeliest acts, with how likely each is."""
    likely = sorted(((p, one) for one, p in chances.items() if p >= LEAST_LIKELY), reverse=True)
    for likelihood, one in likely[:3]:
        name, _, slot = one.partition(" ")
        parse = framed_as(name, words, hearing) if name in _STRUCTURE else None
        if parse is not None:
            yield parse, likelihood
            continue
        act = _filled(name, slot, words, hearing)
        if act is not None:
            yield Parse((act,), _SOUGHT, "sought"), likelihood


def _filled(name: str, slot: str, words: Words, hearing: Hearing) -> TeacherAct | None:
    if name in _PLAIN:
        return _made(name)
    filler = _FILLERS.get(name)
    return filler(slot, words, hearing) if filler else None


def _made(name: str, **slots: Any) -> TeacherAct:
    kind: Callable[..., TeacherAct] = ACTS[name]
    return kind(**slots)


def _motion(slot: str, words: Words, hearing: Hearing) -> TeacherAct | None:
    reading = read_motion(texts_of(words), hearing.book, hearing.names)
    return reading.acts[0] if reading is not None and len(reading.acts) == 1 else None


def _speed(slot: str, words: Words, hearing: Hearing) -> TeacherAct | None:
    texts = texts_of(words)
    if slot == "factor":
        factor = factor_of(texts, hearing.book)
        return None if factor is None else AdjustSpeed(factor=factor)
    change: Any = slot
    return AdjustSpeed(change=change, degree=degree_of(texts, hearing.book))


def _last(slot: str, words: Words, hearing: Hearing) -> TeacherAct | None:
    texts = texts_of(words)
    if slot == "factor":
        numbers = (hearing.book.numbers.quantity(texts, at) for at in range(len(texts)))
        found = next((one for one in numbers if one and one.kind in ("", "ratio")), None)
        return None if found is None else AdjustLast(factor=found.value)
    change: Any = slot
    degree = None if slot == "opposite" else degree_of(texts, hearing.book)
    return AdjustLast(change=change, degree=degree)


MARKS = {"first": Cue("first"), "next": Cue("next"), "last": Cue("last")}


def _cue(slot: str, words: Words, hearing: Hearing) -> TeacherAct | None:
    texts, numbers = texts_of(words), hearing.book.numbers
    if slot in MARKS:
        return MARKS[slot]
    for at in range(len(texts)):
        found = numbers.ordinal(texts, at) or numbers.number(texts, at)
        if found is not None:
            return Cue(int(found[0]))
    return None


def _fixed(name: str, slot_name: str) -> Callable[[str, Words, Hearing], TeacherAct | None]:
    return lambda slot, words, hearing: _made(name, **{slot_name: slot}) if slot else None


def _answered(slot: str, words: Words, hearing: Hearing) -> TeacherAct | None:
    asked = hearing.listening.asked
    return answer(words, asked, hearing.book) if asked in OPEN and asked else None


def _placed(slot: str, words: Words, hearing: Hearing) -> TeacherAct | None:
    texts = texts_of(words)
    found = read_pose(texts, [w.broken for w in words], hearing.listening, hearing.book)
    return None if found is None else found.act


_FILLERS: Mapping[str, Callable[[str, Words, Hearing], TeacherAct | None]] = {
    "translate": _motion,
    "rotate": _motion,
    "adjust_speed": _speed,
    "adjust_last": _last,
    "cue": _cue,
    "show": _fixed("show", "what"),
    "go_back": _fixed("go_back", "stage"),
    "gripper": _fixed("gripper", "command"),
    "explain": lambda slot, words, hearing: Explain(said(words)),
    "key_state": lambda slot, words, hearing: (
        KeyState(said(words)) if hearing.listening.stage == "demonstration" else None
    ),
    "inform": _answered,
    "set_pose": _placed,
}
