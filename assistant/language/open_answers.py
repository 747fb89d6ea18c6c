"""Answers to open questions, and what is said instead of an answer."""

from __future__ import annotations

from assistant.language.answers import LISTS, answer, trimmed, wrapped
from assistant.language.commands import command, unknown
from assistant.language.guessing import asks
from assistant.language.hints import hints
from assistant.language.naming import known_name
from assistant.language.parsing import (
    DOUBTFUL,
    GUESSED,
    LIKELY,
    NAMED,
    SURE,
    Hearing,
    Parse,
    texts_of,
)
from assistant.language.phrasebook import Phrasebook
from assistant.language.repair import respelled
from assistant.language.sides import told_side
from assistant.language.words import Words, spoken
from assistant.language.wrappings import NAMES, said_of
from assistant.model.teacher_acts import (
    AddSubtask,
    AdjustLast,
    AdjustSpeed,
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
    SetPose,
    Show,
    Split,
    Start,
    Translate,
    Undo,
    Unknown,
    Unordered,
)

MOTION = (AdjustSpeed, Translate, Rotate, Gripper)
NOT_ANSWERS = (*MOTION, Cue, KeyState, Start, Again, Approve, SetPose, AdjustLast, Pause)
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
ASIDE = (Help, RepeatLine, Explain, Show, Undo, Redo, BeBrief, BeThorough, Quit, GoBack, Load)
_TOLD = 0.93


def goalless(words: Words, hearing: Hearing) -> Parse | None:
    """Return the answer that there is no goal, told in the words the robot offers for it."""
    offered = {one.lower() for one in hints("nothing", hearing.language)}
    told = spoken(words)
    if hearing.listening.asked != "goal" or told not in offered:
        return None
    return Parse((Inform(told),), SURE, "answer")


def answered(words: Words, hearing: Hearing) -> Parse:
    """Return an answer to an open question, unless the words are a command of their own."""
    asked: Asked = hearing.listening.asked or "goal"
    book = hearing.book
    bare = trimmed(words, book)
    persons = book.wrapping.get("persons", ())
    if any(texts_of(told)[: len(one)] == one for told in (bare, words) for one in persons):
        return Parse((Unknown(),), 0.8)
    for told in dict.fromkeys((words, bare)):
        parse = command(told, hearing)
        if parse is not None and _instead(parse, bare, asked, hearing):
            return parse
    chatting = _chatting(words, bare, asked, book)
    words = _spelled(words, asked, hearing)
    bare = said_of(trimmed(words, book), asked, book)
    asking = bare and asks(bare, book) and not wrapped(bare, asked, book)
    if chatting or asking:
        return Parse((Unknown(),), 0.7)
    found = _corrected_answer(words, hearing)
    if found is None:
        return unknown(words, hearing)
    if asked in ("missing_step", "which") and isinstance(found.value, str):
        names = hearing.listening.subtasks
        found = Inform(known_name(tuple(found.value.split()), names, book) or found.value)
    return Parse((found,), _answer_score(found, words, asked, hearing), "answer")


def _chatting(words: Words, bare: Words, asked: Asked, book: Phrasebook) -> bool:
    """Tell people who tell of other matters, in words of such."""
    if asked == "subtask_count" or not set(texts_of(words)) & book.chat:
        return False
    telling = words[0].text in book.leading_words("telling") and len(words) > 3
    return telling and not wrapped(bare, asked, book)


def _instead(parse: Parse, bare: Words, asked: Asked, hearing: Hearing) -> bool:
    """Tell what is said instead of an answer."""
    if asked == "missing_step" and _placed(parse):
        return True
    if asked == "subtask_count" and _changing(parse):
        return True
    if asked == "which" and parse.acts[0] == Deny() and len(bare) > 2:
        # "No, I meant the other one" names one.
        return False
    return parse.score >= LIKELY and not _answering(parse, bare, asked, hearing)


