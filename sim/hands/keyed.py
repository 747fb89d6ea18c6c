"""Keys, or a mouse, as the teacher's hand: the arm is jogged live, checked, while it is recorded.

A terminal or a window hands key names to `KeyedHand.press`, drags to `KeyedHand.lead`, and calls
`tick` once a period; each tick moves the hand on and returns the sample to record. A tap is one
step (see `sim.hands.steps`); it ends where the hand comes abreast of a place at which a thing is
grasped or let go, so that nobody has to aim. Where the reach ends the hand gives way sideways
(see `sim.sliding`). `release` ends all motion at once. The hand turns about the point between
its fingers.

Keys: w/s forward and backward, a/d left and right, r/f up and down; q/e turn left and right,
t/g tilt up and down, z/x roll counterclockwise and clockwise; o/c open and close the hand;
+/- larger and finer steps; h points the hand straight down, comfortably; u goes back the way of
the last move, and so does the clock; space is the clutch: while it is out, nothing moves the arm.
"""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from assistant.geometry import Array
from assistant.model.motion import ArmReport
from assistant.model.scene import Scene
from assistant.model.setup import Setup
from assistant.ports import Arm, HandSample, Planner
from sim.driving import TIP
from sim.hands import fingers
from sim.hands.going import Going, KeyedState
from sim.hands.keymap import (
    BACK,
    CLOSE,
    CLUTCH,
    FINER,
    LARGER,
    MOVES,
    OPEN,
    POSTURE,
    TURNS,
    stepped,
)
from sim.world import CONTROL_S

ENDS = ("finished", "halted", "unmet")


class KeyedHand(Going):
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
        super().__init__(arm, planner, scene, setup)
        self._ticks = max(1, round(period_s / CONTROL_S))
        self._now = 0
        self._said = ""
        self._clutched = self._over = False

    @property
    def tip(self) -> Array:
        """The point between the fingers, about which the hand turns, seen from the flange."""
        return TIP

    @property
    def state(self) -> KeyedState:
        """What a display shows."""
        look = self._arm.look()
        doing = {OPEN: "opening", CLOSE: "closing"}.get(self._wanted, look.held)
        low = fingers.lowest(self._scene, look)
        step_m, step_rad = self._steps.size(near=self._near(look))
        return KeyedState(
            1000.0 * step_m,
            float(np.rad2deg(step_rad)),
            self._clutched,
            self._blocked,
            self._touching,
            1000.0 * self._gave_way_m,
            doing,
            self._returning is not None,
            None if low is None else (low[0], 1000.0 * low[1]),
        )

    def press(self, key: str) -> bool:
        """Take a key and return whether it means anything here."""
        if key == CLUTCH:
            self._clutched = not self._clutched
            self._let_go()
        elif key in (LARGER, FINER):
            self._steps.change(1 if key == LARGER else -1)
        elif key in (OPEN, CLOSE, POSTURE, BACK):
            self._wanted = "" if self._clutched else key
        elif key in MOVES or key in TURNS:
            if not self._clutched:
                self._steps.take(key, self._now)
        else:
            return False
        return True

    def lead(self, move_m: tuple[float, float, float]) -> None:
        """Move the hand on by so much along the base's axes, as a mouse that drags it does."""
        if not self._clutched:
            begin = self._aimed() if self._led is None else self._led
            self._led = stepped(begin, np.array(move_m), np.zeros(3))

    def release(self) -> None:
        """End all motion at once."""
        self._let_go()
        if self._jog is not None:
            self._arm.stop("key")
            self._braking = True

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
        self._now += 1
        for report in self._arm.tick():
            if report.kind == "unmet":
                self._blocked = report
            if report.kind in ENDS:
                self._ended(report)
        if self._returning is None:
            look = self._arm.look()
            self._trail.see(look.q, look.now_s - self._began_s)

    def _ended(self, report: ArmReport) -> None:
        whole = report.kind == "finished"
        self._rest = self._jog.at(len(self._jog.q)) if whole and self._jog is not None else None
        if not whole:
            self._let_go()
        self._acting = self._braking = False
        self._jog = self._goal = None
        if not self._afar:
            self._led = None
        if self._returning is not None:
            # What is taken back has not been shown: its time has not passed.
            self._began_s = self._arm.look().now_s - self._returning.begin_s
            self._returning = None
