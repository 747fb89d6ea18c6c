"""The teacher's hand, three sources behind one port: a recording, a scripted hand, keys."""

from sim.hands.habits import Habits
from sim.hands.keyed import KeyedHand
from sim.hands.recorded import RecordedHand
from sim.hands.scripted import ScriptedHand

__all__ = ["Habits", "KeyedHand", "RecordedHand", "ScriptedHand"]
