"""The stop spotter: its slopes are right, it learns what it is shown, it hears stop."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from numpy.typing import NDArray

from assistant.session.practice import success_interval
from assistant.shells.voice.mouth import Mouth, Voice
from assistant.shells.voice.sound import RATE_HZ, Sound, read_sound, write_sound
from assistant.shells.voice.spotter import Classifier, StopSpotter, stacked
from assistant.shells.voice.train_spotter import Examples, _labels, _share, _slopes, report, train
from assistant.shells.voice.training_sounds import STOPS, by_people, placed, said_by

DECAY = 1e-4


def loss(
    weights: list[NDArray[np.float64]], rows: NDArray[np.float64], labels: NDArray[np.float32]
) -> float:
    w1, b1, w2, b2 = weights
    hidden = np.maximum(rows @ w1 + b1, 0.0)
    scores = 1.0 / (1.0 + np.exp(-(hidden @ w2 + b2)))
    fit = -np.mean(labels * np.log(scores) + (1 - labels) * np.log(1 - scores))
    return float(fit + 0.5 * DECAY * (np.sum(w1**2) + np.sum(w2**2)))


def test_slopes_agree_with_differences() -> None:
    rng = np.random.default_rng(3)
    rows = rng.standard_normal((20, 5))
    labels = (rng.random(20) < 0.4).astype(np.float32)
    weights = [rng.standard_normal((5, 4)), rng.standard_normal(4), rng.standard_normal(4),
               np.array(0.3)]  # fmt: skip
    for at, slope in enumerate(_slopes(weights, rows, labels)):
        for place in np.ndindex(weights[at].shape):
            moved = [[w.copy() for w in weights] for _ in range(2)]
            moved[0][at][place] += 1e-6
            moved[1][at][place] -= 1e-6
            differences = (loss(moved[0], rows, labels) - loss(moved[1], rows, labels)) / 2e-6
            assert np.asarray(slope)[place] == pytest.approx(differences, abs=1e-6)


def clouds(rng: np.random.Generator) -> Examples:
    """Return 40 clips of three rows; in every fourth the middle row is a stop."""
    clips = np.repeat(np.arange(40), 3)
    labels = ((np.arange(120) % 3 == 1) & (clips % 4 == 0)).astype(np.float32)
    features = rng.standard_normal((120, 6)) + 4.0 * labels[:, None]
    late_s = np.tile([-0.08, 0.0, 0.08], 40)
    return Examples(features.astype(np.float32), labels, clips, late_s)


def test_what_was_trained_is_kept_and_tells_the_clouds_apart(tmp_path: Path) -> None:
    rng = np.random.default_rng(5)
    told = clouds(rng)
    weights = train(told, rng, steps=300)
    np.savez(tmp_path / "weights.npz", threshold=np.float32(0.5), **weights)
    scores = Classifier(tmp_path / "weights.npz")(told.features)
    assert np.all((scores > 0.5) == (told.labels > 0.5))
    assert "missed 0/10" in report(told, weights)
    assert "false 0/30" in report(told, weights)
    assert "median +0.00 s late" in report(told, weights)


def test_rows_near_the_end_of_the_word_are_stops_and_what_is_unsure_is_left_out() -> None:
    late_s = np.array([-1.0, -0.2, 0.1, 0.4, 0.6])
    assert _labels(late_s, True).tolist() == [0.0, -1.0, 1.0, -1.0, 0.0]
    assert _labels(late_s, False).tolist() == [0.0] * 5


@pytest.mark.parametrize(("count", "total"), [(0, 7), (3, 40), (40, 40)])
def test_shares_come_with_the_interval_everything_else_has(count: int, total: int) -> None:
    low, high = success_interval(count, total)
    assert _share(count, total) == f"{count}/{total} ({low:.3f} to {high:.3f})"


def test_each_row_looks_back_over_its_forerunners() -> None:
    embeddings = np.arange(5 * 96, dtype=np.float32).reshape(5, 96)
    rows = stacked(embeddings)
    assert rows.shape == (3, 288)
    assert np.array_equal(rows[1], embeddings[1:4].ravel())
    assert stacked(embeddings[:2]).shape == (0, 288)


def test_a_sentence_is_placed_with_sound_before_and_behind_it() -> None:
    rng = np.random.default_rng(4)
    for _ in range(8):
        said = rng.standard_normal(RATE_HZ // 2).astype(np.float32)
        noisy, ends_s = placed(said, rng)
        assert 1.0 + 0.4 <= ends_s <= 1.5 + 0.6
        assert len(noisy) / RATE_HZ >= ends_s + 0.4
        assert noisy.dtype == np.float32
        assert np.all(np.isfinite(noisy))


def test_every_speaker_says_stop_alone_once() -> None:
    told = said_by(np.random.default_rng(2), others=5)
    assert told[0] == "stop"
    assert told[1] in STOPS[1:]
    assert len(set(told)) == 7


@pytest.mark.voice
def test_people_come_in_pieces_and_never_say_stop(tmp_path: Path) -> None:
    rng = np.random.default_rng(1)
    for name, seconds in (("a", 9), ("b", 2)):
        sound = 0.1 * rng.standard_normal(seconds * RATE_HZ)
        write_sound(tmp_path / f"{name}.wav", Sound(sound.astype(np.float32)))
    told = list(by_people([tmp_path]))
    assert [round(len(samples) / RATE_HZ) for _, samples in told] == [8, 1, 2]
    assert not any(is_stop for is_stop, _ in told)


@pytest.mark.voice
def test_stop_is_heard_and_quiet_is_not(tmp_path: Path) -> None:
    heard = 0
    for name in ("en-us", "en-gb", "en-gb-x-rp+f4"):
        Mouth(Voice("espeak-ng", name)).write("stop", tmp_path / "stop.wav")
        said = read_sound(tmp_path / "stop.wav").samples
        quiet = np.zeros(RATE_HZ, np.float32)
        heard += StopSpotter().hear(np.concatenate([quiet, said, quiet[: RATE_HZ // 2]]))
    assert heard >= 2
    rng = np.random.default_rng(1)
    assert not StopSpotter().hear((1e-4 * rng.standard_normal(2 * RATE_HZ)).astype(np.float32))
