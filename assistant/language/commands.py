"""What a line asks for: one clause, one that is corrected by its speaker, or several."""

from __future__ import annotations

from assistant.language.answers import OPEN
from assistant.language.clauses import clause
from assistant.language.compounds import compound, corrected, once_more, united
from assistant.language.contrasts import contrasted, denied
from assistant.language.mending import mended
from assistant.language.merging import merged
from assistant.language.parsing import (
    ACTING,
    DOUBTFUL,
    GUESSED,
    LIKELY,
    NAMED,
    SURE,
    Hearing,
    Parse,
    texts_of,
)
from assistant.language.topics import going_on, topical
from assistant.language.words import Words
from assistant.model.listening import Listening
from assistant.model.teacher_acts import (
    AddSubtask,
    AdjustLast,
    AdjustSpeed,
    Affirm,
    Again,
    Approve,
    Assign,
    Deny,
    Gripper,
    Merge,
    MoveCut,
    NewSetup,
    Optional,
    Rename,
    RepeatLine,
    Resume,
    Rotate,
    Save,
    Split,
    Start,
    Stop,
    TeacherAct,
    Translate,
    Undo,
    Unknown,
    Unordered,
)

LEAST_MENDED = 0.7
_LONGEST_PLAIN = 4
YES_OR_NO = frozenset(
    ("confirm_tree", "confirm_segmentation", "did_you_mean", "ready", "unsaved", "pose", "order")
)


def plain_answer(words: Words, parse: Parse | None, hearing: Hearing) -> Parse | None:
    """Return yes or no where a question was asked and only they are understood for sure."""
    asked, first = hearing.listening.asked, words[0].text
    plain = (*hearing.book.yes, *hearing.book.no)
    if (asked not in YES_OR_NO and asked != "satisfied") or first not in plain:
        return parse
    if len(words) > 1 and not words[1].broken:
        return parse
    sure = parse is not None and parse.score >= LIKELY and parse.how in ("sentence", "motion")
    if sure or (parse is not None and parse.how == "denied"):
        return parse
    answer = Affirm() if first in hearing.book.yes else Deny()
    more = _goes_on(words[1:], hearing, agreed=isinstance(answer, Affirm))
    return Parse((answer,), GUESSED if more else ACTING, "plain")


def _goes_on(words: Words, hearing: Hearing, *, agreed: bool) -> bool:
    """Tell whether more than talk may follow an answer: then it is read back."""
    if len(words) < _LONGEST_PLAIN:
        return False
    if agreed and any(word.broken and word.text in hearing.book.no for word in words):
        return True
    more = clause(words, hearing)
    return more is not None and isinstance(more.acts[0], _SURELY_MORE)


def consent(words: Words, hearing: Hearing) -> Parse | None:
    """Read "why not" as a yes where one was asked for, never so surely that it ends a thing."""
    asked = hearing.listening.asked
    if asked is None or asked in OPEN or texts_of(words) not in hearing.book.consenting:
        return None
    return Parse((Affirm(),), NAMED, "consent")


def command(words: Words, hearing: Hearing) -> Parse | None:
    """Return the clause as a whole, corrected by its speaker, or cut into several."""
    words = united(words, hearing)
    told = _denied(words, hearing)
    if told is not None:
        return told
    repeated = once_more(words, hearing) or going_on(words, hearing)
    if repeated is not None:
        return settled(repeated, hearing.listening)
    ruled_out = contrasted(words, hearing)
    if ruled_out is not None:
        return settled(ruled_out, hearing.listening)
    taken_back = _mended(words, hearing)
    if taken_back is not None:
        return settled(taken_back, hearing.listening)
    whole = clause(words, hearing)
    if whole is not None and len(whole.acts) > 1 and whole.score >= LIKELY:
        parted = compound(words, hearing) if any(word.broken for word in words[1:]) else None
        whole = parted if parted is not None and len(parted.acts) >= len(whole.acts) else whole
    if whole is not None and whole.how in ("motion", "frame") and len(whole.acts) == 1:
        whole = _with_more(whole, words, hearing)
    if whole is not None and whole.score >= LIKELY:
        return settled(whole, hearing.listening)
    for other in (corrected, compound, topical):
        found = other(words, hearing)
        if found is not None and (whole is None or found.score > whole.score):
            whole = found
        if whole is not None and whole.score >= LIKELY:
            break
    return None if whole is None else settled(whole, hearing.listening)


def _with_more(whole: Parse, words: Words, hearing: Hearing) -> Parse:
    """Return a motion with what else the hand is to do: "mach die Hand auf" is all small words."""
    joints = hearing.book.little["clause_joints"]
    if not any(word.text in joints for word in words[1:]):
        return whole
    parted = compound(words, hearing)
    if parted is None or parted.score < LIKELY:
        return whole
    return parted if any(isinstance(act, Gripper) for act in parted.acts) else whole


