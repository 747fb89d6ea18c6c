"""Understands one clause: whole sentences of the phrasebook, corrections, places, key states."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from typing import Any

from assistant.language.motion import read_motion
from assistant.language.naming import known_name, without_article
from assistant.language.phrasebook import Phrase, Phrasebook, Sentence
from assistant.language.poses import read_pose
from assistant.language.templates import Bound, matches
from assistant.language.words import Word, Words, said
from assistant.model.listening import Listening
from assistant.model.teacher_acts import (
    ACTS,
    AdjustSpeed,
    Gripper,
    KeyState,
    Rotate,
    TeacherAct,
    Translate,
    Where,
)

SURE, LIKELY, DOUBTFUL, GUESS = 0.96, 0.9, 0.6, 0.4
LONGEST_NAME = 7
_NOBODY = frozenset(
    ("there", "it", "that", "this", "what", "which", "who", "they", "everything", "it is", "it's")
)
_STEPS = frozenset(("step", "subtask", "part", "primitive", "stage", "phase"))


@dataclass(frozen=True, slots=True)
class Parse:
    """Acts with the confidence that they are what was meant."""

    acts: tuple[TeacherAct, ...]
    score: float


@dataclass(frozen=True, slots=True)
class Hearing:
    """What understanding a clause needs beside its words."""

    book: Phrasebook
    listening: Listening
    language: str = "english"

    @property
    def names(self) -> frozenset[str]:
        """Words of the names of known objects."""
        return frozenset(w for name in self.listening.objects for w in name.lower().split())


def clause(words: Words, hearing: Hearing) -> Parse | None:
    """Return what a clause means as a whole; None if nothing explains it."""
    best: Parse | None = None
    for bare in _bared(words, hearing.book):
        for parse in _readings(bare, hearing):
            if best is None or parse.score > best.score:
                best = parse
        if best is not None and best.score >= SURE - 0.01:
            return best
    return best


def _readings(words: Words, hearing: Hearing) -> Iterator[Parse]:
    sentence = best_sentence(words, hearing)
    if sentence is not None:
        yield sentence
        if sentence.score >= SURE:
            return
    located = located_correction(words, hearing)
    if located is not None:
        yield located
    if sentence is not None and sentence.score >= LIKELY:
        return
    texts = texts_of(words)
    pose = read_pose(texts, [w.broken for w in words], hearing.listening, hearing.book)
    if pose is not None:
        yield Parse((pose.act,), _explained(pose.unexplained) + 0.01)
    moved = correction(texts, hearing)
    if moved is not None:
        yield moved
    state = key_state(words, hearing)
    if state is not None:
        yield state


def correction(texts: Phrase, hearing: Hearing) -> Parse | None:
    """Return a correction of the motion with the confidence its unexplained words leave."""
    if len(texts) > 25 or (texts and texts[0] in ("what", "why", "how", "who", "where")):
        return None
    reading = read_motion(texts, hearing.book, hearing.names)
    if reading is None or reading.unexplained > 2:
        return None
    if reading.unexplained and (set(texts) & hearing.book.chat or texts[0] in _STATING):
        return None
    return Parse(reading.acts, _explained(reading.unexplained))


_STATING = frozenset("there i my he she they we is are do does did have has his her our".split())


def _explained(unexplained: int) -> float:
    return SURE - 0.01 if unexplained == 0 else max(DOUBTFUL - 0.2 * (unexplained - 1), 0.2)


def texts_of(words: Sequence[Word]) -> Phrase:
    """Return the words as they are compared."""
    return tuple(word.text for word in words)


def _bared(words: Words, book: Phrasebook) -> Iterator[Words]:
    """Yield the clause as it is, then with courtesies taken off its ends, step by step."""
    seen: set[tuple[int, int]] = set()
    starts = [0]
    while (cut := _head(words[starts[-1] :], book)) and len(starts) < 6:
        starts.append(starts[-1] + cut)
    ends = [len(words)]
    while (cut := _tail(words[: ends[-1]], book)) and len(ends) < 5:
        ends.append(ends[-1] - cut)
    for end in ends:
        for start in starts:
            if start < end and (start, end) not in seen:
                seen.add((start, end))
                yield words[start:end]
                if start and words[start - 1].text == "mind" and words[start].text.endswith("ing"):
                    yield (_base(words[start], book), *words[start + 1 : end])


def _base(word: Word, book: Phrasebook) -> Word:
    """Return "move" for "moving", as it follows "would you mind"."""
    stem = word.text.removesuffix("ing")
    for form in (stem, f"{stem}e", stem[:-1]):
        if form in book.vocabulary:
            return replace(word, text=form)
    return word


def _head(words: Words, book: Phrasebook) -> int:
    texts = texts_of(words)
    for size in range(min(8, len(words) - 1), 0, -1):
        if texts[:size] in book.opening:
            return size
    if len(words) > 1 and words[1].broken and texts[0] in ("right", "no", "yes", "good", "yeah"):
        return 0
    return 0


def _tail(words: Words, book: Phrasebook) -> int:
    texts = texts_of(words)
    for size in range(min(7, len(words) - 1), 0, -1):
        if texts[-size:] in book.closing:
            return size
    return 0


def best_sentence(words: Words, hearing: Hearing) -> Parse | None:
    """Return the act of the phrasebook's best matching sentence."""
    texts = texts_of(words)
    if not texts:
        return None
    best: tuple[tuple[float, ...], Parse] | None = None
    book = hearing.book
    for sentence in (*book.by_first.get(texts[0], ()), *book.by_first[""]):
        if not _applies(sentence, hearing.listening):
            continue
        for n, bound in enumerate(matches(sentence.nodes, texts)):
            parse = _parse(sentence, bound, words, hearing)
            if parse is not None:
                free = sum(end - start for _, start, end in bound)
                key = (parse.score, bool(sentence.asked), bool(sentence.stages), -free)
                if best is None or key > best[0]:
                    best = (key, parse)
            if n > 40 or not bound:
                break
    return None if best is None else best[1]


