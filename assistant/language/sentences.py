"""Sentences of the phrasebook, and the teacher's own words in their slots."""

from __future__ import annotations

from typing import Any

from assistant.language.cues import counted_cue, surer
from assistant.language.edges import is_cut_short
from assistant.language.frames import Span, frames
from assistant.language.little_words import LittleWords
from assistant.language.naming import known_name, without_article
from assistant.language.parsing import DOUBTFUL, LIKELY, SURE, Hearing, Parse, texts_of
from assistant.language.phrasebook import Phrase, Sentence
from assistant.language.templates import Bound, matches
from assistant.language.words import Word, Words, said
from assistant.model.listening import Listening
from assistant.model.teacher_acts import ACTS, Cue, TeacherAct

LONGEST_NAME = 7
_ANSWERS = frozenset(("affirm", "deny"))
_NAMING = ("unknown", "save", "load", "compare", "rename", "add_subtask")


def best_sentence(words: Words, hearing: Hearing) -> Parse | None:
    """Return the act of the phrasebook's best matching sentence."""
    if words not in hearing.sentences:
        found = _best_sentence(words, hearing)
        cued = found is not None and isinstance(found.acts[0], Cue)
        counted = counted_cue(words, hearing) if cued else None
        hearing.sentences[words] = surer(found, counted)
    return hearing.sentences[words]


def _best_sentence(words: Words, hearing: Hearing) -> Parse | None:
    texts = texts_of(words)
    if not texts:
        return None
    best: tuple[tuple[float, ...], Parse] | None = None
    for sentence in hearing.book.candidates(texts):
        if not _applies(sentence, hearing.listening):
            continue
        for n, bound in enumerate(matches(sentence.nodes, texts)):
            parse = _parse(sentence, bound, words, hearing)
            if parse is not None:
                free = sum(end - start for _, start, end in bound)
                first = bound[0][2] - bound[0][1] if bound else 0
                asked, staged = bool(sentence.asked), bool(sentence.stages)
                # Nothing was asked: then "go for it" and "spot on" are more than a yes.
                idle = hearing.listening.asked is None and sentence.act in _ANSWERS
                key = (parse.score, asked, staged, not idle, -free, first)
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
        name = label.partition(":")[0]
        if name == "x":
            free = 0.8 if sentence.act == "unknown" else LIKELY
            score = min(score, SURE if sentence.act == "cue" else free)
        elif name in ("n", "nth"):
            slots["number"] = _number(texts_of(words), start, hearing)
        else:
            found = _slot(sentence, label, (start, end), words, hearing)
            if found is None:
                return None
            slots[name], score = found[0], min(score, found[1])
    if sentence.extra == "text":
        slots["text"] = said(words)
    spoken_of = (text for _, s, e in bound for text in texts_of(words[s:e]))
    if sentence.act not in _NAMING and any(text in hearing.book.chat for text in spoken_of):
        return None
    act = _act(sentence, slots)
    return None if act is None else Parse((act,), score)


def _slot(
    sentence: Sentence, label: str, span: Span, words: Words, hearing: Hearing
) -> tuple[Any, float] | None:
    """Return the names of a slot and how far they are trusted; None where they are none."""
    name, _, limit = label.partition(":")
    known = frames(hearing.language)
    part = words[slice(*span)]
    if known is not None and is_cut_short(*span, words, known):
        return None
    new = name in ("name", "new")
    several = sentence.extra == "list"
    value, trust = (
        _names(part, hearing) if several else _name(part, "new" if new else limit, hearing)
    )
    if value is None or known is None or not isinstance(value, str):
        return None if value is None else (value, trust)
    nobody = value in known.small("no_names") and (span[0] == 0 or sentence.act != "rename")
    started = value.partition(" ")[0] in known.small("no_name_starts") and " " in value
    return None if nobody or started else (value, trust)


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
    words = _trimmed(words, hearing, new=limit == "new")
    bare = without_article(texts_of(words), _articles(words, hearing))
    part = words[len(words) - len(bare) :]
    if bare and bare[-1] in hearing.book.little["no_names_end"]:
        return None, 0.0
    names = () if limit == "new" else hearing.listening.subtasks
    found = known_name(texts_of(part), names, hearing.book)
    if found is not None:
        return found, SURE
    if limit == "known" and not _refers(texts_of(part), hearing):
        return None, 0.0
    if _small("persons", hearing) & set(texts_of(part)):
        return said(part), DOUBTFUL
    steps = _small("step_words", hearing)
    if (
        limit == "known"
        and not set(texts_of(part)) & steps
        and not part[0].text.endswith(hearing.book.little.doing)
    ):
        return said(part), 0.8
    value, trust = _unresolved(part, hearing)
    if any(w.text in hearing.book.impure for w in part) or any(w.broken for w in part[1:]):
        trust = 0.7
    return value, min(trust, 0.8) if names else trust


