"""The loop test: a sentence spoken aloud and heard, and the same by a file."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import numpy as np
import pytest

from assistant.cli import main
from assistant.cli import voice as verb
from assistant.errors import BadInput
from assistant.model.listening import Listening, Understanding
from assistant.model.teacher_acts import Approve, Unknown
from assistant.shells.voice import clips, devices, mouth
from assistant.shells.voice.endpointing import FRAME
from assistant.shells.voice.sound import RATE_HZ, Samples, Sound, write_sound

pytestmark = pytest.mark.voice

SPOKEN_FRAMES = 5


class Reads:
    """Understands any sound that is not silent."""

    def read(self, sound: Sound, listening: Listening) -> Understanding:
        if not np.any(sound.samples):
            return Understanding((Unknown(),), 1.0, "")
        return Understanding((Approve(),), 0.9, f"good {len(sound.samples) / RATE_HZ:.1f}")


class Speaks:
    """Speaks for a few frames, as loud as it is told."""

    engine = "engine"

    def __init__(self) -> None:
        self.left = 0

    @property
    def speaking(self) -> bool:
        self.left -= 1
        return self.left >= 0

    def say(self, text: str) -> None:
        self.left = SPOKEN_FRAMES

    def write(self, text: str, path: Path) -> None:
        write_sound(path, Sound(np.full(RATE_HZ, 0.5, np.float32)))


def looped(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str], loud: float | None
) -> tuple[list[str], str]:
    """Return what the loop test says of a room so loud, or without microphone, and its errors."""

    def check() -> None:
        if loud is None:
            raise BadInput.one("voice", "no microphone is there", "plug one in")

    def frames() -> Iterator[Samples]:
        while True:
            yield np.full(FRAME, loud, np.float32)

    monkeypatch.setattr(clips, "ClipReader", Reads)
    monkeypatch.setattr(mouth, "Mouth", Speaks)
    monkeypatch.setattr(devices, "check_microphone", check)
    monkeypatch.setattr(devices, "microphone_frames", frames)
    monkeypatch.setattr(verb, "inventory", dict)
    assert main(["voice", "--loop", "good"]) == 0
    told = capsys.readouterr()
    return told.out.splitlines(), told.err


def test_a_sentence_is_heard_through_the_air_to_its_end_and_by_a_file(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    (air, file), errors = looped(monkeypatch, capsys, 0.2)
    whole_s = (1 + SPOKEN_FRAMES) * FRAME / RATE_HZ + verb.AFTER_S
    assert f'through the air heard "good {whole_s:.1f}": approve (0.90)' in air
    assert 'said "good"; heard "good 1.0"' in file
    assert errors == ""


def test_a_microphone_that_hears_nothing_is_told_from_an_engine_that_says_nothing(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    (air, file), _ = looped(monkeypatch, capsys, 0.0)
    assert air.endswith("through the air heard nothing")
    assert "approve" in file


def test_without_a_microphone_the_file_is_heard(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    (file,), errors = looped(monkeypatch, capsys, None)
    assert "approve" in file
    assert "not through the air" in errors
    assert "no microphone is there" in errors
