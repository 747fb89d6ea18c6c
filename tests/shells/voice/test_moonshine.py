"""Moonshine reads what was said, in an utterance of any length, and says nothing for ever."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from assistant.shells.voice.moonshine import (
    BEAM,
    TOKENS_PER_S,
    Moonshine,
    packaged_moonshine,
    read_pieces,
)
from assistant.shells.voice.mouth import Mouth, Voice
from assistant.shells.voice.sound import RATE_HZ, read_sound


def test_pieces_are_read_with_lengths_of_one_byte_or_two() -> None:
    long = b"a" * 300
    told = b"\x02ab" + bytes((128 + 300 % 128, 300 // 128)) + long + b"\x00\x01c"
    assert read_pieces(told) == [b"ab", long, b"", b"c"]


@pytest.mark.voice
def test_what_was_said_is_read_and_noise_ends(tmp_path: Path) -> None:
    folder = packaged_moonshine()
    assert folder is not None
    moonshine = Moonshine(folder)
    path = tmp_path / "said.wav"
    Mouth(Voice("flite", "slt")).write("open the hand", path)
    assert moonshine.recognize(read_sound(path).samples)[0].text == "open the hand"
    noise = 0.3 * np.random.default_rng(1).standard_normal(RATE_HZ).astype(np.float32)
    told = moonshine.recognize(noise)
    assert sum(len(one.text.split()) for one in told) <= TOKENS_PER_S + 2


@pytest.mark.voice
def test_what_else_may_have_been_read_comes_behind_what_was(tmp_path: Path) -> None:
    folder = packaged_moonshine()
    assert folder is not None
    moonshine = Moonshine(folder)
    path = tmp_path / "said.wav"
    Mouth(Voice("flite", "slt")).write("go slower", path)
    said = read_sound(path).samples
    noise = 0.03 * np.random.default_rng(2).standard_normal(len(said)).astype(np.float32)
    told = moonshine.reread(said + noise)
    assert 1 < len(told) <= BEAM
    assert len({one.text for one in told}) == len(told)
    assert sorted((one.sure for one in told), reverse=True) == [one.sure for one in told]
    assert sum(one.sure for one in told) <= 1.0
    assert moonshine.recognize(said + noise)[0].text in {one.text for one in told}
