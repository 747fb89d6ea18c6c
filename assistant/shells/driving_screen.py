"""What is on the screen while the hand is driven: keys, pictures, the plan's step, the ways."""

from __future__ import annotations

import shutil
from collections.abc import Callable, Mapping
from dataclasses import replace
from typing import Any

import numpy as np
from prompt_toolkit.formatted_text import StyleAndTextTuples
from prompt_toolkit.mouse_events import MouseEvent, MouseEventType

from assistant.dialogue.one_step import ended_at
from assistant.geometry import compose
from assistant.language.speech import in_words
from assistant.ports import ArmLook
from assistant.session.equipment import DrivenHand
from assistant.session.loop import Session
from assistant.shells.driving_picture import Sight, around_mm, drawn, marks, seen_mm, sights
from assistant.shells.driving_view import (
    above_table,
    end_gap,
    gap_line,
    gaps,
    in_the_way,
    low_line,
    points_down,
    step_line,
    unplaced,
    way_line,
)
from assistant.shells.grip_view import Closings, Missed, left_over, missed_line, taken, width_mm
from assistant.shells.gripping import CHARACTERS, Area
from assistant.shells.wrapping import columns, wrapped

QUIET, STRONG, STATE, WARNING = "ansibrightblack", "bold", "ansimagenta", "bold ansired"
"""Each can be read on white and on black."""
INDENT, APART = 1, 3
NARROW, WIDE, LOW, HIGH, FEWEST = 12, 24, 7, 15, 4
"""Bounds of a picture's columns and rows, wanted and at the least; smaller ones show nothing."""
Lines = list[StyleAndTextTuples]


