"""How well teachers are understood: acts and slots right, and how often sure and wrong.

Every corpus of the repository was tuned on after a first look at it: what it shows is that
nothing was lost. Figures of sentences nobody tuned on come from a file kept apart.

run: python -m tests.benchmarks.bench_language [--show] [NAME or FILE.yaml ...]
"""

from __future__ import annotations

import math
import re
import statistics
import sys
import time
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any, cast

from assistant.language.phrasebook import phrasebook
from assistant.language.understanding import understand
from assistant.model.listening import Listening
from assistant.model.teacher_acts import Asked, Stage, act_to_json
from assistant.plain_yaml import read_file

CORPUS = Path(__file__).parents[1] / "language" / "corpus"
STAGES: dict[str, Stage] = {
    "i": "introduction",
    "d": "demonstration",
    "l": "learning",
    "p": "practice",
}
FILES = (
    *("tuning", *(f"tuning{number}" for number in range(2, 13))),
    *("stress1", "stress2", "ways"),
)
FRESH = tuple(f"talk{number}" for number in range(1, 23))
"""Written from the contract alone, by speakers who knew nothing of the rules."""
SURE = 0.85
_ANY = "*"
_ARTICLE = re.compile(r"^(the|a|an|der|die|das|den|dem|ein|eine|einen|einem) ")


@dataclass(frozen=True, slots=True)
class Row:
    """A sentence of a speaker with what it means."""

    speaker: str
    text: str
    listening: Listening
    acts: list[dict[str, Any]]


def rows(file: str) -> Iterator[Row]:
    """Read the sentences of a corpus file, or of any file named by its whole path."""
    speakers = cast("Mapping[str, str]", read_file(CORPUS / file)[0].value)
    for speaker, lines in speakers.items():
        for line in lines.splitlines():
            text, stage, asked, acts = (part.strip() for part in line.rsplit("|", 3))
            where = Listening(stage=STAGES[stage], asked=cast("Asked", asked or None))
            yield Row(speaker, text, where, [act_of(part) for part in acts.split(" ; ")])


def act_of(told: str) -> dict[str, Any]:
    """Return an act as a line of a corpus tells it."""
    name, _, slots = told.strip().partition(" ")
    act: dict[str, Any] = {"act": name}
    for slot in filter(None, slots.split(" & ")):
        key, _, value = slot.strip().partition("=")
        if key.startswith("where."):
            act.setdefault("where", {})[key.removeprefix("where.")] = value
        else:
            act[key] = _value(name, key, value)
    return act


def _value(act: str, key: str, value: str) -> Any:
    listed = key in ("position_mm", "rpy_deg", "by_mm", "subtasks")
    if listed or (act == "inform" and "," in value):
        return [_scalar(part.strip()) for part in value.split(",") if part.strip()]
    return _scalar(value)


def _scalar(text: str) -> Any:
    try:
        return float(text) if "." in text or text.lstrip("-").isdigit() else text
    except ValueError:
        return text


def same(expected: list[dict[str, Any]], got: list[dict[str, Any]]) -> bool:
    """Tell whether acts and slots are the same, numbers nearly; reasons need not match.

    A slot that is told as ``*`` may hold any text; articles in front of a name do not count.
    """
    if len(expected) != len(got):
        return False
    return all(_alike(a, b) for a, b in zip(expected, got, strict=True))


def _alike(a: Any, b: Any) -> bool:
    if isinstance(a, dict) and isinstance(b, dict):
        if a.get("act") == b.get("act") == "explain":
            return True
        a, b = ({key: one for key, one in told.items() if one not in ([], "")} for told in (a, b))
        return a.keys() == b.keys() and all(_alike(a[key], b[key]) for key in a)
    if a == _ANY:
        return isinstance(b, str)
    if isinstance(a, list) and isinstance(b, str):
        return _letters(", ".join(map(str, a))) == _letters(b)
    if isinstance(a, list) or isinstance(b, list):
        a, b = (one if isinstance(one, list) else [one] for one in (a, b))
        return len(a) == len(b) and all(_alike(x, y) for x, y in zip(a, b, strict=True))
    if isinstance(a, float) and isinstance(b, int | float):
        return abs(a - b) <= 1e-6 * max(1.0, abs(a))
    return _letters(str(a)) == _letters(str(b))


def _letters(text: str) -> str:
    """Return a text as it is compared: how it is written in capitals and commas is no meaning."""
    plain = " ".join(re.sub(r"[,;:.!?]+(?=\s|$)", " ", text).lower().split())
    return _ARTICLE.sub("", plain)


def interval(count: int, total: int) -> tuple[float, float]:
    """Return the 95 % interval (Wilson) of a share."""
    z, share = 1.96, count / total
    middle = (share + z * z / (2 * total)) / (1 + z * z / total)
    half = z * math.sqrt(share * (1 - share) / total + z * z / (4 * total**2)) / (1 + z * z / total)
    return max(0.0, middle - half), min(1.0, middle + half)


def report(name: str, file: str, *, show: bool) -> None:
    """Print one line for a half of the corpus, and what was misunderstood."""
    right = sure = wrong_sure = total = 0
    took: list[float] = []
    for row in rows(file):
        began = time.perf_counter()
        meant = understand(row.text, row.listening)
        took.append(time.perf_counter() - began)
        got = [act_to_json(act) for act in meant.acts]
        good = same(row.acts, got)
        total += 1
        right += good
        sure += meant.confidence >= SURE
        wrong_sure += meant.confidence >= SURE and not good
        if show and not good:
            print(
                f"  {row.speaker}: {row.text!r} [{row.listening.stage[:5]} {row.listening.asked}]"
            )
            print(f"     want {row.acts}\n     got  {got} {meant.confidence}")
    took.sort()
    p95 = took[int(0.95 * len(took))] * 1e3
    median = statistics.median(took) * 1e3
    print(
        f"{name:<8} n={total:<4} right {right / total:.3f} ({_told(right, total)})"
        f"  wrong and sure {wrong_sure / total:.4f} ({_told(wrong_sure, total)})"
        f"  sure {sure / total:.2f}  median {median:.2f} ms  p95 {p95:.1f} ms"
    )


def _told(count: int, total: int) -> str:
    low, high = interval(count, total)
    return f"{low:.3f}..{high:.3f}"


def main() -> None:
    """Print loading time and both halves."""
    show = "--show" in sys.argv
    began = time.perf_counter()
    phrasebook()
    print(f"loading {time.perf_counter() - began:.2f} s")
    for name in [one for one in sys.argv[1:] if not one.startswith("-")] or FILES:
        file = name if name.endswith(".yaml") else f"{name}.yaml"
        report(Path(name).stem, file, show=show)


if __name__ == "__main__":
    main()
