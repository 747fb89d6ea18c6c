"""Talking beside a typed shell: models load while the robot greets, then ears open.

Whatever is missing (a microphone, an engine, a package) is told in one line and the keyboard
works on.
"""

from __future__ import annotations

import atexit
import threading
import time
from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass, field
from importlib.util import find_spec
from pathlib import Path

from assistant.errors import AssistantError
from assistant.model.robot_acts import RobotAct
from assistant.session.loop import Session
from assistant.shells.beside import Words
from assistant.shells.voice.choosing import SILENCE
from assistant.shells.voice.ears import Ears, Spotter
from assistant.shells.voice.endpointing import FRAME_S, Endpointer, frames_in, silero
from assistant.shells.voice.hearing import Hearing
from assistant.shells.voice.mouth import Mouth, Voice
from assistant.shells.voice.recognizers import installed
from assistant.shells.voice.sound import Samples, sound_pieces
from assistant.shells.voice.speaking import Speaking

SOON_S = 5.0
AGAIN_S = 3.0
TYPING = "the keyboard works on"


@dataclass(frozen=True, slots=True)
class TalkSettings:
    """How to listen and speak.

    Parameters
    ----------
    ears : Path, optional
        A sound file listened to in place of a microphone.
    device : str, optional
        The microphone's name; None for the default one.
    headset : bool
        The microphone does not hear the robot.
    mute : bool
        Lines are shown, not spoken.
    voice : Voice
    model : Path, optional
        A Whisper model folder.
    real_time : bool
        A sound file is heard at its own pace; else as quickly as it can be, and the arm's
        time passes with it.
    """

    ears: Path | None = None
    device: str | None = None
    headset: bool = False
    mute: bool = False
    voice: Voice = field(default_factory=Voice)
    model: Path | None = None
    real_time: bool = True


class Talking:
    """Ears and mouth of one session.

    Parameters
    ----------
    settings : TalkSettings
    show : callable
        Takes a line about the voice itself, for the screen.
    """

    def __init__(self, settings: TalkSettings, show: Callable[[str], None]) -> None:
        self._settings = settings
        self._show = show
        self._session: Session | None = None
        self._thread: threading.Thread | None = None
        self._over = threading.Event()
        self._mouth = None if settings.mute else self._opened_mouth()

    def out(self, line: RobotAct, text: str) -> None:
        """Speak a robot line; captions are the shell's."""
        if self._mouth is not None:
            self._mouth.say(text)

    def begin(self, session: Session, take: Callable[[Words], None]) -> None:
        """Load models and listen, in a thread of its own."""
        self._session = session
        self._thread = threading.Thread(
            target=self._run, args=(session, take), name="ears", daemon=True
        )
        self._thread.start()

    def finish(self) -> None:
        """Wait until a sound file has been heard; a microphone is heard no longer."""
        if self._thread is not None and self._settings.ears is not None:
            self._thread.join()
        self._hear_no_more()
        if self._mouth is not None:
            self._mouth.finish()

    def _hear_no_more(self) -> None:
        """Close the microphone, and wait for what is being recognized.

        A program that ends while a recognizer computes is aborted.
        """
        self._over.set()
        if self._thread is not None:
            self._thread.join(SOON_S)

    def _moving(self) -> bool:
        return self._session is not None and self._session.moving

    def _opened_mouth(self) -> Speaking | None:
        try:
            return Speaking(Mouth(self._settings.voice), self._moving)
        except AssistantError as error:
            self._show(f"  ({error}; lines are shown only)")
            return None

    def _run(self, session: Session, take: Callable[[Words], None]) -> None:
        try:
            frames = self._until_over(self._frames(session))
            # Behind the sound library's own: what is told of last is done first.
            atexit.register(self._hear_no_more)
            ears = self._ears(session, take)
        except AssistantError as error:
            self._show(f"  ({error}; {TYPING})")
            return
        try:
            ears.listen(frames, beside=self._settings.real_time)
        except AssistantError as error:
            self._show(f"  ({error}; {TYPING} meanwhile)")
        while self._settings.ears is None and not (session.left or self._over.is_set()):
            self._listen_again(session, ears)

    def _listen_again(self, session: Session, ears: Ears) -> None:
        """Wait for a microphone that was unplugged, and go on listening."""
        if self._over.wait(AGAIN_S):
            return
        try:
            frames = self._until_over(self._frames(session))
            ears.listen(self._told_of(frames), beside=True)
        except AssistantError:
            return

    def _until_over(self, frames: Iterable[Samples]) -> Iterator[Samples]:
        for frame in frames:
            if self._over.is_set():
                return
            yield frame

    def _told_of(self, frames: Iterable[Samples]) -> Iterator[Samples]:
        """Yield frames; the first of them is told of."""
        for at, frame in enumerate(frames):
            if at == 0:
                self._show("  (listening again)")
            yield frame

    def _ears(self, session: Session, take: Callable[[Words], None]) -> Ears:
        hearing = Hearing(installed(self._settings.model), session.language)
        # What is asked once is asked now, while the robot still greets.
        hearing.hear(SILENCE, session.listening)
        spotter = _spotter()
        told = "stop is spotted" if spotter else "no stop spotter: type or press a key to stop"
        self._show(f"  (listening with {', '.join(hearing.names)}; {told})")
        return Ears(
            session,
            take,
            Endpointer(silero()),
            hearing,
            spotter=spotter,
            voice=self._mouth,
            headset=self._settings.headset,
        )

    def _frames(self, session: Session) -> Iterable[Samples]:
        if self._settings.ears is None:
            from assistant.shells.voice.devices import check_microphone, microphone_frames

            # Before the models load: they would have nothing to hear.
            check_microphone()
            return microphone_frames(self._settings.device)
        frames = frames_in(sound_pieces(self._settings.ears))
        return _in_real_time(frames) if self._settings.real_time else _in_its_time(frames, session)


def _spotter() -> Spotter | None:
    if find_spec("livekit") is None:
        return None
    from assistant.shells.voice.spotter import StopSpotter

    return StopSpotter()


def _in_real_time(frames: Iterable[Samples]) -> Iterator[Samples]:
    began_s = time.monotonic()
    for at, frame in enumerate(frames):
        time.sleep(max(0.0, began_s + at * FRAME_S - time.monotonic()))
        yield frame


def _in_its_time(frames: Iterable[Samples], session: Session) -> Iterator[Samples]:
    for frame in frames:
        yield frame
        # The arm moves while the teacher talks and pauses.
        session.pass_s(FRAME_S)
