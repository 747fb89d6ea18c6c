"""What is done at a place keeps its shape with it; the way there leads from anywhere."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from assistant.geometry import Array, compose, inverse
from assistant.learning.adaptation import adapt, plan_adaptation
from assistant.learning.arriving import arrival, site_of
from assistant.learning.docking import docking_sample, way_end
from assistant.learning.lesson import learn
from assistant.model.scene import Body, Scene
from assistant.model.settings import GeneralizationSettings
from assistant.model.setup import Place, Setup
from assistant.model.task import Action, Primitive, Subtask, Task, TaskObject
from sim.hands import ScriptedHand
from tests.sim.hand_paths import TABLE

GIVEN = GeneralizationSettings()
SPONGE = Body("sponge", size_mm=(60.0, 40.0, 90.0))
TRAY = Body("tray", size_mm=(200.0, 160.0, 10.0), mass_kg=0.0, grasp_xyz_mm=(-134.1, 0.0, 70.0))
SCENE = Scene("table", {"sponge": SPONGE, "tray": TRAY}, (TABLE,))
SETUP = Setup(
    places={
        "sponge": Place("body", (560.0, 250.0, 240.0), (0.0, 0.0, 20.0)),
        "tray": Place("body", (620.0, -60.0, 240.0)),
    }
)
WIPING = Task(
    "wiping",
    Subtask(
        "wiping",
        (
            Primitive("go", Action("move", "to", "sponge")),
            Primitive("grab", Action("hand", "close", "sponge")),
            Primitive("wipe", Action("free", "wipe the tray", "tray")),
            Primitive("let go", Action("hand", "open", "tray")),
        ),
    ),
    objects=(TaskObject("sponge", "object"), TaskObject("tray", "target")),
)


def wiped(seed: int) -> Task:
    """Learned with carrying, wiping and putting down in steps that follow without a way."""
    hand = ScriptedHand(WIPING, SCENE, SETUP, seed=seed)
    return replace(WIPING, learned=learn([hand.demonstration()], WIPING, scene=SCENE))


@pytest.mark.parametrize("seed", [1, 2])
def test_a_step_that_carries_and_wipes_is_torn_nowhere_and_wipes_as_shown(seed: int) -> None:
    task = wiped(seed)
    lesson = task.learned
    assert lesson is not None
    assert lesson.path is not None
    shown = float(np.max(steps(lesson.path.path)))
    grasp, wipe, release = lesson.stations
    assert grasp.left_at < wipe.docking_at < wipe.at < wipe.left_at < release.docking_at
    elsewhere = Place("body", (420.0, 320.0, 240.0), (0.0, 0.0, 40.0))
    moved = {**SETUP.places, "sponge": elsewhere}
    path = adapt(plan_adaptation(task), SCENE, replace(SETUP, places=moved)).path
    assert np.max(steps(path)) < 2.0 * shown
    # Elsewhere the sponge is fetched, but the tray is where it was: so is all that is done there.
    kept = slice(wipe.docking_at, wipe.left_at)
    np.testing.assert_allclose(path[kept, :3], lesson.path.path[kept, :3], atol=1e-9)


def test_the_way_to_the_place_is_none_of_what_is_done_there() -> None:
    lesson = wiped(1).learned
    assert lesson is not None
    assert lesson.path is not None
    wipe = lesson.stations[1]
    site = site_of("sponge", "tray", wipe.frame_to_world, SCENE)
    assert site is not None
    path = lesson.path.path
    assert site.reached(path[wipe.docking_at : wipe.at], 0.05).all()
    down = site.reached(path, 0.0) & (path[:, 2] < path[wipe.at, 2] + 0.005)
    assert 0 <= int(np.flatnonzero(down)[0]) - wipe.docking_at < 60


def steps(path: Array) -> Array:
    return np.asarray(np.linalg.norm(np.diff(path[:, :3], axis=0), axis=1))


def carried_and_stroked() -> Array:
    """0.4 m away in 100 samples, at rest there, then strokes of 0.1 m to and fro."""
    s = np.linspace(0.0, 1.0, 101)
    way = 0.4 * s**3 * (10.0 - 15.0 * s + 6.0 * s**2)
    strokes = 0.4 + 0.05 * (1.0 - np.cos(np.linspace(0.0, 6.0 * np.pi, 301)))
    path = np.zeros((401, 7))
    path[:, 6] = 1.0
    path[:, 0] = np.concatenate([way[:-1], strokes])
    return path


def test_where_it_first_rests_away_from_where_it_began_it_has_arrived() -> None:
    path = carried_and_stroked()
    assert arrival(path, 0, 0, 400, None, GIVEN) == pytest.approx(100, abs=2)


def test_a_step_with_a_way_before_it_is_kept_whole() -> None:
    path = carried_and_stroked()
    assert arrival(path, 0, 70, 400, None, GIVEN) == 70


def test_a_site_is_reached_by_what_is_held_not_by_the_hand() -> None:
    frame = compose(Place("body", (600.0, 0.0, 240.0)).pose, TRAY.hand_in_body)
    site = site_of("sponge", "tray", frame, SCENE)
    assert site is not None
    middle = compose(Place("body", (600.0, 0.0, 240.0)).pose, SPONGE.hand_in_body)
    beside = compose(Place("body", (600.0, 0.0, 240.0)).pose, inverse(SPONGE.hand_in_body))
    assert site.reached(np.stack([middle, beside]), 0.0).tolist() == [True, False]
    assert site_of("sponge", "unknown", frame, SCENE) is None


@pytest.mark.parametrize("suggested", [0, 30, 100])
def test_before_docking_there_is_always_a_way(suggested: int) -> None:
    xyz = np.zeros((101, 3))
    xyz[:, 0] = np.linspace(0.0, 0.11, 101)
    docking = docking_sample(xyz, 100, suggested, 0, GIVEN)
    assert way_end(xyz, 0, 100) <= docking < 100
