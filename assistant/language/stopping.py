"""Stop words, looked for in raw input while the arm moves: no grammar, no context.

Anything that could be a stop word is one, "don't stop" and misspellings included. A false
stop costs a start; a missed one costs more.
"""

from __future__ import annotations

import re
import unicodedata

from rapidfuzz.distance import OSA

_STOPS = {
    "english": ("stop", "halt", "freeze", "whoa", "woah", "cease", "abort", "emergency", "stahp"),
    "german": ("stop", "stopp", "halt", "anhalten", "aufhören", "abbrechen", "notaus", "nothalt"),
}
_PHRASES = (
    "hold it",
    "do not move",
    "don't move",
    "dont move",
    "hold still",
    "cut it out",
    "stand still",
    "st op",
    "sto p",
    "s top",
    "s t o p",
    "red light",
    "not aus",
)
# Real words one letter away from a stop word; all else that near is a misspelling.
_OTHERS = frozenset(
    [
        "step",
        "steps",
        "stoop",
        "atop",
        "top",
        "tops",
        "shop",
        "shops",
        "slop",
        "stomp",
        "strop",
        "sop",
        "spot",
        "stow",
        "stob",
        "snop",
        "salt",
        "hall",
        "half",
        "hale",
        "hat",
        "malt",
        "hilt",
        "hart",
        "haunt",
        "shalt",
        "alt",
        "walt",
        "breeze",
        "frieze",
        "freezer",
        "greeze",
        "tease",
        "lease",
        "crease",
        "case",
        "chase",
        "erase",
        "ease",
        "cause",
        "what",
        "who",
        "how",
        "hoa",
        "whom",
        "woe",
        "boa",
        "about",
        "apart",
        "part",
        "short",
        "port",
        "up",
        "to",
        "so",
        "too",
        "stub",
        "stock",
        "stupor",
        "store",
        "stone",
        "story",
        "stood",
        "stoke",
        "stove",
        "soup",
        "scoop",
        "swoop",
        "snoop",
    ]
)
# The same in other languages: words that people say of what a hand holds.
_ALSO_OTHERS = {
    "german": frozenset(
        ["hast", "hasst", "halb", "halbe", "hält", "hälst", "holt", "holst", "hole", "hol",
         "hielt", "hat", "hatte", "hals", "hart", "haut", "haft", "half", "halle", "hall",
         "halm", "hallo", "hakt", "habt", "harte", "kalt", "alt", "salat", "statt", "stoff",
         "stopf", "stab", "stoß", "stob", "step", "schalt", "stoppel", "frei", "freie", "fräse",
         "freue", "notiz", "abbiegen", "abbringen"]
    )
}  # fmt: skip
# Verbs and things that only contain the word: "behalte das", "die Schalter", "der Inhalt".
_WITHIN = {"german": re.compile("(be|ent|er|in|aus|ge|ver|unter|haus|auf|sc|vor)halt")}
_WORDS = re.compile(r"[^\W\d_]+")


def has_stop_word(text: str, language: str = "english") -> bool:
    """Tell whether raw input holds a stop word, however it is spelled or meant."""
    plain = unicodedata.normalize("NFKC", text).lower().replace("\u2019", "'")
    plain = re.sub(r"(?<=[^\W\d_])0(?=[^\W\d_])", "o", plain)
    if any(phrase in " ".join(plain.split()) for phrase in _PHRASES):
        return True
    stops = _STOPS.get(language, ()) + _STOPS["english"]
    return any(_is_stop(word, stops, language) for word in _WORDS.findall(plain))


def _is_stop(word: str, stops: tuple[str, ...], language: str) -> bool:
    within = _WITHIN.get(language)
    if within is not None and within.match(word):
        return False
    if "stop" in word or "halt" in word.removesuffix("er") or word in stops:
        return True
    if word in _OTHERS or word in _ALSO_OTHERS.get(language, ()):
        return False
    once = re.sub(r"(.)\1+", r"\1", word)
    return any(
        once == re.sub(r"(.)\1+", r"\1", stop)
        or (len(word) >= 3 and word[0] == stop[0] and OSA.distance(word, stop) <= 1)
        or (
            len(word) == len(stop)
            and sorted(word) == sorted(stop)
            and OSA.distance(word, stop) <= 2
        )
        for stop in stops
    )
