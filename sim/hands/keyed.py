"""Keys, or a mouse, as the teacher's hand: the arm is jogged live, checked, while it is recorded.

A terminal or a window hands key names to `KeyedHand.press`, drags to `KeyedHand.lead`, and calls
`tick` once a period; each tick moves the hand on and returns the sample to record. A tap is one
step of `STEP_M` or `STEP_RAD`, carried out to its end; it ends where the hand comes abreast of a
place at which a thing is grasped or let go, so that nobody has to aim. A key that is seen again
by then is held and keeps moving until `HOLD_S` after it was last seen, since terminals repeat
keys instead of telling when one is let go. `release` ends all motion at once. The hand turns
about the point between its fingers.

Keys: w/s forward and backward, a/d left and right, r/f up and down; q/e turn left and right,
t/g tilt up and down, z/x roll counterclockwise and clockwise; o/c open and close the hand;
+/- faster and slower; space is the clutch: while it is out, nothing moves the arm.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass

import numpy as np

from assistant.geometry import Array, compose
from assistant.model.motion import ArmReport, HandPath, HandStop, Refusal
from assistant.model.scene import Scene
from assistant.model.setup import Setup
from assistant.ports import Arm, HandSample, Planner
from sim.a465 import GRIPPER
from sim.driving import TIP, Driven
from sim.hands.keymap import (
    CLOSE,
    CLUTCH,
    FASTER,
    MOVES,
    OPEN,
    SLOWER,
    TURNS,
    directions,
    stepped,
    tapped,
    unit,
)
from sim.jogging import Jog, Jogger, joint_path
from sim.kinematic_arm import between_pads
from sim.world import CONTROL_S

HOLD_S = 0.12
"""A key moves for this long after it was last seen; terminals repeat about every 40 ms."""
SPEED_M_S, TURN_RAD_S = 0.10, 0.5
SLOWEST, FASTEST, STEP = 0.1, 2.0, 1.25
STEP_M, STEP_RAD = 0.005, float(np.deg2rad(2.0))
"""What a tap does at the usual speed."""
AFAR_M = 0.05
"""A goal farther away is gone towards, not planned to its end."""
RENEWED = 5
"""A held key's motion is planned anew after so many ticks; it would end at rest otherwise."""
SPARED = 0.98
"""Share of the hand's greatest speed that is used."""
ENDS = ("finished", "halted", "unmet")
Trouble = Refusal | ArmReport | None


@dataclass(frozen=True, slots=True)
class KeyedState:
    """What a display shows: factor of speed, clutch, what blocks the way, what the hand does."""

    speed: float
    clutched: bool
    blocked: Trouble
    hand: str


