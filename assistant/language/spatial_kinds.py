"""How places, ways, turns and sizes become words."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping
from typing import Any

from assistant.language.wording import Wording

_AXES = (("forward", "backward"), ("left", "right"), ("up", "down"))


def _numbers(wording: Wording, value: Any) -> str:
    joint = str(wording.book["words"]["numbers"])
    return joint.join(wording.number(one) for one in value)


def _ways(wording: Wording, value: Any) -> str:
    """Return a displacement, x forward, y left, z up in mm, in the teacher's directions."""
    told = [
        f"{wording.number(abs(one))} mm {wording.told(ways[one < 0])}"
        for one, ways in zip(value, _AXES, strict=True)
        if one
    ]
    return wording.joined(told)


def _turns(wording: Wording, value: Any) -> str:
    """Return roll, pitch and yaw in degrees, or the yaw alone where there is nothing else."""
    return _numbers(wording, value if any(value[:2]) else value[2:])


def _mm(wording: Wording, value: Any) -> str:
    return f"{wording.number(1000.0 * abs(float(value)))} mm"


def _deg(wording: Wording, value: Any) -> str:
    return wording.words("degree" if value == 1 else "degrees_of", {"value": value})


def _place(wording: Wording, value: Mapping[str, Any]) -> str:
    x, y, z = value["xyz_mm"]
    roll, pitch, yaw = value["rpy_deg"]
    tilted = not (math.isclose(roll, 0.0, abs_tol=0.05) and math.isclose(pitch, 0.0, abs_tol=0.05))
    slots = {
        "x": round(x, 1),
        "y": round(y, 1),
        "z": round(z, 1),
        "yaw": round(yaw, 1) or None,
        "roll": round(roll, 1) if tilted else None,
        "pitch": round(pitch, 1) if tilted else None,
        "of": wording.book["words"]["of_hand"] if value["of"] == "hand" else None,
    }
    return wording.words("place", slots)


def _places(wording: Wording, value: Mapping[str, Any]) -> str:
    told = [
        wording.words("place_of", {"name": name, "place": _place(wording, place)})
        for name, place in (value or {}).items()
    ]
    if not told:
        return str(wording.book["words"]["nothing_placed"])
    return str(wording.book["words"]["and_then"]).join(told)


def _seen(wording: Wording, value: Mapping[str, Any]) -> str:
    """Return where a place is as seen from the robot's base, in words and centimetres."""
    x, y, _ = (round(one / 10.0) for one in value["xyz_mm"])
    told = [("ahead" if x >= 0 else "back", abs(x)), ("left" if y >= 0 else "right", abs(y))]
    ways: Mapping[str, str] = wording.book["words"]["seen"]
    return wording.joined([wording.filled(ways[way], {"far": far}) for way, far in told if far])


def _sized(wording: Wording, value: Mapping[str, Any]) -> str:
    """Return what shape and size a thing is taken to have."""
    ways: Mapping[str, str] = wording.book["words"]["sized"]
    return wording.filled(ways.get(value["shape"], ways["box"]), value)


def _sizes(wording: Wording, value: Mapping[str, Any]) -> str:
    told = [
        wording.words("size_of", {"name": name, "x": x, "y": y, "z": z})
        for name, (x, y, z) in (value or {}).items()
    ]
    return wording.joined(told)


SPATIAL_KINDS: Mapping[str, Callable[[Wording, Any], str]] = {
    "numbers": _numbers,
    "mm": _mm,
    "ways": _ways,
    "turns": _turns,
    "deg": _deg,
    "sizes": _sizes,
    "sized": _sized,
    "place": _place,
    "seen": _seen,
    "places": _places,
}
