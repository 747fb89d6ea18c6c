"""Show a file for people: a tree, lesson, demonstration, setup, scene or transcript.

example:
  assistant show tasks/pick_and_place.yaml
  assistant show tasks/demonstrations/pick_and_place.yaml --figures figures
"""

from __future__ import annotations

import argparse
import json
import sys
from pathlib import Path
from typing import TYPE_CHECKING

from assistant.cli import DONE
from assistant.cli.naming import must_be_learned, task_path
from assistant.errors import BadInput

if TYPE_CHECKING:
    from assistant.files.kinds import Value


def arguments(parser: argparse.ArgumentParser) -> None:
    """Declare what the verb takes."""
    parser.add_argument("file", type=Path, metavar="FILE", help="a file, or a kept task's name")
    parser.add_argument("--figures", type=Path, metavar="DIR", help="also draw figures there")
    parser.add_argument("--json", action="store_true", help="the values as one JSON line")


def run(args: argparse.Namespace) -> int:
    """Show the file."""
    from assistant.files.kinds import read_known
    from assistant.files.plain import plain_values

    path = task_path(args.file)
    known = read_known(path)
    for warning in known.warnings:
        print(f"warning: {warning}", file=sys.stderr)
    figures = () if args.figures is None else _draw(known.value, path, args.figures)
    if args.json:
        print(json.dumps(plain_values(known.value, known.recording)))
    else:
        from assistant.shells.telling import terminal, view

        terminal().print(view(known.value))
    for drawn in figures:
        print(f"wrote {drawn}", file=sys.stderr)
    return DONE


def _draw(value: Value, path: Path, folder: Path) -> tuple[Path, ...]:
    from assistant.model.demonstration import Demonstration, Recording
    from assistant.model.task import Task
    from assistant.shells.figures import write_figures
    from assistant.shells.recording_figure import write_recording_figure

    match value:
        case Task():
            return write_figures(must_be_learned(value, path), folder)
        case Demonstration():
            spoken = (*value.cues, *value.key_states)
            return write_recording_figure(value.recording, spoken, folder)
        case Recording():
            return write_recording_figure(value, (), folder)
        case _:
            right = "a learned task, a demonstration or a recording"
            raise BadInput.one("--figures", "there are no figures of such a file", right)
