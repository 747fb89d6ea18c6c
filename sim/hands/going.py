"""Carries out what a driven hand is asked for: steps, drags, a posture, opening, going back."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from assistant.geometry import Array, compose
from assistant.model.motion import ArmReport, Refusal
from assistant.model.scene import Scene
from assistant.model.setup import Setup
from assistant.ports import Arm, ArmLook, Planner
from sim.driving import TIP, Driven
from sim.hands import fingers
from sim.hands.keymap import BACK, CLOSE, CLUTCH, OPEN, POSTURE, stepped, tapped, unit
from sim.hands.steps import Steps
from sim.hands.trail import Move, Trail
from sim.jogging import Jog, Jogger, joint_path
from sim.kinematics import branch_of
from sim.posing import posed
from sim.sliding import slid
from sim.tracking import PATH

SPEED_M_S, TURN_RAD_S = 0.2, 1.05
"""Fast enough for a key that a terminal repeats 30 times a second."""
LED_M_S = 0.10
AHEAD_M, AHEAD_RAD = 0.03, 0.2
"""What the hand was asked for is never further ahead of it: so far it takes to come to rest."""
AFAR_M = 0.05
"""A goal farther away is gone towards, not planned to its end."""
RENEWED = 5
"""Such a motion is planned anew after so many ticks; it would end at rest otherwise."""
SPARED = 0.98
"""Share of the hand's greatest speed that is used."""
GAVE_WAY_M = 0.0002
Trouble = Refusal | ArmReport | None


@dataclass(frozen=True, slots=True)
class KeyedState:
    """What a display shows.

    Parameters
    ----------
    step_mm, step_deg : float
        What a tap does now.
    clutched : bool
    blocked : Refusal, ArmReport or None
        What is in the way.
    touching : str
        Which part of the hand or the arm it is in the way of.
    gave_way_mm : float
        How far the hand went aside in the last step, for its reach ends there.
    hand : str
        What it does, or the name of what it holds.
    returning : bool
        Whether it goes back: that is not shown.
    lowest : tuple of str and float, or None
        What of hand and arm is nearest above a table, and how far in mm.
    """

    step_mm: float
    step_deg: float
    clutched: bool
    blocked: Trouble
    touching: str
    gave_way_mm: float
    hand: str
    returning: bool
    lowest: tuple[str, float] | None


