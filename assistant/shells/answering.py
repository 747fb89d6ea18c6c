"""Answers of the robot that are better seen than read: trees, tables and small pictures."""

from __future__ import annotations

import io
import os
import sys
from collections.abc import Mapping
from functools import partial
from typing import Any

import numpy as np
from rich.console import Console, Group, RenderableType
from rich.table import Table
from rich.text import Text

from assistant.dialogue.conditions import plain_conditions
from assistant.dialogue.knowledge import Knowledge
from assistant.dialogue.turn import plain_action
from assistant.language.hints import hints, mentions, page
from assistant.language.speech import in_words
from assistant.model.lesson import LearnedPath, Lesson
from assistant.model.robot_acts import RobotAct
from assistant.model.task import Primitive
from assistant.session.loop import Session
from assistant.shells import curves
from assistant.shells.telling import setup_view
from assistant.shells.trees import Labels, episodes_view, segmentation_views, task_tree

ROWS = 9


CHANGES = (
    "name",
    "optional",
    "required",
    "unordered",
    "ordered",
    "added",
    "removed",
    "merged",
    "split",
)
"""Changes of the plan after which it is drawn anew: labels of what can be undone."""
TOPICS = (*CHANGES, "renamed", "dissolved")


def picture(session: Session, line: RobotAct, *, asked: str = "") -> RenderableType | None:
    """Return what to show instead of a line's sentence, None where that tells it best.

    `asked` is what was typed: how the cuts were found is drawn only for who asks for that.
    """
    if line.act != "told":
        return None
    known = session.dialogue.known
    words = page("terminal", session.language)["tables"]
    labels: Labels = {**_motions(known, session.language), **words["labels"]}
    match line.topic:
        case "tree":
            return _tree(session, labels)
        case "plan" | "conditions":
            return _sentences(session.phrased(line))
        case "corrections":
            told = session.phrased(line).split("\n")
            return _sentences("\n".join(one for one in told if one[:1].isdigit()))
        case "setup" if known.setup.places:
            return setup_view(known.setup, labels)
        case "episodes" if known.lesson is not None and not _in_full(asked, session.language):
            more = page("terminal", session.language)["more_of_cuts"]
            return Group(episodes_view(known.lesson, labels), Text(more, style="dim"))
        case _ if known.lesson is not None:
            return _of_lesson(known, known.lesson, line.topic, words, labels)
        case _:
            return None


def _in_full(asked: str, language: str) -> bool:
    return not asked or mentions(asked, hints("cuts_in_full", language))


def redrawn(session: Session, line: RobotAct) -> RenderableType | None:
    """Return the plan after a change of it, None after other lines and where it follows anyway."""
    told = line.topic.partition("_")[0]
    new = line.act == "done" and (told in TOPICS or line.slots.get("what") in CHANGES)
    soon = session.listening.asked == "confirm_tree" or session.dialogue.brief
    if not new or soon or not session.dialogue.known.root.parts:
        return None
    labels: Labels = page("terminal", session.language)["tables"]["labels"]
    return _tree(session, labels)


def _tree(session: Session, labels: Labels) -> RenderableType:
    words = (partial(how, language=session.language) for how in (_does, _holds))
    return task_tree(session.dialogue.known.task, labels, *words)


def _motions(known: Knowledge, language: str) -> Labels:
    """Return the motions of episodes, and the things there are, as the robot says them."""
    found = known.lesson.segmentation.episodes if known.lesson is not None else ()
    told = (*(one.character for one in found), *known.setup.places)
    return {one: in_words(one, language) for one in told}


def _does(leaf: Primitive, language: str) -> str:
    return in_words(plain_action(leaf.action), language, kind="action")


def _holds(leaf: Primitive, language: str) -> str:
    """Return what holds before a step and at its end, in the words of a record."""
    labels, told = page("record", language), []
    for when, held in (("before", leaf.before), ("until", leaf.until)):
        if held:
            holds = in_words(plain_conditions(held), language, kind="conditions")
            told.append(str(labels[when]).format(conditions=holds))
    return "; ".join(told)


def _of_lesson(
    known: Knowledge, lesson: Lesson, topic: str, words: Mapping[str, Any], labels: Labels
) -> RenderableType | None:
    if topic == "episodes":
        return Group(*segmentation_views(lesson, labels))
    path = lesson.path
    if topic == "trajectory" and path is not None:
        spots = tuple((labels.get(one.frame, one.frame), one.at) for one in lesson.stations)
        return curves.Picture(lambda blocks, wide: path_picture(path, spots, words, blocks, wide))
    return None


def _sentences(text: str) -> Table:
    """Return numbered sentences as a table, so that long ones hang below themselves."""
    table = Table(box=None, pad_edge=False, show_header=False)
    table.add_column(no_wrap=True, justify="right")
    table.add_column()
    for line in text.split("\n"):
        number, dot, told = line.partition(". ")
        table.add_row(f"{number}." if dot else "", Text(told if dot else line))
    return table


def path_picture(
    path: LearnedPath,
    spots: tuple[tuple[str, int], ...],
    words: Mapping[str, Any],
    blocks: str,
    columns: int,
) -> str:
    """Return the learned path from above (x up, y to the left) and its height over time.

    Parameters
    ----------
    path : LearnedPath
    spots : tuple of (name, sample)
        Places to mark by the first letter of their names.
    words : mapping
    blocks : str
        Characters for bars.
    columns : int
    """
    xyz_mm = 1000.0 * path.path[:, :3]
    low, high = xyz_mm.min(axis=0), xyz_mm.max(axis=0)
    share = (high - xyz_mm) / np.maximum(high - low, 1.0)
    cells = np.round(share[:, :2] * np.array([ROWS - 1, columns - 1])).astype(int)
    drawn = [[" "] * columns for _ in range(ROWS)]
    for row, column in cells:
        drawn[row][column] = "."
    for name, at in spots:
        row, column = cells[min(at, len(cells) - 1)]
        drawn[row][column] = name[:1].upper()
    extent = {"x": round(high[0] - low[0]), "y": round(high[1] - low[1])}
    lines = [str(words["path"]).format(**extent), *("".join(line).rstrip() for line in drawn)]
    lines.append(str(words["height"]).format(low=round(low[2]), high=round(high[2])))
    heights = curves.sampled(path.t_s, xyz_mm[:, 2] - low[2], columns)
    lines += curves.bars(heights, rows=3, blocks=blocks)
    return "\n".join([*lines, curves.axis(path.t_s, columns, words["labels"].get(".", "."))])


def rendered(shown: RenderableType, width: int) -> str:
    """Return text of at most `width` columns, with colors unless they are not wanted."""
    console = Console(
        file=io.StringIO(),
        force_terminal=not os.environ.get("NO_COLOR"),
        color_system=None if os.environ.get("NO_COLOR") else "standard",
        width=width,
        highlight=False,
    )
    with console.capture() as captured:
        console.print(shown)
    encoding = sys.stdout.encoding or "utf-8"
    text = captured.get().encode(encoding, "replace").decode(encoding)
    return "\n".join(line.rstrip() for line in text.rstrip().split("\n"))
