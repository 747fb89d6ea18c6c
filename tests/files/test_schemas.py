"""The schemas shipped for editors say what the forms say."""

from __future__ import annotations

import json
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
