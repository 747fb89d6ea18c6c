"""Arm, gripper and bodies in PyBullet, with real contact: what is held is held by friction.

The arm's joints are position drives with velocity feed-forward, followed step by step; the
fingers are coupled as in a real parallel gripper and press with a bounded force. Nothing ties
a body to the hand.
"""

from __future__ import annotations

import math
import tempfile
from collections.abc import Mapping, Sequence
from pathlib import Path

import numpy as np

from assistant.geometry import Array, compose, inverse
from assistant.model.scene import Scene
from sim import a465
from sim.bullet_bodies import add_body, add_obstacle, middle_in_base
from sim.bullet_client import Client
from sim.bullet_settings import BulletSettings
from sim.kinematics import forward
from sim.touching import contents
from sim.urdf import ARM_JOINTS, FINGER_JOINTS, PAD_LINKS, write_urdf
from sim.world import CONTROL_S, EASED, Allowed, Fault

OTHER, LINK, FORCE = 2, 3, 9
"""Fields of a contact point: the other body, the own link, the normal force."""
RENEW_RAD, RENEW_STILL_RAD = np.deg2rad(3.0), np.deg2rad(0.5)
"""Contacts of a hand that has turned by more are found anew; each time a body may slip a little.
A hand that does not turn any more has them found anew earlier: what strains the pads is gone
before a body is looked at and let go."""
STILL_RAD = np.deg2rad(0.01)
"""A hand that turns less in a tick does not turn."""
LATER_TICKS = 2
"""The second pad finds its contacts so long after the first."""


