"""Validate files: tasks, setups, scenes, demonstrations, transcripts and recordings.

Every problem is one line, file:line: what is wrong; what would be right. What can be used but
looks odd is told as a warning and is no problem.

example:
  assistant check tasks/pick_and_place.yaml tasks/setups
"""

from __future__ import annotations

import argparse
import json
import os
import sys
from pathlib import Path
from typing import Any

from assistant.cli import BAD_INPUT, DONE
from assistant.errors import BadInput, Problem

ENDINGS = (".yaml", ".yml", ".csv")
KINDS = ("task", "setup", "scene", "demonstration", "transcript")


def arguments(parser: argparse.ArgumentParser) -> None:
    """Declare what the verb takes."""
    parser.add_argument("files", nargs="*", type=Path, metavar="FILE", help="or a folder")
    parser.add_argument(
        "--schema", choices=KINDS, help="print the JSON Schema of a format, for your editor"
    )
    parser.add_argument("--json", action="store_true", help="one JSON line at the end")


def run(args: argparse.Namespace) -> int:
    """Check each file; the status is 2 if any has a problem."""
    if args.schema:
        from assistant.files.schemas import schema_path

        print(schema_path(args.schema).read_text(encoding="utf-8"), end="")
    elif not args.files:
        raise BadInput.one("assistant check", "which files?", "name files or folders")
    results = [_checked(path) for told in args.files for path in _files(told)]
    if args.json and args.files:
        print(json.dumps({"files": results}))
    else:
        for result in results:
            _tell(result)
    return BAD_INPUT if any(result["problems"] for result in results) else DONE


def _files(path: Path) -> list[Path]:
    """Return a file, or every file of ours in a folder and below; a folder without any itself."""
    if not os.path.isdir(path):
        return [path]
    return sorted(each for each in path.rglob("*") if each.suffix in ENDINGS) or [path]


def _checked(path: Path) -> dict[str, Any]:
    from assistant.files.kinds import read_known

    result: dict[str, Any] = {"file": str(path), "kind": None, "problems": [], "warnings": []}
    try:
        if os.path.isdir(path):
            right = f"name a folder you may read, with {' or '.join(ENDINGS)} files in it"
            raise BadInput.one(str(path), "no file of ours is in this folder", right)
        known = read_known(path)
    except BadInput as error:
        return {**result, "problems": [_fields(each) for each in error.problems]}
    return {**result, "kind": known.kind, "warnings": [_fields(each) for each in known.warnings]}


def _fields(problem: Problem) -> dict[str, str]:
    return {"where": problem.where, "what": problem.what, "right": problem.right}


def _tell(result: dict[str, Any]) -> None:
    for fields in result["problems"]:
        print(Problem(**fields), file=sys.stderr)
    for fields in result["warnings"]:
        print(f"warning: {Problem(**fields)}", file=sys.stderr)
    if not result["problems"]:
        print(f"{result['file']}: a good {result['kind']}")
