"""The paper's Figs. 3, 4 and 5 drawn from a lesson: votes, paths, blending weights."""

from __future__ import annotations

import textwrap
from collections.abc import Iterable
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from assistant.errors import BadInput, WorkFailed
from assistant.geometry import Array
from assistant.learning.weights import frame_weights
from assistant.model.demonstration import Demonstration
from assistant.model.lesson import LearnedPath, Lesson, Segmentation, Station
from assistant.model.task import Task, primitives

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

COLORS = ("#0072b2", "#d55e00", "#009e73", "#cc79a7", "#e69f00", "#56b4e9", "#7f7f7f", "#8c564b")
"""Told apart by people who do not see all colors, and in print."""
_LETTERS, _NARROWEST = 125, 6
"""Small letters that fit side by side across the votes, and the narrowest column of them."""
INK, PALE = "#222222", "#bbbbbb"


def write_figures(task: Task, folder: Path, shown: Demonstration | None = None) -> tuple[Path, ...]:
    """Draw ``votes.png``, ``paths.png`` and ``weights.png``; return the files written.

    Parameters
    ----------
    task : Task
        Learned.
    folder : Path
        Made if need be.
    shown : Demonstration, optional
        Adds the taught path as it was recorded.

    Raises
    ------
    WorkFailed
        If the task has not been learned.
    BadInput
        If the folder cannot be written.
    """
    lesson = task.learned
    if lesson is None:
        raise WorkFailed(f"{task.name!r} has not been learned yet; there is nothing to draw")
    figures = {"votes.png": votes_figure(lesson)}
    if lesson.path is not None:
        figures["paths.png"] = paths_figure(task, lesson, lesson.path, shown)
        figures["weights.png"] = weights_figure(lesson, lesson.path)
    written = []
    try:
        folder.mkdir(parents=True, exist_ok=True)
        for name, figure in figures.items():
            figure.savefig(folder / name, dpi=150)
            written.append(folder / name)
    except OSError as error:
        right = "name a folder you may write in"
        raise BadInput.one(str(folder), f"cannot write ({error.strerror})", right) from error
    return tuple(written)


def votes_figure(lesson: Lesson) -> Figure:
    """Return the votes over time, with kept and eliminated points (the paper's Fig. 3)."""
    found = lesson.segmentation
    figure, axes = _page(10.0, 5.2)
    for color, (name, votes) in zip(COLORS[1:], found.signal_votes.items(), strict=False):
        if np.any(votes > 0.0):
            axes.plot(found.vote_t_s, votes, color=color, linewidth=1.0, alpha=0.75, label=name)
    axes.plot(found.vote_t_s, found.vote, color=COLORS[0], linewidth=2.4, label="overall vote")
    if len(found.vote):
        mean = float(np.mean(found.vote))
        axes.axhline(mean, color=PALE, linestyle="--", linewidth=1.0)
        axes.annotate("mean", (found.vote_t_s[0], mean), (2, 3), textcoords="offset points")
        _mark_points(axes, found)
    _mark_hand(axes, lesson)
    axes.set(xlabel="time (s)", ylabel="vote", ylim=(0.0, 1.39), title="Votes for cutting")
    _mark_episodes(axes, lesson)
    axes.set_yticks(np.linspace(0.0, 1.0, 6))
    axes.legend(loc="upper center", bbox_to_anchor=(0.5, -0.14), ncols=4, frameon=False)
    return figure


def paths_figure(
    task: Task, lesson: Lesson, learned: LearnedPath, shown: Demonstration | None = None
) -> Figure:
    """Return the taught and the generalized path in space (the paper's Fig. 4)."""
    from matplotlib.figure import Figure

    figure = Figure(figsize=(9.0, 7.0), layout="constrained")
    axes: Any = figure.add_subplot(projection="3d")
    if shown is not None:
        taught = shown.recording.path[:, :3] * 1000.0
        axes.plot(*taught.T, color=PALE, linewidth=1.0, linestyle="--", label="as taught")
    xyz = learned.path[:, :3] * 1000.0
    for position, leaf in enumerate(primitives(task.tree)):
        inside = np.flatnonzero(learned.primitive_at == position)
        if len(inside):
            color = COLORS[position % len(COLORS)]
            label = f"{position + 1} {leaf.name}"
            for run in np.split(inside, np.flatnonzero(np.diff(inside) > 1) + 1):
                axes.plot(*xyz[run[0] : run[-1] + 2].T, color=color, linewidth=2.6, label=label)
                label = "_"
    _mark_places(axes, lesson, learned, xyz)
    axes.set(xlabel="x (mm)", ylabel="y (mm)", zlabel="z (mm)", title="Learned path of the hand")
    spans = np.ptp(xyz, axis=0)
    axes.set_box_aspect(np.maximum(spans, 0.3 * np.max(spans)), zoom=1.15)
    axes.view_init(elev=24.0, azim=-38.0)
    axes.locator_params(nbins=5)
    figure.legend(loc="outside lower center", ncols=2, frameon=False)
    return figure


def weights_figure(lesson: Lesson, learned: LearnedPath) -> Figure:
    """Return the blending weights lambda1 and lambda2 over time (the paper's Fig. 5)."""
    stretches = tuple((one.docking_at, one.at) for one in lesson.stations)
    weights = frame_weights(learned.path[:, :3], stretches)
    figure, axes = _page(10.0, 4.2)
    curves = (
        ("$\\lambda_1$: object or target the hand is at", weights.lambda1, "-"),
        ("$\\lambda_2$: where the hand comes from", weights.lambda2, "--"),
    )
    for color, (label, weight, style) in zip(COLORS, curves, strict=False):
        axes.plot(learned.t_s, weight, style, color=color, linewidth=2.2, label=label)
    axes.axhline(0.5, color=PALE, linewidth=0.8, linestyle=":")
    for one in lesson.stations:
        _mark_station(axes, one, learned)
    axes.set(xlabel="time (s)", ylabel="weight", ylim=(-0.04, 1.16), title="Blending weights")
    axes.set_xlim(learned.t_s[0], learned.t_s[-1])
    axes.legend(loc="upper center", bbox_to_anchor=(0.5, -0.16), ncols=2, frameon=False)
    return figure


