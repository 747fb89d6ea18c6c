"""Things a teacher names, by the names the scene has for them."""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Sequence
from dataclasses import replace
from functools import cache

from assistant.dialogue.naming import Value, alike, tidy_name
from assistant.language.actions import called_things, role_of
from assistant.language.hints import hints, phrase_pattern
from assistant.language.slips import without_slips
from assistant.model.scene import Scene
from assistant.model.setup import Setup
from assistant.model.task import Role, TaskObject


def things_in(value: Value, scene: Scene, language: str = "english") -> tuple[TaskObject, ...]:
    """Return the objects an answer names, by the scene's names where it knows them.

    "the cup should be on the tray" names a cup and a tray.
    """
    if not isinstance(value, tuple):
        return _in_sentences(str(value), scene, language)
    told = [part for phrase in value for part in _parted(phrase, scene, language)]
    # A size such as "8 cm wide" is no thing.
    parted = [part for part in told if not re.match(r"\W*\d+\s*(?:mm|cm|m|inch)?\b", part)]
    barely = [bare(phrase, language) for phrase in parted]
    names = [name for phrase in barely for name in _called(phrase, scene, language)]
    no_things: list[str] = hints("no_things", language)
    unique = dict.fromkeys(name for name in names if name and not alike(name, no_things))
    return tuple(TaskObject(name, role(name, scene, language)) for name in unique)


def _in_sentences(text: str, scene: Scene, language: str) -> tuple[TaskObject, ...]:
    """Return the things of a text; "a can of beans. The can goes there" names one, twice."""
    found: list[TaskObject] = []
    for sentence in re.split(r"[.!?](?:\s+|$)", without_relative(text, language)):
        there = [set(one.name.split()) for one in found]
        for one in things_in(_things(sentence, language), scene, language):
            again = any(set(one.name.split()) <= words for words in there)
            if one not in found and (one.name in scene.bodies or not again):
                found.append(one)
    return tuple(found)


def without_relative(text: str, language: str) -> str:
    """Return a text without what it tells of a thing beside: "a board, which lies there"."""
    begun = "|".join(map(re.escape, hints("relative", language)))
    return re.sub(rf",?\s+(?:{begun})\b[^,;.!?]*", "", text, flags=re.IGNORECASE)


def thing_names(scene: Scene, setup: Setup) -> list[str]:
    """Return the names of the things that stand on the table."""
    return [name for name in scene.bodies if name in setup.places]


def _called(phrase: str, scene: Scene, language: str) -> list[str]:
    """Return the things a phrase calls: one, "the blocks", "all of them", or "the red" one."""
    name = known_name(phrase, scene, language)
    if name in scene.bodies:
        return [name]
    plurals: dict[str, str] = hints("plurals", language)
    *told, last = phrase.lower().split() or [""]
    if alike(phrase, hints("all_things", language)):
        return list(scene.bodies)
    wanted = {*told, plurals.get(last, last)} - set(hints("said_of_all", language))
    own = {body: _own_words(body, scene, language) for body in scene.bodies}
    meant = [body for body, words in own.items() if wanted and wanted <= words]
    several = len(meant) > 1 and last in plurals
    return meant if several or len(meant) == 1 else [name]


def _own_words(name: str, scene: Scene, language: str) -> set[str]:
    """Return the words of the names of a body, by which it may be called in part."""
    called = " ".join([name, *called_things(name, language)])
    return set(re.findall(r"\w+", called.lower()))


def _parted(phrase: str, scene: Scene, language: str) -> list[str]:
    """Return the things in a phrase that is more than a name: what stands between its verbs."""

    def there(part: str) -> bool:
        return _called(bare(part, language), scene, language)[0] in scene.bodies

    if there(phrase):
        return [phrase]
    joints = sorted(hints("thing_joints", language), key=len, reverse=True)
    pattern = r"\b(?:" + "|".join(map(re.escape, joints)) + r")\b"
    parts = re.split(pattern, phrase, flags=re.IGNORECASE)
    if len(parts) == 1:
        return [phrase]
    no_things: list[str] = hints("no_things", language)
    barely = [(part, bare(part, language).lower()) for part in parts]
    named = [part for part, name in barely if name and name not in no_things]
    # In a whole sentence a new thing has an article; one that is known needs none.
    led = [part for part in named if _article(language).match(part.strip())]
    return [part for part in named if part in led or there(part)] if led else named


