"""Whether the hand holds what the rest of a halted run needs it to hold, before anything moves.

Between two looks at conditions a hand may be opened or closed by a word: what follows would be
done without the body, or would take along one that is not to be moved.
"""

from __future__ import annotations

from assistant.model.motion import ArmReport, HandPath
from assistant.ports import ArmLook

MISLAID = "held_anew"
"""What an arm report says of a body that is to be in the hand and is not, before going on."""
KEPT = "held_yet"
"""What an arm report says of a body in the hand that is not to be there, before going on."""


def carried_at(path: HandPath, sample: int) -> str:
    """Return what the hand carries at a sample of a path; empty for nothing."""
    carried = ""
    for stop in path.stops:
        if stop.at >= sample:
            break
        if stop.kind == "grasp":
            carried = stop.object
        elif stop.kind == "release":
            carried = ""
    return carried


def unfit(
    path: HandPath, sample: int, look: ArmLook, primitive_at: int, at_s: float
) -> ArmReport | None:
    """Return why a run cannot go on from a sample of its path with what is in the hand.

    Parameters
    ----------
    path : HandPath
        The whole run.
    sample : int
        Where what is left of it begins.
    look : ArmLook
        Where the arm stands.
    primitive_at : int
        The primitive the run was halted in.
    at_s : float
        Simulated time since the motion began.
    """
    needed = carried_at(path, sample)
    # Fingers that were opening let go before they are open: to open them on needs nothing.
    opening = any((stop.kind, stop.at) == ("release", sample) for stop in path.stops)
    if look.held == needed or (opening and not look.held):
        return None
    text, name = (MISLAID, needed) if needed else (KEPT, look.held)
    return ArmReport("unmet", at_s, primitive_at, text, name, found=look.held)
