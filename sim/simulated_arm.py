"""An arm that carries out checked motions in a simulated world and tells how it goes.

It keeps the Arm port's promises for both adapters: the stop flag is read by every tick,
stopping latches and keeps the grip, conditions are checked while it runs, a grasped body is
looked at and the release corrected, and what happens is reported.
"""

from __future__ import annotations

import threading
from dataclasses import replace

import numpy as np

from assistant.errors import WorkFailed
from assistant.geometry import IDENTITY, Array, compose, inverse
from assistant.model.motion import ArmReport, HandStop, JointPath, ReportKind
from assistant.model.placing import states, told_bodies, turned_back
from assistant.model.scene import Scene
from assistant.model.setup import Setup
from assistant.ports import ArmLook
from sim import a465
from sim.correction import checked, matters, release_offset, slipped
from sim.gripping import Grip
from sim.kinematics import forward
from sim.measures import finished
from sim.playback import Playback, planned_reports
from sim.rechecking import still_free
from sim.sensor import InHandSensor, PlaceNoise
from sim.starting import joints_at, same_pose
from sim.touching import Trace, allowed_at
from sim.world import CONTROL_S, EASED, Allowed, Fault, World

NOT_WHERE_PLANNED_DEG = 1.0
"""A motion must begin this close to where the arm is."""
LOST_TICKS = 3
SETTLED_SHARE = 0.25
"""A correction on arrival is complete by this share of the way down: a peg is not in yet."""
SETTLING_TICKS = 8
"""What the pads strained while the hand turned is gone so long after its arrival."""


