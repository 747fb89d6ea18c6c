"""The task tree and what was learned for it, for people at a terminal."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from pathlib import Path
from typing import Literal

from rich.console import Group, RenderableType
from rich.markup import escape
from rich.table import Table
from rich.text import Text
from rich.tree import Tree

from assistant.files.wording import action_words, conditions_words, feedback_words, numbers_words
from assistant.geometry import pose_to_mm_deg
from assistant.model.lesson import Lesson, SegmentationPoint, Station
from assistant.model.task import Primitive, Subtask, Task
from assistant.shells import curves

COLUMNS = 60
Labels = Mapping[str, str]
"""What is written over tables and beside trees in another language; the rest is as it is."""
NO_LABELS: Labels = {}
_Words = Callable[[Primitive], tuple[str, str]]


def task_view(task: Task) -> RenderableType:
    """Return a whole task: its tree and, where there is one, its lesson."""
    parts: list[RenderableType] = [task_tree(task)]
    if task.objects:
        told = ", ".join(f"{each.name} ({each.role})" for each in task.objects)
        parts.append(Text(f"objects: {told}"))
    if task.learned is None:
        parts.append(Text("nothing has been shown yet", style="dim"))
    else:
        parts.extend(lesson_views(task.learned))
    return Group(*parts)


def task_tree(
    task: Task,
    labels: Labels = NO_LABELS,
    told: Callable[[Primitive], str] = action_words,
    held: Callable[[Primitive], str] = conditions_words,
) -> Tree:
    """Return the tree with actions and conditions, numbered as people refer to it.

    Parameters
    ----------
    task : Task
    labels : mapping
    told : callable
        Words for what a primitive does.
    held : callable
        Words for what holds before it and at its end.
    """
    goal = f"[dim]: {escape(task.goal)}[/dim]" if task.goal else ""
    tree = Tree(f"[bold]{escape(task.name)}[/bold]{goal}")
    _add_parts(tree, task.tree, "", labels, lambda part: (told(part), held(part)))
    return tree


def _add_parts(tree: Tree, subtask: Subtask, number: str, labels: Labels, told: _Words) -> None:
    any_order, optional_word = (labels.get(one, one) for one in ("in any order", "optional"))
    if subtask.order == "any" and len(subtask.parts) > 1:
        tree.label = f"{tree.label} [dim]({any_order})[/dim]"
    for position, part in enumerate(subtask.parts, start=1):
        here = f"{number}{position}"
        optional = f" [dim]({optional_word})[/dim]" if part.optional else ""
        if isinstance(part, Subtask):
            goal = f"[dim]: {escape(part.goal)}[/dim]" if part.goal else ""
            branch = tree.add(f"{here} [bold]{escape(part.name)}[/bold]{goal}{optional}")
            _add_parts(branch, part, f"{here}.", labels, told)
        else:
            does, holds = told(part)
            leaf = f"{here} {escape(part.name)} [dim]({escape(does)})[/dim]{optional}"
            tree.add(leaf + (f"\n[dim]{escape(holds)}[/dim]" if holds else ""))


def lesson_views(lesson: Lesson) -> Iterator[RenderableType]:
    """Yield what was learned: source, votes, cuts, episodes, docking, corrections, questions."""
    yield Text(_summary(lesson))
    yield from segmentation_views(lesson)
    if lesson.stations:
        yield _stations(lesson.stations)
    yield from (Text(f"correction: {feedback_words(each)}") for each in lesson.feedback)
    for question in lesson.segmentation.questions:
        about = f" about {question.about}" if question.about else ""
        yield Text(f"open question: {question.asked}{about} ({question.reason})", style="magenta")


def segmentation_views(lesson: Lesson, labels: Labels = NO_LABELS) -> Iterator[RenderableType]:
    """Yield the course of the vote, the cuts and the episodes."""
    if len(lesson.segmentation.vote_t_s) > 1:
        yield curves.Picture(lambda blocks, wide: votes_picture(lesson, blocks, wide, labels))
    if lesson.segmentation.points:
        yield _points(lesson.segmentation.points, labels)
    if lesson.segmentation.episodes:
        yield episodes_view(lesson, labels)


def _summary(lesson: Lesson) -> str:
    sources = ", ".join(Path(source).name for source in lesson.sources)
    told = [f"learned from {sources or 'a demonstration'}"]
    if lesson.path is not None:
        told.append(f"path of {lesson.path.t_s[-1] - lesson.path.t_s[0]:.1f} s")
        told.append(f"{len(lesson.path.t_s)} samples")
    if lesson.segmentation.cue_lag_s is not None:
        told.append(f"cues {lesson.segmentation.cue_lag_s:.2f} s late")
    if lesson.speed != 1.0:
        told.append(f"speed {lesson.speed:.0%} of the demonstration's")
    return "; ".join(told)


def votes_picture(
    lesson: Lesson, blocks: str, columns: int = COLUMNS, labels: Labels = NO_LABELS
) -> str:
    """Return the course of the vote with a mark at each cut."""
    cuts = lesson.segmentation
    lines = [
        labels.get("votes", "votes"),
        *curves.bars(curves.sampled(cuts.vote_t_s, cuts.vote, columns), blocks=blocks),
        curves.marks(cuts.cuts_s, cuts.vote_t_s, columns, "|"),
        curves.axis(cuts.vote_t_s, columns, labels.get(".", ".")),
    ]
    return "\n".join(lines)


def _table(title: str, *columns: str, labels: Labels = NO_LABELS) -> Table:
    named = labels.get(title, title)
    table = Table(title=named, title_justify="left", box=None, pad_edge=False)
    for column in columns:
        justify: Literal["left", "right"] = "left" if column.islower() else "right"
        table.add_column(labels.get(column, column), justify=justify)
    return table


def _number(value: float, labels: Labels) -> str:
    """Return a number with the mark for decimals that the labels name."""
    return f"{value:.2f}".replace(".", labels.get(".", "."))


def _joint(labels: Labels) -> str:
    return "; " if labels.get(".") == "," else ", "


def _points(points: Sequence[SegmentationPoint], labels: Labels) -> Table:
    table = _table("cuts", "at s", "confidence", "kind", "votes", labels=labels)
    for point in points:
        kind = "eliminated" if not point.kept else "inside one" if point.internal else "cut"
        shown = ((labels.get(name, name), vote) for name, vote in point.votes.items())
        votes = _joint(labels).join(f"{name} {_number(vote, labels)}" for name, vote in shown)
        style = "" if point.kept and not point.internal else "dim"
        at_s = _number(point.at_s, labels)
        row = (at_s, f"{point.confidence:.0%}", labels.get(kind, kind), votes)
        table.add_row(*map(escape, row), style=style)
    return table


def episodes_view(lesson: Lesson, labels: Labels) -> Table:
    """Return the parts of what was shown, numbered, and what they were taken for."""
    heads = ("nr", "from s", "to s", "primitive", "sure", "motion")
    table = _table("episodes", *heads, labels=labels)
    unknown = "(nobody introduced it)"
    for number, episode in enumerate(lesson.segmentation.episodes, start=1):
        row = (
            str(number),
            _number(episode.from_s, labels),
            _number(episode.to_s, labels),
            episode.primitive or labels.get(unknown, unknown),
            f"{episode.probability:.0%}",
            labels.get(episode.character, episode.character),
        )
        table.add_row(*map(escape, row))
    return table


def _stations(stations: Sequence[Station]) -> Table:
    table = _table("docking", "kind", "object", "frame", "docking from there, mm and deg")
    for station in stations:
        mm, deg = pose_to_mm_deg(station.docking_in_frame)
        place = f"({numbers_words(mm)}) turned ({numbers_words(deg)})"
        table.add_row(*map(escape, (station.kind, station.object, station.frame, place)))
    return table
