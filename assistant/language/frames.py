"""Frames: acts recognized by the classes of words in a clause, in any order, with fillers between.

Where no known sentence fits, an act is still told by what kinds of words occur: something to
take back and a change make an undo, however they are joined. Words that belong to no class of
the frame stay unexplained and lower the confidence; in acts with names they are the names.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import cache
from pathlib import Path
from typing import Any, cast

from assistant.language.naming import known_name
from assistant.language.parsing import LIKELY, Hearing, Parse, texts_of
from assistant.language.phrasebook import LANGUAGES, Phrase
from assistant.language.words import Words, said
from assistant.model.teacher_acts import ACTS, Explain, TeacherAct
from assistant.plain_yaml import read_file

LONGEST_NAME = 6
MOST_UNEXPLAINED = 3
_TRUST = (LIKELY, 0.72, 0.58, 0.42)
_NAMING = ("save", "load", "compare", "rename", "add_subtask")
_NAMED = 0.78
_TOLD = frozenset(("ordered", "rename", "add_subtask", "remove_subtask", "merge", "split"))
Spans = Mapping[str, tuple[tuple[int, int], ...]]


@dataclass(frozen=True, slots=True)
class Frame:
    """Classes that make an act, and where its slots come from.

    Parameters
    ----------
    needs : tuple of tuple of str
        Each must occur, in one of its ways.
    never, may : frozenset of str
        Classes that must not occur, and those that explain further words.
    slots : mapping
        Fixed values, and ``{}``, ``{class}`` or ``{*}`` for names.
    """

    act: str
    slots: Mapping[str, str]
    needs: tuple[tuple[str, ...], ...]
    never: frozenset[str]
    may: frozenset[str]
    stages: frozenset[str]
    asked: frozenset[str]

    @property
    def names(self) -> tuple[tuple[str, str], ...]:
        """Return slots that take the teacher's own words, with where they stand."""
        told = self.slots.items()
        return tuple((slot, value[1:-1]) for slot, value in told if value.startswith("{"))


@dataclass(frozen=True)
class Frames:
    """The frames of a language with its classes, by the stem they begin with."""

    frames: tuple[Frame, ...]
    phrases: Mapping[str, tuple[tuple[Phrase, str], ...]]
    words: frozenset[str]


@cache
def frames(language: str) -> Frames | None:
    """Return the frames of a language, read once; None if it has none."""
    path = Path(__file__).parent / LANGUAGES[language.lower()] / "frames.yaml"
    if not path.exists():
        return None
    told = cast("dict[str, Any]", read_file(path)[0].value)
    phrases: dict[str, list[tuple[Phrase, str]]] = {}
    words = set(_list(told["empty"]))
    for name, listed in (("empty", told["empty"]), *told["classes"].items()):
        for phrase in _list(listed):
            stems = tuple(_stem(word) for word in phrase.split())
            phrases.setdefault(stems[0], []).append((stems, name))
            words |= set(phrase.split())
    return Frames(
        frames=tuple(_frame(line) for line in told["frames"].splitlines() if line.strip()),
        phrases={first: tuple(ones) for first, ones in phrases.items()},
        words=frozenset(word for word in words if word.isalpha()),
    )


def _list(text: str) -> list[str]:
    return [one.strip() for one in text.replace("\n", " ").split(",") if one.strip()]


def _frame(line: str) -> Frame:
    head, _, rest = line.strip().partition(" : ")
    act, *slots = head.split()
    needed, _, allowed = rest.partition("?")
    marks = [*needed.split(), *allowed.split()]
    return Frame(
        act=act,
        slots=dict(cast("tuple[str, str]", tuple(slot.split("=", 1))) for slot in slots),
        needs=tuple(tuple(one.split("|")) for one in needed.split() if one[0] not in "!@~"),
        never=frozenset(one[1:] for one in marks if one[0] == "!"),
        may=frozenset(one for one in allowed.split() if one[0] not in "!@~"),
        stages=frozenset(one[1:] for one in marks if one[0] == "@"),
        asked=frozenset(one[1:] for one in marks if one[0] == "~"),
    )


def framed(words: Words, hearing: Hearing) -> Parse | None:
    """Return the act whose frame explains a clause best; None if none explains enough."""
    known = frames(hearing.language)
    texts = texts_of(words)
    if known is None or len(texts) > 40:
        return None
    asking = texts[0] in ("what", "which", "where", "how", "who")
    spans = {**_spans(texts, known), **_counted(texts, hearing)}
    best: tuple[tuple[float, int, int], Parse] | None = None
    for frame in known.frames:
        if not _applies(frame, hearing, spans) or (asking and frame.names and frame.act in _TOLD):
            continue
        found = _filled(frame, words, spans, hearing)
        if found is not None:
            parse, explained = found
            key = (parse.score, explained, len(frame.needs))
            if best is None or key > best[0]:
                best = (key, parse)
    return None if best is None else best[1]


