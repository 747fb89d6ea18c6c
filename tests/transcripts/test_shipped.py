"""Every shipped transcript is played and goes as it is written."""

from __future__ import annotations

from pathlib import Path

import pytest

from assistant.cli.adapters import make_equipment
from assistant.files.shipped import shipped
from assistant.files.transcripts import read_transcript
from assistant.session.player import Player

TRANSCRIPTS = sorted(
    path
    for path in shipped("transcripts").glob("**/*.yaml")
    if not path.name.endswith(".actual.yaml")
)


@pytest.mark.parametrize("path", TRANSCRIPTS, ids=lambda path: path.stem)
def test_transcript(path: Path, tmp_path: Path) -> None:
    played = Player(read_transcript(path), make_equipment, tmp_path).play()
    assert played.difference is None
