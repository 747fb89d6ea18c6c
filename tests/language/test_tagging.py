import itertools

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from assistant.language.parsing import Hearing
from assistant.language.phrasebook import phrasebook
from assistant.language.tagging import (
    BUCKETS,
    TAGS,
    TAKES,
    Chain,
    Tagged,
    rows,
    spans_of_tags,
    tagging,
    tags_of_spans,
    unparted,
    ways_of,
)
from assistant.language.traits import word_traits
from assistant.language.words import words_of
from assistant.model.listening import Listening

KINDS = sorted(kind for kind, slots in TAKES.items() if slots)


def some_chain(seed: int) -> Chain:
    rng = np.random.default_rng(seed)
    weights = rng.normal(0, 0.3, (BUCKETS, len(TAGS))).astype(np.float32)
    return Chain(weights, rng.normal(0, 0.3, (len(TAGS), len(TAGS))).astype(np.float32))


def hearing() -> Hearing:
    return Hearing(phrasebook(), Listening(stage="learning"))


@pytest.mark.parametrize("kind", ["rename", "merge", "translate", "add_subtask"])
def test_the_likeliest_spread_is_the_best_of_all(kind: str) -> None:
    chain, words = some_chain(3), words_of("call it lift", {})
    traits = word_traits(words, hearing())
    ways = ways_of(kind)
    scores = chain.weights[rows(traits, kind)].sum(axis=1)
    worth: dict[Tagged, float] = {}
    for path in itertools.product(range(len(ways.tags)), repeat=len(words)):
        fits = ways.begins[path[0]] and ways.ends[path[-1]]
        if not fits or not all(ways.steps[a, b] for a, b in itertools.pairwise(path)):
            continue
        tags = [int(ways.tags[at]) for at in path]
        value = sum(float(scores[n, tag]) for n, tag in enumerate(tags))
        value += sum(float(chain.steps[a, b]) for a, b in itertools.pairwise(tags))
        worth[spans_of_tags([TAGS[tag] for tag in tags])] = value
    told = tagging(traits, kind, chain)
    if not worth:
        assert told is None
        return
    best = max(worth, key=lambda spans: worth[spans])
    total = np.logaddexp.reduce(list(worth.values()))
    assert told is not None
    assert told.spans == best
    assert told.probability == pytest.approx(np.exp(worth[best] - total), rel=1e-3)


@settings(max_examples=30, deadline=None)
@given(st.integers(0, 5), st.sampled_from(KINDS), st.integers(1, 9))
def test_slots_are_filled_as_their_act_needs(seed: int, kind: str, size: int) -> None:
    words = words_of(" ".join(["left", "lift", "the", "two"][n % 4] for n in range(size)), {})
    told = tagging(word_traits(words, hearing()), kind, some_chain(seed))
    if told is None:
        assert size < 3
        return
    slots = [slot for slot, _, _ in told.spans]
    if kind in ("merge", "unordered"):
        assert len(slots) >= 2
    elif kind != "inform many":
        assert len(set(slots)) == len(slots)
    if kind == "rename":
        assert set(slots) == {"old", "new"}
    assert sum(slot.startswith("where") for slot in slots) <= 1
    assert 0 < told.probability <= 1.0001


@given(st.lists(st.tuples(st.integers(0, 1), st.integers(1, 3)), max_size=4))
def test_spans_and_tags_are_each_others_inverse(gaps: list[tuple[int, int]]) -> None:
    spans, at = [], 0
    for n, (gap, size) in enumerate(gaps):
        spans.append((("old", "new", "value")[n % 3], at + gap, at + gap + size))
        at += gap + size
    tags = tags_of_spans(tuple(spans), at)
    assert spans_of_tags([TAGS[tag] for tag in tags]) == tuple(spans)


def test_an_act_without_slots_has_one_spread() -> None:
    traits = word_traits(words_of("undo that", {}), hearing())
    told = tagging(traits, "undo", some_chain(1))
    assert told is not None
    assert (told.spans, told.probability) == ((), 1.0)


@pytest.mark.parametrize(
    ("text", "apart"),
    [("push box to line", True), ("push box, line", False), ("push box and line", False)],
)
def test_steps_of_a_list_are_parted_by_marks_or_joints(text: str, apart: bool) -> None:
    words = words_of(text, {})
    spans: Tagged = (("value", 0, 2), ("value", len(words) - 1, len(words)))
    assert unparted(spans, words, {"and"}) is apart
