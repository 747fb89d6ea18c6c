"""Where a thing is whose name the learned reading tells: its place is read by the grammar."""

from __future__ import annotations

from dataclasses import replace

from assistant.language.parsing import Hearing, texts_of
from assistant.language.poses import read_pose
from assistant.language.words import Words
from assistant.model.teacher_acts import SetPose


def posed(name: str, spelled: Words, hearing: Hearing) -> SetPose | None:
    """Return where a line puts a thing whose name was read otherwise; None if nowhere."""
    name = "" if name in hearing.book.little["no_bodies"] else name
    listening = replace(hearing.listening, asked="pose", objects=(name,) if name else ())
    broken = [w.broken for w in spelled]
    found = read_pose(texts_of(spelled), broken, listening, hearing.book)
    if found is None:
        return None
    known = next(
        (one for one in hearing.listening.objects if name and name in one.lower().split()), name
    )
    plain = read_pose(texts_of(spelled), broken, hearing.listening, hearing.book)
    told = plain.act.object if plain is not None else ""
    if name and _is_coded(name, told):
        known = told
    return SetPose(
        known or found.act.object, found.act.position_mm, found.act.rpy_deg, found.act.by_mm
    )


def _is_coded(name: str, told: str) -> bool:
    """Tell a name with a code beside it, or a code alone: "heat sink" of "heat sink hs2"."""
    before, found, behind = f" {told} ".partition(f" {name} ")
    coded = [any(not c.isalpha() for c in word) for word in behind.split()]
    alone = any(c.isdigit() or c == "_" for c in name) and len(before.split()) == 1
    return bool(found) and ((bool(coded) and all(coded) and not before) or alone)
