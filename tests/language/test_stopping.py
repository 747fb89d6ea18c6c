import pytest

from assistant.language.stopping import has_stop_word


@pytest.mark.parametrize(
    "text",
    ["stop", "don't stop", "STOP!", "stpo", "sotp", "stopp", "stooop", "halt", "hlat", "hallt",
     "freeze", "freze", "whoa", "woah", "abort", "pleasestop", "oh stop it", "hold it",
     "don't move", "s t o p", "emergency"],
)  # fmt: skip
def test_anything_like_a_stop_word_is_one(text: str) -> None:
    assert has_stop_word(text)


@pytest.mark.parametrize(
    "text",
    ["", "next step", "a bit more to the top", "the shop", "half of that", "go on", "so what",
     "put it on the target", "salt", "step three", "how are you", "about two cm"],
)  # fmt: skip
def test_ordinary_words_are_not(text: str) -> None:
    assert not has_stop_word(text)


def test_german_stop_words() -> None:
    assert has_stop_word("anhalten bitte", "german")
    assert has_stop_word("stopp", "german")


@pytest.mark.parametrize(
    "text",
    ["hast du den Block", "nur halb so schnell", "die Hand hält ihn", "sie holt den Becher",
     "der Hals der Flasche", "behalte das", "der Inhalt", "das ist hart"],
)  # fmt: skip
def test_german_words_near_a_stop_word_are_none(text: str) -> None:
    assert not has_stop_word(text, "german")


@pytest.mark.parametrize(
    "text", ["hlat", "stpo", "stop", "halt an", "haltt", "anhlten", "halte an"]
)
def test_german_slips_of_a_stop_word_are_one(text: str) -> None:
    assert has_stop_word(text, "german")
