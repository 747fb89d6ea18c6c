from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from assistant.files.recordings import read_recording
from assistant.model.listening import Understanding
from assistant.model.setup import Setup
from assistant.model.teacher_acts import Cue, KeyState, Unknown
from assistant.ports import HandSample
from assistant.session.watching import Watching, read_back


def sample(t_s: float, opening: float | None = 0.08) -> HandSample:
    pose = np.array([0.4 + 0.01 * t_s, 0.1, 0.6, 0.0, 0.0, 0.0, 1.0])
    return HandSample(t_s, pose, opening)


def watched(path: Path | None, count: int = 5) -> Watching:
    watching = Watching(path)
    for number in range(count):
        watching.see(sample(0.02 * number))
    return watching


def test_samples_are_on_disk_as_they_come(tmp_path: Path) -> None:
    path = tmp_path / "recording.csv"
    watching = watched(path)
    kept = read_recording(path)
    shown = watching.demonstration(Setup(), "live").recording
    np.testing.assert_array_equal(kept.t_s, shown.t_s)
    np.testing.assert_array_equal(kept.path, shown.path)
    assert kept.gripper_m is not None
    assert shown.gripper_m is not None
    np.testing.assert_array_equal(kept.gripper_m, shown.gripper_m)


@pytest.mark.parametrize("cut", range(1, 90, 11))
def test_a_torn_last_sample_is_left_out(tmp_path: Path, cut: int) -> None:
    path = tmp_path / "recording.csv"
    watched(path)
    whole = path.read_bytes()
    path.write_bytes(whole[:-cut])
    kept = read_back(path)
    assert len(kept) == whole[:-cut].count(b"\n") - 1
    for number, one in enumerate(kept):
        assert one.t_s == pytest.approx(0.02 * number)


def test_nothing_recorded_reads_back_as_nothing(tmp_path: Path) -> None:
    assert read_back(tmp_path / "missing.csv") == []
    (tmp_path / "empty.csv").write_text("")
    assert read_back(tmp_path / "empty.csv") == []


def test_going_on_continues_the_clock(tmp_path: Path) -> None:
    path = tmp_path / "recording.csv"
    watched(path)
    again = Watching(path, read_back(path))
    again.go_on()
    again.see(sample(0.0))
    times = [one.t_s for one in again.samples]
    assert times == sorted(set(times))
    assert len(read_recording(path).t_s) == 6


def test_a_hand_without_gripper_is_recorded_so(tmp_path: Path) -> None:
    path = tmp_path / "recording.csv"
    watching = Watching(path)
    watching.see(sample(0.0, None))
    watching.see(sample(0.02, None))
    watching.see(sample(0.04, None))
    assert read_recording(path).gripper_m is None
    assert watching.demonstration(Setup(), "").recording.gripper_m is None
    assert read_back(path)[1].gripper_m is None


def test_a_folder_that_cannot_be_written_loses_no_sample(tmp_path: Path) -> None:
    watching = watched(tmp_path / "missing" / "recording.csv")
    assert len(watching.samples) == 5
    assert "recording.csv" in watching.trouble


def test_markers_and_key_states_are_kept_with_their_times() -> None:
    watching = watched(None)
    watching.hear("then", Understanding((Cue("next"),), 1.0, "then"))
    watching.hear("look", Understanding((KeyState("it is held"),), 1.0, "look"), at_s=0.01)
    watching.hear("nice weather", Understanding((Unknown(),), 0.1, "nice weather"))
    shown = watching.demonstration(Setup(), "live")
    assert [(cue.at_s, cue.say) for cue in shown.cues] == [(0.08, "then")]
    assert [(one.at_s, one.say) for one in shown.key_states] == [(0.01, "look")]


@pytest.mark.parametrize("resumed", [False, True])
def test_what_is_taken_back_is_gone_from_memory_and_from_disk(
    tmp_path: Path, resumed: bool
) -> None:
    path = tmp_path / "recording.csv"
    watching = watched(path, 5 if resumed else 0)
    watching.go_on()
    before = len(watching.samples)
    for number in range(6):
        watching.see(sample(0.02 * number))
        if number in (1, 4):
            watching.hear("then", Understanding((Cue("next"),), 1.0, "then"))
    watching.take_back(0.06)
    assert len(watching.samples) == before + 3
    assert watching.shown_s == pytest.approx(0.04)
    assert [one.t_s for one in read_back(path)] == [one.t_s for one in watching.samples]
    assert len(watching.cues) == 1
    watching.see(sample(0.06))
    assert read_back(path)[-1].t_s == watching.now_s
