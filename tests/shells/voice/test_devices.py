"""Microphones through PortAudio: frames as they are heard, and its errors put into words."""

from __future__ import annotations

import os
import sys
from collections.abc import Callable
from types import SimpleNamespace

import numpy as np
import pytest

from assistant.errors import BadInput
from assistant.shells.voice import devices
from assistant.shells.voice.endpointing import FRAME
from assistant.shells.voice.sound import Samples


class PortAudioError(Exception):
    """As PortAudio's binding raises it."""


class Plugged:
    """A microphone that hears a few frames, then nothing."""

    def __init__(self, *, callback: Callable[..., None], **form: object) -> None:
        os.write(2, b"ALSA lib: so many words\n")
        self._callback = callback

    def __enter__(self) -> None:
        for loud in (0.1, 0.2):
            self._callback(np.full((FRAME, 1), loud, np.float32), FRAME, None, None)

    def __exit__(self, *_: object) -> None:
        pass


def broken(**form: object) -> Plugged:
    os.write(2, b"Expression failed in pa_linux_alsa.c\n")
    raise PortAudioError("Device unavailable")


def portaudio(
    monkeypatch: pytest.MonkeyPatch, stream: Callable[..., Plugged], *inputs: int
) -> None:
    told = [
        {"name": f"device {at}", "max_input_channels": one, "max_output_channels": 2}
        for at, one in enumerate(inputs)
    ]
    library = SimpleNamespace(
        PortAudioError=PortAudioError,
        InputStream=stream,
        query_devices=lambda: told,
        default=SimpleNamespace(device=[0, 1]),
    )
    monkeypatch.setitem(sys.modules, "sounddevice", library)
    monkeypatch.setattr(devices, "UNPLUGGED_AFTER_S", 0.01)


def test_what_is_heard_comes_frame_by_frame_until_the_microphone_is_unplugged(
    monkeypatch: pytest.MonkeyPatch, capfd: pytest.CaptureFixture[str]
) -> None:
    portaudio(monkeypatch, Plugged)
    frames = devices.microphone_frames()
    heard: list[Samples] = [next(frames), next(frames)]
    assert [one.shape for one in heard] == [(FRAME,), (FRAME,)]
    assert [float(one[0]) for one in heard] == pytest.approx([0.1, 0.2])
    with pytest.raises(BadInput, match="the microphone fell silent"):
        next(frames)
    assert capfd.readouterr().err == ""


def test_a_microphone_that_does_not_open_is_one_line(
    monkeypatch: pytest.MonkeyPatch, capfd: pytest.CaptureFixture[str]
) -> None:
    portaudio(monkeypatch, broken)
    with pytest.raises(BadInput, match="Device unavailable"):
        next(devices.microphone_frames())
    assert capfd.readouterr().err == ""
    os.write(2, b"heard again\n")
    assert capfd.readouterr().err == "heard again\n"


def test_a_machine_without_microphone_is_told_apart_from_one_with(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    portaudio(monkeypatch, Plugged, 1, 0)
    devices.check_microphone()
    assert [one.default for one in devices.devices()] == [True, True]
    portaudio(monkeypatch, Plugged, 0)
    with pytest.raises(BadInput, match="no microphone is there"):
        devices.check_microphone()
