import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from assistant.language.likelihood import likelihoods, model
from assistant.language.phrasebook import LANGUAGES
from assistant.language.understanding import understand
from assistant.model.listening import Listening
from assistant.model.teacher_acts import Undo


@pytest.mark.parametrize("language", ["english", "german"])
@settings(max_examples=30, deadline=None)
@given(st.lists(st.text(max_size=12), max_size=8))
def test_chances_of_any_words_sum_to_one(language: str, words: list[str]) -> None:
    told = likelihoods(tuple(words), tuple(words), Listening(stage="practice"), language)
    assert sum(told.values()) == pytest.approx(1.0, abs=1e-5)
    assert min(told.values()) >= 0.0


def test_a_language_without_a_model_has_no_chances(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(LANGUAGES, "unlearned", "unlearned")
    assert likelihoods(("ja",), ("ja",), Listening(), "unlearned") == {}
    assert model("unlearned") is None


def test_the_model_is_kept_in_steps_of_its_largest_weight() -> None:
    known = model("english")
    assert known is not None
    assert np.isfinite(known.weights).all()
    assert len(set(known.labels)) == len(known.labels) == known.weights.shape[1]


def test_words_no_template_holds_are_still_told_by_their_likelihood() -> None:
    meant = understand("unmake that alteration of mine, would you", Listening(stage="practice"))
    assert meant.acts == (Undo(),)
    assert meant.confidence < 0.85