def _spans(texts: Phrase, known: Frames) -> Spans:
    """Return where each class occurs, its longest phrases first."""
    stems = tuple(_stem(text) for text in texts)
    found: dict[str, list[tuple[int, int]]] = {}
    for at, first in enumerate(stems):
        for phrase, name in known.phrases.get(first, ()):
            if stems[at : at + len(phrase)] == phrase:
                found.setdefault(name, []).append((at, at + len(phrase)))
    dressed = {at for a, b in found.get("empty", ()) if b - a > 1 for at in range(a, b)}
    for name in found.keys() - {"empty"}:
        found[name] = [one for one in found[name] if not dressed >= set(range(*one))]
    return {
        name: tuple(sorted(ones, key=lambda s: s[0] - s[1])) for name, ones in found.items() if ones
    }


def _stem(word: str) -> str:
    """Return a word without its ending; words in -ing stay, for they name steps."""
    found = word.removesuffix("s") if not word.endswith("ss") else word
    found = found.removesuffix("ed") if len(found) > 4 else found
    return found.removesuffix("e") if len(found) > 3 else found


def _counted(texts: Phrase, hearing: Hearing) -> dict[str, tuple[tuple[int, int], ...]]:
    """Return where numbers, places in an order and times stand."""
    numbers = hearing.book.numbers
    found: dict[str, list[tuple[int, int]]] = {}
    for at in range(len(texts)):
        quantity = numbers.quantity(texts, at)
        if quantity is not None and quantity.kind in ("s", ""):
            name = "seconds" if quantity.kind == "s" else "number"
            found.setdefault(name, []).append((at, quantity.end))
        place = numbers.ordinal(texts, at)
        if place is not None:
            found.setdefault("ordinal", []).append((at, place[1]))
    return {name: tuple(ones) for name, ones in found.items()}


def _applies(frame: Frame, hearing: Hearing, spans: Spans) -> bool:
    listening = hearing.listening
    if frame.stages and listening.stage not in frame.stages:
        return False
    if frame.asked and (listening.asked or "none") not in frame.asked:
        return False
    return all(any(name in spans for name in ways) for ways in frame.needs)


def _filled(frame: Frame, words: Words, spans: Spans, hearing: Hearing) -> tuple[Parse, int] | None:
    """Return the act with its slots, and how many telling words the frame explains."""
    core = _core(frame, spans)
    if core is None:
        return None
    blank = _places(["empty"], spans)
    used = core | _places([*frame.may, *(one for ways in frame.needs for one in ways)], spans)
    if _places(frame.never, spans) - core:
        return None
    left = set(range(len(words))) - used - blank
    chat = [at for at in left if words[at].text in hearing.book.chat]
    if chat and frame.act not in _NAMING:
        return None
    explained = len((used - blank) | core)
    if frame.names:
        parse = _named(frame, words, used, blank, spans, hearing)
        return None if parse is None else (parse, explained)
    if len(left) > MOST_UNEXPLAINED or len(left) > 2 * explained:
        return None
    slots: dict[str, Any] = {key: _value(value) for key, value in frame.slots.items()}
    return Parse((_act(frame, slots),), _TRUST[len(left)], "frame"), explained


def _places(names: Iterable[str], spans: Spans) -> set[int]:
    return {at for name in names for span in spans.get(name, ()) for at in range(*span)}


def _core(frame: Frame, spans: Spans) -> set[int] | None:
    """Return the places taken by one phrase of each class needed; None if they do not fit."""
    used: set[int] = set()
    for ways in sorted(frame.needs, key=lambda ways: sum(len(spans.get(w, ())) for w in ways)):
        free = [s for w in ways for s in spans.get(w, ()) if not used & set(range(*s))]
        if not free:
            return None
        used |= set(range(*max(free, key=lambda span: span[1] - span[0])))
    return used


def _act(frame: Frame, slots: Mapping[str, Any]) -> TeacherAct:
    kind: Callable[..., TeacherAct] = ACTS[frame.act]
    return kind(**slots)


def _value(told: str) -> Any:
    try:
        return float(told)
    except ValueError:
        return told


