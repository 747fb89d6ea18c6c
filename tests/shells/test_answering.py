from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from types import SimpleNamespace
from typing import cast

import pytest

from assistant.model.robot_acts import RobotAct
from assistant.session.loop import Session
from assistant.shells.answering import picture, redrawn, rendered
from tests.files.examples import lesson, task
from tests.session.lessons import Heard, hold, opened


@pytest.fixture(scope="module")
def taught(tmp_path_factory: pytest.TempPathFactory) -> Iterator[tuple[Session, Heard]]:
    heard = Heard()
    session = opened(tmp_path_factory.mktemp("home"), heard)
    hold(session)
    yield session, heard
    session.close()


@pytest.mark.parametrize(
    ("words", "seen"),
    [
        ("show me the tree", ["1.1 approach object", "2.2 place object on target"]),
        ("show the segmentation", ["votes", "at s", "approach object"]),
        ("show the trajectory", ["path from above", "height", "T"]),
        ("show the plan", ["1.  approach object", "5.  place object on target"]),
        ("show the setup", ["robot start", "block"]),
    ],
)
def test_what_is_asked_for_is_drawn(
    taught: tuple[Session, Heard], words: str, seen: list[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("NO_COLOR", "1")
    session, heard = taught
    before = len(heard.lines)
    session.hear(words)
    drawn = [picture(session, line) for line, _ in heard.lines[before:]]
    text = "\n".join(rendered(each, 70) for each in drawn if each is not None)
    assert [each for each in seen if each not in text] == []
    assert max(map(len, text.split("\n"))) <= 70


@pytest.mark.parametrize(
    ("words", "seen"),
    [
        ("rename move up object to lift", "1.3 lift"),
        ("lift is not optional", "1.3 lift (go up with the block)"),
        ("undo", "1.3 lift (go up with the block) (optional)"),
        ("undo", "1.3 move up object"),
    ],
)
def test_the_plan_is_drawn_after_each_change_of_it(
    taught: tuple[Session, Heard], words: str, seen: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("NO_COLOR", "1")
    session, heard = taught
    before = len(heard.lines)
    session.hear(words)
    drawn = [redrawn(session, line) for line, _ in heard.lines[before:]]
    texts = [rendered(each, 70) for each in drawn if each is not None]
    assert len(texts) == 1
    assert seen in texts[0]


def test_how_the_cuts_were_found_is_drawn_only_for_who_asks(
    taught: tuple[Session, Heard], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("NO_COLOR", "1")
    session, _ = taught
    line = RobotAct("told", "episodes")
    short, full = (picture(session, line, asked=one) for one in ("show me", "show the votes"))
    assert short is not None
    assert full is not None
    few, many = (rendered(one, 70).split("\n") for one in (short, full))
    assert len(few) < 12 < len(many)
    assert "show the votes" in few[-1]
    assert not any("eliminated" in one for one in few)


def test_other_changes_draw_no_plan(taught: tuple[Session, Heard]) -> None:
    session, _ = taught
    assert redrawn(session, RobotAct("done", "undone", slots={"what": "correction"})) is None
    assert redrawn(session, RobotAct("done", "run")) is None


def test_other_lines_are_sentences(taught: tuple[Session, Heard]) -> None:
    session, _ = taught
    assert picture(session, RobotAct("ask", "goal", "goal")) is None
    assert picture(session, RobotAct("told", "brief")) is None


def test_before_anything_was_shown_there_is_nothing_to_draw(tmp_path: Path) -> None:
    session = opened(tmp_path)
    assert picture(session, RobotAct("told", "trajectory")) is None
    session.close()


ENGLISH = (
    *("votes", "cuts", "confidence", "kind", "eliminated", "gripper", "speed", "cue", "jolt"),
    *("episodes", "primitive", "sure", "forward", "down", "right", "optional", "move", "close"),
    *("scene", "robot start", "told of", "hand ", "body", "ahead", "height", "place "),
)


@pytest.mark.parametrize("topic", ["tree", "episodes", "trajectory", "setup"])
def test_in_german_nothing_drawn_is_in_english(
    taught: tuple[Session, Heard], topic: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("NO_COLOR", "1")
    session, _ = taught
    told = cast(
        Session,
        SimpleNamespace(dialogue=session.dialogue, language="german", phrased=session.phrased),
    )
    drawn = picture(told, RobotAct("told", topic))
    assert drawn is not None
    text = rendered(drawn, 90)
    # What the teacher called things stays as it was said.
    for name in (
        *session.dialogue_view["primitives"],
        "pick up object",
        "place object",
        "the block rests on the target",
    ):
        text = text.replace(name, "")
    assert [one for one in ENGLISH if one in text] == []


def _german(topic: str) -> str:
    """Return what a German session draws when it is asked about a task with all there is."""
    told = task(lesson())
    known = SimpleNamespace(task=told, lesson=told.learned, setup=SimpleNamespace(places={}))
    session = SimpleNamespace(language="german", dialogue=SimpleNamespace(known=known))
    drawn = picture(cast("Session", session), RobotAct("told", topic=topic))
    assert drawn is not None
    return rendered(drawn, 100)


@pytest.mark.parametrize(
    ("topic", "seen", "unseen"),
    [
        ("tree", ["bis: ", "vorher: die Hand ist offen", "(darf wegfallen)"], ["until", "before"]),
        ("episodes", ["Abschnitte", "1,25", "nach unten"], ["1.25", "down", "votes", "cuts"]),
        ("trajectory", ["Weg von oben", "0,0"], ["path", "height", "0.0"]),
    ],
)
def test_a_german_session_draws_german(
    topic: str, seen: list[str], unseen: list[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("NO_COLOR", "1")
    text = _german(topic)
    assert [each for each in seen if each not in text] == []
    assert [each for each in unseen if each in text] == []
