"""The robot-led dialogue as a pure state machine: ``step(dialogue, event)``."""
