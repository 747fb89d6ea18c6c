"""What can go wrong, as values: one root, and under it the two ways a command can end badly.

`BadInput` ends a command with status 2 (what was given cannot be used), `WorkFailed` with
status 1 (what was given is fine, the work did not succeed). A message says what was wrong
and what would be right.
"""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass

_CONTROL = re.compile("[\x00-\x1f\x7f-\x9f\u2028\u2029]")
"""Signs that would break a message in two or move the cursor: a file's name may have them."""


@dataclass(frozen=True, slots=True)
class Problem:
    """One thing wrong with an input.

    Parameters
    ----------
    where : str
        ``file:line`` for files, else the name of the argument or value.
    what : str
        What is wrong.
    right : str
        What would be right; empty if `what` says it already.
    """

    where: str
    what: str
    right: str

    def __str__(self) -> str:
        told = f"{self.where}: {self.what}" if self.where else self.what
        told = f"{told}; {self.right}" if self.right else told
        return _CONTROL.sub(lambda sign: repr(sign.group())[1:-1], told)


class AssistantError(Exception):
    """The root of all errors of this project."""


class BadInput(AssistantError):
    """An input cannot be used; carries every problem found, not only the first."""

    def __init__(self, problems: Sequence[Problem]) -> None:
        self.problems = tuple(problems)
        super().__init__("\n".join(str(problem) for problem in self.problems))

    @classmethod
    def one(cls, where: str, what: str, right: str) -> BadInput:
        """Return the error for a single problem."""
        return cls([Problem(where, what, right)])


class WorkFailed(AssistantError):
    """The input is fine, but the work asked for did not succeed."""


class NothingLearned(WorkFailed):
    """A demonstration taught nothing that could be carried out; the message says why.

    Parameters
    ----------
    message : str
    why : str
        A key such as ``never_closed``, from which speech is made.
    facts : mapping, optional
        What a sentence about it needs.
    """

    def __init__(
        self, message: str, why: str = "", facts: Mapping[str, object] | None = None
    ) -> None:
        self.why = why
        self.facts = dict(facts or {})
        super().__init__(message)
