"""A task is written down in the language of its teacher."""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import replace
from typing import get_args

import pytest

from assistant.files.records import record
from assistant.language.hints import page
from assistant.model.lesson import Episode
from assistant.model.task import Primitive, Role, Task, walk
from tests.files.examples import lesson, task

LANGUAGES = ("english", "german")
NAMES = re.compile(r"[A-Za-zÄÖÜäöüß]{2,}")


def _texts(value: object) -> Iterator[str]:
    if isinstance(value, dict):
        for one in value.values():
            yield from _texts(one)
    elif isinstance(value, list):
        for one in value:
            yield from _texts(one)
    else:
        yield str(value)


def _labels(language: str) -> set[str]:
    """Return the words of a language's record."""
    told = " ".join(re.sub(r"\{\w+\}", "", one) for one in _texts(page("record", language)))
    return set(NAMES.findall(told.lower()))


def _own(told: Task) -> Iterator[str]:
    """Yield the teacher's own words: names, goals, corrections."""
    assert told.learned is not None
    yield from (told.name, told.goal, *(one.name for one in told.objects))
    for _, node in walk(told.tree):
        yield node.name
        yield node.action.way if isinstance(node, Primitive) else node.goal
    yield from (one.words for one in told.learned.feedback)


def _whole() -> Task:
    told = lesson()
    cuts = told.segmentation
    moved = Episode(1.0, 2.0, "", 0.5, "turn left")
    cuts = replace(cuts, episodes=(*cuts.episodes, moved))
    return task(replace(told, segmentation=cuts))


@pytest.mark.parametrize("language", LANGUAGES)
def test_a_record_has_all_a_lesson_taught(language: str) -> None:
    words, text = page("record", language), record(_whole(), language)
    for part in ("steps", "learned", "corrections", "nobody"):
        assert words[part] in text
    for table in ("episodes", "stations"):
        assert f"| {' | '.join(words[table])} |" in text
    assert words["motions"]["turn left"] in text


def test_a_german_record_has_no_english_word() -> None:
    ours = _labels("german")
    english = _labels("english") - ours - {"in", "hand"}
    assert len(english) > 20
    told = set(NAMES.findall(record(_whole(), "german").lower()))
    own = set(NAMES.findall(" ".join(_own(_whole())).lower()))
    assert (told - own) & english == set()


def test_both_languages_have_the_same_labels() -> None:
    def keys(value: object) -> object:
        if isinstance(value, dict):
            return {key: keys(one) for key, one in value.items()}
        return len(value) if isinstance(value, list) else None

    assert keys(page("record", "english")) == keys(page("record", "german"))


@pytest.mark.parametrize("language", LANGUAGES)
def test_every_role_is_told(language: str) -> None:
    assert set(page("record", language)["roles"]) == set(get_args(Role))


@pytest.mark.parametrize("language", LANGUAGES)
def test_decimals_stand_as_the_language_writes_them(language: str) -> None:
    mark = {"english": ".", "german": ","}[language]
    other = {"english": ",", "german": "."}[language]
    text = record(_whole(), language)
    assert f"1{mark}25 |" in text
    assert not re.search(rf"\d\{other}\d", text)
