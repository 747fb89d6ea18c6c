"""The nearest speaker's stretch: the room is cut off at the ends, speech never is."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from numpy.typing import NDArray

from assistant.shells.voice.foreground import CLEAR_DB, HIDDEN, HIDDEN_S, MARGIN_S, foreground
from assistant.shells.voice.sound import RATE_HZ

pytestmark = pytest.mark.voice


def tone(seconds: float, loud: float, rng: np.random.Generator) -> NDArray[np.float32]:
    return (loud * rng.standard_normal(round(seconds * RATE_HZ))).astype(np.float32)


@settings(max_examples=25, deadline=None)
@given(st.floats(0.4, 1.5), st.floats(0.4, 1.5), st.floats(0.4, 2.0), st.sampled_from((8.0, 20.0)))
def test_a_room_far_below_the_speaker_is_cut_off(
    before_s: float, after_s: float, speech_s: float, below_db: float
) -> None:
    rng = np.random.default_rng(3)
    room = 0.3 * 10 ** (-(below_db + 4.0) / 20)
    parts = (tone(before_s, room, rng), tone(speech_s, 0.3, rng), tone(after_s, room, rng))
    found = foreground(np.concatenate(parts))
    kept, found_s = found.samples, found.speech_s
    # A loud room hides the soft beginnings and ends of speech: more is kept of it.
    hidden_s = HIDDEN_S * np.interp(below_db + 4.0, CLEAR_DB, HIDDEN)
    assert found_s == pytest.approx(speech_s + hidden_s, abs=0.15)
    assert len(kept) / RATE_HZ == pytest.approx(speech_s + 2 * (MARGIN_S + hidden_s), abs=0.15)
    assert found.clear_db == pytest.approx(below_db + 4.0, abs=2.0)


def test_speech_alone_is_kept_whole() -> None:
    speech = tone(1.2, 0.3, np.random.default_rng(1))
    found = foreground(speech)
    kept, found_s = found.samples, found.speech_s
    assert len(kept) == len(speech)
    assert found_s == pytest.approx(1.2, abs=0.05)


def test_pauses_within_a_sentence_stay() -> None:
    rng = np.random.default_rng(2)
    parts = (tone(0.6, 0.3, rng), tone(0.8, 0.001, rng), tone(0.6, 0.2, rng))
    found = foreground(np.concatenate(parts))
    kept, found_s = found.samples, found.speech_s
    assert found_s == pytest.approx(1.2, abs=0.1)
    assert len(kept) == round(2.0 * RATE_HZ)


def test_soft_sounds_hidden_by_a_loud_room_are_no_pause() -> None:
    rng = np.random.default_rng(5)
    loud = [(0.2, 0.3), (0.25, 0.02)]
    clean = np.concatenate([tone(*one, rng) for one in ((0.5, 0.0005), *3 * loud, (0.5, 0.0005))])
    noisy = clean + tone(len(clean) / RATE_HZ, 0.06, rng)
    assert foreground(noisy).speech_s == pytest.approx(foreground(clean).speech_s, rel=0.25)


def test_a_faint_voice_after_a_pause_is_not_the_speaker() -> None:
    rng = np.random.default_rng(2)
    pieces = ((0.3, 0.001), (0.8, 0.3), (0.8, 0.001), (0.3, 0.06), (0.3, 0.001))
    found_s = foreground(np.concatenate([tone(*one, rng) for one in pieces])).speech_s
    assert found_s == pytest.approx(0.8, abs=0.1)


@pytest.mark.parametrize("count", [0, 1, 100, RATE_HZ])
def test_silence_and_next_to_nothing_stay_as_they_are(count: int) -> None:
    samples = np.zeros(count, dtype=np.float32)
    assert len(foreground(samples).samples) <= count
