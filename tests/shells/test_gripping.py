"""The mouse holds the hand only while its button is down."""

from __future__ import annotations

from prompt_toolkit.data_structures import Point
from prompt_toolkit.mouse_events import MouseButton, MouseEvent, MouseEventType

from assistant.geometry import IDENTITY, Array
from assistant.ports import HandSample
from assistant.session.equipment import DrivenState
from assistant.shells.driving_picture import Sight
from assistant.shells.gripping import Area, Grip

ABOVE = Sight(0, (-200.0, 300.0), 10.0, 10, 20, False)
DOWN, UP, MOVE = MouseEventType.MOUSE_DOWN, MouseEventType.MOUSE_UP, MouseEventType.MOUSE_MOVE


class Led:
    """A hand that remembers how it was led."""

    tip: Array = IDENTITY

    def __init__(self) -> None:
        self.moves: list[tuple[float, float, float]] = []
        self.releases = 0

    @property
    def state(self) -> DrivenState:
        raise NotImplementedError

    def press(self, key: str) -> bool:
        return False

    def lead(self, move_m: tuple[float, float, float]) -> None:
        self.moves.append(move_m)

    def release(self) -> None:
        self.releases += 1

    def say(self, text: str) -> None: ...

    def tick(self) -> HandSample:
        raise NotImplementedError


def event(
    kind: MouseEventType, line: int, column: int, button: MouseButton = MouseButton.LEFT
) -> MouseEvent:
    return MouseEvent(Point(x=column, y=line), kind, button, frozenset())


def gripped() -> tuple[Led, Grip]:
    hand = Led()
    grip = Grip(hand, lambda: (Area(ABOVE, 5, 1),))
    assert grip.take(event(DOWN, 9, 21))
    return hand, grip


def test_the_hand_follows_while_the_button_is_held() -> None:
    hand, grip = gripped()
    assert grip.holds
    grip.take(event(MOVE, 8, 21))
    grip.take(event(MOVE, 8, 17))
    # A row up is forward, two characters left are a cell to the left.
    assert hand.moves == [(0.01, -0.0, 0.0), (-0.0, 0.02, 0.0)]
    assert grip.take(event(UP, 8, 17))
    assert hand.releases == 1
    assert not grip.take(event(MOVE, 5, 5))
    assert len(hand.moves) == 2


def test_beyond_the_picture_the_hand_waits_for_the_pointer() -> None:
    hand, grip = gripped()
    grip.take(event(MOVE, 2, 3))
    assert hand.moves == []
    grip.take(event(MOVE, 9, 23))
    assert hand.moves == [(-0.0, -0.01, 0.0)]


def test_a_button_let_go_unseen_lets_the_hand_go() -> None:
    hand, grip = gripped()
    grip.take(event(MOVE, 8, 21, MouseButton.NONE))
    assert hand.moves == []
    assert hand.releases == 1
    assert not grip.holds


def test_a_press_beside_the_pictures_grips_nothing() -> None:
    hand = Led()
    grip = Grip(hand, lambda: (Area(ABOVE, 5, 1),))
    for place in ((4, 5), (15, 5), (6, 0), (6, 41)):
        assert not grip.take(event(DOWN, *place))
        assert not grip.take(event(MOVE, 6, 6))
    assert hand.moves == []
