"""Recordings: every way a log can be wrong is told with its line, and odd ones are used."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from assistant.errors import BadInput
from assistant.files.columns import COLUMNS
from assistant.files.demonstrations import read_demonstration, write_demonstration
from assistant.files.kinds import read_known
from assistant.files.oddities import odd_demonstration, odd_recording
from assistant.files.recordings import read_recording, recording_of, recording_text, write_recording
from assistant.model.demonstration import Recording
from tests.files import examples
from tests.files.same import same

HEADER = "t_s,x_m,y_m,z_m,qx,qy,qz,qw,gripper_m"
ROWS = [
    f"{0.02 * i:.2f},0.4,{0.001 * i:.3f},0.6,0,0,0,1,{0.08 if i < 5 else 0.04}" for i in range(10)
]
GOOD = "\n".join([HEADER, *ROWS, ""])


def refused(text: str) -> BadInput:
    with pytest.raises(BadInput) as caught:
        recording_of(text, "r.csv")
    return caught.value


@settings(max_examples=25, deadline=None)
@given(st.integers(3, 50), st.integers(0, 999), st.booleans())
def test_recordings_come_back_exactly(
    tmp_path_factory: pytest.TempPathFactory, n: int, seed: int, gripper: bool
) -> None:
    recording = examples.recording(n, seed, gripper=gripper)
    path = tmp_path_factory.mktemp("r") / "r.csv"
    write_recording(recording, path)
    again = read_recording(path)
    assert same(again, recording)
    assert recording_text(again) == path.read_text()


def test_comments_blank_lines_and_the_order_of_columns_do_not_matter() -> None:
    text = "# from the arm\n\nqw,qx,qy,qz,t_s,x_m,y_m,z_m # here\n\n1,0,0,0,0,.1,.2,.3\n# more\n"
    text += "1,0,0,0,1,.1,.2,.3 # last\n1,0,0,0,2,.1,.2,.3"
    recording = recording_of(text, "r.csv")
    assert recording.gripper_m is None
    assert recording.path[0].tolist() == [0.1, 0.2, 0.3, 0, 0, 0, 1]
    bad = refused(text.replace("1,0,0,0,2,", "1,0,0,0,nan,"))
    assert bad.problems[0].where == "r.csv:8"


@pytest.mark.parametrize(
    ("old", "new", "where", "told"),
    [
        ("0.06,0.4", "0.06,nan", "r.csv:5", "NaN or infinite"),
        ("0.06,0.4", "0.06,inf", "r.csv:5", "NaN or infinite"),
        ("0.06,", "0.03,", "r.csv:5", "time runs backward"),
        ("0.06,0.4,0.003,0.6,0,0,0,1", "0.06,0.4,0.003,0.6,0,0,0,.7", "r.csv:5", "length is not 1"),
        ("0.06,0.4,0.003,0.6,0,0,0,1", "0.06,0.4,0.003,0.6,0,0,0,0", "r.csv:5", "length is not 1"),
        ("0.06,0.4", "0.06,x", "r.csv:5", "'x' is not a number"),
        ("0.06,0.4", "0.06,1_0", "r.csv:5", "'1_0' is not a number"),
        ("0.06,0.4", "0.06,", "r.csv:5", "'' is not a number"),
        ("0.06,0.4,", "0.06,", "r.csv:5", "8 values; 9 numbers"),
        ("0.06,0.4", "0.06,400", "r.csv:5", "is this mm?"),
        ("1,0.04", "1,40", "r.csv:7", "gripper_m is in metres"),
        ("x_m", "x_mm", "r.csv:1", "'x_mm' is not known; x_m in metres: divide by 1000"),
        ("x_m", "x", "r.csv:1", "call it x_m (in metres)"),
        ("t_s", "time_ms", "r.csv:1", "t_s in seconds: divide by 1000"),
        ("t_s", "timestamp", "r.csv:1", "call it t_s (in seconds)"),
        ("qx", "q_x", "r.csv:1", "call it qx"),
        ("qx", "QX", "r.csv:1", "call it qx"),
        ("gripper_m", "force_n", "r.csv:1", "'force_n' is not known; leave it out"),
        ("y_m", "x_m", "r.csv:1", "'x_m' stands there twice"),
        ("y_m,", "", "r.csv:1", "missing: y_m"),
        (f"{HEADER}\n", "", "r.csv:1", "there is no header"),
    ],
)
def test_what_cannot_be_meant_is_told(old: str, new: str, where: str, told: str) -> None:
    assert old in GOOD
    error = refused(GOOD.replace(old, new, 1))
    assert error.problems[0].where == where
    assert told in str(error)


@pytest.mark.parametrize(
    ("text", "told"),
    [
        ("", "the file is empty"),
        ("# only this\n", "the file is empty"),
        (HEADER, "no samples below"),
        (HEADER + "\n# none\n", "no samples below"),
        ("\n".join([HEADER, *ROWS[:2]]), "only 2 samples; a recording has at least 3"),
        ("\n".join([HEADER, ROWS[0]]), "only 1 sample;"),
        ("\n".join([HEADER, *[ROWS[0]] * 5]), "r.csv:6: no time passes; t_s in seconds"),
        (GOOD.replace(",0.6,0,0,0,1,", ",0.6,0,0,0,1e300,"), "length is not 1"),
        (GOOD.replace(",", ";"), "separated by semicolons"),
        (GOOD.replace(",", "\t"), "separated by tabs"),
        ("Dear diary,\ntoday\n", "this is no recording"),
        ("abc," * 100_000, "this is no recording"),
        ("Dear diary\n", "this is no recording"),
    ],
)
def test_what_is_no_recording(text: str, told: str) -> None:
    assert told in str(refused(text))


def test_many_bad_lines_are_counted_not_listed() -> None:
    rows = "\n".join(f"{i},x,0,0,0,0,0,1" for i in range(500))
    error = refused(f"{HEADER.rpartition(',')[0]}\n{rows}\n")
    assert len(error.problems) == 21
    assert "and 480 more" in str(error.problems[-1])


def test_nearly_unit_quaternions_are_made_unit_and_flips_turned_back() -> None:
    text = GOOD.replace("0,0,0,1,", "0,0,0.1,0.98,").replace(
        "0.06,0.4,0.003,0.6,0,0,0.1,0.98", "0.06,0.4,0.003,0.6,0,0,-0.1,-0.98"
    )
    quats = recording_of(text, "r.csv").path[:, 3:]
    assert np.allclose(np.linalg.norm(quats, axis=1), 1.0, atol=1e-15)
    assert np.ptp(quats, axis=0).max() < 1e-15


def test_repeated_times_jumps_gaps_and_a_still_hand_are_told_and_used() -> None:
    rows = [row.split(",") for row in ROWS]
    rows[4][0] = rows[3][0]
    for row in rows[6:]:
        row[1] = "0.7"
        row[0] = str(float(row[0]) + 5.0)
    recording = recording_of("\n".join([HEADER, *map(",".join, rows)]), "r.csv")
    told = "\n".join(map(str, odd_recording(recording, "r.csv")))
    assert "1 time stands there twice" in told
    assert "between 0.100 and 5.120 s there are no samples" in told
    assert "jumps" not in told  # within five seconds a hand may get there
    rows = [row.split(",") for row in ROWS]
    rows[5][1] = "0.7"
    for row in rows:
        row[8] = "0.05"
    recording = recording_of("\n".join([HEADER, *map(",".join, rows)]), "r.csv")
    told = "\n".join(map(str, odd_recording(recording, "r.csv")))
    assert "at 0.100 s the hand jumps 300 mm and 0 degrees within 0.020 s" in told
    assert "never opens or closes" in told
    bare = Recording(recording.t_s, recording.path)
    assert "no column gripper_m" in str(odd_recording(bare, "")[-1])


def test_a_good_recording_is_not_odd() -> None:
    assert odd_recording(recording_of(GOOD, "r.csv"), "r.csv") == ()


@pytest.mark.parametrize("data", [b"\x00\x01\x02" * 100, b"\xff\xfe\xfd" * 100])
def test_binary_files_are_told(tmp_path: Path, data: bytes) -> None:
    (tmp_path / "r.csv").write_bytes(data)
    with pytest.raises(BadInput, match=r"binary file|not UTF-8"):
        read_recording(tmp_path / "r.csv")


def test_demonstrations_come_back(tmp_path: Path) -> None:
    shown = examples.demonstration()
    write_demonstration(shown, tmp_path / "d.yaml")
    again = read_demonstration(tmp_path / "d.yaml")
    assert again.source == str(tmp_path / "d.yaml")
    assert same(again.recording, shown.recording)
    assert (again.cues, again.key_states) == (shown.cues, shown.key_states)
    assert same(again.setup, shown.setup)
    assert again.approach_axis == shown.approach_axis


def test_demonstrations_tell_what_is_missing_and_what_was_said_too_late(tmp_path: Path) -> None:
    path = tmp_path / "d.yaml"
    path.write_text("format: demonstration/1\nrecording: r.csv\ncues: [{at_s: 99, say: then}]\n")
    with pytest.raises(BadInput, match=r"d.yaml:2: there is no recording"):
        read_demonstration(path)
    (tmp_path / "r.csv").write_text(GOOD)
    told = odd_demonstration(read_demonstration(path), "d.yaml")
    assert "'then' at 99 s is outside the recording" in str(told[0])
    known = read_known(path)
    assert (known.kind, known.recording, len(known.warnings)) == ("demonstration", "r.csv", 1)


def test_times_in_milliseconds_are_refused_and_a_slow_camera_is_not() -> None:
    rows = [f"{{}},0.{k},0.2,0.6,0,0,0,1,0.05" for k in range(1, 9)]

    def told(step: float) -> str:
        lines = [row.format(step * k) for k, row in enumerate(rows)]
        return "\n".join([",".join(COLUMNS), *lines])

    with pytest.raises(BadInput, match=r"r\.csv:2.*20 s apart.*is this ms\?"):
        recording_of(told(20.0), "r.csv")
    assert len(recording_of(told(2.0), "r.csv").t_s) == 8
