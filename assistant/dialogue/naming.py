"""Names and lists of steps and things out of a teacher's answer."""

from __future__ import annotations

import re
from collections.abc import Sequence

from assistant.language.hints import hints, phrase_pattern
from assistant.language.phrasebook import phrasebook
from assistant.language.slips import without_slips

LONGEST_NAME = 8
"""Words of a task's name; more is asked about."""
SHORTEST_NAME = 3
"""Letters of a task's name; fewer are asked about."""

QUOTES = " \t\"'.,;:!?„“”«»"

Value = str | int | tuple[str, ...]


def text_of(value: Value) -> str:
    """Return an answer as one text."""
    return ", ".join(value) if isinstance(value, tuple) else str(value)


def number_of(value: Value, language: str = "english") -> int | None:
    """Return an answer as a count, or None if it tells none."""
    if isinstance(value, int):
        return value
    text = text_of(value).strip().lower()
    numbers: dict[str, int] = hints("numbers", language)
    found = re.search(r"-?\d+", text)
    if found:
        return int(found.group())
    return next((numbers[word] for word in re.findall(r"[^\W\d_]+", text) if word in numbers), None)


def is_size(value: Value) -> bool:
    """Whether an answer is a size or a length, such as "30 x 20 x 1" or "10 cm"."""
    return re.search(r"\d\s*(?:[xX*]\s*\d|[mc]?m\b)", text_of(value)) is not None


def tidy(name: str, language: str = "english") -> str:
    """Return a name without quotes, end marks and openers such as "first you"."""
    text = re.sub(r"\s+", " ", name).strip(QUOTES)
    openers: list[str] = hints("openers", language)
    stripped = True
    while stripped:
        stripped = False
        for opener in openers:
            hit = phrase_pattern(opener).match(text.lower())
            if hit and hit.end() < len(text):
                text = text[hit.end() :].strip(" ,:")
                stripped = True
    return text


def steps_in(value: Value, room: int, language: str = "english") -> tuple[str, ...]:
    """Return the names in an answer.

    Parameters
    ----------
    value : text, integer or tuple of text
    room : int
        How many names are still missing; "a and b" is two only if that fits.
    language : str
    """
    if isinstance(value, tuple):
        return _told(value, language)
    pieces = _split(str(value), hints("separators", language))
    joins = hints("joins", language)
    if room > 1:
        # "pick it up, move it over and put it down": the last "and" joins a list.
        parted = [part for piece in pieces for part in _split(piece, joins)]
        # "go down and let go" is two steps; "pick and place" is one name.
        long = [part for part in parted if len(part.split()) > 1]
        plain = bool(long) and all(
            part in long or begins_or_ends_with_verb(part, language) for part in parted
        )
        if len(parted) > len(pieces) and (len(parted) == room or len(pieces) > 1) and plain:
            pieces = parted
        elif len(pieces) == 1:
            pieces = _at_verbs(pieces[0], room, language) or pieces
    return _told(pieces, language)


def _told(pieces: Sequence[str], language: str) -> tuple[str, ...]:
    """Return the tidied names of which some tell more than "carefully, please"."""
    names = tuple(filter(None, (tidy(piece, language) for piece in pieces)))
    return tuple(name for name in names if not is_no_step(name, language)) or names


def _verbs(language: str) -> set[str]:
    """Return the words that begin what a teacher says of an action."""
    entries = (*hints("actions", language), *hints("guesses", language))
    ends = (0, -1) if hints("verb_last", language) else (0,)
    return {phrase.split()[end] for one in entries for phrase in one["phrases"] for end in ends}


def action_words(language: str) -> set[str]:
    """Return the words of what a teacher says of an action."""
    entries = (*hints("actions", language), *hints("guesses", language))
    return {word for one in entries for phrase in one["phrases"] for word in phrase.split()}


def listed_steps(text: str, room: int = 2, language: str = "english") -> tuple[str, ...]:
    """Return the steps of a text that plainly lists several, each beginning with its verb."""
    steps = steps_in(text, room, language)
    plain = all(begins_or_ends_with_verb(step, language) for step in steps)
    return steps if len(steps) > 1 and plain else ()