def _named(
    frame: Frame, words: Words, used: set[int], blank: set[int], spans: Spans, hearing: Hearing
) -> Parse | None:
    """Return the act with the words no class took as its names."""
    if frame.act == "explain":
        return Parse((Explain(said(words)),), LIKELY - 0.02, "frame")
    runs = [run for run in _runs(words, used, blank) if run[1] - run[0] <= LONGEST_NAME]
    asking = _places(("what", "why", "no"), spans)
    runs = [run for run in runs if not asking & set(range(*run))]
    slots: dict[str, Any] = {k: v for k, v in frame.slots.items() if not v.startswith("{")}
    wanted = tuple(one for one in frame.names if one[1] not in ("seconds", "ordinal", "number"))
    for slot, kind in set(frame.names) - set(wanted):
        slots[slot] = _counted_value(kind, texts_of(words), spans[kind][0][0], hearing)
        if slot == "which" and slots[slot] == 1 and kind == "ordinal":
            slots[slot] = "first"
    if not wanted:
        left = len(set(range(len(words))) - used - blank)
        return Parse((_act(frame, slots),), _TRUST[min(left, 3)], "frame")
    if wanted[0][1] == "*":
        if len(runs) != 2:
            return None
        names = tuple(_text(words, run, hearing) for run in runs)
        return Parse((_act(frame, {wanted[0][0]: names}),), _NAMED, "named")
    trust = _TRUST[min(max(len(runs) - len(wanted), 0), len(_TRUST) - 1)]
    trust = min(trust, _NAMED)
    if frame.act in _NAMING[:3]:
        runs = _behind(runs, words, spans, blank)
    for slot, lead in sorted(wanted, key=lambda one: one[1] == ""):
        run = _run_of(lead, runs, spans, used)
        if run is None:
            return None
        new = slot in ("new", "name")
        slots[slot] = said(words[slice(*run)]) if new else _text(words, run, hearing)
        runs.remove(run)
    return Parse((_act(frame, slots),), trust, "named")


def _behind(
    runs: list[tuple[int, int]], words: Words, spans: Spans, blank: set[int]
) -> list[tuple[int, int]]:
    """Return all that follows the word that names, such as "one" of "under the name fork one"."""
    starts = [end for _, end in spans.get("named", ()) if end < len(words) and end not in blank]
    if not starts or not runs or max(starts) > runs[-1][0]:
        return runs
    end = len(words)
    while end > runs[-1][1] and words[end - 1].text != "one":
        end -= 1
    return [(runs[-1][0], end)]


def _counted_value(kind: str, texts: Phrase, at: int, hearing: Hearing) -> float | int:
    numbers = hearing.book.numbers
    place = numbers.ordinal(texts, at) if kind == "ordinal" else None
    if place is not None:
        return place[0]
    quantity = numbers.quantity(texts, at)
    value = quantity.value if quantity else 0.0
    return value if kind == "seconds" else int(value)


def _run_of(
    lead: str, runs: Sequence[tuple[int, int]], spans: Spans, used: set[int]
) -> tuple[int, int] | None:
    """Return the run that follows a word of a class, or the one nearest what the frame took."""
    if lead.isdigit():
        return runs[0] if runs else None
    if not lead:
        return min(runs, key=lambda run: _distance(run, used), default=None)
    ends = {end for start, end in spans.get(lead, ()) if start in used}
    near = [run for run in runs if any(end <= run[0] <= end + 4 for end in ends)]
    return near[0] if near else None


def _distance(run: tuple[int, int], used: set[int]) -> float:
    return min(run[0] - at - 0.5 if at < run[0] else at - run[1] + 1 for at in used)


_JOINTS = frozenset(("and", "or", "then", "but", "nor", "plus", "if", "when", "und", "oder"))
_SOFT = frozenset(("the", "of", "to", "on", "in", "up", "down", "with", "onto", "into", "der"))


def _runs(words: Words, used: set[int], blank: set[int]) -> Iterator[tuple[int, int]]:
    """Yield stretches of words that no class took, little words inside kept."""
    start = end = -1
    for at in range(len(words) + 1):
        last = at == len(words)
        text = "" if last else words[at].text
        cut = last or at in used or words[at].broken or text in _JOINTS
        if start >= 0 and (cut or (at in blank and text not in _SOFT)):
            yield start, end
            start = -1
        if not last and at not in used and at not in blank:
            start = at if start < 0 else start
            end = at + 1


def _text(words: Words, run: tuple[int, int], hearing: Hearing) -> str:
    start, end = run
    number = hearing.book.numbers
    if end - start == 1 and number.ordinal(texts_of(words), start) and words[end:]:
        end += words[end].text == "step"
    if end - start == 1 and number.number(texts_of(words), start) and start:
        start -= words[start - 1].text == "step"
    part = words[start:end]
    names = hearing.listening.subtasks
    return known_name(texts_of(part), names, hearing.book.numbers) or said(part)
