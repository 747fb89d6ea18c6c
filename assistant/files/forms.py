"""What files may hold, as pydantic models, and their complaints in words with ``file:line``.

A form describes a file, a value of `assistant.model` what the program works with; each module
of this package turns one into the other. The forms also give the JSON Schemas for editors.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
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
from assistant.files.complaints import complaint, short
from assistant.plain_yaml import Document

MOST_PROBLEMS = 50


def _one_line(text: str) -> str:
    if any(ord(char) < 32 or ord(char) == 127 for char in text):
        raise ValueError("a name with control characters; it stands on one line")
    if text != text.strip():
        raise ValueError("a name with spaces around it; leave them out")
    return text


Number = Annotated[float, Strict(), Field(allow_inf_nan=False)]
Positive = Annotated[float, Strict(), Field(allow_inf_nan=False, gt=0)]
NotNegative = Annotated[float, Strict(), Field(allow_inf_nan=False, ge=0)]
Probability = Annotated[float, Strict(), Field(allow_inf_nan=False, ge=0, le=1)]
Whole = Annotated[int, Strict()]
Count = Annotated[int, Strict(), Field(ge=0)]
Truth = Annotated[bool, Strict()]
Text = Annotated[str, StringConstraints(strict=True)]
# No name is too long: what a teacher once said must be read again.
Name = Annotated[
    str,
    StringConstraints(strict=True, min_length=1),
    AfterValidator(_one_line),
    Field(json_schema_extra={"pattern": r"^\S([^\x00-\x1f\x7f]*\S)?$"}),
]
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


def exactly_one(*keys: str) -> ConfigDict:
    """Return what tells editors that a mapping has exactly one of some keys."""
    return ConfigDict(json_schema_extra={"oneOf": [{"required": [key]} for key in keys]})


def or_nothing(key: str) -> ConfigDict:
    """Return what tells editors that nothing may stand behind a key."""

    def open_up(schema: dict[str, Any]) -> None:
        told = schema["properties"][key]
        schema["properties"][key] = {"anyOf": [told, {"type": "null"}]}

    return ConfigDict(json_schema_extra=open_up)


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
        right = f"begin with format: {known}"
        raise BadInput([*document.flaws, Problem(document.where(), "there is no format", right)])
    told = value["format"]
    if told not in formats:
        what = f"format {short(told)} is not known here"
        wrong = Problem(document.where(["format"]), what, f"format: {known}")
        raise BadInput(_unique([*document.flaws, wrong]))
    return str(told)


def validated(form: type[AnyForm], document: Document, others: Sequence[Problem] = ()) -> AnyForm:
    """Return the form a document fills in, or raise `BadInput` with every problem found.

    Parameters
    ----------
    form : type of Form
    document : Document
    others : sequence of Problem
        Found already by looking at what no form can see; flaws of the document join them.
    """
    known: dict[int, list[str]] = {}
    others = [*document.flaws, *others]
    try:
        filled = form.model_validate(document.value, context=known)
    except ValidationError as error:
        found = _last_missing(error.errors(include_url=False))
        problems = [*others, *(_problem(detail, document, known) for detail in found)]
        raise BadInput(_unique(problems)[:MOST_PROBLEMS]) from error
    if others:
        raise BadInput(_unique(others)[:MOST_PROBLEMS])
    return filled


def _last_missing(found: Sequence[ErrorDetails]) -> list[ErrorDetails]:
    """Return what was found, of a list that is too short only the last value missing."""
    last = {each["loc"][:-1]: each["loc"] for each in found if _is_missing_value(each)}
    return [e for e in found if not _is_missing_value(e) or e["loc"] == last[e["loc"][:-1]]]


def _is_missing_value(detail: ErrorDetails) -> bool:
    return detail["type"] == "missing" and isinstance(detail["loc"][-1], int)


def _unique(problems: Iterable[Problem]) -> list[Problem]:
    return sorted(dict.fromkeys(problems), key=_line)


def _line(problem: Problem) -> int:
    number = problem.where.rpartition(":")[2]
    return int(number) if number.isdigit() else 0


def _problem(detail: ErrorDetails, document: Document, known: dict[int, list[str]]) -> Problem:
    unknown = detail["type"] == "extra_forbidden"
    place, _ = _followed(document.value, detail["loc"])
    # An unknown key is known of by the mapping that holds it, not by the one it may hold.
    _, holder = _followed(document.value, detail["loc"][: -1 if unknown else None])
    what, right = complaint(detail, known.get(id(holder), []))
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
