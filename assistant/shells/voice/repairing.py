"""What may have been said where a reading is nearly a sentence of the phrasebook's words.

A recognizer writes the words it knows best: "close the director" for "close the gripper". Each
stretch of a reading is compared by sound with the words and short commands a teacher uses, and
replaced by those nearest to it. Whether such a sentence means anything, and how well it explains
the sound, is asked afterwards: nothing is acted on because it merely sounds alike.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from functools import cache

from rapidfuzz import process
from rapidfuzz.distance import Levenshtein

from assistant.language.hints import hints
from assistant.language.phrasebook import phrasebook
from assistant.shells.voice.phonemes import distance, is_word, phonemes
from assistant.shells.voice.phrasebank import letters, short_commands

LONGEST_STRETCH = 2
"""Words that are replaced together: "goes lower" by "go slower"."""
MOST_WORDS = 12
NEAREST = 5
LIKE_LETTERS, ALIKE = 0.5, 0.5
WORK_ALIKE = 0.6
"""Words of the work are tried where they sound less alike: most sentences hold one."""
WORK = (
    "gripper", "hand", "block", "target", "object", "cup", "table", "step", "task", "tree", "left",
    "right", "up", "down", "forward", "backward", "back", "front", "faster", "slower", "more",
    "less", "bit", "robot", "arm", "demonstration", "setup", "speed", "two", "three",
)  # fmt: skip
CHANGED = 0.34
"""At most this share of a reading's sounds is replaced: the rest was heard as it was said."""

WAYS = ("left", "right", "up", "down", "forward", "back", "lower", "higher", "slower", "faster")
GOING = tuple(f"{verb} {way}" for verb in ("go", "move") for way in WAYS)
AMOUNTS = ("a bit", "a little", "a lot")

_MEASURE = r"(?=(?:and (?:a|one) half|centim\w+|millim\w+|degrees?|inch\w*|mm|cm|met(?:er|re)s)\b)"
_COUNTS = (("two", rf"\b(?:to|too) {_MEASURE}"), ("four", rf"\b(?:for|fore) {_MEASURE}"))


_MORE_ACTIONS = frozenset(("pick", "place", "put", "pour", "insert", "wipe", "press", "stack"))
_NEVER_FIRST = frozenset(("back", "let", "get", "go", "come", "open", "close", "lower"))
"""Where they follow another action's word they mostly belong to it: "move back"."""
_ARTICLES = frozenset(("the", "a"))
"""A recognizer hears them in the breath before a word."""
_INTRODUCING = frozenset(("the", "a", "to", "of", "for"))


def written(heard: str, asked: str | None = None, language: str = "english") -> str:
    """Return a reading as it is written: "up two centimeters" for "to", lists with commas.

    A step's name has no article before its action.

    Parameters
    ----------
    heard : str
    asked : str, optional
        What the robot asked.
    language : str
    """
    if language != "english":
        return heard
    for number, pattern in _COUNTS:
        heard = re.sub(pattern, f"{number} ", heard)
    if asked == "subtask_name":
        return _without_article(heard)
    return _listed(heard) if asked == "actions" else heard


def _without_article(heard: str) -> str:
    """Return a step's name without an article before its action: "the approach object"."""
    first, _, name = heard.partition(" ")
    action, _, thing = name.partition(" ")
    return name if first in _ARTICLES and thing and action in _actions() else heard


def _listed(heard: str) -> str:
    """Return actions said one after another with commas: "approach, grasp, lift"."""
    words = heard.split()
    known = _actions()
    before = ("", *words)
    starts = [
        at for at, word in enumerate(words) if word in known and before[at] not in _INTRODUCING
    ]
    if len(starts) < 2 or starts[0] > 0 or {"and", "then"} & set(words):
        return heard
    parts = zip(starts, (*starts[1:], len(words)), strict=True)
    return ", ".join(" ".join(words[first:last]) for first, last in parts)


@cache
def _actions() -> frozenset[str]:
    """Return the words actions begin with."""
    told = (phrase for entry in hints("actions", "english") for phrase in entry["phrases"])
    return frozenset(phrase.split()[0] for phrase in told) - _NEVER_FIRST | _MORE_ACTIONS


def repaired(heard: str, names: Sequence[str] = (), language: str = "english") -> tuple[str, ...]:
    """Return a reading with one stretch replaced by words that sound like it, the nearest first.

    Parameters
    ----------
    heard : str
    names : sequence of str
        Of the task's things and steps, beside the phrasebook's words.
    language : str
    """
    words = heard.split()
    if not 0 < len(words) <= MOST_WORDS:
        return ()
    room = CHANGED * len(phonemes(heard))
    found = sorted(_replaced(words, room, _units(tuple(names), language)))
    return tuple(dict.fromkeys(text for _, text in found))


def _replaced(
    words: Sequence[str], room: float, units: tuple[tuple[str, ...], tuple[str, ...]]
) -> Iterator[tuple[float, str]]:
    """Yield how many sounds were changed, and what came of it."""
    phrases, sounds = units
    for first in range(len(words)):
        for last in range(first + 1, min(first + LONGEST_STRETCH, len(words)) + 1):
            stretch = " ".join(words[first:last])
            near = process.extract(
                letters(stretch),
                sounds,
                scorer=Levenshtein.normalized_similarity,
                score_cutoff=LIKE_LETTERS,
                limit=2 * NEAREST,
            )
            told = [(_changed(stretch, phrases[at], ALIKE), phrases[at]) for _, _, at in near]
            told += [(_changed(stretch, word, WORK_ALIKE), word) for word in WORK]
            close = sorted(one for one in told if one[1] != stretch and one[0] <= room)
            for changed, phrase in close[:NEAREST]:
                yield changed, " ".join((*words[:first], phrase, *words[last:]))


def _changed(stretch: str, phrase: str, most: float) -> float:
    """Return how many sounds of a stretch are changed; beyond all where it is not alike."""
    heard, meant = phonemes(stretch), phonemes(phrase)
    far = distance(heard, meant)
    return far * max(len(heard), len(meant)) if far <= most else float("inf")


@cache
def _units(names: tuple[str, ...], language: str) -> tuple[tuple[str, ...], tuple[str, ...]]:
    """Return words and short commands of the phrasebook, with names' words, and their sounds."""
    words = {word for word in phrasebook(language).vocabulary if is_word(word)}
    known = words.union(
        GOING, short_commands(language), (part for name in names for part in name.split())
    )
    phrases = tuple(sorted(known))
    return phrases, tuple(letters(phrase) for phrase in phrases)
