"""Carry out a learned task in setups, in simulation, and measure the alignment.

Nothing moves that was not checked; a setup that cannot be reached is refused with the reason.
Ends with 0 if all are done, 1 if any was missed or refused.

example:
  assistant practice pick_and_place.yaml --setup tasks/setups/table1.yaml
"""

from __future__ import annotations

import argparse
import json
import math
import re
import sys
from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING

from assistant.cli import DONE, FAILED
from assistant.cli.naming import learned_task
from assistant.errors import BadInput

if TYPE_CHECKING:
    from assistant.session.practice import SetupResult

SLOWEST, FASTEST = 0.1, 3.0


def arguments(parser: argparse.ArgumentParser) -> None:
    """Declare what the verb takes."""
    from assistant.cli.adapters import arm_argument

    parser.add_argument("learned", type=Path, metavar="LEARNED", help="a task that was learned")
    parser.add_argument("--setup", nargs="+", type=Path, required=True, metavar="SETUP")
    parser.add_argument("--speed", type=_speed, default=1.0, metavar="F", help="as shown: 1")
    arm_argument(parser)
    parser.add_argument("--window", action="store_true", help="show it in a window, in real time")
    parser.add_argument("--csv", type=Path, metavar="DIR", help="write the joint paths there")
    parser.add_argument("--dry-run", action="store_true", help="plan and check, move nothing")
    parser.add_argument("--json", action="store_true", help="one JSON line at the end")


def _speed(text: str) -> float:
    try:
        factor = float(text)
    except ValueError:
        factor = math.nan
    if not SLOWEST <= factor <= FASTEST:
        expected = f"a factor between {SLOWEST:g} and {FASTEST:g}"
        raise argparse.ArgumentTypeError(f"expected {expected}, got {text}")
    return factor


def run(args: argparse.Namespace) -> int:
    """Practice one setup after another; everything is read and checked before the first."""
    from assistant.cli.adapters import make_arm
    from assistant.cli.placing import check_places, read_places
    from assistant.learning.adaptation import plan_adaptation
    from assistant.session.practice import check_placed, practice_setup, tally
    from assistant.shells.pacing import PacedArm, RealClock
    from sim.planner import A465Planner

    if args.window and (args.json or args.dry_run):
        # The window's library writes to stdout as it likes.
        raise BadInput.one("--window", "does not go with --json or --dry-run", "leave one out")
    task = learned_task(args.learned)
    told = read_places(args.setup)
    check_places(told, lambda _, setup: check_placed(task, setup))
    places = [(placed.scene, placed.setup) for placed in told]
    folder, names = _folder(args.csv), _file_names([setup.name for _, setup in places])
    arm = None if args.dry_run else make_arm(args.arm, window=args.window)
    plan, planner, clock = plan_adaptation(task), A465Planner(), RealClock()
    if arm is not None and args.window:
        # What is shown is to be watched; without a window it runs as fast as it can.
        arm = PacedArm(arm, clock)
    results = []
    for number, (scene, setup) in enumerate(places, start=1):
        print(f"{setup.name} ({number} of {len(places)})", file=sys.stderr)
        result = practice_setup(
            task, scene, setup, arm=arm, planner=planner, speed=args.speed, clock=clock, plan=plan
        )
        results.append(result)
        if folder is not None:
            _write(folder, names[number - 1], result)
    if args.json:
        print(json.dumps(tally(results)))
    else:
        print(table(results, dry=args.dry_run))
    return DONE if all(result.status == "done" for result in results) else FAILED


def _folder(path: Path | None) -> Path | None:
    if path is None:
        return None
    try:
        path.mkdir(parents=True, exist_ok=True)
    except OSError as error:
        what = f"cannot be a folder ({error.strerror})"
        raise BadInput.one(str(path), what, "name a folder you may write in") from error
    return path


def _file_names(setups: Sequence[str]) -> list[str]:
    """Return a file's name for each setup, the same whenever they are practiced again."""
    stems = [re.sub(r"[^\w.-]+", "_", name) or "setup" for name in setups]
    return [
        f"{stem}.csv" if stems.count(stem) == 1 else f"{stem}_{number}.csv"
        for number, stem in enumerate(stems, start=1)
    ]


def _write(folder: Path, name: str, result: SetupResult) -> None:
    if result.motion is None:
        return
    import numpy as np

    from assistant.files.writing import cannot_write

    motion = result.motion
    header = "t_s," + ",".join(f"q{k}_rad" for k in range(1, 7)) + ",gripper_m,primitive"
    rows = np.column_stack([motion.t_s, motion.q, motion.gripper_m, motion.primitive_at])
    path = folder / name
    lines = [header, *(",".join(f"{value:.9g}" for value in row) for row in rows)]
    try:
        path.write_text("\n".join(lines) + "\n", encoding="utf-8")
    except OSError as error:
        raise cannot_write(path, error) from error


def table(results: Sequence[SetupResult], *, dry: bool = False) -> str:
    """Return results as a plain table for people."""
    head = ("setup", "result", "distance mm", "angle deg", "margin deg", "time s", "why")
    rows = [head, *(_row(result, dry) for result in results)]
    widths = [max(len(row[k]) for row in rows) for k in range(len(head))]
    lines = [
        "  ".join(cell.ljust(width) for cell, width in zip(row, widths, strict=True)).rstrip()
        for row in rows
    ]
    count = sum(result.status == "done" for result in results)
    lines.append(f"{count} of {len(results)} {'can be done' if dry else 'done'}")
    return "\n".join(lines)


def _row(result: SetupResult, dry: bool) -> tuple[str, ...]:
    def told(value: float | None, digits: int) -> str:
        return "" if value is None else f"{value:.{digits}f}"

    return (
        result.name,
        "reachable" if dry and result.status == "done" else result.status,
        told(result.distance_mm, 3),
        told(result.angle_deg, 3),
        told(result.joint_margin_deg, 1),
        told(result.sim_s, 1),
        result.reason or result.note,
    )
