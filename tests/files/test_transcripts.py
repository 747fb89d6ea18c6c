"""Transcripts: plays that are read with their lines, and journals a crash cannot spoil."""

from __future__ import annotations

import errno
import os
from pathlib import Path

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from assistant.errors import BadInput
from assistant.files.transcripts import (
    append_step,
    begin_journal,
    mend_transcript,
    read_transcript,
    transcript_text,
    write_transcript,
)
from assistant.model.robot_acts import About
from assistant.model.setup import Setup
from assistant.model.transcript import (
    Demonstrate,
    Expect,
    Happened,
    Near,
    Note,
    Restart,
    RobotLine,
    SetupChoice,
    SetupStep,
    Step,
    TeacherLine,
    Transcript,
    Wait,
)
from tests.files.examples import setups, spoken, words

PLAY = """\
format: transcript/1
title: a lesson
setup: table1_1
arm: pybullet
task: mine.yaml
language: german
steps:
  - note: the beginning
  - teacher: yes
  - teacher: {says: two, heard: too, at_s: 1.5}
  - robot: {act: ask, asked: task_name}
  - robot*: {}
  - robot?: /hel+o/
  - robot: Hello, you.
  - robot+: {act: report, about: pick up, slots: {n: {near: 1, within: 0.5}}}
  - robot: {act: announce, about: {name: grasp, index: [1, 2]}, words: /grasp/}
  - wait: rest
  - wait: 2.5
  - demonstrate: {hand: scripted, seed: 3, cues: auto}
  - demonstrate: {recording: a.csv, cues: [{at_s: 6.5, say: first step}]}
  - setup: {file: odd name}
  - setup: other.yaml
  - expect: {stage: practice, alignment.0.distance_mm: {near: 0, within: 1}}
  - restart: {}
  - happened: {learned: {a: 1.5, b: [1, 2]}}
"""

plain = st.recursive(
    st.one_of(words, st.integers(-9, 9), st.floats(-5, 5), st.booleans(), st.none()),
    lambda inner: st.one_of(st.lists(inner, max_size=3), st.dictionaries(words, inner, max_size=3)),
    max_leaves=12,
)
near = st.builds(Near, st.floats(-5, 5), st.floats(0, 5))
told = st.dictionaries(words, st.one_of(plain, near), max_size=3)
ENDS = st.sampled_from(["", ".yaml", ".yml", ".json", "/of", ".csv"])
choices = st.one_of(
    st.builds(lambda stem, end: SetupChoice(file=f"{stem}{end}"), words, ENDS),
    st.builds(lambda stem, end: SetupChoice(name=f"{stem}{end}"), words, ENDS),
    st.builds(lambda setup: SetupChoice(setup=setup), setups),
)
cues = st.lists(spoken, max_size=3).map(tuple)
steps: st.SearchStrategy[Step] = st.one_of(
    st.builds(Note, st.text(max_size=20)),
    st.builds(TeacherLine, st.text(max_size=20), st.none() | words, st.none() | st.floats(0, 99)),
    st.builds(
        RobotLine,
        st.sampled_from(["one", "maybe", "any", "some"]),
        st.sampled_from([None, "ask", "report"]),
        st.sampled_from([None, "ready", "goal"]),
        st.none() | words,
        told,
        st.none() | words | st.builds(About, words, st.lists(st.integers(1, 9)).map(tuple)),
        st.none() | words,
    ),
    st.builds(
        RobotLine,
        pattern=words.map(lambda text: f"{text.replace('*', '')[:3]}x").filter(
            lambda text: not set(text) & set("[]{}()*?+|\\")
        ),
    ),
    st.builds(Wait, st.none() | st.floats(0, 99)),
    st.builds(Demonstrate, words, st.just(0), cues, cues),
    st.builds(Demonstrate, st.none(), st.integers(0, 9), st.none() | cues, cues),
    st.builds(SetupStep, choices),
    st.builds(Expect, told),
    st.just(Restart()),
    st.builds(Happened, st.dictionaries(words, plain, min_size=1, max_size=3)),
)


