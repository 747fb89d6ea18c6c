"""Not built yet: this verb needs the voice shell.

example:
  assistant hear --help
"""

from __future__ import annotations

import argparse

from assistant.errors import BadInput


def arguments(parser: argparse.ArgumentParser) -> None:
    """Accept what the finished verb will take."""
    parser.add_argument("words", nargs="*")
    parser.add_argument("--stage")
    parser.add_argument("--asked")
    parser.add_argument("--wav")
    parser.add_argument("--json", action="store_true")


def run(args: argparse.Namespace) -> int:
    """Say that there is no voice yet."""
    raise BadInput.one(
        "assistant hear", "voice is not built yet", "the typed dialogue is: assistant teach"
    )
