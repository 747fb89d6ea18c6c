"""The physics library says nothing on stdout, where programs read answers."""

from __future__ import annotations

import subprocess
import sys


def test_nothing_is_written_to_stdout() -> None:
    code = "from sim.bullet_client import Client; Client().close()"
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert done.stdout == ""
