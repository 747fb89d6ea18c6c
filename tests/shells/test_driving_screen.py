"""The whole view while the hand is driven: nothing wider than the terminal, all that matters."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import pytest

from assistant.language.hints import page
from assistant.shells.driving_screen import Screen
from sim.hands import KeyedHand
from tests.session.lessons import lesson, opened


@pytest.fixture
def screen(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Iterator[Screen]:
    """A view whose clutch is out, in a lesson that is being shown."""
    monkeypatch.setenv("COLUMNS", "100")
    monkeypatch.setenv("LINES", "40")
    session = opened(tmp_path)
    for _ in lesson(session):
        if session.watching is not None:
            break
    mover, equipment = session.mover, session.equipment
    mover.arrange(mover.scene, mover.setup)
    hand = KeyedHand(equipment.arm, equipment.planner, mover.scene, mover.setup)
    hand.press(" ")
    yield Screen(session, hand, page("terminal")["driving"], lambda key: None)
    session.close()


def drawn(screen: Screen) -> list[str]:
    fragments = screen.fragments("forward", dragging=False)
    return "".join(part[1] for part in fragments).split("\n")


SIZES = [(100, 40), (80, 24), (60, 24), (60, 16), (40, 20), (120, 50)]


def test_the_view_fits_the_terminal_however_it_is_resized(
    screen: Screen, monkeypatch: pytest.MonkeyPatch
) -> None:
    for columns, lines in SIZES:
        monkeypatch.setenv("COLUMNS", str(columns))
        monkeypatch.setenv("LINES", str(lines))
        shown = drawn(screen)
        assert len(shown) < lines
        assert max(len(line) for line in shown) < columns
        text = " ".join(" ".join(shown).split())
        for told in ("to the block", "to the target", "press 1 and show", "clutch out", "Esc fini"):
            assert told in text
        # Where the mouse is looked for is where the pictures are.
        for area in screen.areas:
            picture = shown[area.line : area.line + area.sight.rows]
            assert all(line[area.column] in ".+oBT_" for line in picture)
            assert shown[area.line - 1].strip().startswith("from above")


def test_a_large_terminal_tells_what_each_key_does_and_a_small_one_keeps_its_pictures(
    screen: Screen, monkeypatch: pytest.MonkeyPatch
) -> None:
    assert "w forward" in " ".join(drawn(screen))
    monkeypatch.setenv("COLUMNS", "60")
    monkeypatch.setenv("LINES", "24")
    assert "w forward" not in " ".join(drawn(screen)).split("to the block")[0]
    assert len(screen.areas) == 2


def test_in_german_the_things_and_the_keys_have_german_names(screen: Screen) -> None:
    screen._session.language = "german"
    german = Screen(screen._session, screen._hand, page("terminal", "german")["driving"], print)
    text = " ".join(drawn(german))
    assert "zu „Block“" in text
    assert "Leertaste Kupplung" in text
    assert "space" not in text
