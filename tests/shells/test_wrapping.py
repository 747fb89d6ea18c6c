from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st

from assistant.shells.wrapping import NARROWEST, styled, wrapped

WORDS = st.lists(st.text("abcdefgh", min_size=1, max_size=9), min_size=1, max_size=40)


@given(WORDS, st.integers(NARROWEST + 10, 120))
def test_lines_fit_and_no_word_is_cut(words: list[str], width: int) -> None:
    lines = wrapped(" ".join(words), width, before="robot: ")
    assert all(len(line) < width for line in lines)
    assert lines[0].startswith("robot: ")
    assert all(line.startswith("       ") for line in lines[1:])
    assert " ".join(lines)[len("robot: ") :].split() == words


def test_a_list_keeps_its_lines_and_indents() -> None:
    told = wrapped("The plan:\n  1. approach\n    1.1 and so on and so on\nRight?", 24, before="> ")
    assert told == (
        "> The plan:",
        "    1. approach",
        "      1.1 and so on and",
        "      so on",
        "  Right?",
    )


def test_nothing_is_a_line_too() -> None:
    assert wrapped("", 80, before="robot: ") == ("robot: ",)


def test_colors_can_be_unwanted(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.delenv("NO_COLOR", raising=False)
    assert styled("x", "1") == "\x1b[1mx\x1b[0m"
    assert styled("x", "") == "x"
    monkeypatch.setenv("NO_COLOR", "1")
    assert styled("x", "1") == "x"
