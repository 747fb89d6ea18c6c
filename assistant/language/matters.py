"""What one sentence tells of several matters: a name, a goal, the things, how many steps, which.

`topics` of a language's `hints.yaml` holds the openings: "the goal is", "you need", "it has two
steps". What comes before the first one answers what was asked.
"""

from __future__ import annotations

import re
from dataclasses import dataclass
from functools import cache
from typing import Any

from assistant.language.hints import hints

TOPICS = ("task_name", "goal", "objects", "count", "steps")


@dataclass(frozen=True, slots=True)
class Told:
    """One matter of a sentence.

    Parameters
    ----------
    topic : str
        One of `TOPICS`; empty for what comes before the first opening.
    text : str
        The matter itself; for ``count`` what is said of the steps after their number.
    count : int
        For ``count``: how many.
    listed : bool
        For ``count``: what follows is opened as a list, however its steps are worded.
    """

    topic: str
    text: str
    count: int = 0
    listed: bool = False


def told_matters(text: str, language: str = "english") -> tuple[Told, ...]:
    """Return the matters of a sentence in the order told; one without a topic has no opening."""
    plain = " ".join(text.replace("\u2019", "'").split())
    found: list[re.Match[str]] = []
    begun = False
    for hit in _openings(language).finditer(plain):
        topic = _topic(hit)
        # A list of steps goes on with "first" and "then" until another matter is opened.
        if topic == "steps" and begun:
            continue
        begun = begun or topic in ("steps", "count")
        found.append(hit)
    head = plain[: found[0].start()] if found else plain
    ends = [*(hit.start() for hit in found[1:]), len(plain)]
    pairs = zip(found, ends, strict=False)
    told = [_matter(hit, plain[hit.end() : end], language) for hit, end in pairs]
    first = (Told("", _tidy(head)),) if _tidy(head) else ()
    return (*first, *told)


def _matter(hit: re.Match[str], text: str, language: str) -> Told:
    topic = _topic(hit)
    if topic != "count":
        return Told(topic, _tidy(text))
    said = hit.group("number").lower()
    number = int(said) if said.isdigit() else hints("numbers", language)[said]
    openings = _any(hints("topics", language)["steps"])
    opened = re.match(rf"\s*(?::|[,;]?\s*(?:{openings})\b)\s*", text, re.IGNORECASE)
    return Told(topic, _tidy(text[opened.end() :] if opened else text), number, bool(opened))


def _topic(hit: re.Match[str]) -> str:
    return next(topic for topic in TOPICS if hit.group(topic) is not None)


@cache
def _openings(language: str) -> re.Pattern[str]:
    topics: dict[str, Any] = hints("topics", language)
    leads = _any([*hints("leads", language), *(one.strip() for one in hints("joins", language))])
    kinds = [rf"(?P<{topic}>(?:{_any(topics[topic])})\b)" for topic in TOPICS if topic != "count"]
    numbers = rf"(?P<number>\d+|{_any(hints('numbers', language))})"
    opened = rf"(?:(?:{_any(topics['counting'])})\s+)?"
    counted = rf"(?P<count>{opened}(?:(?:{_any(topics['about'])})\s+)?{numbers}\s+"
    counted += rf"(?:(?:{_any(topics['main'])})\s+)?(?:{_any(topics['count_nouns'])})\b)"
    joints = "|".join(re.escape(one.strip()) for one in hints("joins", language))
    boundary = rf"(?:^|[,;.:!]|\b(?:{joints})\b)\s*(?:(?:{leads})\b\W*)*"
    return re.compile(boundary + rf"(?:{'|'.join([counted, *kinds])})", re.IGNORECASE)


def _any(phrases: list[str]) -> str:
    return "|".join(re.escape(one) for one in sorted(phrases, key=len, reverse=True))


def _tidy(text: str) -> str:
    return text.strip(" \t\"'.,;:!?-")
