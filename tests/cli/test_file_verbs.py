"""The verbs about files: check, show, convert and tasks, as a person at a shell meets them."""

from __future__ import annotations

import json
from dataclasses import replace
from pathlib import Path

import pytest

from assistant.cli import main
from assistant.files.demonstrations import write_demonstration
from assistant.files.library import library
from assistant.files.recordings import write_recording
from assistant.files.scenes import write_scene
from assistant.files.setups import write_setups
from assistant.files.shipped import shipped
from assistant.files.tasks import write_task
from assistant.files.transcripts import write_transcript
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
    TeacherLine,
    Transcript,
    Wait,
)
from tests.files import examples

PLAY = Transcript(
    "first lesson",
    (
        Note("so it begins"),
        TeacherLine("two", "too", 1.5),
        RobotLine("some", "ask", "goal", about="grasp", slots={"n": Near(1, 0.5)}),
        RobotLine(words="Hello."),
        RobotLine("any"),
        RobotLine("maybe", pattern="h.llo"),
        Wait(None),
        Wait(2.0),
        Demonstrate(seed=3),
        SetupStep(SetupChoice(name="table1_1")),
        Expect({"stage": "practice"}),
        Restart(),
        Happened({"learned": {}}),
    ),
    SetupChoice(setup=Setup("mine")),
)