def _page(width: float, height: float) -> tuple[Figure, Axes]:
    from matplotlib.figure import Figure

    figure = Figure(figsize=(width, height), layout="constrained")
    axes = figure.add_subplot()
    axes.spines[["top", "right"]].set_visible(False)
    return figure, axes


def _mark_points(axes: Axes, found: Segmentation) -> None:
    """Mark on the overall vote which points were kept, and which eliminated."""
    kinds = (
        ("cut between steps", "*", 13, INK, [p for p in found.points if p.kept and not p.internal]),
        ("cut inside a step", "D", 7, INK, [p for p in found.points if p.kept and p.internal]),
        ("eliminated", "o", 7, "none", [p for p in found.points if not p.kept]),
    )
    for label, marker, size, face, points in kinds:
        if points:
            at_s = [point.at_s for point in points]
            heights = np.interp(at_s, found.vote_t_s, found.vote)
            _mark(axes, (at_s, heights), marker, size, face, label)


def _mark(axes: Any, at: Iterable[Any], marker: str, size: int, face: str, label: str) -> None:
    """Put one kind of mark on the points told, a sequence for each axis."""
    axes.plot(*at, marker, markersize=size, color=INK, markerfacecolor=face, label=label, zorder=6)


def _mark_hand(axes: Axes, lesson: Lesson) -> None:
    """Mark with squares where the hand closed and opened."""
    if lesson.path is None or not lesson.stations:
        return
    episodes = {part.primitive: part for part in lesson.segmentation.episodes}
    times = [
        _shown_s(lesson.path, one.at, one.primitive, episodes)
        for one in lesson.stations
        if one.kind != "touch"
    ]
    heights = np.full(len(times), 0.03)
    axes.plot(
        times,
        heights,
        "s",
        markersize=7,
        color=INK,
        markerfacecolor="none",
        label="hand closes or opens",
        clip_on=False,
    )


def _mark_station(axes: Axes, one: Station, learned: LearnedPath) -> None:
    """Shade the stretch from docking to grasp or release, and name its end."""
    from_s, to_s = learned.t_s[one.docking_at], learned.t_s[one.at]
    axes.axvspan(from_s, to_s, color=PALE, alpha=0.25, linewidth=0)
    axes.axvline(to_s, ymax=0.87, color=INK, linewidth=0.9)
    name = f"{one.kind} {one.object}" if one.kind == "grasp" else f"{one.kind} at {one.frame}"
    axes.annotate(name, (to_s, 1.04), ha="center", color=INK)


def _shown_s(learned: LearnedPath, at: int, primitive: str, episodes: dict[Any, Any]) -> float:
    """Return when a sample was shown: rests put in by learning lie within its primitive."""
    episode = episodes.get(primitive)
    inside = np.flatnonzero(learned.primitive_at == learned.primitive_at[at])
    if episode is None or not len(inside):
        return float(learned.t_s[at])
    return float(episode.from_s + learned.t_s[at] - learned.t_s[inside[0]])


def _mark_episodes(axes: Axes, lesson: Lesson) -> None:
    """Name the episodes above the curves."""
    episodes = lesson.segmentation.episodes
    whole = episodes[-1].to_s - episodes[0].from_s if episodes else 1.0
    for number, part in enumerate(episodes):
        color = COLORS[number % len(COLORS)]
        axes.axvspan(part.from_s, part.to_s, color=color, alpha=0.06, linewidth=0)
        middle = (part.from_s + part.to_s) / 2
        above: dict[str, Any] = {"ha": "center", "va": "top", "annotation_clip": False}
        axes.annotate(f"{number + 1}", (middle, 1.37), fontsize=10, fontweight="bold", **above)
        room = int(_LETTERS * (part.to_s - part.from_s) / whole)
        name = textwrap.fill(part.primitive or "(not introduced)", max(room, _NARROWEST))
        axes.annotate(name, (middle, 1.30), fontsize=7.5, **above)


def _mark_places(axes: Any, lesson: Lesson, learned: LearnedPath, xyz: Array) -> None:
    cuts = np.flatnonzero(np.diff(learned.primitive_at)) + 1
    marks = (
        ("*", 13, INK, cuts, "cut between steps"),
        ("D", 6, "white", _internal(lesson, learned), "cut inside a step"),
        ("s", 9, "none", np.array([s.at for s in lesson.stations], dtype=int), "hand acts"),
        ("^", 8, "white", np.array([s.docking_at for s in lesson.stations], dtype=int), "docking"),
    )
    for marker, size, face, samples, label in marks:
        if len(samples):
            _mark(axes, xyz[samples].T, marker, size, face, label)
    axes.text(*xyz[0], "  start", color=INK)


def _internal(lesson: Lesson, learned: LearnedPath) -> Any:
    at_s = [one.at_s for one in lesson.segmentation.points if one.kept and one.internal]
    first = lesson.segmentation.episodes[0].from_s if lesson.segmentation.episodes else 0.0
    return np.clip(np.searchsorted(learned.t_s, np.array(at_s) - first), 0, len(learned.t_s) - 1)
