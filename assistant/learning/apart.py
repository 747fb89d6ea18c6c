"""A stretch within the episodes set apart as a step of its own, once the teacher has named it."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise

from assistant.model.lesson import Episode

SAME_CUT_S = 0.3
"""A stretch that ends so near to an episode's end ends with it."""


def set_apart(
    episodes: Sequence[Episode], name: str, from_s: float, to_s: float
) -> tuple[tuple[float, ...], tuple[str, ...]]:
    """Return cuts and the primitives between them, with a stretch given to a primitive.

    Parameters
    ----------
    episodes : sequence of Episode
        One at least, each beginning where the one before ends.
    name : str
        Of the primitive the stretch belongs to.
    from_s, to_s : float

    Returns
    -------
    cuts_s : tuple of float
    taken : tuple of str, one more than cuts
        What was assigned to none keeps an empty name.
    """
    edges = [episodes[0].from_s, *(one.to_s for one in episodes)]
    new = [at for at in (from_s, to_s) if min(abs(at - edge) for edge in edges) > SAME_CUT_S]
    edges = sorted([*edges, *new])
    middles = [0.5 * (begin + end) for begin, end in pairwise(edges)]
    taken = []
    for middle in middles:
        owner = next(one for one in episodes if one.from_s <= middle <= one.to_s)
        taken.append(name if from_s <= middle <= to_s else owner.primitive or "")
    return tuple(edges[1:-1]), tuple(taken)
