import itertools

from hypothesis import given
from hypothesis import strategies as st

from assistant.language.merging import merged
from assistant.model.teacher_acts import AdjustLast, AdjustSpeed, Rotate, TeacherAct, Translate

CHANGES: list[TeacherAct] = [
    *(Translate("left", degree) for degree in (None, "little", "much")),
    Translate("left", None, 0.01),
    Translate("right"),
    Rotate("left"),
    AdjustSpeed("slower"),
    AdjustSpeed(factor=0.5),
    AdjustSpeed(factor=2.0),
    AdjustLast("more"),
    AdjustLast("more", "much"),
    AdjustLast("less"),
]


@given(st.lists(st.sampled_from(CHANGES), max_size=5))
def test_merging_again_changes_nothing_and_loses_no_kind(acts: list[TeacherAct]) -> None:
    once = merged(acts)
    assert merged(once) == once
    assert {type(act) for act in once} == {type(act) for act in acts}


def test_opposites_stay_two_acts() -> None:
    opposed = [
        (CHANGES[0], CHANGES[4]),
        (AdjustLast("more"), AdjustLast("less")),
        (CHANGES[6], CHANGES[8]),
    ]
    assert all(merged(pair) == pair for pair in opposed)


def test_what_tells_more_is_kept() -> None:
    plain, measured = Translate("left"), Translate("left", None, 0.01)
    told = {merged(pair) for pair in itertools.permutations((plain, measured))}
    assert told == {(measured,)}
    assert merged([Translate("left", "little"), measured]) == (measured,)
    assert merged([AdjustSpeed("slower"), AdjustSpeed(factor=0.5)]) == (AdjustSpeed(factor=0.5),)
