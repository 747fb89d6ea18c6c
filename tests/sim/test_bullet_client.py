"""The physics library says nothing of itself; what goes wrong is still told."""

from __future__ import annotations

import subprocess
import sys


def said(code: str) -> tuple[str, str]:
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    return done.stdout, done.stderr


def test_a_connection_is_made_and_left_in_silence() -> None:
    assert said("from sim.bullet_client import Client; Client().close()") == ("", "")


def test_what_is_told_of_an_error_is_passed_on_but_not_the_greeting() -> None:
    code = """
import os
from sim import bullet_client
with bullet_client._quiet():
    os.write(1, b"chatter\\n")
    os.write(2, b"pybullet build time: today\\ncannot open the display\\n")
os.write(1, b"an answer\\n")
"""
    assert said(code) == ("an answer\n", "cannot open the display\n")
