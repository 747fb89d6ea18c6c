"""Where the teacher's name of a step begins and ends: "push in", "take hold", "pick it up".

Names of steps are verbs with what belongs to them. A particle behind one is part of the name
unless a verb of the sentence takes it: "leave watering out" leaves out, "split lift off" is
about lifting off.
"""

from __future__ import annotations

from collections.abc import Iterator

from assistant.language.frames import Frames, Span
from assistant.language.words import Words

_LONGEST_TAKEN = 3
"""Words of a verb and what it takes before its particle: "put the pot | down"."""


def widened(run: Span, words: Words, used: set[int], known: Frames) -> Span:
    """Return a stretch with the little words at its ends that belong to the name."""
    start, end = run
    end = _with_pronoun(start, end, words, used, known)
    while end < len(words) and is_particle(end, start, words, known) and _ends(end, words, known):
        end += 1
    if start and _led(start, end, words, used, known):
        start -= 1
    return start, end


def lone(words: Words, known: Frames) -> Iterator[Span]:
    """Yield light verbs that stand alone where a name does: "take and carry", "before go"."""
    small = known.small
    for at, word in enumerate(words):
        if word.text not in small("light"):
            continue
        after = words[at + 1] if at + 1 < len(words) else None
        ends = after is None or after.broken or after.text in small("verbs") | small("joints")
        begins = at == 0 or words[at - 1].text in small("leads")
        if ends and begins and len(words) > 1:
            yield at, at + 1


def is_particle(at: int, start: int, words: Words, known: Frames) -> bool:
    """Tell a particle that belongs to the name begun at `start`, not to a verb before it."""
    text = words[at].text
    if words[at].broken or text not in known.small("particles"):
        return False
    parted = known.small("parted")
    before = {word.text for word in words[:start]}
    return not any(f"{verb} {text}" in parted for verb in before)


def is_cut_short(start: int, end: int, words: Words, known: Frames) -> bool:
    """Tell "pick it" and "put pot" where "up" and "down" follow: they belong to the name."""
    if not start or end - start < 2 or end >= len(words) or words[end].broken:
        return False
    if words[end].text not in known.small("particles") or not _ends(end, words, known):
        return False
    if words[end - 1].text in known.small("taken"):
        return True
    taking = words[start].text in known.small("taking") and end - start <= _LONGEST_TAKEN
    before = {word.text for word in words[:start]}
    return taking and not any(f"{one} {words[end].text}" in known.small("parted") for one in before)


def _ends(at: int, words: Words, known: Frames) -> bool:
    """Tell whether no noun follows a particle: then it would lead to a place."""
    after = words[at + 1] if at + 1 < len(words) else None
    if after is None or after.broken:
        return True
    return not after.text[:1].isdigit() and after.text not in known.small("determiners")


def _with_pronoun(start: int, end: int, words: Words, used: set[int], known: Frames) -> int:
    """Return the end of "pick it" in "pick it up": a pronoun the verb of the name takes."""
    if end >= len(words) or words[end].broken or words[end].text not in known.small("taken"):
        return end
    verb = words[end - 1].text
    after = words[end + 1].text if end + 1 < len(words) and not words[end + 1].broken else ""
    if end - start != 1 or (start and words[start - 1].text in known.small("subjects")):
        return end
    if after in known.small("particles"):
        return end + 2
    doing = verb.endswith(known.name_endings) if known.name_endings else False
    done = not after or end + 1 in used or after in known.small("verbs") | known.small("joints")
    return end + 1 if done and not doing else end


def _led(start: int, end: int, words: Words, used: set[int], known: Frames) -> bool:
    """Tell whether "take" before "hold" begins the name, and is no verb of the sentence."""
    light = words[start - 1]
    if light.text not in known.small("light") or words[start].broken:
        return False
    if start == 1:
        return end < len(words) and words[end].text in known.small("verbs")
    lead = words[start - 2].text
    if lead in known.small("to"):
        return start - 2 in used and words[start - 3].text not in known.small("wanting")
    return lead in known.small("leads")
