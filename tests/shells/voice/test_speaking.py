"""Lines are spoken in turn; lists and trees are shown; no stop word while the arm moves."""

from __future__ import annotations

import threading

from assistant.shells.voice.speaking import MOST_WORDS, Speaking, speakable


class Engine:
    """Remembers what it is told to speak; every line is over at once."""

    def __init__(self) -> None:
        self.said: list[str] = []
        self.hushed = 0
        self.spoke = threading.Event()

    @property
    def speaking(self) -> bool:
        return False

    def say(self, text: str) -> None:
        self.said.append(text)
        self.spoke.set()

    def hush(self) -> None:
        self.hushed += 1


def test_lines_are_spoken_in_turn() -> None:
    engine = Engine()
    speaking = Speaking(engine, lambda: False)
    speaking.say("Hello.")
    speaking.say("What is the task called?")
    speaking.finish()
    assert engine.said == ["Hello.", "What is the task called?"]


def test_no_stop_word_is_spoken_while_the_arm_moves() -> None:
    engine = Engine()
    speaking = Speaking(engine, lambda: True)
    speaking.say("Say stop to halt me.")
    speaking.say("Now I approach the block.")
    speaking.finish()
    assert engine.said == ["Now I approach the block."]


def test_hushed_it_falls_silent() -> None:
    engine = Engine()
    speaking = Speaking(engine, lambda: False)
    speaking.hush()
    assert engine.hushed == 1
    assert not speaking.speaking


def test_its_own_words_are_known_again() -> None:
    speaking = Speaking(Engine(), lambda: False)
    speaking.say("Shall I go on more slowly?")
    assert speaking.is_echo("go on more slowly")
    assert not speaking.is_echo("open the hand")
    assert not speaking.is_echo("")


def test_a_tree_is_shown_not_spoken() -> None:
    told = 'I understood this: "pick and place"\n  1 pick up\n    1.1 grasp\nIs that right?'
    assert (
        speakable(told) == 'I understood this: "pick and place" Is that right? The rest is shown.'
    )


def test_a_long_line_is_cut_at_a_sentence() -> None:
    told = "One thing is this. " * 40
    assert len(speakable(told).split()) <= MOST_WORDS + 4
    assert speakable(told).endswith("One thing is this. The rest is shown.")


def test_a_short_line_is_spoken_as_it_is() -> None:
    assert speakable("Are you ready?") == "Are you ready?"
