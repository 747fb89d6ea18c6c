"""The sensor in the hand: sees where a grasped body sits between the fingers, with noise.

A real hand would carry a small camera or touch pads in the fingers. While the hand rests
after closing, several looks are taken and averaged. The release is then corrected by what was
seen, so that errors in the told places do not reach the target.
"""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np

from assistant.geometry import Array, compose, quat_from_rotvec
from assistant.model.scene import Scene


@dataclass(slots=True)
class InHandSensor:
    """Looks at the body in the hand.

    Parameters
    ----------
    noise_m, noise_deg : float
        Standard deviation of a single look, for each axis.
    looks : int
        How many are averaged, one a control tick.
    seed : int
    """

    noise_m: float = 2e-5
    noise_deg: float = 0.02
    looks: int = 8
    seed: int = 0
    _random: np.random.Generator = field(init=False, repr=False)

    def __post_init__(self) -> None:
        self._random = np.random.default_rng(self.seed)

    def look(self, body_in_hand: Array) -> Array:
        """Return the pose of the body's base in the flange's frame as seen, shape (7,)."""
        shift = self._random.normal(0.0, self.noise_m, (self.looks, 3)).mean(axis=0)
        spread = np.deg2rad(self.noise_deg)
        turn = self._random.normal(0.0, spread, (self.looks, 3)).mean(axis=0)
        return compose(body_in_hand, np.concatenate([shift, quat_from_rotvec(turn)]))


@dataclass(frozen=True, slots=True)
class PlaceNoise:
    """Errors of the told places: what can be carried really stands a little elsewhere.

    Parameters
    ----------
    distance_m, angle_deg : float
        Greatest error in the plane and of yaw, drawn evenly.
    seed : int
    """

    distance_m: float = 0.001
    angle_deg: float = 1.0
    seed: int = 0

    def misplaced(self, told: dict[str, Array], scene: Scene) -> dict[str, Array]:
        """Return where bodies really stand, shape (7,) each; what cannot be carried is exact."""
        random = np.random.default_rng(self.seed)
        loose = [name for name in told if name in scene.bodies and scene.bodies[name].mass_kg > 0]
        return {**told, **{name: self._moved(told[name], random) for name in loose}}

    def _moved(self, pose: Array, random: np.random.Generator) -> Array:
        heading = random.uniform(0.0, 2.0 * np.pi)
        reach = self.distance_m * np.sqrt(random.uniform())
        shift = reach * np.array([np.cos(heading), np.sin(heading), 0.0])
        yaw = np.deg2rad(random.uniform(-self.angle_deg, self.angle_deg))
        turn = quat_from_rotvec(np.array([0.0, 0.0, yaw]))
        return compose(pose, np.concatenate([shift, turn]))
