from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import pytest

from assistant.session.loop import Session
from tests.session.lessons import Heard, opened, until_it_moves


@pytest.fixture
def moving(tmp_path: Path) -> Iterator[tuple[Session, Heard]]:
    """A session whose arm is on its way to the block."""
    heard = Heard()
    session = opened(tmp_path, heard)
    until_it_moves(session)
    session.run_until(3.0)
    yield session, heard
    session.close()