class BulletWorld:
    """Contact physics around the arm.

    Parameters
    ----------
    window : bool
        Show it.
    settings : BulletSettings, optional
    """

    def __init__(self, *, window: bool = False, settings: BulletSettings | None = None) -> None:
        self.settings = settings or BulletSettings()
        self._client = Client(window=window)
        self._steps = round(self.settings.physics_hz * CONTROL_S)
        self._numbers: dict[str, int] = {}
        self._bases: dict[str, Array] = {}
        self._names: dict[int, str] = {}
        self._q = np.array(a465.READY)
        self._finger_m = a465.GRIPPER.open_m / 2
        self._arm = -1
        self._eased = False

    def arrange(self, scene: Scene, bodies: Mapping[str, Array], q: Array) -> None:
        """Put arm and bodies at their places, the hand open."""
        client, settings = self._client, self.settings
        client.resetSimulation()
        client.setGravity(0.0, 0.0, -9.81)
        client.setPhysicsEngineParameter(
            fixedTimeStep=1.0 / settings.physics_hz,
            numSolverIterations=settings.iterations,
            solverResidualThreshold=0.0,
            frictionERP=settings.friction_erp,
            deterministicOverlappingPairs=1,
        )
        self._load_arm()
        self._names = {add_obstacle(client, b): b.name for b in (*scene.tables, *scene.obstacles)}
        self._tables = set(self._names)
        known = {name: pose for name, pose in bodies.items() if name in scene.bodies}
        self._numbers = {n: add_body(client, scene.bodies[n], p) for n, p in known.items()}
        self._inside = {self._numbers[name] for name in contents(scene, known)}
        self._names.update({number: name for name, number in self._numbers.items()})
        self._bases = {n: inverse(middle_in_base(scene.bodies[n].size_mm[2])) for n in known}
        self._fixed = {n: p for n, p in bodies.items() if n not in known}
        self._easing = "nothing"
        self._eased = False
        self._parts = 0
        self._found_at = self._hand = forward(q)
        self._late = 0
        self._anchor("")
        self.seat(q)

    def _load_arm(self) -> None:
        client, settings = self._client, self.settings
        with tempfile.TemporaryDirectory() as folder:
            self._arm = client.loadURDF(
                str(write_urdf(Path(folder))),
                useFixedBase=True,
                flags=client.URDF_USE_INERTIA_FROM_FILE,
            )
        infos = [client.getJointInfo(self._arm, k) for k in range(client.getNumJoints(self._arm))]
        number = {info[1].decode(): info[0] for info in infos}
        link = {info[12].decode(): info[0] for info in infos}
        self._joints = [number[name] for name in ARM_JOINTS]
        self._fingers = [number[name] for name in FINGER_JOINTS]
        self._pads = [link[name] for name in PAD_LINKS]
        for k in range(-1, len(infos)):
            client.changeDynamics(
                self._arm, k, linearDamping=0.0, angularDamping=0.0, jointDamping=0.0
            )
        gear = client.createConstraint(
            self._arm,
            self._fingers[0],
            self._arm,
            self._fingers[1],
            client.JOINT_GEAR,
            [0, 1, 0],
            [0, 0, 0],
            [0, 0, 0],
        )
        client.changeConstraint(
            gear, gearRatio=-1, maxForce=settings.gear_force, erp=settings.gear_erp
        )

    def seat(self, q: Array) -> None:
        """Put the joints elsewhere at once, before anything has moved."""
        self._q, self._finger_m = np.array(q), a465.GRIPPER.open_m / 2
        for joint, angle in zip(self._joints, q, strict=True):
            self._client.resetJointState(self._arm, joint, float(angle))
        for finger in self._fingers:
            self._client.resetJointState(self._arm, finger, self._finger_m)

    def step(self, q: Array, hand: Array, opening_m: float, allowed: Allowed) -> Fault | None:
        """Advance by one control tick, a whole number of physics steps."""
        force = self.settings.grip_n * allowed.grip
        self._refine(bool(allowed.grasped))
        self._anchor(allowed.grasped if allowed.grip < 1.0 else "")
        self._let_go(allowed.grip <= EASED)
        self._renew(hand)
        share = np.arange(self._steps)[:, None] / self._steps
        joints = self._q + share * (q - self._q)
        # The fingers have no speed told in advance: they are a step ahead instead.
        fingers = self._finger_m + (share + 1.0 / self._steps) * (opening_m / 2 - self._finger_m)
        self._drive(joints.tolist(), ((q - self._q) / CONTROL_S).tolist(), fingers.tolist(), force)
        self._q, self._finger_m = np.array(q), opening_m / 2
        return self._fault(allowed)

    def _drive(
        self,
        joints: list[list[float]],
        speed: list[float],
        fingers: list[list[float]],
        force: float,
    ) -> None:
        client, settings = self._client, self.settings
        ones, torques = [1.0] * 6, [settings.joint_force] * 6
        six, two = [settings.joint_gain] * 6, [settings.finger_gain] * 2
        for angles, (reach,) in zip(joints, fingers, strict=True):
            client.setJointMotorControlArray(
                self._arm,
                self._joints,
                client.POSITION_CONTROL,
                targetPositions=angles,
                targetVelocities=speed,
                positionGains=six,
                velocityGains=ones,
                forces=torques,
            )
            client.setJointMotorControlArray(
                self._arm,
                self._fingers,
                client.POSITION_CONTROL,
                targetPositions=[reach, reach],
                positionGains=two,
                velocityGains=[1.0, 1.0],
                forces=[force, force],
            )
            client.stepSimulation()

    def _refine(self, touching: bool) -> None:
        """Let steps be done in parts while the hand has to do with a body."""
        parts = self.settings.parts if touching else 1
        if parts != self._parts:
            self._parts = parts
            self._client.setPhysicsEngineParameter(numSubSteps=parts)

    def _anchor(self, easing: str) -> None:
        """Let friction hold places, but between the pads and a body that is being let go.

        Where neither of two touching things is anchored, friction only opposes motion: it no
        longer pulls a body back to where the pads first touched it.
        """
        if easing == self._easing:
            return
        client, eased, self._easing = self._client, bool(easing), easing
        for pad in self._pads:
            friction = self.settings.pad_friction
            client.changeDynamics(
                self._arm, pad, lateralFriction=friction, frictionAnchor=not eased
            )
        for name, number in self._numbers.items():
            client.changeDynamics(number, -1, frictionAnchor=name != easing)

    def _let_go(self, eased: bool) -> None:
        """Let the engine forget the pads' contacts once they no longer press.

        What friction once held is kept as it was then, and would be dragged along by pads that
        leave. Whatever the pads touch is found anew in the next step.
        """
        if eased == self._eased:
            return
        self._eased = eased
        self._forget(self._pads)

    def _renew(self, hand: Array) -> None:
        """Let the engine find the pads' contacts anew once the hand has turned, one by one.

        An anchored contact keeps the direction it had in the world when it began: on a hand that
        turns, the pads would soon press along what is no longer across them, and at some instant
        slip by a millimetre. While one pad finds its contacts the other holds the body.
        """
        if self._late == 1:
            self._forget(self._pads[1:])
        self._late = max(self._late - 1, 0)
        turned, turning = _apart(hand, self._found_at), _apart(hand, self._hand)
        self._hand = hand
        if turned > RENEW_RAD or (turned > RENEW_STILL_RAD and turning < STILL_RAD):
            self._found_at, self._late = hand, LATER_TICKS
            self._forget(self._pads[:1])

    def _forget(self, pads: Sequence[int]) -> None:
        for pad in pads:
            # Leaving and entering the groups that may touch drops what is kept of them.
            for group, mask in ((0, 0), (1, -1)):
                self._client.setCollisionFilterGroupMask(self._arm, pad, group, mask)

    def _fault(self, allowed: Allowed) -> Fault | None:
        client, settings = self._client, self.settings
        gap = np.max(np.abs(self.joints()[0] - self._q))
        grasped = self._numbers.get(allowed.grasped, -1)
        for point in client.getContactPoints(bodyA=self._arm):
            fine = point[OTHER] == grasped and point[LINK] in self._pads
            # The foot of the arm is bolted through the table.
            foot = point[LINK] < 1 and point[OTHER] in self._tables
            if not fine and not foot and point[FORCE] > settings.bump_n:
                return Fault("contact", self._names.get(point[OTHER], "arm"))
        if grasped >= 0 and not allowed.resting:
            for point in client.getContactPoints(bodyA=grasped):
                free = point[OTHER] in (self._arm, *self._inside)
                if not free and point[FORCE] > settings.bump_n:
                    return Fault("contact", self._names.get(point[OTHER], ""))
        return Fault("tracking") if gap > settings.tracking_rad else None

    def joints(self) -> tuple[Array, float]:
        """Return measured joint angles, shape (6,), and opening in m."""
        states = self._client.getJointStates(self._arm, [*self._joints, *self._fingers])
        values = [state[0] for state in states]
        return np.array(values[:6]), float(values[6] + values[7])

    def bodies(self) -> dict[str, Array]:
        """Return the middle of each body's base, shape (7,) each."""
        told = dict(self._fixed)
        for name, number in self._numbers.items():
            place, turn = self._client.getBasePositionAndOrientation(number)
            told[name] = compose(np.array([*place, *turn]), self._bases[name])
        return told

    def held(self) -> str:
        """Return the name of the body that both pads press on; empty for none."""
        pressed: list[dict[int, float]] = [{}, {}]
        for side, pad in enumerate(self._pads):
            for point in self._client.getContactPoints(bodyA=self._arm, linkIndexA=pad):
                pressed[side][point[OTHER]] = pressed[side].get(point[OTHER], 0.0) + point[FORCE]
        least = self.settings.touch_n
        for number, force in pressed[0].items():
            if force > least and pressed[1].get(number, 0.0) > least:
                return self._names.get(number, "")
        return ""

    def close(self) -> None:
        """End the simulation."""
        self._client.close()


def _apart(hand: Array, other: Array) -> float:
    """Return the angle between two poses of the hand: every tick, so without arrays."""
    x, y, z, w = hand[3:].tolist()
    a, b, c, d = other[3:].tolist()
    same = w * d + x * a + y * b + z * c
    turn = (
        w * a - x * d - y * c + z * b,
        w * b - y * d - z * a + x * c,
        w * c - z * d - x * b + y * a,
    )
    return 2.0 * math.atan2(math.hypot(*turn), abs(same))
