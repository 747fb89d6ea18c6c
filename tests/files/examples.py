"""Values with every field set, and strategies that make others."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
from hypothesis import strategies as st

from assistant.geometry import Array
from assistant.model.conditions import Condition
from assistant.model.demonstration import Demonstration, Recording, Spoken
from assistant.model.feedback import Feedback
from assistant.model.lesson import (
    Episode,
    LearnedPath,
    Lesson,
    Question,
    Segmentation,
    SegmentationPoint,
    Station,
)
from assistant.model.scene import Body, Obstacle, Scene
from assistant.model.setup import Place, Setup
from assistant.model.task import Action, Primitive, Role, Subtask, Task, TaskObject, Verb

words = st.text("abc äß'\"-:#,[]{}?*&!|>%@0123456789", min_size=1, max_size=12).filter(
    lambda text: text == text.strip()
)
numbers = st.floats(-1e4, 1e4)
triples = st.tuples(numbers, numbers, numbers)
places = st.builds(Place, st.sampled_from(["hand", "body"]), triples, triples)
hand_places = st.builds(Place, st.just("hand"), triples, triples)
setups = st.builds(Setup, words, words, hand_places, st.dictionaries(words, places, max_size=3))
spoken = st.builds(Spoken, st.floats(0, 100), words)
some_things = st.lists(words, min_size=1, max_size=3, unique=True)


def conditions(names: list[str]) -> st.SearchStrategy[Condition]:
    """Return conditions on things of some names, or on "it"."""
    it = st.none() | st.sampled_from(names)
    return st.one_of(
        st.builds(Condition, st.just("hand"), st.sampled_from(["open", "closed"])),
        st.builds(Condition, st.sampled_from(["docked", "held", "clear"]), it),
        st.builds(Condition, st.sampled_from(["on", "aligned", "above"]), it, it),
    )


def primitives(names: list[str]) -> st.SearchStrategy[Primitive]:
    """Return primitives about things of some names."""
    verbs: st.SearchStrategy[tuple[Verb, str]] = st.one_of(
        st.tuples(st.just("move"), st.sampled_from(["approach", "depart", "to", "up", "forward"])),
        st.tuples(st.just("turn"), st.sampled_from(["left", "counterclockwise"])),
        st.tuples(st.just("hand"), st.sampled_from(["open", "close"])),
        st.tuples(st.just("free"), st.text(max_size=12)),
    )
    things = st.none() | st.sampled_from(names)
    actions = st.builds(lambda verb, thing: Action(verb[0], verb[1], thing), verbs, things)
    several = st.lists(conditions(names), max_size=2).map(tuple)
    return st.builds(Primitive, words, actions, several, several, st.booleans())


def renamed(node: Subtask | Primitive, number: str = "1") -> Subtask | Primitive:
    """Return a tree in which no name stands twice."""
    name = f"{node.name} {number}"
    if isinstance(node, Primitive):
        return replace(node, name=name)
    parts = tuple(renamed(part, f"{number}.{k}") for k, part in enumerate(node.parts))
    return replace(node, name=name, parts=parts)


@st.composite
def tasks(draw: st.DrawFn) -> Task:
    """Return introduced tasks of any shape."""
    names = draw(some_things)
    orders, goals = st.sampled_from(["sequential", "any"]), st.text(max_size=12)
    inner = st.recursive(
        primitives(names),
        lambda part: st.builds(
            Subtask, words, st.lists(part, max_size=3).map(tuple), goals, orders, st.booleans()
        ),
        max_leaves=6,
    )
    tree = renamed(Subtask(draw(words), tuple(draw(st.lists(inner, max_size=3)))))
    assert isinstance(tree, Subtask)
    roles: st.SearchStrategy[Role] = st.sampled_from(["object", "target"])
    things = tuple(TaskObject(name, draw(roles)) for name in names)
    return Task(draw(words), tree, draw(goals), things)


positive = st.floats(0.1, 1e3)
sizes = st.tuples(positive, positive, positive)
not_negative = st.floats(0, 10)
bodies = st.builds(
    Body,
    words,
    st.sampled_from(["box", "cylinder", "sphere", "cup"]),
    sizes,
    not_negative,
    not_negative,
    triples,
    triples,
    triples.filter(any),
    words,
)
obstacles = st.lists(st.builds(Obstacle, words, sizes, triples, triples, words), max_size=2)
scenes = st.builds(
    lambda name, known, tables, boxes, speed: Scene(
        name, {body.name: body for body in known}, tuple(tables), tuple(boxes), speed
    ),
    words,
    st.lists(bodies, max_size=3),
    obstacles,
    obstacles,
    st.floats(0.01, 5),
)


def poses(n: int, seed: int) -> Array:
    """Return random poses, shape (n, 7)."""
    rng = np.random.default_rng(seed)
    quats = rng.normal(size=(n, 4))
    quats /= np.linalg.norm(quats, axis=1, keepdims=True)
    return np.concatenate([rng.normal(size=(n, 3)), quats], axis=1)


def recording(n: int = 20, seed: int = 0, *, gripper: bool = True) -> Recording:
    """Return a smooth random recording whose quaternions do not flip."""
    rng = np.random.default_rng(seed)
    quats = np.array([0.0, 0.0, 0.0, 1.0]) + 0.02 * np.cumsum(rng.normal(size=(n, 4)), axis=0)
    quats /= np.linalg.norm(quats, axis=1, keepdims=True)
    xyz = np.cumsum(rng.normal(scale=1e-3, size=(n, 3)), axis=0)
    t_s = np.cumsum(rng.uniform(0.01, 0.03, size=n))
    opening = np.clip(rng.normal(0.05, 0.03, size=n), 0, 0.1)
    return Recording(t_s, np.concatenate([xyz, quats], axis=1), opening if gripper else None)


def demonstration() -> Demonstration:
    """Return a demonstration with every field set."""
    setup = Setup("here", "stage", Place("hand", (400.0, 1.5, 600.0)), {"block": BODY_PLACE})
    said = (Spoken(0.05, "first step"), Spoken(0.1, "then"))
    return Demonstration(recording(), said, (Spoken(0.2, "it is held"),), setup, "-z", "somewhere")


BODY_PLACE = Place("body", (1.0, 2.5, 3.0), (0.0, 0.0, 40.0))
SCENE = Scene(
    "stage",
    {
        "block": Body(
            "block",
            "cup",
            (30.0, 30.0, 50.0),
            0.1,
            0.5,
            (-100.0, 0.0, 20.0),
            (0.0, 90.0, 0.0),
            (0.0, 1.0, 0.0),
            "red",
        ),
        "yes": Body("yes"),
    },
    (Obstacle("table", (900.0, 900.0, 20.0), (0.0, 0.0, -20.0), (0.0, 0.0, 5.0), "gray"),),
    (Obstacle("post", (30.0, 30.0, 500.5), (300.0, 0.0, 0.0)),),
    0.3,
)
ACTIONS = (
    Action("move", "approach", "block"),
    Action("turn", "clockwise", None),
    Action("hand", "close", "block"),
    Action("free", "stir: three times", "cup 2"),
)
CONDITIONS = (
    Condition("hand", "open"),
    Condition("docked", "block"),
    Condition("held", "block"),
    Condition("on", "block", "cup 2"),
    Condition("aligned", "block", "cup 2"),
    Condition("above", "block", "cup 2"),
    Condition("clear", "cup 2"),
)


def task(learned: Lesson | None = None) -> Task:
    """Return a task with every kind of node, action and condition."""
    leaves = [
        Primitive(f"part {number}", action, CONDITIONS[:number], CONDITIONS[number:], number == 1)
        for number, action in enumerate(ACTIONS)
    ]
    inner = Subtask("no", tuple(leaves[:2]), "the block: in the hand", "any", True)
    root = Subtask("all of it", (inner, *leaves[2:]), "", "sequential")
    objects = (TaskObject("block", "object"), TaskObject("cup 2", "target"))
    return Task("on", root, "it is done, #1", objects, learned)


def lesson(n: int = 30, seed: int = 0) -> Lesson:
    """Return a lesson with every field set."""
    rng = np.random.default_rng(seed)
    station = poses(3, seed)
    path = LearnedPath(
        np.cumsum(rng.uniform(0.01, 0.02, size=n)),
        poses(n, seed),
        rng.uniform(0, 0.1, size=n),
        rng.integers(-1, 4, size=n),
    )
    segmentation = Segmentation(
        points=(
            SegmentationPoint(1.25, 0.9, {"gripper": 1.0, "speed": 1 / 3}),
            SegmentationPoint(2.0, 0.1, {}, False, False),
            SegmentationPoint(3.0, 1.0, {"voice": 0.5}, True, True),
        ),
        episodes=(Episode(0.0, 1.25, "part 0", 0.97, "down"), Episode(1.25, 4.0, None, 0.5)),
        cue_lag_s=0.8,
        questions=(Question("missing_step", "part 2", "empty", {"seen": 5, "names": ("a", "b")}),),
        vote_t_s=np.linspace(0, 4, n),
        vote=rng.uniform(size=n),
        signal_votes={"gripper": rng.uniform(size=n), "speed": rng.uniform(size=n)},
    )
    return Lesson(
        segmentation=segmentation,
        path=path,
        stations=(
            Station("grasp", "block", "block", "part 2", 10, 5, 12, *station),
            Station("touch", "block", "cup 2", "", 20, 18, 29, *station[::-1]),
        ),
        before={"part 0": (Condition("hand", "open"),)},
        until={"part 0": CONDITIONS[1:3], "part 2": (Condition("held", "block"),)},
        sources=("a.yaml", "b.yaml"),
        feedback=(
            Feedback(
                "translate",
                "more left, please",
                "part 2",
                "before",
                "block",
                (0.001, 0.0, -1 / 3),
                (0.0, 0.0, 0.0),
            ),
            Feedback("rotate", "turn", turn_rad=(0.0, 0.1, 0.0)),
            Feedback("speed", "slower", factor=0.8),
            Feedback("hand", "open", hand="open"),
        ),
        speed=0.7,
        jerk_m_s3=0.31,
        approach_axis="-z",
    )
