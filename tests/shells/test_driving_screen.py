"""The whole view while the hand is driven: nothing wider than the terminal, all that matters."""

from __future__ import annotations

from pathlib import Path

import pytest

from assistant.language.hints import page
from assistant.shells.driving_screen import Screen
from sim.hands import KeyedHand
from tests.session.lessons import lesson, opened


@pytest.mark.parametrize(("columns", "lines"), [("80", "24"), ("120", "40")])
def test_the_view_fits_the_terminal(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, columns: str, lines: str
) -> None:
    monkeypatch.setenv("COLUMNS", columns)
    monkeypatch.setenv("LINES", lines)
    session = opened(tmp_path)
    for _ in lesson(session):
        if session.watching is not None:
            break
    mover, equipment = session.mover, session.equipment
    mover.arrange(mover.scene, mover.setup)
    hand = KeyedHand(equipment.arm, equipment.planner, mover.scene, mover.setup)
    screen = Screen(session, hand, page("terminal")["driving"], lambda key: None)
    hand.press(" ")
    text = "".join(part[1] for part in screen.fragments("forward", dragging=False))
    shown = text.split("\n")
    assert len(shown) < int(lines)
    assert max(len(line) for line in shown) < int(columns)
    for told in ("w forward", "Esc finished", "to the block", "press 1 and show", "clutch out"):
        assert told in text
    # Where the mouse is looked for is where the pictures are.
    for area in screen.areas:
        picture = shown[area.line : area.line + area.sight.rows]
        assert all(line[area.column] in ".+oBT_" for line in picture)
        assert shown[area.line - 1].strip().startswith("from above")
    session.close()
