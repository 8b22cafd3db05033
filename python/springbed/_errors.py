"""What can go wrong."""

from __future__ import annotations

from typing import NamedTuple, Optional

__all__ = ["ComputationError", "Problem", "SceneError"]


class Problem(NamedTuple):
    """One thing that is wrong with a scene."""

    place: str
    """Where: line and column of the text, or the path of a value such as ``bodies.0.young``."""
    message: str
    """What it is, and what would be right."""
    line: Optional[int] = None
    """Line of the text, from 1 on."""
    column: Optional[int] = None
    """Column of the text in characters, from 1 on."""

    def __str__(self) -> str:
        return f"{self.place}: {self.message}"


class SceneError(ValueError):
    """A scene is wrong: everything that is wrong with it, in the order of the text."""

    problems: list[Problem]

    def __init__(self, problems: list) -> None:
        self.problems = [Problem(*problem) for problem in problems]
        super().__init__([tuple(problem) for problem in self.problems])

    def __str__(self) -> str:
        return "\n".join(map(str, self.problems))


class ComputationError(RuntimeError):
    """A scene is right and cannot be followed to its end, or a contact cannot be moved so."""
