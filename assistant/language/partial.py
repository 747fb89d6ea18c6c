"""Readings that are only a part of what was said: "save it as test and then goodbye"."""

from __future__ import annotations

from collections.abc import Sequence

from assistant.language.looks import Candidate, kind_of
from assistant.model.teacher_acts import Affirm, Approve, Deny, Quit

_SURELY_CUT = -0.05
"""How likely each part of a cut line is, as a logarithm, from where the cut is sure."""


def unpartial(pool: Sequence[Candidate]) -> list[Candidate]:
    """Return readings without those that are one part of a line surely cut, where one is plain.

    "Save it as test and then goodbye" is no name with a goodbye, nor is it saving alone.
    """
    sure = [one for one in pool if one.looks.get("cut_least", _SURELY_CUT - 1) >= _SURELY_CUT]
    return [one for one in pool if not any(_leaves_out(one, more) for more in sure)]


def _leaves_out(one: Candidate, more: Candidate) -> bool:
    left = tuple(act for act in more.acts if act not in one.acts)
    part = len(one.acts) == 1 and {*one.acts} < {*more.acts}
    answers = any(isinstance(act, Affirm | Approve | Deny) for act in more.acts)
    simple = any(kind_of(acts) == kind_of((Quit(),)) for acts in (left, one.acts))
    return part and simple and not answers
