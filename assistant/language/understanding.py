"""What a sentence means: the words, then as said, respelled, or as it may have sounded.

Sentences of the phrasebook come first, then classes of words, then answers to the question
asked, then the likest known sentence. Beside what this grammar reads stands what was learned
from sentences; the likelier is chosen, and how far both agree tells how sure it is.
"""

from __future__ import annotations

from dataclasses import replace

from assistant.language.answers import OPEN, trimmed
from assistant.language.choosing import chosen
from assistant.language.commands import command, consent, plain_answer, settled, unknown
from assistant.language.counted import counted, only_counted
from assistant.language.cries import cried
from assistant.language.fillers import bare_verbs, without_fillers
from assistant.language.forbidding import obeyed
from assistant.language.guessing import guess, urgent
from assistant.language.last_word import assured, commanded, last_answer
from assistant.language.naming import known_name
from assistant.language.open_answers import MOTION, answered, goalless
from assistant.language.parsing import (
    ACTING,
    DOUBTFUL,
    GUESS,
    LIKELY,
    SURE,
    Hearing,
    Parse,
    Reading,
    texts_of,
)
from assistant.language.phrasebook import phrasebook
from assistant.language.plain_forms import unbent
from assistant.language.repair import homophones, rejoined, respelled, without_slips
from assistant.language.seeking import chances_of
from assistant.language.sentences import best_sentence
from assistant.language.sequels import sequenced
from assistant.language.stopping import has_stop_word
from assistant.language.surface import dressed, plainly
from assistant.language.trusting import wondered
from assistant.language.weighing import weighed
from assistant.language.withdrawing import withdrawn
from assistant.language.words import Words, words_of
from assistant.model.listening import Listening, Understanding
from assistant.model.teacher_acts import (
    Affirm,
    Approve,
    Optional,
    Stop,
    Unknown,
)

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
    if listening.moving and has_stop_word(text, language):
        return Understanding((Stop(),), 1.0, text)
    reading = read(text, plainly(listening), language)
    if not reading.words:
        return Understanding((Unknown(),), 0.9, text)
    acts = obeyed(reading.parse.acts, reading.words, reading.hearing)
    acts = dressed(acts, text, listening, language)
    score = reading.parse.score
    if any(isinstance(act, Stop) for act in acts):
        score = max(score, ACTING) if has_stop_word(text, language) else min(score, DOUBTFUL)
    return Understanding(acts, round(score, 3), text)


def read(text: str, listening: Listening, language: str = "english") -> Reading:
    """Return what a line of text is read as, with what the reading was made from."""
    book = phrasebook(language)
    hearing = Hearing(book, listening, language)
    heard_words = words_of(text, book.contractions)
    words = without_fillers(heard_words[:MOST_WORDS], listening.asked, book)
    words = bare_verbs(without_slips(words, book), listening.asked, book)
    if not words:
        return Reading(Parse((Unknown(),), LIKELY), words, words, {}, hearing)
    if listening.asked not in OPEN:
        words = sequenced(_once(words), hearing)
    plain = consent(words, hearing) or goalless(words, hearing)
    plain = plain or counted(words, hearing) or only_counted(words, hearing)
    plain = plain or last_answer(words, hearing) or assured(words, hearing)
    plain = plain or withdrawn(words, hearing)
    if plain is not None:
        return Reading(_agreed(plain, heard_words, hearing), words, words, {}, hearing)
    short = best_sentence(heard_words, hearing) if 0 < len(heard_words) <= 3 else None
    if short is not None and short.score >= SURE and listening.asked not in OPEN:
        heard, parse = heard_words, settled(short, listening)
    else:
        heard, parse = _best(words, hearing)
    parse = replace(parse, acts=unbent(parse.acts, heard, hearing))
    if commanded(parse, heard, hearing):
        return Reading(parse, words, heard, {}, hearing)
    chances = chances_of(words, heard, hearing)
    grammar = weighed(parse, heard, chances, hearing)
    grammar = wondered(replace(grammar, acts=unbent(grammar.acts, heard, hearing)), words, hearing)
    choice = chosen(parse, grammar, words, chances, hearing)
    answer = _agreed(choice or grammar, heard_words, hearing)
    return Reading(answer, words, heard, chances, hearing)


def _agreed(parse: Parse, words: Words, hearing: Hearing) -> Parse:
    """Return praise behind a yes as the yes it is: "yes, that looks good" answers the question."""
    yes = words[0].text in hearing.book.yes and hearing.listening.asked == "satisfied"
    return replace(parse, acts=(Affirm(),)) if yes and parse.acts == (Approve(),) else parse


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
        stopping = command(spelled, hearing)
        if stopping is not None and stopping.acts == (Stop(),) and stopping.score >= LIKELY:
            return spelled, replace(stopping, score=stopping.score * _REPAIRED)
    if best.score >= LIKELY and texts_of(spelled) == texts_of(words):
        return heard, best
    counting = hearing.listening.asked == "subtask_count" and len(words) > 4
    sounded = words if counting else homophones(words, hearing.book)
    joined = rejoined(words, hearing.book)
    for variant in dict.fromkeys(
        (sounded, spelled, joined, spelled if counting else homophones(spelled, hearing.book))
    ):
        if variant == words or best.score >= LIKELY:
            continue
        parse = _meaning(variant, hearing)
        if parse.score * _REPAIRED > best.score and not isinstance(parse.acts[0], Unknown):
            best, heard = replace(parse, score=parse.score * _REPAIRED), variant
    if best.score < LIKELY and (urgent(spelled, hearing) or cried(words, hearing)):
        return spelled, Parse((Stop(),), LIKELY)
    if best.score < DOUBTFUL or isinstance(best.acts[0], Unknown):
        likely = guess(spelled, hearing)
        if likely is not None and likely.score > best.score - 0.1:
            best, heard = likely, spelled
    return heard, best


def _meaning(words: Words, hearing: Hearing) -> Parse:
    asked = hearing.listening.asked
    if asked in OPEN:
        return answered(words, hearing)
    parse = command(words, hearing)
    parse = plain_answer(words, parse, hearing)
    named = _named_part(words, hearing)
    moving = parse is not None and isinstance(parse.acts[0], MOTION)
    amount = hearing.book.little["amounts"] & set(texts_of(words))
    if moving and parse is not None and amount:
        return parse
    if named is not None and (named.score >= SURE or moving):
        return named
    if parse is not None and parse.score > GUESS:
        return parse
    if named is not None:
        return named
    return parse or unknown(words, hearing)


def _named_part(words: Words, hearing: Hearing) -> Parse | None:
    """Return the step named in answer to whether some may be skipped."""
    if hearing.listening.asked != "optional":
        return None
    little = hearing.book.little
    bare = tuple(w for w in trimmed(words, hearing.book) if w.text not in little["only"])
    if not bare or len(bare) > 6:
        return None
    found = known_name(texts_of(bare), hearing.listening.subtasks, hearing.book)
    if found is not None:
        return Parse((Optional(found),), SURE)
    if set(texts_of(bare)) & hearing.book.impure:
        return None
    text = " ".join(w.said for w in bare if w.said and w.text not in little["articles"])
    return Parse((Optional(text),), 0.7) if text else None
