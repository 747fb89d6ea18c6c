"""Text is cut into the pieces a recognizer reads, and comes back as it was."""

from __future__ import annotations

import pytest

from assistant.shells.voice.moonshine import packaged_moonshine
from assistant.shells.voice.pieces import SPACE, Pieces, read_pieces


def test_pieces_are_read_with_lengths_of_one_byte_or_two() -> None:
    long = b"a" * 300
    told = b"\x02ab" + bytes((128 + 300 % 128, 300 // 128)) + long + b"\x00\x01c"
    assert read_pieces(told) == [b"ab", long, b"", b"c"]


def _file(*pieces: str) -> bytes:
    return b"".join(bytes((len(one.encode()),)) + one.encode() for one in pieces)


def test_the_piece_of_the_lowest_number_is_joined_first() -> None:
    pieces = Pieces(_file("a", "b", "c", SPACE, "bc", "ab", f"{SPACE}a"))
    assert pieces.cut("abc") == (6, 4)
    assert pieces.written(pieces.cut("abc")) == " abc"


def test_of_two_pieces_alike_the_later_is_read() -> None:
    # A tokenizer's first pieces are single bytes, of which it reads none that are letters too.
    assert Pieces(_file(".", SPACE, "a", ".")).cut("a.") == (1, 2, 3)


@pytest.mark.voice
@pytest.mark.parametrize("text", ["Move it 2 cm to the left.", "That's wrong.", "Stop."])
def test_what_was_cut_is_written_as_it_was(text: str) -> None:
    folder = packaged_moonshine()
    assert folder is not None
    pieces = Pieces((folder / "tokenizer.bin").read_bytes())
    assert pieces.written(pieces.cut(text)).strip() == text
