"""What people say beside the question: a greeting, who they are, a name given late.

`hints.yaml` of a language holds the openings; what comes after one is the matter itself.
"""

from __future__ import annotations

import re
from functools import cache

from assistant.language.hints import hints, mentions

LONGEST_NAME = 3
"""Words of a person's name; more is a sentence."""


def after(text: str, part: str, language: str = "english") -> str:
    """Return what follows an opening of a part of `hints.yaml`; empty if none opens the text.

    Greetings and small words such as "no" or "actually" may come before it.
    """
    found = _opening(part, language).match(_plain(text))
    return _tidy(found.group(1)) if found else ""


def mended(text: str, language: str = "english") -> str:
    """Return what a teacher says in the end: "stacking, no wait, sorting" is "sorting"."""
    marks = _alternatives(hints("mends", language))
    parts = re.split(rf"[,;.]?\s*\b(?:{marks})\b[\s,]*", _plain(text), flags=re.IGNORECASE)
    told = [part for part in map(_tidy, parts) if part]
    return told[-1] if told else text


def recounted(text: str, language: str = "english") -> int | None:
    """Return the number in "no, four" or "five steps, not three", where nothing else is said."""
    numbers: dict[str, int] = hints("numbers", language)
    kinds = _alternatives([*hints("leads", language), *hints("count_words", language)])
    wrong = rf"(?:{_alternatives(hints('rather_than', language))})\s+(?:{'|'.join(numbers)}|\d+)"
    left = re.sub(rf"\b(?:{wrong}|{kinds})\b|[^\w\s]", " ", _plain(text), flags=re.IGNORECASE)
    words = left.lower().split()
    if len(words) != 1:
        return None
    return int(words[0]) if words[0].isdigit() else numbers.get(words[0])


def taught(text: str, language: str = "english") -> str:
    """Return the task in "I would like to show you how to clear the table"; empty if none."""
    start = after(text, "teaching_starts", language)
    return after(start, "teaching_verbs", language) if start else ""


def is_greeting(text: str, language: str = "english") -> bool:
    """Whether a text greets and says nothing else."""
    return _is_only(text, "greetings", language)


def is_thanks(text: str, language: str = "english") -> bool:
    """Whether a text thanks and says nothing else."""
    return _is_only(text, "thanks", language)


def frees_order(text: str, language: str = "english") -> bool:
    """Whether a text tells that the order is free, and nothing else."""
    return _is_only(text, "order_free", language)


def introduced_person(
    text: str, language: str = "english", *, sure: bool = False
) -> tuple[str, str]:
    """Return the name of a teacher who tells it, and what else is said; empty if none does.

    Parameters
    ----------
    text : str
    language : str
    sure : bool
        Take only what can mean nothing else: "my name is Anna", not "I am Anna".
    """
    rest = after(text, "person", language)
    told = bool(rest)
    if not rest and not sure:
        rest = after(text, "perhaps_person", language)
    head, _, tail = _broken(rest, language)
    words = re.findall(r"[^\W\d_][\w'-]*", head)
    if not words or len(words) > LONGEST_NAME:
        return "", ""
    odd = words[0].lower() in hints("no_person", language) or words[0].lower().endswith("ing")
    if odd or (not told and len(words) > 1 and not words[0][0].isupper()):
        return "", ""
    return " ".join(word[:1].upper() + word[1:] for word in words), _tidy(tail)


def is_puzzled(text: str, language: str = "english") -> bool:
    """Whether the teacher does not understand what the robot wants."""
    return len(text.split()) <= 8 and mentions(_plain(text), hints("puzzled", language))


def unknowing(text: str, language: str = "english") -> bool:
    """Whether the teacher cannot or will not answer, and does not answer all the same."""
    plain = _plain(text)
    if not mentions(plain, hints("unknowing", language)):
        return False
    return not mentions(plain, hints("all_the_same", language))


def _broken(text: str, language: str) -> tuple[str, str, str]:
    """Return a text before and after its first break."""
    breaks = "|".join(map(re.escape, hints("breaks", language)))
    found = re.search(breaks, text, re.IGNORECASE)
    if found is None:
        return text, "", ""
    return text[: found.start()], found.group(), text[found.end() :]


@cache
def _opening(part: str, language: str) -> re.Pattern[str]:
    leads = _alternatives([*hints("leads", language), *hints("greetings", language)])
    openings = _alternatives(hints(part, language))
    return re.compile(rf"(?:(?:{leads})\b\W*)*(?:{openings})\b\W*(.+)$", re.IGNORECASE | re.DOTALL)


def _alternatives(phrases: list[str]) -> str:
    return "|".join(re.escape(one) for one in sorted(phrases, key=len, reverse=True))


def _is_only(text: str, part: str, language: str) -> bool:
    phrases = _alternatives([*hints(part, language), *hints("beside", language)])
    left = re.sub(rf"\b(?:{phrases})\b", " ", _plain(text), flags=re.IGNORECASE)
    return mentions(_plain(text), hints(part, language)) and not re.search(r"\w", left)


def _plain(text: str) -> str:
    return " ".join(text.replace("\u2019", "'").split()).strip()


def _tidy(text: str) -> str:
    return text.strip(" \t\"'.,;:!?-")
