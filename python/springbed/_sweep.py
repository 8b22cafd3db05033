"""Sweeps: one scene with many values, on all cores or on a cluster."""

from __future__ import annotations

import json
from collections.abc import Mapping
from typing import TYPE_CHECKING, Any, Optional, Union

import numpy as np

from . import _springbed
from ._result import Columns
from ._scene import SceneLike, Source, plain, source

if TYPE_CHECKING:
    import pandas

CHUNKS_PER_THREAD = 4
"""Chunks for each thread of a cluster: more balance the load better, fewer cost less to send."""
LEAST_ROWS = 64
"""Least rows of a chunk; sending one costs as much as computing some."""

LAST = ("error_estimate", "warnings", "failure")
"""Columns after the results."""

Set = list[tuple[str, str, bool]]


class Sweep:
    """The rows of a sweep by columns, in SI units."""

    columns: Columns
    """All columns: the paths varied, the named results, ``error_estimate``, ``warnings``, and ``failure`` where a row
    could not be computed."""
    paths: list[str]
    """Paths of what is varied."""

    def __init__(self, columns: Columns, paths: list[str]) -> None:
        self.columns = columns
        self.paths = paths

    def __len__(self) -> int:
        return len(self.columns["warnings"])

    def __getitem__(self, name: str) -> Any:
        return self.columns[name]

    @property
    def parameters(self) -> Columns:
        """The values of every row, by path."""
        return {path: self.columns[path] for path in self.paths}

    @property
    def results(self) -> Columns:
        """The named results of every row; NaN where a row does not have one."""
        other = {*self.paths, "error_estimate", "warnings", "failure"}
        return {name: column for name, column in self.columns.items() if name not in other}

    @property
    def failures(self) -> dict[int, str]:
        """Why rows could not be computed, by their numbers."""
        return {row: why for row, why in enumerate(self.columns.get("failure", [])) if why}

    def to_pandas(self) -> "pandas.DataFrame":
        """All columns as a data frame."""
        import pandas

        return pandas.DataFrame(self.columns)

    def __repr__(self) -> str:
        return f"Sweep of {len(self)} rows over {', '.join(self.paths)}: {', '.join(self.results)}"


def sweep(
    scene: SceneLike,
    values: Optional[Mapping[str, Any]] = None,
    client: Any = None,
    *,
    zip: bool = False,
) -> Sweep:
    """Compute a scene with many values.

    Parameters
    ----------
    scene
        RON or JSON text, the path of a file, or a dict in the form of JSON.
    values
        Values by path, such as ``{"bodies.0.young": np.geomspace(1e3, 1e6, 50), "adhesion.work": ["10 mJ/m^2", 0.05]}``:
        numbers in SI units, text with a unit, or ranges as on the command line, ``"1kPa..1MPa:50log"``. Several paths
        make a grid, the last one fastest. Without values, those that the scene says itself in ``sweep``.
    client
        A ``dask.distributed.Client``: chunks of rows are computed by its workers, gathered in order; the work of a lost
        worker is done again by another. Tables that the scene names must be where the workers find them.
    zip
        Values of all paths side by side instead of a grid.

    Raises
    ------
    SceneError
        A path or value is wrong. A row that cannot be computed is no error but has a ``failure``.
    """
    given = source(scene)
    set = [one(path, each) for path, each in (values or {}).items()]
    count, paths = _springbed.rows(given, set, zip)
    if client is None:
        return Sweep(_springbed.sweep(given, set, zip, (0, count)), paths)
    size = chunk_of(count, client)
    firsts = list(range(0, count, size))
    ends = [min(first + size, count) for first in firsts]
    futures = client.map(chunk, firsts, ends, given=given, set=set, side_by_side=zip, pure=False)
    return Sweep(joined(client.gather(futures)), paths)


def chunk(first: int, end: int, given: Source, set: Set, side_by_side: bool) -> Columns:
    """Some rows of a sweep, where a worker computes them."""
    return _springbed.sweep(Source(*given), set, side_by_side, (first, end))


def one(path: str, values: Any) -> tuple[str, str, bool]:
    """A path with its values: as the command line has them, or a list in JSON."""
    if isinstance(values, str):
        return path, values, True
    listed = values.tolist() if hasattr(values, "tolist") else values
    listed = list(listed) if isinstance(listed, (list, tuple, range)) else [listed]
    return path, json.dumps(listed, default=plain), False


def chunk_of(count: int, client: Any) -> int:
    """Rows of a chunk."""
    threads = sum(client.nthreads().values()) or 1
    return max(LEAST_ROWS, -(-count // (CHUNKS_PER_THREAD * threads)))


def joined(chunks: list[Columns]) -> Columns:
    """Chunks one below the other; a column that a chunk does not have is NaN or empty there."""
    names = list(dict.fromkeys(name for columns in chunks for name in columns))
    # What is not a result stands after the results, as in one piece.
    names.sort(key=lambda name: LAST.index(name) if name in LAST else -1)
    return {name: stacked([(columns.get(name), len(columns["warnings"])) for columns in chunks]) for name in names}


def stacked(pieces: list[tuple[Union[np.ndarray, list[str], None], int]]) -> Union[np.ndarray, list[str]]:
    """One column from its pieces, each with its number of rows."""
    if any(isinstance(piece, list) for piece, _ in pieces):
        words: list[str] = []
        for piece, rows in pieces:
            words += [""] * rows if piece is None else [as_word(word) for word in piece]
        return words
    return np.concatenate([np.full(rows, np.nan) if piece is None else np.asarray(piece) for piece, rows in pieces])


def as_word(value: Any) -> str:
    """A cell of a column of words."""
    return value if isinstance(value, str) else "" if np.isnan(value) else repr(float(value))
