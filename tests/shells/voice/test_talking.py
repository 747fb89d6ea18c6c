"""Beside a shell: a sound file is heard to its end; what is missing is one line."""

from __future__ import annotations

import threading
from collections.abc import Callable, Iterator
from pathlib import Path

import numpy as np
import pytest

from assistant.cli.adapters import make_equipment
from assistant.errors import BadInput
from assistant.language.understanding import understand
from assistant.model.listening import Listening
from assistant.model.robot_acts import RobotAct
from assistant.model.transcript import Transcript
from assistant.session.loop import Session
from assistant.session.opening import Opening, open_session
from assistant.shells.beside import Words
from assistant.shells.plain import PlainShell
from assistant.shells.voice import talking
from assistant.shells.voice.deciding import Heard
from assistant.shells.voice.ears import Ears
from assistant.shells.voice.endpointing import Endpointer, frames_in
from assistant.shells.voice.sound import RATE_HZ, Samples, Sound, read_sound, write_sound
from assistant.shells.voice.talking import Talking, TalkSettings

pytestmark = pytest.mark.voice


class Says:
    """Hears one sentence after the other, whatever is said."""

    def __init__(self, *sentences: str) -> None:
        self._sentences = iter(sentences)

    def hear(self, samples: Samples, listening: Listening) -> Heard:
        text = next(self._sentences, "")
        return Heard(text, understand(text, listening))


def loudness(frame: Samples) -> float:
    return float(np.abs(frame).max() > 0.1)


def bursts(path: Path, count: int) -> Path:
    quiet, loud = np.zeros(RATE_HZ, np.float32), np.full(RATE_HZ // 2, 0.5, np.float32)
    write_sound(path, Sound(np.concatenate([np.concatenate([quiet, loud])] * count + [quiet])))
    return path


def hold(folder: Path, beside: Talking, told: list[str], *lines: str) -> None:
    shell = PlainShell(told.append)

    def out(line: RobotAct, text: str) -> None:
        shell.out(line, text)
        beside.out(line, text)

    session = open_session(Opening(make_equipment, folder, out), Transcript("by ear"))
    shell.run(session, iter(lines), live=False, beside=beside)
    session.close()


def test_a_sound_file_is_heard_to_its_end(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    says = Says("pick and place", "yes", "the block rests on the target")

    def ears(self: Talking, session: Session, take: Callable[[Words], None]) -> Ears:
        return Ears(session, take, Endpointer(loudness), says)

    monkeypatch.setattr(talking.Talking, "_ears", ears)
    told: list[str] = []
    settings = TalkSettings(bursts(tmp_path / "said.wav", 3), mute=True, real_time=False)
    hold(tmp_path, Talking(settings, told.append), told)
    assert "right?" in told[told.index("you: pick and place") + 1]
    assert "you: the block rests on the target" in told
    assert "Which things" in told[told.index("you: the block rests on the target") + 1]


def test_a_microphone_unplugged_mid_word_is_told_and_heard_again_once_plugged_in(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    said = frames_in([read_sound(bursts(tmp_path / "said.wav", 1))])
    plugged = threading.Event()

    def frames(self: Talking, session: object) -> Iterator[Samples]:
        if not plugged.is_set():
            plugged.set()
            yield np.full(512, 0.5, np.float32)
            raise BadInput.one("voice", "the microphone fell silent", "plug it in again")
        yield from said
        while not heard.is_set():
            yield np.zeros(512, np.float32)

    def ears(self: Talking, session: Session, take: Callable[[Words], None]) -> Ears:
        def taken(words: Words) -> None:
            take(words)
            heard.set()

        return Ears(session, taken, Endpointer(loudness), Says("pick and place"))

    heard = threading.Event()
    monkeypatch.setattr(talking.Talking, "_frames", frames)
    monkeypatch.setattr(talking.Talking, "_ears", ears)
    monkeypatch.setattr(talking, "AGAIN_S", 0.0)
    told: list[str] = []

    def lines() -> Iterator[str]:
        heard.wait(10.0)
        yield "quit\n"
        yield "no\n"

    session = open_session(
        Opening(make_equipment, tmp_path, lambda line, text: None), Transcript("by ear")
    )
    beside = Talking(TalkSettings(mute=True), told.append)
    PlainShell(told.append).run(session, lines(), live=False, beside=beside)
    session.close()
    lost = next(at for at, line in enumerate(told) if "the microphone fell silent" in line)
    assert lost < told.index("  (listening again)") < told.index("you: pick and place")


def test_a_shell_that_ends_closes_the_microphone(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    opened, closed = threading.Event(), threading.Event()

    def frames(self: Talking, session: object) -> Iterator[Samples]:
        try:
            while True:
                opened.set()
                yield np.zeros(512, np.float32)
        finally:
            closed.set()

    def ears(self: Talking, session: Session, take: Callable[[Words], None]) -> Ears:
        return Ears(session, take, Endpointer(loudness), Says())

    monkeypatch.setattr(talking.Talking, "_frames", frames)
    monkeypatch.setattr(talking.Talking, "_ears", ears)

    def lines() -> Iterator[str]:
        assert opened.wait(10.0)
        yield "help\n"

    session = open_session(
        Opening(make_equipment, tmp_path, lambda line, text: None), Transcript("by ear")
    )
    told: list[str] = []
    beside = Talking(TalkSettings(mute=True), told.append)
    PlainShell(told.append).run(session, lines(), live=False, beside=beside)
    assert closed.is_set()
    session.close()


def test_without_a_microphone_typing_goes_on(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    def none(self: Talking, session: object) -> object:
        raise BadInput.one("voice", "no microphone is there", "plug one in")

    monkeypatch.setattr(talking.Talking, "_frames", none)
    told: list[str] = []
    hold(tmp_path, Talking(TalkSettings(mute=True), told.append), told, "pick and place\n")
    assert any(line.endswith("plug one in; the keyboard works on)") for line in told)
    assert any("goal" in line or "should be the case" in line for line in told)
