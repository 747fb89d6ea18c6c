"""The session: words and samples become events, the dialogue steps, its effects are done.

Every event and every robot line is in the journal before anything is done about it. Stopping
goes beside all of this: raw input that holds a stop word while the arm moves sets the flag
that the arm's tick reads, whatever the loop is busy with.
"""

from __future__ import annotations

from collections import deque
from collections.abc import Callable, Mapping
from pathlib import Path
from typing import Any

from assistant.dialogue import effects as wanted
from assistant.dialogue import events
from assistant.dialogue.machine import begin, listening, public_view, step
from assistant.errors import BadInput
from assistant.files.library import Library
from assistant.language.speech import phrase
from assistant.language.stopping import has_stop_word
from assistant.model.listening import Listening, Understanding
from assistant.model.robot_acts import RobotAct
from assistant.model.scene import Scene
from assistant.model.setup import Setup
from assistant.model.task import Task
from assistant.model.transcript import Note
from assistant.ports import Hand, HandSample
from assistant.session import halting
from assistant.session.doing import Workplace, do
from assistant.session.equipment import Equipment
from assistant.session.happenings import Store, to_step
from assistant.session.journal import Journal
from assistant.session.meaning import meant, printable
from assistant.session.motion import Mover
from assistant.session.saying import as_step, not_kept
from assistant.session.watching import Watching

Out = Callable[[RobotAct, str], None]
"""Takes a robot line and the sentence made from it."""


