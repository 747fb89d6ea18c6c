"""Recognized words in one form, whatever recognizer wrote them; what is spelled is a word."""

from __future__ import annotations

import pytest

from assistant.shells.voice.recognized import Recognized, merged, plain_words


@pytest.mark.parametrize(
    ("written", "words"),
    [
        ("Move a bit, to the LEFT!", "move a bit to the left"),
        ("It's called pick-and-place.", "it's called pick and place"),
        ("B-L-O-C-K.", "block"),
        ("R. E. D. block", "red block"),
        ("call it b l u e", "call it blue"),
        ("a b", "a b"),
        ("1.5 mm", "1.5 mm"),
        ("", ""),
    ],
)
def test_words_are_plain(written: str, words: str) -> None:
    assert plain_words(written) == words


def test_readings_of_the_same_words_are_one() -> None:
    told = merged([("go", 0.2), ("no", 0.3), ("go", 0.2), ("", 0.9), ("stop", 0.9), ("stop", 0.9)])
    assert told == (Recognized("stop", 1.0), Recognized("go", 0.4), Recognized("no", 0.3))
