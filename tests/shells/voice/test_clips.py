"""Sound files from the command line: what was said is understood, silence is nothing."""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np
import pytest

from assistant.cli import main
from assistant.shells.voice.sound import RATE_HZ, Sound, write_sound

pytestmark = pytest.mark.voice


def test_a_sentence_said_is_heard(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    said, silent = tmp_path / "said.wav", tmp_path / "silent.wav"
    assert main(["say", "open the hand", "--wav", str(said), "--engine", "espeak-ng"]) == 0
    write_sound(silent, Sound(np.zeros(2 * RATE_HZ, np.float32)))
    assert main(["hear", str(said), str(silent), "--json"]) == 0
    lines = [json.loads(line) for line in capsys.readouterr().out.splitlines()]
    assert lines[0]["acts"] == [{"act": "gripper", "command": "open"}]
    assert lines[1]["acts"] == [{"act": "unknown"}]
    assert lines[1]["heard"] == ""


def test_what_is_no_sound_ends_with_2(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    text = tmp_path / "note.wav"
    text.write_text("move left")
    assert main(["hear", str(text)]) == 2
    assert "this is not a sound file" in capsys.readouterr().err


def test_engines_and_models_are_listed(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["voice", "--json"]) == 0
    told = json.loads(capsys.readouterr().out)
    assert "espeak-ng" in told["speech engines"]
    assert any("moonshine" in model for model in told["recognizers"])
