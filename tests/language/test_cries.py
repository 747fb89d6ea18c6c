import pytest

from assistant.language.understanding import understand
from assistant.model.listening import Listening
from assistant.model.teacher_acts import Stop


def stops(text: str) -> bool:
    meant = understand(text, Listening(stage="practice"))
    return meant.acts == (Stop(),) and meant.confidence >= 0.85


@pytest.mark.parametrize(
    "text",
    ["oi! stoop stop it", "abeg stop am", "stop o", "stop o! stop now",
     "aaah stop that you will crush it", "haw! stoap", "stahp it man",
     "gosh stop it, it will tip", "stop am abeg",
     "sotp it right now", "hoy stop that this instant you oaf", "quick stop the gripper",
     "stop moving your arm"],
)  # fmt: skip
def test_a_stop_among_calls_is_a_stop(text: str) -> None:
    assert stops(text)


@pytest.mark.parametrize(
    "text",
    ["my tram stop is round the corner", "stop by on Sunday",
     "whoa there, far too quick, slow down",
     "the dough won't stop rising",
     "stop the press was his motto", "non stop"],
)  # fmt: skip
def test_other_talk_of_stops_is_none(text: str) -> None:
    assert not stops(text)
