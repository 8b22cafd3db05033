"""Parameters of a scene from measured curves, and how sure they are."""

from __future__ import annotations

import json
import os
from collections.abc import Iterable, Mapping, Sequence
from typing import Any, NamedTuple, Optional, Union

import numpy as np

from . import _springbed
from ._result import Figure
from ._scene import SceneLike, plain, source

Data = Union[str, "os.PathLike[str]", Mapping[str, Any]]
Free = Union[Mapping[str, Optional[tuple[Any, Any]]], Iterable[str]]


class Estimate(NamedTuple):
    """A parameter and how sure it is, in its SI unit."""

    value: float
    standard_error: Optional[float]
    """``None`` where the data say nothing of it."""
    low: Optional[float]
    """Lower end of the 95 % interval; ``None`` where there is none in the range."""
    high: Optional[float]
    """Its upper end."""
    unit: str


class Fit:
    """What one curve says of a scene, in SI units."""

    parameters: dict[str, Estimate]
    """By path, such as ``bodies.0.young``; then ``contact_point``, ``baseline``, ``tilt``, as far as they were free."""
    correlations: np.ndarray
    """Of the errors of the parameters, in the same order."""
    chi2: Optional[float]
    """Mean square of what is left in contact over that of the noise before it; ``None`` where no noise is known."""
    rejected: bool
    """Whether the data speak against the scene."""
    notes: list[str]
    """What a user must know."""
    points: dict[str, np.ndarray]
    """The curve, row by row: ``indentation_m`` and ``force_n`` (``speed_m_per_s`` and ``restitution`` of impacts, ``slide_m`` and
    ``tangential_force_n`` of slides), ``model`` (of what answers) and whether the row ``counts``."""

    def __init__(self, parts: dict[str, Any]) -> None:
        summary = json.loads(parts["summary"])
        self._summary = summary
        self._figure = parts["figure"]
        self.parameters = {row.pop("path"): Estimate(**row) for row in summary["parameters"]}
        self.correlations = np.array(summary["correlations"])
        self.chi2 = summary["chi2"]
        self.rejected = summary["rejected"]
        self.notes = summary["notes"]
        self.points = {name: parts[name] for name in parts if name not in ("summary", "figure")}

    def __getitem__(self, path: str) -> float:
        """The value of a parameter."""
        return self.parameters[path].value

    @property
    def scene(self) -> dict[str, Any]:
        """The scene with the values found: it can be run."""
        return self._summary["scene"]["resolved"]

    @property
    def aic(self) -> float:
        """Akaike's criterion up to a constant of the data: of two models the one with the smaller is the better."""
        return self._summary["aic"]

    @property
    def models(self) -> list[dict[str, Any]]:
        """The models that were compared: ``model``, ``bic_beyond_best``, ``weight``, ``parameters`` and more of each."""
        return self._summary["models"]

    def figure(self) -> Figure:
        """The figure of the fit, as ``springbed fit`` draws it."""
        return Figure(self._figure)

    def _repr_svg_(self) -> str:
        return self._figure

    def __repr__(self) -> str:
        lines = [f"{path:24}{row.value:.6g} {interval(row)} {row.unit}" for path, row in self.parameters.items()]
        return "\n".join(lines + [f"note: {note}" for note in self.notes])


def interval(row: Estimate) -> str:
    """The 95 % interval in words."""
    ends = ["?" if end is None else f"{end:.6g}" for end in (row.low, row.high)]
    return f"({ends[0]} .. {ends[1]})"


