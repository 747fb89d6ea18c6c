"""Single words and what they point to: `hints.yaml` of a language, read once."""

from __future__ import annotations

import re
from collections.abc import Iterable
from functools import cache
from importlib.resources import files
from typing import Any

from assistant.plain_yaml import read_text

FOLDERS = {"en": "english", "english": "english", "de": "german", "german": "german"}


@cache
def page(name: str, language: str = "english") -> Any:
    """Return the plain values of a page of a language's phrasebook, English where missing."""
    top = files("assistant.language")
    source = top / FOLDERS.get(language, "english") / f"{name}.yaml"
    if not source.is_file():
        source = top / "english" / f"{name}.yaml"
    return read_text(source.read_text("utf-8"), f"{name}.yaml")[0].value


def has_page(name: str, language: str) -> bool:
    """Whether a language's phrasebook has this page itself."""
    folder = FOLDERS.get(language, language)
    return (files("assistant.language") / folder / f"{name}.yaml").is_file()


def hints(part: str, language: str = "english") -> Any:
    """Return one part of `hints.yaml`."""
    return page("hints", language)[part]


@cache
def phrase_pattern(phrase: str) -> re.Pattern[str]:
    """Return a pattern for a phrase; ``...`` in it stands for up to four words."""
    parts = [re.escape(part.strip()) for part in phrase.lower().split("...")]
    return re.compile(r"\b" + r"\b(?:\W+[\w'-]+){0,4}?\W+".join(parts) + r"\b")


def mentions(text: str, phrases: Iterable[str]) -> bool:
    """Whether one of the phrases stands in a text."""
    lowered = text.lower()
    return any(phrase_pattern(phrase).search(lowered) for phrase in phrases)


def matter(text: str, part: str, language: str = "english") -> str:
    """Return the first key of a part of `hints.yaml` whose words stand in a text, or ``""``."""
    groups: dict[str, list[str]] = hints(part, language)
    return next((key for key, phrases in groups.items() if mentions(text, phrases)), "")
