from collections.abc import Iterator
from typing import Any, cast

import pytest

from assistant.language.little_words import folder_of
from assistant.plain_yaml import read_file


def words_in(told: Any) -> Iterator[Any]:
    """Yield all that lists of a page hold."""
    for one in told.values() if isinstance(told, dict) else told:
        if isinstance(one, dict | list):
            yield from words_in(one)
        elif isinstance(told, list):
            yield one


@pytest.mark.parametrize("language", ["english", "german"])
def test_lists_of_hints_hold_words_alone(language: str) -> None:
    # "false" without quotes is no word in a page.
    page = cast("dict[str, Any]", read_file(folder_of(language) / "hints.yaml")[0].value)
    assert not [one for one in words_in(page) if isinstance(one, bool)]
