"""Large buffers do not stay when they are done with."""

from __future__ import annotations

import subprocess
import sys

import pytest

SCRIPT = """
from pathlib import Path
import numpy as np
from assistant.shells.voice.memory import give_back, keep_small

def resident_mb():
    return int(Path("/proc/self/statm").read_text("ascii").split()[1]) * 4096 / 2**20

keep_small()
begun = resident_mb()
buffers = [np.ones(2**17) for _ in range(50)]
full = resident_mb()
buffers.clear()
give_back()
print(begun, full, resident_mb())
"""
"""In a process of its own: what other tests left free would take the buffers up, or give back."""


@pytest.mark.skipif(sys.platform != "linux", reason="reads /proc")
def test_what_is_done_with_is_given_back() -> None:
    ran = subprocess.run(
        [sys.executable, "-c", SCRIPT], capture_output=True, text=True, check=True, timeout=60
    )
    begun_mb, full_mb, left_mb = map(float, ran.stdout.split())
    assert full_mb > begun_mb + 40
    assert left_mb < begun_mb + 10
