"""Repair of spelling: the same words come to the same in every process."""

from __future__ import annotations

import os
import subprocess
import sys

_PRINTED = """
from assistant.language.phrasebook import phrasebook
from assistant.language.repair import respelled
from assistant.language.words import words_of

book = phrasebook("english")
for text in ("the cone shaped thing", "sear then rest", "gie it anoter go", "sealing", "rost"):
    heard = respelled(words_of(text, book.contractions), book, ("pane", "bone"))
    print(" ".join(word.text for word in heard))
"""


def test_no_order_of_a_set_decides_which_of_many_near_words_is_meant() -> None:
    told = {
        subprocess.run(
            [sys.executable, "-c", _PRINTED],
            env={**os.environ, "PYTHONHASHSEED": seed},
            check=True,
            capture_output=True,
            text=True,
        ).stdout
        for seed in ("1", "5", "8")
    }
    assert len(told) == 1
    assert len(told.pop().splitlines()) == 5
