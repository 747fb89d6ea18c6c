"""What holds where a speaker says one thing and its opposite: the last word.

"Clockwise, hmm, counterclockwise rather" turns one way only, and "yes, no, sorry, no" is a no.
"""

from __future__ import annotations

from itertools import pairwise

from assistant.language.clauses import clause
from assistant.language.commands import YES_OR_NO
from assistant.language.parsing import GUESSED, LIKELY, SURE, Hearing, Parse, texts_of
from assistant.language.tags import OPPOSITE
from assistant.language.words import Words
from assistant.model.teacher_acts import Affirm, Approve, Deny, Rotate, TeacherAct, Translate

_AWAY = frozenset(("left", "right", "up", "down"))
"""Ways that are no word for beginning, as "forward" is."""


def last_answer(words: Words, hearing: Hearing) -> Parse | None:
    """Return the last yes or no of a line that says both and nothing else."""
    book, texts = hearing.book, texts_of(words)
    if hearing.listening.asked not in YES_OR_NO | {"satisfied"}:
        return None
    taking_back = {text for phrase in book.correction for text in phrase} | book.empty
    told = [text for text in texts if text in book.yes | book.no]
    other = set(texts) - book.yes - book.no - taking_back
    if other or not (set(told) & book.yes and set(told) & book.no) or not words[-1].broken:
        return None
    if texts[-1] not in told:
        return None
    return Parse((Affirm() if texts[-1] in book.yes else Deny(),), LIKELY)


def assured(words: Words, hearing: Hearing) -> Parse | None:
    """Return the yes of "no no, the plan is right": the no only waves a doubt away."""
    book, size = hearing.book, 0
    while size < len(words) and words[size].text in book.no:
        size += 1
    if hearing.listening.asked not in _DOUBTED or not 0 < size < len(words) - 1:
        return None
    rest = texts_of(words[size:])
    picked = any(book.numbers.ordinal(rest, at) for at in range(len(rest)))
    if picked or not words[size].broken:
        return None
    found = clause(words[size:], hearing)
    good = found is not None and found.acts in ((Approve(),), (Affirm(),))
    return (
        Parse((Affirm(),), GUESSED, "plain") if found and good and found.score >= _HEARD else None
    )


_HEARD = 0.7
_DOUBTED = frozenset(("confirm_tree", "confirm_segmentation", "satisfied"))
"""Questions whether something is right, not whether something is to be done."""


def uncontradicted(
    acts: tuple[TeacherAct, ...], words: Words, hearing: Hearing
) -> tuple[TeacherAct, ...]:
    """Return acts without a motion whose opposite follows, where that takes it back.

    "Put the block down 2 cm higher" is one motion, too: down is how a block is put.
    """
    if len(acts) < 2 or _joined(words, hearing):
        return acts
    marks = {phrase[0] for phrase in hearing.book.correction if len(phrase) == 1}
    marked = bool(marks & set(texts_of(words)))
    broken = any(word.broken for word in words[1:])
    taken = {
        n
        for n, (one, two) in enumerate(pairwise(acts))
        if _opposite(one, two, marked) and (broken or not _bare(two))
    }
    return tuple(act for n, act in enumerate(acts) if n not in taken)


def _joined(words: Words, hearing: Hearing) -> bool:
    """Tell whether one thing is to be done and then another: no "and" of a number joins."""
    book, texts = hearing.book, texts_of(words)
    numbers, joints = book.numbers, book.little["clause_joints"]
    at = 0
    while at < len(texts):
        found = numbers.number(texts, at)
        if found is None and texts[at] in joints:
            return True
        at = found[1] if found else at + 1
    return False


def _opposite(one: TeacherAct, other: TeacherAct, marked: bool) -> bool:
    """Tell two motions one way and back: marked as taken back, or the first told in no detail."""
    if not isinstance(one, Translate | Rotate) or type(one) is not type(other):
        return False
    if not isinstance(other, Translate | Rotate) or one.where != other.where:
        return False
    return OPPOSITE.get(one.direction) == other.direction and (marked or _bare(one))


def _bare(act: TeacherAct) -> bool:
    """Tell a motion of which nobody said how far."""
    if not isinstance(act, Translate | Rotate):
        return False
    told = act.distance_m if isinstance(act, Translate) else act.angle_deg
    return told is None and act.degree is None


def commanded(parse: Parse, words: Words, hearing: Hearing) -> bool:
    """Tell a motion told in full where a start was asked for: "go up" is no word for it."""
    if hearing.listening.asked != "ready" or parse.how != "motion" or parse.score < SURE - 0.02:
        return False
    texts, book = texts_of(words), hearing.book
    said = texts[0] in book.yes or set(texts) & book.leading_words("subjects")
    ways = [act for act in parse.acts if isinstance(act, Translate | Rotate)]
    whole = bool(ways) and len(ways) == len(parse.acts)
    return whole and len(texts) > 1 and not said and all(a.direction in _AWAY for a in ways)
