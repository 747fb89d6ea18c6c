"""What follows on what was just said: "close the hand, after this move left" is two things.

"After this" points back at the clause before it, and so is no place in the task.
"""

from __future__ import annotations

from assistant.language.parsing import Hearing, texts_of
from assistant.language.words import Word, Words


def sequenced(words: Words, hearing: Hearing) -> Words:
    """Return the words with "then" where "after this" stands between two clauses."""
    little = hearing.book.little
    then, texts = little.first("then"), texts_of(words)
    found, at = list[Word](), 0
    while at < len(words):
        pair = texts[at : at + 2]
        begins = at and (words[at].broken or texts[at - 1] in little["and"])
        back = len(pair) == 2 and pair[0] in little["afterwards"] and pair[1] in little["just_said"]
        alone = at + 2 < len(words) and texts[at + 2] not in hearing.book.numbers.articles
        if then and begins and back and alone:
            said = " ".join(word.said for word in words[at : at + 2])
            found.append(Word(then, said, words[at].broken))
            at += 2
        else:
            found.append(words[at])
            at += 1
    return tuple(found)