def _applies(sentence: Sentence, listening: Listening) -> bool:
    if sentence.stages and listening.stage not in sentence.stages:
        return False
    return not sentence.asked or (listening.asked or "none") in sentence.asked


def _parse(sentence: Sentence, bound: Bound, words: Words, hearing: Hearing) -> Parse | None:
    slots: dict[str, Any] = dict(sentence.slots)
    score = SURE
    for label, start, end in bound:
        name, _, limit = label.partition(":")
        part = words[start:end]
        if name == "x":
            score = min(score, SURE if sentence.act == "cue" else LIKELY)
        elif name in ("n", "nth"):
            slots["number"] = _number(texts_of(words), start, hearing)
        else:
            several = sentence.extra == "list"
            value, trust = _names(part, hearing) if several else _name(part, limit, hearing)
            if value is None or (start == 0 and value in _NOBODY):
                return None
            if isinstance(value, str) and value.startswith(("it ", "them ", "that ")):
                return None
            slots[name] = value
            score = min(score, trust)
    if sentence.extra == "text":
        slots["text"] = said(words)
    spoken_of = (text for _, s, e in bound for text in texts_of(words[s:e]))
    if sentence.act != "unknown" and any(text in hearing.book.chat for text in spoken_of):
        return None
    act = _act(sentence, slots)
    return None if act is None else Parse((act,), score)


def _number(texts: Phrase, at: int, hearing: Hearing) -> float | None:
    numbers = hearing.book.numbers
    found = numbers.ordinal(texts, at) or numbers.number(texts, at)
    return found[0] if found else None


def _act(sentence: Sentence, slots: dict[str, Any]) -> TeacherAct | None:
    number = slots.pop("number", None) or 0.0
    kind = ACTS[sentence.act]
    if sentence.act == "cue" and sentence.extra == "number":
        slots["which"] = "first" if number == 1 and "{nth}" in sentence.template else int(number)
    if sentence.act == "assign":
        slots["episode"] = int(number)
    if sentence.extra == "seconds":
        slots["at_s"] = float(number)
    if sentence.extra == "ratio":
        slots["factor"] = number / 100.0
    older = slots.pop("older", None)
    if older is not None:
        slots["old"] = older
    if sentence.act in ("unordered", "merge") and "subtasks" in slots:
        slots["subtasks"] = tuple(slots["subtasks"])
        if len(slots["subtasks"]) < 2:
            return None
    return kind(**slots)


