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


class Slow(Engine):
    """Speaks its first line until it is let go on."""

    def __init__(self) -> None:
        super().__init__()
        self.over = threading.Event()

    @property
    def speaking(self) -> bool:
        return not self.over.is_set()


def spoken_behind_a_long_line(*, moving: bool, lines: tuple[str, ...]) -> list[str]:
    engine = Slow()
    speaking = Speaking(engine, lambda: moving)
    speaking.say("I begin. It will take me a while.")
    assert engine.spoke.wait(10.0)
    for line in lines:
        speaking.say(line)
    engine.over.set()
    speaking.finish()
    assert not speaking.speaking
    return engine.said


STEPS = ("I approach the block. Before that, the hand is open.", '"lift it": I go up. Careful.')


def test_while_the_arm_moves_only_the_newest_line_is_spoken_and_in_one_sentence() -> None:
    told = spoken_behind_a_long_line(moving=True, lines=STEPS)
    assert told == ["I begin.", '"lift it": I go up.']


def test_at_rest_every_line_is_spoken_whole() -> None:
    told = spoken_behind_a_long_line(moving=False, lines=STEPS)
    assert told == ["I begin. It will take me a while.", *STEPS]


def test_what_waits_about_a_motion_is_not_spoken_when_it_is_over() -> None:
    engine, moves = Slow(), [True]
    speaking = Speaking(engine, lambda: moves[0])
    speaking.say("I begin.")
    assert engine.spoke.wait(10.0)
    speaking.say("I go up.")
    moves[0] = False
    speaking.say("Done in 44 s. Was that right?")
    engine.over.set()
    speaking.finish()
    assert engine.said == ["I begin.", "Done in 44 s. Was that right?"]


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
