from typing import Any

import pytest

from assistant.language.parsing import Hearing
from assistant.language.phrasebook import phrasebook
from assistant.language.plain_forms import forms, infinitive, step, thing, unbent
from assistant.language.understanding import understand
from assistant.language.words import words_of
from assistant.model.listening import Listening
from assistant.model.teacher_acts import Inform, SetPose, Translate, Where

PRACTICE = Listening(stage="practice")
KNOWN = forms("german")


def _words(text: str) -> Any:
    return words_of(text, phrasebook("german").contractions)


@pytest.mark.parametrize("article", ["der rote", "den roten", "einen roten", "meinen roten"])
def test_a_thing_is_named_alike_whatever_case_it_stands_in(article: str) -> None:
    assert KNOWN is not None
    bent = article.split()[1]
    assert thing(f"{bent} becher", _words(f"und {article} becher"), KNOWN) == "roter becher"


@pytest.mark.parametrize(
    ("said", "name"),
    [
        ("das blaue tuch", "blaues tuch"),
        ("die kleine rote kiste", "kleine rote kiste"),
        ("das kleine rote tuch", "kleines rotes tuch"),
        ("der kleinen kiste", "kleine kiste"),
        ("blaue kiste", "blaue kiste"),
    ],
)
def test_adjectives_end_as_without_their_article(said: str, name: str) -> None:
    assert KNOWN is not None
    bare = said.split(" ", 1)[1] if said.split()[0] in ("das", "die", "der") else said
    assert thing(bare, _words(f"also {said}"), KNOWN) == name


@pytest.mark.parametrize(
    ("bent", "whole"),
    [
        ("festdrückst", "festdrücken"),
        ("absetzt", "absetzen"),
        ("anhebt", "anheben"),
        ("aufnimmt", "aufnehmen"),
        ("loslässt", "loslassen"),
        ("festhältst", "festhalten"),
        ("polsterst", "polstern"),
        ("abfährst", "abfahren"),
        ("greifen", "greifen"),
    ],
)
def test_the_infinitive_of_a_bent_verb(bent: str, whole: str) -> None:
    assert KNOWN is not None
    assert infinitive(bent, KNOWN) == whole
    assert infinitive(whole, KNOWN) == whole


@pytest.mark.parametrize(
    ("line", "said", "name"),
    [
        ("bevor du festdrückst", "festdrückst", "festdrücken"),
        ("ob du das buch suchst", "buch suchst", "buch suchen"),
        ("nachdem du wischen beendet hast", "wischen beendet hast", "wischen"),
        ("nachdem du abgesetzt hast", "abgesetzt hast", "absetzen"),
        ("nachdem du losgelassen hast", "losgelassen hast", "loslassen"),
        ("wenn du mit einsortieren dran bist", "mit einsortieren dran bist", "einsortieren"),
        ("während des transports", "des transports", "transport"),
        ("während des greifens", "greifens", "greifen"),
        ("nach der ansicht", "ansicht", "ansicht"),
    ],
)
def test_a_step_is_named_by_what_is_done(line: str, said: str, name: str) -> None:
    assert KNOWN is not None
    assert step(said, _words(line), KNOWN) == name


def test_a_language_that_bends_nothing_and_names_the_task_knows_stay() -> None:
    acts = (Translate("up", where=Where("festdrückst", "before")), SetPose("roten becher"))
    words = _words("bevor du festdrückst den roten becher")
    english = Hearing(phrasebook("english"), PRACTICE, "english")
    assert unbent(acts, words, english) == acts
    listening = Listening(stage="practice", subtasks=("festdrückst",))
    told = unbent(acts, words, Hearing(phrasebook("german"), listening, "german"))
    assert told == (acts[0], SetPose("roter becher"))


@pytest.mark.parametrize(
    ("text", "asked", "value"),
    [
        ("einen gelben Stein und die rote Kiste", "objects", ("gelber Stein", "rote Kiste")),
        ("den roten Becher", "which", "roter Becher"),
        ("den roten Becher heben", "subtask_name", "den roten Becher heben"),
    ],
)
def test_things_are_named_so_and_steps_keep_their_words(text: str, asked: Any, value: Any) -> None:
    told = understand(text, Listening(stage="introduction", asked=asked), "german").acts
    assert told == (Inform(value),)
