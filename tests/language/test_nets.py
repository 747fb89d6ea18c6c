import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from assistant.language.families import row_of, vectors
from assistant.language.likelihood import model
from assistant.language.nets import (
    MARKS,
    Net,
    Scores,
    act_odds,
    context_of,
    packed,
    seen_by,
    tag_scores,
    told_beside,
    unpacked,
    windows,
)
from assistant.language.parsing import Hearing
from assistant.language.phrasebook import phrasebook
from assistant.language.tagging import TAGS, chain, seconded
from assistant.language.words import words_of
from assistant.model.listening import Listening
from tests.benchmarks.act_net import act_weights
from tests.benchmarks.joined_nets import joined_acts, joined_tags
from tests.benchmarks.tag_net import tag_weights


def act_net() -> Net:
    known = model("english")
    assert known is not None
    assert known.net is not None
    return known.net


@settings(max_examples=30, deadline=None)
@given(st.lists(st.text(max_size=12), max_size=8), st.sampled_from([None, "goal", "ready"]))
def test_odds_of_any_words_sum_to_one(words: list[str], asked: str | None) -> None:
    odds = act_odds(words, asked, "practice", act_net(), "english")
    assert odds.sum() == pytest.approx(1.0, abs=1e-5)
    assert (odds >= 0.0).all()


@given(st.integers(1, 6), st.integers(1, 3))
def test_windows_hold_neighbors_and_nothing_beyond_the_edges(size: int, reach: int) -> None:
    told = np.arange(1.0, 2 * size + 1, dtype=np.float32).reshape(size, 2)
    found = windows(told, 2 * reach + 1, reach).reshape(size, 2 * reach + 1, 2)
    assert np.array_equal(found[:, reach], told)
    for at in range(size):
        for n, there in enumerate(range(at - reach, at + reach + 1)):
            inside = 0 <= there < size
            assert np.array_equal(found[at, n], told[there] if inside else np.zeros(2))


def test_a_net_is_kept_in_steps_and_read_as_it_was() -> None:
    net = act_net()
    again = unpacked(packed(net, "net"), "net")
    assert again is not None
    assert again.context == net.context
    for key, told in net.weights.items():
        assert np.allclose(again.weights[key], told, atol=float(np.abs(told).max()) / 127)


def test_what_is_said_of_an_unknown_question_is_no_context() -> None:
    net = act_net()
    assert context_of(told_beside("no such question", "practice", "none"), net).sum() == 1.0


def test_an_unknown_word_has_no_vector_and_a_known_one_has_the_same_in_the_plural() -> None:
    assert not vectors("english")[row_of("xqzzy", "english")].any()
    assert row_of("blocks", "english") > 0
    assert row_of("saucers", "english") == row_of("saucer", "english")
    assert row_of("12", "english") == row_of("7", "english") > 0


def test_the_tags_of_each_word_are_told_whatever_the_kind() -> None:
    known, book = chain("english"), phrasebook()
    assert known is not None
    assert known.net is not None
    hearing = Hearing(book, Listening(stage="learning"))
    words = words_of("rename grip to hold", book.contractions)
    seen = seconded(words, hearing.listening, "english", known)
    assert seen is not None
    for kind in ("rename", "merge", "no such kind"):
        assert tag_scores(seen, kind, known.net).shape == (len(words), len(TAGS))


_BESIDE, _WORDS = ("?None", "!practice", "=rename"), ("move", "the", "block", "left")


def drawn(weights: dict[str, Scores], rng: np.random.Generator) -> Net:
    told = {k: (rng.normal(size=v.shape) / 5).astype(np.float32) for k, v in weights.items()}
    return Net(told, _BESIDE)


@pytest.mark.parametrize("count", [1, 2, 3])
def test_nets_of_acts_side_by_side_say_the_mean_of_what_each_says(count: int) -> None:
    rng, wide = np.random.default_rng(count), vectors("english").shape[1]
    nets = [drawn(act_weights(rng, wide, len(_BESIDE), 7), rng) for _ in range(count)]
    told = [np.log(act_odds(_WORDS, None, "practice", one, "english")) for one in nets]
    odds = np.exp(np.mean(told, axis=0))
    found = act_odds(_WORDS, None, "practice", joined_acts(nets), "english")
    assert np.allclose(found, odds / odds.sum(), atol=1e-5)


@pytest.mark.parametrize("count", [1, 2, 3])
def test_nets_of_tags_side_by_side_say_the_mean_of_what_each_says(count: int) -> None:
    rng, wide = np.random.default_rng(count), vectors("english").shape[1]
    nets = [drawn(tag_weights(rng, wide, len(_BESIDE), 9), rng) for _ in range(count)]
    marks = rng.random((len(_WORDS), MARKS)).astype(np.float32)

    def scores(net: Net) -> Scores:
        return tag_scores(seen_by(_WORDS, marks, None, "practice", net, "english"), "rename", net)

    told = np.mean([scores(one) for one in nets], axis=0)
    assert np.allclose(scores(joined_tags(nets)), told, atol=1e-4)
