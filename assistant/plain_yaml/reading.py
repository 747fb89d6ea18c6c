"""Reads YAML into plain values and remembers on which line each stands.

Only mappings with text keys, lists and scalars exist; tags, repeated keys, and aliases that
would unfold into more than `MOST_NODES` values are refused. Nothing in a file can name code.
"""

from __future__ import annotations

import re
from dataclasses import dataclass, field
from pathlib import Path

import yaml

from assistant.errors import BadInput, Problem
from assistant.plain_yaml.scalars import meaning
from assistant.plain_yaml.values import Document, Lines, Value, line_of

MOST_BYTES = 32_000_000
MOST_NODES = 2_000_000
DEEPEST = 64
MOST_PROBLEMS = 50
_PAIR = re.compile(
    r"(?P<before>(?<!\\)(?:\\\\)*)"
    r"\\u(?P<high>[dD][89abAB][0-9a-fA-F]{2})\\u(?P<low>[dD][c-fC-F][0-9a-fA-F]{2})"
)
_LOADER = getattr(yaml, "CSafeLoader", yaml.SafeLoader)


def read_file(path: Path, *, flawed: bool = False) -> tuple[Document, ...]:
    """Return every document of a file; see `read_text`. JSON is YAML but for its far letters."""
    text = text_of(path)
    if path.suffix.lower() == ".json":
        text = _PAIR.sub(_one_letter, text)
    return read_text(text, str(path), flawed=flawed)


def _one_letter(pair: re.Match[str]) -> str:
    r"""Return the letter two surrogates stand for, as JSON spells it: ``\ud83d\ude00``."""
    halves = bytes.fromhex(pair["high"] + pair["low"])
    return pair["before"] + halves.decode("utf-16-be")


def text_of(path: Path, most_bytes: int = MOST_BYTES) -> str:
    """Return the text of a file, or raise `BadInput` saying why it cannot be read."""
    try:
        size = path.stat().st_size
        if path.is_dir():
            raise BadInput.one(str(path), "this is a folder", "name a file in it")
        if size > most_bytes:
            raise _too_big(path, f"{size / 1e6:.0f} MB, more than", most_bytes)
        with path.open("rb") as file:  # a pipe tells its size only by being read
            data = file.read(most_bytes + 1)
    except FileNotFoundError as error:
        raise BadInput.one(str(path), "no such file", "check the name and the folder") from error
    except (OSError, ValueError) as error:
        why = getattr(error, "strerror", None) or str(error)
        raise BadInput.one(str(path), f"cannot be read ({why})", "another file") from error
    if len(data) > most_bytes:
        raise _too_big(path, "more than", most_bytes)
    return _decoded(data, str(path))


def _too_big(path: Path, told: str, most_bytes: int) -> BadInput:
    what = f"{told} the {most_bytes / 1e6:.0f} MB a file may have"
    return BadInput.one(str(path), what, "give a smaller file")


def _decoded(data: bytes, file: str) -> str:
    if b"\x00" in data[:4096]:
        raise BadInput.one(f"{file}:1", "this is a binary file", "a text file in UTF-8 is needed")
    try:
        return data.decode("utf-8-sig")
    except UnicodeDecodeError as error:
        line = data.count(b"\n", 0, error.start) + 1
        raise BadInput.one(f"{file}:{line}", "not UTF-8 text", "save it as UTF-8") from error


def read_text(text: str, file: str = "<text>", *, flawed: bool = False) -> tuple[Document, ...]:
    """Return the documents of a YAML text.

    Parameters
    ----------
    text : str
    file : str
        Its name, for messages.
    flawed : bool
        Go on in spite of repeated keys and tags, which then stand with their document: for
        readers that tell them together with whatever else is wrong.

    Raises
    ------
    BadInput
        With every repeated key and tag, or the first place where it is no YAML.
    """
    builder = _Builder(file)
    broken: Problem | None = None
    try:
        for event in yaml.parse(text, Loader=_LOADER):
            builder.take(event)
    except yaml.MarkedYAMLError as error:
        broken = _no_yaml(error, file)
    except yaml.reader.ReaderError as error:
        line = text.count("\n", 0, error.position) + 1
        what = f"character number {error.character} does not belong into text"
        broken = Problem(f"{file}:{line}", what, "leave it out; is this a binary file?")
    except (UnicodeError, RecursionError) as error:
        broken = Problem(f"{file}:1", f"this is no text ({error})", "save it as UTF-8")
    if broken is not None:
        builder.problems.append(broken)
    if builder.problems and (broken is not None or not flawed):
        raise BadInput(builder.problems[:MOST_PROBLEMS])
    return tuple(builder.documents)


def _no_yaml(error: yaml.MarkedYAMLError, file: str) -> Problem:
    unclosed = "quoted scalar" in (error.context or "")
    mark = (unclosed and error.context_mark) or error.problem_mark or error.context_mark
    where = f"{file}:{mark.line + 1}" if mark else file
    began = error.context_mark
    context = ""
    if error.context and began and mark and began.line != mark.line:
        context = f" {error.context} that began on line {began.line + 1}"
    return Problem(where, f"not YAML: {error.problem or 'cannot be read'}{context}", _hint(error))


def _hint(error: yaml.MarkedYAMLError) -> str:
    problem = error.problem or ""
    if "mapping values are not allowed" in problem:
        return "put text that contains ': ' in quotes"
    if "tab" in problem or "cannot start any token" in problem:
        return "indent with spaces, and quote text that begins with a sign"
    if "quoted scalar" in (error.context or ""):
        return "close the quotes"
    if "expected ',' or" in problem:
        return "close the bracket, and quote text that contains brackets or commas"
    return "check indentation, colons and brackets there"


