"""What shows that a step was not left out: the way to a thing, and what the hand did there."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from assistant.geometry import Array
from assistant.learning.stretches import Stretches
from assistant.model.settings import SegmentationSettings
from assistant.model.task import Primitive

_SHORT = 0.1
"""Of the motion's extent: so far the hand may go from docking to grasp (paper III-C a)."""


def unled(leaves: Sequence[Primitive], between: Stretches, settings: SegmentationSettings) -> Array:
    """Return what each stretch loses as each primitive if the one before was left out, in log odds.

    A hand that goes a long way within a grasp was led there: what was told to lead there is no
    step that was never shown. Nor is closing the hand where the hand closed just before.

    Parameters
    ----------
    leaves : sequence of Primitive
        In the tree's order.
    between : Stretches
    settings : SegmentationSettings

    Returns
    -------
    unled : array, shape (n, n, leaves)
    """
    share = np.linalg.norm(between.ways, axis=-1) / between.extent_m
    reached = 1.0 - np.exp(-share / _SHORT)
    against = np.zeros((*share.shape, len(leaves)))
    for k in range(1, len(leaves)):
        before, leaf = leaves[k - 1 : k + 1]
        if leads(before, leaf):
            against[:, :, k] = reached
        elif acts(before, leaves[max(k - 2, 0)]):
            done = between.at_end[before.action.way][0] > 0.0
            against[:, :, k] = done[:, None]
    return -settings.decoding.unled * against


def leads(before: Primitive, leaf: Primitive) -> bool:
    """Tell whether a primitive surely brings the hand to where the next one uses it."""
    there = before.action.verb == "move" and before.action.way not in ("depart", "up")
    same = leaf.action.object is not None and before.action.object == leaf.action.object
    return leaf.action.verb == "hand" and there and same and not before.optional


def acts(leaf: Primitive, before: Primitive) -> bool:
    """Tell whether the hand surely does in a primitive what the one before did not."""
    return leaf.action.verb == "hand" and before.action.verb != "hand" and not leaf.optional