def _name(words: Words, limit: str, hearing: Hearing) -> tuple[str | None, float]:
    """Return a slot's value and how far it can be trusted."""
    if len(words) > LONGEST_NAME:
        return None, 0.0
    bare = without_article(texts_of(words))
    part = words[len(words) - len(bare) :]
    if bare and bare[-1] in ("the", "a", "an", "of", "to", "and"):
        return None, 0.0
    names = (*hearing.listening.subtasks,)
    found = known_name(texts_of(part), names, hearing.book.numbers)
    if found is not None:
        return found, SURE
    if limit == "known" and not _refers(texts_of(part), hearing):
        return None, 0.0
    if any(text in ("i", "he", "she", "they", "who") for text in texts_of(part)):
        return said(part), DOUBTFUL
    return _unresolved(part, hearing)


def _unresolved(part: Words, hearing: Hearing) -> tuple[str, float]:
    """Return a name no task knows: without a trailing "step", unless that is all it has."""
    texts = texts_of(part)
    numbers = hearing.book.numbers
    counted = numbers.ordinal(texts, 0) or numbers.number(texts, 0)
    numbered = texts[0] in _STEPS and numbers.number(texts, 1) is not None
    placed = texts[-1] in _STEPS and (counted or texts[0] in ("next", "last", "final"))
    if placed or (numbered and len(texts) == 2):
        return said(part), LIKELY + 0.03
    if texts[0] in _STEPS and len(texts) > 1:
        part = part[1:]
    if counted and counted[1] == len(texts):
        return said(part), DOUBTFUL
    if len(part) > 1 and texts[-1] in _STEPS:
        part = part[:-1]
    return said(part), LIKELY


def _refers(texts: Phrase, hearing: Hearing) -> bool:
    """Tell whether words name a step without any task known: "step two", "moving up"."""
    steps = {"step", "subtask", "part", "primitive"}
    return bool(set(texts) & steps) or any(text.endswith("ing") for text in texts[:1])


def _names(words: Words, hearing: Hearing) -> tuple[tuple[str, ...] | None, float]:
    parts: list[list[Word]] = [[]]
    for word in words:
        if word.text in ("and", "or", "with", "plus", "both", "either", "nor"):
            parts.append([])
            continue
        if word.broken:
            parts.append([])
        parts[-1].append(word)
    if "two" in texts_of(words) and "the" in texts_of(words) and len(words) <= 3:
        return None, 0.0
    found = [_name(tuple(part), "", hearing) for part in parts if part]
    values = tuple(value for value, _ in found if value is not None)
    if len(values) < 2 or len(values) < len(found):
        return None, 0.0
    return _numbered(values, words, hearing), min(trust for _, trust in found)


def _numbered(values: tuple[str, ...], words: Words, hearing: Hearing) -> tuple[str, ...]:
    """Resolve "steps two and three" through the known names."""
    names = hearing.listening.subtasks
    numbers = hearing.book.numbers
    if not names:
        return values
    found: list[str] = []
    for value in values:
        texts = [t for t in value.split() if t not in ("steps", "step", "subtasks", "parts", "one")]
        place = (numbers.ordinal(texts, 0) or numbers.number(texts, 0)) if len(texts) == 1 else None
        at = int(place[0]) if place else 0
        found.append(names[at - 1] if 1 <= at <= len(names) else value)
    return tuple(found)


def located_correction(words: Words, hearing: Hearing) -> Parse | None:
    """Read "when you place it, a bit more left": a correction with where it belongs."""
    texts = texts_of(words)
    where = hearing.book.where
    for when in ("before", "after", "during"):
        for phrase in where[when]:
            size = len(phrase)
            if texts[:size] == phrase:
                found = _front(words, size, when, hearing)
                if found is not None:
                    return found
            for at in range(1, len(texts) - size):
                if texts[at : at + size] == phrase:
                    found = _joined(words[:at], words[at + size :], phrase, when, hearing)
                    if found is not None:
                        return found
    return None


