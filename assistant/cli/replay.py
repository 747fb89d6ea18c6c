"""Run scripted sessions without a teacher and compare what happens with what they expect.

A transcript that differs is told with its line; what really happened is written beside it as
NAME.actual.yaml.

example:
  assistant replay transcripts/*.yaml
"""

from __future__ import annotations

import argparse
import json
import sys
from pathlib import Path

from assistant.cli import DONE, FAILED
from assistant.cli.talking import speaking


def arguments(parser: argparse.ArgumentParser) -> None:
    """Declare what the verb takes."""
    parser.add_argument("transcripts", nargs="+", type=Path, metavar="TRANSCRIPT")
    parser.add_argument("--speak", action="store_true", help="speak the robot's lines")
    parser.add_argument("--json", action="store_true", help="one JSON line at the end")


def run(args: argparse.Namespace) -> int:
    """Replay them one after another; all are read before the first begins."""
    from assistant.cli.adapters import make_equipment
    from assistant.files.transcripts import read_transcript
    from assistant.session.player import silent
    from assistant.shells.replay import replay

    transcripts = [read_transcript(path) for path in args.transcripts]
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
