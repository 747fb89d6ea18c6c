"""Key states: what a teacher who demonstrates calls attention to."""

from __future__ import annotations

from collections.abc import Sequence

from assistant.language.little_words import LittleWords
from assistant.language.parsing import DOUBTFUL, LIKELY, Hearing, Parse, texts_of
from assistant.language.phrasebook import Phrase
from assistant.language.sentences import best_sentence
from assistant.language.words import Words, said
from assistant.model.teacher_acts import Cue, KeyState


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
    little = hearing.book.little
    weak = little["key_weak"]
    strong = (set(texts) & (nouns | verbs)) - weak
    concerned = bool(set(texts) & nouns and set(texts) & verbs and strong)
    concerned = concerned or (_stated_now(texts, little) and bool(set(texts) & verbs - weak))
    callings = {word for phrase in lists["key_calling"] for word in phrase}
    calling = bool(words_before) and words_before[0].text in callings
    concerned = concerned or (calling and bool(set(texts) & verbs - weak) and len(texts) > 3)
    if set(texts) & hearing.book.chat and not (_stated_now(texts, little) and strong):
        return None
    asking = texts and texts[0] in little["key_asking"]
    if not concerned or asking or len(texts) < 3:
        return None
    if texts[0] in little["own_subjects"] and not marked:
        return Parse((KeyState(said(words)),), DOUBTFUL)
    return Parse((KeyState(said(words)),), LIKELY if marked else LIKELY - 0.03)


def _cued_behind(words: Words, hearing: Hearing) -> bool:
    """Tell whether the last clause is a cue: "the cup is full now, next step"."""
    last = max((at for at in range(1, len(words)) if words[at].broken), default=0)
    told = best_sentence(words[last:], hearing) if last else None
    return told is not None and isinstance(told.acts[0], Cue)


def _stated_now(texts: Phrase, little: LittleWords) -> bool:
    """Tell "the can is gripped now", whatever the can is."""
    at = next((n for n, text in enumerate(texts) if text in little["key_states"]), 0)
    talk = set(texts[:at]) & little["key_talk"]
    return 0 < at <= 4 and not talk and texts[-1] in little["now"]


def _marker(words: Words, markers: Sequence[Phrase]) -> int:
    texts = texts_of(words)
    return next((len(phrase) for phrase in markers if texts[: len(phrase)] == phrase), 0)
