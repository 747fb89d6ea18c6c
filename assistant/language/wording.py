"""How a line's template becomes words: its slots filled, its empty parts left out.

A template is text with ``{slot:kind}``; a part in ``[ ]`` is left out where one of its slots is
empty. A kind is one of `kinds`, a table of the book's ``words``, or a number format as ``.1f``.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Any

_SLOT = re.compile(r"\{(\w+)(?::([^}]*))?\}")
_PART = re.compile(r"\[([^\[\]]*)\]")
_BLANK = re.compile(r"\\\{(\w+)\\\}")


@dataclass(frozen=True, slots=True)
class Wording:
    """A phrasebook and the slots to fill its templates with.

    Parameters
    ----------
    book : mapping
        The plain values of ``says.yaml``.
    slots : mapping
    kinds : mapping of str to callable
        How the value of a slot becomes words.
    """

    book: Mapping[str, Any]
    slots: Mapping[str, Any]
    kinds: Mapping[str, Callable[[Wording, Any], str]]

    def fill(self, template: str) -> str:
        """Return a template with its slots filled and empty parts left out."""
        told = _PART.sub(self._part, template)
        return _SLOT.sub(self._slot, told)

    def filled(self, template: str, slots: Mapping[str, Any]) -> str:
        """Return a template filled with other slots."""
        return replace(self, slots=slots).fill(template)

    def _part(self, found: re.Match[str]) -> str:
        wanted = [name for name, _ in _SLOT.findall(found.group(1))]
        if any(_empty(self.slots.get(name)) for name in wanted):
            return ""
        return _SLOT.sub(self._slot, found.group(1))

    def _slot(self, found: re.Match[str]) -> str:
        name, kind = found.groups()
        return self._word(self.slots.get(name), kind or "")

    def _word(self, value: Any, kind: str) -> str:
        if not kind:
            return "" if value is None else self.told(value)
        make = self.kinds.get(kind)
        if make is not None:
            return make(self, value)
        table = self.book["words"].get(kind)
        if isinstance(table, Mapping):
            return str(table.get(value, value or ""))
        return self.number(value, kind) if isinstance(value, int | float) else self.told(value)

    def number(self, value: float, kind: str = "g") -> str:
        """Return a number with the mark for decimals that the language uses."""
        return format(value, kind).replace(".", str(self.book["words"]["decimal"]))

    def told(self, value: Any) -> str:
        """Return a value as the language calls it: a thing's name, a direction, a place."""
        if isinstance(value, float):
            return str(value).replace(".", str(self.book["words"]["decimal"]))
        return in_own_words(str(value or ""), self.book["given"]) if value != 0 else "0"

    def among(self, part: str, key: str) -> str:
        """Return a word of the book, or the key itself where the book has none."""
        found = self.book[part].get(key, key)
        return str(found)

    def words(self, template: str, slots: Mapping[str, Any]) -> str:
        """Return a template of the book's ``words`` filled with other slots."""
        return self.filled(self.book["words"][template], slots)

    def joined(self, texts: Sequence[str]) -> str:
        """Return "a, b and c"."""
        if len(texts) < 2:
            return "".join(texts)
        return str(self.book["words"]["and"]).join((", ".join(texts[:-1]), texts[-1]))


def in_own_words(text: str, given: Mapping[str, str]) -> str:
    """Return a text that the program made, such as "grasp of block", as the language tells it.

    Parameters
    ----------
    text : str
    given : mapping
        Templates for such texts; what stands in a ``{blank}`` is looked up in turn.
    """
    if text in given:
        return given[text]
    for template, own in given.items():
        if "{" not in template:
            continue
        hit = re.fullmatch(_BLANK.sub(r"(?P<\1>.+?)", re.escape(template)), text)
        if hit:
            told = {name: in_own_words(part, given) for name, part in hit.groupdict().items()}
            return own.format(**told)
    return text


def _empty(value: Any) -> bool:
    return value is None or value == "" or value == [] or value == () or value is False
