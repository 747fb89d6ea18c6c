"""A whole lesson through a pseudo-terminal, the task shown by keys."""

from __future__ import annotations

import contextlib
import os
import sys
import time
from pathlib import Path

import numpy as np
import pexpect
import pytest

from assistant.geometry import Array
from assistant.model.transcript import SetupChoice
from assistant.session.opening import chosen

KEYS = (("w", "s"), ("a", "d"), ("r", "f"))
"""Keys for more and for less of x, y and z."""
RESTS_S = 0.2
FLAGS = ("--arm", "kinematic", "--pace", "8")


class Teacher:
    """Someone at a keyboard who looks where the hand is."""

    def __init__(self, home: Path, *more: str) -> None:
        self.home = home
        environment = {**os.environ, "ASSISTANT_HOME": str(home), "TERM": "xterm"}
        self.terminal = pexpect.spawn(
            sys.executable,
            ["-m", "assistant", "teach", *FLAGS, *more],
            env=environment,
            encoding="utf-8",
            timeout=150,
            dimensions=(40, 120),
        )

    def say(self, text: str, then: str) -> None:
        self.terminal.send(f"{text}\r")
        self.terminal.expect(then)

    def tell_where_the_cursor_is(self) -> None:
        """Answer as a terminal does; the bar is drawn once that is known."""
        self.terminal.expect_exact("\x1b[6n")
        self.terminal.send("\x1b[12;1R")

    def hand(self) -> tuple[Array, float]:
        """Return pose and opening as recorded last."""
        row = self.sample()
        return row[1:8], float(row[8])

    def sample(self) -> Array:
        """Return the last whole row of the recording."""
        path = self.home / "sessions" / "1" / "recording_1.csv"
        while True:
            lines = path.read_bytes()[-1000:].split(b"\n") if path.exists() else []
            if len(lines) > 2:
                return np.array([float(text) for text in lines[-2].split(b",")])
            time.sleep(0.05)

    def press(self, key: str) -> None:
        self.terminal.send(key)
        # A terminal repeats a held key about this often; drain what it draws meanwhile.
        time.sleep(0.03)
        with contextlib.suppress(pexpect.TIMEOUT):
            self.terminal.read_nonblocking(100_000, timeout=0)

    def rest(self) -> Array:
        """Return the hand's pose once it rests by its own clock, however slow the machine is."""
        since = self.sample()
        while True:
            self.press("")
            now = self.sample()
            if not np.array_equal(now[1:8], since[1:8]):
                since = now
            elif now[0] - since[0] > RESTS_S:
                return np.array(now[1:8])

    def drive(self, goal: Array, axis: str, within: float = 0.001) -> None:
        """Hold a key until the hand is near where it should be, then tap it."""
        k = "xyz".index(axis)
        for _ in range(2000):
            gap = float(goal[k] - self.hand()[0][k])
            if abs(gap) < 0.03:
                break
            self.press(KEYS[k][0 if gap > 0 else 1])
        for _ in range(40):
            gap = float(goal[k] - self.rest()[k])
            if abs(gap) < within:
                return
            self.tap(KEYS[k][0 if gap > 0 else 1])
        raise AssertionError("the hand does not get there")

    def tap(self, key: str) -> None:
        """Press a key once and wait until the hand moves."""
        before = self.hand()[0]
        self.press(key)
        for _ in range(600):
            if not np.array_equal(self.hand()[0], before):
                return
            time.sleep(0.02)
        raise AssertionError("the hand does not move")

    def act(self, key: str, opening: float) -> None:
        self.press(key)
        for _ in range(1000):
            if abs(self.hand()[1] - opening) < 0.003:
                return
            time.sleep(0.05)
        raise AssertionError("the hand does not act")


SETUP = """\
format: setup/1
name: near
scene: demonstration_table
robot_start: {hand_xyz_mm: [480, 120, 397], hand_rpy_deg: [0, 0, 0]}
places:
  block: {hand_xyz_mm: [560, 120, 396.7], hand_rpy_deg: [0, 0, 0]}
  target: {hand_xyz_mm: [560, -60, 403], hand_rpy_deg: [0, 0, 0]}
"""
TALK = (
    ("pick and place", "should be the case"),
    ("the block rests on the target", "Which things"),
    ("the block and the target", "how many steps"),
    ("five", "first of the 5"),
    ("approach the block", "second of"),
    ("grasp the block", "third of"),
    ("move up", "fourth of"),
    ("move down to the target", "fifth of"),
    ("place the block on the target", "parts"),
    ("none", "Is that right"),
    ("yes", "Are you ready"),
    ("yes", "FILE"),
    ("keys", "clutch"),
)


