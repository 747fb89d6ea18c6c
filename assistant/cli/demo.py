"""See the whole method at work, no questions asked: teach, learn, practice on Table I.

A shipped transcript teaches pick-and-place to the simulated A465 (contact physics); the four
setups of the paper's Table I are then practiced. Writes pick_and_place.yaml and the figures
votes.png, paths.png and weights.png (the paper's 3, 4, 5).

example:
  assistant demo --out demo
"""

from __future__ import annotations

import argparse
import json
import tempfile
from collections.abc import Callable
from pathlib import Path
from typing import TYPE_CHECKING

from assistant.cli import DONE, FAILED
from assistant.errors import BadInput, WorkFailed

if TYPE_CHECKING:
    from assistant.model.demonstration import Demonstration
    from assistant.model.task import Task
    from assistant.session.practice import SetupResult

Show = Callable[[object], None]
TABLE = "table1"
TRANSCRIPT = "pick_and_place.yaml"
LEARNED = "pick_and_place.yaml"


def arguments(parser: argparse.ArgumentParser) -> None:
    """Declare what the verb takes."""
    parser.add_argument(
        "--out", type=Path, default=Path(), metavar="DIR", help="where the results go (default: .)"
    )
    parser.add_argument("--json", action="store_true", help="end with one JSON line")


def run(args: argparse.Namespace) -> int:
    """Teach, show what was learned, practice."""
    from assistant.cli.learned import learn_values
    from assistant.files.tasks import write_task
    from assistant.session.practice import tally
    from assistant.shells.figures import write_figures
    from assistant.shells.pacing import RealClock
    from assistant.shells.telling import terminal, view

    _make(args.out)
    console = terminal()
    show = console.print
    # With --json, what people read goes to stderr: the answer alone is for programs.
    console.stderr = args.json
    clock = RealClock()
    task, shown = _taught(show)
    show(view(task))
    write_task(task, args.out / LEARNED)
    figures = write_figures(task, args.out, shown)
    results = _practiced(task, show)
    for path in (args.out / LEARNED, *figures):
        show(f"wrote {path}")
    if args.json:
        answer = {**learn_values(task), **tally(results), "wall_s": round(clock.now_s(), 3)}
        print(json.dumps(answer))
    return DONE if all(result.status == "done" for result in results) else FAILED


def _make(folder: Path) -> None:
    try:
        folder.mkdir(parents=True, exist_ok=True)
    except OSError as error:
        what = f"cannot be made ({error.strerror})"
        raise BadInput.one(str(folder), what, "name a folder you may write in") from error


def _taught(show: Show) -> tuple[Task, Demonstration]:
    """Hold the shipped lesson and return what was learned and what was shown in it."""
    from assistant.cli.adapters import make_equipment
    from assistant.files.shipped import shipped
    from assistant.files.transcripts import read_transcript
    from assistant.session.player import Player
    from assistant.shells.demonstrating import dialogue_writer

    transcript = read_transcript(shipped("transcripts") / TRANSCRIPT)
    with tempfile.TemporaryDirectory(prefix="assistant-") as folder:
        player = Player(transcript, make_equipment, Path(folder), dialogue_writer(show))
        played = player.play()
    if played.difference is not None:
        where = f"{transcript.source}:{played.difference.line}"
        raise WorkFailed(
            f"the lesson went otherwise than written: {where}: {played.difference.why}"
        )
    known = player.session.dialogue.known
    return known.task, known.demonstrations[-1]


def _practiced(task: Task, show: Show) -> list[SetupResult]:
    """Practice the setups of Table I and show how they went, beside the paper."""
    from assistant.cli.adapters import make_arm
    from assistant.files.finding import find_setups
    from assistant.files.scenes import find_scene
    from assistant.session.practice import practice_setup
    from assistant.shells.demonstrating import alignment_table
    from assistant.shells.pacing import RealClock
    from sim.planner import A465Planner

    setups, path = find_setups(TABLE, Path())
    arm, planner, clock = make_arm("pybullet"), A465Planner(), RealClock()
    results = []
    for setup in setups:
        scene = find_scene(setup.scene, path)
        result = practice_setup(task, scene, setup, arm=arm, planner=planner, clock=clock)
        results.append(result)
    rows = [(one.name, one.status, one.distance_mm, one.angle_deg) for one in results]
    show(alignment_table(rows))
    return results
