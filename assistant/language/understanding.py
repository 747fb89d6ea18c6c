"""What a sentence means: the words, then as said, respelled, or as it may have sounded.

Sentences of the phrasebook come first, then classes of words, then answers to the question
asked, then the likest known sentence. Confidence stays low wherever a word was left over.
"""

from __future__ import annotations

from dataclasses import replace

from assistant.language.answers import LISTS, OPEN, answer, trimmed, wrapped
from assistant.language.clauses import clause
from assistant.language.compounds import compound, corrected, once_more
from assistant.language.guessing import asks, guess, urgent
from assistant.language.naming import known_name
from assistant.language.parsing import (
    ACTING,
    DOUBTFUL,
    GUESSED,
    GUESS,
    LIKELY,
    SURE,
    Hearing,
    Parse,
    texts_of,
)
from assistant.language.phrasebook import Phrasebook, phrasebook
from assistant.language.repair import homophones, respelled, without_slips
from assistant.language.sentences import best_sentence
from assistant.language.stopping import has_stop_word
from assistant.language.words import Words, plain, spoken, words_of
from assistant.model.listening import Listening, Understanding
from assistant.model.teacher_acts import (
    AddSubtask,
    AdjustLast,
    AdjustSpeed,
    Affirm,
    Again,
    Approve,
    Asked,
    Assign,
    BeBrief,
    BeThorough,
    Cue,
    Deny,
    Explain,
    GoBack,
    Gripper,
    Help,
    Inform,
    KeyState,
    Load,
    Merge,
    MoveCut,
    Optional,
    Ordered,
    Pause,
    Quit,
    Redo,
    RemoveSubtask,
    Rename,
    RepeatLine,
    Required,
    Rotate,
    Save,
    SetPose,
    Show,
    Split,
    Start,
    Stop,
    TeacherAct,
    Translate,
    Undo,
    Unknown,
    Unordered,
)

_MOTION = (AdjustSpeed, Translate, Rotate, Gripper)
_NOT_ANSWERS = (*_MOTION, Cue, KeyState, Start, Again, Approve, SetPose, AdjustLast, Pause)
_STRUCTURE = (
    Rename,
    Optional,
    Required,
    Unordered,
    Ordered,
    AddSubtask,
    RemoveSubtask,
    Merge,
    Split,
    Assign,
    MoveCut,
)
_TELLING = frozenset(("i", "he", "she", "they", "my", "his", "her", "we", "did", "have"))
# What may be said instead of an answer, in words no sentence lists.
_ASIDE = (Help, RepeatLine, Explain, Show, Undo, Redo, BeBrief, BeThorough, Quit, GoBack, Load)
_YES_OR_NO = frozenset(
    ("confirm_tree", "confirm_segmentation", "did_you_mean", "ready", "unsaved", "pose", "order")
)
_PERSON = (("my", "name", "is"), ("i", "am", "called"), ("people", "call", "me"))
_REPAIRED = 0.97
MOST_WORDS = 60


def understand(text: str, listening: Listening, language: str = "english") -> Understanding:
    """Return what a teacher means by a line of text; never raises for any text.

    Parameters
    ----------
    text : str
        As typed or recognized.
    listening : Listening
        Where the dialogue stands.
    language : str
        Name of the phrasebook.
    """
    book = phrasebook(language)
    if listening.moving and has_stop_word(text, language):
        return Understanding((Stop(),), 1.0, plain(text))
    hearing = Hearing(book, listening, language)
    heard_words = words_of(text, book.contractions)
    if 0 < len(heard_words) <= 3:
        short = best_sentence(heard_words, hearing)
        if short is not None and short.score >= SURE and listening.asked not in OPEN:
            return Understanding(short.acts, short.score, spoken(heard_words))
    words = without_slips(_without_fillers(heard_words[:MOST_WORDS], book), book)
    if not words:
        return Understanding((Unknown(),), 0.9, "")
    if listening.asked not in OPEN:
        words = _once(words)
    heard, parse = _best(words, hearing)
    score = parse.score
    if any(isinstance(act, Stop) for act in parse.acts) and not has_stop_word(text, language):
        score = min(score, DOUBTFUL)
    return Understanding(parse.acts, round(score, 3), spoken(heard))


