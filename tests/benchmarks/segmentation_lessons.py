"""What the segmenter makes of lessons: its cuts, its episodes and the steps it asks about."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from assistant.errors import WorkFailed
from assistant.learning.questions import DOUBTED
from assistant.learning.segmentation import segment
from assistant.model.lesson import Segmentation
from assistant.model.settings import SegmentationSettings
from assistant.model.task import Action, Primitive, Subtask, primitives
from tests.generators.shown import Shown, spoken_cues

UNSEEN = ("never_shown", DOUBTED)
"""Why a step is asked about that may never have been shown."""


def ours(shown: Shown, settings: SegmentationSettings | None = None) -> Segmentation:
    try:
        return segment(shown.demonstration, shown.task, settings)
    except WorkFailed:
        return Segmentation((), (), None)


def other_length(shown: Shown, seed: int, *, longer: bool) -> Shown:
    """Return the same demonstration with a tree one step too long or too short."""
    rng = np.random.default_rng(seed)
    leaves = primitives(shown.task.tree)
    one = leaves[int(rng.integers(1, len(leaves)))]
    instead: tuple[Primitive, ...] = ()
    if longer:
        way = str(rng.choice(["left", "forward", "up", "down"]))
        instead = (Primitive("one too many", Action("move", way)), one)
    tree = _replaced(shown.task.tree, one, instead)
    return replace(shown, task=replace(shown.task, tree=tree))


def _replaced(tree: Subtask, one: Primitive, instead: tuple[Primitive, ...]) -> Subtask:
    """Return the tree with other leaves in place of one; what is in any order stays so."""
    parts: list[Subtask | Primitive] = []
    for part in tree.parts:
        if isinstance(part, Subtask):
            parts.append(_replaced(part, one, instead))
        else:
            parts += instead if part == one else (part,)
    return replace(tree, parts=tuple(parts))


def told_coarsely(shown: Shown, seed: int) -> Shown | None:
    """Return the same demonstration told by what the hand does only: take it, put it there.

    Motions before a step of the hand are part of it; the cues follow the cuts that are left.
    None where nothing changes, or one step is left.
    """
    leaves = {leaf.name: leaf for leaf in primitives(shown.task.tree)}
    ends = [k for k, name in enumerate(shown.names) if leaves[name].action.verb == "hand"]
    ends = [*ends, *([len(shown.names) - 1] if ends[-1:] != [len(shown.names) - 1] else [])]
    if not 1 < len(ends) < len(shown.names):
        return None
    names = tuple(shown.names[k] for k in ends)
    cuts_s = tuple(shown.cuts_s[k] for k in ends[:-1])
    end_s = float(shown.demonstration.recording.t_s[-1])
    cues = spoken_cues(list(cuts_s), end_s, np.random.default_rng([seed, 78]))
    tree = Subtask("told", tuple(leaves[name] for name in names))
    demonstration = replace(shown.demonstration, cues=cues)
    return Shown(demonstration, replace(shown.task, tree=tree), cuts_s, names)


def episodes_right(shows: list[Shown], *, true_cuts: bool) -> float:
    """Return the share of true episodes whose middle is given its own primitive."""
    right = total = 0
    for shown in shows:
        given = shown.cuts_s if true_cuts else None
        try:
            found = segment(shown.demonstration, shown.task, cuts_s=given).episodes
        except WorkFailed:
            found = ()
        edges = [0.0, *shown.cuts_s, float(shown.demonstration.recording.t_s[-1])]
        for a, b, name in zip(edges[:-1], edges[1:], shown.names, strict=True):
            total += 1
            middle = 0.5 * (a + b)
            right += any(e.from_s <= middle <= e.to_s and e.primitive == name for e in found)
    return right / max(total, 1)


def steps_named(shows: list[Shown]) -> str:
    """Return how many steps never introduced, and never shown, a question names.

    A step that was shown counts as named if the question tells a time within it.
    """
    unheard = unseen = left_out = 0
    for k, shown in enumerate(shows):
        short = other_length(shown, k, longer=False)
        told = {leaf.name for leaf in primitives(short.task.tree)}
        # A recording may end before the step that is left out of the tree.
        at = next((i for i, name in enumerate(shown.names) if name not in told), None)
        left_out += at is not None
        edges = [0.0, *shown.cuts_s, float(shown.demonstration.recording.t_s[-1])]
        for question in ours(short).questions:
            if at is not None and question.reason == "never_introduced":
                a, b = (float(str(question.facts[key])) for key in ("from_s", "to_s"))
                if max(a, edges[at]) < 0.5 * (a + b) < min(b, edges[at + 1]):
                    unheard += 1
                    break
        long = other_length(shown, k, longer=True)
        unseen += any(
            one.reason in UNSEEN and one.about == "one too many" for one in ours(long).questions
        )
    return f"never introduced {unheard}/{left_out}, never shown {unseen}/{len(shows)}"


def orders_recognized(shows: list[Shown]) -> str:
    """Return of how many lessons shown in another order than told the order was recognized."""
    other = [one for one in shows if one.names != _told_names(one)[: len(one.names)]]
    right = sum(tuple(e.primitive for e in ours(one).episodes) == one.names for one in other)
    return f"{right}/{len(other)}"


def _told_names(shown: Shown) -> tuple[str, ...]:
    return tuple(leaf.name for leaf in primitives(shown.task.tree))
