from __future__ import annotations

from pathlib import Path

from assistant.cli.adapters import make_equipment
from assistant.model.transcript import Transcript
from assistant.session.opening import Opening, open_session
from assistant.shells.plain import PlainShell


def talk(home: Path, *lines: str, live: bool = False) -> list[str]:
    told: list[str] = []
    shell = PlainShell(told.append)
    session = open_session(Opening(make_equipment, home, shell.out), Transcript("plain"))
    shell.run(session, iter(lines), live=live)
    session.close()
    return told


def test_lines_in_lines_out(tmp_path: Path) -> None:
    told = talk(tmp_path, "pick and place\n", "\n", "help\n", "quit\n", "no\n", "never heard\n")
    assert all(line.startswith("robot: ") for line in told)
    assert "goal" in told[2] or "should be" in told[2]
    assert told[-1] == "robot: Goodbye."


def test_beside_a_ticker_it_is_the_same(tmp_path: Path) -> None:
    lines = ("pick and place\n", "quit\n", "no\n")
    assert talk(tmp_path / "a", *lines) == talk(tmp_path / "b", *lines, live=True)
