"""A whole lesson by ear: the shipped transcript spoken by synthesized teachers, against typed.

Every line of the teacher is spoken into one stream of sound with pauses, found by voice
activity, recognized, understood and answered. The teacher behaves as a person would: where the
robot asks whether it heard right, it says yes, or no and the line again; what was missed is said
again, more slowly, at most twice, and typed at last, as the robot proposes. The cues of the
demonstration are spoken while the hand moves, at the times at which they were typed. Trees must
be the same, cuts within 0.3 s, Table I the same.

run: python -m tests.benchmarks.bench_lesson_by_ear [SPEAKER...] [--noise DB] [--show]
"""

from __future__ import annotations

import argparse
import statistics
import tempfile
import time
from collections.abc import Iterator
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import Any

import numpy as np

from assistant.cli.adapters import make_equipment
from assistant.files.demonstrations import read_demonstration
from assistant.files.shipped import shipped
from assistant.files.transcripts import read_transcript
from assistant.model.demonstration import Spoken
from assistant.model.robot_acts import RobotAct
from assistant.model.transcript import (
    Demonstrate,
    SetupStep,
    TeacherLine,
    Transcript,
    Wait,
)
from assistant.session.acting import demonstrate, wait
from assistant.session.opening import Opening, chosen, open_session
from assistant.shells.beside import Words
from assistant.shells.voice.deciding import Heard
from assistant.shells.voice.ears import Ears
from assistant.shells.voice.endpointing import FRAME_S, Endpointer, frames_in, silero
from assistant.shells.voice.hearing import Hearing
from assistant.shells.voice.recognizers import installed
from assistant.shells.voice.sound import RATE_HZ, Samples, Sound
from tests.benchmarks.voices import REPORTED, Noise, Speaker, noise, noisy, spoken

MOST_TRIES = 3
SLOWER = 1.15
"""What is said again is said so much more slowly each time."""
GAP_S = 0.6
Listening = Any


@dataclass(slots=True)
class Timed:
    """A hearing that remembers what it heard and how long that took."""

    hearing: Hearing
    took_s: list[float] = field(default_factory=list)

    def hear(self, samples: Samples, listening: Listening) -> Heard:
        began_s = time.perf_counter()
        heard = self.hearing.hear(samples, listening)
        self.took_s.append(time.perf_counter() - began_s)
        return heard


@dataclass(slots=True)
class Teacher:
    """One who says the lines of a transcript aloud."""

    speaker: Speaker
    noise_db: float | None
    folder: Path
    rng: np.random.Generator
    said: int = 0
    repeated: int = 0
    typed: int = 0
    heard: list[tuple[str, str, float]] = field(default_factory=list)

    def stream(self, text: str, again: int = 0) -> Samples:
        """Return a line with pauses before and behind it, slower each time it is said again."""
        self.said += 1
        before, after = (self.rng.uniform(*span) for span in ((0.5, 1.5), (0.8, 1.2)))
        slowness = self.speaker.slowness * SLOWER**again
        voice = spoken(replace(self.speaker, slowness=slowness), text, self.folder)
        parts = [np.zeros(int(before * RATE_HZ)), 0.6 * voice, np.zeros(int(after * RATE_HZ))]
        return self.in_room(np.concatenate(parts).astype(np.float32))

    def in_room(self, clip: Samples) -> Samples:
        """Return sound with the room's noise."""
        if self.noise_db is None:
            return clip
        room: Noise = noise("kitchen", len(clip), self.rng, self.folder)
        return noisy(clip, room, self.noise_db)


