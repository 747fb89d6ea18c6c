"""A whole lesson in German: by a program, and at a terminal."""

from __future__ import annotations

import signal
from pathlib import Path

import pytest

from assistant.files.tasks import read_task
from tests.cli.at_a_terminal import Teacher
from tests.cli.test_teach import Program

TALK = (
    ("Umsetzen", "task_name"),
    ("der Block liegt auf dem Ziel", "goal"),
    ("der Block und das Ziel", "objects"),
    (
        "zuerst den Block anfahren, dann den Block greifen, dann anheben, danach zum Ziel absenken"
        " und dann loslassen",
        "subtask_count",
    ),
    ("ja", "confirm_tree"),
    ("ich bin bereit", "ready"),
)
QUESTIONS = (
    ("Umsetzen", "Was soll der Fall sein"),
    ("der Block liegt auf dem Ziel", "Welche Dinge"),
    ("der Block und das Ziel", "In wie viele Schritte"),
    (TALK[3][0], "Stimmt das"),
    ("ja", "Bist du bereit"),
    ("ja", "DATEI"),
    ("fertige hand 4", "Ich denke"),
)
AFTER = [r"anfangen\?", "weglassen", "verschieben"]


def test_a_program_teaches_in_german(tmp_path: Path) -> None:
    program = Program(tmp_path, "--setup", "demonstration", "--language", "de")
    for words, asked in TALK:
        assert program.turn()["asked"] == asked
        program.say(words)
    program.turn()
    program.say({"demonstrate": {"hand": "scripted", "seed": 2, "cues": "auto"}})
    while (turn := program.turn())["asked"] != "ready":
        program.say("ja")
    for answer in ("los", {"wait": "rest"}, "ja, das war gut", "speichern"):
        program.say(answer)
        turn = program.turn()
    assert turn["asked"] == "ready"
    assert program.end() == 0
    (kept,) = (tmp_path / "tasks").glob("*.yaml")
    task = read_task(kept)
    assert {one.name: one.role for one in task.objects} == {"block": "object", "target": "target"}
    assert task.learned is not None
    assert any("gespeichert" in str(line.get("text")).lower() for line in program.told)


@pytest.mark.slow
def test_a_german_lesson_at_a_terminal(tmp_path: Path) -> None:
    teacher = Teacher(tmp_path, "--language", "de", "--setup", "demonstration")
    terminal = teacher.terminal
    terminal.expect("Einführung.*noch keine Aufgabe.*Arm ruht")
    for text, then in QUESTIONS:
        teacher.say(text, then)
    # Pressed while no line is open, it stops what moves and ends nothing.
    terminal.kill(signal.SIGINT)
    terminal.expect("Ich habe 5 Teile gesehen")
    # Which questions follow is the cutter's affair.
    while terminal.expect(AFTER):
        terminal.send("ja\r")
    teacher.say("los", "Block anfahren")
    teacher.prompted()
    teacher.say("halt!", "stehen geblieben")
    teacher.say("los", "War das richtig")
    teacher.say("beenden", "speichern")
    teacher.say("ja", "Gespeichert unter dem Namen")
    terminal.close()
