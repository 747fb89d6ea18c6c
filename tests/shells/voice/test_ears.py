"""Words reach the session with their time, stops at once, and the robot does not hear itself."""

from __future__ import annotations

import threading
from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass, field
from types import SimpleNamespace
from typing import cast

import numpy as np
import pytest

from assistant.language.understanding import understand
from assistant.model.listening import Listening, Understanding
from assistant.model.teacher_acts import Unknown
from assistant.session.loop import Session
from assistant.shells.beside import Words
from assistant.shells.voice.deciding import Heard
from assistant.shells.voice.ears import Ears
from assistant.shells.voice.endpointing import FRAME, FRAME_S, Endpointer
from assistant.shells.voice.sound import Samples


@dataclass
class Room:
    """A session as far as ears see it, and the robot's voice."""

    moving: bool = False
    left: bool = False
    watching: object = None
    language: str = "english"
    listening: Listening = field(default_factory=lambda: Listening(stage="practice"))
    equipment: SimpleNamespace = field(
        default_factory=lambda: SimpleNamespace(stop_flag=threading.Event())
    )
    speaking: bool = False
    own_words: str = ""
    hushed: int = 0

    def raw(self, text: str) -> None:
        if self.moving and "stop" in text:
            self.equipment.stop_flag.set()

    def hush(self) -> None:
        self.hushed += 1

    def is_echo(self, words: str) -> bool:
        return words in self.own_words


@dataclass
class Says:
    """Hears the same words in every utterance."""

    words: str
    sure: float = 0.96

    def hear(self, samples: Samples, listening: Listening) -> Heard:
        meant = understand(self.words, listening)
        if not self.words:
            meant = Understanding((Unknown(),), 1.0, "")
        sure = min(meant.confidence, self.sure)
        return Heard(self.words, Understanding(meant.acts, sure, self.words), sure=self.sure)


class SpotsLoud:
    """Takes very loud sound for stop."""

    def hear(self, samples: Samples) -> bool:
        return bool(np.max(samples) > 0.9)


def loudness(frame: Samples) -> float:
    return float(np.abs(frame).max() > 0.1)


def frames(*pieces: tuple[float, float]) -> list[Samples]:
    """Return frames of pieces told by seconds and loudness."""
    return [
        np.full(FRAME, loud, dtype=np.float32)
        for seconds, loud in pieces
        for _ in range(round(seconds / FRAME_S))
    ]


def hear(
    room: Room, words: str, told: Iterable[Samples], *, beside: bool = False, headset: bool = False
) -> list[Words]:
    taken: list[Words] = []
    ears = Ears(
        cast("Session", room),
        taken.append,
        Endpointer(loudness),
        Says(words),
        spotter=SpotsLoud(),
        voice=room,
        headset=headset,
    )
    ears.listen(told, beside=beside)
    return taken


UTTERANCE = ((0.5, 0.0), (0.6, 0.5), (0.8, 0.0))


@pytest.mark.parametrize("beside", [False, True])
def test_words_come_with_how_surely_and_how_long_ago(beside: bool) -> None:
    (words,) = hear(Room(), "slower", frames(*UTTERANCE), beside=beside)
    assert words.text == "slower"
    assert 0.85 <= words.sure <= 1.0
    # Said for 0.6 s and noticed after the silence that ends an utterance.
    assert 0.6 + 0.4 <= words.ago_s <= 0.6 + 0.8 + FRAME_S


def test_what_was_found_to_mean_nothing_is_not_taken_for_something() -> None:
    class Doubts(Says):
        def hear(self, samples: Samples, listening: Listening) -> Heard:
            return Heard(self.words, Understanding((Unknown(),), 0.85, self.words))

    taken: list[Words] = []
    ears = Ears(cast("Session", Room()), taken.append, Endpointer(loudness), Doubts("ten"))
    ears.listen(frames(*UTTERANCE), beside=False)
    assert [words.sure < 0.85 for words in taken] == [True]


def test_silence_is_no_utterance() -> None:
    assert hear(Room(), "slower", frames((2.0, 0.0))) == []


def test_what_is_still_being_said_at_the_end_counts() -> None:
    assert [one.text for one in hear(Room(), "faster", frames((0.5, 0.5)))] == ["faster"]


def test_a_spotted_stop_halts_before_the_word_is_recognized() -> None:
    room = Room(moving=True)
    taken = hear(room, "stop", frames((0.5, 0.0), (0.4, 0.95), (0.8, 0.0)))
    assert room.equipment.stop_flag.is_set()
    assert {one.text for one in taken} == {"stop"}
    # What recognition makes of the same word later is not a second stop.
    assert all(one.ago_s == 0.0 for one in taken)


