from __future__ import annotations

from pathlib import Path

from assistant.cli.adapters import make_equipment
from assistant.files.shipped import shipped
from assistant.model.transcript import Transcript
from assistant.session.opening import Opening, open_session
from assistant.session.past import past_sessions
from assistant.shells.plain import PlainShell


def talk(
    home: Path, *lines: str, live: bool = False, task: str = "", language: str = "english"
) -> list[str]:
    told: list[str] = []
    shell = PlainShell(told.append)
    path = str(shipped("tasks") / task) if task else None
    header = Transcript("plain", arm="kinematic", task=path, language=language)
    session = open_session(Opening(make_equipment, home, shell.out, shell.attach), header)
    shell.run(session, iter(f"{line.strip()}\n" for line in lines), live=live)
    session.close()
    return told


def test_lines_in_lines_out(tmp_path: Path) -> None:
    told = talk(tmp_path, "pick and place\n", "\n", "help\n", "quit\n", "no\n", "never heard\n")
    assert all(line.startswith("robot: ") for line in told)
    assert "goal" in told[2] or "should be" in told[2]
    assert told[-1] == "robot: Goodbye."


def test_input_that_ends_with_unsaved_work_is_told_to_be_kept(tmp_path: Path) -> None:
    told = talk(tmp_path, "pick and place\n")
    assert "Shall I save it" in told[-2]
    assert "all you told me and showed me is kept" in told[-1]
    past = past_sessions(tmp_path / "sessions")
    assert [one.lines for one in past] == [2]
    assert talk(tmp_path)[-1] == "robot: Goodbye."


def test_beside_a_ticker_it_is_the_same(tmp_path: Path) -> None:
    lines = ("pick and place\n", "quit\n", "no\n")
    assert talk(tmp_path / "a", *lines) == talk(tmp_path / "b", *lines, live=True)


def test_whatever_is_typed_the_talk_goes_on(tmp_path: Path) -> None:
    odd = (
        "x" * 1_000_000,
        "word " * 20_000,
        "\x00\x01\x1b[31mred\x07",
        "\udcff\udcfe",
        "a\u202eb\tc",
    )
    for number, line in enumerate(odd):
        told = talk(tmp_path, "pick and place", line, "quit", "no")
        assert told[-1] == "robot: Goodbye."
        # What was typed is in the journal, whatever it was.
        (*_, past) = past_sessions(tmp_path / "sessions")
        assert (past.name, past.trouble) == (str(number + 1), "")


def test_what_cannot_be_shown_is_told_and_the_robot_still_watches(tmp_path: Path) -> None:
    holes = tmp_path / "holes.csv"
    columns = "t_s,x_m,y_m,z_m,qx,qy,qz,qw"
    holes.write_text(
        f"{columns}\n0,0.4,nan,0.6,0,0,0,1\n1,0.4,0,0.6,0,0,0,1\n2,0.4,0,0.6,0,0,0,1\n"
    )
    binary = tmp_path / "bytes.csv"
    binary.write_bytes(bytes(range(256)))
    shown = ("/nowhere.csv", str(tmp_path), str(holes), str(binary), "scripted hand")
    told = talk(tmp_path, "yes", *shown, "quit", "no", task="pick_and_place.yaml")
    text = "\n".join(told)
    for message in ("no such file", "is a folder", "holes.csv:2", "binary", "I saw 5 parts"):
        assert message in text


def test_in_german_the_speaker_is_named_in_german(tmp_path: Path) -> None:
    told = talk(tmp_path, "aufräumen", "beenden", "nein", language="german")
    assert all(line.startswith("Roboter: ") for line in told)


def test_hints_are_no_wider_than_the_terminal(tmp_path: Path) -> None:
    told: list[str] = []
    shell = PlainShell(told.append, 1.0, 40)
    header = Transcript(
        "plain", arm="kinematic", task=str(shipped("tasks") / "pick_and_place.yaml")
    )
    session = open_session(Opening(make_equipment, tmp_path, shell.out, shell.attach), header)
    shell.run(session, iter(("go\n",)), live=False)
    session.close()
    assert any("scripted hand" in line for line in told)
    assert max(map(len, told)) < 40
