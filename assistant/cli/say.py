"""Speak a sentence, aloud or into a WAV file.

example:
  assistant say "show me once" --wav show.wav
"""

from __future__ import annotations

import argparse
from pathlib import Path


def arguments(parser: argparse.ArgumentParser) -> None:
    """Add the sentence and the voice."""
    parser.add_argument("text", nargs="+", metavar="TEXT", help="what to say")
    parser.add_argument("--wav", type=Path, metavar="FILE", help="write it here instead")
    parser.add_argument("--engine", default="", help="espeak-ng, flite or piper")
    parser.add_argument("--voice", default="", help="the engine's name of a voice")
    parser.add_argument("--rate", type=int, default=165, metavar="WPM", help="words a minute")


def run(args: argparse.Namespace) -> int:
    """Speak, and wait until it is said."""
    from assistant.shells.voice.mouth import Mouth, Voice

    mouth = Mouth(Voice(args.engine, args.voice, args.rate))
    text = " ".join(args.text)
    if args.wav:
        mouth.write(text, args.wav)
    else:
        mouth.speak(text)
    return 0