def test_clatter_that_resembles_stop_halts_nothing() -> None:
    room = Room(moving=True)
    ears = Ears(
        cast("Session", room),
        lambda words: None,
        Endpointer(lambda frame: 0.2),
        Says(""),
        spotter=SpotsLoud(),
    )
    ears.listen(frames((0.5, 0.0), (0.4, 0.95), (0.8, 0.0)), beside=False)
    assert not room.equipment.stop_flag.is_set()


def test_at_rest_a_spotted_stop_does_nothing() -> None:
    room = Room()
    assert hear(room, "", frames((0.5, 0.0), (0.4, 0.95), (0.8, 0.0))) == []
    assert not room.equipment.stop_flag.is_set()


def test_the_robot_does_not_hear_itself() -> None:
    room = Room(speaking=True, own_words="slower")
    assert hear(room, "slower", frames(*UTTERANCE)) == []


def test_without_a_headset_only_stop_is_heard_while_the_robot_speaks() -> None:
    assert hear(Room(speaking=True), "slower", frames(*UTTERANCE)) == []
    moving = Room(speaking=True, moving=True)
    assert [one.text for one in hear(moving, "stop", frames(*UTTERANCE))] == ["stop"]
    assert moving.equipment.stop_flag.is_set()


def test_who_answers_before_the_robot_has_quite_ended_is_heard() -> None:
    room = Room(speaking=True, own_words="is that right")

    def told() -> Iterator[Samples]:
        yield from frames((0.5, 0.0), (0.6, 0.5))
        room.speaking = False
        yield from frames((0.15, 0.0), (0.6, 0.5), (0.8, 0.0))

    assert [one.text for one in hear(room, "slower", told())] == ["slower"]


def test_with_a_headset_the_robot_falls_silent() -> None:
    room = Room(speaking=True)
    taken = hear(room, "slower", frames(*UTTERANCE), headset=True)
    assert [one.text for one in taken] == ["slower"]
    assert room.hushed


def test_chat_while_the_arm_moves_is_left_alone() -> None:
    room = Room(moving=True)
    assert hear(room, "the weather is nice today", frames(*UTTERANCE)) == []


def test_who_has_left_hears_nothing() -> None:
    assert hear(Room(left=True), "slower", frames(*UTTERANCE)) == []


def test_the_spotter_listens_on_while_the_robot_speaks() -> None:
    room = Room(speaking=True, moving=True)
    hear(room, "", frames((0.5, 0.0), (0.4, 0.95), (0.8, 0.0)))
    assert room.equipment.stop_flag.is_set()


@dataclass
class Counts(Says):
    """Counts how often it is asked, and where the dialogue stood."""

    asked: list[Listening] = field(default_factory=list)
    heard: threading.Semaphore = field(default_factory=lambda: threading.Semaphore(0))

    def hear(self, samples: Samples, listening: Listening) -> Heard:
        self.asked.append(listening)
        self.heard.release()
        return super().hear(samples, listening)


def in_turn(
    told: list[Samples], counts: Counts, change: Callable[[], None], times: int
) -> Iterator[Samples]:
    """Yield frames; the last of them after so many recognitions, and after a change."""
    yield from told[:-20]
    for _ in range(times):
        assert counts.heard.acquire(timeout=10.0)
    change()
    yield from told[-20:]


@pytest.mark.parametrize("changes", [False, True])
def test_what_was_recognized_ahead_of_the_end_is_not_recognized_again(changes: bool) -> None:
    room, counts = Room(), Counts("slower")
    taken: list[Words] = []
    ears = Ears(cast("Session", room), taken.append, Endpointer(loudness), counts)

    def change() -> None:
        if changes:
            room.listening = Listening(stage="practice", asked="satisfied")

    # The last twenty frames are silence; the silence before is not long enough to end it.
    told = frames((0.5, 0.0), (0.6, 0.5), (0.25 + 20 * FRAME_S, 0.0))
    ears.listen(in_turn(told, counts, change, 1), beside=True)
    assert [one.text for one in taken] == ["slower"]
    assert counts.asked[-1] == room.listening
    assert len(counts.asked) == 1 + changes


@pytest.mark.parametrize(("moving", "recognized"), [(False, 0), (True, 1)])
def test_at_rest_the_robots_own_voice_is_not_even_recognized(moving: bool, recognized: int) -> None:
    room, counts = Room(speaking=True, moving=moving), Counts("slower")
    ears = Ears(cast("Session", room), lambda words: None, Endpointer(loudness), counts, voice=room)
    ears.listen(frames(*UTTERANCE), beside=False)
    assert len(counts.asked) == recognized
