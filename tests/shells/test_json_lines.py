from __future__ import annotations

import json
import threading
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest

from assistant.cli.adapters import make_equipment
from assistant.errors import BadInput
from assistant.files.tasks import write_task
from assistant.model.transcript import Demonstrate, SetupStep, Transcript, Wait
from assistant.session.loop import Session
from assistant.session.opening import Opening, open_session
from assistant.shells.json_lines import JsonShell, step_of
from tests.session.test_practice import learned


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


def practicing(home: Path) -> tuple[JsonShell, Session, list[str]]:
    """A program that has learned the task, with the arm at rest."""
    told: list[str] = []
    shell = JsonShell(told.append)
    file = home / "learned.yaml"
    write_task(learned("pick_and_place"), file)
    header = Transcript("program", arm="kinematic", task=str(file))
    session = open_session(Opening(make_equipment, home, shell.out), header)
    return shell, session, told


def test_a_stop_word_is_seen_while_time_passes(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    shell, session, told = practicing(tmp_path)
    ticks, tick = 0, session.tick
    stop = threading.Event()

    def ticked() -> None:
        nonlocal ticks
        ticks += 1
        if ticks == 50:
            stop.set()
            # The line is read beside; the arm goes on until it was.
            assert session.equipment.stop_flag.wait(20.0)
        tick()

    def lines() -> Iterator[str]:
        yield from ("go", "yes", '{"wait": "rest"}')
        assert stop.wait(20.0)
        yield "don't stop"

    monkeypatch.setattr(session, "tick", ticked)
    shell.run(session, lines())
    session.close()
    assert ticks < 50 + 15
    assert any(json.loads(line).get("topic") == "stop" for line in told)


def test_input_that_ends_while_the_arm_moves_stops_it(tmp_path: Path) -> None:
    shell, session, told = practicing(tmp_path)
    shell.run(session, iter(("go", "yes", '{"wait": 2.0}')))
    session.close()
    stopped = [json.loads(line) for line in told if '"stopped"' in line]
    assert "nobody is there" in stopped[0]["text"]
    assert not session.moving


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
