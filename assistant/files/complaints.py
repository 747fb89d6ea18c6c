"""What a form found wrong, in plain words: what is wrong, and what would be right."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from difflib import get_close_matches
from typing import Any

from pydantic_core import ErrorDetails

LONGEST = 60
_BOUNDS = {
    "greater_than": ("gt", "more than"),
    "greater_than_equal": ("ge", "at least"),
    "less_than": ("lt", "less than"),
    "less_than_equal": ("le", "at most"),
}
_NUMBERS = ("float_type", "int_type", "float_parsing", "int_from_float", "finite_number")


def complaint(detail: ErrorDetails, keys: Sequence[str]) -> tuple[str, str]:
    """Return what is wrong and what would be right.

    Parameters
    ----------
    detail : mapping
        What pydantic tells.
    keys : sequence of text
        Known in the mapping it is about.
    """
    kind, given, ctx = detail["type"], detail["input"], detail.get("ctx", {})
    last = str(detail["loc"][-1]) if detail["loc"] else ""
    named = _named(detail["loc"])
    match kind:
        case "missing" if last.isdigit():
            # A list of which some end is missing.
            return f"{named}{len(given)} values", f"{int(last) + 1} are needed"
        case "missing":
            return f"key {last!r} is missing", f"add {last}: ..."
        case "extra_forbidden":
            return f"unknown key {last!r}", _nearest(last, keys)
        case "value_error" | "part":
            what, _, right = str(ctx.get("error", detail["msg"])).partition("; ")
            return f"{named}{what}", right
        case "literal_error" | "union_tag_invalid" | "union_tag_not_found":
            return _choice(given, named, ctx)
        case _:
            return _shape(kind, given, named, ctx)


def _choice(given: Any, named: str, ctx: Mapping[str, Any]) -> tuple[str, str]:
    """Return the complaint about what is none of several words or shapes."""
    listed = str(ctx.get("expected", ctx.get("expected_tags", ""))).replace("'", "")
    if "a text" in listed:
        shapes = listed.replace(", ", " or ")
        hint = "put it in quotes" if isinstance(given, int | float) else f"write {shapes}"
        return f"{named}{short(given)} is not {shapes}", hint
    told = ctx.get("tag", given)
    if not listed:
        return f"{named}{short(given)} is no step", "one key, such as teacher: or robot:"
    return f"{short(told)} is not known here", f"one of {listed.replace(' or ', ', ')}"


def _shape(kind: str, given: Any, named: str, ctx: Mapping[str, Any]) -> tuple[str, str]:
    """Return the complaint about a value of the wrong shape or size."""
    if kind in _BOUNDS:
        bound, words = _BOUNDS[kind]
        return f"{named}{short(given)} is out of range", f"{words} {ctx.get(bound):g}"
    if kind in _NUMBERS:
        return f"{named}{short(given)} is not a number", "write a plain number"
    match kind:
        case "string_type":
            hint = "put it in quotes" if isinstance(given, int | float) else "write a text"
            return f"{named}{short(given)} is not a text", hint
        case "string_too_short":
            return f"{named}{short(given)} is empty", "write a text"
        case "too_long" | "too_short":
            needed = ctx.get("max_length", ctx.get("min_length"))
            return f"{named}{ctx.get('actual_length')} values", f"{needed} are needed"
        case "bool_type":
            return f"{named}{short(given)} is neither", "write true or false"
        case "tuple_type" | "list_type":
            return f"{named}{short(given)} is not a list", "write [...], or lines that begin with -"
        case "dict_type" | "model_type" | "model_attributes_type":
            return f"{named}{short(given)} is not a mapping", "write key: value"
        case _:
            return f"{named}{short(given)} does not belong here", "see assistant check --schema"


def _named(loc: Sequence[str | int]) -> str:
    """Return the key a complaint is about; branches of unions, named with blanks, are none."""
    keys = [part for part in loc if isinstance(part, str) and " " not in part]
    last = loc[-1] if loc else ""
    plain = isinstance(last, int) or (isinstance(last, str) and " " not in last)
    return f"{keys[-1]}: " if keys and plain else ""


def _nearest(key: str, keys: Sequence[str]) -> str:
    near = get_close_matches(key, keys, n=1, cutoff=0.6)
    if near:
        return f"did you mean {near[0]!r}?"
    return f"known keys: {', '.join(keys)}" if keys else "remove it"


def short(value: Any) -> str:
    """Return a value as it is told: never longer than a line can hold."""
    text = repr(value)
    return text if len(text) <= LONGEST else f"{text[: LONGEST - 3]}..."
