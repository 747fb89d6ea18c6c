"""JSON Schemas of all formats, for editors; made from the forms by ``python -m`` this package."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

from assistant.files.demonstrations import DemonstrationFile
from assistant.files.forms import Form
from assistant.files.scenes import SceneFile
from assistant.files.setups import SetupFile
from assistant.files.tasks import TaskFile
from assistant.files.transcript_forms import TranscriptFile

FOLDER = Path(__file__).resolve().parent
FORMS: dict[str, type[Form]] = {
    "task": TaskFile,
    "setup": SetupFile,
    "scene": SceneFile,
    "demonstration": DemonstrationFile,
    "transcript": TranscriptFile,
}


def schema(kind: str) -> dict[str, Any]:
    """Return the JSON Schema of a format, by its name without the version."""
    made = FORMS[kind].model_json_schema(by_alias=True)
    return {"$schema": "https://json-schema.org/draft/2020-12/schema", **made, "title": kind}


def schema_text(kind: str) -> str:
    """Return the text of a shipped schema."""
    return json.dumps(schema(kind), indent=2, ensure_ascii=False) + "\n"


def schema_path(kind: str) -> Path:
    """Return where the schema of a format is shipped."""
    return FOLDER / f"{kind}.json"
