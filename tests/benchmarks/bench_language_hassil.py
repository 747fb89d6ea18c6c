"""The peer: hassil alone with our own phrasebook, acts only, against the whole of ours.

run: python -m tests.benchmarks.bench_language_hassil
"""

from __future__ import annotations

import re
import statistics
import time
from pathlib import Path
from typing import Any, cast

from hassil import Intents, recognize

import assistant.language
from assistant.language.understanding import understand
from assistant.model.teacher_acts import act_name
from assistant.plain_yaml import read_file
from tests.benchmarks.bench_language import FILES, rows

BOOK = Path(next(iter(assistant.language.__path__))) / "english" / "hears.yaml"


def intents() -> Intents:
    """Return our sentences as hassil's intents; every slot is a wildcard."""
    book = cast("dict[str, Any]", read_file(BOOK)[0].value)
    told: dict[str, Any] = {}
    lists: set[str] = set()
    for entry in book["sentences"]:
        lines = [_theirs(line.strip()) for line in entry["say"].splitlines() if line.strip()]
        lists |= {name for line in lines for name in re.findall(r"\{([^}]*)\}", line)}
        told.setdefault(entry["act"], {"data": []})["data"].append({"sentences": lines})
    rules = {f"r_{name}": _theirs(rule) for name, rule in book["rules"].items()}
    wild = {name: {"wildcard": True} for name in lists}
    return Intents.from_dict(
        {"language": "en", "intents": told, "lists": wild, "expansion_rules": rules}
    )


def _theirs(template: str) -> str:
    maybe = re.sub(r"\(([^()]*)\)\?", r"[\1]", template).replace("?", "")
    return re.sub(r"\{([^}:]*):[^}]*\}", r"{\1}", maybe).replace("<", "<r_")


def main() -> None:
    """Print how often the acts are right, hassil's and ours, on every third sentence."""
    known = intents()
    for name in FILES[1:]:
        theirs = ours = total = 0
        took: list[float] = []
        for row in list(rows(f"{name}.yaml"))[::3]:
            acts = [act["act"] for act in row.acts]
            began = time.perf_counter()
            found = recognize(row.text, known)
            took.append(time.perf_counter() - began)
            total += 1
            theirs += acts == [found.intent.name if found else "unknown"]
            ours += acts == [act_name(act) for act in understand(row.text, row.listening).acts]
        print(
            f"{name:<8} n={total:<3} acts right: hassil {theirs / total:.3f}"
            f" ({statistics.median(took) * 1e3:.0f} ms), ours {ours / total:.3f}"
        )


if __name__ == "__main__":
    main()
