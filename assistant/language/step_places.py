"""Where in a task a correction belongs: words that say when, and the step they lead to."""

from __future__ import annotations

from collections.abc import Iterator

from assistant.language.frames import frames
from assistant.language.naming import without_article
from assistant.language.parsing import LIKELY, SURE, Hearing, texts_of
from assistant.language.phrasebook import Phrase, Phrasebook
from assistant.language.tags import WAYS, tags_of
from assistant.language.words import Words
from assistant.model.feedback import When

PARTLY = 0.78
_PAIR, _SHORT = 2, 3
_NO_PLACE_KINDS = frozenset(
    ("quantity", "little", "much", "faster", "slower", "speed", "too", "enough")
)


def marks(texts: Phrase, book: Phrasebook) -> Iterator[tuple[int, Phrase, When]]:
    """Yield where words stand that say when: the longest phrase of each place."""
    for at in range(len(texts) - 1):
        begun = book.whens.get(texts[at], ())
        found = [one for one in begun if texts[at : at + len(one[0])] == one[0]]
        longest = max((len(phrase) for phrase, _ in found), default=0)
        yield from ((at, phrase, when) for phrase, when in found if len(phrase) == longest)


def only_begun(texts: Phrase, hearing: Hearing) -> bool:
    """Tell a place that is begun and not told: "when you, during the approach, slower"."""
    begun = hearing.book.whens.get(texts[0], ()) if texts else ()
    return any(
        texts[: len(phrase)] == phrase and set(texts[len(phrase) :]) <= hearing.book.stuttered
        for phrase, _ in begun
    )


def ends(words: Words, at: int, start: int, hearing: Hearing) -> Iterator[int]:
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
        little = hearing.book.little
        loose = words[end].text in little["loose_ends"]
        amount = words[end].text in little["quantity_articles"] and _moving(
            texts_of(words[end : end + 2]), hearing
        )
        loose = loose and not amount
        stated = words[end].text in little["lately_named"] and _stated_behind(words, end, hearing)
        if stated or not loose:
            yield end


def _parted(words: Words, hearing: Hearing) -> frozenset[int]:
    """Return where particles stand that belong to the verb before: "putting | down"."""
    motion = hearing.book.motion
    kinds = [motion.get((word.text,), "") for word in words]
    parted = set()
    for at in range(1, len(words)):
        particle = words[at].text in hearing.book.where_words["particles"]
        only_way = kinds[at] in WAYS and not any(kind in WAYS for kind in kinds[at + 1 :])
        if particle and (words[at - 1].text.endswith(hearing.book.little.doing) or not only_way):
            parted.add(at)
    return frozenset(parted)


def verb_in(place: Words, hearing: Hearing) -> bool:
    """Tell "(in) the swirl", whose verb would else be read as what to do."""
    texts = texts_of(place)
    kind = hearing.book.motion.get(texts[1:], "") if len(texts) == _PAIR else ""
    return bool(set(texts[:1]) & hearing.book.little["the"]) and kind in (
        "turn",
        "tilt",
        "raise",
        "lower",
        "move",
    )


def trust_in(texts: Phrase, phrase: Phrase, hearing: Hearing, *, told: bool = False) -> float:
    """Return how sure it is that words no task knows name a step; 0 if they cannot.

    It is `told` where a noun for a step stood behind: "in the tuck step".
    """
    book = hearing.book
    if texts[-1] in book.where_words["no_ends"]:
        return 0.0
    if (len(texts) == 1 and texts[0] in book.little["bare_subjects"]) or any(
        t in book.chat for t in texts
    ):
        return 0.0
    if any(texts[: len(one)] == one for one, _ in book.whens.get(texts[0], ())):
        return 0.0
    if set(texts) <= book.little["no_amounts"] or _moving(texts, hearing):
        return 0.0
    listed = without_article(texts, book.little["determiners"]) in book.where["stepping"]
    known = frames(hearing.language)
    endings = book.little.doing or (known.name_endings if known else ())
    told_step = listed or any(
        t.endswith(endings) and t not in book.where_words["no_steps"] for t in texts
    )
    if is_weak(phrase, book) and not set(phrase) <= book.little["once"] and not (told_step or told):
        odd = [t for t in texts if (t,) not in book.motion and t not in book.empty]
        bodies = {word for one in book.answer_words["pose_bodies"] for word in one} | hearing.names
        named = odd and not bodies & set(texts) and not set(odd) & book.where_words["no_places"]
        own = texts[0] in book.where_words["no_starts"]
        return PARTLY if named and not own and len(texts) <= _SHORT else 0.0
    return SURE if listed else LIKELY + 0.01


def _moving(texts: Phrase, hearing: Hearing) -> bool:
    """Tell words that tell how far or how fast, which no place does."""
    tags = tags_of(texts, hearing.book, frozenset())
    return any(tag.kind in _NO_PLACE_KINDS for tag in tags)


def without_noun(words: Words, book: Phrasebook) -> Words:
    """Take the noun off "the pick it up step"."""
    return (
        words[:-1] if len(words) > 1 and words[-1].text in book.where_words["step_nouns"] else words
    )


def unfinished(words: Words, book: Phrasebook) -> Words:
    """Take off a name of a step that it "is over" or "has finished"."""
    little, at = book.little, len(words)
    while at > 1 and words[at - 1].text in little["over"]:
        at -= 1
    told = 1 < at < len(words) and words[at - 1].text in little["key_states"]
    return words[: at - 1] if told else words


def place_in(words: Words, hearing: Hearing) -> Words:
    """Take the subject off "you place it", and the article off "the grasp"."""
    texts = texts_of(words)
    for phrase in hearing.book.where["subject"]:
        if texts[:1] == phrase[:1] and len(phrase) < len(words) and texts[: len(phrase)] == phrase:
            return place_in(words[len(phrase) :], hearing)
    return words


def is_weak(phrase: Phrase, book: Phrasebook) -> bool:
    """Tell words that lead to much else as well: "in the end", "at once"."""
    return len(phrase) == 1 and phrase[0] in book.where_words["weak"]


def _stated_behind(words: Words, at: int, hearing: Hearing) -> bool:
    """Tell "it should ...", which begins what is asked for."""
    return at + 1 < len(words) and words[at + 1].text in hearing.book.where_words["stated"]