def fit(
    scene: SceneLike,
    data: Union[Data, Sequence[Data]],
    free: Optional[Free] = None,
    **options: Any,
) -> Union[Fit, list[Fit]]:
    """Find parameters of a scene from measured curves.

    Parameters
    ----------
    scene
        As for :func:`run`; its values are where the search starts, and its ``fit`` says what is not said here.
    data
        The path of a file in any shape (CSV, TSV, decimal commas, lines above the table), or a dict of arrays in SI units:
        ``depth`` or ``indentation_m``, ``force`` or ``force_n`` and, for bodies that relax, ``time`` or ``time_s``
        (``Result.records`` is one); ``speed`` and ``restitution`` of impacts, ``slide`` and ``tangential`` (a force) of
        what is moved along. A list of these gives a list of fits.
    free
        Free parameters: ``{"bodies.0.young": (1e3, 1e6)}``, ``{"bodies.0.young": ("1 kPa", "1 MPa")}``, ``None`` in the
        place of a range for none, or texts ``"bodies.0.young=1 kPa..1 MPa"``.
    **options
        ``columns="depth=z [nm], force=F [nN]"``, ``spring="0.05 N/m"`` (deflection and piezo), ``baseline`` ("absent",
        "constant", "linear", "virtual"), ``contact`` ("free", "zero"), ``drive`` ("depth", "force", "speed", "slide"), ``way`` ("both", "in", "out"),
        ``range="-1 um..300 nm"``, ``robust=True``; ``given={"shape.radius": "2 %"}`` for what is known with a standard error
        only (``spring`` is the cantilever), ``models=["hertz", "jkr", "layered"]`` to compare (``Fit.models``).

    Raises
    ------
    SceneError
        The scene, a parameter or an option is wrong.
    ComputationError
        The curve cannot be fitted.
    """
    given = source(scene)
    asked = json.dumps(settings(free, options), default=plain)
    if isinstance(data, (list, tuple)):
        return [Fit(_springbed.fit(given, asked, measured(one))) for one in data]
    return Fit(_springbed.fit(given, asked, measured(data)))


def settings(free: Optional[Free], options: dict[str, Any]) -> dict[str, Any]:
    """What is asked for, in the words of the ``fit`` of a scene."""
    asked = dict(options)
    if "robust" in asked:
        asked["loss"] = "Robust" if asked.pop("robust") else "Square"
    for name in ("baseline", "contact", "drive", "way"):
        if isinstance(asked.get(name), str):
            asked[name] = asked[name].capitalize()
    if isinstance(asked.get("given"), Mapping):
        asked["given"] = [f"{path}={text(spread)}" for path, spread in asked["given"].items()]
    if isinstance(free, str):
        free = [free]
    if isinstance(free, Mapping):
        free = [path if ends is None else f"{path}={text(ends[0])}..{text(ends[1])}" for path, ends in free.items()]
    if free is not None:
        asked["free"] = list(free)
    return asked


def text(value: Any) -> str:
    """A number or a text with its unit, as a range has it."""
    return value if isinstance(value, str) else repr(float(value))


def measured(data: Data) -> Any:
    """The path of a file, or the arrays of a curve."""
    if not isinstance(data, Mapping):
        return os.path.abspath(os.fspath(data))
    pairs = ((SPEED, RESTITUTION), (SLIDE, TANGENTIAL), (DEPTH, FORCE))
    there = (both(data, pair) for pair in pairs)
    columns = next((pair for pair in there if all(one is not None for one in pair)), None)
    if columns is None:
        found = ", ".join(map(str, data)) or "none"
        raise ValueError(
            f"a curve needs depth and force, speed and restitution, or slide and tangential (found: {found}): "
            "expected arrays by these names"
        )
    time = column(data, ("time", "time_s"))
    return tuple(columns if time is None else [*columns, time])


DEPTH, FORCE = ("depth", "indentation_m"), ("force", "force_n")
SPEED, RESTITUTION = ("speed", "speed_m_per_s"), ("restitution",)
SLIDE, TANGENTIAL = ("slide", "slide_m"), ("tangential", "tangential_force", "tangential_force_n")


def both(data: Mapping[str, Any], names: tuple[tuple[str, ...], tuple[str, ...]]) -> list[Optional[np.ndarray]]:
    """Two columns, each by the first of its names that is there."""
    return [column(data, one) for one in names]


def column(data: Mapping[str, Any], names: tuple[str, ...]) -> Optional[np.ndarray]:
    """The first of some columns that is there, as numbers."""
    found = next((data[name] for name in names if name in data), None)
    return None if found is None else np.ascontiguousarray(found, dtype=float)
