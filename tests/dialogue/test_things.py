"""Things as teachers call them: in part, several at once, all of them."""

from __future__ import annotations

import pytest

from assistant.dialogue.things import things_in
from assistant.language.actions import read_action
from assistant.model import teacher_acts as acts
from assistant.model.scene import Body, Scene
from assistant.model.task import TaskObject
from tests.dialogue.teaching import Lessons

STACK = Scene(bodies={name: Body(name) for name in ("red block", "green block", "blue block")})


def called(text: str, scene: Scene = STACK, language: str = "english") -> list[str]:
    return [one.name for one in things_in(text, scene, language)]


@pytest.mark.parametrize(
    ("text", "names"),
    [
        ("red and blue", ["red block", "blue block"]),
        ("the blocks", ["red block", "green block", "blue block"]),
        ("all three blocks", ["red block", "green block", "blue block"]),
        ("all of them", ["red block", "green block", "blue block"]),
        ("the green one", ["green block"]),
        ("the red block and a jug", ["red block", "jug"]),
        # Which of them is not told: it is another thing.
        ("a block", ["block"]),
        ("the cups", ["cups"]),
        # Where a thing lies is told beside and names none.
        (
            "You move the jar, and it goes onto the tray, which lies somewhere beside it.",
            ["jar", "tray"],
        ),
        # A full stop ends a thing, as a comma does; what is named again is the same.
        ("no. a can and a tray", ["can", "tray"]),
        ("a can of beans and a tray. the can goes on the tray", ["can of beans", "tray"]),
    ],
)
def test_things_are_called_in_part_and_together(text: str, names: list[str]) -> None:
    assert called(text) == names


def test_where_a_step_goes_is_the_thing_it_says_to_go_to() -> None:
    things = (TaskObject("red block", "object"), TaskObject("blue block", "target"))
    for text in ("go down to the red block", "let go at the red one", "move it over the red block"):
        action = read_action(text, things).action
        assert action is not None
        assert action.object == "red block"
    down = read_action("move the red block down", things).action
    assert down is not None
    assert down.object == "blue block"


def test_a_new_thing_that_something_is_put_on_is_a_place() -> None:
    def roles(goal: str, things: str) -> dict[str, str]:
        teacher = Lessons().open().tell("tidy").tell(goal).tell(things)
        return {one.name: one.role for one in teacher.dialogue.known.objects or ()}

    assert roles("the cup stands on the saucer", "cup and saucer") == {
        "cup": "object",
        "saucer": "target",
    }
    # What the robot knows keeps the role the scene gives it.
    assert roles("the cup stands on the block", "cup and block")["block"] == "object"
    assert roles("the saucer is clean", "cup and saucer")["saucer"] == "object"


def test_a_place_of_no_known_size_is_flat() -> None:
    teacher = Lessons().open().tell("tidy").tell("the cup stands on the saucer")
    teacher.tell("the cup and the saucer").tell("8 by 8 by 7 cm").tell("I do not know")
    while teacher.asked == "pose":
        teacher.hear(acts.Deny(), text="I will show you")
    teacher.hear(acts.Deny(), text="I do not know")
    assert teacher.dialogue.known.scene.bodies["saucer"].size_mm[2] == 0.0