class Going:
    """An arm that is driven, motion by motion; each is checked before it begins.

    Parameters
    ----------
    arm : Arm
    planner : Planner
    scene : Scene
    setup : Setup
    """

    def __init__(self, arm: Arm, planner: Planner, scene: Scene, setup: Setup) -> None:
        self._arm, self._planner = arm, planner
        self._scene, self._setup = scene, setup
        self._began_s = arm.look().now_s
        # An arm that was only just arranged may hold its start with any joints that do.
        self._fresh = self._began_s == 0.0
        self._steps, self._trail = Steps(), Trail()
        self._blocked: Trouble = None
        self._wanted = self._touching = ""
        self._acting = self._afar = self._braking = False
        self._gave_way_m = 0.0
        self._goal: Array | None = None
        self._led: Array | None = None
        self._jog: Jog | None = None
        self._at = self._due = 0
        self._rest: Driven | None = None
        self._returning: Move | None = None

    def _places(self, look: ArmLook) -> list[Array]:
        """Return where the fingers are when another thing is grasped, or let go at."""
        known = self._scene.bodies
        others = [name for name in look.bodies if name in known and name != look.held]
        bodies = [(look.bodies[name], known[name]) for name in others]
        return [compose(compose(pose, body.hand_in_body), TIP) for pose, body in bodies]

    def _near(self, look: ArmLook) -> bool:
        tip = compose(look.hand, TIP)
        return fingers.near(tip, self._places(look), self._scene)

    def _aimed(self) -> Array:
        """Return where the point between the fingers will come to rest."""
        if self._goal is not None:
            return self._goal
        return self._resting().tip if self._jog is None else self._jog.tips[-1]

    def _let_go(self) -> None:
        self._steps.clear()
        self._goal = self._led = None

    def _decide(self) -> None:
        """Begin, renew or end a motion as the keys ask for."""
        if self._wanted:
            if self._jog is None:
                self._do(self._wanted)
        elif self._steps.waiting:
            if self._close():
                self._step()
        elif self._led is not None and (self._jog is None or self._at >= self._due):
            self._follow(self._led)

    def _resting(self) -> Driven:
        return self._rest or Driven.resting(self._arm.look().q)

    def _moving(self) -> Driven:
        return self._resting() if self._jog is None else self._jog.at(self._at)

    def _close(self) -> bool:
        """Whether the hand is where it was asked to be, all but what it takes to rest there."""
        return self._goal is None or fingers.apart(
            self._moving().tip, self._goal, AHEAD_M, AHEAD_RAD
        )

    def _step(self) -> None:
        """Go on by the next tap; what is not free is not begun."""
        look, now, key = self._arm.look(), self._moving(), self._steps.waiting.popleft()
        jogger = Jogger(self._scene, self._setup, look)
        begin = self._aimed()
        size = self._steps.size(near=self._near(look))
        goal = stepped(begin, *tapped(key, size, begin, self._places(look)))
        most = (min(SPEED_M_S, SPARED * self._scene.hand_speed_m_s), TURN_RAD_S)
        why: Refusal | None = None
        for way in slid(begin, goal, int(branch_of(now.q))):
            found = jogger.to(now, way, most, seats=self._fresh)
            if isinstance(found, Jog):
                aside = float(np.linalg.norm(way[:3] - goal[:3]))
                self._gave_way_m = aside if aside > GAVE_WAY_M else 0.0
                self._begin(found, look, key)
                self._goal = way
                return
            if why is None or why.reason != "collision":
                why = found
        self._refuse(why or Refusal("reach", PATH), jogger)

    def _follow(self, goal: Array) -> None:
        """Go where the mouse is; however far that is, the hand goes as far as the way is free."""
        look, now = self._arm.look(), self._moving()
        jogger = Jogger(self._scene, self._setup, look)
        way = goal[:3] - now.tip[:3]
        most = min(LED_M_S, SPARED * self._scene.hand_speed_m_s)
        self._afar = float(np.linalg.norm(way)) > AFAR_M
        if self._afar:
            speed = np.concatenate([most * unit(way), np.zeros(3)])
            found = jogger.towards(now, speed, seats=self._fresh)
        else:
            found = jogger.to(now, goal, (most, TURN_RAD_S), seats=self._fresh)
        self._due = self._at + RENEWED
        if isinstance(found, Jog):
            self._gave_way_m = 0.0
            self._begin(found, look, CLUTCH)
        elif self._jog is None:
            self._refuse(found, jogger)

    def _refuse(self, why: Refusal, jogger: Jogger) -> None:
        self._blocked, self._touching = why, jogger.touching
        self._steps.clear()
        self._led = None

    def _begin(self, jog: Jog, look: ArmLook, what: str, *, single: bool = False) -> None:
        self._trail.begin(what, look.q, look.now_s - self._began_s, single=single)
        self._arm.start(joint_path(jog, look.gripper_m))
        self._jog, self._at, self._due = jog, 0, RENEWED
        self._blocked, self._fresh, self._touching = None, False, ""

    def _do(self, key: str) -> None:
        """Open or close the hand, which rests meanwhile, take the posture, or go back."""
        self._wanted = ""
        self._let_go()
        look = self._arm.look()
        if key == POSTURE:
            jogger = Jogger(self._scene, self._setup, look)
            found = posed(jogger, self._scene, look, LED_M_S)
            if isinstance(found, Refusal):
                self._refuse(found, jogger)
                return
            self._begin(found, look, key, single=True)
            self._acting = True
        elif key == BACK:
            self._go_back(look)
        elif self._act(key, look):
            self._trail.begin(key, look.q, look.now_s - self._began_s, single=True)

    def _go_back(self, look: ArmLook) -> None:
        """Undo the last move: along its way, or by the other of opening and closing."""
        move = self._trail.pop()
        if move is None:
            return
        self._returning = move
        other = {OPEN: CLOSE, CLOSE: OPEN}.get(move.what)
        if other is not None:
            if not self._act(other, look):
                self._returning = None
            return
        jogger = Jogger(self._scene, self._setup, look)
        found = jogger.along(np.array([look.q, *reversed(move.joints)]))
        if isinstance(found, Refusal):
            self._returning = None
            self._refuse(found, jogger)
            return
        self._arm.start(joint_path(found, look.gripper_m))
        self._jog, self._at, self._acting, self._blocked = found, 0, True, None

    def _act(self, key: str, look: ArmLook) -> bool:
        """Begin to open or to close the hand; return whether that can be."""
        wanted = fingers.acting(key == CLOSE, self._scene, look)
        # Letting go is never refused: nothing else gets a thing out of the hand.
        found = (
            self._planner.plan(wanted, self._scene, self._setup, look)
            if key == CLOSE
            else fingers.resting(wanted, look)
        )
        if isinstance(found, Refusal):
            self._blocked = found
            return False
        self._blocked, self._acting, self._fresh, self._gave_way_m = None, True, False, 0.0
        self._arm.start(found)
        return True
