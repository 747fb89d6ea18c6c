"""Measure success over random setups that can be reached, with a 95 % interval.

Setups are drawn over the ring the arm reaches, with random robot starts, and practiced in
several processes. What is finished is kept, so that the same command goes on where it was
interrupted. Ends with 0 when all setups were tried, however they went.

example:
  assistant evaluate pick_and_place.yaml --setups 100 --seed 1 --sector front
"""

from __future__ import annotations

import argparse
import json
import os
import sys
from pathlib import Path

from assistant.cli import DONE
from assistant.cli.naming import task_path


def arguments(parser: argparse.ArgumentParser) -> None:
    """Declare what the verb takes."""
    from assistant.cli.adapters import arm_argument

    parser.add_argument("learned", type=Path, metavar="LEARNED", help="a task that was learned")
    parser.add_argument("--setups", type=_count, required=True, metavar="N", help="how many")
    parser.add_argument("--seed", type=_seed, required=True, metavar="S")
    parser.add_argument(
        "--sector", choices=("front", "all"), default="all", help="ahead of the arm, or all around"
    )
    parser.add_argument(
        "--scene", default="", metavar="SCENE", help="default: the table, or what has its things"
    )
    parser.add_argument(
        "--workers", type=_count, metavar="K", help="processes; default: one a processor"
    )
    arm_argument(parser)
    parser.add_argument(
        "--noise",
        type=_noise,
        default=(0.0, 0.0),
        metavar="MM,DEG",
        help="errors of the told places of bodies, such as 1,1",
    )
    parser.add_argument("--no-sensor", action="store_true", help="do not look at a grasped body")
    parser.add_argument(
        "--resume", type=Path, metavar="FILE", help="keep what is finished here, and go on from it"
    )
    parser.add_argument("--json", action="store_true", help="one JSON line at the end")


def _count(text: str) -> int:
    if not text.isdigit() or int(text) < 1:
        raise argparse.ArgumentTypeError(f"expected a whole number from 1 on, got {text}")
    return int(text)


def _seed(text: str) -> int:
    if not text.isdigit():
        raise argparse.ArgumentTypeError(f"expected a whole number from 0 on, got {text}")
    return int(text)


def _noise(text: str) -> tuple[float, float]:
    try:
        millimetres, degrees = (float(part) for part in text.split(","))
    except ValueError:
        millimetres = degrees = -1.0
    if not (0.0 <= millimetres <= 50.0 and 0.0 <= degrees <= 45.0):
        raise argparse.ArgumentTypeError(f"expected millimetres,degrees such as 1,1, got {text}")
    return millimetres, degrees


def run(args: argparse.Namespace) -> int:
    """Practice every setup that is not finished yet, then tell how it went."""
    from assistant.cli.evaluation import (
        Evaluation,
        Finished,
        Worker,
        evaluated,
        scene_for,
        summary,
        told,
    )

    learned = task_path(args.learned)
    wanted = Evaluation(
        str(learned),
        args.scene or scene_for(learned),
        args.setups,
        args.seed,
        args.sector,
        args.arm,
        args.noise,
        not args.no_sensor,
    )
    # What is wrong with the task is told before anything is kept.
    Worker(wanted)
    finished = Finished.of(wanted, args.resume)
    workers = min(args.workers or os.cpu_count() or 1, args.setups)
    results = evaluated(wanted, finished, workers, lambda line: print(line, file=sys.stderr))
    answer = told(results)
    if args.json:
        print(json.dumps(answer))
    else:
        print(summary(answer))
    if args.resume is None:
        finished.forget()
    return DONE