class Lesson:
    """The transcript's lesson, typed or by ear."""

    def __init__(self, play: Transcript, folder: Path, teacher: Teacher | None) -> None:
        self.play = play
        self.base = Path(play.source).parent
        self.teacher = teacher
        self.lines: list[RobotAct] = []
        opening = Opening(make_equipment, folder, lambda line, text: self.lines.append(line))
        self.session = open_session(opening, play)
        self.cues: list[tuple[float, str]] = []

    def hold(self, hearing: Timed | None) -> dict[str, Any]:
        """Hold the lesson and return what the session knows at its end."""
        if self.teacher is not None and hearing is not None:
            self.ears = Ears(self.session, self._take, Endpointer(silero()), hearing)
        for step in self.play.steps:
            match step:
                case TeacherLine():
                    self._say(step.text)
                case Wait():
                    wait(self.session, step)
                case SetupStep():
                    self.session.arrange(*chosen(step.choice, self.base))
                case Demonstrate():
                    self._show(step)
                case _:
                    pass
        view = dict(self.session.dialogue_view)
        self.session.close()
        return view

    def _take(self, words: Words) -> None:
        assert self.teacher is not None
        said, before, _ = self.teacher.heard[-1]
        if before:
            self.teacher.heard.append((said, words.text, words.sure))
        else:
            self.teacher.heard[-1] = (said, words.text, words.sure)
        self.session.hear(words.text, by_voice=True, sure=words.sure, ago_s=words.ago_s)

    def _say(self, text: str) -> None:
        if self.teacher is None:
            self.session.hear(text)
            return
        for again in range(MOST_TRIES):
            before = len(self.lines)
            self._speak(text, again)
            if self.session.listening.asked == "did_you_mean":
                if not self._doubted(text):
                    return
            elif not self._missed(before):
                return
            self.teacher.repeated += 1
        self.teacher.typed += 1
        self.session.hear(text)

    def _speak(self, text: str, again: int = 0) -> None:
        assert self.teacher is not None
        self.teacher.heard.append((text, "", 0.0))
        self.ears.listen(frames_in([Sound(self.teacher.stream(text, again))]), beside=False)

    def _missed(self, before: int) -> bool:
        """Whether the robot heard nothing, or told that it did not understand."""
        new = self.lines[before:]
        return not new or any(line.topic.startswith("not_understood") for line in new)

    def _doubted(self, text: str) -> bool:
        """Answer the robot that asks whether it heard right; return whether to repeat."""
        assert self.teacher is not None
        right = self.teacher.heard[-1][1].lower() == text.lower()
        for again in range(MOST_TRIES):
            before = len(self.lines)
            self._speak("yes" if right else "no", again)
            if self.session.listening.asked != "did_you_mean" and not self._missed(before):
                break
        return not right

    def _show(self, step: Demonstrate) -> None:
        if self.teacher is None:
            demonstrate(self.session, step, self.base)
            return
        assert step.recording is not None
        path = (self.base / step.recording).resolve()
        shown = read_demonstration(path)
        silent = Demonstrate(recording=str(path.parent / shown.source), cues=(), key_states=())
        hand = self.session.equipment.hand(
            silent,
            self.session.dialogue.known.task,
            self.session.mover.scene,
            self.session.mover.setup,
        )
        samples = hand.samples()
        said = self._in_turn(shown.cues, shown.key_states)
        self.ears.listen(self._with_hand(said, samples), beside=False)
        if self.session.watching is not None:
            self.cues = [(one.at_s, one.say) for one in self.session.watching.cues]
            self.session.end_recording(keep=True)

    def _in_turn(
        self, cues: tuple[Spoken, ...], key_states: tuple[Spoken, ...]
    ) -> list[tuple[float, str]]:
        """Return the cues, and those key states that fit between them: nobody says two at once."""
        assert self.teacher is not None
        said: list[tuple[float, float, str]] = []
        for one in (*cues, *key_states):
            voice = spoken(self.teacher.speaker, one.say, self.teacher.folder)
            until_s = one.at_s + len(voice) / RATE_HZ + GAP_S
            if all(until_s <= from_s or one.at_s >= to_s for from_s, to_s, _ in said):
                said.append((one.at_s, until_s, one.say))
        return [(from_s, text) for from_s, _, text in sorted(said)]

    def _with_hand(self, said: list[tuple[float, str]], samples: Any) -> Iterator[Samples]:
        """Yield the sound of the demonstration while the hand moves along."""
        assert self.teacher is not None
        length_s = max(at_s for at_s, _ in said) + 4.0
        sound = np.zeros(int(length_s * RATE_HZ), dtype=np.float32)
        for at_s, text in said:
            voice = 0.6 * spoken(self.teacher.speaker, text, self.teacher.folder)
            first = int(at_s * RATE_HZ)
            sound[first : first + len(voice)] += voice
            self.teacher.said += 1
        self.teacher.heard += [("(cues)", "", 0.0)]
        waiting = next(samples, None)
        for at, frame in enumerate(frames_in([Sound(self.teacher.in_room(sound))])):
            while waiting is not None and waiting.t_s <= at * FRAME_S:
                self.session.see(replace(waiting, said=""))
                waiting = next(samples, None)
            yield frame
        while waiting is not None:
            self.session.see(replace(waiting, said=""))
            waiting = next(samples, None)


