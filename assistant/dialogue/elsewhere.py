"""Whether words about a thing move the thing, or correct the motion.

"Put the target ten centimetres further left" tells where a thing stands: the robot carries no
targets. Said of what it carries, and far, it may be either, and is asked about.
"""

from __future__ import annotations

import re
from dataclasses import replace

from assistant.dialogue.asking import ask, question
from assistant.dialogue.placing import set_pose
from assistant.dialogue.state import Dialogue, Pending, Ran, Ready
from assistant.dialogue.turn import Turn, line
from assistant.language.actions import mentioned_objects
from assistant.language.hints import hints
from assistant.model import teacher_acts as acts
from assistant.model.directions import WAYS
from assistant.model.settings import SafetySettings

SAFETY = SafetySettings()
BY_DEGREE_M = {"little": 0.02, None: 0.05, "much": 0.1}
"""How far a thing was put that somebody put further without telling how far."""


def stands_elsewhere(dialogue: Dialogue, act: acts.TeacherAct, words: str) -> Turn | None:
    """Put a thing elsewhere that words of moving are about, or ask; None for a correction."""
    if not isinstance(act, acts.Translate) or act.where is not None:
        return None
    if not isinstance(dialogue.state, Ready | Ran) or not _puts(words, dialogue.language):
        return None
    things = dialogue.known.objects or ()
    named = mentioned_objects(words, things, dialogue.language)
    roles = {one.name: one.role for one in things}
    if len(named) != 1 or named[0] not in dialogue.known.setup.places:
        return None
    target = roles[named[0]] == "target"
    far_m = act.distance_m if act.distance_m is not None else BY_DEGREE_M[act.degree]
    x, y, z = (1000.0 * far_m * share for share in WAYS[act.direction])
    there = acts.SetPose(named[0], by_mm=(x, y, z))
    asked = question(dialogue)
    wanted = asked is not None and asked.topic == "ready_refused"
    if target and (act.distance_m is not None or wanted):
        return set_pose(dialogue, there, words, sure=True)
    if not target and (act.distance_m is None or abs(far_m) <= SAFETY.confirm_beyond_m):
        return None
    told = [acts.act_to_json(act)]
    asking = line("confirm", "stands_elsewhere", asked="did_you_mean", acts=told, thing=named[0])
    pending = Pending("did_you_mean", asking, (there,), words, other=(act,))
    return ask(replace(dialogue, pending=pending))


def _puts(words: str, language: str) -> bool:
    """Whether a text is about putting something that it names right after."""
    verbs, articles = ("|".join(map(re.escape, hints(one, language))) for one in _PUTTING)
    return re.search(rf"\b(?:{verbs})\s+(?:{articles})\s+\w", words, re.IGNORECASE) is not None


_PUTTING = ("putting", "articles")
