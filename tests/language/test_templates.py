import pytest
from hypothesis import given
from hypothesis import strategies as st

from assistant.language.templates import all_words, compiled, first_words, last_words, matches


def bound(template: str, text: str) -> list[dict[str, str]]:
    words = text.split()
    found = matches(compiled(template, {"step": "(step|part)"}, {}), words)
    return [{name: " ".join(words[a:b]) for name, a, b in one} for one in found]


@pytest.mark.parametrize(
    ("template", "text", "times"),
    [
        ("(go|run) now", "go now", 1),
        ("(go|run) now", "go", 0),
        ("[please] go", "go", 1),
        ("[please] go", "please go", 1),
        ("(go on|go) [on]", "go on", 2),
        ("the <step>", "the part", 1),
        ("(a)? b", "b", 1),
    ],
)
def test_matches_count_the_ways(template: str, text: str, times: int) -> None:
    assert len(bound(template, text)) == times


def test_slots_bind_shortest_first() -> None:
    found = bound("call {old} {new}", "call step two lift")
    assert found == [{"old": "step", "new": "two lift"}, {"old": "step two", "new": "lift"}]


@given(st.lists(st.sampled_from(["a", "b", "c"]), max_size=4))
def test_every_match_begins_with_a_first_word(words: list[str]) -> None:
    nodes = compiled("[a] (b|c a) [c]", {}, {})
    firsts = first_words(nodes)
    assert firsts == frozenset("abc")
    if any(True for _ in matches(nodes, words)):
        assert words[0] in firsts
        assert set(words) <= all_words(nodes)


def test_a_slot_inside_a_choice_may_be_followed_by_more() -> None:
    assert bound("(it|the {x}) is {value}", "the cup is red") == [{"x": "cup", "value": "red"}]


@given(st.lists(st.sampled_from(["a", "b", "c"]), max_size=4))
def test_every_match_ends_with_a_last_word(words: list[str]) -> None:
    nodes = compiled("[a] (b|c a) [(b c|b)]", {}, {})
    lasts = last_words(nodes)
    assert lasts == frozenset("abc")
    if any(True for _ in matches(nodes, words)):
        assert words[-1] in lasts


def test_what_ends_in_a_slot_may_end_with_anything() -> None:
    assert last_words(compiled("call it {name}", {}, {})) is None
    assert last_words(compiled("call {name} (now|again)", {}, {})) == frozenset(("now", "again"))
