"""Whatever is written in color can be read on a light background and on a dark one."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

import assistant.shells
from assistant.shells.driving_screen import QUIET, STATE, STRONG, WARNING
from assistant.shells.text import HINT_STYLE, NAME_STYLE, STYLES

PALETTE = {
    "black": (0, 0, 0),
    "red": (205, 0, 0),
    "green": (0, 205, 0),
    "yellow": (205, 205, 0),
    "blue": (0, 0, 238),
    "magenta": (205, 0, 205),
    "cyan": (0, 205, 205),
    "white": (229, 229, 229),
}
"""The colors of xterm, by the last digit of their codes."""
GRAY = (127, 127, 127)
LEAST = 3.0
"""Contrast of large text and of signs (WCAG 2.1, 1.4.11)."""


def luminance(rgb: tuple[int, int, int]) -> float:
    """Return how bright a color is (WCAG 2.1)."""
    shares = [value / 255.0 for value in rgb]
    red, green, blue = (
        share / 12.92 if share <= 0.04045 else ((share + 0.055) / 1.055) ** 2.4 for share in shares
    )
    return 0.2126 * red + 0.7152 * green + 0.0722 * blue


def contrast(rgb: tuple[int, int, int], ground: tuple[int, int, int]) -> float:
    """Return how much a color differs from what it stands on."""
    low, high = sorted((luminance(rgb), luminance(ground)))
    return (high + 0.05) / (low + 0.05)


def readable(rgb: tuple[int, int, int]) -> bool:
    """Whether a color can be read on black and on white."""
    return all(contrast(rgb, ground) >= LEAST for ground in ((0, 0, 0), (255, 255, 255)))


@pytest.mark.parametrize("style", [*STYLES.values(), NAME_STYLE, HINT_STYLE])
def test_the_robots_lines_can_be_read_on_any_ground(style: str) -> None:
    colors = [code for code in style.split(";") if len(code) == 2]
    names = list(PALETTE)
    for code in colors:
        assert readable(GRAY if code == "90" else PALETTE[names[int(code[1])]])


@pytest.mark.parametrize("style", [QUIET, STATE, STRONG, WARNING])
def test_the_view_of_the_driven_hand_can_be_read_on_any_ground(style: str) -> None:
    for word in style.split():
        name = word.removeprefix("ansi")
        assert name == "bold" or readable(GRAY if name == "brightblack" else PALETTE[name])


def test_no_other_color_is_written_anywhere() -> None:
    unreadable = [name for name, rgb in PALETTE.items() if not readable(rgb)]
    assert {"yellow", "cyan", "green"} <= set(unreadable)
    for path in Path(assistant.shells.__path__[0]).glob("*.py"):
        told = re.findall(r"style=\"(\w+)\"|\"ansi(\w+)\"", path.read_text("utf-8"))
        assert not {name for pair in told for name in pair} & set(unreadable), path.name