def show(teacher: Teacher, block: Array, target: Array) -> None:
    """Pick the block up and place it, saying the cues by keys."""
    above = np.array([0.0, 0.0, 0.06, 0.0, 0.0, 0.0, 0.0])
    for key in "++1":
        teacher.press(key)
    teacher.drive(block, "x")
    teacher.press("n")
    teacher.act("c", 0.04)
    teacher.press("n")
    teacher.drive(block + above, "z", within=0.01)
    teacher.press("n")
    for axis in "yxz":
        teacher.drive(target, axis)
    teacher.press("n")
    teacher.act("o", 0.08)
    for _ in range(8):
        teacher.press("s")
    teacher.terminal.send("\x1b")


@pytest.mark.slow
def test_a_lesson_shown_by_keys(tmp_path: Path) -> None:
    setup_file = tmp_path / "near.yaml"
    setup_file.write_text(SETUP)
    scene, setup = chosen(SetupChoice(file=str(setup_file)), tmp_path)
    teacher = Teacher(tmp_path, "--setup", str(setup_file))
    teacher.terminal.expect("What is the task called")
    for text, then in TALK:
        teacher.say(text, then)
    show(teacher, *(scene.hand_pose(name, setup.places[name]) for name in ("block", "target")))
    teacher.terminal.expect("I saw 5 parts")
    # Which questions follow depends on how well the keys were driven.
    while teacher.terminal.expect(["Shall I go ahead", "leave it out", "not sure", "showed me"]):
        teacher.terminal.send("yes\r")
    teacher.say("go", "approach the block")
    teacher.terminal.send("\x03")
    teacher.terminal.expect("I stopped")
    teacher.say("start", "Was that right")
    teacher.say("quit", "Shall I save it")
    teacher.say("yes", "I saved it")
    teacher.terminal.expect("resume 1")
    teacher.terminal.expect(pexpect.EOF)
    teacher.terminal.close()
    assert teacher.terminal.exitstatus == 0
    assert (tmp_path / "tasks" / "pick_and_place.yaml").is_file()


def test_the_line_completes_remembers_and_has_a_bar_below(tmp_path: Path) -> None:
    teacher = Teacher(tmp_path)
    terminal = teacher.terminal
    teacher.tell_where_the_cursor_is()
    terminal.expect("introduction.*no task yet.*arm at rest")
    teacher.say("pick and place", "should be the case")
    teacher.tell_where_the_cursor_is()
    terminal.expect("introduction.*pick and place.*arm at rest")
    terminal.send("what d\t")
    terminal.expect("id you say")
    terminal.send("\r")
    terminal.expect("should be the case")
    terminal.send("pick\x1b[A")
    terminal.expect("and place")
    terminal.send("\x03")
    terminal.sendeof()
    terminal.expect("resume 1")
    terminal.expect(pexpect.EOF)
    terminal.close()
    assert terminal.exitstatus == 0


def sgr(button: int, column: int, line: int, end: str) -> str:
    """Return what a terminal sends for the mouse, places counted from 1."""
    return f"\x1b[<{button};{column};{line}{end}"


def test_the_mouse_drags_the_hand_while_its_button_is_held(tmp_path: Path) -> None:
    teacher = Teacher(tmp_path)
    terminal = teacher.terminal
    terminal.expect("What is the task called")
    for text, then in TALK:
        teacher.say(text, then)
    begin = teacher.rest()
    for _ in range(40):
        # Only what answers where its cursor is can be told where the mouse is; an answer that
        # comes before the pictures are drawn is not for them, so all of it is told again.
        terminal.send("\x1b[8;1R")
        # The pictures lie side by side below the keys; this is within the left one, from above.
        terminal.send(sgr(0, 20, 20, "M"))
        for line in (19, 18, 17):
            terminal.send(sgr(32, 20, line, "M"))
        for _ in range(20):
            teacher.press("")
        if teacher.hand()[0][0] > begin[0] + 0.01:
            break
    terminal.send(sgr(0, 20, 17, "m"))
    there = teacher.rest()
    assert there[0] > begin[0] + 0.01
    assert there[1:3] == pytest.approx(begin[1:3], abs=1e-4)
    # Without the button the pointer moves nothing.
    for line in (16, 17, 18):
        terminal.send(sgr(35, 20, line, "M"))
    assert np.array_equal(teacher.rest(), there)
    terminal.send(sgr(64, 20, 18, "M"))
    for _ in range(200):
        teacher.press("")
        if teacher.hand()[0][2] > there[2] + 0.001:
            break
    assert teacher.rest()[2] == pytest.approx(there[2] + 0.005, abs=1e-4)
    terminal.close(force=True)
