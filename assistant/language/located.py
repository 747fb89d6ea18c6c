"""Corrections of the motion, with where in the task they belong."""

from __future__ import annotations

from dataclasses import replace

from assistant.language.motion import read_motion
from assistant.language.naming import known_name
from assistant.language.parsing import (
    DOUBTFUL,
    GUESSED,
    LIKELY,
    SURE,
    Hearing,
    Parse,
    bared,
    texts_of,
)
from assistant.language.phrasebook import Phrase
from assistant.language.sentences import LONGEST_NAME, best_sentence
from assistant.language.step_places import (
    PARTLY,
    ends,
    is_weak,
    marks,
    only_begun,
    place_in,
    trust_in,
    unfinished,
    verb_in,
    without_noun,
)
from assistant.language.words import Words, said
from assistant.model.feedback import When
from assistant.model.teacher_acts import (
    AdjustSpeed,
    Gripper,
    Rotate,
    Translate,
    Where,
)


def correction(texts: Phrase, hearing: Hearing) -> Parse | None:
    """Return a correction of the motion with the confidence its unexplained words leave."""
    little = hearing.book.little
    if len(texts) > 25 or (texts and texts[0] in little["open_questions"]):
        return None
    reading = read_motion(texts, hearing.book, hearing.names)
    if reading is None or reading.unexplained > 2:
        return None
    empty = 0.004 * min(5, reading.empty)
    if reading.unexplained and (set(texts) & hearing.book.chat or texts[0] in little["stating"]):
        return None
    if reading.unexplained == 0 and (texts[0] in little["asking"] or reading.empty > 4):
        return Parse(reading.acts, GUESSED, "motion")
    return Parse(reading.acts, explained(reading.unexplained) - empty, "motion")


def explained(unexplained: int) -> float:
    """Return the confidence that unexplained words leave."""
    return SURE - 0.01 if unexplained == 0 else max(DOUBTFUL - 0.2 * (unexplained - 1), 0.2)


def located_correction(words: Words, hearing: Hearing) -> Parse | None:
    """Read "when you place it, a bit more left": a correction with where it belongs."""
    texts = texts_of(words)
    little, told = hearing.book.little, set(texts)
    if texts[0] in little["asking_why"] and not set(texts[1:2]) & little["conditional"]:
        return None
    returning = little["back"] & told and little["until"] & told
    if returning and texts[0] in little["going_back"]:
        return None
    stated = _stated(words, hearing)
    if stated is not None:
        return stated
    best: Parse | None = None
    for at, phrase, when in marks(texts, hearing.book):
        found = _marked(words, at, phrase, when, hearing)
        if found is not None and (best is None or found.score > best.score):
            best = found
    return best


def _marked(words: Words, at: int, phrase: Phrase, when: When, hearing: Hearing) -> Parse | None:
    """Read the place behind a mark and the correction around it."""
    start = at + len(phrase)
    before = () if only_begun(texts_of(words[:at]), hearing) else words[:at]
    best: Parse | None = None
    for end in ends(words, at, start, hearing):
        told = (*before, *words[end:])
        found = _joined(told, words[start:end], phrase, when, hearing)
        if found is not None and found.score >= LIKELY:
            return found
        if found is not None and (best is None or found.score > best.score):
            best = found
    return best


def acted_correction(words: Words, hearing: Hearing) -> Parse | None:
    """Read "grasp it a bit lower": a correction of the step the verb names."""
    texts = texts_of(words)
    things = {word for phrase in hearing.book.answer_words["pose_bodies"] for word in phrase}
    little = hearing.book.little
    size = 2 if set(texts[1:2]) & little["lately_named"] else 3
    thing = len(texts) > 2 and texts[1] in little["articles"] and texts[2] in things
    known = size == 2 or thing
    if texts[0] not in little["stepping"] or not known or len(texts) <= size:
        return None
    found = correction(texts[size:], hearing)
    if found is None or found.score < LIKELY:
        return None
    names = hearing.listening.subtasks
    step = known_name(texts[:1], names, hearing.book) or said(words[:size])
    return _at(found, Where(step), SURE)


def _stated(words: Words, hearing: Hearing) -> Parse | None:
    """Read "the approach is too fast": a correction of the step that is spoken of."""
    texts = texts_of(words)
    for at in range(1, min(len(texts) - 1, LONGEST_NAME)):
        if texts[at] not in hearing.book.little["step_states"]:
            continue
        names = hearing.listening.subtasks
        known = known_name(texts[:at], names, hearing.book)
        found = correction(texts[at:], hearing) if known else None
        if found is not None and found.score >= LIKELY:
            return _at(found, Where(str(known)), SURE - 0.02)
    return None


def _at(parse: Parse, spot: Where, score: float) -> Parse | None:
    """Return the corrections with where they belong; None if some cannot have a place."""
    acts = tuple(
        replace(act, where=spot)
        for act in parse.acts
        if isinstance(act, Translate | Rotate | AdjustSpeed | Gripper)
    )
    return Parse(acts, score) if len(acts) == len(parse.acts) else None


def _joined(
    told: Words, place: Words, phrase: Phrase, when: When, hearing: Hearing
) -> Parse | None:
    named = place_in(place, hearing)
    subject = without_noun(unfinished(named, hearing.book), hearing.book)
    if not subject or len(subject) > LONGEST_NAME:
        return None
    if not told or told[-1].text in hearing.book.little["left_hanging"]:
        return None
    texts = texts_of(subject)
    known = known_name(texts, hearing.listening.subtasks, hearing.book)
    trust = SURE if known else trust_in(texts, phrase, hearing, told=len(subject) < len(named))
    if is_weak(phrase, hearing.book) and trust < LIKELY and verb_in(place, hearing):
        trust = SURE
    if trust == 0.0:
        return None
    spot = Where(known or said(subject), when)
    best: Parse | None = None
    for bare in bared(told, hearing.book):
        parse = correction(texts_of(bare), hearing) or best_sentence(bare, hearing)
        if parse is None or parse.score < DOUBTFUL:
            continue
        score = trust if parse.score >= LIKELY else min(trust, PARTLY)
        found = _at(parse, spot, score)
        if found is not None and score >= LIKELY:
            return found
        best = best or found
    return best
