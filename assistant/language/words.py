"""From a line of text to words: lower case, contractions spelled out, numbers and units apart.

Every word remembers what was said, so that names and answers keep the teacher's own text.
"""

from __future__ import annotations

import re
import unicodedata
from collections.abc import Mapping, Sequence
from typing import NamedTuple

from assistant.language.little_words import LittleWords

_PIECES = re.compile(
    r"[+-]?\d+(?:[.,]\d+)?(?:st|nd|rd|th)\b|(?<![\w.])[+-]?(?:\d+(?:\.\d+)?|\.\d+)(?=[^\d]|$)"
    r"|\d+|[^\W\d_]\w*(?:'[^\W\d_]+)*'?|[&%°\"½¼¾]|\+(?!\d)|w/o?\b|[,;:.!?()/=]|-"
)
_BREAKS = frozenset(",;:.!?()/=-")
_SHARE_SIGNS = {"½": "0.5", "¼": "0.25", "¾": "0.75"}
_DASHES = dict.fromkeys((*range(0x2010, 0x2015), 0x2212), "-") | dict.fromkeys(
    (0x2018, 0x2019, 0xB4, 0x60), "'"
)
_UNDERSCORES = re.compile(r"(?<=[^\W_])_+(?=[^\W_])")
OWNER = "'s"
LED = "_"
"""Marks a contraction that stands before another word, "d'_": "d'hand" is "die hand"."""
MOST_CHARACTERS = 2000


