"""Sentences of several clauses, and speakers who correct themselves within one."""

from __future__ import annotations

from itertools import pairwise

from assistant.language.clauses import clause
from assistant.language.contrasts import GROUPS
from assistant.language.located import correction
from assistant.language.merging import CORRECTIONS, merged
from assistant.language.parsing import (
    ACTING,
    AGAIN,
    LIKELY,
    SURE,
    Hearing,
    Parse,
    texts_of,
)
from assistant.language.tags import tags_of
from assistant.language.words import Word, Words
from assistant.model.teacher_acts import (
    AdjustSpeed,
    Affirm,
    Again,
    Deny,
    NewSetup,
    Pause,
    Redo,
    Resume,
    Rotate,
    Start,
    Stop,
    TeacherAct,
    Translate,
    Undo,
    Unknown,
)

_AMONG_TALK = (*CORRECTIONS, Again, NewSetup, Pause, Redo, Resume, Start, Undo)
_IDLE = (Unknown, Affirm, Deny)
_PLAIN = (AdjustSpeed, Rotate, Translate)


def compound(words: Words, hearing: Hearing) -> Parse | None:
    """Return the acts of clauses joined by commas or joining words; all must be understood."""
    stop = _stopped(words, hearing)
    words = _gathered(words, hearing)
    joined = _joined(words, hearing, 4)
    if stop is not None and (joined is None or joined.score < LIKELY):
        return stop
    return joined or _partly(words, hearing)


def _gathered(words: Words, hearing: Hearing) -> Words:
    """Return the words without marks before a lone amount: "up, a little, and slower"."""
    cuts = [at for at in range(1, len(words)) if words[at].broken]
    found = list(words)
    for start, end in pairwise((*cuts, len(words))):
        part, before = words[start:end], words[:start]
        kinds = {tag.kind for tag in tags_of(texts_of(part), hearing.book, hearing.names)}
        kinds -= {"skip", "empty"}
        amount = bool(kinds & GROUPS["amount"]) and kinds <= GROUPS["amount"]
        told = [tag.kind for tag in tags_of(texts_of(before), hearing.book, hearing.names)]
        if amount and set(told) & GROUPS["way"] and not set(told) & GROUPS["amount"]:
            found[start] = Word(words[start].text, words[start].said)
    return tuple(found)


def united(words: Words, hearing: Hearing) -> Words:
    """Return the words with a unit said once at each number: "two cm left and one up"."""
    texts, numbers, motion = texts_of(words), hearing.book.numbers, hearing.book.motion
    found: list[Word] = []
    unit, at = "", 0
    while at < len(words):
        quantity = numbers.quantity(texts, at)
        end = quantity.end if quantity else at + 1
        found.extend(words[at:end])
        counted = quantity.kind == "" if quantity else _lone(words, at, hearing)
        if quantity is not None and quantity.kind == "m":
            unit = texts[end - 1] if texts[end - 1] in numbers.units else ""
        elif unit and counted:
            ways = (motion.get(texts[end : end + size], "") for size in (3, 2, 1))
            if next((kind for kind in ways if kind), "") in GROUPS["way"]:
                found.append(Word(unit, ""))
        at = end
    return tuple(found)


def _lone(words: Words, at: int, hearing: Hearing) -> bool:
    """Tell an article that stands for one of what was measured: "and one up"."""
    joints, articles = hearing.book.little["clause_joints"], hearing.book.numbers.articles
    begun = at > 0 and (words[at].broken or words[at - 1].text in joints)
    return begun and words[at].text in articles


def _partly(words: Words, hearing: Hearing) -> Parse | None:
    """Return what some stretches ask if the others mean nothing here, as a guess."""
    parting = hearing.book.little["parting"]
    cuts = [
        at
        for at in range(1, len(words))
        if words[at].broken
        or (words[at].text in parting and words[at - 1].text not in hearing.book.negating)
    ]
    if not cuts:
        return None
    if set(texts_of(words)) & hearing.book.chat:
        return _beside_chat(words, hearing)
    found: list[TeacherAct] = []
    best: Parse | None = None
    missed = 0
    for start, end in pairwise((0, *cuts, len(words))):
        part = words[start + (words[start].text in parting) : end]
        parse = clause(part, hearing) if part else None
        if parse is not None and parse.score >= 0.78 and not isinstance(parse.acts[0], _IDLE):
            found.extend(parse.acts)
            best = parse if best is None or parse.score >= best.score else best
        missed += parse is None or parse.score < ACTING
    acts = tuple(dict.fromkeys(found))
    if len(acts) > 1 and not all(isinstance(act, CORRECTIONS) for act in acts):
        acts = best.acts if best is not None and best.score >= SURE - 0.01 else acts[-1:]
    if not acts or (missed > 3 and not _asked_for(words, hearing)):
        return None
    return Parse(acts, 0.75 if missed else 0.86, "partly")


