"""Names as the teacher writes them: with the capitals, hyphens and marks of the line itself.

Understanding compares words in one plain form. At its edge names change their dress: those that
are known come in plain, and what the acts name goes out as the task knows it or as it stands in
the line.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, fields, replace
from functools import cached_property
from typing import Any

from assistant.language.hints import hints
from assistant.language.words import cleaned, plain
from assistant.model.listening import Listening
from assistant.model.teacher_acts import TeacherAct, Where

_WORDS = re.compile(r"[^\W_]+(?:'(?!s(?![^\W_]))[^\W_]+)*")
_JOINED = re.compile(r"(?<=[^\W_])(?:[-_]|'(?!s(?![^\W_])))(?=[^\W_])")
_JOINERS = re.compile(r"(?:[-_\s]|'(?=\s))+")
_TOLD = frozenset(
    ("value", "text", "old", "new", "name", "object", "first", "second", "after", "before")
) | {"subtask", "subtasks"}
"""Slots whose text is the teacher's own; the others hold words of the contract."""
_LOOSE_MARKS = re.compile(r"-|(?<![^\W_])_|_(?![^\W_])")
_STEM = 4
"""Letters by which an inflected noun is known."""


def plain_name(name: str) -> str:
    """Return a name in the form words are compared in: "Pick-and-Place" is "pick and place".

    One with a letter or a code joined to it is one word, as in a line: "V-block" is "v_block".
    """
    return " ".join(_LOOSE_MARKS.sub(" ", plain(name)).split())


def plainly(listening: Listening) -> Listening:
    """Return what is listened with, its names in plain form."""
    return replace(
        listening,
        task=plain_name(listening.task),
        objects=tuple(map(plain_name, listening.objects)),
        subtasks=tuple(map(plain_name, listening.subtasks)),
    )


def dressed(
    acts: tuple[TeacherAct, ...], text: str, listening: Listening, language: str
) -> tuple[TeacherAct, ...]:
    """Return the acts with names as the task knows them, or else as they stand in the line.

    Parameters
    ----------
    acts : tuple of TeacherAct
        Their names in plain form.
    text : str
        The line.
    listening : Listening
        With the names as the task knows them.
    language : str
    """
    names = (*listening.subtasks, *listening.objects, listening.task)
    known = {plain_name(name): name for name in reversed(names) if name}
    line = _Line(cleaned(text), known, bool(hints("nouns_begin_large", language)))
    return tuple(_act(one, line) for one in acts)


def _act(act: TeacherAct, line: _Line) -> TeacherAct:
    told: dict[str, Any] = {}
    for slot in fields(act):
        value = getattr(act, slot.name)
        if isinstance(value, Where):
            told[slot.name] = Where(line.name(value.subtask), value.when)
        elif slot.name in _TOLD and isinstance(value, str):
            told[slot.name] = line.name(value)
        elif slot.name in _TOLD and isinstance(value, tuple):
            told[slot.name] = tuple(line.name(one) for one in value)
    return replace(act, **told) if told else act


@dataclass(frozen=True)
class _Line:
    text: str
    known: Mapping[str, str]
    nouns_large: bool

    @cached_property
    def words(self) -> list[re.Match[str]]:
        return list(_WORDS.finditer(self.text))

    def name(self, told: str) -> str:
        """Return a name as it is known, or as it stands in the line, or as it is."""
        if told in self.known:
            return self.known[told]
        found = next(self._places(told), None) or self._compound(told)
        if found is None:
            unjoined = told.replace("_", "-")
            large = self.nouns_large
            return " ".join(map(self._noun, unjoined.split())) if large else unjoined
        part = self._part(*found) + self._left_out(*found)
        loud = not any(letter.islower() for letter in self.text)
        return part.lower() if loud else self._begun(part, found[0])

    def _part(self, first: int, last: int) -> str:
        return " ".join(self.text[self.words[first].start() : self.words[last].end()].split())

    def _left_out(self, first: int, last: int) -> str:
        """Return the mark behind a word whose last letter is left out: "loadin'", "wi'"."""
        begin, end = self.words[first].start(), self.words[last].end()
        quoted = "'" in self.text[max(begin - 1, 0) : begin]
        marked = self.text[end : end + 1] == "'" and not self.text[end + 1 : end + 2].isalnum()
        return "'" if marked and not quoted else ""

    def _places(self, told: str) -> Iterator[tuple[int, int]]:
        """Yield the first and last word where a name stands whole, in no longer compound."""
        size = len(_WORDS.findall(told))
        for first in range(len(self.words) - size + 1) if size else ():
            last = first + size - 1
            begin, end = self.words[first].start(), self.words[last].end()
            within = _JOINED.match(self.text, begin - 1) or _JOINED.match(self.text, end)
            if not within and _loose(self.text[begin:end]) == _loose(told):
                yield first, last

    def _compound(self, told: str) -> tuple[int, int] | None:
        """Return where the one compound stands that a name is a part of: "heat-sink" of "heat"."""
        size, found = len(_WORDS.findall(told)), list[tuple[int, int]]()
        for first in range(len(self.words) - size + 1) if size else ():
            last = first + size - 1
            part = self.text[self.words[first].start() : self.words[last].end()]
            if _loose(part) != _loose(told):
                continue
            while first and self._hyphened(first):
                first -= 1
            while last + 1 < len(self.words) and self._hyphened(last + 1):
                last += 1
            found.append((first, last))
        return found[0] if len(found) == 1 else None

    def _hyphened(self, at: int) -> bool:
        """Tell whether a hyphen alone stands before a word."""
        return self.text[self.words[at - 1].end() : self.words[at].start()] in ("-", "_")

    def _begun(self, part: str, first: int) -> str:
        """Return a name without the capital that only begins a sentence."""
        before = self.text[: self.words[first].start()].rstrip(" \"'(")
        begins = not before or before[-1] in ".!?:"
        coded = not part[1:2].isalpha() or any(letter.isupper() for letter in part[1:])
        if self.nouns_large or not begins or coded:
            return part
        return part[0].lower() + part[1:]

    def _noun(self, word: str) -> str:
        """Return a word that stands in the line with a capital, perhaps inflected, with it."""
        stem = word[:_STEM]
        for one in self.words[1:]:
            told = one.group()
            same = told.lower() == word or (len(stem) == _STEM and told.lower().startswith(stem))
            if same and told[0].isupper():
                return word[0].upper() + word[1:]
        return word


def _loose(text: str) -> str:
    return _JOINERS.sub(" ", text.lower()).strip()