def table(view: dict[str, Any]) -> list[tuple[str, float, float]]:
    """Return setup, distance and angle of every run."""
    return [
        (run["setup"], one["distance_mm"], one["angle_deg"])
        for run in view["runs"]
        for one in run["alignments"]
    ]


def compare(typed: dict[str, Any], heard: dict[str, Any]) -> str:
    """Return how the lesson by ear differs from the typed one."""
    tree = typed["task"]["tree"] == heard["task"]["tree"]
    if not typed["lesson"] or not heard["lesson"]:
        return f"tree {'same' if tree else 'DIFFERS'}, no lesson"
    cuts, told = typed["lesson"]["cuts_s"], heard["lesson"]["cuts_s"]
    apart = (
        f"cuts within {max(abs(a - b) for a, b in zip(cuts, told, strict=True)):.2f} s"
        if len(cuts) == len(told)
        else f"{len(told)} cuts, not {len(cuts)}"
    )
    rows = ", ".join(f"{name} {mm:.3f} mm {deg:.3f} deg" for name, mm, deg in table(heard))
    return f"tree {'same' if tree else 'DIFFERS'}, {apart}; {rows}; agreed {heard['agreed']}"


def main() -> None:
    """Hold the lesson typed, then by ear with each teacher."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("speakers", nargs="*", help="names; all that nothing was tuned on")
    parser.add_argument("--noise", type=float, metavar="DB", help="kitchen noise so far below")
    parser.add_argument("--arm", default="kinematic")
    parser.add_argument("--show", action="store_true")
    parser.add_argument("--clips", type=Path, help="folder in which made speech is kept")
    args = parser.parse_args()
    play = replace(read_transcript(shipped("transcripts") / "pick_and_place.yaml"), arm=args.arm)
    with tempfile.TemporaryDirectory() as kept:
        folder = Path(kept)
        typed = Lesson(play, folder / "typed", None).hold(None)
        print(f"typed: {compare(typed, typed)}", flush=True)
        hearing = Hearing(installed())
        for speaker in REPORTED:
            if args.speakers and speaker.name not in args.speakers:
                continue
            timed = Timed(hearing)
            rng = np.random.default_rng(7)
            teacher = Teacher(speaker, args.noise, args.clips or folder, rng)
            lesson = Lesson(play, folder / speaker.name.replace(" ", "_"), teacher)
            view = lesson.hold(timed)
            if args.show:
                for said, heard, sure in teacher.heard:
                    print(f"  {said!r}: heard {heard!r} ({sure:.2f})")
                print(f"  cues {lesson.cues}")
            print(
                f"{speaker.name}, noise {args.noise}: {compare(typed, view)}; {teacher.said} lines "
                f"said, {teacher.repeated} repeated, {teacher.typed} typed, "
                f"{statistics.median(timed.took_s):.2f} s to understand (median)",
                flush=True,
            )


if __name__ == "__main__":
    main()