def _beside_chat(words: Words, hearing: Hearing) -> Parse | None:
    """Return what the first or the last clause asks by itself, talk beside it."""
    breaks = [at for at in range(1, len(words)) if words[at].broken]
    ends = (words[: breaks[0]], words[breaks[-1] :]) if breaks else ()
    found: list[TeacherAct] = []
    for part in ends:
        parse = None if set(texts_of(part)) & hearing.book.chat else clause(part, hearing)
        if (
            parse is not None
            and parse.score >= SURE - 0.01
            and isinstance(parse.acts[0], _AMONG_TALK)
        ):
            found.extend(parse.acts)
    acts = merged(tuple(dict.fromkeys(found)))
    return Parse(acts, 0.75, "partly") if len(acts) == 1 and acts != (Stop(),) else None


def _asked_for(words: Words, hearing: Hearing) -> bool:
    return bool(hearing.book.little["asking_for"] & set(texts_of(words)))


def _joined(words: Words, hearing: Hearing, depth: int) -> Parse | None:
    if depth == 0 or len(words) > 40:
        return None
    joints = hearing.book.little["clause_joints"]
    for at in range(1, len(words)):
        joint = words[at].text in joints
        if not (joint or words[at].broken):
            continue
        first = clause(words[:at], hearing)
        if first is None or first.score < LIKELY:
            continue
        rest = words[at + 1 :] if joint else words[at:]
        while len(rest) > 1 and rest[0].text in joints:
            rest = rest[1:]
        if not rest:
            continue
        second = clause(rest, hearing)
        if second is None or second.score < LIKELY:
            second = _joined(rest, hearing, depth - 1)
        if second is not None and second.score >= LIKELY:
            return Parse(first.acts + second.acts, min(first.score, second.score))
    return None


def once_more(words: Words, hearing: Hearing) -> Parse | None:
    """Read "again, more left": a correction, then the practice once more."""
    texts, little = texts_of(words), hearing.book.little
    joints = little["clause_joints"]
    for phrase in hearing.book.again:
        begins, ends = texts[0] == phrase[0], texts[-1] == phrase[-1]
        if not (begins or ends):
            continue
        size = len(phrase)
        if begins and texts[:size] == phrase and len(texts) > size:
            rest = words[size:]
            while len(rest) > 1 and rest[0].text in joints | little["again_with"]:
                rest = rest[1:]
        elif ends and texts[-size:] == phrase and len(texts) > size + 1:
            rest = words[:-size]
            joined = rest[-1].text in joints
            if not (joined or words[-size].broken):
                continue
            while rest and rest[-1].text in joints:
                rest = rest[:-1]
        else:
            continue
        parse = clause(rest, hearing) if rest else None
        if parse is None or parse.score < LIKELY:
            parse = compound(rest, hearing) if rest else None
        if parse is not None and parse.score >= LIKELY and isinstance(parse.acts[0], CORRECTIONS):
            # "Repeat it one more time" asks for no more of the last correction.
            plain = parse.how in ("sentence", "motion") and isinstance(parse.acts[0], _PLAIN)
            how = AGAIN if plain and len(parse.acts) == 1 else parse.how
            return Parse((*parse.acts, Again()), parse.score, how)
    return None


def _stopped(words: Words, hearing: Hearing) -> Parse | None:
    """Return stop if the first or the last clause by itself says so, whatever the rest is."""
    breaks = [at for at in range(1, len(words)) if words[at].broken]
    if not breaks:
        return None
    for part in (words[: breaks[0]], words[breaks[-1] :]):
        parse = clause(part, hearing)
        if parse is not None and parse.acts == (Stop(),) and parse.score >= LIKELY:
            return parse
    return None


def corrected(words: Words, hearing: Hearing) -> Parse | None:
    """Return what is left when a speaker takes back what came before."""
    texts = texts_of(words)
    told = set(texts)
    for phrase in hearing.book.correction:
        if phrase[0] not in told:
            continue
        size = len(phrase)
        for at in range(len(texts) - size - 1, -1, -1):
            if texts[at : at + size] != phrase or not words[at + size :]:
                continue
            found = _replaced(words[:at], words[at + size :], hearing, marked=words[at].broken)
            if found is not None:
                return found
    return None


def _replaced(before: Words, behind: Words, hearing: Hearing, *, marked: bool) -> Parse | None:
    """Put the new words where the same classes of words stood before."""
    said = tags_of(texts_of(before), hearing.book, hearing.names)
    new = tags_of(texts_of(behind), hearing.book, hearing.names)
    groups = [group for group in GROUPS.values() if any(tag.kind in group for tag in new)]
    if groups and any(tag.kind in group for tag in said for group in groups[:1]):
        kept = [t for t in said if not any(t.kind in g for g in groups)]
        kept_words = tuple(word for tag in kept for word in tag.words)
        merged = correction((*kept_words, *texts_of(behind)), hearing)
        if merged is not None and merged.score >= LIKELY:
            return Parse(merged.acts, merged.score - 0.02)
    parse = clause(behind, hearing)
    if parse is None or parse.score < LIKELY:
        return None
    earlier = clause(before, hearing) if before else None
    understood = not before or (earlier is not None and earlier.score >= LIKELY)
    if not (marked or understood):
        return None
    return Parse(parse.acts, SURE - 0.04 if understood else 0.8)
