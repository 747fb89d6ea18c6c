"""From sound to acts: recognize, understand, and where that fails compare by sound.

Quick recognizers come first; a slower one is asked only if what the quicker one wrote does not
parse with confidence. Unrelated speech must never act: what neither parses nor sounds like
something that can be said now is unknown.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from assistant.language.completion import suggestions
from assistant.language.understanding import understand
from assistant.model.listening import Listening, Understanding
from assistant.model.teacher_acts import Unknown
from assistant.shells.voice.phonemes import nearest
from assistant.shells.voice.recognizers import Recognizer
from assistant.shells.voice.sound import Samples

SURE = 0.85
NEAR = 0.35
MARGIN = 0.08


@dataclass(frozen=True, slots=True)
class Heard:
    """What an utterance came to.

    Parameters
    ----------
    text : str
        The words as recognized.
    understanding : Understanding
    recognizer : str
        Whose words they are.
    by_sound : bool
        Whether they were matched by sound rather than as written.
    """

    text: str
    understanding: Understanding
    recognizer: str = ""
    by_sound: bool = False


class Hearing:
    """Understands utterances in a place of the dialogue.

    Parameters
    ----------
    recognizers : sequence of Recognizer
        The quickest first.
    language : str
    """

    def __init__(self, recognizers: Sequence[Recognizer], language: str = "english") -> None:
        self._recognizers = tuple(recognizers)
        self._language = language

    def hear(self, samples: Samples, listening: Listening) -> Heard:
        """Return what the utterance means where the dialogue stands."""
        phrases = suggestions(listening, self._language)
        heard: list[Heard] = []
        for recognizer in self._recognizers:
            text = recognizer.recognize(samples, phrases)
            if not text:
                continue
            meant = understand(text, listening, self._language)
            heard.append(Heard(text, meant, recognizer.name))
            if meant.confidence >= SURE and not _is_unknown(meant):
                return heard[-1]
        return self._by_sound(heard, phrases, listening)

    def _by_sound(
        self, heard: Sequence[Heard], phrases: Sequence[str], listening: Listening
    ) -> Heard:
        for candidate in reversed(heard):
            phrase, far, margin = nearest(candidate.text, phrases)
            if far <= NEAR and margin >= MARGIN:
                meant = understand(phrase, listening, self._language)
                sure = Understanding(meant.acts, meant.confidence * (1.0 - far), phrase)
                return Heard(candidate.text, sure, candidate.recognizer, by_sound=True)
        if heard:
            return max(heard, key=lambda one: one.understanding.confidence)
        return Heard("", Understanding((Unknown(),), 1.0, ""))


def _is_unknown(meant: Understanding) -> bool:
    return any(isinstance(act, Unknown) for act in meant.acts)
