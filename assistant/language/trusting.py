"""How far the grammar is trusted with what it is sure of, and what makes its words doubtful."""

from __future__ import annotations

from assistant.language.frames import classes_of
from assistant.language.looks import kind_of
from assistant.language.merging import CORRECTIONS
from assistant.language.parsing import ACTING, GUESSED, SURE, Hearing, Parse, texts_of
from assistant.language.repair import respelled
from assistant.language.seeking import Chances, label_of
from assistant.language.words import Words, said
from assistant.model.teacher_acts import (
    Again,
    Compare,
    Deny,
    Explain,
    Inform,
    Load,
    Ordered,
    Save,
    SetPose,
    TeacherAct,
    Unknown,
    act_to_json,
)

FREE_ANSWERS = ("goal", "facing")
_TRUSTED, _ASKING, _ANSWERING, _PLAINLY, _NEVER = 0.94, 0.8, 0.92, 0.75, 1.0
"""What the grammar is sure of is doubted below: where another act or name costs most, the most."""
_YES_OR_NO = frozenset(
    ("confirm_tree", "confirm_segmentation", "ready", "satisfied", "optional", "order")
)
"""Questions that a yes or no answers whatever stands beside it."""
_SHORT_NAMES = {"task_name": 3, "subtask_name": 4}
_JOINED_NAME = 5
_FEW, _MOVING, _MENDING = 3, 0.85, 0.9
_WHOLE, _TRYING = SURE - 0.02, 0.75
_TRIED = "again"
"""How a correction is read that is to be tried at once: each of its parts is plain."""


def trusted_from(weighed: Parse, hearing: Hearing, size: int = 0) -> float:
    """Return from which probability the grammar is trusted: known names and counts are plain.

    Parameters
    ----------
    size : int
        How many words were said, if that is known: of few words a motion is plain.
    """
    act, listening = weighed.acts[0], hearing.listening
    if weighed.how == _TRIED:
        return _TRYING
    if weighed.how == "motion" and 0 < size <= _FEW:
        return _MOVING
    if names_step(weighed.acts, hearing) or isinstance(act, Unknown):
        return 0.0
    if isinstance(act, Inform):
        free = isinstance(act.value, int) or listening.asked in FREE_ANSWERS
        return _PLAINLY if free else _ANSWERING
    if kind_of(weighed.acts) == "named":
        # Where a name that nobody knows begins and ends the grammar cannot tell.
        return _NEVER
    if weighed.how == "mended":
        return _MENDING
    placed = isinstance(act, SetPose) and act.object in listening.objects
    return _ASKING if placed or isinstance(act, Explain) else _TRUSTED


def is_name(weighed: Parse, words: Words, hearing: Hearing) -> bool:
    """Tell few words that are all of them the name asked for: "press fit and glue"."""
    most = _SHORT_NAMES.get(hearing.listening.asked or "", 0)
    if most and any(word.text in hearing.book.little["and"] for word in words[1:-1]):
        most = _JOINED_NAME
    sure = len(words) <= most and weighed.score >= ACTING
    return sure and weighed.acts == (Inform(said(words)),)


def is_nameless(acts: tuple[TeacherAct, ...]) -> bool:
    """Tell an act about a lesson that nobody named: "save", "load it"."""
    return acts in _NAMELESS


_NAMELESS = ((Save(),), (Load(),), (Compare(),))


def names_step(acts: tuple[TeacherAct, ...], hearing: Hearing) -> bool:
    """Tell acts that name a step the lesson knows."""
    pages = [act_to_json(one) for one in acts]
    values = [value for page in pages for value in page.values()]
    told = {str(one) for v in values for one in (v if isinstance(v, list) else [v])}
    told |= {str(page["where"].get("subtask")) for page in pages if page.get("where")}
    return bool(told & set(hearing.listening.subtasks))


def strange(acts: tuple[TeacherAct, ...], words: Words, hearing: Hearing) -> bool:
    """Tell a word that stands in no list, is no slip of one, and is in no name."""
    book = hearing.book
    spelled = respelled(words, book, hearing.listening.objects)
    odd = {
        w.text
        for w in spelled
        if w.text.isalpha() and w.text not in book.vocabulary and w.text not in book.real
    }
    pages = [act_to_json(one) for one in acts]
    named = " ".join(str(page["where"].get("subtask")) for page in pages if page.get("where"))
    return bool(odd - set(named.lower().split()))


def unheard(acts: tuple[TeacherAct, ...], words: Words, hearing: Hearing) -> bool:
    """Tell words of which some stand in no list, and no is not their first or last where asked.

    "No dear, half of it went on the carpet" answers whether all is well.
    """
    book = hearing.book
    odd = any(w.text not in book.vocabulary and w.text not in book.real for w in words)
    asked = hearing.listening.asked in _YES_OR_NO
    told = words[0].text in book.no or words[-1].text in book.no
    return odd and not (asked and told and acts == (Deny(),))


def consenting(weighed: Parse, chances: Chances, hearing: Hearing) -> bool:
    """Tell whether the only rivals say the same: yes and praise, or yes and go when asked so."""
    first = max(chances, key=chances.__getitem__)
    agreeing = {"affirm", "start" if hearing.listening.asked == "ready" else "approve"}
    return {first, *map(label_of, weighed.acts)} <= agreeing


def chatting(words: Words, hearing: Hearing) -> bool:
    """Tell talk of other matters, misspelled as well."""
    spelled = respelled(words, hearing.book, hearing.listening.objects)
    return bool({*texts_of(words), *texts_of(spelled)} & hearing.book.chat)


def wondering(words: Words, hearing: Hearing) -> bool:
    """Tell a question of why, which asks for no act: "why is episode 3 mapped to insert"."""
    texts, little = texts_of(words), hearing.book.little
    asked = len(texts) > 2 and texts[0] in little["why"] and texts[1] in little["asking"]
    return asked and not set(texts[2:4]) & little["not"]


def wondered(parse: Parse, words: Words, hearing: Hearing) -> Parse:
    """Return a question of why as that, where it was read as what it asks about."""
    named = kind_of(parse.acts) in ("named", "motion") and wondering(words, hearing)
    return Parse((Explain(said(words)),), GUESSED, "sought") if named else parse


def only_part(acts: tuple[TeacherAct, ...], weighed: Parse) -> bool:
    """Tell a part of corrections that the grammar explains whole: "2 cm left and one up"."""
    told = weighed.acts
    whole = weighed.score >= _WHOLE and all(isinstance(one, (*CORRECTIONS, Again)) for one in told)
    return whole and len(acts) < len(told) and all(one in told for one in acts)


def swapped(acts: tuple[TeacherAct, ...], weighed: Parse, words: Words, hearing: Hearing) -> bool:
    """Tell what is forbidden read as though it were wanted: "never pour before opening"."""
    one, other = acts[0], weighed.acts[0]
    if not isinstance(one, Ordered) or not isinstance(other, Ordered):
        return False
    forbidden = "forbid" in classes_of(texts_of(words), hearing.language)
    return forbidden and (one.first, one.second) == (other.second, other.first)
