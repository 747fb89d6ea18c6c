"""The typed line: Ctrl-D is "quit", so that what is not saved is asked about."""

from __future__ import annotations

from pathlib import Path

import pytest
from prompt_toolkit.application import create_app_session
from prompt_toolkit.input import create_pipe_input
from prompt_toolkit.output import DummyOutput

from assistant.cli.adapters import make_equipment
from assistant.model.robot_acts import RobotAct
from assistant.session.opening import Opening, open_session
from assistant.shells.text import TextShell
from tests.session.lessons import HEAD

CTRL_D = "\x04"
STAYS = ("ask.unsaved", "told.as_it_was", "ask.goal", "ask.unsaved")


def topics_of(home: Path, keys: str) -> list[str]:
    """Return what a robot says to keys typed at a terminal, after its first question."""
    told: list[str] = []
    shell = TextShell(home / "history", 50.0)

    def out(line: RobotAct, text: str) -> None:
        told.append(f"{line.act}.{line.topic}")
        shell.out(line, text)

    with create_pipe_input() as typed, create_app_session(input=typed, output=DummyOutput()):
        session = open_session(Opening(make_equipment, home, out, shell.attach), HEAD)
        told.clear()
        typed.send_text(keys)
        shell.run(session)
        session.close()
    return told


@pytest.mark.parametrize(
    ("keys", "topics"),
    [
        (CTRL_D, ["told.goodbye"]),
        (f"stacking\r{CTRL_D}no\r", ["ask.goal", "ask.unsaved", "told.goodbye"]),
        (f"stacking\r{CTRL_D}{CTRL_D}", ["ask.goal", "ask.unsaved", "told.goodbye"]),
        (f"stacking\r{CTRL_D}wait\r{CTRL_D}no\r", ["ask.goal", *STAYS, "told.goodbye"]),
    ],
)
def test_a_closed_line_asks_about_unsaved_work_once(
    tmp_path: Path, keys: str, topics: list[str]
) -> None:
    assert topics_of(tmp_path, keys) == topics
