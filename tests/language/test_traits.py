import numpy as np
from hypothesis import given, settings
from hypothesis import strategies as st

from assistant.language.families import NONE, families
from assistant.language.parsing import Hearing
from assistant.language.phrasebook import phrasebook
from assistant.language.traits import mixed, word_traits
from assistant.language.words import words_of
from assistant.model.listening import Listening


def test_words_that_mean_alike_are_of_one_family() -> None:
    assert families("faster", "english")[1] == families("quicker", "english")[1]
    assert families("faster", "english")[1] != families("kettle", "english")[1]
    assert families("xqzzt", "english") == NONE
    assert families("schneller", "german") == NONE


@settings(max_examples=25, deadline=None)
@given(st.lists(st.sampled_from(["lift", "the", "jug", "2", "zzk"]), min_size=1, max_size=9))
def test_every_word_has_as_many_traits(texts: list[str]) -> None:
    hearing = Hearing(phrasebook(), Listening(stage="practice"))
    one = word_traits(words_of("up", {}), hearing)
    found = word_traits(words_of(" ".join(texts), {}), hearing)
    assert found.shape == (len(texts), one.shape[1])
    assert found.dtype == np.uint32


def test_what_lies_beyond_three_words_changes_nothing_but_ends() -> None:
    hearing = Hearing(phrasebook(), Listening(stage="practice"))
    near = word_traits(words_of("jug bowl cup plate fork knife spoon mug", {}), hearing)
    far = word_traits(words_of("jug bowl cup plate fork knife spoon pan", {}), hearing)
    assert (near[:4] == far[:4]).all()
    assert (near[4:] != far[4:]).any(axis=1).all()


def test_traits_of_another_act_are_other_traits() -> None:
    told = np.random.default_rng(2).integers(0, 1 << 32, 1000, dtype=np.uint32)
    assert not set(mixed(told, np.uint32(1)).tolist()) & set(mixed(told, np.uint32(2)).tolist())
    assert len(set(mixed(told, np.uint32(1)).tolist())) > 995
