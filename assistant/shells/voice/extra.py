"""Whether the voice extra is installed, said plainly where it is not."""

from __future__ import annotations

from importlib.util import find_spec

from assistant.errors import BadInput


def require(*modules: str) -> None:
    """Raise BadInput if one of the modules cannot be imported."""
    missing = [module for module in modules if find_spec(module) is None]
    if missing:
        right = "pip install 'teaching-assistant[voice]'"
        raise BadInput.one("voice", f"not installed: {', '.join(missing)}", right)
