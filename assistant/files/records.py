"""A task with its lesson as a readable record in Markdown, in the language of its teacher."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

from assistant.geometry import pose_to_mm_deg
from assistant.language.hints import page
from assistant.language.speech import in_words
from assistant.model.conditions import Condition
from assistant.model.feedback import Feedback
from assistant.model.lesson import Episode, Lesson, Station
from assistant.model.task import Primitive, Subtask, Task


def record(task: Task, language: str = "english") -> str:
    """Return the record of a task with its lesson.

    Parameters
    ----------
    task : Task
    language : str
        Of the phrasebook that has the headings; names stay the teacher's own.
    """
    return "\n".join([*_Record(language, page("record", language)).lines(task), ""])


def plain_markdown(text: str) -> str:
    """Return text in which no sign means anything to Markdown."""
    return re.sub(r"([\\`*_\[\]<>|#])", r"\\\1", " ".join(text.split()))


@dataclass(frozen=True, slots=True)
class _Record:
    """How a language writes a task down."""

    language: str
    words: Mapping[str, Any]

    def lines(self, task: Task) -> Iterator[str]:
        yield f"# {plain_markdown(task.name)}"
        if task.goal:
            yield self._told("goal", goal=task.goal)
        if task.objects:
            roles = self.words["roles"]
            things = ((self._thing(each.name), roles[each.role]) for each in task.objects)
            told = ", ".join(f"{name} ({role})" for name, role in things)
            yield self._told("objects", objects=told)
        yield f"\n## {self.words['steps']}\n"
        yield from self._parts(task.tree, 0)
        if task.learned is not None:
            yield from self._lesson(task.learned)

    def _told(self, label: str, **slots: str) -> str:
        """Return a line of its own, a label of the language filled."""
        return f"\n{plain_markdown(self.words[label].format(**slots))}"

    def _parts(self, subtask: Subtask, depth: int) -> Iterator[str]:
        for number, part in enumerate(subtask.parts, start=1):
            optional = f" {self.words['optional']}" if part.optional else ""
            head = f"{'   ' * depth}{number}. "
            if isinstance(part, Subtask):
                order = f", {self.words['any_order']}" if part.order == "any" else ""
                goal = f": {plain_markdown(part.goal)}" if part.goal else ""
                yield f"{head}**{plain_markdown(part.name)}**{goal}{order}{optional}"
                yield from self._parts(part, depth + 1)
            else:
                does = plain_markdown("; ".join(self._does(part)))
                yield f"{head}{plain_markdown(part.name)} ({does}){optional}"

    def _does(self, part: Primitive) -> Iterator[str]:
        """Yield what a step does, and what holds before it and at its end."""
        action = part.action
        plain = {action.verb: action.way} | ({"object": action.object} if action.object else {})
        yield in_words(plain, self.language, kind="action")
        for label, conditions in (("before", part.before), ("until", part.until)):
            if conditions:
                told = in_words([_plain(one) for one in conditions], self.language, kind=_ALL)
                yield self.words[label].format(conditions=told)

    def _lesson(self, lesson: Lesson) -> Iterator[str]:
        words, cuts = self.words, lesson.segmentation
        yield f"\n## {words['learned']}\n"
        sources = ", ".join(Path(source).name for source in lesson.sources)
        yield self._told("source", sources=sources or words["demonstration"]).lstrip()
        if cuts.episodes:
            yield from _table(words["episodes"], [self._episode(each) for each in cuts.episodes])
        if lesson.stations:
            yield from _table(words["stations"], [self._docking(each) for each in lesson.stations])
        if lesson.feedback:
            yield f"\n## {words['corrections']}\n"
            yield from (f"* {plain_markdown(self._correction(each))}" for each in lesson.feedback)

    def _episode(self, one: Episode) -> tuple[str, ...]:
        times = (self._number(at, ".2f") for at in (one.from_s, one.to_s))
        motion = self.words["motions"].get(one.character, one.character)
        return *times, one.primitive or self.words["nobody"], f"{one.probability:.0%}", motion

    def _docking(self, one: Station) -> tuple[str, ...]:
        mm, deg = pose_to_mm_deg(one.docking_in_frame)
        kind, world = self.words["dockings"][one.kind], self.words["frames"].get(one.frame)
        names = self._thing(one.object), world or self._thing(one.frame)
        return kind, *names, self._numbers(mm), self._numbers(deg)

    def _correction(self, one: Feedback) -> str:
        turned = (float(np.rad2deg(angle)) for angle in one.turn_rad)
        change = self.words["changes"][one.hand or one.kind].format(
            offset=self._numbers(1000.0 * far for far in one.offset_m),
            turn=self._numbers(turned),
            factor=self._number(one.factor, ".2f"),
        )
        where = self.words["where"][one.when].format(step=one.primitive) if one.primitive else ""
        frame = self.words["moves_with"].format(frame=self._thing(one.frame)) if one.frame else ""
        told = {"words": one.words, "change": change, "where": where, "frame": frame}
        return str(self.words["correction"].format(**told))

    def _thing(self, name: str) -> str:
        """Return a thing's name; those of the shipped scenes have one in each language."""
        return in_words(name, self.language)

    def _numbers(self, values: Iterable[float]) -> str:
        told = (self._number(round(value, 1) + 0.0, ".1f") for value in values)
        return str(self.words["between"]).join(told)

    def _number(self, value: float, how: str) -> str:
        return format(value, how).replace(".", self.words["decimal"])


_ALL = "conditions"


def _plain(condition: Condition) -> dict[str, Any]:
    """Return a condition as files write it."""
    if condition.target:
        return {condition.kind: {"object": condition.object, "target": condition.target}}
    return {condition.kind: condition.object}


def _table(head: Sequence[str], rows: Sequence[Sequence[str]]) -> Iterator[str]:
    yield f"\n| {' | '.join(head)} |"
    yield f"|{'---|' * len(head)}"
    for row in rows:
        yield f"| {' | '.join(plain_markdown(cell) for cell in row)} |"
