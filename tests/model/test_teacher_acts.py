"""Acts travel through files and programs unchanged, and nothing unknown passes."""

from __future__ import annotations

import pytest

from assistant.errors import BadInput
from assistant.model.teacher_acts import (
    ACTS,
    AdjustSpeed,
    Inform,
    SetPose,
    TeacherAct,
    Translate,
    Where,
    act_from_json,
    act_name,
    act_to_json,
)


@pytest.mark.parametrize(
    "act",
    [
        Inform(("red block", "target")),
        Inform(2),
        AdjustSpeed("slower", "little"),
        AdjustSpeed(factor=0.5),
        Translate("left", distance_m=0.02, where=Where("place object", "before")),
        SetPose("block", position_mm=(533.0, 270.0, 300.0), rpy_deg=(0.0, 0.0, 15.0)),
    ],
)
def test_acts_round_trip(act: TeacherAct) -> None:
    assert act_from_json(act_to_json(act)) == act


def test_absent_slots_are_left_out() -> None:
    assert act_to_json(Translate("left")) == {"act": "translate", "direction": "left"}


def test_every_act_of_the_contract_has_its_name() -> None:
    assert {"inform", "adjust_speed", "repeat_line", "set_pose", "be_brief", "unknown"} <= set(ACTS)
    assert len(ACTS) == 43
    assert all(act_name(kind) == name for name, kind in ACTS.items())


def test_unknown_acts_and_slots_are_refused() -> None:
    with pytest.raises(BadInput, match="unknown act 'fly'"):
        act_from_json({"act": "fly"})
    with pytest.raises(BadInput, match="wrong slots for translate; its slots are: direction"):
        act_from_json({"act": "translate", "way": "left"})
