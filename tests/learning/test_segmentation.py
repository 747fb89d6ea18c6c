from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from assistant.errors import BadInput, NothingLearned
from assistant.files.demonstrations import read_demonstration
from assistant.files.tasks import read_task
from assistant.learning.segmentation import segment
from assistant.model.demonstration import Recording, Spoken
from assistant.model.lesson import Segmentation
from assistant.model.settings import paper
from assistant.model.setup import Setup
from assistant.model.task import Action, Primitive, Subtask, primitives
from tests.benchmarks.segmentation_lessons import steps_named, told_coarsely
from tests.benchmarks.segmentation_scores import f1, matched
from tests.generators import generator_a, generator_b
from tests.generators.shown import Habit, Shown
from tests.learning import lessons

SEEDS = range(70_000, 70_004)


def near(shown: Shown, within_s: float = 0.5) -> tuple[int, int]:
    """Return how many true cuts were found, and how many there are."""
    found = np.array(segment(shown.demonstration, shown.task).cuts_s)
    return sum(bool(np.any(np.abs(found - cut) <= within_s)) for cut in shown.cuts_s), len(
        shown.cuts_s
    )


@pytest.mark.parametrize("habit", ["fluent", "slow"])
@pytest.mark.parametrize("generate", [generator_a.generate, generator_b.generate])
def test_most_cuts_are_found(generate: object, habit: Habit) -> None:
    assert callable(generate)
    tallies = [near(generate(seed, habit)) for seed in SEEDS]
    hits, total = np.sum(np.array(tallies), axis=0)
    assert hits / total >= 0.85


@pytest.mark.parametrize("seed", SEEDS)
def test_told_cuts_are_taken_and_assigned_in_order(seed: int) -> None:
    shown = generator_a.generate(seed)
    found = segment(shown.demonstration, shown.task, cuts_s=shown.cuts_s)
    assert found.cuts_s == pytest.approx(shown.cuts_s)
    assert [episode.primitive for episode in found.episodes] == list(shown.names)


def test_a_gripper_cut_is_at_its_instant() -> None:
    shown = generator_a.generate(70_000)
    recording = shown.demonstration.recording
    assert recording.gripper_m is not None
    half = recording.gripper_m < 0.06
    closed_s = float(recording.t_s[int(np.argmax(half))])
    found = np.array(segment(shown.demonstration, shown.task).cuts_s)
    assert np.min(np.abs(found - closed_s)) <= 0.04


def shipped() -> Segmentation:
    folder = Path(__file__).parents[2] / "tasks"
    shown = read_demonstration(folder / "demonstrations" / "pick_and_place.yaml")
    return segment(shown, read_task(folder / "pick_and_place.yaml"))


def test_a_point_within_a_primitive_is_the_grippers_instant_in_its_rest() -> None:
    inner = [point for point in shipped().points if point.internal]
    assert [point.at_s for point in inner] == [pytest.approx(15.96, abs=0.02)]
    assert inner[0].confidence > 0.5


def test_eliminated_points_are_told() -> None:
    found = shipped()
    away = [point for point in found.points if not point.kept]
    assert away
    assert all(point.confidence < 0.5 for point in away)
    others = np.array([point.at_s for point in found.points if point.kept])
    assert all(np.min(np.abs(others - point.at_s)) >= 0.3 for point in away)


def test_points_tell_who_voted_and_how_sure() -> None:
    shown = generator_a.generate(70_001)
    found = segment(shown.demonstration, shown.task)
    for point in found.points:
        assert 0.0 <= point.confidence <= 1.0
        assert set(point.votes) == {"gripper", "speed", "cue", "jolt"}
        assert all(0.0 <= told <= 1.0 for told in point.votes.values())
        assert not (point.internal and not point.kept)
    assert [p.at_s for p in found.points] == sorted(p.at_s for p in found.points)
    assert len(found.vote) == len(found.vote_t_s)
    assert np.max(found.vote) <= sum((0.52, 0.19, 0.29, 0.29))


def test_episodes_cover_the_demonstration() -> None:
    shown = generator_b.generate(70_002)
    found = segment(shown.demonstration, shown.task)
    t_s = shown.demonstration.recording.t_s
    assert found.episodes[0].from_s == t_s[0]
    assert found.episodes[-1].to_s == t_s[-1]
    for before, after in zip(found.episodes[:-1], found.episodes[1:], strict=True):
        assert before.to_s == after.from_s
    assert len(found.cuts_s) == len(found.episodes) - 1


