"""Corrections of the motion, with where in the task they belong."""

from __future__ import annotations

from collections.abc import Iterator
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
from assistant.language.phrasebook import Phrase, Phrasebook
from assistant.language.sentences import LONGEST_NAME, best_sentence
from assistant.language.tags import WAYS, tags_of
from assistant.language.words import Words, said
from assistant.model.feedback import When
from assistant.model.teacher_acts import (
    AdjustSpeed,
    Gripper,
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
    returning = {"back"} & set(texts) and {"when", "before", "until"} & set(texts)
    if returning and texts[0] in ("go", "back", "return", "get", "take"):
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


def marks(texts: Phrase, book: Phrasebook) -> Iterator[tuple[int, Phrase, When]]:
    """Yield where words stand that say when: the longest phrase of each place."""
    for at in range(len(texts) - 1):
        begun = book.whens.get(texts[at], ())
        found = [one for one in begun if texts[at : at + len(one[0])] == one[0]]
        longest = max((len(phrase) for phrase, _ in found), default=0)
        yield from ((at, phrase, when) for phrase, when in found if len(phrase) == longest)


def _marked(words: Words, at: int, phrase: Phrase, when: When, hearing: Hearing) -> Parse | None:
    """Read the place behind a mark and the correction around it."""
    start = at + len(phrase)
    before = () if _only_begun(texts_of(words[:at]), hearing) else words[:at]
    best: Parse | None = None
    for end in _ends(words, at, start, hearing):
        told = (*before, *words[end:])
        found = _joined(told, words[start:end], phrase, when, hearing)
        if found is not None and found.score >= LIKELY:
            return found
        if found is not None and (best is None or found.score > best.score):
            best = found
    return best


def _only_begun(texts: Phrase, hearing: Hearing) -> bool:
    """Tell a place that is begun and not told: "when you, during the approach, slower"."""
    begun = hearing.book.whens.get(texts[0], ()) if texts else ()
    return any(
        texts[: len(phrase)] == phrase and set(texts[len(phrase) :]) <= hearing.book.stuttered
        for phrase, _ in begun
    )


def _ends(words: Words, at: int, start: int, hearing: Hearing) -> Iterator[int]:
    """Yield where a place that begins at `start` may end, the likeliest first."""
    breaks = [end for end in range(start + 1, len(words)) if words[end].broken]
    if at:
        yield from (len(words), *breaks)
        return
    yield from breaks
    if breaks:
        return
    parted = _parted(words, hearing)
    last = len(words) - 1
    for end in sorted(range(start + 1, len(words)), key=lambda one: (one in parted, one)):
        if end == last and end in parted:
            continue
        loose = words[end].text in ("it", "the", "a", "an", "that", "and", "to")
        stated = words[end].text in ("it", "that") and texts_of(words)[end + 1 : end + 2] in _STATED
        if stated or not loose:
            yield end


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


def _parted(words: Words, hearing: Hearing) -> frozenset[int]:
    """Return where particles stand that belong to the verb before: "putting | down"."""
    motion = hearing.book.motion
    kinds = [motion.get((word.text,), "") for word in words]
    parted = set()
    for at in range(1, len(words)):
        particle = words[at].text in _PARTICLES
        only_way = kinds[at] in WAYS and not any(kind in WAYS for kind in kinds[at + 1 :])
        if particle and (words[at - 1].text.endswith("ing") or not only_way):
            parted.add(at)
    return frozenset(parted)


_STATED = (("should",), ("needs",), ("must",), ("has",), ("is",), ("could",), ("ought",))
_NO_STEPS = frozenset(
    ("liking", "something", "anything", "nothing", "everything", "thing", "ring", "string")
)
_PARTICLES = frozenset(("up", "down", "in", "out", "on", "off", "over", "away", "back", "aside"))


def _joined(
    told: Words, place: Words, phrase: Phrase, when: When, hearing: Hearing
) -> Parse | None:
    subject = _without_noun(_place(place, hearing))
    if not subject or len(subject) > LONGEST_NAME:
        return None
    if not told or told[-1].text in ("to", "of", "by", "and", "from"):
        return None
    texts = texts_of(subject)
    known = known_name(texts, hearing.listening.subtasks, hearing.book.numbers)
    trust = SURE if known else _trust(texts, phrase, hearing)
    if trust == 0.0:
        return None
    spot = Where(known or said(subject), when)
    best: Parse | None = None
    for bare in bared(told, hearing.book):
        parse = correction(texts_of(bare), hearing) or best_sentence(bare, hearing)
        if parse is None or parse.score < DOUBTFUL:
            continue
        score = trust if parse.score >= LIKELY else min(trust, _PARTLY)
        found = _at(parse, spot, score)
        if found is not None and score >= LIKELY:
            return found
        best = best or found
    return best


def _trust(texts: Phrase, phrase: Phrase, hearing: Hearing) -> float:
    """Return how sure it is that words no task knows name a step; 0 if they cannot."""
    book = hearing.book
    if texts in (("you",), ("i",), ("we",), ("the",)) or any(t in book.chat for t in texts):
        return 0.0
    if any(texts[: len(one)] == one for one, _ in book.whens.get(texts[0], ())):
        return 0.0
    if _is_amount(texts) or _moving(texts, hearing):
        return 0.0
    listed = without_article(texts) in book.where["stepping"]
    told_step = listed or any(t.endswith("ing") and t not in _NO_STEPS for t in texts)
    if phrase in _WEAK and phrase != ("once",) and not told_step:
        odd = [t for t in texts if (t,) not in book.motion and t not in book.empty]
        bodies = {word for one in book.answer_words["pose_bodies"] for word in one} | hearing.names
        named = odd and not bodies & set(texts) and not set(odd) & _NO_PLACES
        own = texts[0] in ("my", "your", "to", "an")
        return _PARTLY if named and not own and len(texts) <= _SHORT else 0.0
    return SURE if listed else LIKELY + 0.01


def _moving(texts: Phrase, hearing: Hearing) -> bool:
    """Tell words that tell how far or how fast, which no place does."""
    tags = tags_of(texts, hearing.book, frozenset())
    return any(tag.kind in _NO_PLACE_KINDS for tag in tags)


def _without_noun(words: Words) -> Words:
    """Take the noun off "the pick it up step"."""
    return words[:-1] if len(words) > 1 and words[-1].text in _STEP_NOUNS else words


_PARTLY = 0.78
_SHORT = 3
_STEP_NOUNS = frozenset(("step", "part", "phase", "stage", "bit", "subtask"))
_NO_PLACE_KINDS = frozenset(
    ("quantity", "little", "much", "faster", "slower", "speed", "too", "enough")
)
_NO_PLACES = frozenset(
    ["total", "least", "once", "average", "front", "sure", "fact", "time", "i", "he", "she", "they",
     "what", "which", "who", "air", "table", "floor", "top", "bottom", "middle", "half", "general",
     "particular", "case", "future", "first", "last", "next", "goodness", "sake", "god", "mind"]
)  # fmt: skip
_WEAK = frozenset(
    (("at",), ("in",), ("for",), ("as",), ("once",), ("following",), ("on",), ("upon",))
)


def _is_amount(texts: Phrase) -> bool:
    return all(text in ("it", "that", "this", "once", "least", "all", "now") for text in texts)


def _place(words: Words, hearing: Hearing) -> Words:
    """Take the subject off "you place it", and the article off "the grasp"."""
    texts = texts_of(words)
    for phrase in hearing.book.where["subject"]:
        if len(phrase) < len(words) and texts[: len(phrase)] == phrase:
            return _place(words[len(phrase) :], hearing)
    return words
