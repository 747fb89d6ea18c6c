"""Tell what a sentence means: the acts, their slots, and how sure that is.

Without TEXT, JSON lines {"text", "stage", "asked"} are read from standard input and one JSON
line is written for each. A line that cannot be read is told, is answered by "unknown" at
confidence 0, and makes the end status 2; the others are understood all the same.

example:
  assistant understand "a bit more left" --stage practice
  echo '{"text": "yes", "stage": "practice", "asked": "satisfied"}' | assistant understand
"""

from __future__ import annotations

import argparse
import json
import sys
from collections.abc import Iterable, Mapping
from pathlib import Path
from typing import TYPE_CHECKING, Any, cast, get_args

from assistant.cli import BAD_INPUT, DONE
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
    from assistant.language.little_words import folder_of

    folder_of(args.language)  # says so if there is none
    known = _known(args.task)
    given = {"stage": args.stage, "asked": args.asked}
    if not args.words:
        return _lines(sys.stdin, given, known, args.language)
    row = {**given, "text": " ".join(args.words)}
    meant = _meant(row, known, args.language, "assistant understand")
    print(json.dumps(_plain(meant)) if args.json else _told(meant))
    return DONE


def _lines(
    lines: Iterable[str], given: Mapping[str, Any], known: Mapping[str, Any], language: str
) -> int:
    """Understand line after line; one that cannot be read is told, and the others go on."""
    status = DONE
    for number, line in enumerate(lines, start=1):
        where = f"<stdin>:{number}"
        if not line.strip("\ufeff \t\r\n"):
            continue
        try:
            told = _plain(_meant({**given, **_row(line, where)}, known, language, where))
        except BadInput as error:
            print(error, file=sys.stderr)
            told = {"acts": [{"act": "unknown"}], "confidence": 0.0, "heard": "", "why": str(error)}
            status = BAD_INPUT
        print(json.dumps(told), flush=True)
    return status


def _meant(
    row: Mapping[str, Any], known: Mapping[str, Any], language: str, where: str
) -> Understanding:
    from assistant.language.understanding import understand

    return understand(row["text"], _listening(row, known, where), language)


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
        row = json.loads(line.removeprefix("\ufeff"))
    except (ValueError, RecursionError) as error:
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
