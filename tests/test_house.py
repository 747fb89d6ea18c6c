"""The rows of the house: imports point down, never up, never to a neighbor in the same row."""

from __future__ import annotations

import ast
from collections.abc import Iterator
from pathlib import Path

import pytest

ROOT = Path(__file__).parent.parent
ROWS = (
    ("assistant.cli",),
    ("assistant.shells", "sim"),
    ("assistant.session",),
    ("assistant.ports", "assistant.files"),
    ("assistant.dialogue",),
    ("assistant.learning", "assistant.language"),
    ("assistant.model",),
    ("assistant.geometry", "assistant.plain_yaml"),
    ("assistant.errors",),
)
ROOMS = {room: row for row, rooms in enumerate(ROWS) for room in rooms}
HOMES = {
    "pybullet": {"sim"},
    "pybullet_data": {"sim"},
    "toppra": {"sim"},
    "ruckig": {"sim"},
    "prompt_toolkit": {"assistant.shells"},
    "rich": {"assistant.shells"},
    "matplotlib": {"assistant.shells"},
    "yaml": {"assistant.plain_yaml"},
    "filterpy": {"assistant.learning"},
    "time": {"assistant.shells", "sim"},
}
OUTSIDE = {"assistant", "assistant.__main__"}


def modules() -> list[tuple[str, Path]]:
    paths = [path for top in ("assistant", "sim") for path in (ROOT / top).rglob("*.py")]
    named = [(".".join(path.relative_to(ROOT).with_suffix("").parts), path) for path in paths]
    return sorted((name.removesuffix(".__init__"), path) for name, path in named)


def imported(path: Path, module: str) -> Iterator[str]:
    for node in ast.walk(ast.parse(path.read_text("utf-8"))):
        if isinstance(node, ast.Import):
            yield from (alias.name for alias in node.names)
        elif isinstance(node, ast.ImportFrom):
            assert node.level == 0, f"{module}: imports are written out in full"
            yield from (f"{node.module}.{alias.name}" for alias in node.names)


def room_of(module: str) -> str | None:
    return next(
        (room for room in ROOMS if module == room or module.startswith(f"{room}.")),
        None,
    )


@pytest.mark.parametrize(("module", "path"), modules(), ids=lambda value: str(value).split("/")[-1])
def test_imports_point_down(module: str, path: Path) -> None:
    room = room_of(module)
    assert room is not None or module in OUTSIDE, f"{module} stands in no row"
    for name in imported(path, module):
        target = room_of(name)
        if target is None or target == room or room is None:
            continue
        assert ROOMS[target] > ROOMS[room], f"{module} imports {name}: rows point down"


@pytest.mark.parametrize(("module", "path"), modules(), ids=lambda value: str(value).split("/")[-1])
def test_libraries_stay_at_home(module: str, path: Path) -> None:
    room = room_of(module)
    for name in imported(path, module):
        homes = HOMES.get(name.split(".")[0])
        assert homes is None or room in homes, f"{module} imports {name}, whose home is {homes}"


@pytest.mark.parametrize(("module", "path"), modules(), ids=lambda value: str(value).split("/")[-1])
def test_no_unseeded_randomness(module: str, path: Path) -> None:
    for node in ast.walk(ast.parse(path.read_text("utf-8"))):
        if isinstance(node, ast.Import):
            assert all(alias.name != "random" for alias in node.names), module
        if isinstance(node, ast.Call) and isinstance(node.func, ast.Attribute):
            if node.func.attr == "default_rng":
                assert node.args or node.keywords, f"{module}:{node.lineno}: seed the generator"
            drawn = ast.unparse(node.func)
            assert not drawn.startswith("np.random.") or drawn == "np.random.default_rng", module


def test_every_row_has_a_room() -> None:
    found = {room_of(module) for module, _ in modules()} - {None}
    assert found == set(ROOMS)
