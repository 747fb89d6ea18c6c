"""What every state uses: making lines, remembering changes, saying and asking again."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass, replace
from types import MappingProxyType
from typing import Any

from assistant.dialogue.effects import Effect, Say
from assistant.dialogue.knowledge import Knowledge
from assistant.dialogue.sketch import Sketch, walk
from assistant.dialogue.state import Change, Dialogue, Other, Reviewing
from assistant.model.conditions import Condition
from assistant.model.robot_acts import About, RobotAct, RobotActName
from assistant.model.setup import Place
from assistant.model.task import Action, Index
from assistant.model.teacher_acts import (
    Again,
    Asked,
    NewSetup,
    Quit,
    Resume,
    Start,
    TeacherAct,
)

Turn = tuple[Dialogue, tuple[Effect, ...]]


@dataclass(frozen=True, slots=True)
class Words:
    """How something was said.

    Parameters
    ----------
    text : str
    by_voice : bool
    sure : bool
        The teacher has confirmed it.
    """

    text: str
    by_voice: bool = False
    sure: bool = False


_LAST = (NewSetup, Start, Resume, Again, Quit)
"""What begins motion, or ends the session."""
ASIDE = ("setup", "facing")
"""Changes of knowledge that leave the task as it was."""


def line(
    act: RobotActName,
    topic: str,
    *,
    asked: Asked | None = None,
    about: About | None = None,
    **slots: Any,
) -> RobotAct:
    """Return a line of the robot; slots hold plain values only."""
    return RobotAct(act, topic, asked, about, MappingProxyType(slots))


def say(dialogue: Dialogue, *lines: RobotAct) -> Turn:
    """Return the dialogue unchanged, with something said."""
    return dialogue, tuple(Say(one) for one in lines)


def then(turn: Turn, *effects: Effect) -> Turn:
    """Return the turn with more effects after its own."""
    return turn[0], (*turn[1], *effects)


def first(effects: Iterable[Effect], turn: Turn) -> Turn:
    """Return the turn with effects before its own."""
    return turn[0], (*effects, *turn[1])


def snapshot(dialogue: Dialogue, label: str) -> Change:
    """Return what is known now and what learning asks now, to go back to."""
    state = dialogue.state
    return Change(dialogue.known, label, state.questions if isinstance(state, Reviewing) else ())


def changed(
    dialogue: Dialogue, label: str, known: Knowledge, *, clean: tuple[Any, ...] = ()
) -> Dialogue:
    """Return the dialogue with new knowledge that can be undone.

    Parameters
    ----------
    label : str
        Which change, for "I took back ..."; ``says.changes.<label>``.
    clean : tuple of RunResult
        Runs that still count toward agreement; none after a change of the task.
    """
    if known == dialogue.known:
        return dialogue
    past = (*dialogue.past, snapshot(dialogue, label))
    after = replace(dialogue, known=known, past=past, future=(), clean=clean)
    # Where things are and where the teacher stands is no part of a saved task.
    return after if label in ASIDE else replace(after, unsaved=True, agreed=False)


def in_order(meant: Iterable[TeacherAct]) -> tuple[TeacherAct, ...]:
    """Return the acts with those that start motion, or end the session, at the end."""
    return tuple(sorted(meant, key=lambda act: isinstance(act, _LAST)))


def one_question(turn: Turn) -> Turn:
    """Return the turn with only its last question; several would not be heard."""
    asks = [at for at, effect in enumerate(turn[1]) if _is_question(effect)]
    kept = [effect for at, effect in enumerate(turn[1]) if at not in asks[:-1]]
    return turn[0], tuple(kept)


def _is_question(effect: Effect) -> bool:
    return isinstance(effect, Say) and effect.line.act in ("ask", "confirm")


def in_full(said: RobotAct) -> RobotAct:
    """Return a line as it is said the first time."""
    slots = {name: value for name, value in said.slots.items() if name != "again"}
    return replace(said, slots=MappingProxyType({**slots, "again": False}))


def with_other(
    before: Dialogue,
    after: Dialogue,
    other: tuple[TeacherAct, ...],
    words: Words,
    done: TeacherAct | None = None,
) -> Dialogue:
    """Return the dialogue with what would be done with the other candidate kept in mind."""
    return replace(after, other=Other(other, words.text, len(before.past), done))


def about(known: Knowledge, index: Index) -> About:
    """Return whom a line concerns: the node at a position."""
    node = node_or_blank(known.root, index)
    return About(node.name or (known.name if not index else ""), index)


def node_or_blank(root: Sketch, index: Index) -> Sketch:
    """Return the node at a position, or an empty one where the tree ends before."""
    return next((node for place, node in walk(root) if place == index), Sketch())


def plain_action(action: Action) -> dict[str, str]:
    """Return an action as files write it: ``{"move": "up", "object": "block"}``."""
    told = {action.verb: action.way}
    return told | ({"object": action.object} if action.object else {})


def plain_condition(condition: Condition) -> dict[str, Any]:
    """Return a condition as files write it: ``{"held": "block"}``."""
    if condition.target:
        return {condition.kind: {"object": condition.object, "target": condition.target}}
    return {condition.kind: condition.object}


def plain_place(place: Place) -> dict[str, Any]:
    """Return a place in mm and degrees, and of what it is."""
    return {"of": place.kind, "xyz_mm": list(place.xyz_mm), "rpy_deg": list(place.rpy_deg)}


def plain_tree(node: Sketch) -> dict[str, Any]:
    """Return a node and all below as plain values."""
    told: dict[str, Any] = {"name": node.name}
    if node.goal:
        told["goal"] = node.goal
    if node.action is not None:
        told["action"] = plain_action(node.action)
    if node.order == "any":
        told["order"] = "any"
    if node.optional:
        told["optional"] = True
    if node.parts:
        told["parts"] = [plain_tree(part) for part in node.parts]
    return told
