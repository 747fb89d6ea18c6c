"""The loop around the dialogue: events in, effects out, everything journaled first."""
