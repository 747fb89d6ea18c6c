"""What was said often is likely; chances of what comes next sum to one at most; arrays keep all."""

from __future__ import annotations

from math import exp
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from assistant.shells.voice import wording as module
from assistant.shells.voice.wording import RARE, arrays, counted, wording

SAID = ("go up", "go up a bit", "go down", "a bit more", "open the hand")
KNOWN = sorted({word for text in SAID for word in text.split()})


@given(st.lists(st.sampled_from([*KNOWN, "unheard"]), max_size=4))
def test_chances_of_what_comes_next_sum_to_at_most_one(before: list[str]) -> None:
    told = counted(SAID)
    start = told.numbered(" ".join(before))[:-1]
    chances = sum(told._next((*start, one)) for one in range(told.base))
    # Something is kept back for words that were never counted.
    assert 0.5 < chances <= 1.0 + told.base * RARE


def test_what_was_said_is_likelier_than_the_same_words_in_disorder() -> None:
    told = counted(SAID)
    assert told.likelihood("go up a bit") > told.likelihood("bit a up go")
    assert told.likelihood("go up") > told.likelihood("go sideways")
    assert 0.0 < exp(told.likelihood("go up")) < 1.0


def test_arrays_keep_what_was_counted(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    told = counted(SAID)
    np.savez_compressed(tmp_path / "wording.npz", allow_pickle=False, **arrays(told))
    monkeypatch.setattr(module, "files", lambda package: tmp_path)
    again = wording.__wrapped__("english")
    assert again is not None
    for text in (*SAID, "go sideways", ""):
        assert again.likelihood(text) == told.likelihood(text)


def test_teachers_speak_of_their_work() -> None:
    told = wording("english")
    assert told is not None
    each = [
        told.likelihood(text) / (len(text.split()) + 1)
        for text in ("move a bit more to the left", "the soup needs a bit more pepper")
    ]
    assert each[0] > each[1] + 1.0
    assert wording("german") is None
