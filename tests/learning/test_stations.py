from __future__ import annotations

from dataclasses import replace

from assistant.learning.signals import GripperEvent
from assistant.learning.stations import touches, visits
from assistant.model.lesson import Episode
from assistant.model.task import Action, Primitive, Subtask, Task, TaskObject
from tests.learning.lessons import NAMES, task

CLOSE, OPEN = GripperEvent(5.0, "close"), GripperEvent(9.0, "open")
EPISODES = tuple(Episode(2.0 * k, 2.0 * k + 2.0, name, 1.0) for k, name in enumerate(NAMES))


def test_each_event_finds_its_primitive_object_and_frame() -> None:
    grasp, release = visits(task(), (CLOSE, OPEN), EPISODES)
    assert (grasp.primitive, grasp.object, grasp.frame) == ("grasp object", "block", "block")
    assert (release.primitive, release.object) == ("place object", "block")
    assert release.frame == "target"


def test_opening_an_empty_hand_is_no_release() -> None:
    assert [one.kind for one in visits(task(), (replace(OPEN, at_s=1.0), CLOSE), ())] == ["grasp"]


def test_a_tree_without_primitives_of_the_hand_still_has_objects() -> None:
    leaves = (
        Primitive("reach", Action("move", "approach", "block")),
        Primitive("carry", Action("move", "to", "target")),
    )
    plain = Task("carry", Subtask("carry", leaves), "", task().objects)
    episodes = (Episode(0.0, 5.0, "reach", 1.0), Episode(5.0, 9.5, "carry", 1.0))
    grasp, release = visits(plain, (CLOSE, OPEN), episodes)
    assert (grasp.object, release.frame) == ("block", "target")


def test_stacking_releases_at_an_object() -> None:
    leaves = (
        Primitive("grasp b", Action("hand", "close", "b")),
        Primitive("put b", Action("hand", "open", "a")),
    )
    objects = (TaskObject("a", "object"), TaskObject("b", "object"))
    found = visits(Task("stack", Subtask("stack", leaves), "", objects), (CLOSE, OPEN), ())
    assert [(one.object, one.frame) for one in found] == [("b", "b"), ("b", "a")]


def test_touches_are_the_ends_of_motions_to_things() -> None:
    leaves = (
        Primitive("reach", Action("move", "approach", "block")),
        Primitive("push", Action("move", "to", "target")),
    )
    plain = Task("push", Subtask("push", leaves), "", task().objects)
    episodes = (Episode(0.0, 5.0, "reach", 1.0), Episode(5.0, 9.5, "push", 1.0))
    assert [(one.frame, one.at_s) for one in touches(plain, episodes)] == [
        ("block", 5.0),
        ("target", 9.5),
    ]


def closing(*later: Primitive, moved: bool = False) -> list[str]:
    """Return the visits of a task whose second step closes the hand, as `visits` finds them."""
    first = Primitive("begin", Action("move", "down") if moved else Action("hand", "open"))
    tree = Subtask("all", (first, Primitive("fist", Action("hand", "close")), *later))
    return [one.kind for one in visits(Task("all", tree, "", task().objects), (CLOSE,), ())]


def test_a_hand_that_is_closed_before_all_else_to_push_with_grasps_nothing() -> None:
    reach = Primitive("reach", Action("move", "approach", "block"))
    assert closing(reach) == []
    # It may hold something if it was moved before, is opened again, or approaches a target.
    assert closing(reach, moved=True) == ["grasp"]
    assert closing(reach, Primitive("let go", Action("hand", "open"))) == ["grasp"]
    assert closing(Primitive("bring", Action("move", "approach", "target"))) == ["grasp"]
