"""Tasks: the tree as people write it, and everything that was learned, unchanged."""

from __future__ import annotations

from dataclasses import fields, replace
from pathlib import Path

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from assistant.errors import BadInput
from assistant.files.converting import convert
from assistant.files.kinds import Known
from assistant.files.shipped import shipped
from assistant.files.tasks import read_task, task_text, write_task
from assistant.model.feedback import Feedback
from assistant.model.lesson import LearnedPath, Lesson, Segmentation
from assistant.model.task import Action, Primitive, Subtask, Task, TaskObject
from tests.files import examples
from tests.files.same import same

TREE = """\
format: task/1
name: lift
objects: {block: {role: object}}
tree:
  subtask: lift
  order: sequential
  parts:
    - primitive: go there
      action: {move: approach, object: block}
      until: [{docked: block}]
    - {primitive: grasp it, action: {hand: close, object: block}, until: [{held: block}]}
"""


def written(tmp_path: Path, text: str) -> Path:
    path = tmp_path / "task.yaml"
    path.write_text(text)
    return path


@pytest.mark.parametrize("path", sorted(shipped("tasks").glob("*.yaml")), ids=lambda p: p.name)
def test_shipped_tasks_written_again_are_the_same_text(path: Path) -> None:
    assert task_text(read_task(path)) == path.read_text()


def test_every_field_of_a_lesson_comes_back_exactly(tmp_path: Path) -> None:
    task = examples.task(examples.lesson())
    write_task(task, tmp_path / "t.yaml")
    again = read_task(tmp_path / "t.yaml")
    assert same(task, again)
    assert task_text(again) == task_text(task)


def test_the_example_sets_every_field() -> None:
    """A field added to a lesson and not to files would be lost without a complaint."""
    lesson = examples.lesson()
    empty = Lesson(Segmentation((), (), None), None)
    for value, plain in ((lesson, empty), (lesson.segmentation, empty.segmentation)):
        for field in fields(value):
            assert not same(getattr(value, field.name), getattr(plain, field.name)), field.name
    plain_feedback = Feedback("translate", "")
    for field in fields(Feedback):
        told = [getattr(each, field.name) for each in lesson.feedback]
        assert any(value != getattr(plain_feedback, field.name) for value in told), field.name


@settings(max_examples=20, deadline=None)
@given(st.integers(0, 1000), st.integers(21, 60), st.booleans(), st.booleans())
def test_lessons_of_any_shape_come_back(
    tmp_path_factory: pytest.TempPathFactory, seed: int, n: int, gripper: bool, path: bool
) -> None:
    lesson = examples.lesson(30 if not path else max(n, 30), seed)
    assert lesson.path is not None
    if not gripper:
        bare = LearnedPath(lesson.path.t_s, lesson.path.path, None, lesson.path.primitive_at)
        lesson = replace(lesson, path=bare)
    if not path:
        lesson = replace(lesson, path=None, stations=())
    file = tmp_path_factory.mktemp("t") / "t.yaml"
    write_task(examples.task(lesson), file)
    assert same(examples.task(lesson), read_task(file))


@settings(max_examples=25, deadline=None)
@given(examples.tasks())
def test_trees_of_any_shape_come_back(tmp_path_factory: pytest.TempPathFactory, task: Task) -> None:
    file = tmp_path_factory.mktemp("t") / "t.yaml"
    for ending in (".yaml", ".json"):
        path = file.with_suffix(ending)
        convert(Known("task", task), file, path)
        assert read_task(path) == task
    write_task(task, file)
    assert task_text(read_task(file)) == file.read_text("utf-8")


@pytest.mark.parametrize(
    ("old", "new", "line", "told"),
    [
        ("task/1", "task/2", 1, "format 'task/2' is not known here; format: task/1"),
        ("format: task/1\n", "", 1, "there is no format"),
        ("name: lift\n", "name: 7\n", 2, "7 is not a text; put it in quotes"),
        ("name: lift\n", "naem: lift\n", 2, "unknown key 'naem'; did you mean 'name'?"),
        ("name: lift\n", "", 1, "key 'name' is missing"),
        ("role: object", "role: thing", 3, "'thing' is not known here; one of object, target"),
        ("order: sequential", "order: random", 6, "'random' is not known here"),
        ("move: approach", "move: aproach", 9, "'aproach' is not known here; one of approach"),
        ("{move: approach, object", "{move: up, turn: left, object", 9, "exactly one of move"),
        ("{docked: block}", "{docked: block, held: block}", 10, "exactly one of hand"),
        ("{docked: block}", "{docked: cup}", 10, "there is no object 'cup'"),
        ("object: block}, until: [{h", "object: box}, until: [{h", 11, "there is no object 'box'"),
        ("primitive: grasp it", "primitive: go there", 11, "stands here again (first on line 8)"),
        ("primitive: go there", "prim: go there", 8, "unknown key 'prim'"),
        (
            "    - {primitive: grasp it",
            "    - grasp\n    - {primitive: grasp it",
            11,
            "this is no part; a mapping",
        ),
        ("parts:", "parts: none\n  other:", 7, "parts"),
    ],
)
def test_mistakes_are_told_with_their_line(
    tmp_path: Path, old: str, new: str, line: int, told: str
) -> None:
    assert old in TREE
    path = written(tmp_path, TREE.replace(old, new, 1))
    with pytest.raises(BadInput) as caught:
        read_task(path)
    matching = [each for each in caught.value.problems if told in str(each)]
    assert matching, str(caught.value)
    assert matching[0].where == f"{path}:{line}"