def _articles(words: Words, hearing: Hearing) -> frozenset[str]:
    """Return the articles of the language that are no number here: "one step" is counted."""
    numbers, determiners = hearing.book.numbers, hearing.book.little["determiners"]
    counted = numbers.number(texts_of(words), 0)
    return determiners if counted else determiners | numbers.articles


def _trimmed(words: Words, hearing: Hearing, *, new: bool) -> Words:
    """Take words no name begins or ends with off its ends: "of lifting", "gripping always"."""
    ends = hearing.book.impure
    known = None if new else frames(hearing.language)
    steps = _small("step_words", hearing)
    heads = (known.little["heads"] - steps if known else frozenset()) | ends
    heads |= _small("before_names", hearing)
    tails = (known.little["tails"] - steps if known else frozenset()) | ends
    tails -= known.small("particles") if known else frozenset()
    counted = hearing.book.numbers
    while len(words) > 1 and words[0].text in heads and not counted.number(texts_of(words), 1):
        words = words[1:]
    while len(words) > 1 and words[-1].text in tails:
        if words[-1].text in hearing.book.little["one"] and counted.ordinal(
            texts_of(words), len(words) - 2
        ):
            break
        words = words[:-1]
    return words


def _unresolved(part: Words, hearing: Hearing) -> tuple[str, float]:
    """Return a name no task knows: without a trailing "step", unless that is all it has."""
    texts = texts_of(part)
    numbers = hearing.book.numbers
    counted = numbers.ordinal(texts, 0) or numbers.number(texts, 0)
    steps = _small("step_words", hearing)
    numbered = texts[0] in steps and numbers.number(texts, 1) is not None
    ranked = counted or texts[0] in _small("ranks", hearing)
    placed = texts[-1] in steps and ranked
    if placed or (numbered and len(texts) == 2):
        return said(part), LIKELY + 0.03
    if texts[0] in steps and len(texts) > 1:
        part = part[2:] if texts[1] in hearing.book.little["of"] and len(part) > 2 else part[1:]
    if counted and counted[1] == len(texts):
        return said(part), DOUBTFUL
    if len(part) > 1 and texts[-1] in steps:
        part = part[:-1]
    return said(part), LIKELY


def _refers(texts: Phrase, hearing: Hearing) -> bool:
    """Tell whether words name a step without any task known: "step two", "moving up"."""
    little = hearing.book.little
    alone = len(texts) < 2 or (len(texts) == 2 and texts[1] in little["one"])
    counted = hearing.book.numbers.ordinal(texts, 0) is not None and alone
    stepping = bool(set(texts) & _small("step_words", hearing)) or texts[0].endswith(little.doing)
    return counted or stepping or texts[0] in _small("step_verbs", hearing)


def _small(name: str, hearing: Hearing) -> frozenset[str]:
    """Return small words of the language that do something in names."""
    known = frames(hearing.language)
    return known.small(name) if known else frozenset()


def _names(words: Words, hearing: Hearing) -> tuple[tuple[str, ...] | None, float]:
    little = hearing.book.little
    counted = _first_two(texts_of(words), little)
    if counted is not None:
        found_two = [_name(words_in(one), "", hearing) for one in counted]
        return tuple(str(value) for value, _ in found_two), min(t for _, t in found_two)
    parts: list[list[Word]] = [[]]
    for word in words:
        if word.text in _small("name_joints", hearing):
            parts.append([])
            continue
        if word.broken:
            parts.append([])
        parts[-1].append(word)
    told = set(texts_of(words))
    if told & little["two"] and told & little["the"] and len(words) <= 3:
        return None, 0.0
    found = [_name(tuple(part), "", hearing) for part in parts if part]
    values = tuple(value for value, _ in found if value is not None)
    if len(values) < 2 or len(values) < len(found):
        return None, 0.0
    return _numbered(values, words, hearing), min(trust for _, trust in found)


def _first_two(texts: Phrase, little: LittleWords) -> tuple[str, ...] | None:
    """Read "the first two steps" and "steps two and three"."""
    bare = without_article(texts, little["determiners"])
    if len(bare) > 1 and bare[0] in little["the_first"] and bare[1] in little["two"]:
        return little.pair
    step = little.first("step")
    if len(bare) == 4 and bare[0] in little["steps"] and bare[2] in little["or"]:
        return f"{step} {bare[1]}", f"{step} {bare[3]}"
    return None


def words_in(text: str) -> Words:
    """Return plain words of a text."""
    return tuple(Word(one, one) for one in text.split())


def _numbered(values: tuple[str, ...], words: Words, hearing: Hearing) -> tuple[str, ...]:
    """Resolve "steps two and three" through the known names."""
    names = hearing.listening.subtasks
    numbers = hearing.book.numbers
    if not names:
        return values
    found: list[str] = []
    for value in values:
        texts = [t for t in value.split() if t not in hearing.book.little["numbered_nouns"]]
        place = (numbers.ordinal(texts, 0) or numbers.number(texts, 0)) if len(texts) == 1 else None
        at = int(place[0]) if place else 0
        found.append(names[at - 1] if 1 <= at <= len(names) else value)
    return tuple(found)
