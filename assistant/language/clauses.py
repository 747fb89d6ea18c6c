"""Understands one clause: whole sentences of the phrasebook, corrections, places, key states."""

from __future__ import annotations

from collections.abc import Iterator

from assistant.language.frames import framed
from assistant.language.located import correction, explained, key_state, located_correction
from assistant.language.parsing import LIKELY, SURE, Hearing, Parse, bared, texts_of
from assistant.language.poses import read_pose
from assistant.language.sentences import best_sentence
from assistant.language.words import Words
from assistant.model.teacher_acts import Explain, KeyState, Save


def clause(words: Words, hearing: Hearing) -> Parse | None:
    """Return what a clause means as a whole; None if nothing explains it."""
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
    if best is None or best.score < LIKELY:
        told = framed(words, hearing)
        if told is not None and (best is None or told.score > best.score):
            return told
    return best


def _readings(words: Words, hearing: Hearing) -> Iterator[Parse]:
    sentence = best_sentence(words, hearing)
    if sentence is not None:
        yield sentence
        if sentence.score >= SURE:
            return
    located = located_correction(words, hearing)
    if located is not None:
        yield located
    if sentence is not None and sentence.score >= LIKELY:
        return
    texts = texts_of(words)
    pose = read_pose(texts, [w.broken for w in words], hearing.listening, hearing.book)
    if pose is not None:
        yield Parse((pose.act,), explained(pose.unexplained) + 0.01)
    moved = correction(texts, hearing)
    if moved is not None:
        yield moved
    state = key_state(words, hearing)
    if state is not None:
        yield state
