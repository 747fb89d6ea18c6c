"""A play spoken aloud goes on without a loudspeaker, and tells so once."""

from __future__ import annotations

import pytest

from assistant.cli.talking import speaking
from assistant.errors import BadInput
from assistant.shells.voice import mouth


def test_without_a_loudspeaker_lines_are_shown_only(monkeypatch: pytest.MonkeyPatch) -> None:
    tried: list[str] = []

    class Silent:
        def speak(self, text: str) -> None:
            tried.append(text)
            raise BadInput.one("voice", "nothing to speak with", "plug it in")

    monkeypatch.setattr(mouth, "Mouth", Silent)
    shown: list[str] = []
    listen = speaking(shown.append)
    for who, words in (("robot", "Hello."), ("teacher", "hi"), ("robot", "Goodbye.")):
        listen(who, words)
    assert shown[0] == "robot: Hello."
    assert shown[2:] == ["teacher: hi", "robot: Goodbye."]
    assert "nothing to speak with" in shown[1]
    assert tried == ["Hello."]