def test_moving_and_scaling_time_changes_nothing() -> None:
    """The same demonstration elsewhere and on another clock is cut at the same places."""
    shown = generator_a.generate(70_003)
    demonstration = replace(shown.demonstration, setup=Setup())
    recording = demonstration.recording
    path = recording.path.copy()
    path[:, :3] += [0.1, -0.2, 0.05]
    later = Recording(recording.t_s + 100.0, path, recording.gripper_m)
    cues = tuple(Spoken(cue.at_s + 100.0, cue.say) for cue in demonstration.cues)
    moved = replace(demonstration, recording=later, cues=cues)
    first, second = segment(demonstration, shown.task), segment(moved, shown.task)
    assert np.array(second.cuts_s) - 100.0 == pytest.approx(np.array(first.cuts_s), abs=0.02)


def test_a_step_never_shown_is_asked_for() -> None:
    shown = generator_a.generate(70_000)
    leaves = list(primitives(shown.task.tree))
    extra = Primitive("turn it over", Action("turn", "clockwise"))
    task = replace(shown.task, tree=Subtask("t", (*leaves[:3], extra, *leaves[3:])))
    found = segment(shown.demonstration, task)
    asked = [q for q in found.questions if q.reason == "never_shown"]
    assert [question.about for question in asked] == ["turn it over"]
    assert asked[0].asked == "missing_step"
    assert asked[0].facts["introduced"] == len(leaves) + 1


def test_steps_told_coarsely_are_not_taken_apart() -> None:
    """Who introduces "take it" and "put it there" means the ways as well."""
    known = [
        generate(70_300 + k)
        for generate in (generator_a.generate, generator_b.generate)
        for k in range(3)
    ]
    coarse = [one for k, s in enumerate(known) if (one := told_coarsely(s, k)) is not None]
    found = [segment(one.demonstration, one.task).cuts_s for one in coarse]
    counts = [matched(cuts, one.cuts_s, 0.5) for cuts, one in zip(found, coarse, strict=True)]
    assert f1(counts) > 0.85


@pytest.mark.parametrize("seed", [300_003, 300_013])
def test_letting_go_untold_at_the_end_is_asked_about_where_it_was(seed: int) -> None:
    """The rest after it was taken for the way to the target, and all of the way for the step."""
    shown = generator_a.generate(seed, "fluent")
    told = tuple(leaf for leaf in primitives(shown.task.tree) if leaf.name != shown.names[-1])
    task = replace(shown.task, tree=replace(shown.task.tree, parts=told))
    found = segment(shown.demonstration, task)
    asked = [one.facts for one in found.questions if one.reason == "never_introduced"]
    assert shown.names[-1].startswith("place")
    assert [float(str(one["from_s"])) for one in asked] == pytest.approx(
        [shown.cuts_s[-1]], abs=0.3
    )


def test_a_step_never_introduced_is_named() -> None:
    shown = generator_a.generate(70_001)
    leaves = [x for x in primitives(shown.task.tree) if x.action.verb != "hand"]
    task = replace(shown.task, tree=Subtask("t", tuple(leaves[:1])))
    found = segment(shown.demonstration, task)
    assert any(question.reason == "never_introduced" for question in found.questions)
    assert any(episode.primitive is None for episode in found.episodes)


def test_steps_left_out_of_the_introduction_or_the_showing_are_mostly_named() -> None:
    """Most of eight lessons are asked about, each about the right step; right ones are not."""
    shows = [generator_a.generate(seed) for seed in range(70_020, 70_028)]
    for told in steps_named(shows).split(","):
        named, known = told.split()[-1].split("/")
        assert int(named) / int(known) >= 0.75
    asked = [segment(one.demonstration, one.task).questions for one in shows]
    assert not [one for found in asked for one in found if one.reason == "never_introduced"]


def test_cuts_outside_the_demonstration_are_refused() -> None:
    shown = generator_a.generate(70_002)
    with pytest.raises(BadInput, match="not within"):
        segment(shown.demonstration, shown.task, cuts_s=[-1.0])


def test_without_the_gripper_a_question_says_so() -> None:
    shown = generator_a.generate(70_003)
    recording = shown.demonstration.recording
    bare = replace(shown.demonstration, recording=Recording(recording.t_s, recording.path))
    found = segment(bare, shown.task)
    assert any(question.reason == "no_gripper" for question in found.questions)
    assert len(found.cuts_s) >= len(shown.names) - 2


