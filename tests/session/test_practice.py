"""Practice of setups end to end, and what is told of it."""

from __future__ import annotations

import json
from dataclasses import replace
from functools import cache
from pathlib import Path

import pytest

from assistant.cli import main
from assistant.errors import BadInput
from assistant.files.demonstrations import read_demonstration
from assistant.files.scenes import find_scene
from assistant.files.setups import read_setups
from assistant.files.tasks import read_task, write_task
from assistant.geometry import angle_between, distance_between
from assistant.learning.lesson import learn
from assistant.model.feedback import Feedback
from assistant.model.setup import Place
from assistant.model.task import Task
from assistant.session.practice import practice_setup, success_interval
from sim.bullet_arm import BulletArm
from sim.kinematic_arm import KinematicArm
from sim.planner import A465Planner
from sim.sensor import InHandSensor

TASKS = Path(__file__).parents[2] / "tasks"
TABLE1 = TASKS / "setups" / "table1.yaml"
STACKING = TASKS / "setups" / "stacking.yaml"


@cache
def learned(name: str) -> Task:
    task = read_task(TASKS / f"{name}.yaml")
    path = TASKS / "demonstrations" / f"{name}.yaml"
    shown = read_demonstration(path)
    return replace(task, learned=learn([shown], task, scene=find_scene(shown.setup.scene, path)))


@pytest.mark.parametrize("number", range(4))
def test_table_1_is_reached_in_contact(number: int) -> None:
    setup = read_setups(TABLE1)[number]
    scene = find_scene(setup.scene, TABLE1)
    arm = BulletArm(sensor=InHandSensor())
    task = learned("pick_and_place")
    result = practice_setup(task, scene, setup, arm=arm, planner=A465Planner())
    assert result.status == "done", result.reason
    assert result.distance_mm is not None
    assert result.angle_deg is not None
    assert result.distance_mm <= 0.1
    assert result.angle_deg <= 0.1
    assert result.joint_margin_deg is not None
    assert result.joint_margin_deg > 0


@pytest.mark.parametrize("number", range(3))
def test_blocks_are_stacked(number: int) -> None:
    setup = read_setups(STACKING)[number]
    scene = find_scene(setup.scene, STACKING)
    arm = KinematicArm()
    task = learned("stacking")
    result = practice_setup(task, scene, setup, arm=arm, planner=A465Planner())
    assert result.status == "done", result.reason
    assert len(result.reports[-1].alignments) == 2


def test_a_corrected_place_is_what_the_result_is_measured_against() -> None:
    setup = read_setups(TABLE1)[2]
    scene = find_scene(setup.scene, TABLE1)
    task = learned("pick_and_place")
    assert task.learned is not None
    left = Feedback(
        "translate", "more left", "place object on target", frame="target", offset_m=(0, 0.005, 0)
    )
    turned = replace(left, kind="rotate", offset_m=(0.0, 0.0, 0.0), turn_rad=(0.0, 0.0, 0.05))
    arm = KinematicArm()
    results = []
    for feedback in ((), (left, turned)):
        taught = replace(task, learned=replace(task.learned, feedback=feedback))
        result = practice_setup(taught, scene, setup, arm=arm, planner=A465Planner())
        results.append((result, arm.look().bodies["block"]))
    (_, before), (corrected, after) = results
    assert corrected.status == "done", corrected.reason
    assert corrected.distance_mm is not None
    assert corrected.distance_mm <= 0.1
    assert float(distance_between(before, after)) == pytest.approx(0.005, abs=1e-4)
    assert float(angle_between(before, after)) == pytest.approx(0.05, abs=1e-3)


def test_what_cannot_be_reached_is_refused_before_moving() -> None:
    setup = read_setups(TABLE1)[0]
    far = replace(setup, places={**setup.places, "target": Place("hand", (900.0, 0.0, 300.0))})
    scene = find_scene(setup.scene, TABLE1)
    arm = KinematicArm()
    task = learned("pick_and_place")
    result = practice_setup(task, scene, far, arm=arm, planner=A465Planner())
    assert result.status == "refused"
    assert "target" in result.reason
    assert arm.look().now_s == 0.0


def test_missing_places_and_unlearned_tasks_are_bad_input() -> None:
    setup = read_setups(TABLE1)[0]
    scene = find_scene(setup.scene, TABLE1)
    bare = replace(setup, places={"block": setup.places["block"]})
    with pytest.raises(BadInput, match="no place for target"):
        practice_setup(learned("pick_and_place"), scene, bare, arm=None, planner=A465Planner())
    task = replace(learned("pick_and_place"), learned=None)
    with pytest.raises(BadInput, match="nothing was learned"):
        practice_setup(task, scene, setup, arm=None, planner=A465Planner())


def test_the_verb_tells_one_json_line_and_writes_joint_paths(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    file = tmp_path / "learned.yaml"
    write_task(learned("pick_and_place"), file)
    words = ["practice", str(file), "--setup", str(TABLE1), "--arm", "kinematic", "--json"]
    assert main([*words, "--csv", str(tmp_path / "paths")]) == 0
    (line,) = capsys.readouterr().out.splitlines()
    answer = json.loads(line)
    assert (answer["done"], answer["missed"], answer["refused"]) == (4, 0, 0)
    assert [row["name"] for row in answer["setups"]] == [f"table1_{k}" for k in (1, 2, 3, 4)]
    fields = {"name", "status", "distance_mm", "angle_deg", "reason", "joint_margin_deg"}
    fields |= {"peak_joint_speed_ratio", "peak_hand_speed_m_s", "sim_s", "wall_s"}
    assert fields <= set(answer["setups"][0])
    assert len(list((tmp_path / "paths").glob("*.csv"))) == 4
    # The same command again writes the same files.
    assert main([*words, "--csv", str(tmp_path / "paths")]) == 0
    assert len(list((tmp_path / "paths").glob("*.csv"))) == 4


def test_a_dry_run_moves_nothing_and_half_speed_takes_twice(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    file = tmp_path / "learned.yaml"
    write_task(learned("pick_and_place"), file)
    times = []
    for speed in ("1", "0.5"):
        words = ["practice", str(file), "--setup", str(TABLE1), "--dry-run", "--json"]
        assert main([*words, "--speed", speed]) == 0
        rows = json.loads(capsys.readouterr().out)["setups"]
        assert all(row["distance_mm"] is None for row in rows)
        times.append(rows[1]["sim_s"])
    assert times[1] == pytest.approx(2 * times[0], rel=0.1)


def test_a_window_needs_a_display_and_an_arm_that_can_be_seen(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("sys.platform", "linux")
    monkeypatch.delenv("DISPLAY", raising=False)
    monkeypatch.delenv("WAYLAND_DISPLAY", raising=False)
    file = tmp_path / "learned.yaml"
    write_task(learned("pick_and_place"), file)
    words = ["practice", str(file), "--setup", str(TABLE1), "--window"]
    assert main(words) == 2
    assert "no display" in capsys.readouterr().err
    assert main([*words, "--arm", "kinematic"]) == 2
    assert "kinematic arm has none" in capsys.readouterr().err


def test_the_interval_of_a_rate() -> None:
    low, high = success_interval(20, 20)
    assert high == 1.0
    assert low == pytest.approx(0.839, abs=1e-3)
    assert success_interval(0, 0) == (0.0, 1.0)
    for total in range(1, 60):
        assert success_interval(0, total)[0] == 0.0
        assert success_interval(total, total)[1] == 1.0
