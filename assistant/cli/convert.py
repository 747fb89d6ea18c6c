"""Convert a file into another format, by the ending of its new name.

Recordings: .csv, .json, .npz. Tasks: .yaml, .json, .md (a record), .xml (a behavior tree),
.dot (a graph). Transcripts: .yaml, .json, .md (a play). Everything else: .yaml, .json.

example:
  assistant convert pick_and_place.yaml pick_and_place.xml
"""

from __future__ import annotations

import argparse
import sys
from pathlib import Path

from assistant.cli import DONE
from assistant.errors import BadInput


def arguments(parser: argparse.ArgumentParser) -> None:
    """Declare what the verb takes."""
    parser.add_argument("source", type=Path, metavar="IN")
    parser.add_argument("goal", type=Path, metavar="OUT")
    parser.add_argument("--overwrite", action="store_true", help="OUT may exist already")


def run(args: argparse.Namespace) -> int:
    """Convert one file; an existing one is not overwritten unasked."""
    from assistant.files.converting import convert
    from assistant.files.kinds import read_known

    known = read_known(args.source)
    for warning in known.warnings:
        print(f"warning: {warning}", file=sys.stderr)
    if args.goal.is_file() and not args.overwrite and not _same(args.source, args.goal):
        raise BadInput.one(str(args.goal), "exists already", "another name, or --overwrite")
    convert(known, args.source, args.goal)
    return DONE


def _same(source: Path, goal: Path) -> bool:
    """Tell whether a file is to be written again in its stable form."""
    return source.resolve() == goal.resolve()
