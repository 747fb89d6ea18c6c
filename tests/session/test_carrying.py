"""A halted run goes on only with what its rest needs in the hand, and nothing else."""

from __future__ import annotations

import numpy as np
import pytest

from assistant.geometry import compose, inverse
from assistant.session import paths
from assistant.session.carrying import carried_at, unfit
from tests.session.test_paths import SCENE, line_path, look

GRASP = 100
BLOCK = SCENE.bodies["block"]


@pytest.mark.parametrize("sample", [0, GRASP - 1, GRASP, GRASP + 1, 150])
@pytest.mark.parametrize("held", ["", "block", "cup"])
def test_it_goes_on_just_where_the_hand_holds_what_the_path_carries(sample: int, held: str) -> None:
    path = line_path()
    carried = carried_at(path, sample)
    assert carried == ("block" if sample > GRASP else "")
    told = unfit(path, sample, look(path.path[sample], held), 1, 2.0)
    assert (told is None) == (held == carried)
    if told is not None:
        assert (told.kind, told.primitive_at, told.found) == ("unmet", 1, held)
        assert told.object == (carried or held)


@pytest.mark.parametrize("away_m", [0.0, 0.2])
def test_a_body_that_lies_where_it_is_grasped_is_grasped_yet(away_m: float) -> None:
    path = line_path()
    lies = compose(path.path[GRASP], inverse(BLOCK.hand_in_body))
    lies = lies + np.array([away_m, 0, 0, 0, 0, 0, 0])
    after = look(path.path[GRASP + 3], bodies={"block": lies})
    start = paths.goes_on_at(path, after, 1, SCENE)
    # Elsewhere it is not grasped, and the run does not go on without it.
    assert (start <= GRASP) == (away_m == 0.0)
    assert (unfit(path, start, after, 1, 0.0) is None) == (away_m == 0.0)
