"""The word pieces a recognizer reads and writes: numbers of them, and text cut into them.

A text is cut as the recognizer's makers cut theirs: letters that stand side by side are joined
into the piece with the lowest number, again and again, until no two make a piece.
"""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise

SPACE = "\u2581"


class Pieces:
    """The pieces of a tokenizer file.

    Parameters
    ----------
    told : bytes
        Each piece behind its length, in one byte or two.
    """

    def __init__(self, told: bytes) -> None:
        self._pieces = read_pieces(told)
        # Single bytes come first and again as letters: the letters are what is read.
        self._numbers = {piece: at for at, piece in enumerate(self._pieces)}

    def written(self, numbers: Sequence[int]) -> str:
        """Return the text of pieces."""
        told = b"".join(self._pieces[number] for number in numbers)
        return told.decode("utf-8", "replace").replace(SPACE, " ")

    def cut(self, text: str) -> tuple[int, ...]:
        """Return the numbers of a text's pieces; what no piece holds is left out."""
        parts = [letter.encode() for letter in SPACE + text.replace(" ", SPACE)]
        while (at := self._joined_first(parts)) is not None:
            parts[at : at + 2] = [parts[at] + parts[at + 1]]
        return tuple(self._numbers[part] for part in parts if part in self._numbers)

    def _joined_first(self, parts: Sequence[bytes]) -> int | None:
        """Return which part makes with the next one the piece of the lowest number."""
        known = (
            (self._numbers[first + second], at)
            for at, (first, second) in enumerate(pairwise(parts))
            if first + second in self._numbers
        )
        lowest = min(known, default=None)
        return None if lowest is None else lowest[1]


def read_pieces(told: bytes) -> list[bytes]:
    """Return the word pieces of a tokenizer file: each behind its length, in one byte or two."""
    pieces: list[bytes] = []
    at = 0
    while at < len(told):
        length = told[at]
        at += 1
        if length >= 128:
            length += 128 * told[at] - 128
            at += 1
        pieces.append(told[at : at + length])
        at += length
    return pieces