def just_as_many(text: str, count: int, language: str = "english") -> tuple[str, ...]:
    """Return the steps of a list that is as long as was said: not each verb need be known then.

    "Two steps, grab the sponge and wipe the board", but nothing of "two steps, I think".
    """
    if count < 2 or "?" in text:
        return ()
    pieces = _split(text, (*hints("separators", language), *hints("joins", language)))
    steps = tuple(filter(None, (tidy(piece, language) for piece in pieces)))
    known = any(begins_or_ends_with_verb(step, language) for step in steps)
    return steps if len(set(steps)) == count == len(steps) and known else ()


def begins_or_ends_with_verb(step: str, language: str) -> bool:
    """Whether a step's verb stands where the language puts it: "lift the block", "Block heben"."""
    words = without_slips(step, (), language).lower().split()
    verbs = _verbs(language)
    return bool(words) and (words[0] in verbs or words[-1] in verbs)


def is_lone_verb(text: str, language: str, *, ending: bool) -> bool:
    """Tell a verb alone, by the ending of its language if asked so: "greifen" is no thing.

    A language whose verbs have no ending of their own has nouns that look the same: "clutch".
    """
    word = text.lower().strip(QUOTES)
    ends = word.endswith(phrasebook(language).bends.verbs or "?") if ending else True
    return word in _verbs(language) and ends


def _at_verbs(text: str, room: int, language: str) -> list[str]:
    """Return the steps of a list heard without commas, if just as many are missing."""
    if hints("verb_last", language):
        return []
    verbs = _verbs(language)
    pieces: list[list[str]] = []
    for word in text.split():
        if word.lower() in verbs or not pieces:
            pieces.append([])
        pieces[-1].append(word)
    joints = {joint.strip() for joint in hints("joins", language)}
    steps = [" ".join(piece[:-1] if piece[-1] in joints else piece) for piece in pieces]
    return steps if len(steps) == room and all(len(step.split()) > 1 for step in steps) else []


def as_said(value: str, text: str) -> str:
    """Return an answer with the commas and capitals it was typed with, if they are there."""
    wanted = re.findall(r"[\w'-]+", value.lower())
    found = list(re.finditer(r"[\w'-]+", text))
    for at in range(len(found) - len(wanted) + 1):
        if [one.group().lower() for one in found[at : at + len(wanted)]] == wanted and wanted:
            return text[found[at].start() : found[at + len(wanted) - 1].end()]
    return value


def name_and_steps(text: str, language: str = "english") -> tuple[str, tuple[str, ...]]:
    """Return a task's name and the steps told in the same breath, if any were."""
    pieces = _split(text, hints("separators", language))
    opened = any(tidy(piece, language).lower() != piece.strip(" .").lower() for piece in pieces[1:])
    if len(pieces) < 2 or not opened:
        return tidy_name(text), ()
    return tidy_name(pieces[0]), tuple(
        filter(None, (tidy(piece, language) for piece in pieces[1:]))
    )


def tidy_name(name: str) -> str:
    """Return a name without quotes and end marks."""
    return re.sub(r"\s+", " ", name).strip(QUOTES)


def is_odd(name: str, language: str = "english") -> bool:
    """Whether a name is more likely something else: a question, a word of talk, a sentence."""
    words = re.findall(r"[^\W\d_]+", name.lower())
    odd: list[str] = hints("no_task_name", language)
    if not words or "?" in name or len("".join(words)) < SHORTEST_NAME:
        return True
    # "8 by 9" is no name, however much one is asked for.
    told = re.match(r"\s*\d", name) is not None
    return told or len(words) > LONGEST_NAME or words[0] in odd


def is_no_step(name: str, language: str = "english") -> bool:
    """Whether a name is a word of talk such as "none", and no name of a step."""
    return alike(name, hints("no_step_names", language))


def is_nothing(value: Value, language: str = "english") -> bool:
    """Whether an answer tells that there is nothing to tell: "none", "nothing"."""
    return alike(text_of(value), hints("nothing", language))


def alike(name: str, others: Sequence[str]) -> bool:
    """Whether a name is taken, capitals and spaces aside."""
    plain = " ".join(name.lower().split())
    return any(" ".join(other.lower().split()) == plain for other in others)


def _split(text: str, separators: Sequence[str]) -> list[str]:
    pattern = "|".join(re.escape(one) for one in separators)
    return [piece for piece in re.split(pattern, text, flags=re.IGNORECASE) if piece.strip()]