def _once(words: Words) -> Words:
    """Return the words without repetition: "again again", "do it again, do it again"."""
    texts = texts_of(words)
    for size in range(1, len(words) // 2 + 1):
        times, rest = divmod(len(words), size)
        if rest == 0 and times > 1 and texts == texts[:size] * times:
            return words[:size]
    return words


def _best(words: Words, hearing: Hearing) -> tuple[Words, Parse]:
    """Try the words as said, respelled, and as they may have sounded."""
    names = (*hearing.listening.subtasks, *hearing.listening.objects)
    spelled = respelled(words, hearing.book, names)
    best, heard = _meaning(words, hearing), words
    if hearing.listening.asked in OPEN and len(words) <= 2:
        stopping = _command(spelled, hearing)
        if stopping is not None and stopping.acts == (Stop(),) and stopping.score >= LIKELY:
            return spelled, replace(stopping, score=stopping.score * _REPAIRED)
    if best.score >= LIKELY and texts_of(spelled) == texts_of(words):
        return heard, best
    counting = hearing.listening.asked == "subtask_count" and len(words) > 4
    sounded = words if counting else homophones(words, hearing.book)
    for variant in dict.fromkeys(
        (sounded, spelled, spelled if counting else homophones(spelled, hearing.book))
    ):
        if variant == words or best.score >= LIKELY:
            continue
        parse = _meaning(variant, hearing)
        if parse.score * _REPAIRED > best.score and not isinstance(parse.acts[0], Unknown):
            best, heard = replace(parse, score=parse.score * _REPAIRED), variant
    if best.score < LIKELY and urgent(spelled, hearing):
        return spelled, Parse((Stop(),), LIKELY)
    if best.score < DOUBTFUL or isinstance(best.acts[0], Unknown):
        likely = guess(spelled, hearing)
        if likely is not None and likely.score > best.score - 0.1:
            best, heard = likely, spelled
    return heard, best


def _meaning(words: Words, hearing: Hearing) -> Parse:
    asked = hearing.listening.asked
    if asked in OPEN:
        return _answered(words, hearing)
    parse = _command(words, hearing)
    parse = _plain_answer(words, parse, hearing)
    named = _named_part(words, hearing)
    moving = parse is not None and isinstance(parse.acts[0], _MOTION)
    amount = {"bit", "little", "more", "much", "lot", "less", "slower", "faster"}
    if moving and parse is not None and amount & set(texts_of(words)):
        return parse
    if named is not None and (named.score >= SURE or moving):
        return named
    if parse is not None and parse.score > GUESS:
        return parse
    if named is not None:
        return named
    return parse or _unknown(words, hearing)


def _plain_answer(words: Words, parse: Parse | None, hearing: Hearing) -> Parse | None:
    """Return yes or no where a question was asked and only they are understood for sure."""
    asked, first = hearing.listening.asked, words[0].text
    plain = (*hearing.book.yes, *hearing.book.no)
    if (asked not in _YES_OR_NO and asked != "satisfied") or first not in plain:
        return parse
    if len(words) > 1 and not words[1].broken:
        return parse
    if parse is not None and parse.score >= LIKELY and parse.how in ("sentence", "motion"):
        return parse
    return Parse((Affirm() if first in hearing.book.yes else Deny(),), ACTING, "plain")


def _command(words: Words, hearing: Hearing) -> Parse | None:
    """Return the clause as a whole, corrected by its speaker, or cut into several."""
    repeated = once_more(words, hearing)
    if repeated is not None:
        return repeated
    whole = clause(words, hearing)
    if whole is not None and len(whole.acts) > 1 and whole.score >= LIKELY:
        parted = compound(words, hearing) if any(word.broken for word in words[1:]) else None
        whole = parted if parted is not None and len(parted.acts) >= len(whole.acts) else whole
    if whole is not None and whole.score >= LIKELY:
        return _one(whole, hearing.listening)
    for other in (corrected, compound):
        found = other(words, hearing)
        if found is not None and (whole is None or found.score > whole.score):
            whole = found
        if whole is not None and whole.score >= LIKELY:
            break
    return None if whole is None else _one(whole, hearing.listening)


def _one(parse: Parse, listening: Listening) -> Parse:
    """Drop a yes that only leads into the rest, and a no that answers nothing."""
    acts: tuple[TeacherAct, ...] = parse.acts
    if len(acts) > 1 and isinstance(acts[0], Affirm | Deny):
        same = {"ready": Start, "optional": Optional, "unsaved": Save}.get(listening.asked or "")
        if listening.asked is None or (same is not None and isinstance(acts[1], same)):
            acts = acts[1:]
    acts = tuple(act for act in acts if not isinstance(act, Unknown)) or acts[:1]
    if listening.asked in _YES_OR_NO:
        acts = tuple(Affirm() if isinstance(act, Approve) else act for act in acts)
    if all(isinstance(act, Affirm | Approve) for act in acts):
        acts = acts[:1] if listening.asked else acts[-1:]
    unique = tuple(dict.fromkeys(acts))
    if unique == (Unordered(),) and listening.stage == "practice":
        return Parse(unique, DOUBTFUL, parse.how)
    return Parse(unique, parse.score, parse.how)


def _answered(words: Words, hearing: Hearing) -> Parse:
    """Return an answer to an open question, unless the words are a command of their own."""
    asked: Asked = hearing.listening.asked or "goal"
    bare = trimmed(words, hearing.book)
    if texts_of(bare)[:3] in _PERSON or texts_of(words)[:3] in _PERSON:
        return Parse((Unknown(),), 0.8)
    for told in dict.fromkeys((words, bare)):
        parse = _command(told, hearing)
        if asked == "subtask_count" and parse is not None and _changing(parse):
            return parse
        if (
            parse is not None
            and parse.score >= LIKELY
            and not _answering(parse, bare, asked, hearing)
        ):
            return parse
    texts = set(texts_of(words))
    telling = words[0].text in _TELLING and len(words) > 3
    chatting = texts & hearing.book.chat and telling and not wrapped(bare, asked, hearing.book)
    if not wrapped(bare, asked, hearing.book):
        spelled = trimmed(respelled(words, hearing.book, ()), hearing.book)
        words = spelled if wrapped(spelled, asked, hearing.book) else words
        bare = trimmed(words, hearing.book)
    asking = bare and asks(bare) and not wrapped(bare, asked, hearing.book)
    if chatting or asking:
        return Parse((Unknown(),), 0.7)
    found = _corrected_answer(words, hearing)
    if found is None:
        return _unknown(words, hearing)
    if asked in ("missing_step", "which") and isinstance(found.value, str):
        names = hearing.listening.subtasks
        known = known_name(tuple(found.value.split()), names, hearing.book.numbers)
        found = Inform(known or found.value)
    return Parse((found,), _answer_score(found, words, asked, hearing), "answer")


def _answer_score(found: Inform, words: Words, asked: Asked, hearing: Hearing) -> float:
    """Return how sure an answer is: short, plainly wrapped, no word of wrapping left in it."""
    value, bare = found.value, trimmed(words, hearing.book)
    if asked != "task_name" and {"called", "named"} & set(texts_of(words)) and asked in LISTS:
        return DOUBTFUL
    if isinstance(value, int):
        return 0.93 if len(words) <= 8 else GUESSED
    wraps = {phrase[0] for phrase in hearing.book.wrapping["wraps"]}
    names = [value.split()] if isinstance(value, str) else [one.split() for one in value]
    plain = wrapped(bare, asked, hearing.book) or len(bare) == sum(map(len, names))
    plain = plain or (asked in LISTS and len(names) > 1)
    if asked in ("goal", "facing"):
        return (
            0.93
            if plain and len(words) <= 14 and names[0][:1] and names[0][0] not in wraps
            else GUESSED
        )
    marked = isinstance(value, str) and sum(word.broken for word in bare[1:]) > 0
    names = [name for name in names if name] or [["it"]]
    strange = any(name[0] in wraps or set(name) & hearing.book.impure for name in names)
    long = max(map(len, names)) > 4 or len(words) > 10
    return GUESSED if strange or long or marked or not plain else 0.93


def _changing(parse: Parse) -> bool:
    known = isinstance(parse.acts[0], Rename | AddSubtask | RemoveSubtask)
    return known and parse.how != "named" and parse.score >= 0.8


def _answering(parse: Parse, bare: Words, asked: Asked, hearing: Hearing) -> bool:
    """Tell acts whose words may as well be an answer, such as the name of a step."""
    act = parse.acts[0]
    if parse.how in ("frame", "request") and (
        not isinstance(act, _ASIDE) or wrapped(bare, asked, hearing.book)
    ):
        return True
    if isinstance(act, Unknown):
        return wrapped(bare, asked, hearing.book)
    if isinstance(act, _STRUCTURE):
        return parse.score < SURE
    return isinstance(act, _NOT_ANSWERS)


def _corrected_answer(words: Words, hearing: Hearing) -> Inform | None:
    asked = hearing.listening.asked
    if asked is None:
        return None
    texts = texts_of(words)
    for phrase in hearing.book.correction:
        if asked == "goal" and len(phrase) == 1:
            continue
        for at in range(len(texts) - len(phrase) - 1, 0, -1):
            behind = words[at + len(phrase) :]
            marked = words[at].broken or len(phrase) > 1
            if texts[at : at + len(phrase)] == phrase and marked and behind:
                found = answer(behind, asked, hearing.book)
                if found is not None:
                    return found
    return answer(words, asked, hearing.book)


def _named_part(words: Words, hearing: Hearing) -> Parse | None:
    """Return the step named in answer to whether some may be skipped."""
    if hearing.listening.asked != "optional":
        return None
    bare = tuple(w for w in trimmed(words, hearing.book) if w.text not in ("only", "just", "yes"))
    if not bare or len(bare) > 6:
        return None
    found = known_name(texts_of(bare), hearing.listening.subtasks, hearing.book.numbers)
    if found is not None:
        return Parse((Optional(found),), SURE)
    text = " ".join(w.said for w in bare if w.said and w.text not in ("the", "a"))
    return Parse((Optional(text),), 0.7) if text else None


def _unknown(words: Words, hearing: Hearing) -> Parse:
    chat = set(texts_of(words)) & hearing.book.chat
    return Parse((Unknown(),), 0.8 if chat else 0.6)


def _without_fillers(words: Words, book: Phrasebook) -> Words:
    kept = tuple(word for word in words if (word.text,) not in book.fillers)
    return kept or words
