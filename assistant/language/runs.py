"""Stretches of words no class of a frame took: the names of steps and tasks among them."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace

from assistant.language.edges import is_particle, lone, widened
from assistant.language.frames import Frames, Span, Spans, frames, places
from assistant.language.naming import known_name
from assistant.language.parsing import Hearing, texts_of
from assistant.language.words import Words, said

LONGEST_NAME = 6
_CLEAR = 2
_REACH = 4
"""Words between one that leads to a name, such as "before", and the name."""


@dataclass(frozen=True, slots=True)
class Runs:
    """Stretches with how much each looks like a name: known 3, in -ing 2, else 1, odd 0."""

    found: tuple[Span, ...]
    likeness: tuple[int, ...]

    @classmethod
    def of(
        cls,
        words: Words,
        used: set[int],
        blank: set[int],
        spans: Spans,
        hearing: Hearing,
        *,
        whole: bool,
    ) -> Runs:
        """Find them in a clause; those with words of asking are none. A `whole` one keeps ends."""
        known = frames(hearing.language)
        if known is None:
            return cls((), ())
        asking = places(("what", "why", "no"), spans)
        found: list[Span] = []
        stretches = (*_stretches(words, used, blank, known), *_lone(words, used, known))
        for run in sorted(stretches):
            trimmed = run if whole else widened(_trimmed(run, words, known), words, used, known)
            if {word.text for word in words[slice(*trimmed)]} <= known.little["nobody"]:
                continue
            if trimmed[1] - trimmed[0] <= LONGEST_NAME and not asking & set(range(*trimmed)):
                found.append(trimmed)
        return cls(tuple(found), tuple(_likeness(words, run, hearing, known) for run in found))

    def two(self) -> tuple[Span, Span] | None:
        """Return the two that look most like names, in the order said."""
        if len(self.found) < 2:
            return None
        ranked = sorted(zip(self.likeness, self.found, strict=True), key=lambda one: -one[0])
        if len(ranked) > 2 and ranked[2][0] >= ranked[1][0]:
            return None
        first, second = sorted(run for _, run in ranked[:2])
        return first, second

    def best(self, lead: str, spans: Spans, used: set[int]) -> Span | None:
        """Return the likeliest name behind a word of a class, or near what the frame took."""
        runs = list(zip(self.likeness, self.found, strict=True))
        if not runs:
            return None
        if lead.isdigit():
            clear = [run for like, run in runs if like >= _CLEAR]
            return min(clear if len(clear) >= len(runs) - 1 and clear else self.found)
        if lead:
            ends = {one[1] for one in spans.get(lead, ()) if one[0] in used and _alone(one, spans)}
            runs = [r for r in runs if any(end <= r[1][0] <= end + _REACH for end in ends)]
            return max(runs, key=lambda r: (r[0], -r[1][0]), default=(0, None))[1]
        return max(runs, key=lambda r: (r[0], -_distance(r[1], used)))[1]

    def behind(self, words: Words, spans: Spans, blank: set[int]) -> Runs:
        """Return all that follows the word that names: "one" of "under the name fork one"."""
        starts = [end for _, end in spans.get("named", ()) if end < len(words) and end not in blank]
        if not starts or not self.found or max(starts) > self.found[-1][0]:
            return self
        return Runs(((self.found[-1][0], len(words)),), (1,))

    def without(self, run: Span) -> Runs:
        """Return the others."""
        kept = [pair for pair in zip(self.found, self.likeness, strict=True) if pair[0] != run]
        return replace(
            self, found=tuple(one for one, _ in kept), likeness=tuple(like for _, like in kept)
        )


def _alone(span: Span, spans: Spans) -> bool:
    """Tell a word that leads to a name from one within a phrase: the "to" of "refer to"."""
    longer = (one for name, ones in spans.items() if name != "empty" for one in ones)
    return not any(a <= span[0] and span[1] <= b and b - a > span[1] - span[0] for a, b in longer)


def _lone(words: Words, used: set[int], known: Frames) -> Iterator[Span]:
    return (span for span in lone(words, known) if span[0] not in used)


def _stretches(words: Words, used: set[int], blank: set[int], known: Frames) -> Iterator[Span]:
    """Yield stretches of words that no class took, little words inside kept."""
    joints, soft = known.little["joints"], known.little["soft"]
    glue = known.small("glue")
    start = end = -1
    for at in range(len(words) + 1):
        last = at == len(words)
        text = "" if last else words[at].text
        taken = at in used and not (text in glue and start >= 0)
        cut = last or taken or words[at].broken or text in joints
        if start >= 0 and (cut or (at in blank and text not in soft)):
            yield start, end
            start = -1
        if not last and at not in used and at not in blank:
            start = at if start < 0 else start
            end = at + 1


def _trimmed(run: Span, words: Words, known: Frames) -> Span:
    """Take words off both ends that lead to a name or follow it: "node testing"."""
    start, end = run
    heads, tails = known.little["heads"], known.little["tails"]
    told = any(word.text in known.little["verbs"] for word in words)
    ordered = start == 0 and end == 2 and words[1].text.endswith(known.name_endings)
    if ordered and not told and known.name_endings:
        # An order begins with a verb, even with one nobody listed: "yank polishing".
        return 1, 2
    while end - start > 1 and words[start].text in heads:
        start += 1
    while end - start > 1 and words[end - 1].text in tails:
        if is_particle(end - 1, start, words, known):
            break
        end -= 1
    return start, end


def _likeness(words: Words, run: Span, hearing: Hearing, known: Frames) -> int:
    texts = texts_of(words[slice(*run)])
    if known_name(texts, hearing.listening.subtasks, hearing.book):
        return 3
    if any(text.endswith(known.name_endings) for text in texts if len(text) > 4):
        return 2
    return 0 if set(texts) & hearing.book.impure else 1


def _distance(run: Span, used: set[int]) -> float:
    gaps = (run[0] - at - 0.5 if at < run[0] else at - run[1] + 1 for at in used)
    return min(gaps, default=float(run[0]))


def _with_noun(words: Words, run: Span, steps: frozenset[str], hearing: Hearing) -> bool:
    """Tell a long name with the noun of a step behind it: "the twist knob bit"."""
    start, end = run
    led = start > 0 and words[start - 1].text in hearing.book.little["articles"]
    if end - start <= _CLEAR or not led or words[end - 1].text not in steps:
        return False
    whole = said(words[start:end])
    return whole not in hearing.listening.subtasks


def named_text(words: Words, run: Span, hearing: Hearing) -> str:
    """Return the known name a stretch refers to, or its own words; "step two" is whole."""
    start, end = run
    numbers = hearing.book.numbers
    known = frames(hearing.language)
    steps = known.little["steps"] if known else frozenset()
    ranked = words[start].text in hearing.book.little["last_ones"]
    ranked = ranked or bool(numbers.ordinal(texts_of(words), start))
    if end - start == 1 and ranked and words[end:]:
        end += words[end].text in steps
    if end - start == 1 and numbers.number(texts_of(words), start) and start:
        start -= words[start - 1].text in steps
    end -= not ranked and _with_noun(words, (start, end), steps, hearing)
    part = words[start:end]
    names = hearing.listening.subtasks
    return known_name(texts_of(part), names, hearing.book) or said(part)
