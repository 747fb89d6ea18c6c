"""What files may hold, as pydantic models, and their complaints in words with ``file:line``.

A form describes a file, a value of `assistant.model` what the program works with; each module
of this package turns one into the other. The forms also give the JSON Schemas for editors.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from difflib import get_close_matches
from typing import Annotated, Any, TypeVar

from pydantic import (
    AfterValidator,
    BaseModel,
    ConfigDict,
    Discriminator,
    Field,
    Strict,
    StringConstraints,
    Tag,
    ValidationError,
    ValidationInfo,
    model_validator,
)
from pydantic_core import ErrorDetails

from assistant.errors import BadInput, Problem
from assistant.plain_yaml import Document

MOST_PROBLEMS = 50


def _one_line(text: str) -> str:
    if any(ord(char) < 32 or ord(char) == 127 for char in text):
        raise ValueError("a name stands on one line, without control characters")
    if text != text.strip():
        raise ValueError("a name has no spaces around it")
    return text


Number = Annotated[float, Strict(), Field(allow_inf_nan=False)]
Positive = Annotated[float, Strict(), Field(allow_inf_nan=False, gt=0)]
NotNegative = Annotated[float, Strict(), Field(allow_inf_nan=False, ge=0)]
Probability = Annotated[float, Strict(), Field(allow_inf_nan=False, ge=0, le=1)]
Whole = Annotated[int, Strict()]
Count = Annotated[int, Strict(), Field(ge=0)]
Truth = Annotated[bool, Strict()]
Text = Annotated[str, StringConstraints(strict=True)]
Name = Annotated[
    str,
    StringConstraints(strict=True, min_length=1, max_length=200),
    AfterValidator(_one_line),
]
NameOrNone = Annotated[str, StringConstraints(strict=True, max_length=200)]
Triple = tuple[Number, Number, Number]


class Form(BaseModel):
    """A mapping with known keys and no others."""

    model_config = ConfigDict(extra="forbid", frozen=True)

    @model_validator(mode="before")
    @classmethod
    def _remember_keys(cls, data: Any, info: ValidationInfo) -> Any:
        if isinstance(info.context, dict) and isinstance(data, dict):
            keys = [field.alias or name for name, field in cls.model_fields.items()]
            info.context[id(data)] = keys
        return data


def shape_of(value: Any) -> str:
    """Return how a value is written: the tag by which `TextOr` and such choose."""
    if isinstance(value, dict):
        return "a mapping"
    if isinstance(value, list | tuple):
        return "a list"
    return "a text" if isinstance(value, str) else "a number"


by_shape = Discriminator(shape_of)
as_text = Tag("a text")
as_number = Tag("a number")
as_list = Tag("a list")
as_mapping = Tag("a mapping")

AnyForm = TypeVar("AnyForm", bound=Form)


def the_document(documents: Sequence[Document], file: str) -> Document:
    """Return the only document of a file that must hold one."""
    if not documents or documents[0].value is None:
        raise BadInput.one(f"{file}:1", "the file is empty", "begin with format: NAME/1")
    if len(documents) > 1:
        where = f"{file}:{documents[1].line()}"
        raise BadInput.one(where, "a second document begins", "one document a file")
    return documents[0]


def check_format(document: Document, *formats: str) -> str:
    """Return the document's ``format`` if it is one of those known, else raise `BadInput`."""
    value = document.value
    known = " or ".join(formats)
    if not isinstance(value, dict) or "format" not in value:
        raise BadInput.one(document.where(), "there is no format", f"begin with format: {known}")
    told = value["format"]
    if told not in formats:
        raise BadInput.one(
            document.where(["format"]), f"format {told!r} is not known here", f"format: {known}"
        )
    return str(told)


def validated(form: type[AnyForm], document: Document, others: Sequence[Problem] = ()) -> AnyForm:
    """Return the form a document fills in, or raise `BadInput` with every problem found.

    Parameters
    ----------
    form : type of Form
    document : Document
    others : sequence of Problem
        Found already by looking at what no form can see.
    """
    known: dict[int, list[str]] = {}
    try:
        filled = form.model_validate(document.value, context=known)
    except ValidationError as error:
        found = error.errors(include_url=False)
        problems = [*(_problem(detail, document, known) for detail in found), *others]
        raise BadInput(_unique(problems)[:MOST_PROBLEMS]) from error
    if others:
        raise BadInput(_unique(others)[:MOST_PROBLEMS])
    return filled


def _unique(problems: Iterable[Problem]) -> list[Problem]:
    return sorted(dict.fromkeys(problems), key=_line)


def _line(problem: Problem) -> int:
    number = problem.where.rpartition(":")[2]
    return int(number) if number.isdigit() else 0


def _problem(detail: ErrorDetails, document: Document, known: dict[int, list[str]]) -> Problem:
    place, holder = _followed(document.value, detail["loc"])
    last = str(detail["loc"][-1]) if detail["loc"] else ""
    what, right = _words(detail, last, known.get(id(holder), []))
    return Problem(document.where(place), what, right)


def _followed(value: Any, loc: Sequence[str | int]) -> tuple[list[str | int], Any]:
    """Return the place in the document, and the innermost mapping or list on the way.

    Pydantic's location also names the branch of a union; such parts are not in the document.
    """
    place: list[str | int] = []
    holder = value
    for part in loc:
        inside = isinstance(value, dict) and part in value
        if not inside and not (
            isinstance(value, list) and isinstance(part, int) and part < len(value)
        ):
            continue
        place.append(part)
        value = value[part]
        if isinstance(value, dict):
            holder = value
    return place, holder


def _words(detail: ErrorDetails, last: str, keys: list[str]) -> tuple[str, str]:
    """Return what is wrong and what would be right."""
    kind, given, ctx = detail["type"], detail["input"], detail.get("ctx", {})
    match kind:
        case "missing":
            return f"key {last!r} is missing", f"add {last}: ..."
        case "extra_forbidden":
            return f"unknown key {last!r}", _nearest(last, keys)
        case "literal_error" | "union_tag_invalid":
            told = ctx.get("tag", given)
            return f"{_short(told)} is not known here", f"one of {_listed(ctx)}"
        case "string_type":
            hint = "put it in quotes" if isinstance(given, int | float) else "write a text"
            return f"{_named(last)}{_short(given)} is not a text", hint
        case "float_type" | "int_type" | "float_parsing" | "int_from_float":
            return f"{_named(last)}{_short(given)} is not a number", "write a plain number"
        case "too_long" | "too_short":
            needed = ctx.get("max_length", ctx.get("min_length"))
            return f"{_named(last)}{ctx.get('actual_length')} values", f"{needed} are needed"
        case "value_error":
            return f"{_named(last)}{ctx.get('error')}", ""
        case _:
            return f"{_named(last)}{_short(given)}: {_small(detail['msg'])}", ""


def _nearest(key: str, keys: list[str]) -> str:
    near = get_close_matches(key, keys, n=1, cutoff=0.6)
    if near:
        return f"did you mean {near[0]!r}?"
    return f"known keys: {', '.join(keys)}" if keys else "remove it"


def _listed(ctx: dict[str, Any]) -> str:
    listed = ctx.get("expected", ctx.get("expected_tags", ""))
    return str(listed).replace("'", "").replace(" or ", ", ")


def _named(last: str) -> str:
    return "" if not last or last.isdigit() or " " in last else f"{last}: "


def _short(value: Any) -> str:
    text = repr(value)
    return text if len(text) <= 60 else f"{text[:57]}..."


def _small(message: str) -> str:
    return message[:1].lower() + message[1:]
