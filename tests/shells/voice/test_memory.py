"""Large buffers do not stay when they are done with."""

from __future__ import annotations

import gc
import sys
from pathlib import Path

import numpy as np
import pytest

from assistant.shells.voice.memory import give_back, keep_small


def resident_mb() -> float:
    return int(Path("/proc/self/statm").read_text("ascii").split()[1]) * 4096 / 2**20


@pytest.mark.skipif(sys.platform != "linux", reason="reads /proc")
def test_what_is_done_with_is_given_back() -> None:
    keep_small()
    # What others left free would take up the buffers without anything being seen of it.
    give_back()
    before_mb = resident_mb()
    buffers = [np.ones(2**17) for _ in range(50)]
    assert resident_mb() > before_mb + 40
    buffers.clear()
    gc.collect()
    give_back()
    assert resident_mb() < before_mb + 10
