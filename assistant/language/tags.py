"""Words of corrections by class: ways, paces, amounts, and what turns them round."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import lru_cache

from assistant.language.little_words import LittleWords
from assistant.language.numbers import Quantity
from assistant.language.phrasebook import Phrase, Phrasebook
from assistant.model.teacher_acts import Degree

OPPOSITE = {
    "left": "right",
    "right": "left",
    "up": "down",
    "down": "up",
    "forward": "backward",
    "backward": "forward",
    "clockwise": "counterclockwise",
    "counterclockwise": "clockwise",
    "faster": "slower",
    "slower": "faster",
}
WAYS = {
    **{way: way for way in OPPOSITE if way not in ("faster", "slower")},
    "up-er": "up",
    "down-er": "down",
    "high": "up",
    "low": "down",
    "raise": "up",
    "lower": "down",
    "advance": "forward",
    "retreat": "backward",
}
PACES = {"faster": "faster", "fast": "faster", "slower": "slower", "slow": "slower"}


@dataclass(frozen=True, slots=True)
class Tag:
    """A stretch of words with the class it belongs to; class ``other`` is unexplained."""

    kind: str
    quantity: Quantity | None
    words: tuple[str, ...]


def tags_of(words: Sequence[str], book: Phrasebook, names: frozenset[str]) -> tuple[Tag, ...]:
    """Return the classes of the words, longest phrases first."""
    return _tags(tuple(words), book, names)


@lru_cache(maxsize=4096)
def _tags(words: Phrase, book: Phrasebook, names: frozenset[str]) -> tuple[Tag, ...]:
    found: list[Tag] = []
    at = 0
    while at < len(words):
        begun = book.motion_begun.get(words[at])
        phrase = next((p for p in begun if words[at : at + len(p)] == p), None) if begun else None
        quantity = book.numbers.quantity(words, at)
        if quantity is not None and (phrase is None or quantity.end - at >= len(phrase)):
            found.append(Tag("quantity", quantity, tuple(words[at : quantity.end])))
            at = quantity.end
        elif phrase is not None:
            at += len(phrase)
            # Behind all else "too" means also, and German "zu" shuts the hand.
            alone = book.motion[phrase] == "too" and (
                not words[at:] or words[at] in book.little["joints"]
            )
            found.append(Tag("other" if alone else book.motion[phrase], None, phrase))
        else:
            kind = "skip" if words[at] in names else "other"
            kind = "empty" if words[at] in book.empty else kind
            found.append(Tag(kind, None, (words[at],)))
            at += 1
    return tuple(found)


def rounded(value: float) -> float:
    """Return a number without the dust of arithmetic."""
    return float(f"{value:.9g}")


def flipped(tags: Sequence[Tag]) -> bool:
    """Tell whether words say that there is too much of a way: "too far left"."""
    kinds = [tag.kind for tag in tags]
    if "enough" in kinds:
        return False
    return "too" in kinds or "not" in kinds or "less" in kinds


def degree(tags: Sequence[Tag], little: LittleWords) -> Degree | None:
    """Return little or much; "too far" and "not so much" only name the direction."""
    found: list[str] = []
    for at, tag in enumerate(tags):
        if tag.kind not in ("little", "much"):
            continue
        before = tags[at - 1].kind if at else ""
        if tag.kind == "much" and before in ("too", "so", "enough"):
            continue
        alone = tag.words[0] if len(tag.words) == 1 else ""
        if alone in little["far"] or (alone in little["well"] and before):
            behind = tags[at + 1].kind if at + 1 < len(tags) else ""
            if behind != "too":
                continue
        found.append(tag.kind)
    if not found:
        return None
    return "little" if "little" in found else "much"


def degree_of(words: Sequence[str], book: Phrasebook) -> Degree | None:
    """Return little or much, wherever it stands."""
    return degree(tags_of(words, book, frozenset()), book.little)
