"""How a task is shown is said in a line; keys may be recorded as rarely as in the paper."""

from __future__ import annotations

from pathlib import Path
from types import SimpleNamespace
from typing import cast

import numpy as np
import pytest

from assistant.errors import BadInput
from assistant.files.recordings import read_recording
from assistant.ports import HandSample
from assistant.session.loop import Session
from assistant.shells.due import Begun, Due
from assistant.shells.showing import Showing, told_problem

WATCHING = cast(Session, SimpleNamespace(watching=object(), language="english"))
AT_REST = cast(Session, SimpleNamespace(watching=None, language="english"))


HEADER = "t_s,x_m,y_m,z_m,qx,qy,qz,qw"


def nowhere(line: str) -> None:
    raise AssertionError(line)


@pytest.mark.parametrize(
    ("line", "every_s"),
    [("keys", 0.02), ("Keys 0.5", 0.5), ("keys .5 s", 0.5), ("keys 9", 1.0), ("keys 0", 0.02)],
)
def test_keys_may_say_how_often_to_record(line: str, every_s: float) -> None:
    assert Showing(nowhere, keys=True).by_keys(WATCHING, line) == every_s


@pytest.mark.parametrize("line", ["the key ring", "keyss", "keys left", ""])
def test_other_lines_ask_for_no_keys(line: str) -> None:
    assert Showing(nowhere, keys=True).by_keys(WATCHING, line) is None


def test_without_keys_or_outside_a_demonstration_there_are_none() -> None:
    assert Showing(nowhere, keys=False).by_keys(WATCHING, "keys") is None
    assert Showing(nowhere, keys=True).by_keys(AT_REST, "keys") is None


def test_samples_are_recorded_when_due_and_whenever_something_is_said() -> None:
    due = Due(0.5)
    said = {0.62: "then"}
    samples = [
        HandSample(t_s, np.zeros(7), 0.08, said.get(t_s, ""))
        for t_s in (round(0.02 * k, 2) for k in range(100))
    ]
    assert [sample.t_s for sample in samples if due(sample)] == [0.0, 0.5, 0.62, 1.12, 1.62]


@pytest.mark.parametrize("said", ["", "first step"])
def test_nothing_is_recorded_before_the_teacher_does_or_says_something(said: str) -> None:
    begun = Begun()
    assert begun(HandSample(30.0, np.zeros(7), 0.08)) is None
    if not said:
        begun.begin()
    first = begun(HandSample(30.02, np.zeros(7), 0.08, said))
    then = begun(HandSample(30.04, np.zeros(7), 0.08))
    assert first is not None
    assert then is not None
    assert (first.t_s, first.said) == (0.0, said)
    assert then.t_s == pytest.approx(0.02)


@pytest.mark.parametrize(
    ("text", "told"),
    [
        (None, "diese Datei gibt es nicht; prüfe Namen und Ordner"),
        ("", "die Datei ist leer; beginne sie mit t_s,"),
        (f"{HEADER}\n", "unter der Kopfzeile stehen keine Messwerte; eine Zeile je Messwert"),
        (f"{HEADER}\n0,0,0,0,0,0,0,1\n1,999,0,0,0,0,0,1\n", "die Hand ist mehr als"),
        (f"{HEADER}\n1,0,0,0,0,0,0,1\n0,0,0,0,0,0,0,1\n", "die Zeit läuft rückwärts; t_s darf"),
    ],
)
def test_what_is_wrong_with_a_file_is_told_in_german(
    tmp_path: Path, text: str | None, told: str
) -> None:
    file = tmp_path / "shown.csv"
    if text is not None:
        file.write_text(text)
    with pytest.raises(BadInput) as wrong:
        read_recording(file)
    problem = wrong.value.problems[0]
    assert told in told_problem(problem, "german")
    assert told_problem(problem, "english") == str(problem)
