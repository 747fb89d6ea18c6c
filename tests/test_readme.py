"""The README tells the truth: its session is the shipped lesson's, its verbs and files exist."""

from __future__ import annotations

import re
from pathlib import Path

from assistant.cli.adapters import make_equipment
from assistant.cli.running import VERBS
from assistant.files.shipped import shipped
from assistant.files.transcripts import read_transcript
from assistant.session.player import Player

ROOT = Path(__file__).parents[1]
README = (ROOT / "README.md").read_text("utf-8")


def squeezed(text: str) -> str:
    return re.sub(r"\s+", " ", text).strip()


def test_the_session_is_what_the_shipped_lesson_says(tmp_path: Path) -> None:
    heard: list[str] = []
    lesson = read_transcript(shipped("transcripts") / "pick_and_place.yaml")
    played = Player(lesson, make_equipment, tmp_path, lambda _, words: heard.append(words)).play()
    assert played.difference is None
    said = squeezed(" ".join(heard))
    shown = README[README.index("robot: What is the task called?") :].split("```")[0]
    lines = [squeezed(line) for line in re.split(r"\n(?=robot:|  you:|\.\.\.)", shown)]
    told = [line.split(": ", 1)[1] for line in lines if line and line != "..."]
    assert len(told) > 15
    # How far off the block lies is measured anew by each run.
    assert [line for line in told if "off its place" not in line and line not in said] == []


def test_every_verb_and_file_named_is_there() -> None:
    named = set(re.findall(r"`assistant (\w+)", README))
    assert named
    assert named <= set(VERBS)
    pictures = re.findall(r"\]\((\S+\.png)\)", README)
    assert pictures
    assert all((ROOT / picture).is_file() for picture in pictures)


def test_both_commands_stand_where_scripts_look_for_them() -> None:
    for command in ("demo", "test"):
        block = README.split(f"<!-- command: {command} -->\n```sh\n")[1].split("\n```")[0]
        assert block.startswith("python3 -m venv .venv && .venv/bin/pip install")
