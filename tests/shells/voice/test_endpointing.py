"""Utterances hold all that was spoken, and nothing piles up however long it is noisy."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from assistant.shells.voice.endpointing import (
    FRAME,
    FRAME_S,
    Endpointer,
    EndpointSettings,
    Utterance,
    utterances_in,
)
from assistant.shells.voice.sound import RATE_HZ, Samples, Sound


def loudness(frame: Samples) -> float:
    return float(np.abs(frame).max() > 0.1)


def sound_of(*pieces: tuple[float, bool]) -> Sound:
    parts = [np.full(round(s / FRAME_S) * FRAME, 0.5 * loud, np.float32) for s, loud in pieces]
    return Sound(np.concatenate(parts))


@given(st.lists(st.tuples(st.floats(0.2, 1.5), st.floats(0.6, 2.0)), min_size=1, max_size=4))
def test_every_word_is_in_one_utterance(told: list[tuple[float, float]]) -> None:
    pieces = [(0.5, False)]
    for speech_s, silence_s in told:
        pieces += [(speech_s, True), (silence_s, False)]
    sound = sound_of(*pieces)
    found = list(utterances_in(sound, loudness))
    assert len(found) == len(told)
    spoken = sum(float(np.abs(one.sound.samples).sum()) for one in found)
    assert spoken == pytest.approx(float(np.abs(sound.samples).sum()))


def test_the_beginning_is_the_instant_of_the_first_sound() -> None:
    found = next(utterances_in(sound_of((1.0, False), (0.4, True), (1.0, False)), loudness))
    assert found.speech_from_s == pytest.approx(1.0, abs=FRAME_S)
    assert found.speech_to_s == pytest.approx(1.4, abs=FRAME_S)
    assert found.sound.from_s < found.speech_from_s


def test_a_click_is_no_utterance() -> None:
    assert not list(utterances_in(sound_of((0.5, False), (0.04, True), (1.0, False)), loudness))


def test_a_short_answer_ends_sooner() -> None:
    ended: list[int] = []
    for short in (False, True):
        endpointer = Endpointer(loudness)
        endpointer.short_answer = short
        frames = sound_of((0.3, True), (1.0, False)).samples.reshape(-1, FRAME)
        ended.append(next(at for at, frame in enumerate(frames) if endpointer.hear(frame)))
    settings = EndpointSettings()
    gain_s = settings.silence_s - settings.short_silence_s
    assert (ended[0] - ended[1]) * FRAME_S == pytest.approx(gain_s, abs=2 * FRAME_S)


def test_endless_noise_is_cut_into_bounded_pieces() -> None:
    found = list(utterances_in(sound_of((100.0, True)), loudness))
    assert max(one.sound.duration_s for one in found) <= EndpointSettings().longest_s + FRAME_S
    assert sum(len(one.sound.samples) for one in found) == pytest.approx(100 * RATE_HZ, rel=0.01)


def test_the_end_of_a_file_ends_the_sentence() -> None:
    found = list(utterances_in(sound_of((0.2, False), (0.5, True)), loudness))
    assert len(found) == 1
    assert found[0].speech_to_s == pytest.approx(0.7, abs=2 * FRAME_S)


def test_recognizing_may_begin_ahead_of_the_end_with_all_that_was_said() -> None:
    endpointer = Endpointer(loudness)
    sound = sound_of((0.3, False), (0.6, True), (0.25, False), (0.4, True), (1.0, False))
    ahead: list[Utterance] = []
    ended: list[Utterance] = []
    for frame in sound.samples.reshape(-1, FRAME):
        if one := endpointer.hear(frame):
            ended.append(one)
        elif paused := endpointer.paused():
            ahead.append(paused)
    # Once in the pause within the sentence, once at its end.
    assert [one.speech_to_s < ended[0].speech_to_s for one in ahead] == [True, False]
    assert ahead[1].speech_from_s == ended[0].speech_from_s
    spoken = (float(np.abs(one.sound.samples).sum()) for one in (ahead[1], ended[0]))
    assert next(spoken) == pytest.approx(next(spoken))


def test_nobody_recognizes_a_click_ahead() -> None:
    endpointer = Endpointer(loudness)
    for frame in sound_of((0.3, False), (0.04, True), (0.4, False)).samples.reshape(-1, FRAME):
        endpointer.hear(frame)
        assert endpointer.paused() is None


def test_somebody_is_there_for_a_second_after_they_spoke() -> None:
    endpointer = Endpointer(loudness)
    assert not endpointer.somebody
    told: list[bool] = []
    for loud in (1.0, *[0.0] * round(1.5 / FRAME_S)):
        endpointer.hear(np.full(FRAME, loud, np.float32))
        told.append(endpointer.somebody)
    assert told == sorted(told, reverse=True)
    assert sum(told) * FRAME_S == pytest.approx(1.0, abs=FRAME_S)
