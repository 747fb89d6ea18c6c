from __future__ import annotations

import json
from pathlib import Path

import pytest

from assistant.cli import main
from assistant.files.transcripts import read_transcript
from tests.session.lessons import hold, opened


def test_sessions_are_listed(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setenv("ASSISTANT_HOME", str(tmp_path))
    assert main(["sessions"]) == 0
    assert "no sessions yet" in capsys.readouterr().out
    session = opened(tmp_path)
    session.hear("pick and place")
    session.close()
    assert main(["sessions"]) == 0
    assert " 1 line " in capsys.readouterr().out
    assert main(["sessions", "--json"]) == 0
    (past,) = json.loads(capsys.readouterr().out)["sessions"]
    assert past["name"] == "1"


def test_a_journal_can_be_kept_as_a_test(tmp_path: Path) -> None:
    session = opened(tmp_path)
    hold(session)
    session.close()
    journal = tmp_path / "sessions" / "1" / "journal.yaml"
    assert read_transcript(journal).title == "a lesson"
    assert main(["replay", str(journal)]) == 0
