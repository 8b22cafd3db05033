"""What comes out of a scene."""

from __future__ import annotations

import json
import os
from functools import cached_property
from typing import TYPE_CHECKING, Any, NamedTuple, Union

import numpy as np

from . import _springbed
from ._scene import Source

if TYPE_CHECKING:
    import pandas

Columns = dict[str, Union[np.ndarray, list[str]]]


class ErrorEstimate(NamedTuple):
    """Estimate of the error of forces and radii."""

    relative: float
    """Relative to the largest force and radius of the scene."""
    basis: str
    """How it was made."""


class Figure:
    """A figure as SVG; it shows itself in a notebook and is saved as SVG, PNG or PDF."""

    def __init__(self, svg: str) -> None:
        self.svg = svg

    def _repr_svg_(self) -> str:
        return self.svg

    def save(self, path: Any, dpi: int = 200) -> None:
        """Write it to a file: SVG, or PNG with ``dpi`` dots per inch, or PDF, by what the name ends with."""
        ending = os.fspath(path).rpartition(".")[2].lower()
        kind = ending if ending in ("png", "pdf") else "svg"
        with open(path, "wb") as file:
            file.write(_springbed.picture(self.svg, kind, dpi))


class Result:
    """Records, fields and named results of one scene, in SI units; units end the names (``force_n``, ``time_s``)."""

    records: Columns
    """One row per record, NaN where a value does not exist: ``time_s``, ``indentation_m``, ``force_n``,
    ``contact_radius_m``, ``stiffness_n_per_m``, ``stored_j``, ``dissipated_j``, with friction ``slide_m`` and more."""
    tables: dict[str, Columns]
    """The other tables by name: ``pressure``, ``stress``, ``impacts``, ``ensemble``, …, as the scene has them."""
    results: dict[str, Union[float, bool, int]]
    """Named results: ``largest_force_n``, ``pull_off_force_n``, ``restitution``, …, as the scene has them."""
    warnings: list[str]
    """Physics a user must know."""
    error_estimate: ErrorEstimate
    """Estimate of the relative error, and how it was made."""

    def __init__(self, parts: dict[str, Any], folder: str) -> None:
        self.records = parts["records"]
        self.tables = parts["tables"]
        self.results = parts["results"]
        self.warnings = parts["warnings"]
        self.error_estimate = ErrorEstimate(*parts["error_estimate"])
        self._plan = parts["plan"]
        self._scene = parts["scene"]
        self._folder = folder

    @property
    def scene(self) -> dict[str, Any]:
        """The scene as it was resolved, all quantities in SI units: it can be changed and run again."""
        return json.loads(self._scene)

    @property
    def plan(self) -> dict[str, Any]:
        """What computed the scene: ``solver``, ``reason``, parts ``used`` and ``left_out``, ``springs``, ``state_bytes``."""
        return json.loads(self._plan)

    @cached_property
    def fields(self) -> dict[str, Columns]:
        """Pressure [Pa] and surface displacement [m] over the radius [m], by what they belong to: ``end of entry 1``, …."""
        table = self.tables.get("pressure", {})
        labels = np.asarray(table.get("profile", []))
        order = list(dict.fromkeys(labels.tolist()))
        numbers = {name: column for name, column in table.items() if name != "profile"}
        return {label: {name: column[labels == label] for name, column in numbers.items()} for label in order}

    def to_pandas(self, table: str = "records") -> "pandas.DataFrame":
        """The records, or another table by its name, as a data frame."""
        import pandas

        return pandas.DataFrame(self.records if table == "records" else self.tables[table])

    def figure(self, style: str = "screen") -> Figure:
        """The figure of the scene, as ``springbed run`` draws it: for a ``screen``, or in the width of one column
        (``paper``, 85 mm) or two (``paper-wide``, 175 mm) of a journal."""
        return Figure(_springbed.figure(Source(self._scene, True, self._folder), style))

    def _repr_svg_(self) -> str:
        return self.figure().svg

    def __repr__(self) -> str:
        lines = [f"{name:32}{value}" for name, value in self.results.items()]
        lines.append(f"{'relative error':32}{self.error_estimate.relative:.0e}")
        lines += [f"warning: {warning}" for warning in self.warnings]
        return "\n".join(lines)
