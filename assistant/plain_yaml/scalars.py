"""What a word of YAML is: a number, true, false, nothing, or text.

Only what a person means at sight is a number: ``1e-3`` and ``-.5`` are, ``3:30``, ``0x10``,
``1_000`` and dates are text; so are ``yes``, ``no``, ``on`` and ``off``.
Differs: from YAML 1.1, where these are booleans and 210.
"""

from __future__ import annotations

import json
import re
from numbers import Integral, Real

Plain = str | int | float | bool | None

NUMBER = re.compile(r"[-+]?(?:[0-9]+(?:\.[0-9]*)?|\.[0-9]+)(?:[eE][-+]?[0-9]+)?")
LONGEST_WHOLE = 19
"""Signs of a whole number; longer ones are read as floating point."""
_WORDS: dict[str, Plain] = {
    **dict.fromkeys(("", "~", "null", "Null", "NULL"), None),
    **dict.fromkeys(("true", "True", "TRUE"), True),
    **dict.fromkeys(("false", "False", "FALSE"), False),
    **dict.fromkeys((".nan", ".NaN", ".NAN"), float("nan")),
    **dict.fromkeys((".inf", ".Inf", ".INF", "+.inf", "+.Inf", "+.INF"), float("inf")),
    **dict.fromkeys(("-.inf", "-.Inf", "-.INF"), float("-inf")),
}
_NUMBER_STARTS = frozenset("0123456789+-.")
_NEVER_FIRST = frozenset("-?:,[]{}#&*!|>'\"%@`~=")
_FLOW = re.compile(r"[\[\]{},]|:\?")
_NOT_PLAIN = re.compile(
    r": |:$| #|[\x00-\x1f\x7f-\xa0\u2028\u2029\ufeff\ud800-\udfff]|[\ufffe\uffff]"
)
_ESCAPED = re.compile("[\x7f-\xa0\u2028\u2029\ufeff\ufffe\uffff]")
_LONE_SURROGATE = re.compile("[\ud800-\udfff]")


def meaning(word: str) -> Plain:
    """Return the value of a word written without quotes."""
    if word[:1] in _NUMBER_STARTS and NUMBER.fullmatch(word):
        whole = len(word) <= LONGEST_WHOLE and word.lstrip("+-").isdigit()
        return int(word) if whole else float(word)
    return _WORDS.get(word, word)


def scalar_text(value: Plain, *, in_flow: bool) -> str:
    """Return the text whose meaning is `value`, quoted only where it must be."""
    if value is None:
        return "null"
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, Integral):
        return str(int(value))
    if isinstance(value, Real):
        return _float_text(float(value))
    text = str(value)
    return text if _is_plain(text, in_flow=in_flow) else _quoted(text)


def _float_text(value: float) -> str:
    if value != value:
        return ".nan"
    if value in (float("inf"), float("-inf")):
        return ".inf" if value > 0 else "-.inf"
    return repr(value)


def _is_plain(text: str, *, in_flow: bool) -> bool:
    if not text or text != text.strip() or not isinstance(meaning(text), str):
        return False
    if text[0] in _NEVER_FIRST or _NOT_PLAIN.search(text) or text.startswith(("---", "...")):
        return False
    return not (in_flow and _FLOW.search(text))


def _quoted(text: str) -> str:
    return json_word(_LONE_SURROGATE.sub("\ufffd", text))


def json_word(value: object) -> str:
    """Return a value as JSON that is YAML too: letters YAML does not take are spelled."""
    quoted = json.dumps(value, ensure_ascii=False)
    return _ESCAPED.sub(lambda found: f"\\u{ord(found.group()):04x}", quoted)
