"""Sound of every rate comes out the same; what is no sound is refused in words."""

from __future__ import annotations

import wave
from pathlib import Path

import numpy as np
import pytest

from assistant.errors import BadInput
from assistant.shells.voice.sound import RATE_HZ, Sound, read_sound, to_16k_mono, write_sound

pytestmark = pytest.mark.voice


def tone(rate_hz: int, seconds: float = 0.5) -> np.ndarray:
    return 0.4 * np.sin(2 * np.pi * 440 * np.arange(round(rate_hz * seconds)) / rate_hz)


@pytest.mark.parametrize("rate_hz", [8_000, 16_000, 22_050, 44_100, 48_000])
def test_any_rate_becomes_the_same_sound(rate_hz: int) -> None:
    expected = tone(RATE_HZ)
    heard = to_16k_mono(tone(rate_hz), rate_hz)
    middle = slice(800, 7200)
    assert np.max(np.abs(heard[middle] - expected[: len(heard)][middle])) < 0.01


def test_stereo_is_mixed() -> None:
    both = np.stack([tone(RATE_HZ), np.zeros(RATE_HZ // 2)], axis=1)
    assert np.allclose(to_16k_mono(both, RATE_HZ), tone(RATE_HZ) / 2, atol=1e-6)


@pytest.mark.parametrize("ending", [".wav", ".flac"])
def test_what_was_written_is_read(tmp_path: Path, ending: str) -> None:
    path = tmp_path / f"tone{ending}"
    write_sound(path, Sound(tone(RATE_HZ).astype(np.float32)))
    assert np.allclose(read_sound(path).samples, tone(RATE_HZ), atol=1e-4)


def test_a_part_keeps_its_time() -> None:
    part = Sound(np.zeros(RATE_HZ, np.float32), from_s=3.0).cut(0.25, 0.5)
    assert part.from_s == pytest.approx(3.25)
    assert part.duration_s == pytest.approx(0.25)


def test_a_text_file_named_wav_is_refused(tmp_path: Path) -> None:
    path = tmp_path / "note.wav"
    path.write_text("move left")
    with pytest.raises(BadInput, match=r"note\.wav: this is not a sound file; a WAV or FLAC"):
        read_sound(path)


def test_a_missing_file_is_refused(tmp_path: Path) -> None:
    with pytest.raises(BadInput, match="no such file"):
        read_sound(tmp_path / "none.wav")


def test_an_empty_wav_is_silence(tmp_path: Path) -> None:
    path = tmp_path / "empty.wav"
    with wave.open(str(path), "wb") as file:
        file.setnchannels(1)
        file.setsampwidth(2)
        file.setframerate(RATE_HZ)
        file.writeframes(b"")
    assert len(read_sound(path).samples) == 0