def _spelled(words: Words, asked: Asked, hearing: Hearing) -> Words:
    """Return the words respelled where more of them turn out to be wrapping: "is caled"."""
    bare, book = trimmed(words, hearing.book), hearing.book
    spelled = trimmed(respelled(words, book, ()), book)
    if texts_of(spelled) == texts_of(bare) or not wrapped(spelled, asked, book):
        return words
    if not wrapped(bare, asked, book):
        return spelled
    before, behind = answer(words, asked, book), answer(spelled, asked, book)
    told = before is not None and behind is not None
    return spelled if told and len(str(behind)) < len(str(before)) else words


def _answer_score(found: Inform, words: Words, asked: Asked, hearing: Hearing) -> float:
    """Return how sure an answer is: short, plainly wrapped, no word of wrapping left in it."""
    value, book = found.value, hearing.book
    texts = set(texts_of(words))
    if asked in LISTS and texts & book.leading_words("called"):
        return DOUBTFUL
    if isinstance(value, int):
        return _TOLD if len(words) <= 8 else GUESSED
    if asked == "missing_step" and texts & book.leading_words("placing"):
        return GUESSED
    bare = trimmed(words, book)
    told = told_side(bare, asked, book) if asked in NAMES else bare
    names = [value.split()] if isinstance(value, str) else [one.split() for one in value]
    plain = wrapped(bare, asked, book) or len(bare) == sum(map(len, names)) or len(told) < len(bare)
    plain = plain or (asked in LISTS and len(names) > 1)
    wraps = book.leading_words("wraps")
    if asked in ("goal", "facing"):
        begins = bool(names[0]) and names[0][0] not in wraps
        return _TOLD if plain and begins and len(words) <= 14 else GUESSED
    names = [name for name in names if name] or [[*book.little["pronoun"]]]
    marked = isinstance(value, str) and any(word.broken for word in told[1:])
    strange = any(name[0] in wraps or set(name) & book.impure for name in names)
    strange = strange or (asked in LISTS and any(_odd(name, book) for name in names))
    long = max(map(len, names)) > 4 or len(words) > 10
    return GUESSED if strange or long or marked or not plain else _TOLD


def _odd(name: list[str], book: Phrasebook) -> bool:
    """Tell an item of a list with words that name no thing: "more nothing", "naturally"."""
    little = book.empty - book.leading_words("prepositions") - book.leading_words("qualities")
    hollow = little | book.yes | book.no | book.chat | book.leading_words("hollow")
    return any(
        text in hollow
        or (bool(book.little.how) and text.endswith(book.little.how) and len(text) > 5)
        for text in name
    )


def _changing(parse: Parse) -> bool:
    known = isinstance(parse.acts[0], Rename | AddSubtask | RemoveSubtask)
    return known and parse.how != "named" and parse.score >= 0.8


def _placed(parse: Parse) -> bool:
    """Tell a missing step that is named with where it belongs."""
    act = parse.acts[0]
    return isinstance(act, AddSubtask) and bool(act.before or act.after) and parse.score >= NAMED


def _answering(parse: Parse, bare: Words, asked: Asked, hearing: Hearing) -> bool:
    """Tell acts whose words may as well be an answer, such as the name of a step."""
    act = parse.acts[0]
    if parse.how in ("frame", "request") and (
        not isinstance(act, ASIDE) or wrapped(bare, asked, hearing.book)
    ):
        return True
    if isinstance(act, Unknown):
        return wrapped(bare, asked, hearing.book)
    if isinstance(act, _STRUCTURE):
        return parse.score < SURE
    return isinstance(act, NOT_ANSWERS)


def _corrected_answer(words: Words, hearing: Hearing) -> Inform | None:
    asked = hearing.listening.asked
    if asked is None:
        return None
    texts = texts_of(words)
    for phrase in hearing.book.correction:
        if asked == "goal" and len(phrase) == 1:
            continue
        for at in range(len(texts) - len(phrase) - 1, 0, -1):
            if texts[at : at + len(phrase)] != phrase:
                continue
            behind = words[at + len(phrase) :]
            marked = words[at].broken or len(phrase) > 1
            kept = any(texts[at : at + len(k)] == k for k in hearing.book.not_taken_back)
            if marked and behind and not kept:
                found = answer(behind, asked, hearing.book)
                if found is not None:
                    return found
    return answer(words, asked, hearing.book)
