"""Words are data: every language fills the same lists, and no code holds English words."""

import ast
import re
from collections.abc import Iterator
from pathlib import Path
from typing import Any, get_args

import pytest

from assistant.errors import BadInput
from assistant.language import phrasebook as of_phrasebook
from assistant.language.likelihood import model
from assistant.language.little_words import folder_of, little_words
from assistant.language.phrasebook import phrasebook
from assistant.language.tagging import SLOTS
from assistant.language.words import words_of
from assistant.model import listening, teacher_acts
from assistant.plain_yaml import read_file

CODE = Path(of_phrasebook.__file__).parent
CONTRACTIONS = phrasebook().contractions
PAGES = ("hears", "frames", "says")
NAMING = ("looks", "choosing", "likelihood", "traits", "nets")
"""Pages whose texts are names of looks and of weights."""
OWN = {
    "sentence",
    "frame",
    "request",
    "seconds",
    "act",
    "when",
    "action",
    "known",
    "target",
    "box",
    "cup",
    "any",
    "list",
}
"""Names of ways to read, of kinds of slots, of shapes of bodies, and of what a JSON line holds."""


def keys(told: Any) -> Iterator[str]:
    """Yield every key of a page, which is a name and no word."""
    if isinstance(told, dict):
        for key, below in told.items():
            yield str(key)
            yield from keys(below)


def names() -> set[str]:
    """Return words that are names of the program's own: of acts, slots, kinds and lists."""
    found = {
        word
        for page in PAGES
        for word in keys(read_file(folder_of("en") / f"{page}.yaml")[0].value)
    }
    for kind in teacher_acts.ACTS.values():
        found |= set(kind.__dataclass_fields__)
    found |= set(teacher_acts.ACTS)
    for told in (*vars(teacher_acts).values(), *vars(listening).values()):
        found |= {one for one in get_args(told) if isinstance(one, str)}
    for page in CODE.glob("*.py"):
        found |= set(closed(page))
    known, book = model("english"), phrasebook()
    found |= {*SLOTS, *(known.labels if known else ())}
    return (
        found | OWN | set(book.motion.values()) | {kind for kind, _ in book.numbers.units.values()}
    )


def closed(page: Path) -> Iterator[str]:
    """Yield the values of the closed types of a page."""
    for node in ast.walk(ast.parse(page.read_text())):
        if isinstance(node, ast.Subscript) and getattr(node.value, "id", "") == "Literal":
            for one in ast.walk(node.slice):
                if isinstance(one, ast.Constant) and isinstance(one.value, str):
                    yield one.value


def compared(page: Path) -> Iterator[tuple[int, str]]:
    """Yield the texts of a page's code that others are compared with or looked for among."""
    for node in ast.walk(ast.parse(page.read_text())):
        held: list[ast.expr] = []
        if isinstance(node, ast.Compare):
            held = [node.left, *node.comparators]
        elif isinstance(node, ast.Set | ast.Tuple | ast.List):
            held = node.elts
        for one in held:
            if isinstance(one, ast.Constant) and isinstance(one.value, str):
                yield one.lineno, one.value


def test_no_code_holds_words_of_english() -> None:
    """A text in code that is an English word must be the name of something."""
    book = phrasebook()
    words = book.vocabulary | book.real | book.empty | {"the", "a", "an", "is", "to", "of"}
    own = names()
    held = [
        f"{page.name}:{line}: {text}"
        for page in sorted(CODE.glob("*.py"))
        if page.stem not in NAMING
        for line, text in compared(page)
        if re.fullmatch(r"[a-z']+( [a-z']+)*", text)
        and text not in own
        and all(word in words for word in text.split())
    ]
    assert held == []


def test_every_language_fills_the_same_lists() -> None:
    """A rule never misses a list, and no word stands in two ways."""
    assert little_words("english").lists.keys() == little_words("german").lists.keys()


def test_an_owner_that_is_a_step_is_no_contraction_of_let_us() -> None:
    """Behind any noun "'s" is read as "is" only where a state follows."""
    said = [word.text for word in words_of("the goblet's off, pouring's done", CONTRACTIONS)]
    assert said == ["the", "goblet's", "off", "pouring", "is", "done"]


def test_unknown_languages_are_refused() -> None:
    """Told with what would be right."""
    with pytest.raises(BadInput, match="english or german"):
        folder_of("klingon")
