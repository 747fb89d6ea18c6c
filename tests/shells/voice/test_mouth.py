"""A sentence that nobody could hear is not taken for spoken."""

from __future__ import annotations

import stat
from pathlib import Path

import pytest

from assistant.errors import BadInput
from assistant.shells.voice.mouth import Mouth, Voice


@pytest.mark.parametrize(
    ("script", "spoken"),
    [
        ("exit 0", True),
        ("echo 'ALSA lib pcm.c: Unknown PCM' >&2; echo 'error: No such file' >&2; exit 0", False),
        ("exit 1", False),
    ],
)
def test_without_a_loudspeaker_speaking_fails(
    script: str, spoken: bool, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    engine = tmp_path / "espeak-ng"
    engine.write_text(f"#!/bin/sh\n{script}\n")
    engine.chmod(engine.stat().st_mode | stat.S_IXUSR)
    monkeypatch.setenv("PATH", str(tmp_path), prepend=":")
    mouth = Mouth(Voice("espeak-ng"))
    if spoken:
        mouth.speak("hello")
        return
    with pytest.raises(BadInput, match="could not speak aloud"):
        mouth.speak("hello")
