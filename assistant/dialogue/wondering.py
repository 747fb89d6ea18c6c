"""Questions about the robot that are known by their words, whatever else they look like."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from assistant.dialogue.asking import places, question, tell
from assistant.dialogue.doubting import without_guess
from assistant.dialogue.explaining import explain
from assistant.dialogue.helping import help_line
from assistant.dialogue.naming import tidy_name
from assistant.dialogue.reporting import refusal_line
from assistant.dialogue.state import Dialogue, Watching
from assistant.dialogue.things import thing_names
from assistant.dialogue.turn import Turn, Words, line
from assistant.language.hints import hints, matter, mentions
from assistant.model import teacher_acts as acts
from assistant.model.robot_acts import RobotAct


def wondered(dialogue: Dialogue, words: Words) -> Turn | None:
    """Answer what may be asked at any time and has one meaning; None where it is not asked."""
    plain = tidy_name(words.text).lower()
    if plain in hints("what_now", dialogue.language):
        return tell(dialogue, help_line(dialogue))
    if isinstance(dialogue.state, Watching):
        return None
    told = _guided(dialogue, plain)
    if told is not None:
        return tell(replace(without_guess(dialogue), misses=0), told)
    if mentions(words.text, hints("questions", dialogue.language)):
        calm = replace(without_guess(dialogue), misses=0)
        return explain(calm, acts.Explain(words.text))
    return _why_refused(dialogue, plain)


def _guided(dialogue: Dialogue, plain: str) -> RobotAct | None:
    """Tell who asks how all this goes, what is there, and where to stand."""
    known = dialogue.known
    things = thing_names(known.scene, known.setup)
    topic = matter(plain, "guide", dialogue.language)
    if topic == "way":
        return line("told", "guide", things=things)
    if topic == "stand":
        return line("told", "stand")
    if topic != "table":
        return None
    if things:
        return line("told", "setup", setup=known.setup.name, places=places(known))
    return line("told", "empty_table")


def _why_refused(dialogue: Dialogue, plain: str) -> Turn | None:
    """Tell why a run was refused to who asks just "why?" or "why not?" then."""
    asked, refusal = question(dialogue), dialogue.refusal
    if refusal is None or asked is None or asked.topic != "ready_refused":
        return None
    if plain not in hints("why_not", dialogue.language):
        return None
    return tell(replace(dialogue, misses=0), refusal_line("explain", refusal))


def asks_why(dialogue: Dialogue, meant: Sequence[acts.TeacherAct], text: str) -> bool:
    """Whether a text asks for an explanation, which may be given on a guess: it moves nothing."""
    first_word = (text.lower().split() or [""])[0]
    asks = text.rstrip().endswith("?") or first_word in hints("question_words", dialogue.language)
    only = len(meant) == 1 and isinstance(meant[0], acts.Explain)
    return asks and only and bool(matter(text, "explain", dialogue.language))
