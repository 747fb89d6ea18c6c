"""Count which words teachers say in a row, for hearing them, and print how well that tells.

The files that spoken sentences are reported on are never counted, and those that thresholds are
chosen on can be withheld too.

run: python -m tests.benchmarks.fit_wording [--write] [CORPUS to withhold ...]
"""

from __future__ import annotations

import sys
from collections.abc import Iterable, Iterator
from math import exp
from pathlib import Path

import numpy as np

from assistant.shells.voice import wording
from assistant.shells.voice.recognized import plain_words
from tests.benchmarks.bench_language import rows
from tests.benchmarks.voice_clips import FILES

TEACHERS = (
    *("tuning", "tuning2", "tuning3", "tuning4", "tuning7", "tuning8", "tuning9", "tuning10"),
    *("tuning11", "talk1", "talk2", "talk3", "talk4", "talk5", "talk6", "talk7", "talk8"),
    *("talk_held", "stress1", "stress2", "ways"),
)
REPORTED = FILES["reported"]


def said(files: Iterable[str]) -> Iterator[str]:
    """Yield what teachers say to the robot, in plain words."""
    for file in files:
        for row in rows(f"{file}.yaml"):
            if row.acts and row.acts[0]["act"] != "unknown":
                yield plain_words(row.text)


def main() -> None:
    """Count, print how puzzled the model is by the reported files, and write if asked."""
    withheld = {*REPORTED, *(name for name in sys.argv[1:] if name != "--write")}
    told = wording.counted(said(name for name in TEACHERS if name not in withheld))
    likely, words = 0.0, 0
    for text in said(REPORTED):
        likely += told.likelihood(text)
        words += len(text.split()) + 1
    print(f"{len(told.words)} words, {len(told.keys[-1])} triples; perplexity of sentences that")
    print(f"were not counted: {exp(-likely / words):.0f}")
    if "--write" in sys.argv:
        path = Path(wording.__file__).with_name("wording.npz")
        np.savez_compressed(path, allow_pickle=False, **wording.arrays(told))
        print(f"written: {path.stat().st_size} bytes")


if __name__ == "__main__":
    main()