class SimulatedArm:
    """The Arm port over a world.

    Parameters
    ----------
    world : World
    stop_flag : threading.Event, optional
        Read by every tick; who set it clears it before the next start.
    sensor : InHandSensor or None
        Looks at a grasped body; None leaves the release as planned.
    noise : PlaceNoise, optional
        Errors of the told places of bodies that can be carried.
    """

    def __init__(
        self,
        world: World,
        stop_flag: threading.Event | None = None,
        *,
        sensor: InHandSensor | None = None,
        noise: PlaceNoise | None = None,
    ) -> None:
        self.world = world
        self._flag = stop_flag or threading.Event()
        self._sensor = sensor
        self._noise = noise
        self._scene, self._setup = Scene(), Setup()
        self._told: dict[str, Array] = {}
        self._playback: Playback | None = None
        self._q = np.array(a465.READY)
        self._hand = forward(self._q)
        self._now_s = self._began_s = 0.0
        self._grip = Grip()
        self._carried = ""
        self._supposed: Array | None = None
        self._fresh = True
        self._rest()

    def _rest(self) -> None:
        self._why, self._primitive, self._lost = "", -1, 0
        self._grip.rest()
        self._offset: Array = np.array(IDENTITY)
        self._misfit: Fault | None = None
        self._released: list[HandStop] = []
        self._trace = Trace()
        self._told_samples: list[tuple[int, ArmReport]] = []

    def arrange(self, scene: Scene, setup: Setup) -> None:
        """Put the arm at the robot start and every body at its place."""
        self._scene, self._setup = scene, setup
        self._told = told_bodies(scene, setup)
        self._q = joints_at(setup.robot_start.pose)
        self._hand = forward(self._q)
        self._playback, self._carried = None, ""
        self._now_s, self._grip, self._supposed, self._fresh = 0.0, Grip(), None, True
        self._rest()
        bodies = self._noise.misplaced(self._told, scene) if self._noise else dict(self._told)
        self.world.arrange(scene, bodies, self._q)

    def look(self) -> ArmLook:
        """Return what is measured now."""
        q, opening = self.world.joints()
        held = self.world.held()
        moving = self._playback is not None
        return ArmLook(q, forward(q), opening, held, self.world.bodies(), moving, self._now_s)

    def start(self, motion: JointPath) -> None:
        """Begin to carry out a checked motion.

        Raises
        ------
        WorkFailed
            If the motion does not begin where the arm is.
        """
        if self._fresh:
            self._seat(motion.q[0])
        away = float(np.rad2deg(np.max(np.abs(self.world.joints()[0] - motion.q[0]))))
        if away > NOT_WHERE_PLANNED_DEG:
            raise WorkFailed(f"the motion begins {away:.1f} deg from where the arm is; plan anew")
        self._rest()
        self._fresh = False
        self._began_s = self._now_s
        self._playback = Playback(motion)
        self._told_samples = planned_reports(motion)
        if not self._carried:
            self._grip.opening_m = float(np.clip(motion.gripper_m[0], 0.0, a465.GRIPPER.open_m))
        elif self._playback.pending and self._playback.pending[0].kind == "release":
            self._correct(self._carried, 0)

    def _seat(self, q: Array) -> None:
        # A setup tells where the hand starts; which joint angles hold it there is the plan's.
        if same_pose(forward(q), self._hand):
            self._q = q
            self.world.seat(q)

    def stop(self, why: str) -> None:
        """Brake now, keep the grip, discard what was started."""
        if self._playback is not None and not self._why:
            self._why = why
            self._playback.brake()

    def tick(self) -> tuple[ArmReport, ...]:
        """Advance by one control period and return what there is to tell."""
        if self._playback is None:
            self.world.step(self._q, self._hand, self._grip.opening_m, Allowed(self._carried))
            self._now_s += CONTROL_S
            return ()
        if self._flag.is_set():
            self.stop("stop")
        return self._run(self._playback)

    def _run(self, playback: Playback) -> tuple[ArmReport, ...]:
        acting = playback.at_station and not playback.braking
        if not acting:
            playback.advance()
            self._look_again(playback)
            self._q, self._hand = playback.now()
            self._ease_early(playback)
            if self._carried:
                self._hold(playback)
        stops, sample = playback.motion.stops, playback.sample
        allowed = allowed_at(stops, sample, self._carried, self._grip.share)
        fault = self.world.step(self._q, self._hand, self._grip.opening_m, allowed)
        self._trace.see(stops, sample, self._carried, self.world)
        self._now_s += CONTROL_S
        told, fault = self._passed(playback), fault or self._misfit
        if fault is None and self._carried and not acting and self._grip.share == 1.0:
            fault = self._lost_grip()
        if fault is not None:
            halted = self._halt("unmet", fault.text, fault.body, fault.target)
            return (*told, replace(halted, amount=fault.amount, unit=fault.unit))
        if playback.at_rest:
            return (*told, self._halt("halted", self._why))
        if playback.braking:
            return tuple(told)
        if playback.at_station:
            return (*told, *self._act(playback, playback.pending[0]))
        if playback.over:
            return (*told, self._finish(playback))
        return tuple(told)

    def _ease_early(self, playback: Playback) -> None:
        # A body that stands while it is still pressed between the pads creeps on its support.
        stop = playback.pending[0] if playback.pending else None
        if stop is None or stop.kind != "release" or playback.braking:
            return
        if stop.docking_at < playback.sample and playback.stands:
            self._grip.ease()

    def _hold(self, playback: Playback) -> None:
        # Whoever stops meanwhile wants the grip kept.
        grip, opening_m = self._grip, self.world.joints()[1]
        if grip.share <= EASED and playback.rests and not playback.braking:
            grip.part(opening_m)
        else:
            grip.press(opening_m)

    def _lost_grip(self) -> Fault | None:
        self._lost = 0 if self.world.held() == self._carried else self._lost + 1
        return Fault("held", self._carried) if self._lost > LOST_TICKS else None

    def _act(self, playback: Playback, stop: HandStop) -> tuple[ArmReport, ...]:
        closing, grip = stop.kind == "grasp", self._grip
        if closing and grip.acting_s == 0.0 and stop.object in self._told:
            self._supposed = compose(inverse(playback.hands[stop.at]), self._told[stop.object])
        done = grip.act(self.world.joints()[1], closing=closing)
        return self._acted(playback, stop) if done else ()

    def _acted(self, playback: Playback, stop: HandStop) -> tuple[ArmReport, ...]:
        playback.pending.pop(0)
        self._grip.rest()
        held = self.world.held()
        if stop.kind == "release":
            return self._let_go(stop, held)
        if held != stop.object:
            return (self._halt("unmet", "held", stop.object),)
        self._carried, self._offset = held, np.array(IDENTITY)
        if held:
            self._correct(held, min(stop.left_at, playback.motion.t_s.size - 1))
        closed = self._report("perceived", "hand", "closed")
        return (closed, self._report("perceived", "held", held)) if held else (closed,)

    def _let_go(self, stop: HandStop, held: str) -> tuple[ArmReport, ...]:
        self._carried = ""
        opened = self._report("perceived", "hand", "open")
        if held:
            return opened, self._halt("unmet", "clear", held)
        self._released.append(stop)
        bodies = self.world.bodies()
        if stop.object not in bodies or stop.frame not in self._setup.places:
            return (opened,)
        self._told[stop.object] = bodies[stop.object]
        about = (stop.object, stop.frame)
        if not (seen := states(self._scene, self._setup, stop, bodies)):
            return opened, self._halt("unmet", "on", *about)
        return opened, *(self._report("perceived", text, *about) for text in seen)

    def _correct(self, held: str, begin: int, full: int = 0) -> None:
        """Look at the body in the hand and move its release accordingly."""
        playback, supposed = self._playback, self._supposed
        if playback is None or self._sensor is None or supposed is None:
            return
        stop = playback.pending[0] if playback.pending else None
        if stop is None or stop.kind != "release" or not stop.frame:  # let go of anywhere
            return
        in_hand = compose(inverse(forward(self.world.joints()[0])), self.world.bodies()[held])
        seen = turned_back(self._scene.bodies[held], self._sensor.look(in_hand), supposed)
        offset = release_offset(supposed, seen)
        if offset is None:
            self._misfit = slipped(held, supposed, seen)
            return
        more = compose(inverse(self._offset), offset)
        free = still_free(self._scene, self._setup, self.look(), begin)
        done = checked(playback.motion, more, begin, full or stop.docking_at, stop, free)
        if done is not None:
            playback.replace(done[0])
            self._offset = compose(self._offset, done[1])
        elif matters(more):
            self._misfit = Fault("aligned", held, stop.frame)

    def _look_again(self, playback: Playback) -> None:
        # What crept while the body was carried is seen on arrival at the docking pose.
        stop = playback.pending[0] if playback.pending else None
        if stop is None or not self._carried:
            return
        down = max(int(SETTLED_SHARE * (stop.at - stop.docking_at)), 1)
        if playback.sample == stop.docking_at + min(SETTLING_TICKS, down // 2):
            self._correct(self._carried, playback.sample, stop.docking_at + down)

    def _passed(self, playback: Playback) -> list[ArmReport]:
        told = []
        # Where the gripper has yet to act, the primitive before is not over.
        sample = playback.sample - 1 if playback.at_station else playback.sample
        primitive = int(playback.motion.primitive_at[max(sample, 0)])
        while self._told_samples and self._told_samples[0][0] <= playback.sample:
            report = self._told_samples.pop(0)[1]
            told.append(self._report(report.kind, report.text, report.object))
        if primitive != self._primitive:
            self._primitive = primitive
            told.append(self._report("primitive"))
        return told

    def _report(
        self, kind: ReportKind, text: str = "", name: str = "", target: str = ""
    ) -> ArmReport:
        return ArmReport(kind, self._now_s - self._began_s, self._primitive, text, name, target)

    def _halt(self, kind: ReportKind, text: str, name: str = "", target: str = "") -> ArmReport:
        # Halted while the fingers opened, it was let go all the same.
        self._carried = self._carried if self.world.held() or self._grip.share > EASED else ""
        self._playback = None
        return self._report(kind, text, name, target)

    def _finish(self, playback: Playback) -> ArmReport:
        self._playback = None
        touched = [stop for stop in playback.motion.stops if stop.kind == "touch"]
        stops, told = [*self._released, *touched], self._report("finished")
        return finished(told, self._scene, self._setup, stops, self.world.bodies(), self._trace)
