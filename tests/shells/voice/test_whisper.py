"""Whisper tells how well words explain a sound, and reads what was said."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from assistant.shells.voice.mouth import Mouth, Voice
from assistant.shells.voice.sound import RATE_HZ, read_sound
from assistant.shells.voice.whisper import STEP, Whisper, packaged_whisper


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
def test_a_loud_room_is_looked_at_longer_and_all_that_was_said_always_is() -> None:
    folder = packaged_whisper()
    assert folder is not None
    whisper = Whisper(folder, threads=1)
    short, long = (np.zeros(seconds * RATE_HZ, np.float32) for seconds in (1, 17))
    steps = [
        np.array(whisper._encoded(sound, loud)).shape[1]
        for sound, loud in ((short, False), (short, True), (long, True))
    ]
    assert steps[0] < steps[1] < steps[2]
    assert steps[2] * STEP >= len(long)
