import pytest

from tests.language.heard_as import heard_as


@pytest.mark.parametrize(
    ("text", "act", "name"),
    [
        ("do you remember the lesson we named early bird, please load it", "load", "early bird"),
        ("pull up the old one, tower of doom", "load", "tower of doom"),
        ("fetch my lesson, bottle sorting", "load", "bottle sorting"),
        ("compare what you do now with the lesson we called rainy day", "compare", "rainy day"),
        ("how does this stack up against blue tower, compare them", "compare", "blue tower"),
        ("guard it with the name first success", "save", "first success"),
        ("write it on disk as glass order", "save", "glass order"),
    ],
)
def test_a_lesson_is_named_anywhere_in_a_line(text: str, act: str, name: str) -> None:
    assert heard_as(text) == [{"act": act, "name": name}]


def test_what_follows_a_name_is_an_act_of_its_own() -> None:
    told = [{"act": "save", "name": "early bird"}, {"act": "quit"}]
    assert heard_as("save it as early bird and then quit") == told
