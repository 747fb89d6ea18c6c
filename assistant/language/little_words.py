"""Words that single rules look at, such as articles and joining words: `little_words.yaml`.

Each language fills the same lists with what plays the part there; a list may be empty.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from functools import cache
from pathlib import Path
from typing import Any, cast

from assistant.errors import BadInput
from assistant.language.lists import listed, pairs
from assistant.plain_yaml import read_file

LANGUAGES = {"english": "english", "en": "english", "german": "german", "de": "german"}


@dataclass(frozen=True, eq=False)
class LittleWords:
    """The lists of a language.

    Parameters
    ----------
    lists : mapping
        Words by what they do.
    doing, stems, how, likeness : tuple of str
        Endings of words that name what is done, that change nothing for the sense of a name, of
        words that only tell how, and that two sentences alike may differ in.
    pair : tuple of str
        What "the first two" are.
    examples : tuple of str
        Names of steps and tasks, for sentences that are made up.
    typos : mapping
        Slips of little words with what is meant.
    """

    lists: Mapping[str, frozenset[str]]
    doing: tuple[str, ...]
    stems: tuple[str, ...]
    how: tuple[str, ...]
    likeness: tuple[str, ...]
    pair: tuple[str, ...]
    examples: tuple[str, ...]
    typos: Mapping[str, str]

    def __getitem__(self, name: str) -> frozenset[str]:
        """Return the words of a list."""
        return self.lists[name]

    def first(self, name: str) -> str:
        """Return the one word of a list; empty if there is none."""
        return next(iter(self.lists[name]), "")


def folder_of(language: str) -> Path:
    """Return where the pages of a language are.

    Raises
    ------
    BadInput
        If no such language is known.
    """
    name = LANGUAGES.get(language.lower())
    if name is None:
        raise BadInput.one("language", f"unknown language {language!r}", "english or german")
    return Path(__file__).parent / name


@cache
def little_words(language: str = "english") -> LittleWords:
    """Return the little words of a language, read once."""
    told = cast("dict[str, Any]", read_file(folder_of(language) / "little_words.yaml")[0].value)
    return LittleWords(
        lists={name: frozenset(listed(words)) for name, words in told["words"].items()},
        doing=listed(told["doing_endings"]),
        stems=listed(told["stem_endings"]),
        how=listed(told["how_endings"]),
        likeness=listed(told["likeness_endings"]),
        pair=listed(told["first_two"]),
        examples=listed(told["example_names"]),
        typos=dict(pairs(told["typos"])),
    )
