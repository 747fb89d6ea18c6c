"""A scripted hand finds places for what nobody placed, and leaves what was."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np

from assistant.files.scenes import read_scene
from assistant.files.setups import read_setups
from assistant.model.scene import Body
from assistant.model.setup import Setup
from assistant.model.task import TaskObject
from sim.hands.untold import APART_MM, filled
from tests.sim.hand_paths import TABLE1, scene, taught


def test_what_was_told_stays_and_what_was_not_stands_apart_on_a_table() -> None:
    told = TABLE1[0]
    assert filled(taught(), scene(), told, 0) == told
    bare = replace(told, places={})
    found = filled(taught(), scene(), bare, 3)
    assert set(found.places) == {one.name for one in taught().objects}
    spots = [np.array(place.xyz_mm[:2]) for place in found.places.values()]
    assert float(np.linalg.norm(spots[0] - spots[1])) > APART_MM
    assert filled(taught(), scene(), bare, 3) == found
    assert isinstance(found, Setup)


def test_what_nobody_placed_stands_on_the_table_beside_what_is_there() -> None:
    there = read_scene(Path("tasks/scenes/demonstration_table.yaml"))
    where = read_setups(Path("tasks/setups/demonstration.yaml"))[0]
    new = {"peg": Body("peg"), "hole": Body("hole", mass_kg=0.0)}
    more = replace(there, bodies={**there.bodies, **new})
    things = (TaskObject("peg", "object"), TaskObject("hole", "target"))
    for seed in range(5):
        found = filled(replace(taught(), objects=things), more, where, seed)
        tops = {found.places[name].xyz_mm[2] for name in new}
        assert tops == {336.7}
