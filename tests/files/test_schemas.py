"""The schemas shipped for editors say what the forms say."""

from __future__ import annotations

import json
import re
from typing import Any

import pytest

from assistant.files.schemas import FORMS, schema, schema_path


def outline(value: Any, name: str = "") -> list[str]:
    """Return which keys each mapping may and must have, and which words are known.

    How a schema spells the rest differs between versions of the library that makes it.
    """
    if isinstance(value, list):
        return sorted(line for part in value for line in outline(part, name))
    if not isinstance(value, dict):
        return []
    lines = []
    for key in ("required", "enum"):
        if isinstance(value.get(key), list):
            lines.append(f"{name} {key}: {sorted(map(str, value[key]))}")
    if isinstance(value.get("properties"), dict):
        lines.append(f"{name} keys: {sorted(value['properties'])}")
    for key, part in value.items():
        lines += outline(part, f"{name}.{key}" if key != "anyOf" else name)
    return sorted(lines)


@pytest.mark.parametrize("kind", sorted(FORMS))
def test_shipped_schemas_are_current(kind: str) -> None:
    told = "write them anew with python -m assistant.files.schemas"
    shipped = json.loads(schema_path(kind).read_text())
    assert outline(shipped) == outline(schema(kind)), told


@pytest.mark.parametrize("kind", sorted(FORMS))
def test_unknown_keys_are_refused_in_every_mapping_with_known_ones(kind: str) -> None:
    made = schema(kind)
    for name, form in {**made["$defs"], kind: made}.items():
        if "properties" in form:
            assert form["additionalProperties"] is False, name


def test_what_may_be_left_empty_and_what_excludes_itself_is_told() -> None:
    made = schema("transcript")
    forms = made["$defs"]
    empty = {"RobotStep": "robot", "RobotAnyStep": "robot*", "RestartStep": "restart"}
    for told in (forms[name]["properties"][key] for name, key in empty.items()):
        assert {"type": "null"} in told["anyOf"]
    assert {"type": "null"} in made["properties"]["steps"]["anyOf"]
    one = [{"required": ["xyz_mm"]}, {"required": ["hand_xyz_mm"]}]
    assert forms["PlaceForm"]["oneOf"] == one
    assert forms["DemonstrateForm"]["oneOf"] == [
        {"required": ["recording"]},
        {"required": ["hand"]},
    ]
    tree = schema("task")["$defs"]
    assert len(tree["ActionForm"]["oneOf"]) == 4
    assert tree["ConditionForm"]["maxProperties"] == 1


def test_names_of_a_schema_are_those_of_the_reader() -> None:
    pattern = re.compile(schema("setup")["properties"]["name"]["pattern"], re.ASCII)
    for name in ("a", "größer als", "a-b", "1"):
        assert pattern.search(name)
    for name in (" a", "a ", "a\nb", "", "a\x7fb"):
        assert not pattern.search(name)
