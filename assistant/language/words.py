"""From a line of text to words: lower case, contractions spelled out, numbers and units apart.

Every word remembers what was said, so that names and answers keep the teacher's own text.
"""

from __future__ import annotations

import re
import unicodedata
from collections.abc import Mapping, Sequence
from dataclasses import dataclass

_PIECES = re.compile(
    r"[+-]?\d+(?:[.,]\d+)?(?:st|nd|rd|th)\b|(?<![\w.])[+-]?(?:\d+(?:\.\d+)?|\.\d+)(?=[^\d]|$)"
    r"|\d+|[^\W\d_]\w*(?:'[^\W\d_]+)*'?|[&%°\"½¼¾]|w/o?\b|[,;:.!?()/=]|-"
)
_BREAKS = frozenset(",;:.!?()/=-")
_SIGNS = {"%": "percent", "°": "degrees", '"': "inches", "½": "0.5", "¼": "0.25", "¾": "0.75"}
_DASHES = dict.fromkeys((*range(0x2010, 0x2015), 0x2212), "-") | dict.fromkeys(
    (0x2018, 0x2019, 0xB4, 0x60), "'"
)
# What follows "is" rather than an owner: "the job's called", "the block's too high"; what
# follows the owner after the name of a step: "pouring's end".
_AFTER_IS = frozenset(
    [
        "called",
        "named",
        "the",
        "a",
        "an",
        "too",
        "not",
        "in",
        "on",
        "at",
        "about",
        "to",
        "just",
        "still",
        "now",
        "done",
        "over",
        "moving",
        "going",
        "gotta",
        "got",
        "have",
        "has",
        "always",
        "never",
        "optional",
        "required",
        "way",
        "really",
        "so",
        "gone",
        "been",
        "ended",
        "finished",
        "full",
        "empty",
        "open",
        "closed",
        "ready",
        "tight",
        "loose",
        "here",
        "there",
        "held",
        "gripped",
        "touching",
        "holding",
        "upright",
        "stuck",
        "shut",
        "clear",
    ]
)
_OWNED = frozenset(
    ["end", "ending", "cut", "name", "finish", "boundary", "start", "beginning", "goal"]
)
MOST_CHARACTERS = 2000


@dataclass(frozen=True, slots=True)
class Word:
    """One word.

    Parameters
    ----------
    text : str
        As it is compared: lower case, spelled out, perhaps repaired.
    said : str
        As the teacher said it, lower case; empty for the rest of a contraction.
    broken : bool
        Whether a comma or another mark stands before it.
    """

    text: str
    said: str
    broken: bool = False


Words = tuple[Word, ...]


def plain(text: str) -> str:
    """Return the text in lower case with simple apostrophes, dashes and spaces."""
    known = unicodedata.normalize("NFKC", text[:MOST_CHARACTERS].replace("½", " 0.5 "))
    return " ".join(known.translate(_DASHES).lower().split())


def words_of(text: str, contractions: Mapping[str, tuple[str, ...]]) -> Words:
    """Split a line into words, contractions spelled out."""
    found: list[Word] = []
    broken = False
    before_end = -1
    source = _separated(plain(text))
    for match in _PIECES.finditer(source):
        piece = match.group()
        glued = match.start() == before_end
        before_end = match.end()
        if piece in _BREAKS:
            joined = piece == "-" and glued and source[match.end() : match.end() + 1] != " "
            broken = broken or not (joined or piece == "'")
            continue
        for word in _spelled(piece.strip("'"), contractions):
            found.append(Word(word.text, word.said, broken))
            broken = False
    return _phrases(found, contractions)


_SHARES = re.compile(r"(?<![\d/.,])(\d{1,2})/(\d{1,2})(?![\d/])")


def _share(found: re.Match[str]) -> str:
    """Return "0.75" for "3/4"; what is no share stays as it is."""
    above, below = int(found.group(1)), int(found.group(2))
    return f"{above / below:.12g}" if 0 < above < below else found.group()


def _separated(text: str) -> str:
    """Put a space between a number and its unit, and take thousands of commas out."""
    text = (
        re.sub(r"(?<=\d),(?=\d{1,2}(?!\d))(?!\d,\d)", ".", text) if text.count(",") == 1 else text
    )
    text = re.sub(r"(?<![\d½¼¾])\"", " ", text)
    text = _SHARES.sub(_share, text)
    text = re.sub(r"(?<![a-z\d])x(?=\d)", "x ", text)
    text = re.sub(r"(?<=[a-z])0(?=[a-z])", "o", text)
    text = re.sub(r"\bs[ .-]t[ .-]o[ .-]p\b", "stop", text)
    text = re.sub(r"(?<=\d)\s*(?=[°%\"])", " ", text)
    return re.sub(r"(?<![a-z\d_])(\d+(?:\.\d+)?)(?=(?!st\b|nd\b|rd\b|th\b)[a-z])", r"\1 ", text)


def _spelled(piece: str, contractions: Mapping[str, tuple[str, ...]]) -> list[Word]:
    if piece in _SIGNS:
        return [Word(_SIGNS[piece], piece)]
    if piece in contractions:
        first, *rest = contractions[piece]
        return [Word(first, piece), *(Word(one, "") for one in rest)]
    for ending in ("n't", "'m", "'re", "'ve", "'ll", "'em", "'s"):
        if piece.endswith(ending) and len(piece) > len(ending) and ending in contractions:
            stem = piece[: -len(ending)]
            return [Word(stem, piece), *(Word(one, "") for one in contractions[ending])]
    return [Word(piece, piece)] if piece else []


def _phrases(words: Sequence[Word], contractions: Mapping[str, tuple[str, ...]]) -> Words:
    """Replace contractions that are written as two words, such as ``counter clockwise``."""
    found: list[Word] = []
    for word in words:
        pair = f"{found[-1].text} {word.text}" if found and not word.broken else ""
        if found and found[-1].text.endswith("'s") and _is_behind(found[-1], word):
            stem = found[-1].text.removesuffix("'s")
            told = found[-1].said.removesuffix("'s")
            found[-1:] = [Word(stem, told, found[-1].broken), Word("is", "'s")]
        if pair in contractions:
            first, *rest = contractions[pair]
            together = f"{found[-1].said} {word.said}"
            found[-1] = Word(first, together, found[-1].broken)
            found.extend(Word(one, "") for one in rest)
        else:
            found.append(word)
    return tuple(found)


def _is_behind(owner: Word, word: Word) -> bool:
    step = owner.text.endswith("ing's") and word.text not in _OWNED
    return step or word.text in _AFTER_IS


def said(words: Sequence[Word]) -> str:
    """Return the words as the teacher said them."""
    return " ".join(word.said for word in words if word.said).replace(" 's", "'s").lstrip("' ")


def told(words: Sequence[Word]) -> str:
    """Return the words as the teacher said them, with commas where marks stood between."""
    parts = [
        f", {word.said}" if word.broken and at else f" {word.said}"
        for at, word in enumerate(words)
        if word.said
    ]
    return "".join(parts).replace(" 's", "'s").strip(" ,")


def spoken(words: Sequence[Word]) -> str:
    """Return the words as they are compared."""
    return " ".join(word.text for word in words)
