"""Every shipped transcript is played and goes as it is written."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest

from assistant.cli.adapters import make_equipment
from assistant.files.shipped import shipped
from assistant.files.transcripts import read_transcript
from assistant.language import hints
from assistant.session.player import Player

TRANSCRIPTS = sorted(
    path
    for path in shipped("transcripts").glob("**/*.yaml")
    if not path.name.endswith(".actual.yaml")
)


def only(language: str, monkeypatch: pytest.MonkeyPatch) -> None:
    """Have every look into the hints of another language fail."""
    pages = hints.page

    def page(name: str, asked: str = "english") -> Any:
        assert asked == language, f"a {language} lesson looks into the {asked} {name}"
        return pages(name, asked)

    monkeypatch.setattr(hints, "page", page)


@pytest.mark.parametrize("path", TRANSCRIPTS, ids=lambda path: path.stem)
def test_transcript(path: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    transcript = read_transcript(path)
    only(transcript.language, monkeypatch)
    played = Player(transcript, make_equipment, tmp_path).play()
    assert played.difference is None
