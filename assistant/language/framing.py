"""Acts made of frames: the frame that explains most of a clause, its names in the slots.

Words that belong to no class of the frame stay unexplained and lower the confidence; in acts
with names they are the names.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from itertools import pairwise
from typing import Any

from assistant.language.frames import Frame, Frames, Span, Spans, frames, places, spans_of
from assistant.language.parsing import LIKELY, NAMED, Hearing, Parse, bared, texts_of
from assistant.language.phrasebook import Phrase
from assistant.language.runs import Runs, named_text
from assistant.language.sentences import best_sentence
from assistant.language.words import Words, said
from assistant.model.teacher_acts import ACTS, Explain, TeacherAct, act_name, act_to_json

MOST_UNEXPLAINED = 3
LONGEST_LINE = 40
_TRUST = (LIKELY, 0.72, 0.58, 0.42)
_COUNTED = ("seconds", "ordinal", "number")
_NAMING = ("save", "load", "compare", "rename", "add_subtask")
_TOLD = frozenset(("ordered", "rename", "add_subtask", "remove_subtask", "merge", "split"))
_ASIDE, _ASIDE_WORD, _MORE = 0.02, 0.012, 0.06
_ODD = 0.7
"""Of sentences whose names hold words that no name holds."""


def framed(words: Words, hearing: Hearing) -> Parse | None:
    """Return the act whose frame explains a clause best; None if none explains enough."""
    known = frames(hearing.language)
    texts = texts_of(words)
    if known is None or len(texts) > LONGEST_LINE:
        return None
    asking = texts[0] in known.little["asking"]
    spans = spans_of(texts, known, hearing.book.numbers)
    best: tuple[tuple[float, int, int], Parse] | None = None
    for frame in known.told_by(spans):
        told = asking and frame.names and frame.act in _TOLD
        if frame.expected or told or not _applies(frame, hearing, spans):
            continue
        found = _filled(frame, words, spans, hearing)
        if found is not None:
            parse, explained = found
            key = (parse.score, explained, len(frame.needs))
            if best is None or key > best[0]:
                best = (key, parse)
    return None if best is None else best[1]


def framed_as(act: str, words: Words, hearing: Hearing) -> Parse | None:
    """Return an act that is expected, as its best frame reads it in the whole or a part."""
    known = frames(hearing.language)
    if known is None or len(words) > LONGEST_LINE:
        return None
    best: Parse | None = None
    for part in stretches(words, known):
        dropped = len(words) - len(part)
        left_out = _ASIDE + _ASIDE_WORD * dropped if dropped else 0.0
        for found in _expected(act, part, known, hearing):
            if best is None or found.score - left_out > best.score:
                best = Parse(found.acts, found.score - left_out, found.how)
    if best is None:
        return None
    most = LIKELY if best.how == "sentence" else NAMED
    return Parse(best.acts, min(best.score, most), best.how)


def _expected(act: str, part: Words, known: Frames, hearing: Hearing) -> Iterator[Parse]:
    """Yield an act as frames and sentences read it in a part, more worth the more they name."""
    spans = spans_of(texts_of(part), known, hearing.book.numbers)
    for frame in known.told_by(spans):
        if frame.act == act and _applies(frame, hearing, spans):
            found = _filled(frame, part, spans, hearing)
            if found is not None:
                worth = found[0].score + _MORE * len(frame.names)
                yield Parse(found[0].acts, worth, found[0].how)
    told = next((best_sentence(bare, hearing) for bare in bared(part, hearing.book)), None)
    if told is not None and [act_name(one) for one in told.acts] == [act]:
        odd = _MORE if told.score <= _ODD else 0.0
        yield Parse(told.acts, told.score - odd + _MORE * _names_in(told.acts[0]), told.how)


def _names_in(act: TeacherAct) -> int:
    kept = ("act", "direction", "at_s", "episode")
    return sum(bool(value) for key, value in act_to_json(act).items() if key not in kept)


def stretches(words: Words, known: Frames) -> Iterator[Words]:
    """Yield the line, then what stands between its marks and the words that begin asides."""
    yield words
    asides = known.little["asides"]
    cuts = [n for n in range(1, len(words)) if words[n].broken or words[n].text in asides]
    bounds = [0, *cuts, len(words)]
    if 3 <= len(bounds) <= 8:
        for start in bounds[:-1]:
            for end in reversed(bounds):
                if end > start and (start, end) != (0, len(words)):
                    yield words[start:end]


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
    if core is None or places(frame.never, spans) - core:
        return None
    blank = places(["empty"], spans) | _adverbs(words, hearing)
    used = core | places([*frame.may, *(one for ways in frame.needs for one in ways)], spans)
    left = set(range(len(words))) - used - blank
    if frame.act not in _NAMING and any(words[at].text in hearing.book.chat for at in left):
        return None
    explained = len((used - blank) | core)
    if frame.names:
        parse = _named(frame, words, used, blank, spans, hearing)
        return None if parse is None else (parse, explained)
    if len(left) > MOST_UNEXPLAINED or len(left) > 2 * explained:
        return None
    slots: dict[str, Any] = {key: _value(value) for key, value in frame.slots.items()}
    return Parse((_act(frame, slots),), _TRUST[len(left)], "frame"), explained


def _adverbs(words: Words, hearing: Hearing) -> set[int]:
    """Return where words stand that only say how: "properly", "hereby"."""
    known = frames(hearing.language)
    endings = known.adverb_endings if known else ()
    if not endings:
        return set()
    return {
        at
        for at, word in enumerate(words)
        if len(word.text) > 4 and word.text.endswith(endings) and word.text not in hearing.names
    }


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
    slots = _counted_slots(frame, words, spans, hearing)
    wanted = tuple(one for one in frame.names if one[1] not in _COUNTED)
    if not wanted:
        left = len(set(range(len(words))) - used - blank)
        return Parse((_act(frame, slots),), _TRUST[min(left, 3)], "frame")
    whole = frame.act in _NAMING[:3]
    runs = Runs.of(words, used, blank, spans, hearing, whole=whole)
    if wanted[0][1] == "*":
        pair = tuple(named_text(words, run, hearing) for run in runs.two() or ())
        made = _act(frame, {**slots, wanted[0][0]: pair})
        return (
            Parse((made,), NAMED if len(runs.found) == 2 else _TRUST[1], "named") if pair else None
        )
    trust = min(_TRUST[min(max(len(runs.found) - len(wanted), 0), 3)], NAMED)
    taken = _taken(frame, wanted, runs, used, words, spans, blank)
    if taken is None:
        return None
    slots |= {slot: _told(slot, words, run, hearing) for slot, run in taken.items()}
    return Parse((_act(frame, slots),), trust, "named")


def _told(slot: str, words: Words, run: Span, hearing: Hearing) -> str:
    """Return a name as it was said where it is new, else the known one it refers to."""
    new = slot in ("new", "name")
    return said(words[slice(*run)]) if new else named_text(words, run, hearing)


def _counted_slots(frame: Frame, words: Words, spans: Spans, hearing: Hearing) -> dict[str, Any]:
    """Return the slots that are fixed, or told by a number, a place in an order, or a time."""
    slots: dict[str, Any] = {k: v for k, v in frame.slots.items() if not v.startswith("{")}
    for slot, kind in frame.names:
        if kind in _COUNTED:
            # Of two counts the last holds where one is denied: "not at 10, it ends at 11".
            chosen = max(spans[kind]) if "no" in spans else spans[kind][0]
            slots[slot] = _counted_value(slot, kind, texts_of(words)[slice(*chosen)], hearing)
    return slots


def _taken(
    frame: Frame,
    wanted: tuple[tuple[str, str], ...],
    runs: Runs,
    used: set[int],
    words: Words,
    spans: Spans,
    blank: set[int],
) -> dict[str, Span] | None:
    """Return which stretch fills each slot; None if one stays empty."""
    if frame.act in _NAMING[:3]:
        runs = runs.behind(words, spans, blank)
    taken: dict[str, Span] = {}
    for slot, lead in sorted(wanted, key=lambda one: one[1] == ""):
        run = runs.best(lead, spans, used)
        if run is None:
            return None
        taken[slot] = run
        runs = runs.without(run)
    crossed = any(a[1] > b[0] for a, b in pairwise(sorted(taken.values())))
    return None if crossed else taken


def _counted_value(slot: str, kind: str, texts: Phrase, hearing: Hearing) -> Any:
    numbers = hearing.book.numbers
    place = numbers.ordinal(texts, 0) if kind == "ordinal" else None
    if place is not None:
        return "first" if slot == "which" and place[0] == 1 else place[0]
    quantity = numbers.quantity(texts, 0) or numbers.quantity(texts, 1)
    value = quantity.value if quantity else 0.0
    return value if slot == "at_s" else int(value)
