"""A recording as a figure: the hand's speed over time, its opening, and what was said."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING

from assistant.errors import BadInput
from assistant.model.demonstration import Recording, Spoken
from assistant.shells.curves import speed

if TYPE_CHECKING:
    from matplotlib.figure import Figure


def write_recording_figure(
    recording: Recording, spoken: Sequence[Spoken], folder: Path
) -> tuple[Path, ...]:
    """Draw ``recording.png`` and return its path; the folder is made if need be."""
    try:
        folder.mkdir(parents=True, exist_ok=True)
        recording_figure(recording, spoken).savefig(folder / "recording.png", dpi=150)
    except OSError as error:
        right = "name a folder you may write in"
        raise BadInput.one(str(folder), f"cannot write ({error.strerror})", right) from error
    return (folder / "recording.png",)


def recording_figure(recording: Recording, spoken: Sequence[Spoken]) -> Figure:
    """Return the course of speed and opening with a dashed line where words were said."""
    from matplotlib.figure import Figure

    figure = Figure(figsize=(9.0, 4.0), layout="constrained")
    above, below = figure.subplots(2, 1, sharex=True, height_ratios=[3, 1])
    above.plot(recording.t_s, 1000.0 * speed(recording.t_s, recording.path), color="tab:blue")
    above.set_ylabel("speed [mm/s]")
    if recording.gripper_m is not None:
        below.plot(recording.t_s, 1000.0 * recording.gripper_m, color="tab:gray")
    below.set_ylabel("opening [mm]")
    below.set_xlabel("time [s]")
    for each in spoken:
        for axes in (above, below):
            axes.axvline(each.at_s, color="tab:red", linestyle="--", linewidth=0.8)
        top = (each.at_s, 1.0)
        above.annotate(each.say, top, xycoords=above.get_xaxis_transform(), va="bottom", fontsize=7)
    return figure
