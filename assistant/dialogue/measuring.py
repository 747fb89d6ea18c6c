"""What a run that is over is told by: how things lie, how deep, how much (paper IV-B).

Corners and edges tell how well a thing was put on a place; a task that is about something else
is told by its own measure, and by whether that was enough.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from assistant.model.motion import Alignment, Measure

ALL_PERCENT = 99.95
"""From here on a share is told as all of it."""


def result_slots(alignments: Sequence[Alignment], measures: Sequence[Measure]) -> dict[str, Any]:
    """Return the slots that tell a run's result.

    Parameters
    ----------
    alignments : sequence of Alignment
    measures : sequence of Measure
        Told is the first that was not good enough, or else the first; all are in ``measures``.

    Returns
    -------
    slots : dict
        ``alignments`` and ``measures`` as plain values; of the measure that is told ``object``,
        ``target``, ``value``, ``unit``, ``good``, and the value once more by its kind.
    """
    slots: dict[str, Any] = {"alignments": [_alignment(one) for one in alignments]}
    if not measures:
        return slots
    told = next((one for one in measures if not one.good), measures[0])
    first = _measure(told)
    kind = first.pop("kind")
    everything = kind == "inside" and told.value >= ALL_PERCENT
    return {
        **slots,
        **first,
        "measures": [_measure(one) for one in measures],
        ("everything" if everything else kind): kind if everything else first["value"],
        "lacking": "" if told.good else kind,
    }


def _alignment(one: Alignment) -> dict[str, Any]:
    return {
        "object": one.object,
        "target": one.target,
        "distance_mm": round(one.distance_mm, 3),
        "angle_deg": round(one.angle_deg, 3),
    }


def _measure(one: Measure) -> dict[str, Any]:
    return {
        "kind": one.kind,
        "object": one.object,
        "target": one.target,
        "value": round(one.value, 3),
        "unit": one.unit,
        "good": one.good,
    }