def written(tmp_path: Path, text: str) -> Path:
    path = tmp_path / "play.yaml"
    path.write_text(text)
    return path


def test_a_play_is_read_as_typed_steps_with_their_lines(tmp_path: Path) -> None:
    play = read_transcript(written(tmp_path, PLAY))
    assert (play.title, play.arm, play.task, play.language) == (
        "a lesson",
        "pybullet",
        "mine.yaml",
        "german",
    )
    assert play.setup == SetupChoice(name="table1_1")
    assert [step.line for step in play.steps] == list(range(8, 26))
    assert play.steps[1] == TeacherLine("yes")
    assert play.steps[2] == TeacherLine("two", "too", 1.5)
    assert [line.text for line in play.steps[1:3] if isinstance(line, TeacherLine)] == [
        "yes",
        "too",
    ]
    assert play.steps[4] == RobotLine("any")
    assert play.steps[5] == RobotLine("maybe", pattern="hel+o")
    assert play.steps[6] == RobotLine(words="Hello, you.")
    assert play.steps[7] == RobotLine(
        "some", act="report", about="pick up", slots={"n": Near(1, 0.5)}
    )
    assert play.steps[8] == RobotLine(act="announce", about=About("grasp", (1, 2)), pattern="grasp")
    assert play.steps[9:11] == (Wait(None), Wait(2.5))
    assert play.steps[11] == Demonstrate(None, 3, None)
    assert play.steps[13] == SetupStep(SetupChoice(file="odd name"))


def test_a_play_written_again_is_the_same_text(tmp_path: Path) -> None:
    assert transcript_text(read_transcript(written(tmp_path, PLAY))) == PLAY


@settings(max_examples=60, deadline=None)
@given(st.lists(steps, max_size=6))
def test_all_steps_come_back(tmp_path_factory: pytest.TempPathFactory, some: list[Step]) -> None:
    path = tmp_path_factory.mktemp("t") / "t.yaml"
    play = Transcript('it\'s: a "play"', tuple(some), SetupChoice(setup=Setup()), "pybullet")
    write_transcript(play, path)
    assert read_transcript(path) == play


@pytest.mark.parametrize(
    ("old", "new", "line", "told"),
    [
        ("- teacher: yes", "- techer: yes", 9, "one of note, teacher, robot, robot?"),
        ("- teacher: yes", "- yes", 9, "one of note, teacher"),
        ("- teacher: yes", "- {teacher: yes, wait: 1}", 9, "unknown key 'wait'"),
        ("- teacher: yes", "- teacher: 3", 9, "3 is not a text or a mapping; put it in quotes"),
        ("says: two", "say: two", 10, "unknown key 'say'; did you mean 'says'?"),
        ("asked: task_name", "asked: taskname", 11, "'taskname' is not known here"),
        ("robot*: {}", "robot*: {akt: ask}", 12, "did you mean 'act'?"),
        ("/hel+o/", "/hel(+o/", 13, "bad /pattern/"),
        ("wait: rest", "wait: soon", 17, "one of rest"),
        ("wait: 2.5", "wait: -1", 18, "-1 is out of range; at least 0"),
        ("hand: scripted, seed: 3", "seed: 3", 19, "either recording: FILE.csv or hand: scripted"),
        ("recording: a.csv", "recording: a.csv, seed: 1", 20, "seed and cues: auto go with"),
        ("at_s: 6.5", "at_s: six", 20, "'six' is not a number"),
        ("{file: odd name}", "{file: odd, name: other}", 21, "file: stands alone"),
        ("arm: pybullet", "arm: real", 4, "one of pybullet, kinematic"),
    ],
)
def test_mistakes_are_told_with_their_line(
    tmp_path: Path, old: str, new: str, line: int, told: str
) -> None:
    assert old in PLAY
    path = written(tmp_path, PLAY.replace(old, new, 1))
    with pytest.raises(BadInput) as caught:
        read_transcript(path)
    assert told in str(caught.value)
    assert caught.value.problems[0].where == f"{path}:{line}"


