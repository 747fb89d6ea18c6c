"""Another order of what may come in any, where the one that was shown is refused.

A place may be taken until what stands there has been put away. Which order was taken instead
is told with the motion, as everything is that was changed on the way.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace

from assistant.learning.adaptation import AdaptationPlan, adapt, plan_adaptation
from assistant.learning.ordering import Order, in_order, other_orders
from assistant.model.motion import HandPath, JointPath, Refusal
from assistant.model.scene import Scene
from assistant.model.setup import Setup
from assistant.model.task import Task
from assistant.ports import Planner
from assistant.session.advising import advised

__all__ = ["Planned", "in_order", "planned"]


@dataclass(frozen=True, slots=True, eq=False)
class Planned:
    """What came of planning a task in a setup.

    Parameters
    ----------
    task : Task
        With the lesson in the order that is taken.
    order : tuple of str
        Names of the parts as they are done; empty where that is as shown.
    path : HandPath
    motion : JointPath or Refusal
    """

    task: Task
    order: Order
    path: HandPath
    motion: JointPath | Refusal


def planned(
    task: Task,
    scene: Scene,
    setup: Setup,
    planner: Planner,
    *,
    speed: float,
    plan: AdaptationPlan | None = None,
) -> Planned:
    """Return a motion as shown, or in the first other order in which the task can be done.

    What cannot be done in any order is refused for the reason it has as shown, and with what
    was found to help.
    """
    plan = plan or plan_adaptation(task)
    path = adapt(plan, scene, setup, speed=speed)
    shown = Planned(task, (), path, planner.plan(path, scene, setup))
    if not isinstance(shown.motion, Refusal):
        return shown
    others = _others(task, scene, setup, planner, speed)
    done = next((one for one in others if not isinstance(one.motion, Refusal)), None)
    if done is not None:
        return done
    return replace(shown, motion=advised(shown.motion, plan, scene, setup, planner, speed))


def _others(
    task: Task, scene: Scene, setup: Setup, planner: Planner, speed: float
) -> Iterator[Planned]:
    for order, other in other_orders(task):
        path = adapt(plan_adaptation(other), scene, setup, speed=speed)
        motion = planner.plan(path, scene, setup)
        if isinstance(motion, JointPath):
            notes = (f"first {', then '.join(order)}", motion.note)
            motion = replace(motion, note="; ".join(filter(None, notes)))
        yield Planned(other, order, path, motion)
