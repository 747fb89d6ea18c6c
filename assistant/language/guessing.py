"""What to make of words no sentence explains: a cry, a question, or the likest sentence."""

from __future__ import annotations

from assistant.language.answers import OPEN
from assistant.language.parsing import Hearing, Parse, texts_of
from assistant.language.similarity import likest
from assistant.language.words import Words, said
from assistant.model.teacher_acts import ACTS

_QUESTIONS = frozenset(
    [
        "what",
        "who",
        "where",
        "when",
        "which",
        "whose",
        "why",
        "how",
        "do",
        "did",
        "are",
        "is",
        "can",
    ]
)


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
    answering = hearing.listening.asked in OPEN and not asks(words)
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


def asks(words: Words) -> bool:
    """Tell a question or a polite request from an answer."""
    if words[0].text in ("what", "can", "do", "are", "is", "did", "how") and (
        len(words) < 2 or (words[0].text == "can" and words[1].broken)
    ):
        return len(words) < 2 and words[0].text in ("what", "how")
    if words[0].text == "what" and words[1].text in ("we", "i", "you"):
        return False
    polite = words[0].text in ("could", "would", "will", "may", "shall") and len(words) > 1
    return words[0].text in _QUESTIONS or (polite and words[1].text in ("you", "i", "we"))
