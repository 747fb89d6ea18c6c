"""A whole lesson through a pseudo-terminal, the task shown by keys."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pexpect
import pytest

from assistant.geometry import Array
from assistant.model.transcript import SetupChoice
from assistant.session.opening import chosen
from tests.cli.at_a_terminal import Teacher, introduced

SETUP = """\
format: setup/1
name: near
scene: demonstration_table
robot_start: {hand_xyz_mm: [480, 80, 397], hand_rpy_deg: [0, 0, 0]}
places:
  block: {hand_xyz_mm: [560, 80, 396.7], hand_rpy_deg: [0, 0, 0]}
  target: {hand_xyz_mm: [560, -60, 403], hand_rpy_deg: [0, 0, 0]}
"""


def show(teacher: Teacher, block: Array, target: Array) -> None:
    """Pick the block up and place it, saying the cues by keys."""
    above = np.array([0.0, 0.0, 0.06, 0.0, 0.0, 0.0, 0.0])
    teacher.press("1")
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
    teacher.introduce()
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
    terminal.expect("introduction.*no task yet.*arm at rest")
    teacher.say("pick and place", "should be the case")
    terminal.expect("introduction.*pick and place.*arm at rest")
    terminal.send("what d\t")
    terminal.expect("id you say")
    terminal.send("\r")
    terminal.expect("should be the case")
    teacher.say("what\x1b[A", "should be the case")
    journal = tmp_path / "sessions" / "1" / "journal.yaml"
    assert journal.read_text("utf-8").count("teacher: what did you say") == 2
    teacher.prompted()
    # What is pasted in two lines answers two questions.
    terminal.send("\x1b[200~the block rests on the target\nthe block and the target\x1b[201~\r")
    terminal.expect("how many steps")
    assert "teacher: the block and the target" in journal.read_text("utf-8")
    teacher.prompted()
    terminal.send("pick\x03")
    terminal.sendeof()
    terminal.expect("Shall I save it")
    teacher.prompted()
    terminal.sendeof()
    terminal.expect("resume 1")
    terminal.expect(pexpect.EOF)
    terminal.close()
    assert terminal.exitstatus == 0


def sgr(button: int, column: int, line: int, end: str) -> str:
    """Return what a terminal sends for the mouse, places counted from 1."""
    return f"\x1b[<{button};{column};{line}{end}"


def test_the_mouse_drags_the_hand_while_its_button_is_held(tmp_path: Path) -> None:
    introduced(tmp_path)
    teacher = Teacher(tmp_path, "--resume")
    terminal = teacher.terminal
    teacher.take_the_hand()
    # Where the pictures are is known once the terminal's answer has come, and so with what follows.
    teacher.press("+")
    terminal.expect("shown   larger")
    # What is shown is recorded from the first word or move on.
    teacher.press("1")
    begin = teacher.rest()
    # The pictures lie side by side below the keys; this is within the left one, from above.
    terminal.send(sgr(0, 20, 20, "M"))
    for line in (19, 18, 17):
        terminal.send(sgr(32, 20, line, "M"))
    teacher.until(lambda: teacher.hand[0] > begin[0] + 0.01)
    terminal.send(sgr(0, 20, 17, "m"))
    there = teacher.rest()
    assert there[0] > begin[0] + 0.01
    assert there[1:3] == pytest.approx(begin[1:3], abs=1e-4)
    # Without the button the pointer moves nothing; what the wheel does comes after it.
    for line in (16, 17, 18):
        terminal.send(sgr(35, 20, line, "M"))
    terminal.send(sgr(64, 20, 18, "M"))
    teacher.until(lambda: teacher.hand[2] > there[2] + 0.001)
    assert teacher.rest()[:3] - there[:3] == pytest.approx([0.0, 0.0, 0.01], abs=1e-4)
    terminal.close(force=True)
