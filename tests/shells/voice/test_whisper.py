"""Whisper tells how well words explain a sound, and reads what was said."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from assistant.shells.voice.mouth import Mouth, Voice
from assistant.shells.voice.sound import read_sound
from assistant.shells.voice.whisper import Whisper, packaged_whisper


@pytest.mark.voice
def test_what_was_said_explains_the_sound_best(tmp_path: Path) -> None:
    folder = packaged_whisper()
    assert folder is not None
    path = tmp_path / "said.wav"
    Mouth(Voice("flite", "slt")).write("open the hand", path)
    quiet = np.zeros(4000, np.float32)
    sound = np.concatenate([quiet, read_sound(path).samples, quiet])
    whisper = Whisper(folder, threads=1)
    phrases = ("open the hand", "close the hand", "open", "stop")
    told = whisper.likelihoods(sound, phrases)
    assert max(zip(told, phrases, strict=True))[1] == "open the hand"
    assert all(one <= 0.0 for one in told)
    assert whisper.recognize(sound)[0].text == "open the hand"


@pytest.mark.voice
def test_a_few_words_in_a_loud_room_are_told_from_others(tmp_path: Path) -> None:
    # Looking at no more of the sound than was said makes such a model half deaf.
    folder = packaged_whisper()
    assert folder is not None
    path = tmp_path / "said.wav"
    Mouth(Voice("flite", "slt")).write("show setup", path)
    said = read_sound(path).samples
    sound = np.pad(said, 3000)
    loudness = np.sqrt(np.mean(said**2) / 10.0)
    sound += (loudness * np.random.default_rng(3).standard_normal(len(sound))).astype(np.float32)
    told = Whisper(folder, threads=1).likelihoods(sound, ("show setup", "go", "help"), loud=True)
    assert told[0] > max(told[1:]) + 2.0
