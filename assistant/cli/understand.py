"""Tell what a sentence means: the acts, their slots, and how sure that is.

Without TEXT, JSON lines {"text", "stage", "asked"} are read from standard input and one JSON
line is written for each.

example:
  assistant understand "a bit more left" --stage practice
  echo '{"text": "yes", "stage": "practice", "asked": "satisfied"}' | assistant understand
"""

from __future__ import annotations

import argparse
import json
import sys
from collections.abc import Mapping
from pathlib import Path
from typing import TYPE_CHECKING, Any, cast, get_args

from assistant.errors import BadInput

if TYPE_CHECKING:
    from assistant.model.listening import Listening, Understanding


def arguments(parser: argparse.ArgumentParser) -> None:
    """Describe the words and where the dialogue stands."""
    parser.add_argument("words", nargs="*", metavar="TEXT", help="what the teacher says")
    parser.add_argument("--stage", default="practice", help="where the dialogue stands")
    parser.add_argument("--asked", help="what the robot just asked")
    parser.add_argument("--task", type=Path, metavar="FILE", help="a task whose names are known")
    parser.add_argument("--language", default="english", help="english or german")
    parser.add_argument("--json", action="store_true", help="one JSON line")


def run(args: argparse.Namespace) -> int:
    """Understand the words given, or every line of standard input."""
    from assistant.language.understanding import understand

    known = _known(args.task)
    given = {"stage": args.stage, "asked": args.asked}
    if args.words:
        listening = _listening(given, known, "assistant understand")
        meant = understand(" ".join(args.words), listening, args.language)
        print(json.dumps(_plain(meant), ensure_ascii=False) if args.json else _told(meant))
        return 0
    for number, line in enumerate(sys.stdin, start=1):
        if line.strip():
            row = {**given, **_row(line, f"<stdin>:{number}")}
            listening = _listening(row, known, f"<stdin>:{number}")
            meant = understand(str(row["text"]), listening, args.language)
            print(json.dumps(_plain(meant), ensure_ascii=False), flush=True)
    return 0


def _known(path: Path | None) -> Mapping[str, Any]:
    if path is None:
        return {}
    from assistant.cli.naming import task_path
    from assistant.files.tasks import read_task
    from assistant.model.task import walk

    task = read_task(task_path(path))
    nodes = [node.name for index, node in walk(task.tree) if index]
    return {
        "task": task.name,
        "objects": tuple(one.name for one in task.objects),
        "subtasks": tuple(nodes),
    }


def _row(line: str, where: str) -> Mapping[str, Any]:
    try:
        row = json.loads(line)
    except ValueError as error:
        right = 'a JSON object such as {"text": "yes", "stage": "practice", "asked": null}'
        raise BadInput.one(where, "not JSON", right) from error
    if not isinstance(row, dict) or not isinstance(row.get("text"), str):
        raise BadInput.one(where, "no text", 'an object with "text" is needed')
    return {key: value for key, value in row.items() if value is not None or key == "asked"}


def _listening(row: Mapping[str, Any], known: Mapping[str, Any], where: str) -> Listening:
    from assistant.model.listening import Listening
    from assistant.model.teacher_acts import ASKED, STAGES, Asked, Stage

    stage, asked = row.get("stage", "practice"), row.get("asked")
    if stage not in get_args(Stage):
        raise BadInput.one(where, f"unknown stage {stage!r}", f"one of {', '.join(STAGES)}")
    if asked not in (None, "", *get_args(Asked)):
        raise BadInput.one(where, f"unknown question {asked!r}", f"one of {', '.join(ASKED)}")
    return Listening(stage=cast("Stage", stage), asked=cast("Asked", asked or None), **known)


def _plain(meant: Understanding) -> dict[str, Any]:
    from assistant.model.teacher_acts import act_to_json

    acts = [act_to_json(act) for act in meant.acts]
    return {"acts": acts, "confidence": meant.confidence, "heard": meant.heard}


def _told(meant: Understanding) -> str:
    from assistant.model.teacher_acts import act_to_json

    lines = []
    for act in meant.acts:
        slots = {key: value for key, value in act_to_json(act).items() if key != "act"}
        told = ", ".join(f"{key}: {value}" for key, value in slots.items())
        lines.append(f"{act_to_json(act)['act']}{f' ({told})' if told else ''}")
    return "\n".join([*lines, f"confidence {meant.confidence:.2f}, heard: {meant.heard}"])
