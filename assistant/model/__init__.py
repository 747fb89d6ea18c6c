"""Frozen values that every part shares: tasks, setups, scenes, demonstrations, lessons, acts."""