class Screen:
    """Draws the view.

    Parameters
    ----------
    session : Session
        Watching.
    hand : DrivenHand
    words : mapping
        Of driving, from the phrasebook's page for the terminal.
    press : callable
        Takes a key that was clicked.
    """

    def __init__(
        self,
        session: Session,
        hand: DrivenHand,
        words: Mapping[str, Any],
        press: Callable[[str], None],
    ) -> None:
        self._session, self._hand, self._words = session, hand, words
        self._press = press
        self.facing = session.dialogue_view.get("facing") == "facing"
        self.areas: tuple[Area, ...] = ()
        self._size, self._rest = (0, 0), 0
        self._sights: tuple[Sight, ...] = ()
        step = str(session.dialogue_view["step_shown"])
        self._closings = Closings()
        self._end = ended_at(session.dialogue.known, step) if step else None

    def _fitted(self, look: ArmLook, rest: int) -> None:
        """Choose the pictures anew where the terminal was resized, or the rest needs more room.

        What a teacher needs most, the ways and what happens, is never cut off below.
        """
        wide, high = shutil.get_terminal_size()
        size = (wide, high)
        if size == self._size and rest <= self._rest:
            return
        self._rest = rest if size != self._size else max(rest, self._rest)
        self._size = size
        rows = min(high - self._rest - 2, HIGH)
        across = (columns() - 1 - INDENT - APART) // (2 * CHARACTERS)
        fits = rows >= FEWEST and across >= NARROW
        self._sights = self._chosen(look, rows, min(across, WIDE)) if fits else ()

    def _chosen(self, look: ArmLook, rows: int, across: int) -> tuple[Sight, Sight]:
        scene, tip = self._session.mover.scene, self._hand.tip
        bodies = [(look.bodies[n], b) for n, b in scene.bodies.items() if n in look.bodies]
        goals = [compose(compose(pose, body.hand_in_body), tip) for pose, body in bodies]
        goals += [] if self._end is None else [compose(self._end, tip)]
        here = compose(look.hand, tip)
        placed = all(one.name in look.bodies for one in self._session.dialogue.known.objects or ())
        seen = seen_mm(look, [here, *goals], scene)
        if not placed:
            # What is to be met somewhere is met on the table, to either side.
            seen = np.concatenate([seen, around_mm(here, above_table(look, scene, tip))])
        return sights(seen, rows, across, facing=self.facing)

    def fragments(self, told: str, *, dragging: bool) -> StyleAndTextTuples:
        """Return the whole view.

        Parameters
        ----------
        told : str
            What the last key did.
        dragging : bool
            Whether the mouse holds the hand.
        """
        look = self._session.mover.look
        watching = self._session.watching
        samples = watching.samples if watching is not None else []
        self._closings.see(look, samples, returning=self._hand.state.returning)
        below = [*self._ways(look), *self._state(look, told), *self._warning(dragging=dragging)]
        lines = self._keys()
        if len(lines) + len(below) + LOW + 2 > shutil.get_terminal_size().lines:
            lines = self._few_keys()
        self._fitted(look, len(lines) + len(below))
        first = len(lines) + 1
        self.areas = tuple(
            Area(sight, first, INDENT + k * (CHARACTERS * sight.columns + APART))
            for k, sight in enumerate(self._sights)
        )
        lines += [*self._pictures(look), *below]
        return [part for line in lines for part in (*line, ("", "\n"))][:-1]

    def _keys(self) -> Lines:
        """Return the keys with what they do, in rows; each can be clicked."""
        words = self._words
        lines: Lines = []
        for row, keys in words["rows"].items():
            lines += self._row(str(words["headings"][row]), keys.split())
        heading = self._heading(str(words["headings"]["mouse"]))[1]
        mouse = wrapped(f"{words['mouse']} {words['arrows']}", columns(), before=f"{heading}  ")
        lines += [[(QUIET, line)] for line in mouse]
        return lines

    def _few_keys(self) -> Lines:
        """Return the keys in short, for a terminal too small for all that they do."""
        told = wrapped(str(self._words["few_keys"]), columns(), before=" ")
        return [[(QUIET, line)] for line in told]

    def _heading(self, text: str) -> tuple[str, str]:
        wide = max(len(str(one)) for one in self._words["headings"].values())
        return QUIET, f" {text:{wide}}"

    def _row(self, heading: str, keys: list[str]) -> Lines:
        lines: Lines = [[self._heading(heading)]]
        used = begin = len(lines[0][0][1])
        for key in keys:
            does = str(self._words["keys"][key])
            shown = str(self._words["key_names"].get(key, key))
            size = len(shown) + len(does) + 4
            if used + size >= columns():
                lines.append([("", " " * begin)])
                used = begin
            used += size
            lines[-1] += [
                (STRONG, f"  {shown}", self._click(key)),
                (QUIET, f" {does}", self._click(key)),
            ]
        return lines

    def _click(self, key: str) -> Callable[[MouseEvent], None]:
        def clicked(event: MouseEvent) -> None:
            if event.event_type is MouseEventType.MOUSE_UP:
                self._press(key)

        return clicked

    def _pictures(self, look: ArmLook) -> Lines:
        if not self._sights:
            return []
        scene, tip = self._session.mover.scene, self._hand.tip
        language = self._session.language
        left, right = (drawn(sight, look, scene, tip, language) for sight in self._sights)
        wide = CHARACTERS * self._sights[0].columns
        pad, gap = " " * INDENT, " " * APART
        titles = f"{self._words['above']:{wide}}{gap}{self._words['side']}"
        lines: Lines = [[(QUIET, pad + titles)]]
        for one, other in zip(left, right, strict=True):
            lines.append([("", f"{pad}{one:{wide}}{gap}{other:{wide}}")])
        return lines

    def _ways(self, look: ArmLook) -> Lines:
        scene, words = self._session.mover.scene, self._words
        letters = marks(scene.bodies, self._session.language)
        told: list[str] = []
        for gap in gaps(look, scene, self._hand.tip):
            told_of = replace(gap, name=in_words(gap.name, self._session.language))
            way = gap_line(told_of, words, facing=self.facing, holding=bool(look.held))
            told += wrapped(way, columns(), before=f" {letters[gap.name]} ")
        told += self._lost(look)
        if self._end is not None:
            end = end_gap(look, self._end, self._hand.tip)
            ended = gap_line(end, words, facing=self.facing, holding=bool(look.held))
            told += wrapped(ended, columns(), before="   ")
        return [[("", line)] for line in told]

    def _lost(self, look: ArmLook) -> list[str]:
        """Return what to do about things whose places nobody told, and where the hand is."""
        words, tip = self._words, self._hand.tip
        first = self._closings.first
        objects = self._session.dialogue.known.objects or ()
        told = list(unplaced(objects, look, words, closed=first is not None))
        low = self._hand.state.lowest
        if low is not None and any(one.name not in look.bodies for one in objects):
            told.append(low_line(low, look, tip, words))
            if first is not None:
                back = end_gap(look, first, tip)
                told.append(way_line(str(words["to_closed"]), back, words, facing=self.facing))
        return [line for one in told if one for line in wrapped(one, columns(), before="   ")]

    def _state(self, look: ArmLook, told: str) -> Lines:
        session, words = self._session, self._words
        watching = session.watching
        cues = [cue.say for cue in watching.cues] if watching is not None else []
        shown_s = watching.now_s if watching is not None else 0.0
        state = (
            *self._gripped(look),
            self._step(),
            str(words["shown"]).format(seconds=in_words(round(shown_s, 1), session.language)),
            told,
        )
        step = step_line(session.dialogue_view, cues, words)
        lines = [(STRONG, line) for line in wrapped(step, columns(), before=" ")] if step else []
        doing = wrapped("   ".join(filter(None, state)), columns(), before=" ")
        return [[one] for one in (*lines, *((STATE, line) for line in doing))]

    def _gripped(self, look: ArmLook) -> tuple[str, str]:
        """Return how far the hand is open, and what it holds, as far as anybody can know."""
        words, known = self._words, self._session.dialogue.known
        held, mm = self.taken(look), 1000.0 * look.gripper_m
        name = held if isinstance(held, str) else ""
        if name and not look.held:
            # On an empty table nothing keeps the fingers apart but what the teacher told.
            mm = width_mm(known, name) or mm
        told = str(words["holding"]).format(name=in_words(name, self._session.language))
        return str(words["hand"]).format(mm=round(mm)), told if name else ""

    def taken(self, look: ArmLook) -> str | Missed:
        """Return what the hand holds, or missed where it closed."""
        there = look if self._closings.last is None else replace(look, hand=self._closings.last)
        return taken(self._session.dialogue.known, there, self._session.mover.scene, self._hand.tip)

    def unfinished(self) -> str:
        """Return what seems to be missing before the demonstration ends: what is held, or not."""
        held = self.taken(self._session.mover.look)
        known, language = self._session.dialogue.known, self._session.language
        return left_over(held, known, self._words, language)

    def _step(self) -> str:
        """Return how large a step is now."""
        now = self._hand.state
        told = (
            in_words(round(one, 1), self._session.language) for one in (now.step_mm, now.step_deg)
        )
        mm, deg = told
        return str(self._words["size"]).format(mm=mm, deg=deg)

    def _warning(self, *, dragging: bool) -> Lines:
        state, words = self._hand.state, self._words
        warning = str(words["dragging"]) if dragging else ""
        if state.gave_way_mm:
            warning = str(words["gave_way"])
        if state.returning:
            warning = str(words["returning"])
        if state.clutched:
            warning = str(words["clutched"])
        look, language = self._session.mover.look, self._session.language
        held = self.taken(look)
        if isinstance(held, Missed):
            warning = missed_line(held, words, language)
        if state.blocked is not None:
            warning = in_the_way(
                state.blocked,
                words,
                language,
                look.held,
                facing=self.facing,
                touching=state.touching,
                down=points_down(look),
            )
        return [[(WARNING, line)] for line in wrapped(warning, columns(), before=" ")]
