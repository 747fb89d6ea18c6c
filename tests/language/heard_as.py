"""What the grammar alone hears in a line: its acts as they are told to programs."""

from typing import Any, cast

from assistant.language.commands import command
from assistant.language.fillers import without_fillers
from assistant.language.parsing import Hearing
from assistant.language.phrasebook import phrasebook
from assistant.language.words import words_of
from assistant.model.listening import Listening
from assistant.model.teacher_acts import Asked, Stage, act_to_json


def heard_as(text: str, asked: str | None = None, stage: str = "practice") -> list[dict[str, Any]]:
    """Return the acts of a line, which must mean something."""
    book = phrasebook()
    where = Listening(stage=cast("Stage", stage), asked=cast("Asked | None", asked))
    words = without_fillers(words_of(text, book.contractions), where.asked, book)
    found = command(words, Hearing(book, where))
    assert found is not None
    return [act_to_json(act) for act in found.acts]
