"""Finds the verb, runs it, and turns errors into one line and a status.

Only the verb that was asked for is imported, so that help comes at once.
"""

from __future__ import annotations

import argparse
import importlib
import os
import sys
import traceback
from collections.abc import Sequence
from typing import Any, NoReturn

from assistant.cli import BAD_INPUT, DONE, FAILED, streams
from assistant.errors import AssistantError, BadInput, Problem, WorkFailed

VERBS = {
    "teach": "teach the robot in an interactive session (the default)",
    "demo": "see a whole lesson: taught from the shipped transcript, practiced on Table I",
    "replay": "run scripted sessions without a teacher",
    "learn": "learn from demonstrations without dialogue",
    "adapt": "compute the path of the hand for a setup",
    "practice": "carry out a learned task and measure the alignment",
    "evaluate": "measure success over random reachable setups",
    "understand": "tell what a sentence means",
    "hear": "recognize and understand sound files",
    "say": "speak a sentence",
    "voice": "list sound devices and engines, and test them",
    "show": "show a tree, lesson, demonstration or setup for people",
    "check": "validate files",
    "convert": "convert between formats, by ending",
    "tasks": "list, show or delete learned tasks",
    "sessions": "list sessions that can be resumed",
}


class Parser(argparse.ArgumentParser):
    """An argument parser whose complaint is one line and status 2."""

    def error(self, message: str) -> NoReturn:
        """Say what is wrong and where help is, then leave with status 2."""
        self.exit(BAD_INPUT, f"{self.prog}: {message}; see {self.prog} --help\n")

    def exit(self, status: int = 0, message: str | None = None) -> NoReturn:
        """Leave, once help has been written."""
        streams.flush()
        super().exit(status, message)


def run_verb(argv: Sequence[str]) -> int:
    """Run the verb some words name, and return its exit status."""
    words = list(argv)
    os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")
    if not words or (words[0].startswith("-") and words[0] not in ("-h", "--help", "--version")):
        words.insert(0, "teach")
    streams.prepare()
    try:
        status = _run(words)
        streams.flush()
    except BrokenPipeError:
        # The reader has left (`| head`): nobody is there to be told.
        streams.silence()
        return DONE
    except (SystemExit, KeyboardInterrupt):
        raise
    except BaseException as error:  # the panic of a library written in Rust is no Exception
        return _ended(error, words[0])
    return status


def _ended(error: BaseException, verb: str) -> int:
    """Tell what ended a verb, and return its status."""
    match error:
        case BadInput():
            print(error, file=sys.stderr)
            return BAD_INPUT
        case WorkFailed():
            print(error, file=sys.stderr)
        case OSError() if why := streams.unwritable(error):
            print(f"assistant {verb}: {why}", file=sys.stderr)
            streams.silence()
        case OSError() if error.filename is not None:
            # Wherever a file is first looked at: a name too long, a folder nobody may look into.
            print(_unusable(error), file=sys.stderr)
            return BAD_INPUT
        case _:
            print(f"assistant {verb}: a fault of the program: {_kept(error)}", file=sys.stderr)
    return FAILED


def _unusable(error: OSError) -> Problem:
    """Tell which file or folder cannot be used, and why."""
    right = "name a file or folder that you may use"
    return Problem(str(error.filename), f"cannot be used ({error.strerror})", right)


def _kept(error: BaseException) -> str:
    """Keep the whole story of a fault in a file; return one line about it."""
    from assistant.files.home import home

    told = f"{type(error).__name__}: {error}".splitlines()[0]
    try:
        path = home() / "faults.log"
        path.parent.mkdir(parents=True, exist_ok=True)
        with path.open("a", encoding="utf-8") as file:
            traceback.print_exception(error, file=file)
    except (OSError, AssistantError):
        return told
    return f"{told} (the whole story is in {path})"


def _run(words: list[str]) -> int:
    verb = words[0]
    if verb.startswith("-"):
        _overview().parse_args(words)
    if verb not in VERBS:
        raise BadInput.one("assistant", f"unknown verb {verb!r}", f"one of {', '.join(VERBS)}")
    module = importlib.import_module(f"assistant.cli.{verb}")
    parser = Parser(
        prog=f"assistant {verb}",
        description=module.__doc__,
        formatter_class=argparse.RawDescriptionHelpFormatter,
    )
    module.arguments(parser)
    status: int = module.run(parser.parse_args(words[1:]))
    return status


def _overview() -> Parser:
    listed = "\n".join(f"  {verb:<11} {summary}" for verb, summary in VERBS.items())
    parser = Parser(
        prog="assistant",
        usage="assistant [VERB] [ARGUMENTS]",
        description="Teach a robot arm a task by telling it, showing it once and correcting it.",
        epilog=f"verbs:\n{listed}\n\nassistant VERB --help tells more, with an example.",
        formatter_class=argparse.RawDescriptionHelpFormatter,
    )
    parser.add_argument("--version", action=_Version, help="show the version and leave")
    return parser


class _Version(argparse.Action):
    """Looks the version up only when it is asked for: that takes a third of the time of help."""

    def __init__(self, option_strings: Sequence[str], dest: str, **more: Any) -> None:
        super().__init__(option_strings, dest, nargs=0, **more)

    def __call__(self, parser: argparse.ArgumentParser, *_: object) -> None:
        from importlib.metadata import version

        print(f"assistant {version('teaching-assistant')}")
        parser.exit()