@settings(max_examples=15, deadline=None)
@given(st.lists(steps, min_size=1, max_size=4), st.data())
def test_a_journal_killed_at_any_instant_goes_on(
    tmp_path_factory: pytest.TempPathFactory, some: list[Step], data: st.DataObject
) -> None:
    path = tmp_path_factory.mktemp("j") / "j.yaml"
    begin_journal(Transcript("journal"), path)
    sizes = [path.stat().st_size]
    for step in some:
        append_step(path, step)
        sizes.append(path.stat().st_size)
    assert read_transcript(path).steps == tuple(some)
    cut = data.draw(st.integers(sizes[0], sizes[-1]))
    os.truncate(path, cut)
    whole = sum(size <= cut for size in sizes[1:])
    # All but the blank line that ends a longer step may be there: then the step is dropped too.
    assert read_transcript(path, resume=True).steps == tuple(some[:whole])
    lost = mend_transcript(path)
    assert len(lost.encode()) <= cut - sizes[whole] + 3
    append_step(path, Note("on we go"))
    assert read_transcript(path).steps == (*some[:whole], Note("on we go"))


def test_zeros_left_by_a_power_cut_are_cut_off(tmp_path: Path) -> None:
    path = tmp_path / "j.yaml"
    begin_journal(Transcript("journal", (Note("one"),)), path)
    with path.open("ab") as file:
        file.write(b"\x00" * 50)
    assert read_transcript(path, resume=True).steps == (Note("one"),)
    mend_transcript(path)
    assert read_transcript(path).steps == (Note("one"),)


def test_only_resuming_tolerates_a_torn_step(tmp_path: Path) -> None:
    path = tmp_path / "j.yaml"
    begin_journal(Transcript("journal", (Note("one"),)), path)
    with path.open("a") as file:
        file.write("  - teacher: {says: he")
    with pytest.raises(BadInput, match="close the bracket"):
        read_transcript(path)
    assert read_transcript(path, resume=True).steps == (Note("one"),)
    assert mend_transcript(path) == "  - teacher: {says: he"
    assert mend_transcript(path) == ""


def test_a_journal_is_never_begun_over_another(tmp_path: Path) -> None:
    begin_journal(Transcript("one"), tmp_path / "j.yaml")
    with pytest.raises(BadInput, match="a journal of this name exists"):
        begin_journal(Transcript("two"), tmp_path / "j.yaml")
    with pytest.raises(BadInput, match="its folder does not exist"):
        begin_journal(Transcript("two"), tmp_path / "none" / "j.yaml")


def test_a_full_disk_leaves_no_half_step(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    path = tmp_path / "j.yaml"
    begin_journal(Transcript("journal", (Note("one"),)), path)
    before = path.read_bytes()

    def full(handle: int) -> None:
        raise OSError(errno.ENOSPC, "No space left on device")

    monkeypatch.setattr(os, "fsync", full)
    with pytest.raises(BadInput, match=r"cannot be written \(No space left on device\)"):
        append_step(path, Note("two"))
    assert path.read_bytes() == before


def test_a_full_disk_leaves_no_journal_without_a_head(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    def full(handle: int) -> None:
        raise OSError(errno.ENOSPC, "No space left on device")

    monkeypatch.setattr(os, "fsync", full)
    with pytest.raises(BadInput, match=r"cannot be written \(No space left on device\)"):
        begin_journal(Transcript("journal"), tmp_path / "j.yaml")
    assert list(tmp_path.iterdir()) == []


def test_a_journal_may_have_any_title(tmp_path: Path) -> None:
    path = tmp_path / "j.yaml"
    begin_journal(Transcript("steps: []"), path)
    append_step(path, Note("one"))
    assert read_transcript(path).title == "steps: []"
    assert read_transcript(path).steps == (Note("one"),)
