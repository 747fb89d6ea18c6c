import pytest

from assistant.language.looks import Candidate
from assistant.language.partial import unpartial
from assistant.language.understanding import understand
from assistant.model.listening import Listening
from assistant.model.teacher_acts import Again, Deny, Quit, Save, TeacherAct, Translate, Undo

SAVED = Candidate((Save("probe"),))
GONE = Candidate((Quit(),))
MOVED = Candidate((Translate("left"),))


def _cut(*acts: TeacherAct, least: float = -0.01) -> Candidate:
    return Candidate(acts, {"cut_least": least})


def test_a_part_of_a_line_surely_cut_is_dropped() -> None:
    both = _cut(Save("probe"), Quit())
    assert unpartial([SAVED, GONE, MOVED, both]) == [MOVED, both]


def test_a_doubtful_cut_drops_nothing() -> None:
    pool = [SAVED, GONE, _cut(Save("probe"), Quit(), least=-0.2)]
    assert unpartial(pool) == pool


def test_an_answer_before_a_change_drops_nothing() -> None:
    pool = [SAVED, _cut(Deny(), Save("probe"))]
    assert unpartial(pool) == pool


@pytest.mark.parametrize(
    ("language", "text", "acts"),
    [
        ("german", "speicher das als Probe und dann tschüss", (Save("Probe"), Quit())),
        ("german", "rückgängig, und dann nochmal", (Undo(), Again())),
        ("english", "Save it, then close out the session.", (Save(), Quit())),
    ],
)
def test_two_plain_things_are_both_done(
    language: str, text: str, acts: tuple[TeacherAct, ...]
) -> None:
    assert understand(text, Listening(stage="practice"), language).acts == acts
