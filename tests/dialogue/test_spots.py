"""A thing that nobody has put anywhere is offered a place that is free and on a table."""

from __future__ import annotations

from dataclasses import replace

from assistant.dialogue.spots import spot
from assistant.model import teacher_acts as acts
from assistant.model.scene import Obstacle, Scene
from tests.dialogue.teaching import Lessons

TABLE = Obstacle("table", (1800.0, 1800.0, 20.0), (0.0, 0.0, 220.0))


def asked_where() -> Lessons:
    teacher = Lessons().open().tell("tea").tell("done").tell(("jar", "target"))
    known = teacher.dialogue.known
    bare = Scene(tables=(TABLE,), bodies={"target": known.scene.bodies["target"]})
    teacher.dialogue = replace(teacher.dialogue, known=replace(known, scene=bare))
    return teacher.tell("a box, 4 by 4 by 6 centimetres")


def test_who_leaves_the_place_to_the_robot_is_told_one() -> None:
    teacher = asked_where().hear(acts.Unknown(), text="in the middle of the table")
    assert teacher.topics[0] == "read_back.place"
    place = teacher.dialogue.known.setup.places["jar"]
    assert (place.kind, place.xyz_mm[2]) == ("body", 240.0)


def test_who_does_not_know_is_offered_one_and_no_leaves_it_to_the_showing() -> None:
    teacher = asked_where().hear(acts.Unknown(), text="i don't know")
    assert teacher.topics == ["confirm.place_offered"]
    teacher.hear(acts.Deny(), text="no")
    assert "jar" in teacher.dialogue.known.unplaced
    assert "jar" not in teacher.dialogue.known.setup.places


def test_no_place_is_taken_twice() -> None:
    teacher = asked_where().hear(acts.Unknown(), text="anywhere")
    known = teacher.dialogue.known
    taken = known.setup.places["jar"]
    two = replace(
        known,
        scene=replace(known.scene, bodies={**known.scene.bodies, "tin": known.scene.bodies["jar"]}),
    )
    other = spot(two, "tin")
    assert other is not None
    assert abs(other.xyz_mm[1] - taken.xyz_mm[1]) >= 60.0


def test_beside_what_is_nowhere_yet_a_place_is_offered() -> None:
    teacher = asked_where()
    known = teacher.dialogue.known
    nowhere = {name: one for name, one in known.setup.places.items() if name != "target"}
    setup = replace(known.setup, places=nowhere)
    teacher.dialogue = replace(
        teacher.dialogue, known=replace(known, setup=setup, unplaced=("target",))
    )
    teacher.hear(acts.Unknown(), text="right of the target")
    assert teacher.topics == ["told.nowhere_yet", "confirm.place_offered"]
    teacher.hear(acts.Affirm(), text="yes")
    assert "jar" in teacher.dialogue.known.setup.places
