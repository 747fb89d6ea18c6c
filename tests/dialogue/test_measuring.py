"""What a run is told by once it is over."""

from __future__ import annotations

from dataclasses import asdict

import pytest

from assistant.dialogue import events as ev
from assistant.dialogue.measuring import result_slots
from assistant.language.speech import phrase
from assistant.model.motion import Alignment, ArmReport, Measure
from assistant.model.robot_acts import RobotAct
from tests.dialogue.teaching import Lessons

DEEP = Measure("depth", "peg", "socket", 50.0, "mm", True)
SHALLOW = Measure("depth", "peg", "socket", 21.04, "mm", False)
AT_LINE = Measure("edge", "box", "line", 0.21, "mm", True)
WIPED = Measure("covered", "sponge", "board", 100.0, "%", True)
ALL_IN = Measure("inside", "cup", "bowl", 100.0, "%", True)
MOST_IN = Measure("inside", "cup", "bowl", 80.0, "%", False)
NONE_IN = Measure("inside", "cup", "bowl", 0.0, "%", False)


def told(*measures: Measure, language: str = "english") -> str:
    return phrase(RobotAct("done", "run", slots=result_slots((), measures)), language)


@pytest.mark.parametrize(
    ("measure", "english", "german"),
    [
        (
            DEEP,
            "Done. The peg is 50.0 mm deep in the socket.",
            "Erledigt. „Stift“ steckt 50,0 mm tief in „Fassung“.",
        ),
        (
            SHALLOW,
            "Done. The peg is 21.0 mm deep in the socket. That is not deep enough.",
            "Erledigt. „Stift“ steckt 21,0 mm tief in „Fassung“. Das ist nicht tief genug.",
        ),
        (
            AT_LINE,
            "Done. The edge of the box is 0.2 mm from the line.",
            "Erledigt. Die Kante von „Kiste“ ist 0,2 mm von „Linie“ entfernt.",
        ),
        (
            WIPED,
            "Done. The sponge covered 100 % of the board.",
            "Erledigt. „Schwamm“ hat 100 % von „Tafel“ überstrichen.",
        ),
        (
            ALL_IN,
            "Done. All balls are in the bowl.",
            "Erledigt. In „Schale“ liegen alle Kugeln.",
        ),
        (
            MOST_IN,
            "Done. 80 % of the balls are in the bowl. That is not enough.",
            "Erledigt. In „Schale“ liegen 80 % der Kugeln. Das ist nicht genug.",
        ),
        (
            NONE_IN,
            "Done. 0 % of the balls are in the bowl. That is not enough.",
            "Erledigt. In „Schale“ liegen 0 % der Kugeln. Das ist nicht genug.",
        ),
    ],
    ids=lambda value: value.kind if isinstance(value, Measure) else "",
)
def test_each_measure_is_told_in_its_own_words(measure: Measure, english: str, german: str) -> None:
    assert told(measure) == english
    assert told(measure, language="german") == german


@pytest.mark.parametrize("measure", [DEEP, SHALLOW, AT_LINE, WIPED, ALL_IN, MOST_IN, NONE_IN])
def test_the_slots_are_the_measure_s_own(measure: Measure) -> None:
    slots = result_slots((), (measure,))
    fields = asdict(measure)
    assert slots["measures"] == [fields]
    del fields["kind"]
    assert {key: slots[key] for key in fields} == fields


def test_what_was_not_good_enough_is_told_before_what_was() -> None:
    slots = result_slots((), (DEEP, MOST_IN, AT_LINE))
    assert (slots["object"], slots["good"]) == ("cup", False)
    assert [one["kind"] for one in slots["measures"]] == ["depth", "inside", "edge"]
    assert "balls" in told(DEEP, MOST_IN)
    assert "peg" in told(DEEP, AT_LINE)


def test_without_measures_only_what_lies_somewhere_is_told() -> None:
    slots = result_slots((Alignment("block", "target", 0.04, 0.02),), ())
    assert set(slots) == {"alignments"}
    assert phrase(RobotAct("done", "run", slots=slots)) == (
        "Done. The block is 0.04 mm and 0.02 degrees off its place on the target."
    )


def test_the_end_of_a_run_tells_its_measures() -> None:
    teacher = Lessons().ready().moving()
    teacher.happen(ev.ArmReported(ArmReport("finished", 9.0, 4, measures=(SHALLOW,))))
    done = teacher.lines[0]
    assert (done.act, done.topic) == ("done", "run")
    assert {key: done.slots[key] for key in ("object", "target", "value", "unit", "good")} == {
        "object": "peg",
        "target": "socket",
        "value": 21.04,
        "unit": "mm",
        "good": False,
    }
