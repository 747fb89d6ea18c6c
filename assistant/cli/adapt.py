"""Compute the path of the hand for setups: geometry and timing of the hand only, no arm.

example:
  assistant adapt learned.yaml --setup tasks/setups/table1.yaml --csv path.csv
"""

from __future__ import annotations

import argparse
import json
import sys
from pathlib import Path
from typing import TYPE_CHECKING, Any

from assistant.cli import DONE
from assistant.cli.naming import learned_task

if TYPE_CHECKING:
    from assistant.learning.adaptation import AdaptationPlan
    from assistant.model.motion import HandPath
    from assistant.model.scene import Scene
    from assistant.model.setup import Setup

_AT_ONCE = 64
"""Setups adapted to before any is measured: the one is timed, the other is not."""


def arguments(parser: argparse.ArgumentParser) -> None:
    """Declare what the verb takes."""
    parser.add_argument("learned", type=Path, metavar="LEARNED", help="a task that was learned")
    parser.add_argument("--setup", nargs="+", type=Path, required=True, metavar="SETUP")
    parser.add_argument("--csv", type=Path, metavar="FILE", help="write the path as a recording")
    parser.add_argument("--json", action="store_true", help="one JSON line a setup")


def run(args: argparse.Namespace) -> int:
    """Adapt to one setup after another; everything is read and checked before the first."""
    from assistant.cli.placing import check_places, read_places
    from assistant.learning.adaptation import adapt, frames_in, plan_adaptation
    from assistant.learning.measures import measured
    from assistant.shells.pacing import RealClock

    task = learned_task(args.learned)
    told = read_places(args.setup)
    clock = RealClock()
    plan = plan_adaptation(task)
    check_places(told, lambda scene, setup: frames_in(plan, scene, setup))
    places = [(placed.scene, placed.setup) for placed in told]
    # The first adaptation of a process also pays for what is done once.
    adapt(plan, *places[0])
    plan_s = clock.now_s()
    for begin in range(0, len(places), _AT_ONCE):
        some = places[begin : begin + _AT_ONCE]
        made = [_timed(plan, scene, setup) for scene, setup in some]
        for number, ((scene, setup), (path, wall_s)) in enumerate(zip(some, made, strict=True)):
            values = {"name": setup.name, **measured(task, plan, path, scene, setup)}
            values |= {"plan_s": round(plan_s, 6), "wall_s": round(wall_s, 6)}
            print(json.dumps(values) if args.json else _told(values))
            if args.csv is not None:
                _write(path, _numbered(args.csv, begin + number + 1, len(places)))
    return DONE


def _timed(plan: AdaptationPlan, scene: Scene, setup: Setup) -> tuple[HandPath, float]:
    from assistant.learning.adaptation import adapt
    from assistant.shells.pacing import RealClock

    clock = RealClock()
    path = adapt(plan, scene, setup)
    return path, clock.now_s()


def _told(values: dict[str, Any]) -> str:
    return (
        f"{values['name']}: grasp off by {values['grasp_error_m'] * 1000:.1e} mm, release by "
        f"{values['release_error_m'] * 1000:.1e} mm; jerk {values['jerk_ratio']:.2f}, peak speed "
        f"{values['peak_speed_ratio']:.2f}, duration {values['duration_ratio']:.2f} of the "
        f"demonstration's"
    )


def _numbered(path: Path, number: int, count: int) -> Path:
    return path if count == 1 else path.with_stem(f"{path.stem}_{number}")


def _write(path: HandPath, to: Path) -> None:
    from assistant.files.recordings import write_recording
    from assistant.model.demonstration import Recording

    write_recording(Recording(path.t_s, path.path, path.gripper_m), to)
    print(f"wrote {to}", file=sys.stderr)
