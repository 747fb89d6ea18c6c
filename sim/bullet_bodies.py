"""Bodies, tables and obstacles of a scene as PyBullet's shapes."""

from __future__ import annotations

import numpy as np

from assistant.geometry import IDENTITY, Array, compose, pose_from_mm_deg
from assistant.model.scene import Body, Obstacle
from sim.bullet_client import Client

COLORS = {
    "red": (0.8, 0.15, 0.12, 1.0),
    "green": (0.2, 0.6, 0.25, 1.0),
    "blue": (0.15, 0.35, 0.75, 1.0),
    "yellow": (0.9, 0.75, 0.2, 1.0),
    "gray": (0.6, 0.6, 0.6, 1.0),
}
TABLE_FRICTION = 0.5
CUP_WALLS = 12
"""With the floor at most 16: PyBullet leaves out what goes beyond, without a word."""
CUP_THICKNESS_M = 0.004
FLAT_M = 1e-4
"""A body lower than this is a mark on the table: seen, but not felt."""
ROUND_BOXES = 8
"""Of which a cylinder is made, each turned further: twice as many flat sides."""


def middle_in_base(height_mm: float) -> Array:
    """Return the middle of a body seen from the middle of its base, shape (7,)."""
    pose = np.array(IDENTITY)
    pose[2] = height_mm / 2000.0
    return pose


def holed(body: Body) -> tuple[list[list[float]], list[list[float]]]:
    """Return half sizes and middles, in m from the body's middle, of the boxes around a hole."""
    x, y, z = (edge / 1000.0 for edge in body.size_mm)
    wide, long, deep = (edge / 1000.0 for edge in body.hole_mm)
    side, front, up = (x - wide) / 4, (y - long) / 4, (z - deep) / 2
    halves = [[x / 2, y / 2, up]]
    middles = [[0.0, 0.0, up - z / 2]]
    for sign in (-1.0, 1.0):
        halves += [[side, y / 2, deep / 2], [wide / 2, front, deep / 2]]
        middles += [[sign * (wide / 2 + side), 0.0, up], [0.0, sign * (long / 2 + front), up]]
    return halves, middles


def add_body(client: Client, body: Body, base: Array) -> int:
    """Put a body at a pose of its base, shape (7,), and return its number."""
    pose = compose(base, middle_in_base(body.size_mm[2]))
    shape = -1 if body.size_mm[2] / 1000.0 < FLAT_M else _collision(client, body)
    number: int = client.createMultiBody(
        baseMass=body.mass_kg,
        baseCollisionShapeIndex=shape,
        baseVisualShapeIndex=_visual(client, body),
        basePosition=pose[:3].tolist(),
        baseOrientation=pose[3:].tolist(),
    )
    client.changeDynamics(
        number,
        -1,
        lateralFriction=body.friction,
        linearDamping=0.0,
        angularDamping=0.0,
        rollingFriction=1e-4 if body.shape == "sphere" else 0.0,
    )
    return number


def add_obstacle(client: Client, box: Obstacle) -> int:
    """Put a table or an obstacle where the scene says and return its number."""
    base = pose_from_mm_deg(box.xyz_mm, box.rpy_deg)
    pose = compose(base, middle_in_base(box.size_mm[2]))
    half = [edge / 2000.0 for edge in box.size_mm]
    number: int = client.createMultiBody(
        baseMass=0.0,
        baseCollisionShapeIndex=client.createCollisionShape(client.GEOM_BOX, halfExtents=half),
        baseVisualShapeIndex=client.createVisualShape(
            client.GEOM_BOX, halfExtents=half, rgbaColor=COLORS.get(box.color, COLORS["gray"])
        ),
        basePosition=pose[:3].tolist(),
        baseOrientation=pose[3:].tolist(),
    )
    client.changeDynamics(number, -1, lateralFriction=TABLE_FRICTION, frictionAnchor=True)
    return number


def _collision(client: Client, body: Body) -> int:
    x, y, z = (edge / 1000.0 for edge in body.size_mm)
    if any(body.hole_mm):
        halves, middles = holed(body)
        return int(
            client.createCollisionShapeArray(
                shapeTypes=[client.GEOM_BOX] * len(halves),
                halfExtents=halves,
                collisionFramePositions=middles,
            )
        )
    match body.shape:
        case "box":
            half = [x / 2, y / 2, z / 2]
            return int(client.createCollisionShape(client.GEOM_BOX, halfExtents=half))
        case "cylinder":
            return _cylinder(client, x / 2, z)
        case "sphere":
            return int(client.createCollisionShape(client.GEOM_SPHERE, radius=x / 2))
        case "cup":
            return _cup(client, x / 2, z)


def _cylinder(client: Client, radius: float, height: float) -> int:
    """Return a cylinder: boxes as wide as it is, one turned against the next.

    On what is really round the engine finds ever other points of contact, some all in one line:
    it rocks where it stands, and tips in the hand by degrees. Flat sides and corners are found
    again where they were.
    """
    side = radius * np.tan(np.pi / 2 / ROUND_BOXES)
    halves = np.arange(ROUND_BOXES) * np.pi / 2 / ROUND_BOXES
    turns = np.column_stack([0.0 * halves, 0.0 * halves, np.sin(halves), np.cos(halves)])
    return int(
        client.createCollisionShapeArray(
            shapeTypes=[client.GEOM_BOX] * ROUND_BOXES,
            halfExtents=[[radius, side, height / 2]] * ROUND_BOXES,
            collisionFramePositions=[[0.0, 0.0, 0.0]] * ROUND_BOXES,
            collisionFrameOrientations=turns.tolist(),
        )
    )


def _cup(client: Client, radius: float, height: float) -> int:
    """Return a cup: a floor and a ring of walls."""
    thick = CUP_THICKNESS_M
    wall = radius * np.tan(np.pi / CUP_WALLS)
    halves = [[radius - thick, radius - thick, thick / 2]]
    places = [[0.0, 0.0, -height / 2 + thick / 2]]
    turns = [[0.0, 0.0, 0.0, 1.0]]
    for angle in np.arange(CUP_WALLS) * 2.0 * np.pi / CUP_WALLS:
        halves.append([thick / 2, wall, height / 2])
        reach = radius - thick / 2
        places.append([reach * np.cos(angle), reach * np.sin(angle), 0.0])
        turns.append([0.0, 0.0, float(np.sin(angle / 2)), float(np.cos(angle / 2))])
    return int(
        client.createCollisionShapeArray(
            shapeTypes=[client.GEOM_BOX] * len(halves),
            halfExtents=halves,
            collisionFramePositions=places,
            collisionFrameOrientations=turns,
        )
    )


def _visual(client: Client, body: Body) -> int:
    x, y, z = (max(edge / 1000.0, FLAT_M) for edge in body.size_mm)
    color = COLORS.get(body.color, COLORS["yellow"])
    if any(body.hole_mm):
        halves, middles = holed(body)
        return int(
            client.createVisualShapeArray(
                shapeTypes=[client.GEOM_BOX] * len(halves),
                halfExtents=halves,
                visualFramePositions=middles,
                rgbaColors=[color] * len(halves),
            )
        )
    if body.shape == "box":
        half = [x / 2, y / 2, z / 2]
        return int(client.createVisualShape(client.GEOM_BOX, halfExtents=half, rgbaColor=color))
    if body.shape == "sphere":
        return int(client.createVisualShape(client.GEOM_SPHERE, radius=x / 2, rgbaColor=color))
    return int(
        client.createVisualShape(client.GEOM_CYLINDER, radius=x / 2, length=z, rgbaColor=color)
    )
