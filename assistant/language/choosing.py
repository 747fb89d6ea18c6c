"""Which reading of a line holds: those of the grammar and the learned ones beside each other.

Readings that two independent ways arrive at are nearly always right. What readings look like is
weighed by two logistic models: one chooses, one tells how sure the choice is. Their weights
are fitted by `tests/benchmarks/fit_choice.py` on speakers the readings were not learned from.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cache
from pathlib import Path
from typing import Any, cast

from assistant.language.commands import settled
from assistant.language.cutting import cuts, sure_cuts
from assistant.language.forbidding import turned
from assistant.language.last_word import uncontradicted
from assistant.language.leading_answers import with_answer, without_nothing
from assistant.language.learned import learned
from assistant.language.looks import Candidate, Looks, key_of, kind_of, look_at
from assistant.language.open_answers import ASIDE, NOT_ANSWERS
from assistant.language.parsing import ACTING, DOUBTFUL, GUESSED, LIKELY, Hearing, Parse
from assistant.language.partial import unpartial
from assistant.language.phrasebook import LANGUAGES
from assistant.language.plain_forms import shortened, unbent
from assistant.language.seeking import Chances, chance, label_of
from assistant.language.trusting import (
    FREE_ANSWERS,
    chatting,
    consenting,
    is_name,
    is_nameless,
    names_step,
    only_part,
    strange,
    swapped,
    trusted_from,
    unheard,
    wondering,
)
from assistant.language.weighing import praised
from assistant.language.wholes import by_parts
from assistant.language.words import Words
from assistant.model.teacher_acts import (
    Affirm,
    Approve,
    Deny,
    Explain,
    Inform,
    Stop,
    TeacherAct,
    Unknown,
)
from assistant.plain_yaml import read_file

CUT_BELOW = 0.93
"""A line is cut anywhere where the whole is less likely one act, else only where both are sure."""
PLAIN_FROM = 0.5
"""A sentence of the phrasebook is weighed where its words tell its act less likely."""
_BESIDE_ANSWERS = (*ASIDE, Inform, Unknown)
_DOUBTED = 0.65
"""Where the grammar is surer that words mean nothing here, they are no answer."""
_UNKNOWN, _CHATTED_FROM = "unknown", 0.8
"""How likely words mean nothing here where those of other matters are listened to no more."""
_MOST_WHOLE = 6
_LEAST = 1e-4
_SPREAD = 5.0


@dataclass(frozen=True, slots=True)
class Weights:
    """What looks count for the choice and for how sure it is.

    Parameters
    ----------
    sure_at : float
        The probability from which few enough choices are wrong that they are acted on.
    exact_from : float
        From which a sentence of the phrasebook is trusted, where few sentences were learned from.
    """

    choice: Mapping[str, float]
    sureness: Mapping[str, float]
    sure_at: float
    exact_from: float = 1.0


@cache
def weights(language: str) -> Weights | None:
    """Return the weights of a language, read once; None if it has none."""
    path = Path(__file__).parent / LANGUAGES[language.lower()] / "choice.yaml"
    if not path.exists():
        return None
    page = cast("Mapping[str, Any]", read_file(path)[0].value)
    choice, sureness = (
        {name: float(value) for name, value in page[part].items()}
        for part in ("choice", "sureness")
    )
    return Weights(choice, sureness, float(page["sure_at"]), float(page.get("exact_from", 1.0)))


def chosen(
    first: Parse, weighed: Parse, words: Words, chances: Chances, hearing: Hearing
) -> Parse | None:
    """Return the reading that is likeliest with how sure that is; None without a model.

    Parameters
    ----------
    first, weighed : Parse
        What the grammar read, before and after its own weighing.
    words : tuple of Word
        The line without fillers.
    """
    known = weights(hearing.language)
    if known is None or not chances or Stop() in weighed.acts or plain(weighed, chances):
        return None
    if is_name(weighed, words, hearing) and chance(weighed.acts, chances) >= PLAIN_FROM:
        return None
    pool = candidates(first, weighed, words, chances, hearing)
    ranked = ranking(pool, known.choice)
    best = ranked[0][1]
    found = weighed.score >= ACTING and names_step(weighed.acts, hearing)
    if found and not names_step(best.acts, hearing):
        # Names of known steps are found by the grammar alone, and seldom by chance.
        return None
    right = 1 / (1 + math.exp(-_told(known.sureness, sure_looks(ranked))))
    return Parse(best.acts, _score(best.acts, right, weighed, chances, words, hearing), "chosen")


def _score(
    acts: tuple[TeacherAct, ...],
    right: float,
    weighed: Parse,
    chances: Chances,
    words: Words,
    hearing: Hearing,
) -> float:
    """Return how sure a choice is: what the grammar is sure of stays so unless it is doubted."""
    known = weights(hearing.language)
    score = scaled(right, known.sure_at if known else 1.0)
    unheard = isinstance(weighed.acts[0], Unknown) or chatting(words, hearing)
    if unheard and not isinstance(acts[0], Unknown):
        score = min(score, GUESSED)
    if kind_of(acts) == "motion" and strange(acts, words, hearing):
        # It may tell how far or how fast: "more to the left, a pochino".
        score, weighed = min(score, DOUBTFUL), replace(weighed, score=min(weighed.score, DOUBTFUL))
    if acts != weighed.acts:
        return score
    trusted = trusted_from(weighed, hearing, len(words))
    trusted = min(trusted, known.exact_from) if known and weighed.exact else trusted
    if consenting(weighed, chances, hearing) or right >= trusted:
        return max(score, weighed.score)
    return score


def _kept_from(
    acts: tuple[TeacherAct, ...], weighed: Parse, words: Words, hearing: Hearing
) -> bool:
    """Tell what is no reading of an answer: "open the hand" names a step where one is asked.

    Nor is a yes or no told by words that stand in no list.
    """
    doubted = (swapped, turned)
    if any(tell(acts, weighed, words, hearing) for tell in doubted):
        return True
    if praised(weighed.acts, acts, words, hearing) or only_part(acts, weighed):
        return True
    if isinstance(weighed.acts[0], Explain) and wondering(words, hearing):
        return kind_of(acts) in ("named", "motion")
    if weighed.exact and shortened(acts, weighed.acts, hearing):
        return True
    if isinstance(weighed.acts[0], Unknown) and isinstance(acts[0], Inform):
        return weighed.score > _DOUBTED
    if isinstance(weighed.acts[0], Unknown) and isinstance(acts[0], Affirm | Deny | Approve):
        return unheard(acts, words, hearing)
    if not isinstance(weighed.acts[0], Inform):
        return False
    if _told_whole(words, hearing) and isinstance(acts[0], Inform):
        return True
    if hearing.listening.asked in FREE_ANSWERS or weighed.score >= LIKELY:
        beside = Inform if hearing.listening.asked == "facing" else _BESIDE_ANSWERS
        return not all(isinstance(act, beside) for act in acts)
    return any(isinstance(act, NOT_ANSWERS) for act in acts)


def _told_whole(words: Words, hearing: Hearing) -> bool:
    """Tell answers no part of which stands for them: where one stands, how big a thing is."""
    asked, numbers = hearing.listening.asked, hearing.book.numbers
    measured = asked == "body" and any(numbers.number((word.text,), 0) for word in words)
    return asked == "facing" or measured


def plain(weighed: Parse, chances: Chances) -> bool:
    """Tell a sentence of the phrasebook whose words tell its act: nothing is left to weigh.

    Where names or places are told, which words tell them is always weighed. What is listed as
    meaning nothing here, "thank you", is not heard as an answer.
    """
    told = kind_of(weighed.acts) in ("named", "placed", "inform")
    if not weighed.exact or (told and not is_nameless(weighed.acts)):
        return False
    nothing = weighed.acts == (Unknown(),) and weighed.score >= ACTING
    beside = isinstance(weighed.acts[0], ASIDE)
    return nothing or beside or chance(weighed.acts, chances) >= PLAIN_FROM


def scaled(right: float, sure_at: float) -> float:
    """Return a probability on the scale of confidence, where what is acted on begins higher."""
    if right < sure_at:
        return ACTING * right / sure_at
    return ACTING + (1 - ACTING) * (right - sure_at) / (1 - sure_at)


def ranking(
    pool: Sequence[Candidate], choice: Mapping[str, float]
) -> list[tuple[float, Candidate]]:
    """Return readings with their shares of the probability, the likeliest first."""
    worth = [_told(choice, one.looks) for one in pool]
    top = max(worth)
    odds = [math.exp(one - top) for one in worth]
    shares = (one / sum(odds) for one in odds)
    return sorted(zip(shares, pool, strict=True), key=lambda one: -one[0])


def sure_looks(ranked: Sequence[tuple[float, Candidate]]) -> Looks:
    """Return what tells how sure the first of ranked readings is."""
    share = min(max(ranked[0][0], _LEAST), 1 - _LEAST)
    second = ranked[1][0] if len(ranked) > 1 else 0.0
    return {
        **ranked[0][1].looks,
        "share": math.log(share / (1 - share)),
        "second": math.log(max(second, _LEAST)),
        "many": len(ranked) / _SPREAD,
    }


def _told(weights: Mapping[str, float], looks: Looks) -> float:
    return sum([weights.get(name, 0.0) * value for name, value in looks.items()])


def candidates(
    first: Parse, weighed: Parse, words: Words, chances: Chances, hearing: Hearing
) -> list[Candidate]:
    """Return the readings of a line with what they look like."""
    pool: dict[str, Candidate] = {}

    def add(acts: tuple[TeacherAct, ...], looks: Looks) -> None:
        acts = uncontradicted(unbent(acts, words, hearing), words, hearing)
        acts = by_parts(with_answer(acts, words, hearing), words, hearing)
        acts = without_nothing(acts, hearing)
        one = pool.setdefault(key_of(acts), Candidate(acts))
        one.looks = {**looks, **one.looks}

    add(
        weighed.acts,
        {
            "weighed": 1.0,
            "weighed_score": _logit(weighed.score),
            f"how_{weighed.how}": 1.0,
            "exact": float(weighed.exact),
        },
    )
    add(first.acts, {"first": 1.0, "first_score": _logit(first.score)})
    unlike = chances.get(_UNKNOWN, 1.0) >= _CHATTED_FROM
    chat = unlike and isinstance(weighed.acts[0], Unknown) and chatting(words, hearing)
    for acts, looks in [] if chat else _learned(weighed, words, chances, hearing):
        if Stop() not in acts and not _kept_from(acts, weighed, words, hearing):
            add(settled(Parse(acts, ACTING), hearing.listening).acts, looks)
    found = unpartial(list(pool.values()))
    look_at(found, weighed, words, chances, hearing)
    return found


def _learned(
    weighed: Parse, words: Words, chances: Chances, hearing: Hearing
) -> list[tuple[tuple[TeacherAct, ...], Looks]]:
    """Return what was learned to read in a line as a whole, and cut into clauses."""
    found: list[tuple[tuple[TeacherAct, ...], Looks]] = []
    also = [label_of(act) for act in weighed.acts] if len(weighed.acts) == 1 else []
    whole = learned(words, hearing, chances, also)
    whole.sort(key=lambda one: -(one.act_log + one.slots_log))
    for rank, one in enumerate(whole[:_MOST_WHOLE]):
        looks = {"whole": 1.0, "whole_act": one.act_log, "whole_slots": one.slots_log}
        found.append(((one.act,), {**looks, "whole_top": float(rank == 0)}))
    sure = max(chances.values()) >= CUT_BELOW
    for rank, cut in enumerate(
        sure_cuts(words, chances, hearing) if sure else cuts(words, hearing)
    ):
        looks = {"cut": 1.0, "cut_mean": cut.mean_log, "cut_least": cut.least_log}
        looks |= {"cut_marked": cut.marked, "cut_top": float(rank == 0), "cut_sure": float(sure)}
        found.append((tuple(one.act for one in cut.clauses), looks))
    return found


def _logit(share: float) -> float:
    share = min(max(share, 0.01), 0.99)
    return math.log(share / (1 - share))
