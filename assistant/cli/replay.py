"""Run scripted sessions without a teacher and compare what happens with what they expect.

A transcript that differs is told with its line; what really happened is written beside it as
NAME.actual.yaml. Of a folder all transcripts below it are run.

example:
  assistant replay transcripts
  assistant replay transcripts/table1.yaml
"""

from __future__ import annotations

import argparse
import json
import sys
from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING

from assistant.cli import DONE, FAILED
from assistant.cli.talking import speaking
from assistant.errors import BadInput, Problem

if TYPE_CHECKING:
    from assistant.model.transcript import Transcript

HEAD = 4096
ACTUAL = ".actual.yaml"


def arguments(parser: argparse.ArgumentParser) -> None:
    """Declare what the verb takes."""
    parser.add_argument(
        "transcripts", nargs="+", type=Path, metavar="TRANSCRIPT", help="a file or a folder"
    )
    parser.add_argument("--speak", action="store_true", help="speak the robot's lines")
    parser.add_argument("--json", action="store_true", help="one JSON line at the end")


def run(args: argparse.Namespace) -> int:
    """Replay them one after another; all are read before the first begins."""
    from assistant.cli.adapters import make_equipment
    from assistant.session.player import silent
    from assistant.shells.replay import replay

    transcripts = _read(_files(args.transcripts))
    listener = speaking(lambda line: print(line, file=sys.stderr)) if args.speak else silent
    results = []
    for transcript in transcripts:
        result = replay(transcript, make_equipment, listener)
        results.append(result)
        if not args.json:
            print(result.told(), file=sys.stdout if result.passed else sys.stderr)
    if args.json:
        print(json.dumps({"transcripts": [result.as_json() for result in results]}))
    return DONE if all(result.passed for result in results) else FAILED


def _read(paths: Sequence[Path]) -> list[Transcript]:
    """Return all transcripts; what is wrong with any is told before the first is played."""
    from assistant.files.references import unknown_in_head
    from assistant.files.transcripts import read_transcript

    read: list[Transcript] = []
    problems: list[Problem] = []
    for path in paths:
        try:
            read.append(read_transcript(path))
            problems += unknown_in_head(read[-1], path)
        except BadInput as error:
            problems += error.problems
    if problems:
        raise BadInput(problems)
    return read


def _files(given: Sequence[Path]) -> tuple[Path, ...]:
    """Return the transcripts given, and those in folders, in the order of their names."""
    found: list[Path] = []
    for path in given:
        if not path.is_dir():
            found.append(path)
            continue
        inside = [each for each in sorted(path.rglob("*.yaml")) if is_transcript(each)]
        if not inside:
            raise BadInput.one(str(path), "no transcript in this folder", "one with transcripts")
        found += inside
    return tuple(found)


def is_transcript(path: Path) -> bool:
    """Whether a file begins as a transcript and is not what a failed play left behind."""
    with path.open("rb") as file:
        head = file.read(HEAD)
    return not path.name.endswith(ACTUAL) and b"format: transcript/" in head