class Word(NamedTuple):
    """One word; a named tuple, for lines are looked up by their words.

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


def cleaned(text: str) -> str:
    """Return the text with simple apostrophes, dashes and letters."""
    known = unicodedata.normalize("NFKC", text[:MOST_CHARACTERS].replace("½", " 0.5 "))
    return known.translate(_DASHES)


def plain(text: str) -> str:
    """Return the text in lower case with simple apostrophes, dashes and spaces."""
    told = _UNDERSCORES.sub(" ", cleaned(text).lower())
    return " ".join(_HYPHENED.sub(_coded, told).split())


def _coded(found: re.Match[str]) -> str:
    """Return a name such as "vortex-10s" or "v-block" as one word; "w-wait" only stutters."""
    parts = found.group().split("-")
    mixed = any(not one.isalpha() and not one.isdigit() for one in parts)
    numbered = len(parts) == 2 and parts[0] not in _AXES and parts[1].isdigit()
    lone = [one for one in parts if len(one) == 1 and one.isalpha()]
    lettered = len(parts[0]) == 1 and (numbered or parts[-1].isalpha())
    stutters = bool(lone) and all(parts[-1].startswith(one) for one in lone)
    return "_".join(parts) if (mixed or lettered) and not stutters else found.group()


_HYPHENED = re.compile(r"(?<![\w-])[^\W\d_][^\W_]*(?:-[^\W_]+)+(?![\w-])")
_AXES = frozenset("xyz")


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
        if piece in _BREAKS and not (piece in contractions and _equals(source, match)):
            joined = piece == "-" and glued and source[match.end() : match.end() + 1] != " "
            broken = broken or not (joined or piece == "'")
            continue
        for word in _spelled(piece.strip("'"), contractions):
            found.append(Word(word.text, word.said, broken))
            broken = False
    return _phrases(found, contractions)


def _equals(source: str, mark: re.Match[str]) -> bool:
    """Tell the "=" of "episode 4 = lift", which says that one is the other, from "x = 4"."""
    counted = source[: mark.start()].rstrip()[-1:].isdigit()
    return counted and source[mark.end() :].lstrip()[:1].isalpha()


_SHARES = re.compile(r"(?<![\d/.,])(\d{1,2})/(\d{1,2})(?![\d/])")


def _share(found: re.Match[str]) -> str:
    """Return "0.75" for "3/4"; what is no share stays as it is."""
    above, below = int(found.group(1)), int(found.group(2))
    return f"{above / below:.12g}" if 0 < above < below else found.group()


_WITHIN_DIGITS = re.compile(r"(?<=\d),(?=\d)")


def _separated(text: str) -> str:
    """Put a space between a number and its unit, and take thousands of commas out."""
    lone = len(_WITHIN_DIGITS.findall(text)) == 1
    text = re.sub(r"(?<=\d),(?=\d{1,2}(?!\d))(?!\d,\d)", ".", text) if lone else text
    text = re.sub(r"(?<![\d½¼¾])\"", " ", text)
    text = _SHARES.sub(_share, text)
    text = re.sub(r"(?<![a-z\d])x(?=\d)", "x ", text)
    text = re.sub(r"(?<=[a-z])0(?=[a-z])", "o", text)
    text = re.sub(r"\bs[ .-]t[ .-]o[ .-]p\b", "stop", text)
    text = re.sub(r"(?<=\d)\s*(?=[°%\"])", " ", text)
    return re.sub(r"(?<![a-z\d_])(\d+(?:\.\d+)?)(?=(?!st\b|nd\b|rd\b|th\b)[a-z])", r"\1 ", text)


def _spelled(piece: str, contractions: Mapping[str, tuple[str, ...]]) -> list[Word]:
    if piece in _SHARE_SIGNS:
        return [Word(_SHARE_SIGNS[piece], piece)]
    if piece in contractions:
        first, *rest = contractions[piece]
        return [Word(first, piece), *(Word(one, "") for one in rest)]
    mark = piece.find("'") + 1
    led = contractions.get(piece[:mark] + LED) if mark and piece[mark:] else None
    if led:
        return [Word(" ".join(led), piece[:mark]), *_spelled(piece[mark:], contractions)]
    mark = piece.rfind("'")
    for cut in (mark - 1, mark) if mark > 0 else ():
        if cut > 0 and piece[cut:] in contractions:
            return [Word(piece[:cut], piece), *(Word(one, "") for one in contractions[piece[cut:]])]
    return [Word(piece, piece)] if piece and piece != "+" else []


def _phrases(words: Sequence[Word], contractions: Mapping[str, tuple[str, ...]]) -> Words:
    """Replace contractions that are written as two words, such as ``counter clockwise``."""
    found: list[Word] = []
    for word in words:
        pair = f"{found[-1].text} {word.text}" if found and not word.broken else ""
        owner = found[-1] if found and found[-1].text.endswith(OWNER) else None
        being = _being(owner, word, contractions) if owner else ""
        if owner and being:
            stem, told = owner.text.removesuffix(OWNER), owner.said.removesuffix(OWNER)
            found[-1:] = [Word(stem, told, owner.broken), Word(being, OWNER)]
        if pair in contractions:
            first, *rest = contractions[pair]
            together = f"{found[-1].said} {word.said}"
            found[-1] = Word(first, together, found[-1].broken)
            found.extend(Word(one, "") for one in rest)
        else:
            found.append(word)
    return tuple(found)


def _being(owner: Word, word: Word, contractions: Mapping[str, tuple[str, ...]]) -> str:
    """Return the "is" of "the job's called" and "pouring's done"; empty where "'s" owns."""
    told = contractions.get(f"{OWNER} {word.text}")
    ending = f"{owner.text.removesuffix(OWNER)[-_ENDING:]} {OWNER}"
    if told is None and f"{ending} {word.text}" not in contractions:
        told = contractions.get(ending)
    return told[0] if told else ""


_ENDING = 3
"""Letters at the end of a word that names what is done: "pouring"."""


def owners(little: LittleWords) -> dict[str, tuple[str, ...]]:
    """Return what is read behind an owner's mark, as contractions: "'s called" is "is called"."""
    being = tuple(little["is"])
    found: dict[str, tuple[str, ...]] = {f"{OWNER} {one}": being for one in little["behind_is"]}
    for ending in little.doing if being else ():
        found[f"{ending} {OWNER}"] = being
        found |= {f"{ending} {OWNER} {one}": () for one in little["owned"]}
    return found


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
