"""Steps that are spoken of by their parts: "the two parts of step two in any order".

Not one of the parts is named but what they are parts of, and so the act is about that.
"""

from __future__ import annotations

from assistant.language.parsing import Hearing, texts_of
from assistant.language.runs import named_text
from assistant.language.words import Words
from assistant.model.teacher_acts import TeacherAct, Unordered


def by_parts(
    acts: tuple[TeacherAct, ...], words: Words, hearing: Hearing
) -> tuple[TeacherAct, ...]:
    """Return acts with the step whose parts are spoken of, where it is said of them."""
    if len(acts) != 1 or not isinstance(acts[0], Unordered):
        return acts
    little, texts = hearing.book.little, texts_of(words)
    for at in range(1, len(texts) - 2):
        if texts[at] in little["owned_by"] and texts[at - 1] in little["counted"]:
            start, end = at + 1, _end(at + 1, words, hearing)
            if end > start:
                return (Unordered((named_text(words, (start, end), hearing),)),)
    return acts


def _end(at: int, words: Words, hearing: Hearing) -> int:
    """Return where the name of the step ends: at a mark, or where it is told what of its parts."""
    little = hearing.book.little
    while at < len(words) and words[at].text in little["determiners"]:
        at += 1
    while at < len(words) and not words[at].broken and words[at].text not in little["of_parts"]:
        at += 1
    return at
