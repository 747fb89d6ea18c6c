"""Runs an evaluation in several processes and keeps what is finished.

The record is a file of JSON lines: first what is evaluated, then one line a setup, written as
soon as it is known. A torn last line, left by a process that was killed, is done again.
"""

from __future__ import annotations

import hashlib
import json
import re
import signal
from collections import Counter
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import asdict, dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any, Literal

from assistant.errors import BadInput, WorkFailed

if TYPE_CHECKING:
    from assistant.ports import Arm

FORMAT = "evaluation/1"
FINE_MM, FINE_DEG = 0.2, 0.1
Values = dict[str, Any]


@dataclass(frozen=True, slots=True)
class Evaluation:
    """What is to be evaluated; plain values, so that another process can be told."""

    learned: str
    scene: str
    setups: int
    seed: int
    sector: Literal["front", "all"]
    arm: str
    noise: tuple[float, float] = (0.0, 0.0)
    sensor: bool = True

    def key(self) -> Values:
        """Return what must be the same for a record to be gone on with."""
        values = {name: value for name, value in asdict(self).items() if name != "setups"}
        values["noise"] = list(self.noise)
        values["learned"] = hashlib.sha256(_read(Path(self.learned))).hexdigest()
        return {"format": FORMAT, **values}


def _read(path: Path) -> bytes:
    try:
        return path.read_bytes()
    except OSError as error:
        what = f"cannot be read ({error.strerror})"
        raise BadInput.one(str(path), what, "name a task that was learned") from error


def scene_for(learned: Path) -> str:
    """Return the name of the first scene that has all a task is about."""
    from assistant.cli.fitting import fitting_scene
    from assistant.files.tasks import read_task

    return fitting_scene(read_task(learned), learned).name


class Finished:
    """The record of finished setups, by number.

    Parameters
    ----------
    path : Path
    key : mapping
        See `Evaluation.key`.
    """

    def __init__(self, path: Path, key: Values) -> None:
        self.path = path
        self.results: dict[int, Values] = {}
        self._key = key
        if path.exists():
            self._load()
        else:
            self._begin()

    @classmethod
    def of(cls, wanted: Evaluation, path: Path | None) -> Finished:
        """Return the record of an evaluation, kept under the home folder or at `path`."""
        from assistant.files.home import home

        key = wanted.key()
        if path is None:
            name = hashlib.sha256(json.dumps(key, sort_keys=True).encode()).hexdigest()[:16]
            path = home() / "evaluations" / f"{name}.jsonl"
        return cls(path, key)

    def _begin(self) -> None:
        try:
            self.path.parent.mkdir(parents=True, exist_ok=True)
        except OSError as error:
            raise self._unwritable(error) from error
        self._append(self._key)

    def _load(self) -> None:
        lines = _read(self.path).decode("utf-8", errors="replace").split("\n")
        first = _parsed(lines[0])
        if first != self._key:
            what = "is the record of something else"
            raise BadInput.one(f"{self.path}:1", what, "name another file, or remove it")
        whole = [parsed for line in lines[1:-1] if (parsed := _parsed(line)) is not None]
        self.results = {int(result["number"]): result for result in whole if "number" in result}
        if lines[-1]:
            self._append(None)

    def add(self, result: Values) -> None:
        """Keep the result of one setup."""
        self._append(result)
        self.results[int(result["number"])] = result

    def _append(self, values: Values | None) -> None:
        # None ends a torn line, so that the next one stands by itself.
        line = "" if values is None else json.dumps(values)
        try:
            with self.path.open("a", encoding="utf-8") as file:
                file.write(line + "\n")
        except OSError as error:
            raise self._unwritable(error) from error

    def _unwritable(self, error: OSError) -> BadInput:
        what = f"cannot be written ({error.strerror})"
        return BadInput.one(str(self.path), what, "name another file with --resume")

    def forget(self) -> None:
        """Remove the record: the evaluation is complete and has been told."""
        self.path.unlink(missing_ok=True)


def _parsed(line: str) -> Values | None:
    try:
        values = json.loads(line)
    except ValueError:
        return None
    return values if isinstance(values, dict) else None


def evaluated(
    wanted: Evaluation, finished: Finished, workers: int, tell: Callable[[str], None]
) -> list[Values]:
    """Practice what is not finished and return the results of all setups, in order."""
    numbers = [k for k in range(1, wanted.setups + 1) if k not in finished.results]
    if len(numbers) < wanted.setups:
        tell(f"{wanted.setups - len(numbers)} of {wanted.setups} were finished before")
    done = wanted.setups - len(numbers)
    for result in _results(wanted, numbers, min(workers, len(numbers))):
        finished.add(result)
        done += 1
        why = f": {result['reason']}" if result["reason"] else ""
        tell(f"{done} of {wanted.setups}  {result['name']} {result['status']}{why}")
    return [finished.results[number] for number in range(1, wanted.setups + 1)]


