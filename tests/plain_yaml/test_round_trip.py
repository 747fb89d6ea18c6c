"""What is written is read again as the same values, whatever a teacher may have said."""

from __future__ import annotations

import json
import math
from collections.abc import Mapping
from pathlib import Path
from typing import Any

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from assistant.plain_yaml import json_word, read_file, read_text, tidy, write, write_item

texts = st.text(st.characters(exclude_categories=["Cs"]), max_size=30)
scalars = st.one_of(
    st.none(),
    st.booleans(),
    st.integers(-(10**17), 10**17),
    st.floats(allow_nan=False),
    texts,
    st.sampled_from(["yes", "no", "on", "off", "3:30", "1e-3", "null", "~", "- a", "a: b", "a #b"]),
)
keys = st.one_of(texts, st.sampled_from(["on", "1", "true", "a b", "robot?", "robot*", "steps"]))
values = st.recursive(
    scalars,
    lambda inner: st.one_of(st.lists(inner, max_size=4), st.dictionaries(keys, inner, max_size=4)),
    max_leaves=15,
)
mappings = st.dictionaries(keys, values, max_size=5)


def same(first: Any, second: Any) -> bool:
    """Equal, with 1 and 1.0 and True told apart."""
    if isinstance(first, dict):
        return list(first) == list(second) and all(same(first[k], second[k]) for k in first)
    if isinstance(first, list):
        return len(first) == len(second) and all(map(same, first, second))
    return type(first) is type(second) and first == second


@settings(max_examples=120)
@given(mappings)
def test_reading_what_was_written_gives_the_same_values(value: dict[str, Any]) -> None:
    (document,) = read_text(write(value))
    assert same(value, document.value)


@settings(max_examples=60)
@given(mappings)
def test_writing_what_was_read_gives_the_same_text(value: dict[str, Any]) -> None:
    text = write(value, spread=["steps"])
    read = read_text(text)[0].value
    assert isinstance(read, Mapping)
    assert write(read, spread=["steps"]) == text


@settings(max_examples=60)
@given(st.lists(values, min_size=1, max_size=4))
def test_items_appended_one_by_one_are_a_list(items: list[Any]) -> None:
    text = "".join(write_item(item) for item in items)
    assert same(items, read_text(text)[0].value)


def test_a_lone_half_of_a_letter_is_replaced_not_refused() -> None:
    (document,) = read_text(write({"says": "caf\udce9"}))
    assert document.value == {"says": "caf\ufffd"}


def test_words_stay_words_and_numbers_numbers() -> None:
    (document,) = read_text(
        "{a: yes, b: no, c: on, d: off, e: 3:30, f: 1e-3, g: 0x10, h: 1_000, i: 2026-01-01,"
        " j: -.5, k: true, l: null, m: '1', n: 12345678901234567890, o: +7, p: 1.}"
    )
    assert document.value == {
        "a": "yes",
        "b": "no",
        "c": "on",
        "d": "off",
        "e": "3:30",
        "f": 0.001,
        "g": "0x10",
        "h": "1_000",
        "i": "2026-01-01",
        "j": -0.5,
        "k": True,
        "l": None,
        "m": "1",
        "n": 12345678901234567890.0,
        "o": 7,
        "p": 1.0,
    }


def test_short_things_stay_on_a_line_and_long_ones_are_spread() -> None:
    text = write(
        {
            "cues": [{"at_s": 6.5, "say": "then"}],
            "steps": [{"teacher": "hello"}, {"says": "a, b", "heard": "c"}],
            "row": [1.5] * 60,
        },
        spread=["steps"],
    )
    assert text == (
        "cues: [{at_s: 6.5, say: then}]\n"
        "steps:\n"
        "  - teacher: hello\n"
        '  - {says: "a, b", heard: c}\n'
        f"row: [{', '.join(['1.5'] * 60)}]\n"
    )


def test_whole_numbers_are_tidied_and_nothing_else_is() -> None:
    assert str(tidy(300.0)) == "300"
    assert tidy(0.1) == 0.1
    assert str(tidy(-0.0)) == "-0.0"
    assert math.isinf(tidy(math.inf))
    assert str(tidy(1e20)) == "1e+20"


def test_rows_stay_on_their_lines_however_long() -> None:
    row = {"name": "x" * 90, "votes": {"gripper": 1.0, "speed": 0.5}}
    text = write({"points": [row, row], "inner": {"points": {"a": 1}}}, rows=["points"])
    assert text.count("\n") == 4
    assert read_text(text)[0].value == {"points": [row, row], "inner": {"points": {"a": 1}}}


def test_empty_mapping_is_a_mapping() -> None:
    assert read_text(write({}))[0].value == {}


@settings(max_examples=50, deadline=None)
@given(st.recursive(texts, lambda one: st.lists(one) | st.dictionaries(texts, one), max_leaves=5))
def test_json_of_any_text_is_read_however_it_spells_its_letters(
    tmp_path_factory: pytest.TempPathFactory, value: object
) -> None:
    path = tmp_path_factory.mktemp("j") / "x.json"
    for text in (json_word({"a": value}), json.dumps({"a": value})):
        path.write_text(text, "utf-8")
        (document,) = read_file(path)
        assert document.value == {"a": value}


def test_a_backslash_that_is_meant_stays(tmp_path: Path) -> None:
    path = tmp_path / "x.json"
    path.write_text(json.dumps({"a": "\\ud83d\\ude00", "b": "\\\U0001f600"}))
    (document,) = read_file(path)
    assert document.value == {"a": "\\ud83d\\ude00", "b": "\\\U0001f600"}
