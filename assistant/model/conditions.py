"""Conditions before and after a primitive: states of the hand and of the objects."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal, get_args

ConditionKind = Literal["hand", "docked", "held", "on", "aligned", "above", "clear"]
CONDITIONS: tuple[ConditionKind, ...] = get_args(ConditionKind)


@dataclass(frozen=True, slots=True)
class Condition:
    """A state to hold before or after a primitive.

    Parameters
    ----------
    kind : str
        One of `CONDITIONS`.
    object : str, optional
        The object concerned; for ``hand`` its state, ``open`` or ``closed``.
    target : str, optional
        For ``on``, ``aligned`` and ``above``.
    """

    kind: ConditionKind
    object: str | None = None
    target: str | None = None
