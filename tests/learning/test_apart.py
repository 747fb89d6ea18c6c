from __future__ import annotations

import pytest

from assistant.learning.apart import SAME_CUT_S, set_apart
from assistant.model.lesson import Episode

EPISODES = (
    Episode(0.0, 4.0, "go", 0.9),
    Episode(4.0, 6.0, None, 0.5),
    Episode(6.0, 9.0, "lift", 1),
)


def test_a_whole_episode_needs_no_further_cut() -> None:
    near = 0.5 * SAME_CUT_S
    assert set_apart(EPISODES, "shake", 4.0 + near, 6.0 - near) == (
        (4.0, 6.0),
        ("go", "shake", "lift"),
    )


@pytest.mark.parametrize(
    ("from_s", "to_s", "cuts_s", "taken"),
    [
        (0.0, 2.5, (2.5, 4.0, 6.0), ("shake", "go", "", "lift")),
        (1.0, 2.5, (1.0, 2.5, 4.0, 6.0), ("go", "shake", "go", "", "lift")),
        (7.5, 9.0, (4.0, 6.0, 7.5), ("go", "", "lift", "shake")),
        (3.0, 7.0, (3.0, 4.0, 6.0, 7.0), ("go", "shake", "shake", "shake", "lift")),
    ],
)
def test_a_stretch_within_episodes_is_cut_out_and_the_rest_stays_what_it_was(
    from_s: float, to_s: float, cuts_s: tuple[float, ...], taken: tuple[str, ...]
) -> None:
    assert set_apart(EPISODES, "shake", from_s, to_s) == (cuts_s, taken)
