"""Readings that are nearly a sentence: stretches are replaced by what sounds like them."""

from __future__ import annotations

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from assistant.shells.voice.phonemes import distance, phonemes
from assistant.shells.voice.repairing import MOST_WORDS, repaired, written

pytestmark = pytest.mark.voice

WORDS = st.sampled_from(("would", "you", "move", "it", "soup", "a", "bit", "less", "stamp", "road"))


@pytest.mark.parametrize(
    ("heard", "said"),
    [
        ("would you mind sailing a bit less", "would you mind saying a bit less"),
        ("during the approach goes lower", "during the approach go slower"),
        ("close the grippers", "close the gripper"),
        ("close the ripper", "close the gripper"),
        ("we do", "redo"),
    ],
)
def test_what_was_said_is_among_what_may_have_been(heard: str, said: str) -> None:
    assert said in repaired(heard)


def test_names_of_the_task_are_tried() -> None:
    assert "merge dribble and lift" not in repaired("merge scribble and lift")
    assert "merge dribble and lift" in repaired("merge scribble and lift", ("dribble",))


@settings(max_examples=20, deadline=None)
@given(st.lists(WORDS, max_size=MOST_WORDS + 2))
def test_most_of_a_reading_stays(words: list[str]) -> None:
    heard = " ".join(words)
    found = repaired(heard)
    assert len(set(found)) == len(found)
    assert all(distance(phonemes(one), phonemes(heard)) < 0.5 for one in found)
    assert heard not in found


@pytest.mark.parametrize(
    ("heard", "said"),
    [
        ("to centimeters up", "two centimeters up"),
        (
            "bring it up about to and a half centimeters",
            "bring it up about two and a half centimeters",
        ),
        ("turn left for degrees", "turn left four degrees"),
        ("go back to the demonstration", "go back to the demonstration"),
        ("wait for me", "wait for me"),
    ],
)
def test_little_words_before_a_measure_are_numbers(heard: str, said: str) -> None:
    assert written(heard) == said
    assert written(heard, language="german") == heard


@pytest.mark.parametrize(
    ("heard", "said"),
    [
        ("approach grasp lift", "approach, grasp, lift"),
        ("pick up place", "pick up, place"),
        ("grasp the block lift the block", "grasp the block, lift the block"),
        ("grasp and lift", "grasp and lift"),
        ("grasp the lid", "grasp the lid"),
        ("move back lift", "move back, lift"),
        ("place the lift", "place the lift"),
    ],
)
def test_actions_said_one_after_another_are_a_list(heard: str, said: str) -> None:
    assert written(heard, "actions") == said
    assert written(heard) == heard


@pytest.mark.parametrize(
    ("heard", "name"),
    [
        ("the approach object", "approach object"),
        ("a grasp the object", "grasp the object"),
        ("the approach", "the approach"),
        ("the red block", "the red block"),
    ],
)
def test_a_step_has_no_article_before_its_action(heard: str, name: str) -> None:
    assert written(heard, "subtask_name") == name
    assert written(heard, "objects") == heard
