from __future__ import annotations

import os
import resource
from pathlib import Path

import pytest

from assistant.errors import BadInput, WorkFailed
from assistant.files.transcripts import read_transcript
from assistant.model.transcript import Happened, Note, RobotLine, TeacherLine, Transcript
from assistant.session.journal import Journal
from assistant.session.past import newest_session, past_sessions
from tests.session.lessons import Heard, lesson, opened

HEAD = Transcript("a lesson", arm="kinematic")
STEPS = (
    RobotLine(act="greet", topic="hello", words="Hello."),
    TeacherLine("it's called: pick & place - 'quoted' \"twice\""),
    TeacherLine("then", at_s=1.25, by_voice=0.9),
    Happened({"arm": {"kind": "finished", "at_s": 3.2, "alignments": [{"object": "block"}]}}),
    Note("a remark"),
)


def written(folder: Path, count: int = len(STEPS)) -> Journal:
    folder.mkdir(parents=True)
    journal = Journal(folder)
    journal.create(HEAD)
    for step in STEPS[:count]:
        journal.write(step)
    return journal


def test_what_is_written_is_read_back(tmp_path: Path) -> None:
    written(tmp_path / "1").close()
    again = Journal(tmp_path / "1")
    assert again.resume().steps == STEPS
    again.close()


def test_a_journal_cut_anywhere_keeps_every_whole_step(tmp_path: Path) -> None:
    written(tmp_path / "1").close()
    whole = (tmp_path / "1" / "journal.yaml").read_bytes()
    head = whole.index(b"  - ")
    least = 0
    for end in range(head + 8, len(whole) + 1, 7):
        (tmp_path / "1" / "journal.yaml").write_bytes(whole[:end])
        journal = Journal(tmp_path / "1")
        steps = journal.resume().steps
        assert steps == STEPS[: len(steps)]
        assert len(steps) >= least
        least = len(steps)
        journal.write(Note("on we go"))
        journal.close()
        again = Journal(tmp_path / "1")
        assert again.resume().steps == (*steps, Note("on we go"))
        again.close()


def test_two_sessions_on_one_journal_are_refused(tmp_path: Path) -> None:
    journal = written(tmp_path / "1")
    with pytest.raises(WorkFailed, match="session 1 is open in another program"):
        Journal(tmp_path / "1").resume()
    journal.close()
    again = Journal(tmp_path / "1")
    again.resume()
    again.close()


def test_a_disk_that_fails_ends_the_writing_and_not_the_session(tmp_path: Path) -> None:
    journal = written(tmp_path / "1", 2)
    journal.path.unlink()
    journal.path.mkdir()
    journal.write(STEPS[2])
    assert "journal.yaml" in journal.trouble
    trouble = journal.trouble
    journal.write(STEPS[3])
    assert journal.trouble == trouble
    journal.close()


def test_a_folder_that_refuses_is_told_with_its_place_and_what_would_be_right(
    tmp_path: Path,
) -> None:
    journal = Journal(tmp_path)
    journal.fail(OSError(30, "Read-only file system", "/mnt/sessions/3"))
    assert journal.trouble == (
        "/mnt/sessions/3: Read-only file system; name a folder you may write in, with room left"
    )


def test_no_such_session_is_told(tmp_path: Path) -> None:
    with pytest.raises(BadInput, match="no such session"):
        Journal(tmp_path / "7").resume()
    with pytest.raises(BadInput, match="no session yet"):
        newest_session(tmp_path)


def test_past_sessions_tell_where_they_stand(tmp_path: Path) -> None:
    written(tmp_path / "1").close()
    written(tmp_path / "2", 1).close()
    (tmp_path / "3").mkdir()
    (tmp_path / "3" / "journal.yaml").write_text("format: transcript/9\n")
    by_name = {past.name: past for past in past_sessions(tmp_path)}
    assert by_name["1"].lines == 2
    assert by_name["1"].last == "Hello."
    assert by_name["2"].lines == 0
    assert "transcript/1" in by_name["3"].trouble


def test_a_disk_that_fills_up_is_told_once_and_the_lesson_goes_on(tmp_path: Path) -> None:
    child = os.fork()
    if child == 0:
        # Python is told of a file that grows too large by an error, as of a full disk.
        resource.setrlimit(resource.RLIMIT_FSIZE, (8_000, 8_000))
        os._exit(0 if told_once_and_went_on(tmp_path) else 1)
    _, status = os.waitpid(child, 0)
    assert os.waitstatus_to_exitcode(status) == 0
    assert read_transcript(tmp_path / "sessions" / "1" / "journal.yaml", resume=True).steps


def told_once_and_went_on(home: Path) -> bool:
    heard = Heard()
    for _ in lesson(opened(home, heard)):
        if "done.run" in heard.topics:
            return heard.topics.count("error.not_kept") == 1
    return False
