r"""Learn a task from demonstrations, without dialogue: cut, assign, generalize.

Several demonstrations are learned each on its own, or together as one lesson. Ends with 1 if
nothing could be learned.

example:
  assistant learn tasks/demonstrations/pick_and_place.yaml --task tasks/pick_and_place.yaml \
    -o learned.yaml
"""

from __future__ import annotations

import argparse
import json
import sys
from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING

from assistant.cli import DONE, FAILED
from assistant.cli.naming import task_path
from assistant.errors import BadInput, NothingLearned, Problem

if TYPE_CHECKING:
    from assistant.model.demonstration import Demonstration
    from assistant.model.lesson import Lesson
    from assistant.model.scene import Scene
    from assistant.model.task import Task


def arguments(parser: argparse.ArgumentParser) -> None:
    """Declare what the verb takes."""
    parser.add_argument("demonstrations", nargs="+", type=Path, metavar="DEMONSTRATION")
    parser.add_argument(
        "--task",
        type=Path,
        required=True,
        metavar="TREE",
        help="the task as introduced, or its name",
    )
    parser.add_argument("--together", action="store_true", help="all as one lesson")
    parser.add_argument("-o", "--out", type=Path, metavar="LEARNED", help="write the learned task")
    parser.add_argument("--figures", type=Path, metavar="DIR", help="draw votes, paths, weights")
    parser.add_argument("--json", action="store_true", help="one JSON line a lesson")


def run(args: argparse.Namespace) -> int:
    """Learn, tell, and write what was asked for."""
    from assistant.learning.lesson import load_libraries

    task, shown, scenes = _read_all(args.task, args.demonstrations)
    if args.together or len(shown) == 1:
        groups = [(shown, scenes[-1])]
    else:
        groups = [([one], scene) for one, scene in zip(shown, scenes, strict=True)]
    if len(groups) > 1 and (args.out or args.figures):
        raise BadInput.one("assistant learn", "several lessons, one place to write", "--together")
    load_libraries()
    learned = [_one(group, task, scene, args.json) for group, scene in groups]
    if learned[0] is not None and len(groups) == 1:
        _write(replace(task, learned=learned[0]), groups[0][0], args.out, args.figures)
    return DONE if all(lesson is not None for lesson in learned) else FAILED


def _read_all(tree: Path, paths: Sequence[Path]) -> tuple[Task, list[Demonstration], list[Scene]]:
    """Return the task, and all demonstrations with their scenes.

    What is wrong with any file is told with the rest; what is odd in a demonstration is told,
    and learned from all the same.
    """
    from assistant.files.oddities import odd_demonstration
    from assistant.files.scenes import find_scene
    from assistant.files.tasks import read_task

    tasks: list[Task] = []
    shown: list[Demonstration] = []
    scenes: list[Scene] = []
    problems: list[Problem] = []
    try:
        tasks.append(read_task(task_path(tree)))
    except BadInput as error:
        problems += error.problems
    for path in paths:
        try:
            shown.append(_shown(path))
            scenes.append(find_scene(shown[-1].setup.scene, path))
        except BadInput as error:
            problems += error.problems
    if problems:
        raise BadInput(problems)
    for one, path in zip(shown, paths, strict=True):
        for odd in odd_demonstration(one, str(path)):
            print(f"warning: {odd}", file=sys.stderr)
    return tasks[0], shown, scenes


def _shown(path: Path) -> Demonstration:
    """Return a demonstration; a recording alone is one in which nothing was said."""
    from assistant.files.demonstrations import read_demonstration
    from assistant.files.kinds import read_known
    from assistant.model.demonstration import Demonstration, Recording

    if path.suffix.lower() not in (".yaml", ".yml"):
        told = read_known(path).value
        if isinstance(told, Recording):
            return Demonstration(told, source=str(path))
    return read_demonstration(path)


def _one(shown: Sequence[Demonstration], task: Task, scene: Scene, as_json: bool) -> Lesson | None:
    from assistant.cli.learned import learn_values, tell_lesson
    from assistant.learning.lesson import learn
    from assistant.shells.pacing import RealClock

    sources = [Path(one.source).name for one in shown]
    clock = RealClock()
    try:
        lesson = learn(shown, task, scene=scene)
    except NothingLearned as error:
        print(f"{', '.join(sources)}: nothing learned: {error}", file=sys.stderr)
        if as_json:
            print(json.dumps({"demonstrations": sources, "nothing_learned": str(error)}))
        return None
    wall_s = clock.now_s()
    done = replace(task, learned=lesson)
    if as_json:
        told = {"demonstrations": sources, **learn_values(done), "wall_s": round(wall_s, 6)}
        print(json.dumps(told))
    else:
        tell_lesson(done, wall_s)
    return lesson


def _write(
    task: Task, shown: Sequence[Demonstration], out: Path | None, figures: Path | None
) -> None:
    if out is not None:
        from assistant.files.converting import ENDINGS, convert
        from assistant.files.kinds import Known
        from assistant.files.tasks import write_task

        if out.suffix.lower() in ENDINGS["task"]:
            convert(Known("task", task), out, out)
        else:
            write_task(task, out)
        print(f"wrote {out}", file=sys.stderr)
    if figures is not None:
        from assistant.shells.figures import write_figures

        for path in write_figures(task, figures, shown[-1]):
            print(f"wrote {path}", file=sys.stderr)
