"""Taking a correction back by its own words: "take back the 3 cm lower", "undo more left".

What is taken back is told as it was asked for; read by itself it would be done once more.
"""

from __future__ import annotations

from assistant.language.clauses import clause
from assistant.language.parsing import DOUBTFUL, GUESSED, LIKELY, Hearing, Parse, texts_of
from assistant.language.words import Words
from assistant.model.teacher_acts import AdjustSpeed, Gripper, Rotate, Translate, Undo

_CORRECTIONS = (AdjustSpeed, Gripper, Rotate, Translate)


def withdrawn(words: Words, hearing: Hearing) -> Parse | None:
    """Return the undo of a correction that is told behind a verb of taking back."""
    texts, little = texts_of(words), hearing.book.little
    sure = texts[0] in little["undoing"]
    size = 1 if sure else 2
    apart = texts[:1] and texts[0] in little["taking"] and set(texts[1:2]) & little["back"]
    if not (sure or apart):
        return None
    rest = words[size:]
    told = len(rest) > 1 and rest[0].text in little["determiners"]
    while len(rest) > 1 and rest[0].text in little["determiners"] | little["last_change"]:
        rest = rest[1:]
    joined = rest and rest[0].text in little["clause_joints"]
    if len(rest) < 2 or joined or any(word.broken for word in rest):
        return None
    if not (sure or told) and hearing.book.numbers.quantity(texts_of(rest), 0):
        return None
    found = clause(rest, hearing)
    if found is None or found.score < DOUBTFUL:
        return None
    if not all(isinstance(act, _CORRECTIONS) for act in found.acts):
        return None
    return Parse((Undo(),), LIKELY if sure and found.score >= LIKELY else GUESSED, "plain")
