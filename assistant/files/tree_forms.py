"""The task tree as forms: subtasks, primitives, actions and conditions of task/1."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Annotated, Any, Literal

from pydantic import ConfigDict, Discriminator, Field, Tag, model_validator

from assistant.files.forms import Form, Name, Text, Truth, exactly_one
from assistant.model.conditions import CONDITIONS, Condition
from assistant.model.task import Action, Order, Primitive, Role, Subtask, TaskObject, Verb

Move = Literal["approach", "depart", "to", "up", "down", "left", "right", "forward", "backward"]
Turn = Literal[
    "left", "right", "up", "down", "forward", "backward", "clockwise", "counterclockwise"
]
_VERBS: tuple[Verb, ...] = ("move", "turn", "hand", "free")


class ActionForm(Form):
    """What a primitive does: one of move, turn, hand and free, and with which object."""

    model_config = exactly_one(*_VERBS)
    move: Move | None = None
    turn: Turn | None = None
    hand: Literal["open", "close"] | None = None
    free: Text | None = Field(None, description="a motion the robot has no word for")
    object: Name | None = None

    @model_validator(mode="after")
    def _one_verb(self) -> ActionForm:
        if sum(getattr(self, verb) is not None for verb in _VERBS) != 1:
            raise ValueError(
                "an action of none or several kinds; exactly one of move, turn, hand and free"
            )
        return self

    def action(self) -> Action:
        """Return the action told."""
        verb = next(verb for verb in _VERBS if getattr(self, verb) is not None)
        return Action(verb, getattr(self, verb), self.object)


class PairForm(Form):
    """An object and a target."""

    object: Name | None
    target: Name | None


class ConditionForm(Form):
    """A state, told by exactly one key."""

    model_config = ConfigDict(json_schema_extra={"minProperties": 1, "maxProperties": 1})
    hand: Literal["open", "closed"] | None = None
    docked: Name | None = None
    held: Name | None = None
    on: PairForm | None = None
    aligned: PairForm | None = None
    above: PairForm | None = None
    clear: Name | None = None

    @model_validator(mode="after")
    def _one_state(self) -> ConditionForm:
        if len(self.model_fields_set) != 1:
            listed = ", ".join(type(self).model_fields)
            raise ValueError(f"a condition of none or several kinds; exactly one of {listed}")
        return self

    def condition(self) -> Condition:
        """Return the condition told."""
        kind = next(each for each in CONDITIONS if each in self.model_fields_set)
        value = getattr(self, kind)
        if isinstance(value, PairForm):
            return Condition(kind, value.object, value.target)
        return Condition(kind, value)


class PrimitiveForm(Form):
    """A leaf of the tree."""

    primitive: Name
    action: ActionForm
    before: tuple[ConditionForm, ...] = ()
    until: tuple[ConditionForm, ...] = ()
    optional: Truth = False

    def node(self) -> Primitive:
        """Return the primitive told."""
        return Primitive(
            name=self.primitive,
            action=self.action.action(),
            before=conditions_of(self.before),
            until=conditions_of(self.until),
            optional=self.optional,
        )


class SubtaskForm(Form):
    """An inner node of the tree."""

    subtask: Name
    goal: Text = ""
    order: Order = "sequential"
    optional: Truth = False
    parts: tuple[PartForm, ...] = ()

    def node(self) -> Subtask:
        """Return the subtask told, with all below it."""
        parts = tuple(part.node() for part in self.parts)
        return Subtask(self.subtask, parts, self.goal, self.order, self.optional)


def _kind(part: Any) -> str | None:
    if not isinstance(part, Mapping):
        return None
    return "a primitive" if "primitive" in part else "a subtask"


PartForm = Annotated[
    Annotated[SubtaskForm, Tag("a subtask")] | Annotated[PrimitiveForm, Tag("a primitive")],
    Discriminator(
        _kind,
        custom_error_type="part",
        custom_error_message="this is no part; a mapping with the key primitive or subtask",
    ),
]


class ObjectForm(Form):
    """A body the task is about: carried (object), or a place for one (target)."""

    role: Role


def conditions_of(forms: Sequence[ConditionForm]) -> tuple[Condition, ...]:
    """Return the conditions told."""
    return tuple(form.condition() for form in forms)


def objects_of(forms: Mapping[str, ObjectForm]) -> tuple[TaskObject, ...]:
    """Return the objects told."""
    return tuple(TaskObject(name, form.role) for name, form in forms.items())


def node_values(node: Subtask | Primitive) -> dict[str, Any]:
    """Return a node and all below it as plain values."""
    values: dict[str, Any]
    if isinstance(node, Primitive):
        values = {"primitive": node.name, "action": _action_values(node.action)}
        if node.before:
            values["before"] = conditions_values(node.before)
        if node.until:
            values["until"] = conditions_values(node.until)
        return {**values, "optional": True} if node.optional else values
    values = {"subtask": node.name}
    if node.goal:
        values["goal"] = node.goal
    values["order"] = node.order
    if node.optional:
        values["optional"] = True
    return {**values, "parts": [node_values(part) for part in node.parts]}


def _action_values(action: Action) -> dict[str, Any]:
    values: dict[str, Any] = {action.verb: action.way}
    return values if action.object is None else {**values, "object": action.object}


def conditions_values(conditions: Sequence[Condition]) -> list[dict[str, Any]]:
    """Return conditions as plain values."""
    return [_condition_values(each) for each in conditions]


def _condition_values(condition: Condition) -> dict[str, Any]:
    if condition.kind in ("on", "aligned", "above"):
        return {condition.kind: {"object": condition.object, "target": condition.target}}
    return {condition.kind: condition.object}
