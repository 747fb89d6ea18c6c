"""List, show or delete learned tasks.

example:
  assistant tasks
  assistant tasks show pick_and_place
  assistant tasks delete pick_and_place
"""

from __future__ import annotations

import argparse
import json
from typing import TYPE_CHECKING, Any

from assistant.cli import DONE
from assistant.errors import BadInput

if TYPE_CHECKING:
    from assistant.files.library import Library


def arguments(parser: argparse.ArgumentParser) -> None:
    """Declare what the verb takes."""
    parser.add_argument("do", nargs="?", choices=("list", "show", "delete"), default="list")
    parser.add_argument("name", nargs="?", metavar="NAME")
    parser.add_argument("--json", action="store_true", help="one JSON line")


def run(args: argparse.Namespace) -> int:
    """Do what was asked with the tasks kept."""
    from assistant.files.home import home_to_look_into
    from assistant.files.library import library

    home_to_look_into()
    kept = library()
    if args.do == "list":
        _list(kept, as_json=args.json)
        return DONE
    if args.name is None:
        known = ", ".join(kept.names()) or "none yet"
        raise BadInput.one(f"assistant tasks {args.do}", "which one?", f"kept: {known}")
    if args.do == "show":
        _show(kept, args.name, as_json=args.json)
        return DONE
    kept.delete(args.name)
    print(json.dumps({"deleted": args.name}) if args.json else f"deleted {args.name}")
    return DONE


def _list(kept: Library, *, as_json: bool) -> None:
    from assistant.files.wording import one_line

    rows = [_summary(kept, name) for name in kept.names()]
    if as_json:
        print(json.dumps({"folder": str(kept.folder), "tasks": rows}))
        return
    if not rows:
        print(f"no tasks are kept yet in {kept.folder}; teach one: assistant teach")
    for row in rows:
        goal = one_line(row["goal"])
        state = row["trouble"] or ("learned" if row["learned"] else "introduced")
        versions = f", {row['earlier']} earlier" if row["earlier"] else ""
        print(f"{row['name']:<24} {state}{versions}  {goal}".rstrip())


def _summary(kept: Library, name: str) -> dict[str, Any]:
    row: dict[str, Any] = {
        "name": name,
        "file": str(kept.path(name)),
        "goal": "",
        "learned": False,
        "earlier": len(kept.earlier(name)),
        "trouble": "",
    }
    try:
        task = kept.load(name)
    except BadInput as error:
        return {**row, "trouble": f"cannot be read: {error.problems[0]}"}
    return {**row, "goal": task.goal, "learned": task.learned is not None}


def _show(kept: Library, name: str, *, as_json: bool) -> None:
    task = kept.load(name)
    if as_json:
        from assistant.files.plain import plain_values

        print(json.dumps(plain_values(task)))
        return
    from assistant.shells.telling import terminal, view

    terminal().print(view(task))
