"""How single slots of a line become words: lists, trees, conditions, episodes, corrections."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Any

from assistant.language.spatial_kinds import SPATIAL_KINDS
from assistant.language.wording import Wording


def _list(wording: Wording, value: Any) -> str:
    return wording.joined([wording.told(one) for one in value or ()])


def _names(wording: Wording, value: Any) -> str:
    return wording.joined([wording.words("name", {"name": one}) for one in value or ()])


def _things(wording: Wording, value: Any) -> str:
    return wording.joined([wording.words("thing", {"name": one}) for one in value or ()])


def _answer(wording: Wording, value: Any) -> str:
    return _list(wording, value) if isinstance(value, list | tuple) else wording.told(value)


def _some(wording: Wording, value: Any) -> str:
    return str(value) if value else str(wording.book["words"]["none"])


def _ordinal(wording: Wording, value: Any) -> str:
    known = wording.book["words"]["ordinals"]
    if 1 <= value <= len(known):
        return str(known[value - 1])
    return wording.words("ordinal", {"number": value})


def _percent(wording: Wording, value: Any) -> str:
    return wording.words("percent", {"value": 100.0 * float(value or 0.0)})


def _action(wording: Wording, value: Mapping[str, str] | None) -> str:
    if not value:
        return ""
    verb, way = next(iter(value.items()))
    ways = wording.book["actions"].get(verb, way)
    template = ways.get(way, way) if isinstance(ways, Mapping) else ways
    return wording.filled(str(template), {"object": value.get("object"), "way": way})


def _condition(wording: Wording, value: Mapping[str, Any]) -> str:
    kind, told = next(iter(value.items()))
    slots = told if isinstance(told, Mapping) else {"object": told}
    return wording.filled(wording.among("conditions", kind), slots)


def _conditions(wording: Wording, value: Any) -> str:
    return wording.joined([_condition(wording, one) for one in value or ()])


def _state(wording: Wording, value: Any) -> str:
    return wording.fill(wording.among("unmet", str(value)))


def _tree(wording: Wording, value: Mapping[str, Any]) -> str:
    return "\n".join(
        (wording.words("name", value) + _marks(wording, value), *_below(wording, value, ""))
    )


def _marks(wording: Wording, node: Mapping[str, Any]) -> str:
    told = wording.book["words"]
    any_order = told["any_order"] if node.get("order") == "any" else ""
    return any_order + (told["optional"] if node.get("optional") else "")


def _below(wording: Wording, node: Mapping[str, Any], number: str) -> list[str]:
    lines: list[str] = []
    for position, part in enumerate(node.get("parts", ()), start=1):
        place = f"{number}{position}"
        indent = "  " * (place.count(".") + 1)
        action = f": {_action(wording, part['action'])}" if "action" in part else ""
        lines.append(f"{indent}{place} {part['name']}{action}{_marks(wording, part)}")
        lines.extend(_below(wording, part, f"{place}."))
    return lines


def _lag(wording: Wording, value: float) -> str:
    """Return how far cues are from what they tell of, and on which side."""
    ways: Mapping[str, str] = wording.book["words"]["lags"]
    return wording.filled(ways["late" if value >= 0.0 else "early"], {"s": abs(value)})


def _episodes(wording: Wording, value: Any) -> str:
    unassigned = wording.book["words"]["unassigned"]
    told = [
        wording.words("episode", {**one, "primitive": one["primitive"] or unassigned})
        for one in value or ()
    ]
    return wording.joined(told)


def _alignments(wording: Wording, value: Any) -> str:
    return ". ".join(wording.words("alignment", one) for one in value or ())


def _signals(wording: Wording, value: Any) -> str:
    return wording.joined([wording.among("signals", str(one)) for one in value or ()])


def _cuts(wording: Wording, value: Any) -> str:
    told = [
        wording.words(
            "cut",
            {
                "at_s": one["at_s"],
                "percent": _percent(wording, one["confidence"]),
                "signals": _signals(wording, one["signals"]),
            },
        )
        for one in value or ()
    ]
    return wording.joined(told)


def _steps(wording: Wording, value: Any) -> str:
    told = [
        wording.words("step", {**one, "number": at, "action": _action(wording, one["action"])})
        for at, one in enumerate(value or (), start=1)
    ]
    return "\n".join(told)


def _conditions_of(wording: Wording, value: Any) -> str:
    told = [
        wording.words(
            "step_conditions",
            {
                "number": at,
                "name": one["name"],
                "before": _conditions(wording, one["before"]),
                "until": _conditions(wording, one["until"]),
            },
        )
        for at, one in enumerate(value or (), start=1)
    ]
    return "\n".join(told)


def _corrections(wording: Wording, value: Any) -> str:
    told = [
        wording.words(
            "correction", {"number": at, "when": "during", **one, "amount": _amount(wording, one)}
        )
        for at, one in enumerate(value or (), start=1)
    ]
    return "\n".join(told)


def _amount(wording: Wording, one: Mapping[str, Any]) -> str:
    """Return how far a correction goes, in mm, degrees or percent of the speed."""
    template = wording.book["words"]["amounts"][one["kind"]]
    return wording.filled(template, {**one, "percent": one.get("factor")})


def _acts(wording: Wording, value: Any) -> str:
    told = [wording.filled(wording.among("acts", one["act"]), one) for one in value]
    return wording.joined([one.strip() for one in told])


def _hint(wording: Wording, value: Any) -> str:
    return wording.fill(wording.among("hints", value) if value else "")


def _from(part: str) -> Callable[[Wording, Any], str]:
    """Return a kind that looks a key up in a part of the book."""

    def look(wording: Wording, value: Any) -> str:
        return str(wording.book[part].get(value, value or ""))

    return look


KINDS: Mapping[str, Callable[[Wording, Any], str]] = {
    **SPATIAL_KINDS,
    "list": _list,
    "names": _names,
    "things": _things,
    "answer": _answer,
    "some": _some,
    "ordinal": _ordinal,
    "percent": _percent,
    "action": _action,
    "conditions": _conditions,
    "state": _state,
    "tree": _tree,
    "lag": _lag,
    "episodes": _episodes,
    "alignments": _alignments,
    "signals": _signals,
    "cuts": _cuts,
    "steps": _steps,
    "conditions_of": _conditions_of,
    "corrections": _corrections,
    "acts": _acts,
    "hint": _hint,
    "change": _from("changes"),
    "reason": _from("reasons"),
    "why": _from("whys"),
    "whens": _from("whens"),
}
