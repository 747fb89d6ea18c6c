"""The robot's lines in words: `says.yaml` of a language, filled from a line's slots."""

from __future__ import annotations

import re
from collections.abc import Mapping
from typing import Any

from assistant.errors import BadInput
from assistant.language.hints import has_page, page
from assistant.language.kinds import KINDS
from assistant.language.wording import Wording
from assistant.model.robot_acts import RobotAct


def check_spoken(language: str) -> None:
    """Raise BadInput if the robot has no words of its own in a language."""
    if not has_page("says", language):
        what = f"the robot does not speak {language} yet"
        raise BadInput.one("language", what, "sentences are understood: assistant understand")


def phrase(line: RobotAct, language: str = "english", *, brief: bool = False) -> str:
    """Return the sentence for a line.

    Parameters
    ----------
    line : RobotAct
        Its sentence is ``says.<act>.<topic>``; a topic such as ``optional.no_change`` falls
        back to ``optional``, and one the phrasebook lacks to its own words.
    language : str
        ``english`` or ``german``, or ``en`` or ``de``.
    brief : bool
        Say less. A question with the slot ``again`` was asked just before and is short too.
    """
    book = page("says", language)
    template = _template(book["says"].get(line.act, {}), line.topic)
    slots = dict(line.slots)
    if line.about is not None:
        slots.setdefault("name", line.about.name)
    slots.setdefault("when", "during")
    wording = Wording(book, slots, KINDS)
    if template is None:
        return wording.fill(str(slots.get("reason", "")) or line.topic.replace("_", " "))
    if isinstance(template, Mapping):
        again = bool(slots.get("again"))
        length = "brief" if (brief or again) and "brief" in template else "full"
        template = template["again" if again and "again" in template else length]
    return _tidy(wording.fill(template))


def in_words(value: object, language: str = "english", *, kind: str = "") -> str:
    """Return one value as the robot says it: a thing's name, or, of a kind, an action.

    Parameters
    ----------
    value : object
    language : str
    kind : str
        As slots of sentences have it: ``action``, ``percent``.
    """
    wording = Wording(page("says", language), {}, KINDS)
    return KINDS[kind](wording, value) if kind else wording.told(value)


def _template(topics: Mapping[str, Any], topic: str) -> Any:
    """Return the most special sentence there is for a topic."""
    while topic not in topics:
        topic, dot, _ = topic.rpartition(".")
        if not dot:
            return None
    return topics[topic]


def _tidy(text: str) -> str:
    """Return a sentence that begins with a capital and has no stray blanks."""
    text = re.sub(r" +([,;:?!]|\.(?!\.))", r"\1", re.sub(r"(?<=\S) {2,}", " ", text)).strip()
    return text[:1].upper() + text[1:]
