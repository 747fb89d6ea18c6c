"""Which stretches of a learned path keep their shape with their object or target."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from assistant.geometry import Array
from assistant.learning.ways import Span
from assistant.model.lesson import Station
from assistant.model.settings import BlendingSettings


def held_stretches(
    xyz: Array, stations: Sequence[Station], settings: BlendingSettings
) -> tuple[tuple[Span, ...], bool]:
    """Return the stretches that keep their shape, and whether the last is the start again.

    The first is the start; a path that comes back to its start ends there again; else the last
    station's stretch goes on to the end.
    """
    travel = np.concatenate([[0.0], np.cumsum(np.linalg.norm(np.diff(xyz, axis=0), axis=1))])
    held: list[Span] = [(0, 0)]
    previous = 0
    for k, station in enumerate(stations):
        way = travel[station.at] - travel[previous]
        pushed = station.kind == "touch" and station.object != station.frame
        # A body that is pushed follows no sharp bend: all of the way serves to come around.
        kept = 0.0 if pushed else min(settings.hold_m, settings.most_held * way)
        begin = int(np.searchsorted(travel, travel[station.at] - kept, side="right")) - 1
        begin = max(min(begin, station.docking_at), held[-1][1] + 1)
        end = station.left_at
        if k + 1 < len(stations):
            end = min(end, max(stations[k + 1].docking_at - 2, station.at))
        held.append((min(begin, station.at), max(end, station.at)))
        previous = station.at
    last = len(xyz) - 1
    home = bool(np.linalg.norm(xyz[-1] - xyz[0]) < 0.05) and last > held[-1][1] + 10
    if home and len(stations):
        return (*held, (last, last)), True
    held[-1] = (held[-1][0], last)
    return tuple(held), False
