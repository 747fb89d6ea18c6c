"""Keys as the teacher's hand: every press jogs the arm live, checked, while it is recorded.

A terminal or a window hands key names to `KeyedHand.press` and calls `tick` once a period;
each tick moves the hand on and returns the sample to record. A tap is one
step of `STEP_M` or `STEP_RAD`, carried out to its end; a key that is seen again by then is held
and keeps moving until `HOLD_S` after it was last seen, since terminals repeat keys instead of
telling when one is let go. `release` ends all motion at once.

Keys: w/s forward and backward, a/d left and right, r/f up and down; q/e turn left and right,
t/g tilt up and down, z/x roll counterclockwise and clockwise; o/c open and close the hand;
+/- faster and slower; space is the clutch: while it is out, no key moves the arm.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass

import numpy as np

from assistant.geometry import Array, quat_from_rotvec, quat_multiply
from assistant.model.motion import HandPath, HandStop, Refusal
from assistant.model.scene import Scene
from assistant.model.setup import Setup
from assistant.ports import Arm, HandSample, Planner
from sim.a465 import GRIPPER
from sim.kinematic_arm import between_pads
from sim.world import CONTROL_S

MOVES: Mapping[str, tuple[float, float, float]] = {
    "w": (1.0, 0.0, 0.0),
    "s": (-1.0, 0.0, 0.0),
    "a": (0.0, 1.0, 0.0),
    "d": (0.0, -1.0, 0.0),
    "r": (0.0, 0.0, 1.0),
    "f": (0.0, 0.0, -1.0),
}
TURNS: Mapping[str, tuple[float, float, float]] = {
    "q": (0.0, 0.0, 1.0),
    "e": (0.0, 0.0, -1.0),
    "t": (0.0, -1.0, 0.0),
    "g": (0.0, 1.0, 0.0),
    "z": (-1.0, 0.0, 0.0),
    "x": (1.0, 0.0, 0.0),
}
OPEN, CLOSE, FASTER, SLOWER, CLUTCH = "o", "c", "+", "-", " "
HOLD_S = 0.12
"""A key moves for this long after it was last seen; terminals repeat about every 40 ms."""
STEP_SAMPLES = 6
SPEED_M_S, TURN_RAD_S = 0.10, 0.5
SLOWEST, FASTEST, STEP = 0.1, 2.0, 1.25
STEP_M, STEP_RAD = 0.005, float(np.deg2rad(2.0))
"""What a tap does at the usual speed."""
CHUNKS_S = (1.5, 0.6, 0.1, 0.04)
"""A held key moves so long at a time; the first time shorter, which is off more quickly."""
ENDS = ("finished", "halted", "unmet")


@dataclass(frozen=True, slots=True)
class KeyedState:
    """What a display shows: factor of speed, clutch, what blocks the way, what the hand does."""

    speed: float
    clutched: bool
    blocked: str
    hand: str


class KeyedHand:
    """The Hand port over keys that drive an arm.

    Parameters
    ----------
    arm : Arm
        Arranged; its bodies are really moved.
    planner : Planner
        Checks every step for reach, limits and collision.
    scene : Scene
    setup : Setup
    period_s : float
        Between samples: 0.02, or 0.5 as in the paper.
    """

    def __init__(
        self, arm: Arm, planner: Planner, scene: Scene, setup: Setup, period_s: float = CONTROL_S
    ) -> None:
        self._arm, self._planner = arm, planner
        self._scene, self._setup = scene, setup
        self._ticks = max(1, round(period_s / CONTROL_S))
        self._began_s = arm.look().now_s
        self._left: dict[str, float] = {}
        self._speed, self._clutched, self._blocked = 1.0, False, ""
        self._wanted = ""
        self._over = self._moving = self._stepping = False
        self._driven_by: frozenset[str] = frozenset()
        self._held = False
        self._said = ""

    @property
    def state(self) -> KeyedState:
        """What a display shows."""
        doing = {OPEN: "opening", CLOSE: "closing"}.get(self._wanted, self._arm.look().held)
        return KeyedState(self._speed, self._clutched, self._blocked, doing)

    def press(self, key: str) -> bool:
        """Take a key and return whether it means anything here."""
        if key == CLUTCH:
            self._clutched = not self._clutched
            self._left.clear()
        elif key in (FASTER, SLOWER):
            factor = STEP if key == FASTER else 1.0 / STEP
            self._speed = float(np.clip(self._speed * factor, SLOWEST, FASTEST))
        elif key in (OPEN, CLOSE):
            self._wanted = "" if self._clutched else key
        elif key in MOVES or key in TURNS:
            if not self._clutched:
                self._left[key] = HOLD_S
        else:
            return False
        return True

    def release(self, key: str | None = None) -> None:
        """End the motion of a key, or of all of them."""
        for known in [key] if key else list(self._left):
            self._left.pop(known, None)
        self._stepping = False

    def say(self, text: str) -> None:
        """Attach words to the next sample."""
        self._said = f"{self._said}, {text}" if self._said else text

    def finish(self) -> None:
        """End the demonstration after the next sample."""
        self._over = True
        self.release()

    def tick(self) -> HandSample:
        """Let one period pass and return the sample at its end."""
        for _ in range(self._ticks):
            self._tick()
        look = self._arm.look()
        said, self._said = self._said, ""
        return HandSample(look.now_s - self._began_s, look.hand, look.gripper_m, said)

    def _tick(self) -> None:
        keys = frozenset(self._left)
        if not self._moving and self._wanted:
            self._act()
        elif not self._moving and keys:
            self._jog(keys)
        elif self._moving and self._driven_by and not self._goes_on(keys):
            self._arm.stop("key")
        for report in self._arm.tick():
            if report.kind == "unmet":
                self._blocked = f"{report.text} {report.object}".strip()
            if report.kind in ENDS:
                self._moving, self._driven_by = False, frozenset()
        # Whoever lets go of all keys begins anew with a step.
        self._held = self._held and bool(self._left)
        self._left = {k: s - CONTROL_S for k, s in self._left.items() if s > CONTROL_S}

    def _goes_on(self, keys: frozenset[str]) -> bool:
        """Whether what moves is still wanted; a step is, unless another key is pressed."""
        return keys == self._driven_by or (self._stepping and not keys)

    def samples(self) -> Iterator[HandSample]:
        """Yield samples until `finish` is called."""
        while not self._over:
            yield self.tick()

    def _jog(self, keys: frozenset[str]) -> None:
        """Plan a short straight motion; it is braked as soon as the keys change."""
        look = self._arm.look()
        move = sum((np.array(MOVES[k]) for k in keys if k in MOVES), np.zeros(3))
        turn = sum((np.array(TURNS[k]) for k in keys if k in TURNS), np.zeros(3))
        speed = min(SPEED_M_S * self._speed, self._scene.hand_speed_m_s)
        if not self._held:
            self._step(keys, move, turn)
            return
        # A way that is blocked further on is tried again over a shorter stretch.
        for seconds in CHUNKS_S[1:] if self._stepping else CHUNKS_S:
            t_s = np.arange(0.0, seconds + CONTROL_S / 2, CONTROL_S)[:, None]
            goals = stepped(
                look.hand, _unit(move) * speed * t_s, _unit(turn) * TURN_RAD_S * self._speed * t_s
            )
            if self._begin(goals, np.full(len(goals), look.gripper_m), ()):
                self._driven_by, self._stepping = keys, False
                return
        self.release()

    def _step(self, keys: frozenset[str], move: Array, turn: Array) -> None:
        look = self._arm.look()
        share = np.linspace(0.0, 1.0, STEP_SAMPLES)[:, None] * self._speed
        goals = stepped(look.hand, _unit(move) * STEP_M * share, _unit(turn) * STEP_RAD * share)
        self._held = True
        if self._begin(goals, np.full(len(goals), look.gripper_m), ()):
            self._driven_by, self._stepping = keys, True
        else:
            self.release()

    def _act(self) -> None:
        """Open or close the hand, which rests meanwhile."""
        look = self._arm.look()
        closing, self._wanted = self._wanted == CLOSE, ""
        name = look.held or (self._reached(look.bodies, look.hand) if closing else "")
        goal = 0.0 if closing else GRIPPER.open_m
        stop = HandStop(1, "grasp" if closing else "release", name, "", 0, 2)
        self._left.clear()
        self._begin(np.tile(look.hand, (3, 1)), np.array([look.gripper_m, goal, goal]), (stop,))

    def _reached(self, bodies: Mapping[str, Array], hand: Array) -> str:
        return between_pads(self._scene, bodies, hand)

    def _begin(self, path: Array, gripper_m: Array, stops: tuple[HandStop, ...]) -> bool:
        count = len(path)
        t_s = CONTROL_S * np.arange(count, dtype=float)
        wanted = HandPath(t_s, path, gripper_m, np.full(count, -1), stops)
        found = self._planner.plan(wanted, self._scene, self._setup, self._arm.look())
        if isinstance(found, Refusal):
            self._blocked = str(found)
            return False
        self._blocked, self._moving = "", True
        self._arm.start(found)
        return True


def stepped(hand: Array, moves: Array, turns: Array) -> Array:
    """Return a flange pose moved along the base's axes and turned about them, shape (n, 7)."""
    quats = quat_multiply(quat_from_rotvec(turns), hand[3:])
    return np.concatenate([hand[:3] + moves, quats], axis=-1)


def _unit(vector: Array) -> Array:
    length = float(np.linalg.norm(vector))
    return np.array(vector / length, dtype=float) if length > 0 else np.zeros(3)
