"""Files made to break the reader are refused with their line, quickly and without harm."""

from __future__ import annotations

import contextlib
import os
from pathlib import Path

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from assistant.errors import BadInput
from assistant.plain_yaml import read_file, read_text, text_of

BOMB = "a: &a [x, x, x, x, x, x, x, x, x, x]\n" + "".join(
    f"{name}: &{name} [{', '.join([f'*{before}'] * 10)}]\n"
    for before, name in zip("abcdefghi", "bcdefghij", strict=True)
)


@pytest.mark.parametrize(
    ("text", "line", "told"),
    [
        ("a: 1\nb: 2\na: 3\n", 3, "'a' stands here again (first on line 1)"),
        ("a: {b: 1,\n b: 2}\n", 2, "'b' stands here again"),
        ("a: !!python/object/apply:os.system [x]\n", 1, "is not allowed"),
        ("a: !mine x\n", 1, "tag '!mine' is not allowed"),
        ("a:\n  - b\n c: d\n", 3, "not YAML"),
        ("a: 'never closed\n", 1, "close the quotes"),
        ("a: b: c\n", 1, "put text that contains ': ' in quotes"),
        ("a:\n\tb: 1\n", 2, "indent with spaces"),
        ("a: [1, 2\nb: 3\n", 2, "close the bracket"),
        ("? [a, b]\n: c\n", 1, "a key must be a word"),
        ("a: &x [*x]\n", 1, "names nothing that is complete above"),
        ("a: *y\n", 1, "names nothing that is complete above"),
        ("a: &x 1\n? *x\n: 2\n", 2, "a key must be a word"),
        ("[" * 70, 1, "nested deeper than 64 levels"),
        ("[" * 300_000, 1, "nested deeper than 64 levels"),
        ("{a: " * 100_000, 1, "nested deeper than 64 levels"),
        ("- " * 100_000, 1, "nested deeper than 64 levels"),
        ("a: b\x07c\n", 1, "does not belong into text"),
        (BOMB, 6, "more than 2,000,000 values"),
    ],
)
def test_refused_with_its_line(text: str, line: int, told: str) -> None:
    with pytest.raises(BadInput) as caught:
        read_text(text, "bad.yaml")
    first = caught.value.problems[0]
    assert first.where == f"bad.yaml:{line}"
    assert told in str(first)


def test_all_repeated_keys_and_tags_are_told_at_once() -> None:
    with pytest.raises(BadInput) as caught:
        read_text("a: 1\na: 2\nb: !x 3\nb: 4\n")
    assert len(caught.value.problems) == 3


def test_aliases_that_stay_small_are_read() -> None:
    (document,) = read_text("a: &p [1, 2]\nb: *p\n")
    assert document.value == {"a": [1, 2], "b": [1, 2]}


def test_several_documents_keep_their_lines() -> None:
    first, second = read_text("a: 1\n---\nb:\n  - c: 2\n", "f")
    assert first.where(["a"]) == "f:1"
    assert second.where(["b", 0, "c"]) == "f:4"
    assert second.where(["b", 7]) == "f:3"


@settings(max_examples=300)
@given(st.text(alphabet="ab:-?*&!|>'\"#%@`[]{},\n\t 1.~<=", max_size=40))
def test_any_text_is_read_or_refused(text: str) -> None:
    with contextlib.suppress(BadInput):
        assert isinstance(read_text(text), tuple)


@pytest.mark.parametrize(
    ("data", "told"),
    [
        (b"\x89PNG\r\n\x1a\n\x00\x00\x00\rIHDR", "a binary file"),
        (b"a: 1\nb: caf\xe9\n", ":2: not UTF-8 text"),
    ],
)
def test_what_is_no_text(tmp_path: Path, data: bytes, told: str) -> None:
    path = tmp_path / "x.yaml"
    path.write_bytes(data)
    with pytest.raises(BadInput, match=told):
        read_file(path)


def test_a_file_of_100_megabytes_is_not_even_read(tmp_path: Path) -> None:
    path = tmp_path / "huge.yaml"
    with path.open("wb") as file:
        os.truncate(file.fileno(), 100_000_000)
    with pytest.raises(BadInput, match="100 MB, more than the 32 MB"):
        read_file(path)


def test_missing_files_and_folders_are_told(tmp_path: Path) -> None:
    with pytest.raises(BadInput, match="no such file"):
        read_file(tmp_path / "none.yaml")
    with pytest.raises(BadInput, match="this is a folder"):
        read_file(tmp_path)
    with pytest.raises(BadInput, match="cannot be read"):
        read_file(tmp_path / ("n" * 300))


def test_a_byte_order_mark_is_no_part_of_the_text(tmp_path: Path) -> None:
    path = tmp_path / "bom.yaml"
    path.write_bytes(b"\xef\xbb\xbfa: 1\n")
    assert read_file(path)[0].value == {"a": 1}


def test_a_pipe_without_end_is_cut_short() -> None:
    with pytest.raises(BadInput, match="more than the 0 MB a file may have"):
        text_of(Path("/dev/zero"), 1000)


def test_messages_stay_short_whatever_the_file_holds() -> None:
    long = "k" * 1000
    with pytest.raises(BadInput) as caught:
        read_text(f"{{{long}: 1, {long}: 2}}\nx: !{long} 3")
    assert len(str(caught.value)) < 600
