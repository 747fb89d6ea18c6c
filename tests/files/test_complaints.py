"""Whatever stands in a file, each complaint tells where, what is wrong and what would be right."""

from __future__ import annotations

import re
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from assistant.errors import BadInput
from assistant.files.kinds import read_known
from assistant.files.shipped import shipped
from assistant.files.tasks import task_text
from assistant.plain_yaml import read_text, write
from tests.files.examples import lesson, task

COMPLAINT = re.compile(r"x\.(?:yaml|csv):\d+: \S.*; \S.*")
FOREIGN = re.compile(r"[Ii]nput should|discriminat|valid (?:dict|tuple|list)|Form\b|tag '|\bctx\b")
JUNK: tuple[Any, ...] = (
    *(None, True, -1, 7, 1e300, float("nan"), float("inf"), "", "x", " x ", "a\nb", "a" * 300),
    *([], [1], ["x"], [[]], {}, {"a": 1}, {"near": "x", "within": -1}, "/(/", "\x00", "1e999"),
)
FILES = (
    *("tasks/pick_and_place.yaml", "tasks/setups/wiping.yaml", "tasks/scenes/sorting_table.yaml"),
    *("tasks/demonstrations/wiping.yaml", "transcripts/stop_while_moving.yaml"),
    "transcripts/misheard.yaml",
)


def texts() -> Iterator[str]:
    for name in FILES:
        kind, _, rest = name.partition("/")
        yield (shipped("tasks" if kind == "tasks" else "transcripts") / rest).read_text("utf-8")
    yield task_text(task(lesson()))


def places(value: Any, place: tuple[str | int, ...] = ()) -> Iterator[tuple[str | int, ...]]:
    yield place
    parts = enumerate(value) if isinstance(value, list) else ()
    for key, part in value.items() if isinstance(value, dict) else parts:
        yield from places(part, (*place, key))


def changed(value: Any, place: tuple[str | int, ...], junk: Any) -> Any:
    if not place:
        return junk
    copy: Any = dict(value) if isinstance(value, dict) else list(value)
    copy[place[0]] = changed(value[place[0]], place[1:], junk)
    return copy


def complaints(path: Path) -> list[str]:
    try:
        read_known(path)
    except BadInput as error:
        return [str(problem).replace(f"{path.parent}/", "") for problem in error.problems]
    return []


@pytest.mark.parametrize("text", tuple(texts()), ids=(*FILES, "a lesson"))
def test_any_value_anywhere_is_read_or_told(
    text: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    Path("wiping.csv").write_bytes((shipped("tasks") / "demonstrations/wiping.csv").read_bytes())
    rng = np.random.default_rng(0)
    value = read_text(text)[0].value
    every = list(places(value))[1:]
    refused = 0
    for at in rng.permutation(len(every))[:40]:
        junk = JUNK[rng.integers(len(JUNK))]
        bad = changed(value, every[at], junk)
        Path("x.yaml").write_text(write(bad), "utf-8")
        for told in complaints(Path("x.yaml")):
            refused += 1
            assert COMPLAINT.fullmatch(told), (every[at], junk, told)
            assert not FOREIGN.search(told), (every[at], junk, told)
    assert refused


def test_repeated_keys_and_tags_are_told_with_the_rest(tmp_path: Path) -> None:
    path = tmp_path / "x.yaml"
    text = "format: setup/1\nname: a\nname: 7\nscene: !x table\nplaces: 3\nmore: 1\n"
    path.write_text(f"{text}---\nformat: setup/1\nname: b\nname: b\n")
    assert complaints(path) == [
        "x.yaml:3: key 'name' stands here again (first on line 2); each key once",
        "x.yaml:3: name: 7 is not a text; put it in quotes",
        "x.yaml:4: tag '!x' is not allowed; write plain values without '!'",
        "x.yaml:5: places: 3 is not a mapping; write key: value",
        "x.yaml:6: unknown key 'more'; known keys: name, scene, robot_start, places, format",
        "x.yaml:10: key 'name' stands here again (first on line 9); each key once",
    ]


def test_steps_and_patterns_are_told_with_the_rest(tmp_path: Path) -> None:
    path = tmp_path / "x.yaml"
    path.write_text(
        "format: transcript/1\ntitle: 7\nsteps:\n  - robot: /(/\n  - robot: {words: '/[/'}\n"
        "  - expect: {a.b: {near: x, within: 1}, c: {near: 1, within: -1}}\n"
        "  - robot: {slots: {n: [{near: true, within: 1}]}}\n  - {}\n  - 3\n"
    )
    lines = [int(told.split(":")[1]) for told in complaints(path)]
    assert lines == [2, 4, 5, 6, 7, 8, 9]


def test_parts_of_a_lesson_are_told_together(tmp_path: Path) -> None:
    text = task_text(task(lesson()))
    for old, new in (
        ("[t_s, vote,", "[t, vote,"),
        ("[t_s, x_m,", "[t_s, y_m,"),
        ("at: 10", "at: 99"),
    ):
        assert old in text
        text = text.replace(old, new, 1)
    path = tmp_path / "x.yaml"
    path.write_text(text)
    assert len(complaints(path)) == 3


def test_a_demonstration_and_its_recording_are_told_together(tmp_path: Path) -> None:
    path = tmp_path / "x.yaml"
    path.write_text("format: demonstration/1\nrecording: x.csv\ncues: 3\n")
    (tmp_path / "x.csv").write_text(
        "t_s,x_m,y_m,z_m,qx,qy,qz,qw\n0,0,0,0,0,0,0,1\nx\n1,nan,0,0,0,0,0,1\n0,0,0,0,0,0,0,2\n"
    )
    told = complaints(path)
    assert [one.split(":")[:2] for one in told] == [
        ["x.csv", "3"],
        ["x.yaml", "3"],
        ["x.csv", "4"],
        ["x.csv", "5"],
    ]


def test_steps_of_one_name_on_one_line_are_told(tmp_path: Path) -> None:
    path = tmp_path / "x.yaml"
    step = "{primitive: up, action: {move: up}}"
    path.write_text(f"format: task/1\nname: a\ntree: {{subtask: a, parts: [{step}, {step}]}}\n")
    (told,) = complaints(path)
    assert told.startswith("x.yaml:3: the name 'up' stands here again (first on line 3); each")
