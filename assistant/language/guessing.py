"""What to make of words no sentence explains: a cry, a question, or the likest sentence."""

from __future__ import annotations

from assistant.language.answers import OPEN
from assistant.language.parsing import Hearing, Parse, texts_of
from assistant.language.phrasebook import Phrasebook
from assistant.language.similarity import likest
from assistant.language.words import Words, said
from assistant.model.teacher_acts import ACTS


def urgent(words: Words, hearing: Hearing) -> bool:
    """Tell a short cry that begins or ends with a stop word, whatever else is in it."""
    texts = texts_of(words)
    known = hearing.book.answer_words
    if len(texts) > 4 or set(texts) & hearing.book.chat:
        return False
    ends = {texts[:1], texts[-1:], texts[-2:]}
    calm = {word for phrase in known["stop_calm"] for word in phrase}
    return bool(ends & set(known["stop_cries"])) and not set(texts) & calm


def guess(words: Words, hearing: Hearing) -> Parse | None:
    """Return the act of the likest known sentence, unless people chat or answer."""
    texts = texts_of(words)
    answering = hearing.listening.asked in OPEN and not asks(words, hearing.book)
    if answering or set(texts) & hearing.book.chat or len(texts) > 14:
        return None
    found = likest(texts, hearing.listening, hearing.language)
    if found is None:
        return None
    sentence, score = found
    slots = dict(sentence.slots)
    if sentence.extra == "text":
        slots["text"] = said(words)
    elif sentence.extra:
        return None
    return Parse((ACTS[sentence.act](**slots),), score)


def asks(words: Words, book: Phrasebook) -> bool:
    """Tell a question or a polite request from an answer."""
    first, second = words[0].text, words[1].text if len(words) > 1 else ""
    if not second:
        return (first,) in book.wrapping.get("asked_alone", ())
    begun = (first,)
    listing = words[1].broken and begun in book.wrapping.get("also_things", ())
    stated = (second,) in book.wrapping.get("stating", ())
    if listing or (stated and begun in book.wrapping.get("whats", ())):
        return False
    if begun in book.wrapping.get("whens", ()):
        return (second,) in book.wrapping.get("inverted", ())
    if begun in book.wrapping.get("polite_first", ()):
        return (second,) in book.wrapping.get("spoken_to", ())
    return begun in book.wrapping.get("questions", ())
