"""Made and mutated utterances: nothing raises, stops falsely, or acts on unknown.

run: python -m tests.benchmarks.bench_language_fuzz [COUNT]
"""

from __future__ import annotations

import random
import string
import sys
import time
from dataclasses import replace

from assistant.language.phrasebook import phrasebook
from assistant.language.stopping import has_stop_word
from assistant.language.understanding import understand
from assistant.model.listening import Listening
from assistant.model.teacher_acts import ASKED, STAGES, Stop, Unknown
from tests.benchmarks.bench_language import rows

SURE = 0.85


def made(rng: random.Random, texts: list[str], vocabulary: list[str]) -> str:
    """Return an utterance: mutated, spliced, made of vocabulary, or of any characters."""
    kind = rng.random()
    if kind < 0.45:
        return mutated(rng, rng.choice(texts))
    if kind < 0.6:
        joint = rng.choice(["and", ",", "", "then", "no wait"])
        return f"{rng.choice(texts)} {joint} {rng.choice(texts)}"
    if kind < 0.85:
        return " ".join(rng.choices(vocabulary, k=rng.randint(1, 9)))
    letters = string.printable + "äöüß€\u201c\u2019…\u2014½²\ufb01日本語\u0000\ud7ff😀"
    return "".join(rng.choices(letters, k=rng.randint(0, 60)))


def mutated(rng: random.Random, text: str) -> str:
    """Return the text with a few letters dropped, doubled, swapped or changed."""
    chars = list(text)
    for _ in range(rng.randint(1, 4)):
        at = rng.randrange(len(chars)) if chars else 0
        way = rng.random()
        if not chars or way < 0.25:
            chars.insert(at, rng.choice(string.ascii_lowercase + " ,.!"))
        elif way < 0.5:
            del chars[at]
        elif way < 0.75 and at + 1 < len(chars):
            chars[at], chars[at + 1] = chars[at + 1], chars[at]
        else:
            chars[at] = rng.choice(string.ascii_lowercase)
    return "".join(chars)


def main() -> None:
    """Run the count given, 100,000 by default, and print what went wrong."""
    count = int(sys.argv[1]) if len(sys.argv) > 1 else 100_000
    rng = random.Random(7)
    texts = [row.text for file in ("tuning.yaml", "tuning4.yaml") for row in rows(file)]
    vocabulary = sorted(phrasebook().vocabulary)
    names = ("pick up object", "approach object", "move up object", "place object")
    raised: list[str] = []
    stopped: list[str] = []
    missed: list[str] = []
    mixed: list[str] = []
    began = time.perf_counter()
    for _ in range(count):
        text = made(rng, texts, vocabulary)
        listening = Listening(
            stage=rng.choice(STAGES),
            asked=rng.choice((None, *ASKED)),
            subtasks=names if rng.random() < 0.5 else (),
            objects=("block", "target") if rng.random() < 0.5 else (),
        )
        try:
            meant = understand(text, listening)
            moving = understand(f"{text} stop", replace(listening, moving=True))
        except Exception as error:
            raised.append(f"{text!r}: {error!r}")
            continue
        if moving.acts != (Stop(),):
            missed.append(text)
        stops = any(isinstance(act, Stop) for act in meant.acts)
        if stops and meant.confidence >= SURE and not has_stop_word(text):
            stopped.append(text)
        if any(isinstance(act, Unknown) for act in meant.acts) and len(meant.acts) > 1:
            mixed.append(text)
    took = time.perf_counter() - began
    print(f"{count} utterances in {took:.0f} s ({took / count * 1e3:.2f} ms each)")
    for name, found in (
        ("raised", raised),
        ("stopped without a stop word", stopped),
        ("stop missed while moving", missed),
        ("acted on unknown", mixed),
    ):
        print(f"{name}: {len(found)} {found[:5]}")


if __name__ == "__main__":
    main()