class Session:
    """One conversation with one arm.

    Parameters
    ----------
    equipment : Equipment
    journal : Journal
        Already created or resumed.
    out : callable
        See `Out`.
    library : Library
        Kept tasks.
    language : str
        Which phrasebook.
    fed : bool
        Results come from a journal: nothing is computed or moved.
    """

    def __init__(
        self,
        equipment: Equipment,
        journal: Journal,
        out: Out,
        library: Library,
        language: str = "english",
        *,
        fed: bool = False,
    ) -> None:
        self.workplace = Workplace(equipment, library, Store(journal.folder))
        self.workplace.tell = self.tell
        self.journal = journal
        self.out = out
        self.language = language
        self.fed = fed
        self.dialogue = begin(language)
        self.watching: Watching | None = None
        self.recordings = 0
        self.left = False
        # Whether who could stop the arm still can: a shell beside it puts its heartbeat here.
        self.in_touch: Callable[[], bool] = lambda: True
        self._events: deque[events.Event] = deque()
        self._busy = self._trouble_told = False

    @property
    def equipment(self) -> Equipment:
        """The outside of the session."""
        return self.workplace.equipment

    @property
    def mover(self) -> Mover:
        """What leads the arm."""
        return self.workplace.mover

    @property
    def moving(self) -> bool:
        """Whether the arm moves."""
        return self.mover.moving

    @property
    def listening(self) -> Listening:
        """What the understanding of the next words depends on."""
        return listening(self.dialogue)

    @property
    def dialogue_view(self) -> Mapping[str, Any]:
        """Plain values of the dialogue, for status lines; safe to read while the arm ticks."""
        return public_view(self.dialogue)

    def begin(
        self, scene: Scene, setup: Setup, task: Task | None, path: Path | None = None
    ) -> None:
        """Open the conversation, with the task of a file to go on with if one is given."""
        self.tell_trouble()
        self.mover.arrange(scene, setup)
        library = self.workplace.library
        saved_as = "" if path is None else library.name_of(path)
        self.happen(events.Begun(scene, setup, task, library.names(), saved_as))

    def close(self) -> None:
        """Give the journal free."""
        self.journal.close()

    # What the teacher does.

    def raw(self, text: str) -> bool:
        """Stop what is under way if input says so, and return whether; safe from any thread."""
        if stops := (self.moving or self._busy) and has_stop_word(text, self.language):
            self.equipment.stop_flag.set()
        return stops

    def understood(self, text: str, sure: float = 1.0) -> Understanding:
        """Return what words mean here and now."""
        return meant(self.dialogue, text, sure, self.language)

    def hear(
        self, text: str, *, by_voice: bool = False, sure: float = 1.0, ago_s: float = 0.0
    ) -> None:
        """Take an utterance.

        Parameters
        ----------
        text : str
        by_voice : bool
        sure : float
            How surely the words were recognized.
        ago_s : float
            How long ago the first word began.
        """
        self.raw(text := printable(text))
        if not self.moving or (self.mover.braking and not has_stop_word(text, self.language)):
            self.equipment.stop_flag.clear()
        self.happen(events.Heard(text, self.understood(text, sure), by_voice, sure, ago_s))

    def halt(self, why: str) -> None:
        """Stop the arm for a reason outside the conversation; see `halting`."""
        self.equipment.stop_flag.set()
        if self.moving:
            self.mover.halt(why)
            self.happen(events.Halted(why))

    def arrange(self, scene: Scene, setup: Setup) -> None:
        """Put things where the teacher says, once the arm stands."""
        self.halt(halting.REARRANGED)
        self.rest()
        self.mover.arrange(scene, setup)
        self.happen(events.Arranged(setup, scene))

    def watch(self, hand: Hand) -> None:
        """Watch a hand until it has shown everything, or the teacher ends the demonstration."""
        for sample in hand.samples():
            if self.watching is None:
                return
            self.see(sample)

    def see(self, sample: HandSample) -> None:
        """Take one sample of the teacher's hand, and what is said with it."""
        if self.watching is not None:
            self.watching.see(sample)
        if sample.said:
            self.hear(sample.said)

    # What the dialogue wants of the demonstration.

    def record(self) -> None:
        """Begin to watch, from the start."""
        self.recordings += 1
        path = self.journal.folder / f"recording_{self.recordings}.csv"
        self.watching = Watching(None if self.journal.trouble else path)

    def end_recording(self, *, keep: bool) -> None:
        """Take the demonstration as it is, or drop it."""
        watched, self.watching = self.watching, None
        if watched is not None and keep:
            self.happen(watched.shown(self.mover.setup))

    # Time.

    def tick(self) -> None:
        """Let one control period pass; the arm stops if nobody could stop it any more."""
        stopping = self.equipment.stop_flag.is_set()
        if self.moving and not stopping and not self.in_touch():
            self.halt(halting.HEARTBEAT)
        for report in self.mover.tick():
            self.happen(events.ArmReported(report))

    def pass_s(self, seconds: float) -> None:
        """Let simulated time pass."""
        passed_s = 0.0
        while self.moving and passed_s < seconds:
            before_s = self.mover.now_s
            self.tick()
            # Arranging a setup sets the arm's time back.
            passed_s += max(self.mover.now_s - before_s, 0.0)

    def run_until(self, at_s: float) -> None:
        """Let time pass until so long after the motion began."""
        while self.moving and self.mover.run_s < at_s:
            self.tick()

    def rest(self) -> None:
        """Let simulated time pass until the arm rests."""
        while self.moving:
            self.tick()

    # The loop itself.

    def happen(self, event: events.Event) -> None:
        """Journal an event, let the dialogue answer it, and do what it wants done."""
        self._events.append(event)
        if self._busy:
            return
        self._busy = True
        try:
            while self._events:
                self._step(self._events.popleft())
        finally:
            self._busy = False

    def _step(self, event: events.Event) -> None:
        said_s = None if self.watching is None else self.watching.said_s(event)
        self._write(event, said_s)
        if self.watching is not None and isinstance(event, events.Heard):
            self.watching.hear(event.text, event.understanding, said_s)
        self.dialogue, effects = step(self.dialogue, event)
        for effect in (*effects, *self.mover.released(event)):
            self.do(effect)
        self.tell_trouble()

    def do(self, effect: wanted.Effect) -> None:
        """Carry out one effect; where results are fed back, only what is said."""
        match effect:
            case wanted.Say():
                self.say(effect.line)
            case wanted.Leave():
                self.left = True
            case _ if self.fed:
                return
            case wanted.Record():
                self.record()
            case wanted.EndRecording():
                self.end_recording(keep=effect.keep)
            case _:
                result = do(self.workplace, self.dialogue, effect)
                if result is not None:
                    self.happen(result)

    def say(self, line: RobotAct) -> None:
        """Journal a robot line, then say it."""
        text = self.phrased(line)
        self.journal.write(as_step(line, text))
        self.out(line, text)

    def tell(self, line: RobotAct) -> None:
        """Say what belongs to the session and not to the conversation: journaled as a remark."""
        text = self.phrased(line)
        self.journal.write(Note(text))
        self.out(line, text)

    def tell_trouble(self) -> None:
        """Say once that the session cannot be written down, as soon as that is so."""
        if self.journal.trouble and not self._trouble_told:
            self._trouble_told = True
            self.out(line := not_kept(self.journal.trouble), self.phrased(line))

    def phrased(self, line: RobotAct) -> str:
        """Return the sentence for a line."""
        return phrase(line, self.language, brief=self.dialogue.brief)

    def _write(self, event: events.Event, said_s: float | None) -> None:
        if self.journal.trouble:
            return
        try:
            made = to_step(event, self.workplace.store, said_s)
        except (OSError, BadInput) as error:
            self.journal.fail(error)
            return
        if made is not None:
            self.journal.write(made)
