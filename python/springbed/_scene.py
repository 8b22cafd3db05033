"""Scenes as Python has them: RON text, paths of files, dicts in the form of JSON."""

from __future__ import annotations

import json
import os
from collections.abc import Mapping
from typing import Any, NamedTuple, Union

SceneLike = Union[str, "os.PathLike[str]", Mapping[str, Any]]


class Source(NamedTuple):
    """The text of a scene, whether it is JSON, and the folder of the tables it names."""

    text: str
    json: bool
    folder: str


def source(scene: SceneLike) -> Source:
    """The text of a scene that is given as RON or JSON text, as the path of a file, or as a dict."""
    if isinstance(scene, Source):
        return scene
    if isinstance(scene, Mapping):
        return Source(json.dumps(scene, default=plain), True, os.getcwd())
    if isinstance(scene, str) and is_text(scene):
        return Source(scene, scene.lstrip().startswith("{"), os.getcwd())
    path = os.fspath(scene)
    with open(path, encoding="utf-8-sig") as file:
        text = file.read()
    named = os.path.splitext(path)[1].lower() == ".json"
    return Source(text, named, os.path.dirname(os.path.abspath(path)))


def is_text(scene: str) -> bool:
    """Whether a string is a scene, not the path of one: it begins with a bracket or a comment, or has several lines."""
    return "\n" in scene or scene.lstrip().startswith(("(", "{", "//", "/*"))


def plain(value: Any) -> Any:
    """A NumPy number or array as JSON has it."""
    if hasattr(value, "tolist"):
        return value.tolist()
    if isinstance(value, os.PathLike):
        return os.fspath(value)
    raise TypeError(f"{value!r} cannot stand in a scene: expected numbers, text, lists and dicts")


def written(values: Mapping[str, Any]) -> list[tuple[str, str]]:
    """Paths with their values in JSON."""
    return [(path, json.dumps(value, default=plain)) for path, value in values.items()]
