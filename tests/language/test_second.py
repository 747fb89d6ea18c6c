"""The second reading of a sentence is another one than the first, or none."""

from __future__ import annotations

import pytest

from assistant.language.second import second_reading
from assistant.language.understanding import understand
from assistant.model.listening import Listening
from assistant.model.teacher_acts import Unknown

PRACTICE = Listening("practice", "satisfied", objects=("block", "target"), subtasks=("lift it",))


@pytest.mark.parametrize("text", ["lower it", "right", "a bit more up", "carry on", ""])
def test_the_second_reading_is_never_the_first(text: str) -> None:
    first = understand(text, PRACTICE).acts
    second = second_reading(text, PRACTICE, first)
    assert second != first
    assert second is None or not isinstance(second[0], Unknown)
