"""Writes the schemas anew after a form has changed."""

from __future__ import annotations

from assistant.files.schemas import FORMS, schema_path, schema_text
from assistant.files.writing import write_text

if __name__ == "__main__":
    for kind in FORMS:
        write_text(schema_path(kind), schema_text(kind))