def test_a_demonstration_that_ends_holding_is_asked_about() -> None:
    shown = generator_a.generate(70_000)
    recording = shown.demonstration.recording
    assert recording.gripper_m is not None
    stop = int(np.argmax(recording.gripper_m < 0.05)) + 100
    short = Recording(recording.t_s[:stop], recording.path[:stop], recording.gripper_m[:stop])
    found = segment(replace(shown.demonstration, recording=short), shown.task)
    assert any(question.reason == "ends_holding" for question in found.questions)


def test_a_hand_that_never_closes_teaches_nothing() -> None:
    shown = generator_a.generate(70_000)
    recording = shown.demonstration.recording
    opened = Recording(recording.t_s, recording.path, np.full(len(recording.t_s), 0.08))
    with pytest.raises(NothingLearned, match="never closes"):
        segment(replace(shown.demonstration, recording=opened), shown.task)


def test_two_samples_and_no_motion_teach_nothing() -> None:
    shown = generator_a.generate(70_000)
    recording = shown.demonstration.recording
    two = Recording(recording.t_s[:2], recording.path[:2])
    with pytest.raises(NothingLearned, match="2 samples"):
        segment(replace(shown.demonstration, recording=two), shown.task)
    still = Recording(recording.t_s, np.tile(recording.path[0], (len(recording.t_s), 1)))
    with pytest.raises(NothingLearned, match="never moves"):
        segment(replace(shown.demonstration, recording=still), shown.task)
    with pytest.raises(NothingLearned, match="no steps"):
        segment(shown.demonstration, replace(shown.task, tree=Subtask("empty")))


def test_very_many_samples_are_cut_alike() -> None:
    shown = generator_a.generate(70_002)
    recording = shown.demonstration.recording
    assert recording.gripper_m is not None
    t_s = np.linspace(recording.t_s[0], recording.t_s[-1], 60_000)
    columns = [np.interp(t_s, recording.t_s, column) for column in recording.path.T]
    path = np.stack(columns, axis=1)
    path[:, 3:] /= np.linalg.norm(path[:, 3:], axis=1, keepdims=True)
    dense = Recording(t_s, path, np.interp(t_s, recording.t_s, recording.gripper_m))
    found = segment(replace(shown.demonstration, recording=dense), shown.task)
    usual = segment(shown.demonstration, shown.task)
    assert found.cuts_s == pytest.approx(usual.cuts_s, abs=0.15)


def test_the_papers_method_stays_available() -> None:
    shown = generator_a.generate(70_001)
    found = segment(shown.demonstration, shown.task, paper())
    assert found.cue_lag_s is None
    assert len(found.cuts_s) >= 1
    assert {episode.primitive for episode in found.episodes} <= set(shown.names)
    assert set(found.signal_votes) == {"gripper", "speed", "cue"}


def test_a_made_demonstration_is_cut_into_what_it_shows() -> None:
    """Drawing back after placing is a step of its own where it was named or a cue tells of it."""
    shown, task = lessons.demonstration(), lessons.task()
    found = segment(shown, task)
    assert np.allclose(found.cuts_s, lessons.CUTS_S, atol=0.1)
    assert "never_introduced" not in {one.reason for one in found.questions}
    assert any(point.internal and abs(point.at_s - 14.0) < 0.1 for point in found.points)
    cues = tuple(Spoken(cut + 0.6, "next") for cut in (*lessons.CUTS_S, 14.0))
    found = segment(replace(shown, cues=cues), task)
    assert np.allclose(found.cuts_s, [*lessons.CUTS_S, 14.0], atol=0.1)
    assert found.episodes[-1].primitive is None
    assert "never_introduced" in [one.reason for one in found.questions]
    leaves = (*primitives(task.tree), Primitive("leave", Action("move", "depart", "target")))
    named = segment(shown, replace(task, tree=Subtask("all", leaves)))
    assert np.allclose(named.cuts_s, [*lessons.CUTS_S, 14.0], atol=0.1)
    assert named.questions == ()
    upto = shown.recording.t_s < 14.4
    gripper = shown.recording.gripper_m
    assert gripper is not None
    short = Recording(shown.recording.t_s[upto], shown.recording.path[upto], gripper[upto])
    found = segment(replace(shown, recording=short), task)
    assert np.allclose(found.cuts_s, lessons.CUTS_S, atol=0.1)
    assert found.questions == ()
