"""What synthesized and recorded teachers say in the voice benchmarks, and what it means.

Sentences come from the language corpus (those whose text is understood; typing slips left out).
The signal-to-noise ratio counts the stretches in which somebody speaks.
"""

from __future__ import annotations

import hashlib
import random
import re
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

from assistant.language.understanding import understand
from assistant.model.listening import Listening
from assistant.model.teacher_acts import Asked, act_to_json
from assistant.shells.voice.deciding import SURE, is_unknown
from assistant.shells.voice.phonemes import is_word
from assistant.shells.voice.sound import Samples, read_sound
from tests.benchmarks.bench_language import rows, same
from tests.benchmarks.voices import NOISES, Speaker, noise, noisy, placed, speakers, spoken

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
    sure: float = SURE


def sayable(text: str) -> bool:
    """Tell whether a line could have been spoken: words of a dictionary, no signs."""
    words = re.findall(r"[a-z0-9']+", text.lower())
    odd = any(sign in "<>@#_/+()[]{}%$;" for sign in text)
    return (
        not odd
        and len(words) <= MOST_WORDS
        and all(word.isdigit() or is_word(word) for word in words)
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


def sentences(group: str, count: int, folder: Path) -> Iterator[Clip]:
    """Yield sentences of a group's speakers, in silence and in noise."""
    known = speakers(group)
    for at, (text, listening, acts) in enumerate(lines(group, count)):
        speaker = known[at % len(known)]
        for kind, samples in in_rooms(speaker, text, group, folder):
            yield Clip(f"sentence {kind}", speaker.engine, text, listening, acts, samples)


def words(group: str, count: int, folder: Path) -> Iterator[Clip]:
    """Yield words alone, each by so many speakers, in silence and in noise."""
    known = speakers(group)
    for at, word in enumerate(word for word in WORDS for _ in range(count)):
        speaker = known[at % len(known)]
        listening, acts, sure = word_meaning(word)
        for kind, samples in in_rooms(speaker, word, group, folder):
            yield Clip(f"word {kind}", speaker.engine, word, listening, acts, samples, sure)


def word_meaning(word: str) -> tuple[Listening, list[dict[str, Any]], float]:
    """Return where a word alone is said, what it means there, and how surely when typed."""
    asked: Asked | None = "satisfied" if word in ("yes", "no") else None
    listening = Listening(stage="practice", asked=asked)
    meant = understand(word, listening)
    return listening, [act_to_json(act) for act in meant.acts], min(SURE, meant.confidence)


def chat(group: str, count: int, folder: Path) -> Iterator[Clip]:
    """Yield sentences that have nothing to do with robots."""
    known = speakers(group)
    for at, text in enumerate(CHAT[:count]):
        speaker = known[at % len(known)]
        _, samples = next(in_rooms(speaker, text, group, folder))
        yield Clip("chat", speaker.engine, text, PRACTICE, [], samples)


def in_rooms(
    speaker: Speaker, text: str, group: str, folder: Path
) -> Iterator[tuple[str, Samples]]:
    """Yield what is said in silence, then in one of the group's noises at 20 and 10 dB."""
    seed = int(hashlib.sha256(f"{speaker.name}{text}".encode()).hexdigest()[:8], 16)
    rng = np.random.default_rng(seed)
    clip = placed(spoken(speaker, text, folder), rng)
    yield "clean", clip
    kind = NOISES[group][int(rng.integers(len(NOISES[group])))]
    for snr_db in (20, 10):
        yield f"{snr_db} dB {kind}", noisy(clip, noise(kind, len(clip), rng, folder), snr_db)


def people(folder: Path, count: int) -> Iterator[Clip]:
    """Yield recorded speech that has nothing to do with robots."""
    files = recordings(folder)
    for path in random.Random(1).sample(files, min(count, len(files))):
        yield Clip("people's chat", "people", path.name, PRACTICE, [], read_sound(path).samples)


def people_words(folder: Path) -> Iterator[Clip]:
    """Yield words recorded alone; the file, or else its folder, is named by the word."""
    for path in recordings(folder):
        named = [name for name in (path.stem, path.parent.name) if name in WORDS]
        if named:
            listening, acts, sure = word_meaning(named[0])
            samples = read_sound(path).samples
            yield Clip("people's word", "people", named[0], listening, acts, samples, sure)


def recordings(folder: Path) -> list[Path]:
    """Return the sound files in a folder and below."""
    return sorted(path for end in ("wav", "flac", "ogg") for path in folder.rglob(f"*.{end}"))
