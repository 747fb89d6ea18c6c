"""Which of several readings holds: what the grammar read, or what the words are likely to tell."""

from __future__ import annotations

import math
from collections.abc import Iterator

from assistant.language.frames import frames
from assistant.language.parsing import DOUBTFUL, Hearing, Parse, texts_of
from assistant.language.repair import respelled
from assistant.language.seeking import Chances, chance, label_of, sought
from assistant.language.words import Words
from assistant.model.teacher_acts import (
    Affirm,
    Approve,
    BeBrief,
    BeThorough,
    Deny,
    Explain,
    GoBack,
    Help,
    Inform,
    Load,
    Quit,
    RepeatLine,
    Show,
    Stop,
    TeacherAct,
    Unknown,
    act_name,
    act_to_json,
)

# What may be said instead of an answer to an open question.
_INSTEAD = (
    Help,
    RepeatLine,
    Quit,
    Show,
    Explain,
    BeBrief,
    BeThorough,
    GoBack,
    Load,
    Deny,
    Inform,
    Unknown,
)
_TRUST = 0.8
_LEAST = 1e-4
_NOTHING = 0.35
_PARTLY = 0.6
_SLOT = 1.5
_SHORT = 3
_HARDLY, _MOSTLY = 0.004, 0.5


def weighed(parse: Parse, heard: Words, chances: Chances, hearing: Hearing) -> Parse:
    """Return the reading that is likeliest, how sure it is included."""
    if not chances or parse.exact or parse.acts == (Stop(),):
        return parse
    parse = _likely_acts(parse, chances)
    told = chance(parse.acts, chances)
    best, worth = parse, _logit(_grammar(parse)) + _TRUST * _log(told)
    for other, likely in _others(parse, heard, hearing, chances):
        same = [label_of(act) for act in other.acts] == [label_of(act) for act in parse.acts]
        again = [act_name(act) for act in other.acts] == [act_name(act) for act in parse.acts]
        if other.acts == parse.acts or (again and parse.how == "mended"):
            continue
        value = _logit(_grammar(other)) + _TRUST * _log(likely)
        value += _SLOT * (_told(other) - _told(parse)) if same else 0.0
        if value > worth:
            best, worth = other, value
    if isinstance(best.acts[0], Explain) and _strange(heard, hearing):
        return Parse(best.acts, min(best.score, DOUBTFUL), "strange")
    return best


def praised(
    acts: tuple[TeacherAct, ...],
    others: tuple[TeacherAct, ...],
    words: Words,
    hearing: Hearing,
) -> bool:
    """Tell praise behind a yes to what was asked, which says the same: it is no other reading."""
    if acts != (Affirm(),) or others != (Approve(),) or not words:
        return False
    return hearing.listening.asked is not None and words[0].text in hearing.book.yes


def _unheard(heard: Words, hearing: Hearing) -> bool:
    """Tell whether some word is in no list: a yes or no is not told by such."""
    book = hearing.book
    return any(w.text not in book.vocabulary and w.text not in book.real for w in heard)


def _strange(heard: Words, hearing: Hearing) -> bool:
    """Tell questions about other matters: nothing in them points at what the robot did."""
    known = frames(hearing.language)
    about = known.little["about"] if known else frozenset()
    return len(heard) > _SHORT and not about & set(texts_of(heard))


def _others(
    parse: Parse, heard: Words, hearing: Hearing, chances: Chances
) -> Iterator[tuple[Parse, float]]:
    """Yield other readings; talk of other matters and plain answers have few."""
    spelled = respelled(heard, hearing.book, hearing.listening.objects)
    if {*texts_of(heard), *texts_of(spelled)} & hearing.book.chat:
        return
    answers = isinstance(parse.acts[0], Inform)
    for other, likely in sought(heard, hearing, chances):
        if isinstance(other.acts[0], Inform) and isinstance(parse.acts[0], Unknown):
            continue
        if isinstance(other.acts[0], Affirm | Deny | Approve) and _unheard(heard, hearing):
            continue
        if praised(parse.acts, other.acts, heard, hearing):
            continue
        if not answers or (isinstance(other.acts[0], _INSTEAD) and likely > _MOSTLY):
            yield other, likely


def _likely_acts(parse: Parse, chances: Chances) -> Parse:
    """Drop acts of a line that its words hardly tell: "leave it, open the hand" leaves nothing."""
    if len(parse.acts) < 2:
        return parse
    kept = tuple(act for act in parse.acts if chance((act,), chances) >= _HARDLY)
    if not kept or kept == parse.acts or chance(kept, chances) < _MOSTLY:
        return parse
    return Parse(kept, min(parse.score, DOUBTFUL + 0.2), parse.how)


def _told(parse: Parse) -> int:
    """Return how many slots are told."""
    return sum(
        value not in (None, [], "") for act in parse.acts for value in act_to_json(act).values()
    )


def _grammar(parse: Parse) -> float:
    if isinstance(parse.acts[0], Unknown):
        return parse.score if parse.score > 0.7 else _NOTHING
    return min(parse.score, _PARTLY) if parse.how == "partly" else parse.score


def _logit(share: float) -> float:
    return math.log(share / (1 - share))


def _log(share: float) -> float:
    return math.log(max(share, _LEAST))
