"""What a line rules out: "left, not right", and a no with what is wanted instead."""

from __future__ import annotations

from assistant.language.clauses import clause
from assistant.language.mending import without_marks
from assistant.language.merging import CORRECTIONS
from assistant.language.parsing import GUESSED, Hearing, Parse, texts_of
from assistant.language.phrasebook import Phrase
from assistant.language.tags import tags_of
from assistant.language.words import Words
from assistant.model.teacher_acts import Deny

GROUPS = {
    "way": frozenset(
        [
            "left",
            "right",
            "up",
            "down",
            "forward",
            "backward",
            "clockwise",
            "counterclockwise",
            "up-er",
            "down-er",
            "high",
            "low",
            "raise",
            "lower",
            "advance",
            "retreat",
        ]
    ),
    "amount": frozenset(("quantity", "little", "much")),
    "pace": frozenset(("faster", "slower", "fast", "slow")),
    "verb": frozenset(("turn", "tilt", "move")),
}
"""Kinds of words of which one takes the place of another."""


def contrasted(words: Words, hearing: Hearing) -> Parse | None:
    """Read "left, not right", "not left but right", "ten mil, not ten centimetres, up"."""
    texts = texts_of(words)
    told = set(texts)
    for phrase in hearing.book.contrasting:
        if phrase[0] not in told:
            continue
        for at in range(len(texts) - len(phrase)):
            if texts[at : at + len(phrase)] != phrase:
                continue
            dropped = _dropped(words, at + len(phrase), hearing)
            if dropped is None:
                continue
            end, group = dropped
            kept = _without_no((*words[:at], *words[end:]), hearing)
            if not kept or not _holds(kept, group, hearing):
                continue
            parse = clause(kept, hearing)
            if parse is not None and parse.score >= GUESSED and _corrects(parse):
                return Parse(parse.acts, parse.score - 0.03, parse.how)
    return None


def _without_no(words: Words, hearing: Hearing) -> Words:
    """Take a no off the front that only opens the line."""
    leading = len(words) > 1 and words[0].text in hearing.book.no and words[1].broken
    return words[1:] if leading else words


def _corrects(parse: Parse) -> bool:
    return all(isinstance(act, CORRECTIONS) for act in parse.acts)


def _dropped(words: Words, at: int, hearing: Hearing) -> tuple[int, str] | None:
    """Return where what is ruled out ends, and of which kind of words it is."""
    texts = texts_of(words)
    end, group = at, ""
    while at < len(texts) and not group:
        end, group = _kind_at(texts, at, hearing)
        if not group and texts[at] not in hearing.book.little["contrast_little"]:
            return None
        at += 1
    while end < len(texts) and texts[end] in hearing.book.little["contrast_marks"]:
        end += 1
    return (end, group) if group else None


def _kind_at(texts: Phrase, at: int, hearing: Hearing) -> tuple[int, str]:
    """Return where what stands at a place ends, and of which kind of words it is."""
    if texts[at] in hearing.book.little["whens"]:
        return at + 1, "when"
    tag = tags_of(texts[at:], hearing.book, hearing.names)[0]
    kinds = (name for name, kinds in GROUPS.items() if tag.kind in kinds)
    return at + len(tag.words), next(kinds, "")


def _holds(words: Words, group: str, hearing: Hearing) -> bool:
    """Tell whether words of a kind are among others."""
    if group == "when":
        return bool(hearing.book.little["whens"] & set(texts_of(words)))
    tags = tags_of(texts_of(words), hearing.book, hearing.names)
    return any(tag.kind in GROUPS[group] for tag in tags)


def denied(words: Words, hearing: Hearing) -> tuple[Words, Words] | None:
    """Return the no a line begins with and what is wanted instead: "no, I said slower"."""
    book, texts = hearing.book, texts_of(words)
    cuts = [at for at in range(1, min(len(words), _LONGEST_NO)) if words[at].broken]
    if texts[0] in book.no and (1 not in cuts):
        cuts = [1, *cuts]
    for at in reversed(cuts):
        head, rest = words[:at], without_marks(words[at:], book.restating)
        if rest and _denies(head, hearing, restated=len(rest) < len(words) - at):
            return head, rest
    return None


_LONGEST_NO = 8


def _denies(words: Words, hearing: Hearing, *, restated: bool) -> bool:
    """Tell a clause that says no, alone or among words that say nothing."""
    texts, book = texts_of(words), hearing.book
    refusing = book.no | book.refusing
    little = refusing | book.empty | book.little["not"]
    if set(texts) & refusing and all(text in little for text in texts):
        return True
    tags = tags_of(texts, book, hearing.names)
    if any(tag.kind in kinds for tag in tags for kinds in GROUPS.values()):
        return False
    if restated and book.little["not"] & set(texts):
        return True
    parse = clause(words, hearing)
    return parse is not None and parse.acts == (Deny(),)
