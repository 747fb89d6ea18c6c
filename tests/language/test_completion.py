import pytest

from assistant.language.completion import suggestions
from assistant.language.understanding import understand
from assistant.model.listening import Listening
from assistant.model.teacher_acts import ASKED, STAGES, Asked, Stage, Unknown


@pytest.mark.parametrize(
    ("stage", "asked"), [*((stage, None) for stage in STAGES), *(("learning", a) for a in ASKED)]
)
def test_every_suggestion_is_understood_where_it_is_offered(
    stage: Stage, asked: Asked | None
) -> None:
    listening = Listening(
        stage=stage, asked=asked, objects=("block", "target"), subtasks=("lift", "place object")
    )
    for line in suggestions(listening):
        if not line.endswith(" to"):
            meant = understand(line, listening)
            assert not isinstance(meant.acts[0], Unknown), line


def test_suggestions_hold_the_tasks_own_names() -> None:
    lines = suggestions(Listening(stage="introduction", subtasks=("wipe table",)))
    assert "you can skip wipe table" in lines
