"""Understands one clause: whole sentences of the phrasebook, corrections, places, key states."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

from assistant.language.amounts import read_amount
from assistant.language.cues import counted_cue, surer
from assistant.language.frames import frames
from assistant.language.framing import framed
from assistant.language.kept import kept
from assistant.language.key_states import key_state
from assistant.language.located import (
    acted_correction,
    correction,
    explained,
    located_correction,
)
from assistant.language.parsing import (
    ACTING,
    LIKELY,
    SURE,
    Hearing,
    Parse,
    bared,
    texts_of,
    undressed,
)
from assistant.language.poses import read_pose
from assistant.language.sentences import best_sentence
from assistant.language.shifts import read_shift
from assistant.language.words import Words
from assistant.model.teacher_acts import (
    AddSubtask,
    AdjustLast,
    AdjustSpeed,
    Again,
    Assign,
    Compare,
    Explain,
    Gripper,
    KeyState,
    Load,
    Merge,
    MoveCut,
    Optional,
    Ordered,
    Pause,
    RemoveSubtask,
    Rename,
    Required,
    Rotate,
    Save,
    Split,
    Stop,
    Translate,
    Unordered,
)


def clause(words: Words, hearing: Hearing) -> Parse | None:
    """Return what a clause means as a whole; None if nothing explains it."""
    if words not in hearing.clauses:
        found = _clause(words, hearing)
        hearing.clauses[words] = surer(found, counted_cue(words, hearing))
    return hearing.clauses[words]


def _clause(words: Words, hearing: Hearing) -> Parse | None:
    best: Parse | None = None
    for bare in bared(words, hearing.book):
        for parse in _readings(bare, hearing):
            # Of two equal readings the one without courtesies in its names is right.
            same = best is not None and type(best.acts[0]) is type(parse.acts[0])
            same = same and not isinstance(parse.acts[0], KeyState | Explain | Save)
            if best is None or parse.score > best.score or (same and parse.score == best.score):
                best = parse
        if best is not None and best.score >= SURE - 0.01:
            return best
    if best is not None and best.how == "sentence" and ACTING <= best.score < SURE - 0.01:
        best = _seconded(best, words, hearing)
    if best is None or best.score < ACTING:
        others = (kept(words, hearing), framed(words, hearing), _requested(words, hearing))
        best = max((best, *others), key=lambda parse: parse.score if parse else 0.0)
    if best is None or best.score < ACTING:
        told = _reasoned(words, hearing)
        best = told if told is not None and (best is None or told.score > best.score) else best
    return best


def _reasoned(words: Words, hearing: Hearing) -> Parse | None:
    """Return the correction that is asked for before a reason: "left so that I can see it"."""
    known = frames(hearing.language)
    reasons = known.little.get("reasons", frozenset()) if known else frozenset()
    texts = texts_of(words)
    for at in range(2, len(words) - 1):
        if any(" ".join(texts[at : at + size]) in reasons for size in (1, 2, 3)):
            found = clause(words[:at], hearing)
            asked = found is not None and isinstance(found.acts[0], _ASKED_FOR)
            if found is not None and asked and found.score >= LIKELY:
                return Parse(found.acts, found.score - 0.04, found.how)
    return None


_ASKED_FOR = (Translate, Rotate, AdjustSpeed, AdjustLast, Gripper, Again, Pause)


_NAMING = (AddSubtask, Assign, Merge, MoveCut, Optional, Ordered, RemoveSubtask, Rename)
_NAMED = (*_NAMING, Required, Split, Unordered, Save, Load, Compare)


def _seconded(best: Parse, words: Words, hearing: Hearing) -> Parse:
    """Trust names told by a sentence less where the frames read others."""
    if len(best.acts) > 1 or not isinstance(best.acts[0], _NAMED):
        return best
    told = framed(words, hearing)
    if told is not None and told.acts == best.acts:
        return best
    return Parse(best.acts, 0.8, "unseconded")


def _requested(words: Words, hearing: Hearing) -> Parse | None:
    """Return what a request asks for that is worded as no sentence of the phrasebook is."""
    for bare in undressed(words, hearing.book):
        found = max(_readings(bare, hearing), key=lambda parse: parse.score, default=None)
        if found is not None and found.score >= LIKELY and found.acts != (Stop(),):
            return Parse(found.acts, 0.8, "request")
    return None


_RENAMING = (AddSubtask, RemoveSubtask, Rename)


def _readings(words: Words, hearing: Hearing) -> Iterator[Parse]:
    sentence = best_sentence(words, hearing)
    if sentence is not None:
        yield sentence
        if sentence.score >= SURE:
            return
    located = located_correction(words, hearing)
    placed = located is not None and located.score >= LIKELY
    named = sentence is not None and isinstance(sentence.acts[0], _RENAMING)
    if named and not placed:
        return
    acted = None if named else acted_correction(words, hearing)
    if acted is not None:
        yield acted
    if located is not None:
        yield replace(located, score=SURE - 0.01) if named else located
    if placed or (sentence is not None and sentence.score >= LIKELY):
        return
    texts = texts_of(words)
    pose = read_pose(texts, [w.broken for w in words], hearing.listening, hearing.book)
    if pose is not None:
        yield Parse((pose.act,), explained(pose.unexplained) + 0.01)
    shift = read_shift(texts, hearing.listening, hearing.book)
    if shift is not None:
        yield Parse((shift.act,), explained(shift.unexplained) + 0.01)
        return
    leading = texts[0] == "right" and len(words) > 2 and words[1].broken
    moved = None if leading else correction(texts, hearing)
    if moved is not None:
        yield moved
    amount = read_amount(texts, hearing.book) if moved is None and pose is None else None
    if amount is not None:
        yield Parse((amount.act,), explained(amount.unexplained), "motion")
    state = key_state(words, hearing)
    if state is not None:
        yield state