def test_all_problems_are_told_at_once(tmp_path: Path) -> None:
    text = TREE.replace("move: approach", "move: x").replace("role: object", "role: x")
    with pytest.raises(BadInput) as caught:
        read_task(written(tmp_path, text.replace("hand: close", "hand: shut")))
    assert len(caught.value.problems) == 3


def test_what_no_form_sees_is_told_with_the_rest_in_the_order_of_lines(tmp_path: Path) -> None:
    text = TREE.replace("name: lift", "nmae: lift").replace("grasp it", "go there")
    with pytest.raises(BadInput) as caught:
        read_task(written(tmp_path, text.replace("object: block}", "object: blok}", 1)))
    told = [str(problem).split(": ", 1)[1] for problem in caught.value.problems]
    assert told[0].startswith("key 'name' is missing")
    assert told[1].startswith("unknown key 'nmae'; did you mean 'name'?")
    assert sum("there is no object 'blok'" in one for one in told) == 1
    assert "the name 'go there' stands here again (first on line 8)" in told[-1]


@pytest.mark.parametrize(
    ("old", "new", "told"),
    [
        ("at: 10", "at: 999", "at: the path has 30 rows"),
        ("speed: 0.7", "speed: -1", "speed"),
        ("confidence: 0.9", "confidence: 9", "confidence"),
        ("columns: [t_s, vote,", "columns: [t, vote,", "other columns than known"),
        ("columns: [t_s, x_m,", "columns: [t_s, y_m,", "other columns than known"),
        ("kind: touch", "kind: throw", "'throw' is not known here"),
    ],
)
def test_a_lesson_that_does_not_fit_together_is_refused(
    tmp_path: Path, old: str, new: str, told: str
) -> None:
    text = task_text(examples.task(examples.lesson()))
    assert old in text
    with pytest.raises(BadInput) as caught:
        read_task(written(tmp_path, text.replace(old, new, 1)))
    assert told in str(caught.value)


def test_rows_that_are_short_or_run_backward_are_told(tmp_path: Path) -> None:
    lines = task_text(examples.task(examples.lesson())).splitlines()
    first = next(i for i, line in enumerate(lines) if line.strip() == "rows:") + 1
    swapped = [*lines[:first], lines[first + 1], lines[first], *lines[first + 2 :]]
    with pytest.raises(BadInput, match=rf":{first + 2}: time does not increase"):
        read_task(written(tmp_path, "\n".join(swapped)))
    other = lines[first].rsplit(",", 1)[0] + ", 4]"
    with pytest.raises(BadInput, match=r"no such primitive: the tree has 4"):
        read_task(written(tmp_path, "\n".join([*lines[:first], other, *lines[first + 1 :]])))
    lines[first] = lines[first].rsplit(",", 1)[0] + "]"
    with pytest.raises(BadInput, match=rf":{first + 1}: 9 numbers; 10 as in columns"):
        read_task(written(tmp_path, "\n".join(lines)))


def test_objects_may_be_named_like_keys(tmp_path: Path) -> None:
    names = ("points", "tree", "parts", "episodes", "learned", "yes", "null", "7", "a: b")
    plain = examples.task(examples.lesson())
    added = tuple(TaskObject(name, "object") for name in names)
    task = replace(plain, objects=(*plain.objects, *added))
    write_task(task, tmp_path / "t.yaml")
    assert same(read_task(tmp_path / "t.yaml"), task)


def test_empty_and_double_files_are_told(tmp_path: Path) -> None:
    with pytest.raises(BadInput, match="the file is empty"):
        read_task(written(tmp_path, "# nothing\n"))
    with pytest.raises(BadInput, match=":13: a second document begins"):
        read_task(written(tmp_path, f"{TREE}---\n{TREE}"))


def test_no_name_is_too_long_to_be_read_again(tmp_path: Path) -> None:
    name = "put the block on the target " * 50 + "at last"
    long = Task(name, Subtask(name, (Primitive(f"{name}!", Action("free", name)),)), name)
    write_task(long, tmp_path / "t.yaml")
    assert read_task(tmp_path / "t.yaml") == long
