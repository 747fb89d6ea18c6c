"""Cut a demonstration into episodes and assign them to the introduced primitives (III-A, B)."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from types import MappingProxyType

import numpy as np

from assistant.errors import BadInput, NothingLearned
from assistant.geometry import Array
from assistant.learning.candidates import Evidence, gather
from assistant.learning.confidence import all_right
from assistant.learning.parting import only_leaves, with_leaving
from assistant.learning.points import episodes, points, signal_votes
from assistant.learning.questions import questions
from assistant.learning.reading import Understood, read, read_cuts
from assistant.learning.showing import shown_part
from assistant.learning.smoothing import smooth
from assistant.learning.votes import overall
from assistant.model.demonstration import Demonstration, Recording
from assistant.model.lesson import Episode, Segmentation, SegmentationPoint
from assistant.model.settings import SegmentationSettings
from assistant.model.task import Task, primitives

_FEWEST_SAMPLES = 5
Doubts = tuple[float, Mapping[str, float], Sequence[tuple[float, float, float]]]
_CERTAIN: Doubts = (1.0, MappingProxyType({}), ())
"""Of what the teacher decided on: all is right, nothing is left out or untold."""


def segment(
    demonstration: Demonstration,
    task: Task,
    settings: SegmentationSettings | None = None,
    *,
    cuts_s: Sequence[float] | None = None,
    assigned: Sequence[tuple[int, str]] = (),
) -> Segmentation:
    """Return cuts, episodes and their primitives, with votes, confidence and questions.

    Parameters
    ----------
    demonstration : Demonstration
    task : Task
        With at least one primitive.
    settings : SegmentationSettings, optional
    cuts_s : sequence of float, optional
        Cuts the teacher decided on; they are taken as they are.
    assigned : sequence of (int, str)
        Assignments the teacher decided on: the number of an episode, counted from 1, and the
        primitive's name.

    Returns
    -------
    segmentation : Segmentation

    Raises
    ------
    NothingLearned
        If the recording is too short, the hand never moves, or it never closes in a task
        that carries something.
    """
    settings = settings or SegmentationSettings()
    whole = demonstration.recording
    if cuts_s is None and settings.method == "decode":
        demonstration = shown_part(demonstration, settings)
    evidence = gathered(demonstration, task, settings)
    if cuts_s is None and settings.method == "paper":
        from assistant.learning.paper_method import read_as_printed

        understood = read_as_printed(demonstration, task, evidence, settings)
    elif cuts_s is None:
        understood = read(demonstration, task, evidence, settings)
    else:
        understood = read_cuts(demonstration, task, evidence, settings, _inside(cuts_s, evidence))
    told = cuts_s is not None
    found = _told(demonstration, task, evidence, understood, settings, assigned, told=told)
    return replace(found, episodes=_of_all(whole, found.episodes))


def gathered(demonstration: Demonstration, task: Task, settings: SegmentationSettings) -> Evidence:
    """Return what the signals say; a recording nothing can be learned from is refused."""
    recording = demonstration.recording
    if len(recording.t_s) < _FEWEST_SAMPLES:
        raise NothingLearned(
            f"the recording has {len(recording.t_s)} samples, too few to learn from; "
            f"at least {_FEWEST_SAMPLES} are needed",
            "too_short",
        )
    if not primitives(task.tree):
        raise NothingLearned("the task has no steps yet; introduce at least one", "no_steps")
    evidence = gather(demonstration, smooth(recording, settings.smoothing), settings)
    if float(np.max(evidence.pace)) < settings.signals.least_pace_m_s:
        raise NothingLearned(
            "the hand never moves in this demonstration; show the task once more", "never_moved"
        )
    closes = any(event.kind == "close" for event in evidence.events)
    if recording.gripper_m is not None and not closes and _carries(task):
        raise NothingLearned(
            "the hand never closes in this demonstration, so nothing was picked up; "
            "show the task once more and close the hand on the object",
            "never_closed",
        )
    return evidence


def _carries(task: Task) -> bool:
    """Tell whether the task needs a hand that closes."""
    leaves = primitives(task.tree)
    hands = {leaf.action.way for leaf in leaves if leaf.action.verb == "hand"}
    # What is pushed or swept there is done as shown, by a motion without a word of its own.
    if not hands and any(leaf.action.verb == "free" and leaf.action.object for leaf in leaves):
        return False
    roles = {known.role for known in task.objects}
    moves = {leaf.action.way for leaf in leaves}
    return "close" in hands or (not hands and roles == {"object", "target"} and "approach" in moves)


def _inside(cuts_s: Sequence[float], evidence: Evidence) -> list[float]:
    t_s = evidence.smoothed.t_s
    outside = [cut for cut in cuts_s if not t_s[0] < cut < t_s[-1]]
    if outside:
        raise BadInput.one(
            "cuts",
            f"{outside[0]:.2f} s is not within the demonstration",
            f"cuts lie between {t_s[0]:.2f} and {t_s[-1]:.2f} s",
        )
    return sorted(set(cuts_s))


def _of_all(whole: Recording, found: tuple[Episode, ...]) -> tuple[Episode, ...]:
    """Return episodes with the rests before the first and after the last as part of them."""
    first = replace(found[0], from_s=float(whole.t_s[0]))
    found = (first, *found[1:])
    return (*found[:-1], replace(found[-1], to_s=float(whole.t_s[-1])))


def _told(
    demonstration: Demonstration,
    task: Task,
    evidence: Evidence,
    understood: Understood,
    settings: SegmentationSettings,
    assigned: Sequence[tuple[int, str]],
    *,
    told: bool,
) -> Segmentation:
    leaves = primitives(task.tree)
    lag_s = understood.lag.best_s if understood.lag is not None else None
    cues_s = np.array([cue.at_s for cue in demonstration.cues]) - (lag_s or 0.0)
    votes = signal_votes(evidence, cues_s, len(leaves) - 1, settings)
    found = points(understood, evidence, votes, cues_s, settings)
    parts = episodes(understood, evidence, leaves)
    if not told:
        found, parts = with_leaving(evidence, found, parts, cues_s)
    parts = _reassigned(parts, assigned, task)
    asked = _doubts(task, understood, evidence, found, cues_s) if not told else _CERTAIN
    return Segmentation(
        points=found,
        episodes=parts,
        cue_lag_s=lag_s,
        questions=questions(task, demonstration, evidence, found, parts, *asked),
        vote_t_s=evidence.smoothed.t_s,
        vote=overall(votes, settings.votes.weights),
        signal_votes=MappingProxyType(votes),
    )


def _doubts(
    task: Task,
    understood: Understood,
    evidence: Evidence,
    found: Sequence[SegmentationPoint],
    cues_s: Array,
) -> Doubts:
    """Return how sure all cuts are, what may be left out, and where untold steps may lie."""
    leaves = primitives(task.tree)
    left_out = {leaves[k].name: chance for k, chance in understood.left_out().items()}
    cuts = [point.confidence for point in found if point.kept and not point.internal]
    places = understood.unheard()
    unheard = [one for one in places if not only_leaves(evidence, one[0], one[1], cues_s)]
    return all_right(understood, np.array(cuts), cues_s), left_out, unheard


def _reassigned(
    found: tuple[Episode, ...], assigned: Sequence[tuple[int, str]], task: Task
) -> tuple[Episode, ...]:
    """Return the episodes with the teacher's own assignments, which are certain."""
    names = {leaf.name for leaf in primitives(task.tree)}
    out = list(found)
    for number, name in assigned:
        if not 1 <= number <= len(out):
            raise BadInput.one("assign", f"there is no part {number}", f"parts are 1 to {len(out)}")
        if name not in names:
            raise BadInput.one("assign", f"no step is called {name!r}", ", ".join(sorted(names)))
        out[number - 1] = replace(out[number - 1], primitive=name, probability=1.0)
    return tuple(out)
