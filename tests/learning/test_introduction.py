from __future__ import annotations

from assistant.learning.introduction import orders, other_orders
from assistant.model.task import Action, Primitive, Subtask, Task


def leaf(name: str) -> Primitive:
    return Primitive(name, Action("free", name))


def test_a_sequence_has_one_order() -> None:
    tree = Subtask("all", (leaf("a"), Subtask("inner", (leaf("b"), leaf("c")))))
    assert orders(Task("t", tree)) == ((0, 1, 2),)


def test_parts_of_any_order_move_as_wholes() -> None:
    first, second = Subtask("x", (leaf("a"), leaf("b"))), Subtask("y", (leaf("c"), leaf("d")))
    tree = Subtask("all", (first, second, leaf("e")), order="any")
    found = orders(Task("t", tree))
    assert found[0] == (0, 1, 2, 3, 4)
    assert len(found) == 6
    assert all(order.index(1) == order.index(0) + 1 for order in found)


def test_very_many_orders_are_bounded() -> None:
    tree = Subtask("all", tuple(leaf(str(k)) for k in range(10)), order="any")
    assert len(orders(Task("t", tree))) == 120


def carried(name: str) -> Subtask:
    take, let_go = Action("hand", "close", name), Action("hand", "open", name)
    return Subtask(f"bring {name}", (Primitive(f"take {name}", take), Primitive(name, let_go)))


def test_parts_that_end_with_an_empty_hand_can_change_places() -> None:
    tree = Subtask("all", (leaf("begin"), carried("a"), carried("b"), leaf("end")))
    assert other_orders(Task("t", tree)) == ((0, 3, 4, 1, 2, 5),)
    # What is allowed anyway, and what would leave a thing in the hand, is no other order.
    free = Subtask("all", (carried("a"), carried("b")), order="any")
    assert other_orders(Task("t", free)) == ()
    (take, let_go) = carried("a").parts
    assert other_orders(Task("t", Subtask("all", (Subtask("x", (take,)), let_go)))) == ()
