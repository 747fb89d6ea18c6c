from __future__ import annotations

import numpy as np

from assistant.model.demonstration import frozen_array, sealed


def test_what_can_still_be_written_to_is_copied() -> None:
    values = np.arange(6.0).reshape(2, 3)
    frozen = frozen_array(values)
    values[0, 0] = 9.0
    assert frozen[0, 0] == 0.0
    assert not frozen.flags.writeable


def test_what_is_read_only_is_taken_itself() -> None:
    frozen = frozen_array(np.arange(3.0))
    assert frozen_array(frozen) is frozen


def test_a_read_only_view_of_what_can_still_be_written_to_is_copied() -> None:
    values = np.arange(6.0)
    view = values[:3]
    view.setflags(write=False)
    frozen = frozen_array(view)
    values[0] = 9.0
    assert frozen[0] == 0.0


def test_what_was_sealed_is_taken_itself_though_it_is_a_view() -> None:
    values = np.arange(6.0).reshape(2, 3)
    turned = sealed(values.T)
    del values
    assert frozen_array(turned) is turned
    assert not turned.flags.writeable
