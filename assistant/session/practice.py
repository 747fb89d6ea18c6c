"""Practice of one setup from end to end: adapt, plan, check, move, measure (paper III-D, IV-B)."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import asdict, dataclass, field, replace
from typing import Any, Literal

from assistant.errors import BadInput
from assistant.geometry import Array
from assistant.learning.adaptation import AdaptationPlan, adapt, plan_adaptation
from assistant.model.motion import ArmReport, JointPath, Refusal
from assistant.model.scene import Scene
from assistant.model.setup import Setup
from assistant.model.task import Task
from assistant.ports import Arm, Clock, Planner

Status = Literal["done", "missed", "refused"]

CLOSE_MM, CLOSE_DEG = 1.0, 1.0
"""A setup is done if every object ends within this of its place; the paper's worst is 1 mm."""
PATIENCE = 3.0
"""A run that takes so many times what was planned, and ten seconds, will not end."""


@dataclass(frozen=True, slots=True, eq=False)
class SetupResult:
    """How practice went in one setup.

    Parameters
    ----------
    name : str
        Of the setup.
    status : {"done", "missed", "refused"}
    distance_mm, angle_deg : float or None
        Of the worst object: corners from their places, and edges from theirs. None where
        nothing was let go.
    reason : str
        Why it was missed or refused; empty when done.
    joint_margin_deg, peak_joint_speed_ratio, peak_hand_speed_m_s : float or None
        As planned; None if refused.
    sim_s, wall_s : float
        Simulated time of the run, and time spent on it.
    note : str
        What was changed on the way.
    motion : JointPath or None
        What was planned.
    reports : tuple of ArmReport
        What the arm told.
    measures : tuple of mapping
        What tells success where alignment does not; the fields of `Measure`.
    """

    name: str
    status: Status
    distance_mm: float | None = None
    angle_deg: float | None = None
    reason: str = ""
    joint_margin_deg: float | None = None
    peak_joint_speed_ratio: float | None = None
    peak_hand_speed_m_s: float | None = None
    sim_s: float = 0.0
    wall_s: float = 0.0
    note: str = ""
    motion: JointPath | None = None
    reports: tuple[ArmReport, ...] = field(default=(), repr=False)
    measures: tuple[Mapping[str, Any], ...] = ()

    def values(self) -> dict[str, Any]:
        """Return the fields of a JSON answer."""
        left_out = ("motion", "reports", *(() if self.measures else ("measures",)))
        kept = replace(self, motion=None, reports=())
        return {key: value for key, value in asdict(kept).items() if key not in left_out}


def practice_setup(
    task: Task,
    scene: Scene,
    setup: Setup,
    *,
    arm: Arm | None,
    planner: Planner,
    speed: float = 1.0,
    clock: Clock | None = None,
    plan: AdaptationPlan | None = None,
) -> SetupResult:
    """Carry out a learned task in one setup and return how well it went.

    Parameters
    ----------
    task : Task
        With a lesson.
    scene : Scene
    setup : Setup
        A place for everything the lesson is about.
    arm : Arm or None
        None plans and checks, but moves nothing.
    planner : Planner
    speed : float
        Factor of the demonstration's speed.
    clock : Clock, optional
        Measures `SetupResult.wall_s`.
    plan : AdaptationPlan, optional
        What `plan_adaptation` returned for this task, to save doing it again.

    Raises
    ------
    BadInput
        If nothing was learned yet, or something needed has no place.
    """
    begun_s = clock.now_s() if clock else 0.0
    check_placed(task, setup)
    path = adapt(plan or plan_adaptation(task), scene, setup, speed=speed)
    motion = planner.plan(path, scene, setup)
    if isinstance(motion, Refusal):
        result = SetupResult(setup.name, "refused", reason=_refused(motion))
    elif arm is None:
        result = _planned(setup.name, motion)
    else:
        arm.arrange(scene, setup)
        result = _run(arm, motion, _planned(setup.name, motion))
    return replace(result, wall_s=clock.now_s() - begun_s) if clock else result


def check_placed(task: Task, setup: Setup) -> None:
    """Refuse a task that was not learned, and a setup that lacks a place it needs."""
    if task.learned is None or task.learned.path is None:
        raise BadInput.one(task.name, "nothing was learned for this task yet", "learn or teach it")
    stations = task.learned.stations
    needed = dict.fromkeys(name for stop in stations for name in (stop.object, stop.frame) if name)
    missing = [name for name in needed if name not in setup.places]
    if missing:
        places = ", ".join(setup.places) or "none"
        told = ", ".join(missing)
        raise BadInput.one(setup.name, f"no place for {told}", f"it has places for: {places}")


