"""Corrections of the motion, with where in the task they belong, and key states."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from assistant.language.motion import read_motion
from assistant.language.naming import known_name, without_article
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
from assistant.language.words import Words, said
from assistant.model.feedback import When
from assistant.model.teacher_acts import (
    AdjustSpeed,
    Cue,
    Gripper,
    KeyState,
    Rotate,
    Translate,
    Where,
)

_ASKING = frozenset(("is", "are", "was", "do", "does", "did", "has", "have"))
_ASKING_WHY = frozenset(("what", "why", "how", "who", "where", "which"))
_STATING = frozenset(
    [
        "there",
        "i",
        "my",
        "he",
        "she",
        "they",
        "we",
        "is",
        "are",
        "do",
        "does",
        "did",
        "have",
        "has",
        "his",
        "her",
        "our",
    ]
)


def correction(texts: Phrase, hearing: Hearing) -> Parse | None:
    """Return a correction of the motion with the confidence its unexplained words leave."""
    if len(texts) > 25 or (texts and texts[0] in ("what", "why", "how", "who", "where")):
        return None
    reading = read_motion(texts, hearing.book, hearing.names)
    if reading is None or reading.unexplained > 2:
        return None
    empty = 0.004 * min(5, reading.empty)
    if reading.unexplained and (set(texts) & hearing.book.chat or texts[0] in _STATING):
        return None
    if reading.unexplained == 0 and (texts[0] in _ASKING or reading.empty > 4):
        return Parse(reading.acts, GUESSED, "motion")
    return Parse(reading.acts, explained(reading.unexplained) - empty, "motion")


def explained(unexplained: int) -> float:
    """Return the confidence that unexplained words leave."""
    return SURE - 0.01 if unexplained == 0 else max(DOUBTFUL - 0.2 * (unexplained - 1), 0.2)


def located_correction(words: Words, hearing: Hearing) -> Parse | None:
    """Read "when you place it, a bit more left": a correction with where it belongs."""
    texts = texts_of(words)
    if texts[0] in _ASKING_WHY and texts[1:2] not in (("if",), ("about",)):
        return None
    where = hearing.book.where
    returning = {"back"} & set(texts) and {"when", "before", "until"} & set(texts)
    if returning and texts[0] in ("go", "back", "return", "get", "take"):
        return None
    stated = _stated(words, hearing)
    if stated is not None:
        return stated
    whens: tuple[When, ...] = ("before", "after", "during")
    for when in whens:
        for phrase in where[when]:
            size = len(phrase)
            if texts[:size] == phrase:
                found = _front(words, size, when, hearing)
                if found is not None:
                    return found
            for at in range(1, len(texts) - size):
                if texts[at : at + size] == phrase:
                    found = _joined(words[:at], words[at + size :], phrase, when, hearing)
                    if found is not None:
                        return found
    return None


def acted_correction(words: Words, hearing: Hearing) -> Parse | None:
    """Read "grasp it a bit lower": a correction of the step the verb names."""
    texts = texts_of(words)
    things = {word for phrase in hearing.book.answer_words["pose_bodies"] for word in phrase}
    size = 2 if texts[1:2] in (("it",), ("that",)) else 3
    known = size == 2 or (len(texts) > 2 and texts[1] in ("the", "a") and texts[2] in things)
    if texts[0] not in _STEPPING or not known or len(texts) <= size:
        return None
    found = correction(texts[size:], hearing)
    if found is None or found.score < LIKELY:
        return None
    names = hearing.listening.subtasks
    step = known_name(texts[:1], names, hearing.book.numbers) or said(words[:size])
    return _at(found, Where(step), SURE)


_STEPPING = frozenset(("grasp", "grab", "approach", "release", "pick"))


def _stated(words: Words, hearing: Hearing) -> Parse | None:
    """Read "the approach is too fast": a correction of the step that is spoken of."""
    texts = texts_of(words)
    for at in range(1, min(len(texts) - 1, LONGEST_NAME)):
        if texts[at] not in ("is", "was", "needs", "should", "must", "goes", "went"):
            continue
        names = hearing.listening.subtasks
        known = known_name(texts[:at], names, hearing.book.numbers)
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


def _front(words: Words, size: int, when: When, hearing: Hearing) -> Parse | None:
    breaks = [at for at in range(size + 1, len(words)) if words[at].broken]
    free = sorted(range(size + 1, len(words)), key=lambda at: (at - 1 in _parted(words), at))
    for at in breaks or free:
        loose = words[at].text in ("it", "the", "a", "an", "that", "and", "to")
        stated = words[at].text in ("it", "that") and texts_of(words)[at + 1 : at + 2] in _STATED
        if loose and not words[at].broken and not stated:
            continue
        found = _joined(words[at:], words[size:at], texts_of(words[:size]), when, hearing)
        if found is not None:
            return found
    return None


def _parted(words: Words) -> frozenset[int]:
    """Return where words in -ing stand whose particle follows: "putting | down"."""
    return frozenset(
        at
        for at in range(len(words) - 1)
        if words[at].text.endswith("ing") and words[at + 1].text in _PARTICLES
    )


_STATED = (("should",), ("needs",), ("must",), ("has",), ("is",), ("could",), ("ought",))
_NO_STEPS = frozenset(("something", "anything", "nothing", "everything", "thing", "ring", "string"))
_PARTICLES = frozenset(("up", "down", "in", "out", "on", "off", "over", "away", "back", "aside"))


def _joined(
    told: Words, place: Words, phrase: Phrase, when: When, hearing: Hearing
) -> Parse | None:
    subject, where = _place(place, hearing), hearing.book.where
    weak = phrase in _WEAK
    if not subject or len(subject) > LONGEST_NAME:
        return None
    if not told or told[-1].text in ("to", "of", "by", "and", "from"):
        return None
    texts = texts_of(subject)
    if texts in ((("you",), ("i",), ("we",), ("the",))):
        return None
    if any(text in hearing.book.chat for text in texts):
        return None
    known = known_name(texts, hearing.listening.subtasks, hearing.book.numbers)
    listed = without_article(texts) in where["stepping"]
    told_step = listed or any(t.endswith("ing") and t not in _NO_STEPS for t in texts)
    vague = weak and known is None and phrase != ("once",) and not told_step
    if vague or _is_amount(texts, hearing):
        return None
    for bare in bared(told, hearing.book):
        parse = correction(texts_of(bare), hearing) or best_sentence(bare, hearing)
        if parse is None or parse.score < LIKELY:
            continue
        found = _at(
            parse, Where(known or said(subject), when), SURE if known or listed else LIKELY + 0.01
        )
        if found is not None:
            return found
    return None


_WEAK = frozenset(
    (("at",), ("in",), ("for",), ("as",), ("once",), ("following",), ("on",), ("upon",))
)


def _is_amount(texts: Phrase, hearing: Hearing) -> bool:
    return all(text in ("it", "that", "this", "once", "least", "all", "now") for text in texts)


def _place(words: Words, hearing: Hearing) -> Words:
    """Take the subject off "you place it", and the article off "the grasp"."""
    texts = texts_of(words)
    for phrase in hearing.book.where["subject"]:
        if len(phrase) < len(words) and texts[: len(phrase)] == phrase:
            return _place(words[len(phrase) :], hearing)
    return words


def key_state(words: Words, hearing: Hearing) -> Parse | None:
    """Read what a teacher who demonstrates calls attention to."""
    if hearing.listening.stage != "demonstration" or _cued_behind(words, hearing):
        return None
    lists = hearing.book.answer_words
    marked, words_before = False, words
    while (cut := _marker(words, lists["key_markers"])) and len(words) > cut:
        words, marked = words[cut:], True
    texts = texts_of(words)
    nouns = {word for phrase in lists["key_nouns"] for word in phrase} | hearing.names
    verbs = {word for phrase in lists["key_verbs"] for word in phrase}
    weak = {"it", "they", "both", "is", "are", "was", "got", "does", "no"}
    strong = (set(texts) & (nouns | verbs)) - weak
    concerned = bool(set(texts) & nouns and set(texts) & verbs and strong)
    concerned = concerned or (_stated_now(texts) and bool(set(texts) & verbs - weak))
    callings = {word for phrase in lists["key_calling"] for word in phrase}
    calling = bool(words_before) and words_before[0].text in callings
    concerned = concerned or (calling and bool(set(texts) & verbs - weak) and len(texts) > 3)
    if set(texts) & hearing.book.chat and not (_stated_now(texts) and strong):
        return None
    asking = texts and texts[0] in ("what", "why", "how", "who", "where", "do", "can", "are")
    if not concerned or asking or len(texts) < 3:
        return None
    if texts[0] in ("i", "we", "my", "they", "he", "she") and not marked:
        return Parse((KeyState(said(words)),), DOUBTFUL)
    return Parse((KeyState(said(words)),), LIKELY if marked else LIKELY - 0.03)


def _cued_behind(words: Words, hearing: Hearing) -> bool:
    """Tell whether the last clause is a cue: "the cup is full now, next step"."""
    last = max((at for at in range(1, len(words)) if words[at].broken), default=0)
    told = best_sentence(words[last:], hearing) if last else None
    return told is not None and isinstance(told.acts[0], Cue)


def _stated_now(texts: Phrase) -> bool:
    """Tell "the can is gripped now", whatever the can is."""
    stating = {"is", "are", "has", "have", "sits", "lies", "stands", "hangs", "rests"}
    at = next((n for n, text in enumerate(texts) if text in stating), 0)
    talk = {"i", "you", "we", "he", "she", "they", "my", "that", "this", "what", "there", "step"}
    return 0 < at <= 4 and not set(texts[:at]) & talk and texts[-1] == "now"


def _marker(words: Words, markers: Sequence[Phrase]) -> int:
    texts = texts_of(words)
    return next((len(phrase) for phrase in markers if texts[: len(phrase)] == phrase), 0)