def _front(words: Words, size: int, when: str, hearing: Hearing) -> Parse | None:
    breaks = [at for at in range(size + 1, len(words)) if words[at].broken]
    for at in breaks or range(size + 1, len(words)):
        found = _joined(words[at:], words[size:at], texts_of(words[:size]), when, hearing)
        if found is not None:
            return found
    return None


def _joined(told: Words, place: Words, phrase: Phrase, when: str, hearing: Hearing) -> Parse | None:
    subject = _place(place, hearing)
    weak = phrase in (("at",), ("in",), ("for",), ("as",), ("once",), ("following",))
    if not subject or len(subject) > LONGEST_NAME:
        return None
    if not told or told[-1].text in ("to", "of", "by", "and", "from"):
        return None
    if told[0].text in ("it", "the", "a", "an", "that", "and", "to") and not told[0].broken:
        return None
    texts = texts_of(subject)
    if texts in ((("you",), ("i",), ("we",), ("the",))):
        return None
    if any(text in hearing.book.chat for text in texts):
        return None
    known = known_name(texts, hearing.listening.subtasks, hearing.book.numbers)
    if (weak and known is None and phrase != ("once",)) or _is_amount(texts, hearing):
        return None
    for bare in _bared(told, hearing.book):
        parse = correction(texts_of(bare), hearing) or best_sentence(bare, hearing)
        if parse is None or parse.score < LIKELY:
            continue
        spot = Where(
            known or said(subject),
            "before" if when == "before" else "after" if when == "after" else "during",
        )
        acts = tuple(
            replace(act, where=spot)
            for act in parse.acts
            if isinstance(act, Translate | Rotate | AdjustSpeed | Gripper)
        )
        if len(acts) == len(parse.acts):
            return Parse(acts, SURE if known else LIKELY + 0.01)
    return None


def _is_amount(texts: Phrase, hearing: Hearing) -> bool:
    return all(text in ("it", "that", "this", "once", "least", "all", "now") for text in texts)


def _place(words: Words, hearing: Hearing) -> Words:
    """Take the subject off "you place it", and the article off "the grasp"."""
    texts = texts_of(words)
    for phrase in hearing.book.where["subject"]:
        if len(phrase) < len(words) and texts[: len(phrase)] == phrase:
            rest = words[len(phrase) :]
            return rest[1:] if len(rest) > 1 and rest[0].text in ("the", "are", "is") else rest
    return words


def key_state(words: Words, hearing: Hearing) -> Parse | None:
    """Read what a teacher who demonstrates calls attention to."""
    if hearing.listening.stage != "demonstration":
        return None
    lists = hearing.book.answer_words
    marked = False
    while (cut := _marker(words, lists["key_markers"])) and len(words) > cut:
        words, marked = words[cut:], True
    texts = texts_of(words)
    nouns = {word for phrase in lists["key_nouns"] for word in phrase} | hearing.names
    verbs = {word for phrase in lists["key_verbs"] for word in phrase}
    weak = {"it", "they", "both", "is", "are", "was", "got", "does", "no"}
    strong = (set(texts) & (nouns | verbs)) - weak
    concerned = bool(set(texts) & nouns and set(texts) & verbs and strong)
    asking = texts and texts[0] in ("what", "why", "how", "who", "where", "do", "can", "are")
    if not concerned or asking or set(texts) & hearing.book.chat or len(texts) < 3:
        return None
    if texts[0] in ("i", "we", "my"):
        return Parse((KeyState(said(words)),), DOUBTFUL)
    return Parse((KeyState(said(words)),), LIKELY if marked else LIKELY - 0.03)


def _marker(words: Words, markers: Sequence[Phrase]) -> int:
    texts = texts_of(words)
    return next((len(phrase) for phrase in markers if texts[: len(phrase)] == phrase), 0)
