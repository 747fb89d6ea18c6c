"""YAML as people mean it: plain values only, with line numbers, read safely, written stably."""

from assistant.plain_yaml.reading import read_file, read_text, text_of
from assistant.plain_yaml.scalars import json_word
from assistant.plain_yaml.values import Document, Value
from assistant.plain_yaml.writing import tidy, write, write_item

__all__ = [
    "Document",
    "Value",
    "json_word",
    "read_file",
    "read_text",
    "text_of",
    "tidy",
    "write",
    "write_item",
]