class KeyedHand:
    """The Hand port over keys that drive an arm.

    Parameters
    ----------
    arm : Arm
        Arranged; its bodies are really moved.
    planner : Planner
        Checks opening and closing; `sim.jogging` checks every step of the hand.
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
        # An arm that was only just arranged may hold its start with any joints that do.
        self._fresh = self._began_s == 0.0
        self._left: dict[str, float] = {}
        self._speed, self._clutched, self._held = 1.0, False, False
        self._blocked: Trouble = None
        self._wanted = self._said = ""
        self._over = self._acting = self._braking = self._afar = False
        self._goal: Array | None = None
        self._jog: Jog | None = None
        self._asked: object = None
        self._at = self._due = 0
        self._rest: Driven | None = None

    @property
    def tip(self) -> Array:
        """The point between the fingers, about which the hand turns, seen from the flange."""
        return TIP

    @property
    def state(self) -> KeyedState:
        """What a display shows."""
        doing = {OPEN: "opening", CLOSE: "closing"}.get(self._wanted, self._arm.look().held)
        return KeyedState(self._speed, self._clutched, self._blocked, doing)

    def press(self, key: str) -> bool:
        """Take a key and return whether it means anything here."""
        if key == CLUTCH:
            self._clutched = not self._clutched
            self._let_go()
        elif key in (FASTER, SLOWER):
            factor = STEP if key == FASTER else 1.0 / STEP
            self._speed = float(np.clip(self._speed * factor, SLOWEST, FASTEST))
        elif key in (OPEN, CLOSE):
            self._wanted = "" if self._clutched else key
        elif key in MOVES or key in TURNS:
            self._push(key)
        else:
            return False
        return True

    def _push(self, key: str) -> None:
        if self._clutched:
            return
        if key in self._left:
            self._held = True
        elif not self._held:
            size = STEP_M * self._speed, STEP_RAD * self._speed
            self._aim(*tapped(key, size, self._aimed(), self._places()))
        self._left[key] = HOLD_S

    def lead(self, move_m: tuple[float, float, float]) -> None:
        """Move the hand on by so much along the base's axes, as a mouse that drags it does."""
        if not self._clutched:
            self._aim(self._speed * np.array(move_m), np.zeros(3))

    def _places(self) -> list[Array]:
        """Return where the fingers are when another thing is grasped, or let go at."""
        look, known = self._arm.look(), self._scene.bodies
        others = [name for name in look.bodies if name in known and name != look.held]
        bodies = [(look.bodies[name], known[name]) for name in others]
        return [compose(compose(pose, body.hand_in_body), TIP) for pose, body in bodies]

    def _aimed(self) -> Array:
        """Return where the point between the fingers will come to rest."""
        if self._goal is not None:
            return self._goal
        return self._resting().tip if self._jog is None else self._jog.tips[-1]

    def _aim(self, move: Array, turn: Array) -> None:
        """Add to where the hand is to come to rest."""
        self._goal = stepped(self._aimed(), move, turn)

    def release(self, key: str | None = None) -> None:
        """End the motion of a key, or all motion at once."""
        if key is not None:
            self._left.pop(key, None)
            return
        self._let_go()
        if self._jog is not None:
            self._arm.stop("key")
            self._braking = True

    def _let_go(self) -> None:
        self._left.clear()
        self._held, self._goal = False, None

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

    def samples(self) -> Iterator[HandSample]:
        """Yield samples until `finish` is called."""
        while not self._over:
            yield self.tick()

    def _tick(self) -> None:
        if not self._acting and not self._braking:
            self._decide()
        self._at += 1
        for report in self._arm.tick():
            if report.kind == "unmet":
                self._blocked = report
            if report.kind in ENDS:
                self._ended(report)
        self._left = {k: s - CONTROL_S for k, s in self._left.items() if s > CONTROL_S}
        # Whoever lets go of all keys begins anew with a step.
        self._held = self._held and bool(self._left)

    def _ended(self, report: ArmReport) -> None:
        whole = report.kind == "finished"
        self._rest = self._jog.at(len(self._jog.q)) if whole and self._jog is not None else None
        if not whole:
            self._let_go()
        elif self._goal is not None and self._goal.tobytes() == self._asked and not self._afar:
            self._goal = None
        self._acting = self._braking = False
        self._jog = self._asked = None

    def _decide(self) -> None:
        """Begin, renew or end a motion as the keys ask for."""
        if self._wanted and self._jog is None:
            self._act()
            return
        keys = frozenset(self._left) if self._held and not self._wanted else frozenset()
        asked: object = None
        if keys:
            self._goal, asked = None, keys
        elif self._goal is not None and not self._wanted:
            asked = self._goal.tobytes()
        renewed = (bool(keys) or self._afar) and self._at >= self._due
        if asked != self._asked or renewed:
            self._plan(keys, asked)

    def _resting(self) -> Driven:
        return self._rest or Driven.resting(self._arm.look().q)

    def _plan(self, keys: frozenset[str], asked: object) -> None:
        """Plan the next motion from where the arm is in course; what is not free is not begun."""
        look = self._arm.look()
        jogger = Jogger(self._scene, self._setup, look)
        now = self._resting() if self._jog is None else self._jog.at(self._at)
        most = min(SPEED_M_S * self._speed, SPARED * self._scene.hand_speed_m_s)
        turning = TURN_RAD_S * self._speed
        way = np.zeros(3) if self._goal is None else self._goal[:3] - now.tip[:3]
        self._afar = not keys and float(np.linalg.norm(way)) > AFAR_M
        if keys or self._afar:
            # Wherever the goal is, the hand goes as far as the way is free.
            move, turn = directions(keys) if keys else (unit(way), np.zeros(3))
            speed = np.concatenate([most * move, turning * turn])
            found = jogger.towards(now, speed, seats=self._fresh)
        elif self._goal is not None:
            found = jogger.to(now, self._goal, (most, turning), seats=self._fresh)
        else:
            found = jogger.halting(now)
        if isinstance(found, Refusal) and self._jog is None:
            self._blocked = found
            self._let_go()
            return
        if isinstance(found, Refusal) and asked != self._asked:
            # What is in course and no longer wanted is braked.
            found = jogger.halting(now)
        self._asked, self._due = asked, self._at + RENEWED
        if isinstance(found, Jog):
            self._begin(found, look.gripper_m)

    def _begin(self, jog: Jog, gripper_m: float) -> None:
        self._arm.start(joint_path(jog, gripper_m))
        self._jog, self._at, self._due = jog, 0, RENEWED
        self._blocked, self._fresh = None, False

    def _act(self) -> None:
        """Open or close the hand, which rests meanwhile."""
        look = self._arm.look()
        closing, self._wanted = self._wanted == CLOSE, ""
        name = look.held or (self._reached(look.bodies, look.hand) if closing else "")
        goal = 0.0 if closing else GRIPPER.open_m
        stop = HandStop(1, "grasp" if closing else "release", name, "", 0, 2)
        self._let_go()
        t_s, path = CONTROL_S * np.arange(3.0), np.tile(look.hand, (3, 1))
        opening = np.array([look.gripper_m, goal, goal])
        wanted = HandPath(t_s, path, opening, np.full(3, -1), (stop,))
        found = self._planner.plan(wanted, self._scene, self._setup, look)
        if isinstance(found, Refusal):
            self._blocked = found
            return
        self._blocked, self._acting, self._fresh = None, True, False
        self._arm.start(found)

    def _reached(self, bodies: Mapping[str, Array], hand: Array) -> str:
        return between_pads(self._scene, bodies, hand)
