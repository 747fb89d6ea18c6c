"""Bodies that stand elsewhere than before: "the jug has shifted 8 cm forward".

A body that is said to be somewhere, or that somebody moved, is a new place of it; what the
hand should do is a correction, and so is whatever "should" be or is "too" far.
"""

from __future__ import annotations

from collections.abc import Sequence
from functools import lru_cache

from assistant.language.naming import without_article
from assistant.language.phrasebook import Phrase, Phrasebook
from assistant.language.poses import PoseReading, body_like, displacement
from assistant.language.tags import WAYS, tags_of
from assistant.language.words import OWNER
from assistant.model.listening import Listening
from assistant.model.teacher_acts import SetPose

LONGEST_BODY = 3
_ENDS_NAME = frozenset(("too", "enough", "faster", "slower"))


def read_shift(words: Sequence[str], listening: Listening, book: Phrasebook) -> PoseReading | None:
    """Return by how much a body is told to stand elsewhere; None if nothing of the kind."""
    if "pose_shifted" not in book.answer_words or len(words) < _FEWEST:
        return None
    words = _parted(words, book)
    told = _told(book, "shifted") | _told(book, "resting")
    scene = bool(_told(book, "scene") & set(words))
    if not told & set(words) and not scene:
        return None
    if _told(book, "wanting") & set(words) and not scene:
        return None
    by = displacement(words, book)
    if by is None or any(tag.kind in _ENDS_NAME for tag in tags_of(words, book, frozenset())):
        return None
    body = _fronted(words, book) or _pushed(words, book, scene=scene)
    if body is None:
        return None
    name = body_like(" ".join(body), listening)
    return PoseReading(SetPose(name, None, None, by), _left(words, body, book))


_FEWEST = 4


def _parted(words: Sequence[str], book: Phrasebook) -> Sequence[str]:
    """Return the words with "plate's" near the front as "plate is"."""
    at = next((at for at, word in enumerate(words[:LONGEST_BODY]) if word.endswith(OWNER)), -1)
    if at < 0:
        return words
    return (*words[:at], words[at].removesuffix(OWNER), *book.little["is"], *words[at + 1 :])


@lru_cache(maxsize=64)
def _told(book: Phrasebook, name: str) -> frozenset[str]:
    return frozenset(phrase[0] for phrase in book.answer_words.get(f"pose_{name}", ()))


def _fronted(words: Sequence[str], book: Phrasebook) -> Phrase | None:
    """Return the body of "the jug has shifted ..." and "the jug, I pushed it ..."."""
    verbs = _told(book, "resting") | _told(book, "shifted") | _told(book, "agents")
    verbs |= book.little["shifted"]
    end = next((at for at, word in enumerate(words) if word in verbs), 0)
    return _body(words[:end], book)


def _pushed(words: Sequence[str], book: Phrasebook, *, scene: bool) -> Phrase | None:
    """Return the body of "somebody has pushed the pot ...", up to where it is told how far."""
    shifting = _told(book, "shifted") | (_told(book, "shifting") if scene else frozenset())
    verb = next((at for at, word in enumerate(words[:_REACH]) if word in shifting), -1)
    agents = {word for word in words[:verb] if word in _told(book, "agents")} if verb > 0 else ()
    if verb < 0 or (not agents and not scene):
        return None
    end = verb + 1
    while end < len(words) and not _amount(words, end, book):
        end += 1
    return _body(words[verb + 1 : end], book)


_REACH = 6


def _amount(words: Sequence[str], at: int, book: Phrasebook) -> bool:
    """Tell where it begins to be told how far or which way."""
    kind = book.motion.get((words[at],), "")
    quantity = words[at] not in book.numbers.articles and book.numbers.quantity(words, at)
    return bool(quantity) or kind in WAYS or words[at] in book.little["aimed"]


def _body(words: Sequence[str], book: Phrasebook) -> Phrase | None:
    """Return the words as a body's name; None if they can be none, as the hand's own parts."""
    name = without_article(words, book.little["determiners"] | book.numbers.articles)
    while name and name[-1] in _told(book, "lately"):
        name = name[:-1]
    if not 0 < len(name) <= LONGEST_BODY or set(name) & _told(book, "own"):
        return None
    moving = any(book.motion.get((word,), "") in WAYS for word in name[-1:])
    counted = any(book.numbers.number(name, at) for at in range(len(name)))
    return None if moving or counted or set(name) & book.impure else name


def _left(words: Sequence[str], body: Phrase, book: Phrasebook) -> int:
    """Return how many words tell neither the body nor how far it was moved."""
    known = {word for phrase in book.answer_words["pose_fillers"] for word in phrase}
    kinds = ("resting", "shifted", "agents", "scene", "shifting", "lately", "before")
    known |= {word for kind in kinds for word in _told(book, kind)} | set(body)
    tags = tags_of(words, book, frozenset(body))
    return sum(tag.kind in ("other", "empty") and not set(tag.words) <= known for tag in tags)
