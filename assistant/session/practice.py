"""Practice of one setup from end to end: adapt, plan, check, move, measure (paper III-D, IV-B)."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import asdict, dataclass, field, replace
from typing import Any, Literal

from assistant.dialogue.reporting import unmet_line
from assistant.errors import BadInput
from assistant.geometry import Array
from assistant.language.speech import phrase
from assistant.learning.adaptation import AdaptationPlan
from assistant.learning.preparing import carried_out
from assistant.model.motion import Alignment, ArmReport, JointPath, Refusal
from assistant.model.placing import alignments
from assistant.model.scene import Scene
from assistant.model.setup import Setup
from assistant.model.task import Task, primitives
from assistant.ports import Arm, Clock, Planner
from assistant.session.conditions import Surroundings, expectations
from assistant.session.heeding import Heeding
from assistant.session.ordering import planned

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

    Parts that may come in any order are done in another one where the one shown is refused.

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
    WorkFailed
        If the demonstration did not record the hand.
    """
    begun_s = clock.now_s() if clock else 0.0
    check_placed(task, setup)
    found = planned(task, scene, setup, planner, speed=speed, plan=plan)
    if isinstance(found.motion, Refusal):
        result = SetupResult(setup.name, "refused", reason=_refused(found.motion))
    elif arm is None:
        result = _planned(setup.name, found.motion)
    else:
        arm.arrange(scene, setup)
        around = Surroundings(scene, setup, found.path, arm.look().gripper_m)
        result = _run(arm, found.motion, found.task, around)
    return replace(result, wall_s=clock.now_s() - begun_s) if clock else result


def check_placed(task: Task, setup: Setup) -> None:
    """Refuse a task that was not learned, and a setup that lacks a place it needs."""
    if task.learned is None:
        raise BadInput.one(task.name, "nothing was learned for this task yet", "learn or teach it")
    stations = carried_out(task)[0].stations
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


def _run(arm: Arm, motion: JointPath, task: Task, around: Surroundings) -> SetupResult:
    begun_s = arm.look().now_s
    arm.start(motion)
    heeding = Heeding(arm, expectations(task), around)
    reports: list[ArmReport] = []
    period_s = _period(motion.t_s)
    # Resting while the gripper acts is not part of the motion's own time.
    patience = math.ceil((PATIENCE * float(motion.t_s[-1]) + 10.0) / period_s)
    for _ in range(patience):
        reports.extend(heeding.tick())
        if reports and reports[-1].kind in ("finished", "unmet", "halted"):
            break
    run = replace(
        _planned(around.setup.name, motion),
        sim_s=arm.look().now_s - begun_s,
        reports=tuple(reports),
    )
    last = reports[-1] if reports else None
    if last is not None and last.kind == "finished":
        return _judged(run, last)
    so_far = _measured(run, _let_go(arm, around, reports))
    return replace(so_far, status="missed", reason=_halted(last, task))


def _let_go(arm: Arm, around: Surroundings, reports: Sequence[ArmReport]) -> tuple[Alignment, ...]:
    """Return how well what was let go lies, in a run that did not come to its end."""
    opened = sum((told.text, told.object) == ("hand", "open") for told in reports)
    released = [stop for stop in around.path.stops if stop.kind == "release"][:opened]
    return alignments(around.scene, around.setup, released, arm.look().bodies)


def _period(t_s: Array) -> float:
    return float(t_s[1] - t_s[0]) if len(t_s) > 1 else 0.02


def _judged(run: SetupResult, last: ArmReport) -> SetupResult:
    measures = tuple(asdict(measure) for measure in last.measures)
    judged = _aligned(_measured(replace(run, measures=measures), last.alignments), last.alignments)
    bad = [measure for measure in last.measures if not measure.good]
    return replace(judged, status="missed", reason=str(bad[0])) if bad else judged


def _measured(run: SetupResult, found: Sequence[Alignment]) -> SetupResult:
    """Return a result with the worst distance and angle of what was let go."""
    if not found:
        return run
    distance, angle = max(one.distance_mm for one in found), max(one.angle_deg for one in found)
    return replace(run, distance_mm=distance, angle_deg=angle)


def _aligned(run: SetupResult, found: Sequence[Alignment]) -> SetupResult:
    bad = [one for one in found if one.distance_mm > CLOSE_MM or one.angle_deg > CLOSE_DEG]
    if not bad:
        return run
    worst = max(bad, key=lambda one: (one.distance_mm, one.angle_deg))
    off = f"{run.distance_mm:.2f} mm and {run.angle_deg:.2f} deg off on {worst.target}"
    return replace(run, status="missed", reason=f"{worst.object} lies {off}")


def _halted(last: ArmReport | None, task: Task) -> str:
    if last is None or last.kind not in ("unmet", "halted"):
        return "the run did not end in time"
    at = f"halted at {last.at_s:.1f} s"
    if last.kind == "halted":
        return f"{at}: {last.text}"
    leaves = primitives(task.tree)
    name = leaves[last.primitive_at].name if 0 <= last.primitive_at < len(leaves) else task.name
    return f"{at}. {phrase(unmet_line(last, name), brief=True)}"


HINTS: Mapping[str, str] = {
    "closer": "put it{} closer",
    "farther": "put it{} farther away",
    "turn": "turn it",
    "turn_left": "turn it{} to the left",
    "turn_right": "turn it{} to the right",
    "lower": "put it lower",
    "higher": "put it{} higher",
    "clear": "clear the way",
    "nothing": "neither closer nor farther nor turned can it be done there",
}


def _refused(refusal: Refusal) -> str:
    unit = "deg" if refusal.hint.startswith("turn") else "mm"
    hint = HINTS.get(refusal.hint, "").format(f" {refusal.by:g} {unit}" if refusal.by else "")
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
    # At the ends exactly: rounding must not leave all of them a hair below all.
    return (middle - half if done else 0.0), (middle + half if done < total else 1.0)