def known_name(phrase: str, scene: Scene, language: str = "english") -> str:
    """Return the scene's name for a thing, or the phrase itself if the scene has none.

    "the red block" is the block of the scene if that is red, or if no other block is there.
    """
    called = {name: called_things(name, language) for name in scene.bodies}
    lowered = without_slips(phrase, [one for all_ in called.values() for one in all_], language)
    lowered = lowered.lower()
    for name, words in called.items():
        if lowered in words:
            return name
    inside = {
        name: hit.group()
        for name, words in called.items()
        for hit in (phrase_pattern(word).search(lowered) for word in words)
        if hit
    }
    others = set(re.findall(r"\w+", lowered))
    fitting = [
        name
        for name, said in inside.items()
        if others - set(said.split()) <= _words_of(name, scene, language)
    ]
    return fitting[0] if len(fitting) == 1 else phrase


def _words_of(name: str, scene: Scene, language: str) -> set[str]:
    """Return the words that may be said of a body: its name, color and shape."""
    body = scene.bodies[name]
    colors: dict[str, list[str]] = hints("colors", language)
    shapes: dict[str, list[str]] = hints("shapes", language)
    plain = {*re.findall(r"\w+", f"{name} {body.color} {body.shape}".lower())}
    told = (*colors.get(body.color, ()), *hints("said_of_things", language))
    return plain | set(told) | (set(shapes.get(body.shape, ())) if colors else set())


def role(name: str, scene: Scene, language: str = "english") -> Role:
    """Return ``target`` for what cannot be moved or is called one, else ``object``."""
    body = scene.bodies.get(name)
    if body is not None and body.mass_kg == 0:
        return "target"
    return "target" if body is None and role_of(name, language) == "target" else "object"


def placed(
    things: tuple[TaskObject, ...], told: Sequence[str], scene: Scene, language: str = "english"
) -> tuple[TaskObject, ...]:
    """Return things, new ones that something is put on as targets: "the cup is on the saucer"."""
    on, articles = _any("rests_on", language), _any("articles", language)
    heads = Counter(_head(thing) for thing in things)
    out = []
    for thing in things:
        # "On the board" is on the wooden board, where no other one is named.
        short = (_head(thing),) if heads[_head(thing)] == 1 else ()
        called = "|".join(map(re.escape, (thing.name, *short)))
        said = rf"\b(?:{on})\s+(?:(?:{articles})\s+)*(?:{called})\b"
        under = any(re.search(said, text, re.IGNORECASE) for text in told)
        new = thing.name not in scene.bodies
        out.append(replace(thing, role="target") if under and new else thing)
    # Where all are put on each other, none is only a place.
    return things if all(one.role == "target" for one in out) else tuple(out)


def _head(thing: TaskObject) -> str:
    """Return the last word of a name: "board" of a wooden board."""
    return (thing.name.lower().split() or [""])[-1]


def _any(part: str, language: str) -> str:
    return "|".join(map(re.escape, sorted(hints(part, language), key=len, reverse=True)))


def _things(text: str, language: str) -> tuple[str, ...]:
    between = "|".join(rf"\b{re.escape(one)}\b" for one in hints("between_things", language))
    return tuple(piece for piece in re.split(rf",|;|{between}", text) if piece.strip())


def bare(phrase: str, language: str = "english") -> str:
    """Return a name without its articles."""
    return _article(language).sub("", tidy_name(phrase))


@cache
def _article(language: str) -> re.Pattern[str]:
    articles = "|".join(map(re.escape, hints("articles", language)))
    return re.compile(rf"^(?:(?:{articles})\s+)+", re.IGNORECASE)
