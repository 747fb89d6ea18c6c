"""Microphones and loudspeakers through PortAudio, with its errors put into words."""

from __future__ import annotations

import os
import queue
import sys
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from importlib import import_module
from types import ModuleType

import numpy as np

from assistant.errors import BadInput
from assistant.shells.voice.endpointing import FRAME
from assistant.shells.voice.sound import RATE_HZ, Samples

_LIBRARY = "apt install libportaudio2, or the PortAudio of your system"
_PLUG = "plug one in; assistant voice lists what is there"
OPENS_WITHIN_S = 10.0
UNPLUGGED_AFTER_S = 3.0
STDERR = 2


@dataclass(frozen=True, slots=True)
class Device:
    """A sound device; the default one for its direction is marked."""

    name: str
    inputs: int
    outputs: int
    default: bool


def devices() -> tuple[Device, ...]:
    """Return the sound devices of this machine, perhaps none.

    Raises
    ------
    BadInput
        If PortAudio is missing.
    """
    sound = _portaudio()
    defaults = {index for index in sound.default.device if index >= 0}
    return tuple(
        Device(
            told["name"], told["max_input_channels"], told["max_output_channels"], at in defaults
        )
        for at, told in enumerate(sound.query_devices())
    )


def check_microphone() -> None:
    """Raise BadInput if this machine has nothing to hear with."""
    if not any(device.inputs for device in devices()):
        raise BadInput.one("voice", "no microphone is there", _PLUG)


def microphone_frames(device: str | int | None = None) -> Iterator[Samples]:
    """Yield frames of 512 samples as they are heard.

    Raises
    ------
    BadInput
        If there is no microphone, or it was unplugged.
    """
    sound = _portaudio()
    heard: queue.Queue[Samples] = queue.Queue()

    def keep(samples: Samples, *_: object) -> None:
        heard.put(np.array(samples[:, 0]))

    try:
        with _without_chatter():
            stream = sound.InputStream(
                samplerate=RATE_HZ,
                channels=1,
                dtype="float32",
                blocksize=FRAME,
                device=device,
                callback=keep,
            )
        with stream:
            # A device may take its time to open; once it has spoken it never pauses.
            yield heard.get(timeout=OPENS_WITHIN_S)
            while True:
                yield heard.get(timeout=UNPLUGGED_AFTER_S)
    except queue.Empty as error:
        raise BadInput.one("voice", "the microphone fell silent", "plug it in again") from error
    except (sound.PortAudioError, ValueError) as error:
        raise BadInput.one("voice", f"no microphone: {error}", _PLUG) from error


def _portaudio() -> ModuleType:
    try:
        with _without_chatter():
            return import_module("sounddevice")
    except (ImportError, OSError) as error:
        raise BadInput.one("voice", "PortAudio is not installed", _LIBRARY) from error


@contextmanager
def _without_chatter() -> Iterator[None]:
    """Keep what the system's sound libraries write by themselves off the teacher's screen.

    They tell of every device that cannot be opened, past Python; what matters comes as an error.
    """
    sys.stderr.flush()
    kept = os.dup(STDERR)
    nowhere = os.open(os.devnull, os.O_WRONLY)
    try:
        os.dup2(nowhere, STDERR)
        yield
    finally:
        os.dup2(kept, STDERR)
        os.close(kept)
        os.close(nowhere)
