"""List the sessions that can be resumed, the newest last.

example:
  assistant sessions
  assistant teach --resume 3
"""

from __future__ import annotations

import argparse
import json
from dataclasses import asdict
from datetime import datetime

from assistant.cli import DONE


def arguments(parser: argparse.ArgumentParser) -> None:
    """Declare what the verb takes."""
    parser.add_argument("--json", action="store_true", help="one JSON line")


def run(args: argparse.Namespace) -> int:
    """List them."""
    from assistant.files.home import home_to_look_into
    from assistant.session.past import past_sessions

    folder = home_to_look_into() / "sessions"
    found = past_sessions(folder)
    if args.json:
        print(json.dumps({"sessions": [asdict(past) for past in found]}))
        return DONE
    if not found:
        print(f"no sessions yet in {folder}; begin one: assistant teach")
    for past in found:
        when = datetime.fromtimestamp(past.changed_s).strftime("%Y-%m-%d %H:%M")
        lines = f"{past.lines:3d} line{' ' if past.lines == 1 else 's'}"
        print(f"{past.name:>4}  {when}  {past.trouble or f'{lines}  {_short(past.last)}'}".rstrip())
    return DONE


def _short(text: str) -> str:
    from assistant.files.wording import one_line

    text = one_line(text)
    return text if len(text) <= 60 else text[:57] + "..."
