"""Sentences are understood one after another, whatever stands between them."""

from __future__ import annotations

import io
import json
from typing import Any

import pytest

from assistant.cli import main

GOOD = '{"text": "yes", "stage": "practice", "asked": "satisfied"}'


def understood(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str], *lines: str
) -> tuple[int, list[dict[str, Any]], str]:
    """Return the status, an answer a line, and the complaints."""
    monkeypatch.setattr("sys.stdin", io.StringIO("\n".join(lines)))
    status = main(["understand", "--json"])
    told = capsys.readouterr()
    return status, [json.loads(line) for line in told.out.splitlines()], told.err


@pytest.mark.parametrize(
    ("bad", "why"),
    [
        ("yes", "not JSON"),
        ("[" * 100_000, "not JSON"),
        ('"yes"', "no text"),
        ('{"text": 3}', "no text"),
        ('{"text": "yes", "stage": "bed"}', "unknown stage 'bed'"),
        ('{"text": "yes", "stage": ["practice"]}', "unknown stage"),
        ('{"text": "yes", "asked": "age"}', "unknown question 'age'"),
    ],
)
def test_a_bad_line_is_told_and_the_others_are_understood(
    bad: str, why: str, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    status, answers, err = understood(monkeypatch, capsys, GOOD, "", bad, GOOD)
    assert status == 2
    assert [one["acts"][0]["act"] for one in answers] == ["affirm", "unknown", "affirm"]
    assert answers[1]["confidence"] == 0.0
    assert err.startswith(f"<stdin>:3: {why}")
    assert err == f"{answers[1]['why']}\n"


def test_every_text_is_answered(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    odd = ["", "\ud800 no", "n\x00o", "größer", "日本", "no" * 500]
    lines = [json.dumps({"text": text}) for text in odd]
    status, answers, err = understood(monkeypatch, capsys, "\ufeff" + lines[0], *lines[1:])
    assert (status, err) == (0, "")
    assert len(answers) == len(odd)
    assert answers[3]["heard"] == "größer"


def test_no_input_is_no_line(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    assert understood(monkeypatch, capsys) == (0, [], "")


def test_a_language_nobody_knows_is_told_once(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setattr("sys.stdin", io.StringIO(f"{GOOD}\n{GOOD}\n"))
    assert main(["understand", "--language", "fr"]) == 2
    assert capsys.readouterr().err == "language: unknown language 'fr'; english or german\n"
