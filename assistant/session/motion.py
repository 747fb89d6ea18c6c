"""The arm's side of a session: checking a setup, starting a run, ticking, halting.

Motion is adapted (paper III-D a), planned and checked before anything moves; a stop that
arrives meanwhile wins. After a halt a run goes on from the measured pose, checked anew. What is
told to move while the arm still brakes is latched until it stands; another stop discards it.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Any

from assistant.dialogue import effects as wanted
from assistant.dialogue.events import Checked, Event
from assistant.geometry import pose_to_mm_deg
from assistant.model.motion import ArmReport, HandPath, JointPath, Refusal
from assistant.model.scene import Scene
from assistant.model.setup import Setup
from assistant.ports import ArmLook
from assistant.session import paths
from assistant.session.carrying import unfit
from assistant.session.conditions import Expected, Surroundings, expectations
from assistant.session.equipment import Equipment
from assistant.session.heeding import Heeding
from assistant.session.holding import with_held
from assistant.session.latching import Latch

if TYPE_CHECKING:
    from assistant.session.ordering import Planned

ENDS = ("finished", "halted", "unmet")
"""Reports after which the arm rests."""


@dataclass(frozen=True, slots=True, eq=False)
class Run:
    """A run that was checked: what the hand is to follow, and the joints for it.

    Parameters
    ----------
    scene, setup
    path : HandPath
        The whole of it, also where only a rest is left to do.
    motion : JointPath
    conditions : Expected
        Of its primitives; none where a demonstration is replayed as it was.
    order : tuple of str
        Of parts that may come in any, as they are done; empty where that is as shown.
    """

    scene: Scene
    setup: Setup
    path: HandPath
    motion: JointPath
    conditions: Expected = ()
    order: tuple[str, ...] = ()


class Mover:
    """Moves the arm for a session.

    Parameters
    ----------
    equipment : Equipment
    """

    def __init__(self, equipment: Equipment) -> None:
        self._equipment = equipment
        self._checked: Run | None = None
        self._run: Run | None = None
        self._waiting = False
        self._pauses = False
        self._is_aside = False
        self._latch = Latch()
        self.braking = False
        self._started_s = self._lasts_s = 0.0
        self._primitive_at = -1
        self._heeding: Heeding | None = None
        self._open_m = 0.0
        self.scene = Scene()
        self.setup = Setup()
        self.moving = False

    @property
    def look(self) -> ArmLook:
        """What is measured now."""
        return self._equipment.arm.look()

    @property
    def now_s(self) -> float:
        """Simulated time."""
        return self.look.now_s

    @property
    def run_s(self) -> float:
        """Simulated time since the motion began."""
        return self.now_s - self._started_s

    @property
    def left_s(self) -> float:
        """Simulated time until the motion ends, if nothing comes between."""
        return max(self._lasts_s - self.run_s, 0.0) if self.moving else 0.0

    @property
    def under_way(self) -> bool:
        """Whether a run has begun and is not over, be it halted or not."""
        return self._run is not None

    def view(self) -> dict[str, Any]:
        """Return plain values of the arm for transcripts."""
        look = self.look
        xyz_mm, rpy_deg = pose_to_mm_deg(look.hand)
        bodies = {name: pose_to_mm_deg(pose) for name, pose in look.bodies.items()}
        return {
            "moving": self.moving,
            "held": look.held,
            "gripper_mm": look.gripper_m * 1000.0,
            "hand_xyz_mm": xyz_mm.tolist(),
            "hand_rpy_deg": rpy_deg.tolist(),
            "bodies": {
                name: {"xyz_mm": xyz.tolist(), "rpy_deg": rpy.tolist()}
                for name, (xyz, rpy) in bodies.items()
            },
        }

    def arrange(self, scene: Scene, setup: Setup) -> None:
        """Put everything where the setup says; the arm goes to its start."""
        self._equipment.arm.arrange(scene, setup)
        self.scene, self.setup = scene, setup
        self._checked = self._run = None
        self.moving = self._waiting = self.braking = False
        self._latch.clear()
        self._open_m = self.look.gripper_m

    def check(self, effect: wanted.Check) -> Checked:
        """Adapt the task to a setup and check the motion, moving nothing.

        Of a halted run (`anew`) only the rest, from the measured pose.
        """
        found = self._rest_planned(effect) if effect.anew else self._whole_planned(effect)
        if isinstance(found.motion, Refusal):
            return Checked(effect.setup, found.motion)
        conditions, motion = expectations(found.task), found.motion
        run = Run(effect.scene, effect.setup, found.path, motion, conditions, found.order)
        self._checked = run
        return Checked(effect.setup, None, float(motion.t_s[-1]), motion.note)

    def _whole_planned(self, effect: wanted.Check) -> Planned:
        # Planning, and all that learning imports, happens where it is first needed.
        from assistant.session.ordering import planned

        planner = self._equipment.planner
        return planned(effect.task, effect.scene, effect.setup, planner, speed=effect.speed)

    def _rest_planned(self, effect: wanted.Check) -> Planned:
        """Plan what is left of a run, in the order it was begun in."""
        from assistant.session.ordering import Planned, in_order

        order = () if self._run is None else self._run.order
        task, look = in_order(effect.task, order), self.look
        whole = paths.adapted(task, effect.scene, effect.setup, effect.speed)
        rest = paths.rest_of(whole, look, self._primitive_at, effect.scene)
        found = self._equipment.planner.plan(rest, effect.scene, effect.setup, look)
        return Planned(task, order, whole, found)

    def move(self, effect: wanted.Move) -> ArmReport | None:
        """Begin what was checked last; unless it is the rest of a run, all is put in place.

        Of a rest that cannot be done with what is in the hand, why is returned.
        """
        run, self._checked = self._checked, None
        if run is None:
            return None
        if not effect.anew:
            self.arrange(run.scene, run.setup)
        elif (unfit := self._unfit(run.path)) is not None:
            return unfit
        self._pauses = effect.pause_before_primitives
        self._begin(run, anew=effect.anew)
        return None

    def replay(self, effect: wanted.Replay) -> Refusal | None:
        """Carry out a demonstration as it was shown, checked like any motion."""
        path = paths.as_shown(effect.task, effect.demonstration, effect.speed)
        self.arrange(self.scene, effect.setup)
        self._pauses = False
        found = self._equipment.planner.plan(path, self.scene, self.setup)
        if isinstance(found, Refusal):
            return found
        self._begin(Run(self.scene, self.setup, path, found), anew=False)
        return None

    def go_on(self, *, anew: bool) -> Refusal | ArmReport | None:
        """Continue after an announcement, or (`anew`) after a halt from where the arm is.

        What was halted while it was being announced is not moved by the end of the announcement.
        """
        self._waiting = False
        if not anew or self._run is None:
            return None
        if (unfit := self._unfit(self._run.path)) is not None:
            return unfit
        look = self.look
        rest = paths.rest_of(self._run.path, look, self._primitive_at, self.scene)
        found = self._equipment.planner.plan(rest, self.scene, self.setup, look)
        if isinstance(found, Refusal):
            return found
        self._begin(replace(self._run, motion=found), anew=True)
        return None

    def _unfit(self, path: HandPath) -> ArmReport | None:
        look = self.look
        start = paths.goes_on_at(path, look, self._primitive_at, self.scene)
        return unfit(path, start, look, self._primitive_at, self.run_s)

    def halt(self, why: str) -> None:
        """Brake now; what was started, or was to be started then, is discarded."""
        self._waiting = False
        self._latch.discard()
        self.braking = self.moving
        self._equipment.arm.stop(why)

    def latches(self, effect: wanted.Effect) -> bool:
        """Keep what has to wait until an arm that is coming to rest stands; tell whether so."""
        settling = self.moving and (self.braking or self._is_aside)
        return settling and self._latch.keeps(effect)

    def released(self, event: Event) -> tuple[wanted.Effect, ...]:
        """Return what was latched, once the dialogue has heard that the arm stands."""
        return self._latch.released(event)

    def set_hand(self, command: str) -> Refusal | None:
        """Open or close the hand where it is."""
        return self._aside(paths.hand_only(self.look, self.scene, command, self._open_m))

    def jog(self, offset_m: tuple[float, ...], turn_rad: tuple[float, ...]) -> Refusal | None:
        """Move the hand by a small step."""
        return self._aside(paths.step_by(self.look, offset_m, turn_rad))

    def home(self, setup: Setup) -> Refusal | None:
        """Bring the hand back to where a setup has it start; what it holds stays in it."""
        return self._aside(paths.straight_to(self.look, setup.robot_start.pose))

    def tick(self) -> tuple[ArmReport, ...]:
        """Advance by one control period; nothing passes while an announcement is made."""
        if not self.moving or self._waiting:
            return ()
        heeding = None if self._is_aside else self._heeding
        reports = self._equipment.arm.tick() if heeding is None else heeding.tick()
        for report in reports:
            self._take(report)
        if self.moving:
            return reports
        return self._latch.before(with_held(reports, self.look, self.scene))

    def _take(self, report: ArmReport) -> None:
        if report.kind in ENDS:
            self.moving = self._waiting = self.braking = False
        if self._is_aside:
            return
        if report.kind == "primitive":
            self._primitive_at = report.primitive_at
            self._waiting = self._pauses
        if report.kind == "finished":
            self._run = None

    def _aside(self, path: HandPath) -> Refusal | None:
        """Make a small motion at rest; a halted run is kept, to be gone on with."""
        look = self.look
        found = self._equipment.planner.plan(path, self.scene, self.setup, look)
        if isinstance(found, Refusal):
            return found
        self._start(found)
        self._is_aside = True
        return None

    def _begin(self, run: Run, *, anew: bool) -> None:
        done = self._heeding.done if anew and self._heeding is not None else -1
        self._primitive_at = self._primitive_at if anew else -1
        around = Surroundings(run.scene, run.setup, run.path, self._open_m)
        self._heeding = Heeding(self._equipment.arm, run.conditions, around, done)
        self._run = run
        self._start(run.motion)

    def _start(self, motion: JointPath) -> None:
        self._is_aside = self._waiting = False
        self._started_s = self.now_s
        self._lasts_s = float(motion.t_s[-1])
        self._equipment.arm.start(motion)
        self.moving = True
