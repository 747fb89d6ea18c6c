from __future__ import annotations

import json
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest

from assistant.cli.adapters import make_equipment
from assistant.errors import BadInput
from assistant.model.transcript import Demonstrate, SetupStep, Transcript, Wait
from assistant.session.opening import Opening, open_session
from assistant.shells.json_lines import JsonShell, step_of


def talk(home: Path, *lines: str) -> list[dict[str, Any]]:
    told: list[str] = []
    shell = JsonShell(told.append)
    session = open_session(Opening(make_equipment, home, shell.out), Transcript("program"))
    shell.run(session, iter(lines))
    session.close()
    return [json.loads(line) for line in told]


def test_every_robot_line_has_its_fields(tmp_path: Path) -> None:
    told = talk(tmp_path, "it's called pick and place")
    lines = [one for one in told if "act" in one]
    assert all({"act", "asked", "about", "text", "stage"} <= set(one) for one in lines)
    asked = [one["asked"] for one in lines if one["asked"]]
    assert asked[:2] == ["task_name", "goal"]
    assert lines[2]["about"] == {"name": "pick and place", "index": []}


def test_ready_follows_every_line_and_the_end_quits(tmp_path: Path) -> None:
    told = talk(tmp_path, "pick and place", "", '{"wait": 1.5}')
    ready = [one for one in told if "ready" in one]
    assert ready == [{"ready": True, "moving": False}] * 4
    assert told[-1]["asked"] == "unsaved"


def test_input_that_breaks_stops_the_arm_and_ends_the_talk(tmp_path: Path) -> None:
    def lines() -> Iterator[str]:
        yield "pick and place"
        raise OSError("the other end is gone")

    told: list[str] = []
    shell = JsonShell(told.append)
    session = open_session(Opening(make_equipment, tmp_path, shell.out), Transcript("program"))
    shell.run(session, lines())
    session.close()
    assert not session.in_touch()
    assert json.loads(told[-1])["asked"] == "unsaved"


@pytest.mark.parametrize(
    "line", ['{"dance": 1}', "{nonsense", '{"wait": 1, "setup": "table1_1"}', '{"teacher": "go"}']
)
def test_a_bad_step_is_told_and_the_talk_goes_on(tmp_path: Path, line: str) -> None:
    told = talk(tmp_path, line, "pick and place")
    errors = [one for one in told if one.get("act") == "error"]
    assert len(errors) == 1
    assert "demonstrate" in errors[0]["text"]
    assert any(one.get("asked") == "goal" for one in told)


def test_showing_before_the_introduction_is_refused(tmp_path: Path) -> None:
    told = talk(tmp_path, '{"demonstrate": {"hand": "scripted", "seed": 1, "cues": "auto"}}')
    assert any("introduce the task first" in one.get("text", "") for one in told)


def test_a_setup_is_arranged(tmp_path: Path) -> None:
    told = talk(tmp_path, '{"setup": "table1_1"}', '{"setup": "nowhere"}')
    assert any(one.get("act") == "read_back" for one in told)
    assert any("no setup 'nowhere'" in one.get("text", "") for one in told)


def test_steps_are_read_like_those_of_transcripts() -> None:
    assert step_of('{"wait": "rest"}') == Wait(None)
    assert step_of('{"wait": 2.0}') == Wait(2.0)
    assert isinstance(step_of('{"setup": "table1_1"}'), SetupStep)
    shown = step_of('{"demonstrate": {"hand": "scripted", "seed": 3, "cues": "auto"}}')
    assert shown == Demonstrate(seed=3, cues=None)
    with pytest.raises(BadInput):
        step_of('{"wait": "long"}')
