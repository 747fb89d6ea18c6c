"""What the dialogue wants done, done: what it results in is returned as an event."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field, replace
from typing import assert_never

from assistant.dialogue import asking, events
from assistant.dialogue import effects as wanted
from assistant.dialogue.state import Dialogue
from assistant.errors import BadInput, NothingLearned
from assistant.files.library import Library
from assistant.model.motion import ArmReport, Refusal
from assistant.model.robot_acts import RobotAct
from assistant.session import halting, keeping
from assistant.session.equipment import DrivenHand, Equipment
from assistant.session.happenings import Store
from assistant.session.motion import Mover

NO_SETUP, GIVEN_UP = "no_setup", "given_up"
LONG_LOOKED = 150
"""After so many arrangements out of reach the teacher is told; mostly ten are enough."""
HAND_KEYS = {"open": "o", "close": "c"}
"""While the hand is driven by keys, words about it press the keys that mean the same."""


Work = wanted.Learn | wanted.Keep | wanted.Load | wanted.Discard | wanted.WriteDown | wanted.Arrange
Motion = (
    wanted.Check
    | wanted.Move
    | wanted.Replay
    | wanted.GoOn
    | wanted.SetHand
    | wanted.Jog
    | wanted.Home
    | wanted.Halt
)


@dataclass(slots=True)
class Workplace:
    """What effects act upon: the arm, the kept tasks, the journal's folder.

    Parameters
    ----------
    equipment : Equipment
    library : Library
    store : Store
    """

    equipment: Equipment
    library: Library
    store: Store
    mover: Mover = field(init=False)
    driven: DrivenHand | None = None
    """The hand that the teacher drives just now."""
    drawn: int = 0
    """How many new setups have been drawn; the next one's seed."""
    tell: Callable[[RobotAct], None] = lambda line: None
    """Says a line while something is under way that takes long."""

    def __post_init__(self) -> None:
        self.mover = Mover(self.equipment)


def do(place: Workplace, dialogue: Dialogue, effect: Work | Motion) -> events.Event | None:
    """Carry out one effect and return what came of it, if that is known at once."""
    match effect:
        case wanted.Learn():
            return learned(place, effect)
        case wanted.Keep():
            return keeping.keep(place.library, effect.task, effect.name, overwrite=effect.overwrite)
        case wanted.Load():
            return keeping.load(place.library, effect.name)
        case wanted.Discard():
            return keeping.discard(place.library, effect.name)
        case wanted.WriteDown():
            return keeping.write_down(place.library, effect.task, effect.name, dialogue.language)
        case wanted.Arrange():
            return _arrange(place, dialogue, effect)
        case _:
            return _move(place, dialogue, effect)


def _move(place: Workplace, dialogue: Dialogue, effect: Motion) -> events.Event | None:
    mover = place.mover
    if mover.latches(effect):
        return None
    if isinstance(effect, wanted.Check):
        return mover.check(effect)
    refusal: Refusal | ArmReport | None = None
    match effect:
        case wanted.Move():
            refusal = mover.move(effect)
        case wanted.Replay():
            refusal = mover.replay(effect)
        case wanted.GoOn() if mover.under_way:
            refusal = mover.go_on(anew=effect.anew)
        case wanted.GoOn():
            refusal = _from_start(mover, dialogue)
        case wanted.SetHand() if place.driven is not None:
            place.driven.press(HAND_KEYS[effect.command])
        case wanted.SetHand():
            refusal = mover.set_hand(effect.command)
        case wanted.Jog():
            refusal = mover.jog(effect.offset_m, effect.turn_rad)
        case wanted.Home():
            refusal = mover.home(effect.setup)
        case wanted.Halt():
            mover.halt(effect.why)
        case _:
            assert_never(effect)
    if isinstance(refusal, ArmReport):
        return events.ArmReported(refusal)
    return None if refusal is None else events.Checked(mover.setup, refusal)


def _from_start(mover: Mover, dialogue: Dialogue) -> Refusal | None:
    """Begin a run that was under way in an earlier life of the session: all is in place again."""
    check = asking.check(dialogue)
    found = mover.check(check)
    if found.refusal is None:
        slow = dialogue.pace == "slow"
        mover.move(wanted.Move(check.task, check.setup, check.speed, slow))
    return found.refusal


def learned(place: Workplace, effect: wanted.Learn) -> events.Learned:
    """Learn, and tell why nothing was learned if so."""
    # Smoothing takes a second to import; a session that never learns is spared it.
    from assistant.learning.lesson import learn

    place.store.taught = effect.task
    try:
        lesson = learn(
            effect.demonstrations,
            effect.task,
            cuts_s=effect.cuts_s,
            assigned=effect.assigned,
            scene=place.mover.scene,
        )
    except NothingLearned as error:
        return events.Learned(None, error.why or str(error), error.facts)
    except BadInput as error:
        return events.Learned(None, str(error.problems[0]))
    return events.Learned(lesson)


def _looked_for(place: Workplace) -> Callable[[int], bool]:
    """Return what is asked while a setup is looked for: it tells that it takes long, and stops."""

    def goes_on(drawn: int) -> bool:
        if drawn == LONG_LOOKED:
            place.tell(RobotAct("report", "still_looking"))
        return not place.equipment.stop_flag.is_set()

    return goes_on


def _arrange(place: Workplace, dialogue: Dialogue, effect: wanted.Arrange) -> events.Event | None:
    mover = place.mover
    if mover.moving and not mover.braking:
        mover.halt(halting.REARRANGED)
    if mover.latches(effect):
        return None
    scene = effect.scene or mover.scene
    setup = effect.setup or mover.setup
    if not effect.random:
        mover.arrange(scene, setup)
        return None
    place.drawn += 1
    goes_on = _looked_for(place)
    drawn = place.equipment.new_setup(dialogue.known.task, scene, setup, place.drawn, goes_on)
    if drawn is None:
        stopped = place.equipment.stop_flag.is_set()
        place.equipment.stop_flag.clear()
        thing = next(iter(setup.places), "")
        return events.Checked(setup, Refusal("setup", GIVEN_UP if stopped else NO_SETUP, thing))
    drawn = replace(drawn, name=f"new {place.drawn}")
    mover.arrange(scene, drawn)
    return events.Arranged(drawn, scene)
