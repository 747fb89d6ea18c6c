"""What the readings of a line look like: beside each other, and each for itself."""

from __future__ import annotations

import math
import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any

from assistant.language.answers import OPEN
from assistant.language.frames import frames
from assistant.language.parsing import Hearing, Parse
from assistant.language.seeking import Chances, chance, label_of
from assistant.language.words import Words
from assistant.model.teacher_acts import TeacherAct, act_to_json

Looks = dict[str, float]
_LEAST = 1e-4
_SURELY = 0.7
"""How likely both clauses of a line are at least where they are surely two."""
_NAMES = (
    *("subtask", "name", "old", "new", "first", "second", "subtasks", "before", "after"),
    "object",
)
_KINDS: Mapping[str, str] = {
    **dict.fromkeys(("optional", "required", "unordered", "ordered", "rename"), "named"),
    **dict.fromkeys(("add_subtask", "remove_subtask", "merge", "split"), "named"),
    **dict.fromkeys(("move_cut", "assign", "save", "load", "compare"), "named"),
    **dict.fromkeys(("translate", "rotate", "adjust_speed", "gripper", "adjust_last"), "motion"),
    **dict.fromkeys(("explain", "key_state"), "texted"),
    "inform": "inform",
    "unknown": "unknown",
    "set_pose": "placed",
}
_BY_KIND = (
    *("weighed", "whole_top", "agreed", "cut"),
    *("likely", "slots_likely", "chance", "weighed_score", "exact", "left", "bare"),
)
"""Looks that tell more of some kinds of acts than of others."""
_ARTICLE = re.compile(r"\b(the|a|an) ")


@dataclass
class Candidate:
    """A reading of a line with what it looks like, each look a number near one."""

    acts: tuple[TeacherAct, ...]
    looks: Looks = field(default_factory=dict)


def key_of(acts: Sequence[TeacherAct]) -> str:
    """Return what readings have in common that mean the same."""
    told = []
    for act in acts:
        page = act_to_json(act)
        kept = ("act",) if page["act"] in ("explain", "key_state") else tuple(page)
        told.append(sorted((k, page[k]) for k in kept if page[k] not in ("", [], None)))
    return _ARTICLE.sub("", str(told).lower())


def look_at(
    pool: Sequence[Candidate], weighed: Parse, words: Words, chances: Chances, hearing: Hearing
) -> None:
    """Add to readings how they stand beside each other, and what each is made of."""
    grammar = _labels(weighed.acts)
    best = max(chances, key=chances.__getitem__, default="")
    _look_at_cuts(pool)
    for one in pool:
        one.looks |= _beside(one, grammar, best, chances)
        one.looks |= _names(one, words, hearing)
        one.looks |= {
            "always": 1.0,
            "words": min(len(words), 20) / 10,
            "open": float(hearing.listening.asked in OPEN),
            "two": float(len(one.acts) == 2),
            "more": float(len(one.acts) > 2),
        }
        one.looks |= _likely(one.looks)
        kind = kind_of(one.acts)
        one.looks[f"kind_{kind}"] = 1.0
        if kind == "inform":
            one.looks[f"asked_{hearing.listening.asked}"] = 1.0
        for look in _BY_KIND:
            if one.looks.get(look):
                one.looks[f"{kind}_{look}"] = one.looks[look]


def _look_at_cuts(pool: Sequence[Candidate]) -> None:
    """Add which readings are only a part of what a line cut in clauses tells."""
    whole = [one for one in pool if len(one.acts) == 1]
    for cut in pool:
        if "cut" not in cut.looks or len(cut.acts) < 2:
            continue
        likely = math.exp(cut.looks["cut_least"])
        cut.looks["cut_both"] = float(likely > _SURELY)
        for one in whole:
            if one.acts[0] in cut.acts:
                one.looks["within"] = max(likely, one.looks.get("within", 0.0))
                if one.looks.keys() & {"weighed", "whole_top"}:
                    cut.looks["holds"] = likely


def _likely(looks: Looks) -> Looks:
    """Return how likely the learned readings are, and that where the grammar reads the same."""
    found: Looks = {}
    if "whole" in looks:
        slots = math.exp(looks["whole_slots"])
        found |= {"slots_likely": slots, "likely": slots * math.exp(looks["whole_act"])}
    if "cut" in looks:
        found["cut_likely"] = math.exp(looks["cut_least"])
    if "weighed" in looks:
        found |= {f"agreed_{name}": value for name, value in found.items()}
    return found


def kind_of(acts: Sequence[TeacherAct]) -> str:
    """Return of which kind acts are: the first kind that some act of them is of."""
    found = {_KINDS.get(str(act_to_json(act)["act"]), "plain") for act in acts}
    order = ("named", "motion", "inform", "unknown", "placed", "texted")
    return next((kind for kind in order if kind in found), "plain")


def _labels(acts: Sequence[TeacherAct]) -> list[str]:
    return sorted(label_of(act) for act in acts)


def _beside(one: Candidate, grammar: list[str], best: str, chances: Chances) -> Looks:
    labels, looks = _labels(one.acts), one.looks
    told = chance(one.acts, chances)
    rival = max([p for label, p in chances.items() if label not in labels], default=0.0)
    weighed = "weighed" in looks
    return {
        "chance": math.log(max(told, _LEAST)),
        "margin": told - rival,
        "rival": math.log(max(rival, _LEAST)),
        "like_grammar": float(labels == grammar),
        "like_model": float(labels == [best]),
        "agreed": float(weighed and looks.get("whole_top", 0.0) > 0),
        "agreed_cut": float(weighed and "cut" in looks),
        "both": float(weighed and "first" in looks),
        "several_weighed": float(weighed and len(one.acts) > 1),
    }


def _names(one: Candidate, words: Words, hearing: Hearing) -> Looks:
    """Return what the names of a reading look like, and what it leaves of the words."""
    book, known = hearing.book, frames(hearing.language)
    endings = known.name_endings if known else ()
    pages = [act_to_json(act) for act in one.acts]
    names = [str(name) for page in pages for key in _NAMES for name in _each(page.get(key))]
    values = [str(value) for page in pages for value in _each(page.get("value"))]
    own = {word for name in (*names, *values) for word in name.lower().split()}
    left = [w for w in words if w.said not in own and w.text not in own]
    strange = sum(w.text.isalpha() and w.text not in book.vocabulary for w in left)
    longest = max((len(name.split()) for name in (*names, *values)), default=0)
    clear = all(any(w.endswith(endings) for w in name.split()) for name in names)
    return {
        "names": float(bool(names)),
        "clear_names": float(bool(names) and bool(endings) and clear),
        "long_names": float(longest > 2),
        "longer_names": float(longest > 4),
        "odd_names": float(bool(own & book.impure)),
        "strange": min(strange, 4.0),
        "left": min(len(left), 8) / 4,
        "bare": float(not left),
        "filled": min(sum(len(page) - 1 for page in pages), 5) / 2,
    }


def _each(value: Any) -> list[Any]:
    if value is None or value == "":
        return []
    return list(value) if isinstance(value, list | tuple) else [value]