def _results(wanted: Evaluation, numbers: Sequence[int], workers: int) -> Iterator[Values]:
    if workers <= 1:
        worker = Worker(wanted) if numbers else None
        yield from (worker.practice(number) for number in numbers if worker is not None)
        return
    import multiprocessing

    context = multiprocessing.get_context("spawn")
    with context.Pool(workers, _begin, (wanted,)) as pool:
        yield from pool.imap_unordered(_practice, numbers)


_worker: list[Worker] = []


def _begin(wanted: Evaluation) -> None:
    # Ctrl-C is for the process that was started by hand: it ends the others.
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    _worker[:] = [Worker(wanted)]


def _practice(number: int) -> Values:
    return _worker[0].practice(number)


class Worker:
    """Practices setups by number; what needs to be done only once is kept."""

    def __init__(self, wanted: Evaluation) -> None:
        from assistant.cli.fitting import fitting_scene
        from assistant.cli.naming import learned_task
        from assistant.learning.adaptation import plan_adaptation
        from assistant.shells.pacing import RealClock
        from sim.planner import A465Planner

        path = Path(wanted.learned)
        self._wanted = wanted
        self._task = learned_task(path)
        self._scene = fitting_scene(self._task, path, wanted.scene)
        self._plan = plan_adaptation(self._task)
        self._planner, self._clock = A465Planner(), RealClock()

    def practice(self, number: int) -> Values:
        """Draw a setup and return how practice went in it."""
        from assistant.session.practice import SetupResult, practice_setup
        from sim.setups import random_setup

        wanted = self._wanted
        setup = random_setup(self._task, self._scene, wanted.seed, number, wanted.sector)
        try:
            result = practice_setup(
                self._task,
                self._scene,
                setup,
                arm=_arm(wanted, number),
                planner=self._planner,
                clock=self._clock,
                plan=self._plan,
            )
        except WorkFailed as error:
            result = SetupResult(setup.name, "missed", reason=str(error))
        return {"number": number, **result.values()}


def _arm(wanted: Evaluation, number: int) -> Arm:
    """Return an arm whose noise is that of one setup, whoever practices it and when."""
    from sim.sensor import InHandSensor, PlaceNoise

    distance_mm, angle_deg = wanted.noise
    sensor = InHandSensor(seed=number) if wanted.sensor else None
    noise = PlaceNoise(distance_mm / 1000.0, angle_deg, number) if any(wanted.noise) else None
    if wanted.arm == "kinematic":
        from sim.kinematic_arm import KinematicArm

        return KinematicArm(sensor=sensor, noise=noise)
    from sim.bullet_arm import BulletArm

    return BulletArm(sensor=sensor, noise=noise)


def told(results: Sequence[Values]) -> Values:
    """Return the JSON answer: every setup, the counts, the interval and causes of failures."""
    from assistant.session.practice import success_interval

    kinds = ("done", "missed", "refused")
    counts = {kind: sum(result["status"] == kind for result in results) for kind in kinds}
    setups = [{k: v for k, v in result.items() if k != "number"} for result in results]
    return {
        "setups": setups,
        **counts,
        "success_interval_95": list(success_interval(counts["done"], len(results))),
        "fine": sum(_fine(result) for result in results),
        "causes": dict(_causes(results)),
    }


def _fine(result: Values) -> bool:
    distance, angle = result["distance_mm"], result["angle_deg"]
    if distance is None or angle is None:
        return False
    return bool(distance <= FINE_MM and angle <= FINE_DEG)


def _causes(results: Sequence[Values]) -> list[tuple[str, int]]:
    failed = [result for result in results if result["status"] != "done"]
    plain = (re.sub(r"\d+(\.\d+)?", "#", f"{r['status']}: {r['reason']}") for r in failed)
    return Counter(plain).most_common()


def summary(answer: Mapping[str, Any]) -> str:
    """Return an answer for people."""
    total = len(answer["setups"])
    low, high = answer["success_interval_95"]
    lines = [
        f"done {answer['done']} of {total}: {answer['done'] / total:.1%} "
        f"(95 % between {low:.1%} and {high:.1%})",
        f"within {FINE_MM} mm and {FINE_DEG} deg: {answer['fine']}",
        f"missed {answer['missed']}, refused {answer['refused']}",
    ]
    lines += [f"  {count} x {cause}" for cause, count in answer["causes"].items()]
    return "\n".join(lines)
