"""One step shown again: only its stretch of the demonstration is replaced, the rest is kept."""

from __future__ import annotations

from dataclasses import dataclass, replace

from assistant.dialogue.asking import learn, tell
from assistant.dialogue.going_back import go_back
from assistant.dialogue.knowledge import Knowledge
from assistant.dialogue.reviewing import with_lesson
from assistant.dialogue.sketch import at, leaves, walk
from assistant.dialogue.state import AwaitingShow, Dialogue
from assistant.dialogue.turn import Turn, changed, first, line, say
from assistant.geometry import Array
from assistant.learning.splicing import Apart, Spliced, spliced
from assistant.model.demonstration import Demonstration, Recording
from assistant.model.lesson import Episode
from assistant.model.setup import Setup
from assistant.model.task import Index


@dataclass(frozen=True, slots=True)
class Stretch:
    """Where a step is in the last demonstration.

    Parameters
    ----------
    first, last : int
        Its episodes among all.
    from_s, to_s : float
    single : bool
        Whether it is one motion, which has no cuts of its own.
    """

    first: int
    last: int
    from_s: float
    to_s: float
    single: bool


def wanted(dialogue: Dialogue, index: Index) -> Turn:
    """Offer to watch one step again; the whole task where the step was not seen for itself."""
    name = at(dialogue.known.root, index).name
    found = stretch(dialogue.known, name)
    if found is None:
        told = line("told", "step_again", name=name)
        return first(say(dialogue, told)[1], go_back(dialogue, "demonstration"))
    told = line("told", "one_step_again", name=name, from_s=found.from_s, to_s=found.to_s)
    return first(say(dialogue, told)[1], go_back(dialogue, "demonstration", step=name))


def stretch(known: Knowledge, name: str) -> Stretch | None:
    """Return where a step is in what was shown; None if that is not there, or not in one piece."""
    node = next((one for _, one in walk(known.root) if one.name == name), None)
    episodes = known.lesson.segmentation.episodes if known.lesson is not None else ()
    if node is None or not known.demonstrations:
        return None
    own = {leaf.name for _, leaf in leaves(node)} or {name}
    hits = [at for at, one in enumerate(episodes) if one.primitive in own]
    if not hits or hits != list(range(hits[0], hits[-1] + 1)):
        return None
    begin, end = episodes[hits[0]], episodes[hits[-1]]
    return Stretch(hits[0], hits[-1], begin.from_s, end.to_s, not node.parts)


def before_step(known: Knowledge, name: str) -> tuple[Demonstration, Setup] | None:
    """Return what was shown up to where a step begins, and where everything was then.

    None where the step is the first, so that the hand is there already.
    """
    found = stretch(known, name)
    if found is None or known.lesson is None:
        return None
    shown = known.demonstrations[-1]
    count = int((shown.recording.t_s < found.from_s).sum())
    if count < 2:
        return None
    old = shown.recording
    gripper = None if old.gripper_m is None else old.gripper_m[:count]
    ahead = Recording(old.t_s[:count], old.path[:count], gripper)
    as_shown = with_lesson(replace(known, setup=shown.setup), known.lesson).setup
    return replace(shown, recording=ahead), as_shown


def ended_at(known: Knowledge, name: str) -> Array | None:
    """Return the pose, shape (7,), in which a step ended as it was shown; None if it was not."""
    found = stretch(known, name)
    if found is None:
        return None
    old = known.demonstrations[-1].recording
    last = int((old.t_s <= found.to_s).sum()) - 1
    pose: Array = old.path[max(last, 0)]
    return pose


def shown_step(dialogue: Dialogue, name: str, again: Demonstration) -> Turn:
    """Put what was shown again in its place, and learn from the whole."""
    known = dialogue.known
    found = stretch(known, name)
    if found is None:
        return tell(dialogue, line("error", "not_shown", reason="too_short"))
    whole = known.demonstrations[-1]
    new = spliced(whole, found.from_s, found.to_s, again)
    if isinstance(new, Apart):
        topic = f"step_apart.{new.end}" if new.away_mm else f"step_hand.{new.end}"
        told = line("error", topic, name=name, away_mm=new.away_mm or None)
        return tell(replace(dialogue, state=AwaitingShow(name)), told)
    kept = changed(dialogue, "demonstration", _with(known, found, new))
    before_s, now_s = found.to_s - found.from_s, new.to_s - found.from_s
    told = line("done", "step_shown", name=name, before_s=before_s, now_s=now_s)
    return first(say(kept, told)[1], learn(kept))


def _with(known: Knowledge, found: Stretch, new: Spliced) -> Knowledge:
    """Return what is known with the stretch replaced; the cuts beside it stay where they are."""
    replaced = replace(
        known,
        demonstrations=(*known.demonstrations[:-1], new.demonstration),
        cuts_s=None,
        assigned=(),
        reviewed=False,
    )
    if not found.single or known.lesson is None:
        return replaced
    episodes = known.lesson.segmentation.episodes
    moved_s = new.to_s - found.to_s
    own = replace(episodes[found.first], to_s=new.to_s)
    later = (
        replace(one, from_s=one.from_s + moved_s, to_s=one.to_s + moved_s)
        for one in episodes[found.last + 1 :]
    )
    now: tuple[Episode, ...] = (*episodes[: found.first], own, *later)
    named = tuple((at, one.primitive) for at, one in enumerate(now, start=1) if one.primitive)
    return replace(replaced, cuts_s=tuple(one.to_s for one in now[:-1]), assigned=named)