def _denied(words: Words, hearing: Hearing) -> Parse | None:
    """Read a no to the question asked with what is wanted instead: "no, I said slower"."""
    if hearing.listening.asked not in _NO_WITH_MORE:
        return None
    parted = denied(words, hearing)
    found = command(parted[1], hearing) if parted else None
    if found is None or any(isinstance(a, _NO_MORE) for a in found.acts):
        return None
    if found.score < (LEAST_MENDED if isinstance(found.acts[0], _SURELY_MORE) else GUESSED):
        return None
    runs = hearing.listening.asked in ("satisfied", "did_you_mean")
    if not runs and isinstance(found.acts[0], Again | Start | Resume):
        return None
    return Parse((Deny(), *found.acts), min(found.score, ACTING - 0.01), "denied")


_SURELY_MORE = (AddSubtask, Assign, Merge, MoveCut, Rename, Split)
"""What nobody says by chance behind a no: told by several words, names among them."""
_NO_WITH_MORE = YES_OR_NO | {"satisfied"}
_NO_MORE = (Deny, Affirm, Unknown, Stop, Undo, RepeatLine, AdjustLast, Save, Approve)


def _mended(words: Words, hearing: Hearing) -> Parse | None:
    """Return what a line means whose speaker took back a part of it."""
    best: Parse | None = None
    for line in mended(words, hearing):
        parse = clause(line, hearing)
        if parse is None or parse.score < LIKELY:
            other = compound(line, hearing)
            parse = other if other is not None and other.score >= LIKELY else parse
        if parse is not None and (best is None or parse.score > best.score + 0.06):
            best = parse
    if best is None or best.score < LEAST_MENDED or isinstance(best.acts[0], Unknown):
        return None
    return Parse(best.acts, min(best.score, SURE) - 0.04, "mended")


def settled(parse: Parse, listening: Listening) -> Parse:
    """Drop a yes that only leads into the rest, and a no that answers nothing."""
    acts = _answered(parse.acts, listening)
    acts = tuple(act for act in acts if not isinstance(act, Unknown)) or acts[:1]
    if any(isinstance(act, RepeatLine) for act in acts):
        acts = tuple(act for act in acts if not isinstance(act, Again))
    if listening.asked in YES_OR_NO - {"ready"} and isinstance(acts[0], Affirm):
        acts = acts[:1] + tuple(act for act in acts[1:] if not isinstance(act, Start | Resume))
    if all(isinstance(act, Affirm | Approve) for act in acts):
        acts = acts[:1] if listening.asked else acts[-1:]
    for leading, implied in _IMPLIED:
        if any(isinstance(act, leading) for act in acts):
            acts = tuple(act for act in acts if not isinstance(act, implied))
    if listening.asked == "ready":
        acts = tuple(Start() if isinstance(act, Resume) else act for act in acts)
    unique = _again_last(merged(tuple(dict.fromkeys(acts))))
    if unique == (Unordered(),) and listening.stage == "practice":
        return Parse(unique, DOUBTFUL, parse.how)
    return Parse(unique, parse.score, parse.how)


# What another act says already: to go on is no start, and "now further, go on" no correction.
_IMPLIED: tuple[tuple[type[TeacherAct], tuple[type[TeacherAct], ...]], ...] = (
    (Resume, (Start, Undo, AdjustLast)),
    (NewSetup, (Start, Again)),
)


_CORRECTING = (AdjustLast, AdjustSpeed, Rotate, Translate)


def _again_last(acts: tuple[TeacherAct, ...]) -> tuple[TeacherAct, ...]:
    """Return acts with the correction first: "again, more left" is corrected, then run."""
    if Again() not in acts or not any(isinstance(act, _CORRECTING) for act in acts):
        return acts
    return (*(act for act in acts if act != Again()), Again())


def _answered(acts: tuple[TeacherAct, ...], listening: Listening) -> tuple[TeacherAct, ...]:
    """Return acts without a yes or no that what was asked does not want."""
    if listening.asked in YES_OR_NO:
        acts = tuple(Affirm() if isinstance(act, Approve) else act for act in acts)
    if len(acts) < 2 or not isinstance(acts[0], Affirm | Deny):
        return acts
    if listening.asked in OPEN:
        return acts[1:]
    same = {"ready": Start, "optional": Optional}.get(listening.asked or "")
    if listening.asked == "unsaved" and acts == (Affirm(), Save()):
        return acts[:1]
    while len(acts) > 1 and isinstance(acts[0], Affirm) and isinstance(acts[1], Affirm):
        acts = acts[1:]
    wanted = len(acts) > 1 and same is not None and isinstance(acts[1], same)
    return acts[1:] if len(acts) > 1 and (listening.asked is None or wanted) else acts


def unknown(words: Words, hearing: Hearing) -> Parse:
    """Return that nothing is understood, surer of it where the words are of other matters."""
    chat = set(texts_of(words)) & hearing.book.chat
    return Parse((Unknown(),), 0.8 if chat else 0.6)
