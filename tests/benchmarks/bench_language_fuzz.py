"""Made and mutated utterances: nothing raises, stops falsely, or acts on unknown.

Each is understood at a made-up place of the conversation, and heard by a dialogue that stands
somewhere in a lesson: words that were not understood surely must start no motion there.

run: python -m tests.benchmarks.bench_language_fuzz [COUNT] [SEED]
"""

from __future__ import annotations

import random
import string
import sys
import time
from collections import defaultdict
from collections.abc import Mapping
from dataclasses import replace

from assistant.dialogue import effects as fx
from assistant.dialogue import events as ev
from assistant.dialogue.machine import step
from assistant.dialogue.state import Dialogue
from assistant.language.phrasebook import phrasebook
from assistant.language.stopping import has_stop_word
from assistant.language.understanding import understand
from assistant.model import teacher_acts as acts
from assistant.model.lesson import Question
from assistant.model.listening import Listening, Understanding
from assistant.session.meaning import meant
from tests.benchmarks.bench_language import rows
from tests.dialogue.teaching import Lessons

SURE = 0.85
MOTION = (fx.Move, fx.GoOn, fx.Replay, fx.SetHand, fx.Jog, fx.Home, fx.Record)
Found = dict[str, list[str]]


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


def places() -> Mapping[str, Dialogue]:
    """Return dialogues that stand at different places of one lesson."""
    lessons = {
        "naming": Lessons().open(),
        "planned": Lessons().introduce(),
        "awaiting": Lessons().confirmed(),
        "watching": Lessons().confirmed().hear(acts.Start()),
        "reviewing": Lessons().learned(),
        "asking": Lessons().learned(Question("confirm_segmentation", "grasp object", "unsure")),
        "ready": Lessons().ready(),
        "moving": Lessons().ready().moving().report("primitive", 1),
        "paused": Lessons().ready().moving().report("primitive", 1).hear(acts.Pause()),
        "stopped": Lessons().ready().moving().report("primitive", 1).hear(acts.Stop()),
        "ran": Lessons().ready().run(),
        "agreed": Lessons().agreed(),
    }
    return {name: lesson.dialogue for name, lesson in lessons.items()}


def begins_motion(after: Dialogue, effects: tuple[fx.Effect, ...]) -> bool:
    """Whether something is set moving, or will be once its check is over."""
    looking = after.run is not None and after.run.purpose in ("look", "dry")
    checked = any(isinstance(one, fx.Check) for one in effects) and not looking
    return checked or any(isinstance(one, MOTION) for one in effects)


def understood(rng: random.Random, text: str, found: Found) -> Understanding:
    """Look at what a text means at a made-up place, at rest and while the arm moves."""
    names = ("pick up object", "approach object", "move up object", "place object")
    listening = Listening(
        stage=rng.choice(acts.STAGES),
        asked=rng.choice((None, *acts.ASKED)),
        subtasks=names if rng.random() < 0.5 else (),
        objects=("block", "target") if rng.random() < 0.5 else (),
    )
    at_rest = understand(text, listening)
    moving = understand(f"{text} stop", replace(listening, moving=True))
    if moving.acts != (acts.Stop(),):
        found["stop missed while moving"].append(text)
    stops = any(isinstance(act, acts.Stop) for act in at_rest.acts)
    if stops and at_rest.confidence >= SURE and not has_stop_word(text):
        found["stopped without a stop word"].append(text)
    if any(isinstance(act, acts.Unknown) for act in at_rest.acts) and len(at_rest.acts) > 1:
        found["acted on unknown"].append(text)
    return at_rest


def heard(where: str, dialogue: Dialogue, text: str, found: Found) -> None:
    """Look at what a dialogue does with a text, or with one that ends in a stop word."""
    meaning = meant(dialogue, text, 1.0, "english")
    after, effects = step(dialogue, ev.Heard(text, meaning))
    unknown = all(isinstance(act, acts.Unknown) for act in meaning.acts)
    if begins_motion(after, effects) and (unknown or meaning.confidence < SURE):
        kind = "moved on unknown" if unknown else "moved though unsure"
        found[kind].append(f"{where}: {text!r} {meaning.confidence:.2f} {meaning.acts}")
    if not dialogue.in_motion:
        return
    told = f"{text} stop"
    stopping = step(dialogue, ev.Heard(told, meant(dialogue, told, 1.0, "english")))[1]
    if not any(isinstance(one, fx.Halt) for one in stopping):
        found["stop missed by the dialogue"].append(f"{where}: {text!r}")


def main() -> None:
    """Run the count given, 100,000 by default, and print what went wrong."""
    count = int(sys.argv[1]) if len(sys.argv) > 1 else 100_000
    seed = int(sys.argv[2]) if len(sys.argv) > 2 else 7
    rng = random.Random(seed)
    texts = [row.text for file in ("tuning.yaml", "tuning4.yaml") for row in rows(file)]
    vocabulary = sorted(phrasebook().vocabulary)
    stands = list(places().items())
    kinds = (
        *("raised", "stopped without a stop word", "stop missed while moving"),
        *("acted on unknown", "moved on unknown", "moved though unsure"),
        "stop missed by the dialogue",
    )
    found: Found = defaultdict(list, {kind: [] for kind in kinds})
    began = time.perf_counter()
    for _ in range(count):
        text = made(rng, texts, vocabulary)
        where, dialogue = rng.choice(stands)
        try:
            understood(rng, text, found)
            heard(where, dialogue, text, found)
        except Exception as error:
            found["raised"].append(f"{text!r}: {error!r}")
    took = time.perf_counter() - began
    print(f"{count} utterances, seed {seed}, in {took:.0f} s ({took / count * 1e3:.2f} ms each)")
    for kind, texts_found in found.items():
        print(f"{kind}: {len(texts_found)}", *texts_found[:12], sep="\n  ")


if __name__ == "__main__":
    main()
