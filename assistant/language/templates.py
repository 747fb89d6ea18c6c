"""Templates of sentences: ``(a|b)`` chooses, ``[a]`` may be missing, ``<rule>``, ``{slot}``.

A template becomes a small tree that is matched against words from left to right. Choices
between plain phrases are kept as a tree of words, so that their number costs nothing.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace

Bound = tuple[tuple[str, int, int], ...]
Reader = Callable[[Sequence[str], int], Iterator[int]]
_TOKENS = re.compile(r"\{[^}]*\}|<[^>]*>|[()\[\]|?]|[^\s(){}\[\]<>|?]+")
_END = ""


@dataclass(frozen=True, slots=True)
class Slot:
    """The teacher's own words; `reader` limits what they may be (numbers).

    Only words of `follows` come behind, where that is known: it tells where the slot may end.
    """

    name: str
    reader: Reader | None = None
    follows: frozenset[str] | None = None


@dataclass(frozen=True, slots=True)
class Phrases:
    """A choice between phrases, as nested mappings word -> rest; ``""`` marks an end."""

    tree: Mapping[str, object]


@dataclass(frozen=True, slots=True)
class Choice:
    """A choice between sequences; the empty sequence makes it optional."""

    ways: tuple[tuple[Node, ...], ...]


Node = str | Slot | Phrases | Choice


@dataclass
class _Reading:
    tokens: list[str]
    rules: Mapping[str, str]
    readers: Mapping[str, Reader]
    at: int = 0
    made: dict[str, Node] = field(default_factory=dict)

    def ways(self) -> tuple[tuple[Node, ...], ...]:
        """Read sequences separated by ``|`` up to a closing bracket or the end."""
        ways: list[tuple[Node, ...]] = []
        nodes: list[Node] = []
        while self.at < len(self.tokens):
            token = self.tokens[self.at]
            if token in (")", "]"):
                break
            self.at += 1
            if token == "|":
                ways.append(_followed(nodes))
                nodes = []
            elif token == "?":
                nodes[-1] = Choice(((nodes[-1],), ()))
            else:
                nodes.append(self.node(token))
        ways.append(_followed(nodes))
        return tuple(ways)

    def node(self, token: str) -> Node:
        """Read one element that begins with `token`."""
        if token in ("(", "["):
            ways = self.ways()
            self.at += 1
            return _choice((*ways, ()) if token == "[" else ways)
        if token.startswith("<"):
            return self.rule(token[1:-1])
        if token.startswith("{"):
            name = token[1:-1]
            return Slot(name, self.readers.get(name.partition(":")[0]))
        return token

    def rule(self, name: str) -> Node:
        """Return the node of a rule, read once."""
        if name not in self.made:
            tokens = _TOKENS.findall(self.rules[name])
            inner = _Reading(tokens, self.rules, self.readers, made=self.made)
            self.made[name] = _choice(inner.ways())
        return self.made[name]


def _followed(nodes: Sequence[Node]) -> tuple[Node, ...]:
    """Return the nodes, each slot with the words one of which must come behind it."""
    found: list[Node] = []
    for at, node in enumerate(nodes):
        rest = nodes[at + 1 :]
        if isinstance(node, Slot) and node.reader is None and rest and not _empty(rest):
            node = replace(node, follows=first_words(rest))
        found.append(node)
    return tuple(found)


def _choice(ways: tuple[tuple[Node, ...], ...]) -> Node:
    """Return a tree of words if all ways are plain, else the choice itself."""
    plain = [way for way in ways if all(isinstance(node, str) for node in way)]
    rest = tuple(way for way in ways if not all(isinstance(node, str) for node in way))
    if len(plain) < 2:
        return Choice(ways) if len(ways) > 1 or len(ways[0]) != 1 else ways[0][0]
    tree: dict[str, object] = {}
    for way in plain:
        at = tree
        for word in way:
            below = at.setdefault(str(word), {})
            at = below if isinstance(below, dict) else {}
        at[_END] = {}
    return Choice(((Phrases(tree),), *rest)) if rest else Phrases(tree)


def compiled(
    template: str,
    rules: Mapping[str, str],
    readers: Mapping[str, Reader],
    made: dict[str, Node] | None = None,
) -> tuple[Node, ...]:
    """Return the sequence of nodes a template stands for; `made` keeps rules between calls."""
    reading = _Reading(_TOKENS.findall(template), rules, readers, made={} if made is None else made)
    ways = reading.ways()
    return ways[0] if len(ways) == 1 else (_choice(ways),)


def matches(nodes: Sequence[Node], words: Sequence[str]) -> Iterator[Bound]:
    """Yield every way the whole of `words` matches, shortest slots first."""
    for end, bound in _run(tuple(nodes), words, 0, ()):
        if end == len(words):
            yield bound


def _run(
    nodes: tuple[Node, ...], words: Sequence[str], at: int, bound: Bound, *, tail: bool = True
) -> Iterator[tuple[int, Bound]]:
    """Yield where matches of nodes end; at the `tail` a slot takes all that is left."""
    if not nodes:
        yield at, bound
        return
    node, rest = nodes[0], nodes[1:]
    if isinstance(node, str):
        if at < len(words) and words[at] == node:
            yield from _run(rest, words, at + 1, bound, tail=tail)
        return
    if isinstance(node, Slot):
        for end in _slot_ends(node, words, at, last=tail and not rest):
            yield from _run(rest, words, end, (*bound, (node.name, at, end)), tail=tail)
        return
    if isinstance(node, Phrases):
        for end in _phrase_ends(node, words, at):
            yield from _run(rest, words, end, bound, tail=tail)
        return
    for way in node.ways:
        for end, more in _run(way, words, at, bound, tail=tail and not rest):
            yield from _run(rest, words, end, more, tail=tail)


def _slot_ends(slot: Slot, words: Sequence[str], at: int, *, last: bool) -> Iterator[int]:
    if slot.reader is not None:
        return slot.reader(words, at)
    if last:
        return iter((len(words),) if at < len(words) else ())
    follows = slot.follows
    if follows is not None:
        return (end for end in range(at + 1, len(words)) if words[end] in follows)
    return iter(range(at + 1, len(words) + 1))


def _phrase_ends(phrases: Phrases, words: Sequence[str], at: int) -> Iterator[int]:
    """Yield where phrases that begin at `at` end, longest first."""
    found: list[int] = []
    tree: Mapping[str, object] = phrases.tree
    end = at
    while True:
        if _END in tree:
            found.append(end)
        below = tree.get(words[end]) if end < len(words) else None
        if not isinstance(below, dict):
            break
        tree, end = below, end + 1
    return iter(reversed(found))


def first_words(nodes: Sequence[Node]) -> frozenset[str] | None:
    """Return the words a match can begin with; None if it can begin with anything."""
    found: set[str] = set()
    for node in nodes:
        if isinstance(node, str):
            return frozenset(found | {node})
        if isinstance(node, Slot):
            return None
        ways = [first_words(way) for way in node.ways] if isinstance(node, Choice) else []
        if any(way is None for way in ways):
            return None
        tree = node.tree if isinstance(node, Phrases) else {}
        found |= {word for word in tree if word}
        found |= {word for way in ways if way for word in way}
        empty = _END in tree or (isinstance(node, Choice) and any(_empty(w) for w in node.ways))
        if not empty:
            return frozenset(found)
    return frozenset(found)


def last_words(nodes: Sequence[Node]) -> frozenset[str] | None:
    """Return the words a match can end with; None if it can end with anything."""
    found: set[str] = set()
    for node in reversed(nodes):
        if isinstance(node, str):
            return frozenset(found | {node})
        if isinstance(node, Slot):
            return None
        ways = [last_words(way) for way in node.ways] if isinstance(node, Choice) else []
        if any(way is None for way in ways):
            return None
        found |= {word for way in ways if way for word in way}
        found |= set(_tree_ends(node.tree)) if isinstance(node, Phrases) else set()
        if not _empty((node,)):
            return frozenset(found)
    return frozenset(found)


def _tree_ends(tree: Mapping[str, object]) -> Iterator[str]:
    for word, below in tree.items():
        if isinstance(below, dict) and word:
            if _END in below:
                yield word
            yield from _tree_ends(below)


def _empty(way: Sequence[Node]) -> bool:
    return all(
        (isinstance(node, Phrases) and _END in node.tree)
        or (isinstance(node, Choice) and any(_empty(one) for one in node.ways))
        for node in way
    )


def needed_words(nodes: Sequence[Node]) -> tuple[frozenset[str], ...]:
    """Return sets of words of which a match holds one each; slots and what may miss need none."""
    found: list[frozenset[str]] = []
    for node in nodes:
        if isinstance(node, str):
            found.append(frozenset([node]))
        elif isinstance(node, Phrases) and _END not in node.tree:
            found.append(frozenset(_tree_words(node.tree)))
        elif isinstance(node, Choice) and not any(_empty(way) or _free(way) for way in node.ways):
            found.append(frozenset(all_words([node])))
    return tuple(found)


def _free(nodes: Sequence[Node]) -> bool:
    """Tell whether a way may be matched by a slot alone."""
    return not needed_words(nodes)


def has_slot(nodes: Sequence[Node]) -> bool:
    """Tell whether the teacher's own words stand anywhere in a template."""
    return any(
        isinstance(node, Slot)
        or (isinstance(node, Choice) and any(has_slot(way) for way in node.ways))
        for node in nodes
    )


def all_words(nodes: Sequence[Node]) -> set[str]:
    """Return every word that occurs in a template."""
    found: set[str] = set()
    for node in nodes:
        if isinstance(node, str):
            found.add(node)
        elif isinstance(node, Phrases):
            found |= _tree_words(node.tree)
        elif isinstance(node, Choice):
            for way in node.ways:
                found |= all_words(way)
    return found


def _tree_words(tree: Mapping[str, object]) -> set[str]:
    found = {word for word in tree if word}
    for below in tree.values():
        if isinstance(below, dict):
            found |= _tree_words(below)
    return found
