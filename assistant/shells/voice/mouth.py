"""The robot's voice: an engine in a process of its own, cut off when the teacher speaks."""

from __future__ import annotations

import shutil
import subprocess
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

from assistant.errors import BadInput

ENGINES = ("espeak-ng", "flite", "piper")


@dataclass(frozen=True, slots=True)
class Voice:
    """How the robot speaks.

    Parameters
    ----------
    engine : str
        One of `ENGINES`; empty for the first that is installed.
    name : str
        The engine's name of a voice, or for Piper the model file; empty for its default.
    words_per_minute : int
    """

    engine: str = ""
    name: str = ""
    words_per_minute: int = 165


def engines() -> tuple[str, ...]:
    """Return the installed engines, the default first."""
    return tuple(engine for engine in ENGINES if shutil.which(engine))


class Mouth:
    """Speaks one sentence at a time; a new one, or `hush`, cuts the last one off.

    Raises
    ------
    BadInput
        If the engine asked for, or any at all, is not installed.
    """

    def __init__(self, voice: Voice | None = None) -> None:
        self.voice = voice or Voice()
        found = engines()
        self.engine = self.voice.engine or (found[0] if found else "")
        if self.engine not in found:
            named = self.engine or "a speech engine"
            raise BadInput.one("voice", f"{named} is not installed", "apt install espeak-ng")
        self._process: subprocess.Popen[bytes] | None = None

    @property
    def speaking(self) -> bool:
        """Whether a sentence is being spoken."""
        return self._process is not None and self._process.poll() is None

    def say(self, text: str) -> None:
        """Begin to speak a sentence aloud and return at once."""
        self.hush()
        self._process = subprocess.Popen(
            self._command(text, None),
            stdin=subprocess.DEVNULL,
            stdout=subprocess.DEVNULL,
            stderr=subprocess.DEVNULL,
        )

    def speak(self, text: str) -> None:
        """Speak a sentence aloud and return when it is said.

        Raises
        ------
        BadInput
            If no sound came out.
        """
        self.hush()
        done = subprocess.run(
            self._command(text, None), stdin=subprocess.DEVNULL, capture_output=True, check=False
        )
        # Without a loudspeaker espeak-ng says so and ends as if all were well.
        told = done.stderr.decode(errors="replace").splitlines()
        if done.returncode != 0 or any(line.startswith("error") for line in told):
            right = "a sound device, or --wav FILE"
            raise BadInput.one("voice", f"{self.engine} could not speak aloud", right)

    def hush(self) -> None:
        """Fall silent now."""
        if self._process is not None and self._process.poll() is None:
            self._process.kill()
            self._process.wait()
        self._process = None

    def write(self, text: str, path: Path) -> None:
        """Speak a sentence into a WAV file.

        Raises
        ------
        BadInput
            If the engine could not write it.
        """
        done = subprocess.run(
            self._command(text, path), stdin=subprocess.DEVNULL, capture_output=True, check=False
        )
        if done.returncode != 0 or not path.is_file():
            told = done.stderr.decode(errors="replace").strip().splitlines()
            why = told[-1] if told else f"{self.engine} ended with status {done.returncode}"
            what = f"the sentence could not be spoken: {why}"
            raise BadInput.one(str(path), what, "another engine; assistant voice lists them")

    def _command(self, text: str, path: Path | None) -> Sequence[str]:
        name, rate = self.voice.name, self.voice.words_per_minute
        if self.engine == "espeak-ng":
            out = ["-w", str(path)] if path else []
            return ["espeak-ng", "-v", name or "en-us", "-s", str(rate), *out, "--", text]
        if self.engine == "flite":
            stretch = f"duration_stretch={165 / rate:.2f}"
            out = ["-o", str(path) if path else "play"]
            return ["flite", "-voice", name or "slt", "--setf", stretch, "-t", text, *out]
        out = ["-f", str(path)] if path else []
        return ["piper", "-m", name or "en_US-joe-medium", *out, "--", text]
