"""Bodies of the physics are as large as told, and stand still where they are put."""

from __future__ import annotations

import numpy as np
import pytest

from assistant.model.scene import Body
from assistant.model.setup import Place
from sim.bullet_bodies import add_body, add_obstacle
from sim.bullet_client import Client
from sim.bullet_settings import BulletSettings
from tests.sim.hand_paths import TABLE

BOWL = Body("bowl", "cylinder", (60.0, 60.0, 70.0))
TRAY = Body("tray", size_mm=(300.0, 200.0, 10.0), mass_kg=0.0)
TOP_M = 0.24


@pytest.fixture
def client() -> Client:
    client = Client()
    settings = BulletSettings()
    client.setGravity(0.0, 0.0, -9.81)
    client.setPhysicsEngineParameter(
        fixedTimeStep=1.0 / settings.physics_hz,
        numSolverIterations=settings.iterations,
        solverResidualThreshold=0,
    )
    add_obstacle(client, TABLE)
    return client


def test_a_cylinder_is_as_wide_and_as_high_as_told(client: Client) -> None:
    add_body(client, BOWL, Place("body", (600.0, 0.0, 240.0)).pose)
    middle = np.array([0.6, 0.0, TOP_M + 0.035])
    for angle in np.linspace(0.0, np.pi, 7):
        far = np.array([0.2 * np.cos(angle), 0.2 * np.sin(angle), 0.0])
        hit = client.rayTest((middle + far).tolist(), (middle - far).tolist())[0]
        assert 0.0299 < np.linalg.norm(np.array(hit[3]) - middle) < 0.0307
    down = client.rayTest([0.6, 0.0, 0.5], [0.6, 0.0, 0.1])[0]
    assert down[3][2] == pytest.approx(TOP_M + 0.070, abs=1e-5)


@pytest.mark.parametrize("yaw_deg", [-160.0, -30.0, 17.0, 101.0])
def test_a_round_body_does_not_rock_where_it_stands(client: Client, yaw_deg: float) -> None:
    add_body(client, TRAY, Place("body", (700.0, 0.0, 240.0), (0.0, 0.0, yaw_deg)).pose)
    base = Place("body", (706.0, -13.0, 250.1), (0.0, 0.0, 40.0 - 2.0 * yaw_deg)).pose
    number = add_body(client, BOWL, base)
    client.changeDynamics(number, -1, frictionAnchor=True)
    for _ in range(250):
        client.stepSimulation()
    begun = np.array(client.getBasePositionAndOrientation(number)[0])
    off = []
    for k in range(600):
        if k % 100 == 0:
            # As when the hand leaves, the engine finds the contacts anew.
            client.setPhysicsEngineParameter(numSubSteps=1 + (k // 100) % 2)
        if k % 300 == 150:
            client.changeDynamics(number, -1, frictionAnchor=(k // 300) % 2 == 1)
        if k % 500 == 250:
            above = [*begun[:2].tolist(), float(begun[2]) + 0.02]
            client.applyExternalForce(number, -1, [0.3, 0.0, 0.0], above, client.WORLD_FRAME)
        client.stepSimulation()
        off.append(np.array(client.getBasePositionAndOrientation(number)[0]) - begun)
    assert np.max(np.abs(off)) < 2e-6