@pytest.fixture(autouse=True)
def _home(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("ASSISTANT_HOME", str(tmp_path / "home"))
    monkeypatch.setenv("COLUMNS", "120")
    monkeypatch.chdir(tmp_path)


def run(capsys: pytest.CaptureFixture[str], *words: str) -> tuple[int, str, str]:
    """Run a verb and return its status, what it printed, and what it complained about."""
    status = main(words)
    told = capsys.readouterr()
    return status, told.out, told.err


def test_check_tells_every_problem_of_every_file(capsys: pytest.CaptureFixture[str]) -> None:
    Path("bad.yaml").write_text("format: task/1\nname: 7\ntree: {subtask: a, part: []}\n")
    good = str(shipped("tasks") / "pick_and_place.yaml")
    status, out, err = run(capsys, "check", "bad.yaml", good, "none.yaml")
    assert status == 2
    assert out == f"{good}: a good task\n"
    assert "bad.yaml:2: name: 7 is not a text; put it in quotes" in err
    assert "bad.yaml:3: unknown key 'part'; did you mean 'parts'?" in err
    assert "none.yaml: no such file" in err


def test_check_warns_of_what_is_odd_and_is_content(capsys: pytest.CaptureFixture[str]) -> None:
    write_recording(examples.recording(gripper=False), Path("r.csv"))
    status, out, err = run(capsys, "check", "r.csv")
    assert (status, out) == (0, "r.csv: a good recording\n")
    assert err.startswith("warning: r.csv: there is no column gripper_m")


def test_check_tells_programs_too(capsys: pytest.CaptureFixture[str]) -> None:
    Path("bad.yaml").write_text("x: 1\n")
    status, out, _ = run(capsys, "check", "--json", "bad.yaml")
    (told,) = json.loads(out)["files"]
    assert status == 2
    assert told["problems"][0]["where"] == "bad.yaml:1"


def test_check_takes_folders_and_gives_schemas(capsys: pytest.CaptureFixture[str]) -> None:
    status, out, _ = run(capsys, "check", str(shipped("tasks") / "scenes"))
    assert status == 0
    assert "table.yaml: a good scene" in out
    status, out, _ = run(capsys, "check", "--schema", "setup")
    assert status == 0
    assert json.loads(out)["title"] == "setup"
    assert run(capsys, "check")[0] == 2


def test_check_says_of_a_folder_that_nothing_in_it_is_ours(
    capsys: pytest.CaptureFixture[str],
) -> None:
    Path("none").mkdir()
    Path("none", "notes.txt").write_text("format: task/1")
    status, out, err = run(capsys, "check", "none")
    assert (status, out) == (2, "")
    assert err.startswith("none: no file of ours is in this folder; name a folder")
    Path("none", "t.yml").write_text("format: task/1\nname: a\ntree: {subtask: a}\n")
    assert run(capsys, "check", "none")[0] == 0


def test_figures_of_what_was_never_learned_are_bad_input(
    capsys: pytest.CaptureFixture[str],
) -> None:
    write_task(examples.task(), Path("t.yaml"))
    status, out, err = run(capsys, "show", "t.yaml", "--figures", "figures")
    assert (status, out) == (2, "")
    assert err == (
        "t.yaml:1: nothing has been learned for this task yet; show it first: assistant learn\n"
    )
    assert not Path("figures").exists()


def test_show_a_lesson(capsys: pytest.CaptureFixture[str]) -> None:
    write_task(examples.task(examples.lesson()), Path("t.yaml"))
    status, out, _ = run(capsys, "show", "t.yaml")
    assert status == 0
    for told in (
        "1.2 part 1 (turn clockwise) (optional)",
        "until: docked at block, block in the hand, block on cup 2",
        "learned from a.yaml, b.yaml; path of",
        "cues 0.80 s late",
        "gripper 1.00, speed 0.33",
        "(nobody introduced it)",
        '"more left, please": moved by (1.0, 0.0, -333.3) mm before part 2 (moves with block)',
        "open question: missing_step about part 2 (empty)",
        "█",
    ):
        assert told in out, told
    assert "\x1b" not in out


def test_show_plays_setups_scenes_and_demonstrations(capsys: pytest.CaptureFixture[str]) -> None:
    write_transcript(PLAY, Path("p.yaml"))
    write_setups([Setup("a [b]", places={"x": examples.BODY_PLACE})], Path("s.yaml"))
    write_scene(examples.SCENE, Path("c.yaml"))
    write_demonstration(examples.demonstration(), Path("d.yaml"))
    expected = {
        "p.yaml": [
            "teacher: two [heard: too] [at 1.5 s]",
            "robot: ask, goal, about grasp, n 1 wi",
            'robot: "Hello."',
            "(until the arm rests)",
            "the scripted hand, seed 3",
        ],
        "s.yaml": ["a [b] (scene table)", "1, 2.5, 3"],
        "c.yaml": ["obstacle", "at most 300 mm/s"],
        "d.yaml": ["20 samples in", "first step", "^", "key state"],
        "d.csv": ["20 samples in", "gripper, up to"],
    }
    for name, lines in expected.items():
        status, out, _ = run(capsys, "show", name)
        assert status == 0
        for line in lines:
            assert line in out, (name, line)


def test_show_draws_what_can_be_drawn(capsys: pytest.CaptureFixture[str]) -> None:
    write_demonstration(examples.demonstration(), Path("d.yaml"))
    write_setups([Setup("a")], Path("s.yaml"))
    for name in ("d.yaml", "d.csv"):
        status, _, err = run(capsys, "show", name, "--figures", "drawn")
        assert (status, err.splitlines()[-1]) == (0, "wrote drawn/recording.png")
    assert Path("drawn/recording.png").read_bytes().startswith(b"\x89PNG")
    status, _, err = run(capsys, "show", "s.yaml", "--figures", "drawn")
    assert (status, "no figures of such a file" in err) == (2, True)
    assert run(capsys, "show", "d.csv", "--figures", "d.csv/x")[0] == 2


def test_show_json_gives_the_values(capsys: pytest.CaptureFixture[str]) -> None:
    write_demonstration(examples.demonstration(), Path("d.yaml"))
    write_transcript(PLAY, Path("p.yaml"))
    for name, key in (("d.yaml", "recording"), ("d.csv", "t_s"), ("p.yaml", "steps")):
        status, out, _ = run(capsys, "show", "--json", name)
        assert status == 0
        assert key in json.loads(out)


def test_convert_does_not_overwrite_unasked(capsys: pytest.CaptureFixture[str]) -> None:
    write_task(examples.task(), Path("t.yaml"))
    assert run(capsys, "convert", "t.yaml", "t.json") == (0, "", "")
    status, _, err = run(capsys, "convert", "t.yaml", "t.json")
    assert (status, err) == (2, "t.json: exists already; another name, or --overwrite\n")
    assert run(capsys, "convert", "--overwrite", "t.yaml", "t.json")[0] == 0
    assert run(capsys, "convert", "t.yaml", "t.yaml")[0] == 0


def test_tasks_are_listed_shown_and_deleted(capsys: pytest.CaptureFixture[str]) -> None:
    status, out, _ = run(capsys, "tasks")
    assert status == 0
    assert "no tasks are kept yet" in out
    library().save("mine", examples.task(examples.lesson()))
    library().save("other", examples.task())
    library().path("broken").write_text("x: 1")
    _, out, _ = run(capsys, "tasks")
    assert "mine                     learned" in out
    assert "other                    introduced" in out
    assert "broken                   cannot be read" in out
    assert "learned from a.yaml" in run(capsys, "tasks", "show", "mine")[1]
    assert "learned from a.yaml" in run(capsys, "show", "mine")[1]
    told = json.loads(run(capsys, "tasks", "--json")[1])
    assert [row["learned"] for row in told["tasks"]] == [False, True, False]
    assert json.loads(run(capsys, "tasks", "show", "mine", "--json")[1])["name"] == "on"
    assert run(capsys, "tasks", "delete", "mine")[:2] == (0, "deleted mine\n")
    status, _, err = run(capsys, "tasks", "show", "mine")
    assert status == 2
    assert "no task 'mine' is kept; known: broken, other" in err
    assert run(capsys, "tasks", "delete")[0] == 2


@pytest.mark.parametrize("verb", ["check", "show", "convert", "tasks"])
def test_help_has_an_example(verb: str, capsys: pytest.CaptureFixture[str]) -> None:
    with pytest.raises(SystemExit) as caught:
        main([verb, "--help"])
    assert caught.value.code == 0
    assert f"example:\n  assistant {verb}" in capsys.readouterr().out


def test_listing_tasks_obeys_no_sign_that_stands_in_them(
    capsys: pytest.CaptureFixture[str],
) -> None:
    library().save("it", replace(examples.task(), goal="one\n\x1b[31mtwo\x07"))
    status, out, _ = run(capsys, "tasks")
    assert status == 0
    assert out.endswith("one [31mtwo\n")
    assert out.count("\n") == 1


@pytest.mark.parametrize("key", ["scene", "setup", "task"])
def test_a_name_too_long_for_a_file_names_none(
    key: str, capsys: pytest.CaptureFixture[str]
) -> None:
    head = "format: setup/1" if key == "scene" else "format: transcript/1\ntitle: t\nsteps: []"
    Path("long.yaml").write_text(f"{head}\n{key}: {'ä' * 200}\n", encoding="utf-8")
    status, _, err = run(capsys, "check", "long.yaml")
    assert status == 0
    assert f"warning: long.yaml{'' if key == 'scene' else ':4'}: there is no" in err
