"""One sentence that answers several questions of the introduction, or another than was asked.

"It's called stacking, the goal is a tower, you need the two blocks, and it has two steps: fetch
the red one, put it on the green one" leaves only what the robot still does not know.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass, replace

from assistant.dialogue.answers import answer
from assistant.dialogue.asking import ask, proceed
from assistant.dialogue.introduction import MOST_PARTS, all_understood
from assistant.dialogue.knowledge import Knowledge
from assistant.dialogue.naming import (
    Value,
    is_nothing,
    is_odd,
    just_as_many,
    listed_steps,
    steps_in,
    tidy_name,
)
from assistant.dialogue.state import Dialogue, Introducing
from assistant.dialogue.things import things_in
from assistant.dialogue.turn import Turn, Words, changed, first, line, say
from assistant.language.matters import Told, told_matters
from assistant.model import teacher_acts as acts
from assistant.model.robot_acts import RobotAct
from assistant.model.teacher_acts import Asked

_ASKED = ("task_name", "goal", "objects", "subtask_count")
_QUESTIONS: dict[str, Asked] = {"task_name": "task_name", "goal": "goal", "objects": "objects"}
"""Questions by the topics that answer them."""


@dataclass(frozen=True, slots=True)
class _Noted:
    """What is known so far, what is said of it, and a question that comes first."""

    known: Knowledge
    lines: tuple[RobotAct, ...] = ()
    asks: Introducing | None = None


def told_several(
    dialogue: Dialogue, words: Words, _: Iterable[acts.TeacherAct] = ()
) -> Turn | None:
    """Take all that a sentence tells of the task; None where it just answers the question."""
    state = dialogue.state
    if not isinstance(state, Introducing) or state.asked not in _ASKED or state.named:
        return None
    if dialogue.pending is not None or "?" in words.text:
        return None
    told = told_matters(words.text, dialogue.language)
    told = _of_use(dialogue, state, told, by_voice=words.by_voice)
    if not told:
        return None
    noted = _Noted(dialogue.known)
    for matter in told:
        noted = _note(noted, state, matter)
        if noted.asks is not None:
            break
    if noted.known == dialogue.known and noted.asks is None:
        return None
    after = changed(dialogue, _label(told), noted.known, clean=dialogue.clean)
    said = say(after, *noted.lines)[1]
    if noted.asks is not None:
        return first(said, ask(replace(after, state=noted.asks)))
    return first(said, proceed(after))


def _label(told: tuple[Told, ...]) -> str:
    """Return which change it is, for undo."""
    topics = [one.topic for one in told]
    if len(topics) > 1:
        return "several"
    return {"count": "steps", "steps": "steps"}.get(topics[0], topics[0])


def _of_use(
    dialogue: Dialogue, state: Introducing, told: tuple[Told, ...], *, by_voice: bool
) -> tuple[Told, ...]:
    """Return the matters, each with its topic; none where the question alone is answered."""
    language, known = dialogue.language, dialogue.known
    opened = [one for one in told if one.topic]
    if not opened or (state.index and any(one.topic != "count" for one in opened)):
        return ()
    named = tuple(one if one.topic else _answering(state, one) for one in told)
    topics = [one.topic for one in named]
    if len(set(topics)) < len(topics) or "" in topics:
        return ()
    if known.root.parts and not state.index and {"steps", "count"} & set(topics):
        return ()
    if not all(_tells(one, known, language) for one in named):
        return ()
    return () if _read_elsewhere(state, named, by_voice=by_voice) else named


def _read_elsewhere(state: Introducing, told: tuple[Told, ...], *, by_voice: bool) -> bool:
    """Whether the question alone is answered, or a name is told with the steps."""
    topics = [one.topic for one in told]
    if len(topics) > 1:
        return topics == ["task_name", "steps"]
    if topics[0] == "count" and told[0].text:
        # Of a list that was heard, what is unsure is read back.
        return by_voice
    asked = ("count", "steps") if state.asked == "subtask_count" else (state.asked,)
    return topics[0] in asked or "task_name" in (topics[0], state.asked)


def _answering(state: Introducing, told: Told) -> Told:
    """Return what comes before the first opening as the answer to what was asked."""
    return replace(told, topic=state.asked if state.asked in _QUESTIONS else "")


def _tells(told: Told, known: Knowledge, language: str) -> bool:
    """Whether a matter tells what its opening promises."""
    match told.topic:
        case "task_name":
            return bool(told.text) and not is_odd(tidy_name(told.text), language)
        case "goal":
            return bool(told.text)
        case "objects":
            return is_nothing(told.text, language) or bool(
                things_in(told.text, known.scene, language)
            )
        case "count":
            return 0 < told.count <= MOST_PARTS
        case _:
            return bool(_steps(told, language))


def _steps(told: Told, language: str) -> tuple[str, ...]:
    if not told.text:
        return ()
    plain = told.topic == "count" and not told.listed
    # Who says three may name two, joined by an "and".
    for room in dict.fromkeys((max(told.count, 2), 2)):
        steps = (listed_steps if plain else steps_in)(told.text, room, language)
        if len(steps) > 1:
            return steps
    return just_as_many(told.text, told.count, language) if plain else steps


def _note(noted: _Noted, state: Introducing, told: Told) -> _Noted:
    """Return what is known after one matter more."""
    language = noted.known.language
    if told.topic in _QUESTIONS:
        asked = Introducing(_QUESTIONS[told.topic])
        echo = () if told.topic == state.asked else _echo(noted.known, told)
        return _added(noted, asked, told.text, echo)
    steps = _steps(told, language)
    if told.count:
        noted = _added(noted, Introducing("subtask_count", state.index), told.count)
    if not steps:
        return noted
    echo = (line("done", "steps", names=list(steps)),)
    if told.count:
        return _added(noted, Introducing("subtask_name", (*state.index, 1)), steps, echo)
    return _added(noted, Introducing("subtask_count", state.index), steps, echo)


def _echo(known: Knowledge, told: Told) -> tuple[RobotAct, ...]:
    """Return what the robot says of a matter that it did not ask for."""
    if told.topic == "goal":
        return (line("done", "goal", goal=tidy_name(told.text)),)
    if told.topic != "objects":
        return ()
    things = things_in(told.text, known.scene, known.language)
    return (line("done", "things", names=[one.name for one in things]),) if things else ()


def _added(
    noted: _Noted, asked: Introducing, value: Value, echo: tuple[RobotAct, ...] = ()
) -> _Noted:
    found = answer(noted.known, asked, value)
    if asked.asked == "objects" and isinstance(value, str) and is_nothing(value):
        return replace(noted, known=all_understood(replace(noted.known, objects=())))
    echo = () if found.lines or found.asks is not None else echo
    return _Noted(found.known, (*noted.lines, *found.lines, *echo), found.asks)