def _planned(name: str, motion: JointPath) -> SetupResult:
    return SetupResult(
        name,
        "done",
        joint_margin_deg=motion.joint_margin_deg,
        peak_joint_speed_ratio=motion.peak_joint_speed_ratio,
        peak_hand_speed_m_s=motion.peak_hand_speed_m_s,
        sim_s=float(motion.t_s[-1]),
        note=motion.note,
        motion=motion,
    )


def _run(arm: Arm, motion: JointPath, planned: SetupResult) -> SetupResult:
    begun_s = arm.look().now_s
    arm.start(motion)
    reports: list[ArmReport] = []
    period_s = _period(motion.t_s)
    # Resting while the gripper acts is not part of the motion's own time.
    patience = math.ceil((PATIENCE * float(motion.t_s[-1]) + 10.0) / period_s)
    for _ in range(patience):
        reports.extend(arm.tick())
        if reports and reports[-1].kind in ("finished", "unmet", "halted"):
            break
    sim_s = arm.look().now_s - begun_s
    return _judged(replace(planned, sim_s=sim_s, reports=tuple(reports)))


def _period(t_s: Array) -> float:
    return float(t_s[1] - t_s[0]) if len(t_s) > 1 else 0.02


def _judged(run: SetupResult) -> SetupResult:
    last = run.reports[-1] if run.reports else None
    if last is None or last.kind != "finished":
        return replace(run, status="missed", reason=_halted(last))
    measures = tuple(asdict(measure) for measure in last.measures)
    judged = _aligned(replace(run, measures=measures), last)
    bad = [measure for measure in last.measures if not measure.good]
    return replace(judged, status="missed", reason=str(bad[0])) if bad else judged


def _aligned(run: SetupResult, last: ArmReport) -> SetupResult:
    if not last.alignments:
        return run
    distance = max(found.distance_mm for found in last.alignments)
    angle = max(found.angle_deg for found in last.alignments)
    measured = replace(run, distance_mm=distance, angle_deg=angle)
    if distance <= CLOSE_MM and angle <= CLOSE_DEG:
        return measured
    worst = max(last.alignments, key=lambda found: (found.distance_mm, found.angle_deg))
    reason = f"{worst.object} lies {distance:.2f} mm and {angle:.2f} deg off on {worst.target}"
    return replace(measured, status="missed", reason=reason)


def _halted(last: ArmReport | None) -> str:
    if last is None or last.kind not in ("unmet", "halted"):
        return "the run did not end in time"
    about = f" {last.object}" if last.object else ""
    onto = f" on {last.target}" if last.target else ""
    if last.kind == "halted":
        return f"halted at {last.at_s:.1f} s: {last.text}"
    return f"halted at {last.at_s:.1f} s: {UNMET.get(last.text, last.text)}{about}{onto}"


UNMET: Mapping[str, str] = {
    "held": "not in the hand:",
    "hand": "the hand should be",
    "clear": "still in the hand:",
    "on": "not where it belongs:",
    "contact": "unexpected contact with",
    "tracking": "the arm left its path",
}
"""What an unmet condition is called, followed by the body it is about."""

HINTS: Mapping[str, str] = {
    "closer": "put it closer",
    "farther": "put it farther away",
    "turn": "turn it",
    "lower": "put it lower",
    "clear": "clear the way",
}


def _refused(refusal: Refusal) -> str:
    hint = HINTS.get(refusal.hint, "")
    return f"{refusal}; {hint}" if hint else str(refusal)


def tally(results: Sequence[SetupResult]) -> dict[str, Any]:
    """Return the JSON answer of practice: every setup, how many of each kind, and the interval."""
    count = {kind: sum(r.status == kind for r in results) for kind in ("done", "missed", "refused")}
    return {
        "setups": [result.values() for result in results],
        **count,
        "success_interval_95": list(success_interval(count["done"], len(results))),
    }


def success_interval(done: int, total: int) -> tuple[float, float]:
    """Return the 95 % interval of a success rate (Wilson's), within [0, 1]."""
    if total == 0:
        return 0.0, 1.0
    z = 1.959964
    rate, share = done / total, z * z / total
    middle = (rate + share / 2.0) / (1.0 + share)
    half = z * math.sqrt(rate * (1.0 - rate) / total + share / (4.0 * total)) / (1.0 + share)
    return max(0.0, middle - half), min(1.0, middle + half)
