"""Numbers of the physics, each with its reason."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True, slots=True)
class BulletSettings:
    """Settings of the simulated contact.

    Parameters
    ----------
    physics_hz : int
        A whole multiple of the control rate.
    iterations : int
        Of the contact solver; it is never left early, so that runs repeat exactly.
    parts : int
        In so many parts a step is done while the hand holds or touches something. A body that
        is swung goes straight on within a step while the pads go round. What they then pull it
        back by strains them against each other once their contacts are found anew one by one,
        until it slips; half a step takes it a quarter as far.
    joint_gain, joint_force : float, float
        Share of a joint's position error removed in a step, and the torque to do it with.
    pad_friction : float
    grip_n : float
        Force of each finger.
    finger_gain : float
    gear_force, gear_erp : float, float
        Of the coupling of the two fingers.
    friction_erp : float
        Share of the slip of a contact that is undone in a step. With the library's own 0.2
        a block creeps in the hand by 0.1 mm while it is carried and turned.
    tracking_rad : float
        A joint further than this from its command is a fault.
    touch_n, bump_n : float, float
        A finger holds from this force on; a body is bumped into from this force on.
    """

    physics_hz: int = 250
    iterations: int = 50
    parts: int = 2
    joint_gain: float = 0.3
    joint_force: float = 2000.0
    pad_friction: float = 0.9
    grip_n: float = 30.0
    finger_gain: float = 0.3
    gear_force: float = 1000.0
    gear_erp: float = 0.8
    friction_erp: float = 0.8
    tracking_rad: float = 0.01
    touch_n: float = 1.0
    bump_n: float = 1.0
