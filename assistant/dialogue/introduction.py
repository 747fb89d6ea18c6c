"""The robot asks what the task is, but only what it does not know yet (paper II-A).

`need` is a function of knowledge alone, so that undo, corrections and answers to several
questions at once all lead to the right next question.
"""

from __future__ import annotations

from dataclasses import replace

from assistant.dialogue.bodies import fitted, plain_size
from assistant.dialogue.knowledge import Knowledge
from assistant.dialogue.sketch import Sketch, at, put, walk
from assistant.dialogue.state import Introducing
from assistant.dialogue.things import thing_names
from assistant.dialogue.turn import about, line, plain_tree
from assistant.language.actions import mentioned_objects, read_action
from assistant.model.robot_acts import RobotAct
from assistant.model.task import Action, Index, TaskObject

MOST_PARTS = 30
"""More parts of one node than this are taken for a mishearing."""

_NEEDS_OBJECT = {("move", "approach"), ("move", "depart"), ("move", "to"), ("hand", "close")}


def need(known: Knowledge) -> Introducing | None:
    """Return the next open question, or None if the task is introduced and confirmed."""
    if not known.name:
        return Introducing("task_name")
    if known.goal is None:
        return Introducing("goal")
    if known.objects is None:
        return Introducing("objects")
    open_question = _about_things(known) or _about_nodes(known)
    if open_question is None and not known.tree_confirmed:
        return Introducing("confirm_tree")
    return open_question


def _about_things(known: Knowledge) -> Introducing | None:
    for thing in known.objects or ():
        if thing.name not in known.scene.bodies:
            return Introducing("body", thing=thing.name)
        if thing.name not in known.setup.places and thing.name not in known.unplaced:
            return Introducing("pose", thing=thing.name)
    return None


def _about_nodes(known: Knowledge) -> Introducing | None:
    return _below(known, (), known.root)


def _below(known: Knowledge, index: Index, node: Sketch) -> Introducing | None:
    if node.single is None:
        return Introducing("subtask_count", index)
    if node.single:
        return _about_motion(known, index, node)
    for position, part in enumerate(node.parts, start=1):
        if not part.name:
            return Introducing("subtask_name", (*index, position))
    for position, part in enumerate(node.parts, start=1):
        found = _below(known, (*index, position), part)
        if found is not None:
            return found
    return None


def _about_motion(known: Knowledge, index: Index, node: Sketch) -> Introducing | None:
    if node.action is None:
        return Introducing("actions", index)
    wants = (node.action.verb, node.action.way) in _NEEDS_OBJECT and known.objects
    if wants and node.action.object is None:
        return Introducing("objects", index)
    return None


def question(known: Knowledge, state: Introducing) -> RobotAct:
    """Return what the robot asks in this state."""
    node = about(known, state.index)
    match state.asked:
        case "subtask_count" if state.named:
            return line(
                "ask",
                "count_contradicted",
                asked="subtask_count",
                about=node,
                said=state.said,
                count=len(state.named),
                names=list(state.named),
            )
        case "which":
            return line("ask", "which_extra", asked="which", about=node, names=list(state.named))
        case "subtask_name":
            return _ask_name(known, state.index)
        case "objects" if state.index:
            return line("ask", "objects_of", asked="objects", about=node, name=node.name)
        case "objects":
            things = thing_names(known.scene, known.setup)
            return line(
                "ask", "objects", asked="objects", about=node, name=node.name, things=things
            )
        case "body":
            return line("ask", "body", asked="body", about=node, thing=state.thing)
        case "pose":
            size = plain_size(known, state.thing) if state.thing in known.shaped else None
            return line("ask", "pose", asked="pose", about=node, thing=state.thing, size=size)
        case "confirm_tree":
            return line("confirm", "tree", asked="confirm_tree", about=node, **_read_back(known))
        case "subtask_count" if state.index:
            return line("ask", "count_of", asked="subtask_count", about=node, name=node.name)
        case _:
            return line("ask", state.asked, asked=state.asked, about=node, name=node.name)


def _ask_name(known: Knowledge, index: Index) -> RobotAct:
    parent = at(known.root, index[:-1])
    name = parent.name or known.name
    count = len(parent.parts)
    topic = "subtask_name" if count > 1 else "only_subtask_name"
    node = about(known, index)
    return line(
        "ask", topic, asked="subtask_name", about=node, which=index[-1], count=count, parent=name
    )


def _read_back(known: Knowledge) -> dict[str, object]:
    objects = [{"name": one.name, "role": one.role} for one in known.objects or ()]
    return {
        "tree": plain_tree(replace(known.root, name=known.name)),
        "goal": known.goal or "",
        "objects": objects,
        "sizes": _sizes(known) or None,
    }


def _sizes(known: Knowledge) -> dict[str, list[float]]:
    """Return how big the things of the task are taken to be that the teacher told of, in cm."""
    bodies = known.scene.bodies
    told = [one.name for one in known.objects or () if one.name in known.shaped]
    return {name: [round(side / 10.0, 1) for side in bodies[name].size_mm] for name in told}


def understood(known: Knowledge, index: Index) -> Knowledge:
    """Return what is known after taking from a node's name the action it plainly tells."""
    node = at(known.root, index)
    if known.objects is None:
        # "grasp the block" is read once it is known that there is a block.
        return known
    reading = read_action(node.name, known.objects, known.language)
    if node.single is None and not reading.sure:
        return known
    if node.single is False or node.action is not None or reading.action is None:
        return known
    action = _with_its_thing(known, index, reading.action)
    sure = replace(node, single=True, action=action)
    return with_roles(replace(known, root=put(known.root, index, sure)))


def _with_its_thing(known: Knowledge, index: Index, action: Action) -> Action:
    """Return an action on the thing its step's whole speaks of: "grab it" below "the pot"."""
    if action.object is not None or (action.verb, action.way) not in _NEEDS_OBJECT:
        return action
    for above in range(len(index) - 1, 0, -1):
        name = at(known.root, index[:above]).name
        spoken = mentioned_objects(name, known.objects or (), known.language)
        if len(spoken) == 1:
            return replace(action, object=spoken[0])
    return action


def all_understood(known: Knowledge) -> Knowledge:
    """Return what is known after reading every name that has not been read."""
    for index, node in tuple(walk(known.root)):
        if index and node.name:
            known = understood(known, index)
    return known


def with_action(known: Knowledge, index: Index, action: Action) -> Knowledge:
    """Return what is known after a node is one motion with this action."""
    node = replace(at(known.root, index), single=True, action=action, parts=())
    return with_roles(replace(known, root=put(known.root, index, node)))


def with_roles(known: Knowledge) -> Knowledge:
    """Return what is known with roles as the actions use things: what is grasped is carried.

    A thing that is only gone down to or released at is a target, such as the lowest block of
    a stack.
    """
    actions = [node.action for _, node in walk(known.root) if node.action is not None]
    grasped = {one.object for one in actions if (one.verb, one.way) == ("hand", "close")}
    goals = {one.object for one in actions if (one.verb, one.way) == ("hand", "open")}
    if grasped and not any(goals):
        # "Put it down" where it was carried to: "carry it to the book".
        goals |= {one.object for one in actions if (one.verb, one.way) == ("move", "to")}
    roles: list[TaskObject] = []
    for thing in known.objects or ():
        if thing.name in grasped:
            roles.append(replace(thing, role="object"))
        elif thing.name in goals:
            roles.append(replace(thing, role="target"))
        else:
            roles.append(thing)
    return known if known.objects is None else fitted(replace(known, objects=tuple(roles)))
