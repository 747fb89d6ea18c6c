"""A scripted hand finds places for what nobody placed, and leaves what was."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from assistant.model.setup import Setup
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
