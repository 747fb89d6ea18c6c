"""Names as they are told by themselves: "the red cup" of a language that inflects its words.

Where a sentence bends a name ("bevor du festdrückst", "den roten Becher"), its own form is
found by the endings of the language's ``forms.yaml``; a language without that page bends none.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, fields, replace
from functools import cache
from typing import Any, cast

from assistant.language.lists import Phrase, longest_first, pairs, single
from assistant.language.little_words import folder_of
from assistant.language.parsing import Hearing
from assistant.language.words import Words
from assistant.model.teacher_acts import Inform, SetPose, TeacherAct, Where
from assistant.plain_yaml import read_file

_STEPS = frozenset(("subtask", "subtasks", "first", "second", "after", "before", "old"))
_THINGS = frozenset(("objects", "which", "body"))
_SHORTEST = 4


@dataclass(frozen=True, slots=True, eq=False)
class Forms:
    """How names are bent.

    Parameters
    ----------
    adjectives : mapping
        An article and the ending of an adjective behind it, with the ending without article.
    persons : frozenset of str
        Who does something: the last word of a step behind them is a bent verb.
    verbs, changed, done : mapping
        Endings of bent verbs, bent verbs and participles, with what they are of.
    running, led : tuple of phrases
        What stands behind and before a step's name and is no part of it.
    within, ending : str
        What a regular participle has within it, and at its end.
    owned : frozenset of str
        Articles behind which a name ends in `owned_ending`.
    """

    adjectives: Mapping[str, str]
    persons: frozenset[str]
    verbs: Mapping[str, str]
    changed: Mapping[str, str]
    done: Mapping[str, str]
    running: tuple[Phrase, ...]
    led: tuple[Phrase, ...]
    within: str
    ending: str
    owned: frozenset[str]
    owned_ending: str


@cache
def forms(language: str) -> Forms | None:
    """Return how a language bends names, read once; None if it does not."""
    path = folder_of(language) / "forms.yaml"
    if not path.exists():
        return None
    told = cast("dict[str, Any]", read_file(path)[0].value)
    return Forms(
        adjectives=dict(pairs(told["adjectives"])),
        persons=single(told["persons"]),
        verbs=dict(pairs(told["verbs"])),
        changed=dict(pairs(told["changed"])),
        done=dict(pairs(told["done"])),
        running=longest_first(told["running"]),
        led=longest_first(told["led"]),
        within=told["within"],
        ending=told["ending"],
        owned=single(told["owned"]),
        owned_ending=told["owned_ending"],
    )


def unbent(acts: tuple[TeacherAct, ...], words: Words, hearing: Hearing) -> tuple[TeacherAct, ...]:
    """Return the acts with names in their own form.

    Parameters
    ----------
    acts : tuple of TeacherAct
    words : tuple of Word
        The line they were read in.
    hearing : Hearing
    """
    known = forms(hearing.language)
    if known is None:
        return acts
    return tuple(_act(act, words, known, hearing) for act in acts)


def _act(act: TeacherAct, words: Words, known: Forms, hearing: Hearing) -> TeacherAct:
    if isinstance(act, Inform):
        if hearing.listening.asked not in _THINGS or isinstance(act.value, int):
            return act
        return replace(act, value=_each(act.value, lambda one: thing(one, words, known)))
    if isinstance(act, SetPose):
        return replace(act, object=thing(act.object, words, known))
    own = {*hearing.listening.subtasks}
    told: dict[str, Any] = {}
    for slot in fields(act):
        value = getattr(act, slot.name)
        if isinstance(value, Where) and value.subtask not in own:
            told[slot.name] = Where(step(value.subtask, words, known), value.when)
        elif slot.name in _STEPS and isinstance(value, str | tuple):
            told[slot.name] = _each(
                value, lambda one: one if one in own else step(one, words, known)
            )
    return replace(act, **told) if told else act


def _each(value: Any, change: Any) -> Any:
    return tuple(map(change, value)) if isinstance(value, tuple) else change(value)


def shortened(
    acts: tuple[TeacherAct, ...], whole: tuple[TeacherAct, ...], hearing: Hearing
) -> bool:
    """Tell a thing told by less than its whole name: "rote" of "der rote Becher"."""
    one, other = acts[0], whole[0]
    if forms(hearing.language) is None or not isinstance(one, SetPose):
        return False
    return isinstance(other, SetPose) and len(one.object.split()) < len(other.object.split())


def thing(name: str, words: Words, known: Forms) -> str:
    """Return the name of a thing as it is without its article: "roter becher"."""
    parts = name.split()
    place = next(_places(parts, words), None) if len(parts) > 1 else None
    if not place:
        return name
    article = words[place - 1].text
    for at, part in enumerate(parts[:-1]):
        for size in (2, 1):
            ending = known.adjectives.get(f"{article} {part[-size:]}")
            if ending is not None and len(part) - size > 1:
                parts[at] = part[:-size] + ending
                break
    return " ".join(parts)


def step(name: str, words: Words, known: Forms) -> str:
    """Return the name of a step without what says that it runs, its verb in the infinitive."""
    parts = _disowned(tuple(name.split()), words, known)
    bent = _told_of(parts, words, known)
    bare = _bare(parts, known)
    last = bare[-1] if bare else ""
    whole = _of_participle(last, known) if len(bare) < len(parts) else ""
    if not whole and bent and bare == parts:
        whole = infinitive(last, known)
    return " ".join((*bare[:-1], whole or last))


def _disowned(parts: Phrase, words: Words, known: Forms) -> Phrase:
    """Return a name that another owns without article and ending: "des transports"."""
    start = next(_places(parts, words), 0)
    owned = bool(parts) and parts[0] in known.owned
    if not owned and not (start and words[start - 1].said in known.owned):
        return parts
    bare = parts[owned:]
    if not bare or len(bare[-1]) <= _SHORTEST:
        return parts
    return (*bare[:-1], bare[-1].removesuffix(known.owned_ending))


def _told_of(parts: Sequence[str], words: Words, known: Forms) -> bool:
    """Tell whether somebody is told to do what the name says: "bevor du festdrückst"."""
    for start in _places(parts, words):
        led = start > 1 and (words[start - 1].text,) in known.led
        if words[start - 1 - led].text in known.persons:
            return True
    return False


def _bare(parts: Phrase, known: Forms) -> Phrase:
    behind = next((one for one in known.running if _ends(parts, one)), ())
    parts = parts[: len(parts) - len(behind)]
    ahead = next((one for one in known.led if _begins(parts, one)), ())
    return parts[len(ahead) :] if behind else parts


def _ends(parts: Phrase, phrase: Phrase) -> bool:
    return len(parts) > len(phrase) and parts[-len(phrase) :] == phrase


def _begins(parts: Phrase, phrase: Phrase) -> bool:
    return len(parts) > len(phrase) and parts[: len(phrase)] == phrase


def infinitive(verb: str, known: Forms) -> str:
    """Return the infinitive of a bent verb; the verb itself if it is none."""
    for bent, whole in known.changed.items():
        if verb.endswith(bent):
            return verb.removesuffix(bent) + whole
    for ending, whole in known.verbs.items():
        if verb.endswith(ending) and len(verb) - len(ending) >= _SHORTEST - 1:
            return verb.removesuffix(ending) + whole
    return verb


def _of_participle(verb: str, known: Forms) -> str:
    """Return the infinitive of "abgesetzt" and "losgelassen"; empty if it is no participle."""
    for done, whole in known.done.items():
        if verb.endswith(done):
            return verb.removesuffix(done) + whole
    at = verb.find(known.within)
    stem = verb[at + len(known.within) :].removesuffix(known.ending)
    regular = at >= 0 and verb.endswith(known.ending) and len(stem) >= _SHORTEST - 1
    return f"{verb[:at]}{infinitive(stem + known.ending, known)}" if regular else ""


def _places(parts: Sequence[str], words: Words) -> Iterator[int]:
    """Yield where a name begins in the line."""
    told = [word.said for word in words]
    for start in range(1, len(words) - len(parts) + 1):
        if told[start : start + len(parts)] == list(parts):
            yield start
