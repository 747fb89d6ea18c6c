"""What is told to move, or to be elsewhere, while the arm brakes, waits until it stands."""

from __future__ import annotations

import numpy as np
import pytest

from assistant.model.motion import ArmReport
from assistant.model.scene import Scene
from assistant.model.setup import Setup
from assistant.session import halting
from assistant.session.heeding import Heeding
from assistant.session.loop import Session
from sim import a465
from tests.session.lessons import Heard

TICK_S = 0.02


@pytest.fixture
def heavy(monkeypatch: pytest.MonkeyPatch) -> None:
    """Let the arm brake for many ticks."""
    monkeypatch.setattr(a465, "ACCELERATIONS", 0.05 * a465.ACCELERATIONS)


def reach_rest(session: Session) -> None:
    """Let time pass until the arm has come to rest, or has begun anew from there."""
    while session.mover.braking:
        session.tick()


@pytest.mark.parametrize(("halt", "go"), [("stop", "start"), ("pause", "go on")])
def test_a_start_while_the_arm_brakes_is_done_once_it_stands(
    moving: tuple[Session, Heard], halt: str, go: str
) -> None:
    session, heard = moving
    session.hear(halt)
    session.tick()
    session.hear(go)
    assert heard.topics[-1] == "told.going_on"
    told = len(heard.topics)
    reach_rest(session)
    # The very tick that ends the braking begins the rest of the run, from standing still.
    assert session.moving
    assert session.mover.run_s == 0.0
    assert heard.topics[told:] == []
    session.rest()
    assert heard.topics[-2:] == ["done.run", "ask.satisfied"]


@pytest.mark.usefixtures("heavy")
def test_a_start_changes_nothing_while_the_arm_brakes(moving: tuple[Session, Heard]) -> None:
    session, _ = moving
    session.hear("stop")
    session.tick()
    session.hear("start")
    q = [session.mover.look.q]
    while session.mover.braking:
        session.tick()
        q.append(session.mover.look.q)
    steps = np.linalg.norm(np.diff(np.array(q), axis=0), axis=1)
    assert len(steps) > 5
    assert (np.diff(steps) < 0.0).all()
    assert steps[-1] < 0.1 * steps[0]


@pytest.mark.usefixtures("heavy")
@pytest.mark.parametrize("again", ["stop", "Ctrl-C"])
def test_a_stop_after_the_start_discards_it(moving: tuple[Session, Heard], again: str) -> None:
    session, heard = moving
    for words in ("stop", "start"):
        session.hear(words)
        session.tick()
    assert session.mover.braking
    if again == "stop":
        session.hear("stop")
    else:
        session.halt(halting.KEY)
    session.rest()
    session.pass_s(1.0)
    assert not session.moving
    assert session.dialogue.arm == "stopped"
    assert heard.topics[-1] == "stopped.stop"


def test_a_stop_seen_by_the_arm_alone_after_the_start_halts_its_first_tick(
    moving: tuple[Session, Heard],
) -> None:
    session, heard = moving
    for words in ("stop", "start"):
        session.hear(words)
    session.equipment.stop_flag.set()
    reach_rest(session)
    begun = session.mover.look.hand
    session.rest()
    assert np.linalg.norm(session.mover.look.hand[:3] - begun[:3]) < 1e-4
    assert session.dialogue.arm == "stopped"
    assert heard.topics[-1] == "stopped.stop"


@pytest.mark.parametrize("words", ["go home", "open the hand", "again"])
def test_nothing_else_moves_before_rest_either(moving: tuple[Session, Heard], words: str) -> None:
    session, _ = moving
    session.hear("stop")
    session.hear(words)
    assert session.mover.braking
    reach_rest(session)
    assert session.moving
    assert session.mover.run_s == 0.0


@pytest.mark.usefixtures("heavy")
@pytest.mark.parametrize("words", ["new setup", "swap the block and the target"])
def test_things_are_put_elsewhere_only_once_the_arm_stands(
    moving: tuple[Session, Heard], words: str
) -> None:
    session, heard = moving
    session.hear("stop")
    session.tick()
    session.hear(words)
    look = session.mover.look
    where, hand, jumps = look.bodies["block"], look.hand, []
    while session.mover.braking:
        assert np.array_equal(session.mover.look.bodies["block"], where)
        session.tick()
        if session.mover.braking:
            hand, before = session.mover.look.hand, hand
            jumps.append(float(np.linalg.norm(hand[:3] - before[:3])))
    assert len(jumps) > 5
    assert max(jumps) < 0.25 * TICK_S
    assert not np.array_equal(session.mover.look.bodies["block"], where)
    start = session.mover.setup.robot_start.pose
    assert session.mover.look.hand == pytest.approx(start, abs=1e-6)
    session.hear("go")
    session.rest()
    assert heard.topics[-2:] == ["done.run", "ask.satisfied"]


@pytest.mark.parametrize("words", ["new setup", "swap them"])
def test_on_the_way_nothing_is_put_elsewhere(moving: tuple[Session, Heard], words: str) -> None:
    session, _ = moving
    before = session.mover.look
    session.hear(words)
    after = session.mover.look
    assert np.array_equal(after.hand, before.hand)
    assert all(np.array_equal(after.bodies[name], before.bodies[name]) for name in before.bodies)


@pytest.mark.usefixtures("heavy")
def test_a_stop_takes_no_arrangement_back(moving: tuple[Session, Heard]) -> None:
    session, _ = moving
    for words in ("stop", "swap the block and the target", "go", "stop"):
        session.hear(words)
        session.tick()
    session.rest()
    assert not session.moving
    told = session.dialogue.known.setup.places["block"]
    assert session.mover.setup.places["block"] == told


@pytest.mark.usefixtures("heavy")
def test_a_setup_a_program_tells_waits_for_rest(
    moving: tuple[Session, Heard], monkeypatch: pytest.MonkeyPatch
) -> None:
    session, _ = moving
    scene, setup = session.mover.scene, session.mover.setup
    before = session.mover.now_s
    places: list[tuple[float, bool]] = []
    arranged = session.mover.arrange

    def arrange(scene: Scene, setup: Setup) -> None:
        places.append((session.mover.now_s, session.moving))
        arranged(scene, setup)

    monkeypatch.setattr(session.mover, "arrange", arrange)
    session.arrange(scene, setup)
    assert places[0][0] > before + 5 * TICK_S
    assert not places[0][1]


def test_a_condition_broken_while_braking_discards_the_start(
    moving: tuple[Session, Heard], monkeypatch: pytest.MonkeyPatch
) -> None:
    session, heard = moving
    for words in ("stop", "start"):
        session.hear(words)
    lost = ArmReport("unmet", 3.0, 0, "contact", "block")
    monkeypatch.setattr(Heeding, "tick", lambda self: (lost,))
    session.tick()
    session.pass_s(1.0)
    assert not session.moving
    assert session.dialogue.arm == "stopped"
    assert heard.topics[-1] == "stopped.unmet.contact"