def _short(text: str) -> str:
    return repr(text if len(text) <= 60 else f"{text[:57]}...")


def _line(event: yaml.Event) -> int:
    return event.start_mark.line + 1 if event.start_mark else 0


@dataclass(slots=True)
class _Open:
    """A mapping or list that is being read."""

    line: int
    value: dict[str, Value] | list[Value]
    lines: dict[str, Lines] | list[Lines]
    anchor: str | None
    size: int = 1
    key: str | None = None


@dataclass(slots=True)
class _Builder:
    """Takes parser events one by one; no recursion, so depth cannot crash it."""

    file: str
    documents: list[Document] = field(default_factory=list)
    problems: list[Problem] = field(default_factory=list)
    stack: list[_Open] = field(default_factory=list)
    anchors: dict[str, tuple[Value, Lines, int]] = field(default_factory=dict)
    told: int = 0

    def take(self, event: yaml.Event) -> None:
        match event:
            case yaml.ScalarEvent():
                self._scalar(event)
            case yaml.SequenceStartEvent():
                self._begin(event, [], [])
            case yaml.MappingStartEvent():
                self._begin(event, {}, {})
            case yaml.SequenceEndEvent() | yaml.MappingEndEvent():
                done = self.stack.pop()
                self._put(done.value, (done.line, done.lines), done.size, done.anchor)
            case yaml.AliasEvent():
                self._alias(event)
            case yaml.DocumentStartEvent():
                self.anchors.clear()
                self.told = len(self.problems)
            case _:
                pass

    def _scalar(self, event: yaml.ScalarEvent) -> None:
        line = _line(event)
        if event.tag is not None:
            self._no_tag(event.tag, line)
        top = self.stack[-1] if self.stack else None
        if top is not None and top.key is None and isinstance(top.value, dict):
            self._key(event.value, line)
            return
        value = event.value if event.style else meaning(event.value)
        if top is None or event.anchor:
            self._put(value, line, 1, event.anchor)
        elif isinstance(top.value, list) and isinstance(top.lines, list):
            # Nearly all of a long file are numbers in rows: the shortest way for them.
            top.value.append(value)
            top.lines.append(line)
            top.size += 1
            if top.size > MOST_NODES:
                self._fail(line, f"more than {MOST_NODES:,} values", "a smaller file")
        else:
            self._put(value, line, 1, None)

    def _wants_key(self) -> bool:
        return (
            bool(self.stack)
            and self.stack[-1].key is None
            and isinstance(self.stack[-1].value, dict)
        )

    def _key(self, key: str, line: int) -> None:
        top = self.stack[-1]
        top.key = key
        if isinstance(top.lines, dict):
            if key in top.lines:
                first = line_of(top.lines[key])
                self._tell(
                    line,
                    f"key {_short(key)} stands here again (first on line {first})",
                    "each key once",
                )
            top.lines[key] = line

    def _begin(
        self,
        event: yaml.SequenceStartEvent | yaml.MappingStartEvent,
        value: dict[str, Value] | list[Value],
        lines: dict[str, Lines] | list[Lines],
    ) -> None:
        line = _line(event)
        self._no_tag(event.tag, line)
        if self._wants_key():
            self._fail(line, "a key must be a word, not a list or mapping", "write key: value")
        if len(self.stack) >= DEEPEST:
            self._fail(line, f"nested deeper than {DEEPEST} levels", "a flatter file")
        self.stack.append(_Open(line, value, lines, event.anchor))

    def _alias(self, event: yaml.AliasEvent) -> None:
        line = _line(event)
        if self._wants_key():
            self._fail(line, "a key must be a word, not an alias", "write key: value")
        anchor = event.anchor or ""
        if anchor not in self.anchors:
            self._fail(
                line,
                f"*{anchor[:40]} names nothing that is complete above",
                f"mark a value above with &{anchor[:40]}",
            )
        value, lines, size = self.anchors[anchor]
        self._put(value, lines, size, None)

    def _put(self, value: Value, lines: Lines, size: int, anchor: str | None) -> None:
        if anchor:
            self.anchors[anchor] = (value, lines, size)
        if not self.stack:
            flaws = tuple(self.problems[self.told :])
            self.documents.append(Document(value, lines, self.file, flaws))
            return
        top = self.stack[-1]
        top.size += size
        if top.size > MOST_NODES:
            self._fail(line_of(lines), f"more than {MOST_NODES:,} values", "a smaller file")
        if isinstance(top.value, list) and isinstance(top.lines, list):
            top.value.append(value)
            top.lines.append(lines)
        elif isinstance(top.value, dict) and isinstance(top.lines, dict):
            key = top.key or ""
            top.value[key] = value
            # The line of a key is where a reader looks, not where its value begins.
            top.lines[key] = (
                lines if isinstance(lines, int) else (line_of(top.lines[key]), lines[1])
            )
            top.key = None

    def _no_tag(self, tag: str | None, line: int) -> None:
        if tag is not None:
            self._tell(line, f"tag {_short(tag)} is not allowed", "write plain values without '!'")

    def _tell(self, line: int, what: str, right: str) -> None:
        self.problems.append(Problem(f"{self.file}:{line}", what, right))

    def _fail(self, line: int, what: str, right: str) -> None:
        raise BadInput([*self.problems, Problem(f"{self.file}:{line}", what, right)])
