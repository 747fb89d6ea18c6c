from __future__ import annotations

import pytest

from assistant.shells.telling import terminal, view
from tests.files import examples


@pytest.mark.parametrize(("no_color", "plain"), [("1", True), ("", False)])
def test_no_color_leaves_no_sign_for_the_terminal(
    no_color: str, plain: bool, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setenv("NO_COLOR", no_color)
    monkeypatch.setenv("FORCE_COLOR", "1")
    monkeypatch.setenv("TERM", "xterm")
    terminal().print(view(examples.task(examples.lesson())))
    told = capsys.readouterr().out
    assert "learned from a.yaml" in told
    assert ("\x1b" not in told) == plain
