"""Teach the robot a task by talking: it asks, watches one demonstration, practices and learns.

Everything said and shown is journaled at once; a session that ended in any way goes on with
--resume. Ctrl-C stops the arm.

example:
  assistant teach --setup tasks/setups/demonstration.yaml
  assistant teach --task pick_and_place
  assistant teach --resume
"""

from __future__ import annotations

import argparse
import os
import sys
from collections.abc import Callable
from functools import partial
from types import MappingProxyType
from typing import TYPE_CHECKING

from assistant.cli import DONE, FAILED
from assistant.cli.adapters import LANGUAGES, arm_argument
from assistant.cli.naming import task_path
from assistant.cli.starting import as_started
from assistant.cli.talking import make_talking, shown_and_spoken, voice_arguments
from assistant.errors import AssistantError, BadInput
from assistant.language.hints import page
from assistant.model.robot_acts import RobotAct

if TYPE_CHECKING:
    from assistant.model.transcript import Transcript
    from assistant.session.loop import Out, Session

NEWEST = "newest"


def arguments(parser: argparse.ArgumentParser) -> None:
    """Declare what the verb takes."""
    arm_argument(parser)
    parser.add_argument(
        "--task",
        metavar="TASK",
        help="go on teaching this task: a file, or a name it is kept under",
    )
    parser.add_argument("--setup", metavar="FILE", help="where things are (a file or a name)")
    parser.add_argument("--language", choices=("en", "de"), default="en")
    parser.add_argument(
        "--resume", nargs="?", const=NEWEST, metavar="ID", help="go on with an earlier session"
    )
    parser.add_argument(
        "--pace", type=_pace, default=1.0, metavar="F", help="of the simulated arm; 1 is real time"
    )
    parser.add_argument("--window", action="store_true", help="show the arm in a window")
    parser.add_argument("--json", action="store_true", help="talk in JSON lines, for programs")
    voice_arguments(parser)
    parser.add_argument("--browser", action="store_true", help="talk in a browser")


def _pace(text: str) -> float:
    try:
        factor = float(text)
    except ValueError:
        factor = 0.0
    if not 0.1 <= factor <= 100.0:
        raise argparse.ArgumentTypeError(f"expected a number from 0.1 to 100, got {text!r}")
    return factor


def run(args: argparse.Namespace) -> int:
    """Hold one session."""
    if args.browser:
        raise BadInput.one("--browser", "is not built yet", "leave it out and type")
    if args.json and args.window:
        # The window's library writes to stdout as it likes.
        raise BadInput.one("--window", "does not go with --json", "one of the two")
    if args.json and args.voice:
        raise BadInput.one("--voice", "does not go with --json", "one of the two")
    if args.json:
        return _with_json(args)
    live = sys.stdin.isatty() and sys.stdout.isatty()
    if live and os.environ.get("TERM", "dumb") != "dumb":
        return _with_text(args)
    return _with_plain(args, live=live)


def _with_json(args: argparse.Namespace) -> int:
    from assistant.shells.json_lines import JsonShell

    shell = JsonShell(lambda line: print(line, flush=True))
    session = _opened(args, shell.out, shell.attach)
    return _guarded(session, lambda: shell.run(session, sys.stdin))


def _with_plain(args: argparse.Namespace, *, live: bool) -> int:
    from assistant.shells.plain import PlainShell
    from assistant.shells.wrapping import columns

    width = columns() if live else None
    shell = PlainShell(lambda line: print(line, flush=True), args.pace, width)
    talking = make_talking(args, lambda line: print(line, flush=True), live=live)
    session = _opened(args, shown_and_spoken(shell.out, talking), shell.attach)
    return _guarded(session, lambda: shell.run(session, sys.stdin, live=live, beside=talking))


def _with_text(args: argparse.Namespace) -> int:
    from assistant.cli.adapters import warm_up
    from assistant.files.home import home
    from assistant.shells.text import TextShell, write

    shell = TextShell(home() / "history", args.pace)
    talking = make_talking(args, write, live=True)
    session = _opened(args, shown_and_spoken(shell.out, talking), shell.attach)
    warm_up()
    return _guarded(session, lambda: shell.run(session, talking))


def _opened(
    args: argparse.Namespace, out: Out, made: Callable[[Session], None] = lambda session: None
) -> Session:
    from assistant.cli.adapters import make_equipment
    from assistant.files.home import home
    from assistant.session.opening import Opening, open_session, resume_session
    from assistant.session.past import newer_sessions, newest_session

    equipment = partial(make_equipment, window=args.window)
    opening = Opening(equipment, home(), out, made)
    if args.resume is None:
        return open_session(opening, _header(args))
    name = newest_session(opening.sessions) if args.resume == NEWEST else args.resume
    damaged = newer_sessions(opening.sessions, name) if args.resume == NEWEST else ()
    try:
        session = resume_session(opening, name)
    except (KeyError, TypeError, ValueError, OSError) as error:
        # Files beside the journal were changed by hand or are gone.
        where = str(opening.sessions / name)
        what = f"the session cannot be read back ({type(error).__name__}: {error})"
        raise BadInput.one(where, what, "its files as they were written") from error
    if damaged:
        session.tell(_older(name, damaged))
    return session


def _older(name: str, damaged: tuple[str, ...]) -> RobotAct:
    """Return the line that tells that a newer session could not be read."""
    slots = {"name": name, "names": list(damaged)}
    return RobotAct("report", "resumed_older", slots=MappingProxyType(slots))


def _header(args: argparse.Namespace) -> Transcript:
    from assistant.model.transcript import SetupChoice, Transcript

    choice = None if args.setup is None else SetupChoice(file=args.setup)
    task = None if args.task is None else str(task_path(args.task).resolve())
    language = LANGUAGES[args.language]
    return Transcript("a lesson", setup=choice, arm=args.arm, task=task, language=language)


def _guarded(session: Session, hold: Callable[[], None]) -> int:
    """Hold the conversation; whatever goes wrong is one line, and nothing is lost."""
    status = DONE
    try:
        hold()
    except AssistantError:
        raise
    except Exception as error:
        what = f"{type(error).__name__}: {error}".splitlines()[0]
        print(f"something unexpected went wrong ({what})", file=sys.stderr)
        status = FAILED
    finally:
        session.close()
    _tell_where(session)
    return status


def _tell_where(session: Session) -> None:
    if session.journal.trouble:
        # Said when it came up.
        return
    journal = session.journal
    told = page("terminal", session.language)["kept_where"]
    command = as_started("teach", "--resume", journal.name)
    print(told.format(path=journal.path, command=command), file=sys.stderr)
