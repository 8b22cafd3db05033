"""Contact mechanics by the method of dimensionality reduction: indentation, adhesion, friction, creep, impact.

>>> import springbed
>>> ball = springbed.run('''(shape: Paraboloid(radius: "10 mm"),
...     bodies: (Elastic(young: "210 GPa", poisson: 0.3), Rigid),
...     history: [Indent(to: "1 um", over: 1)])''')
>>> round(ball.results["largest_force_n"], 4)
30.7692

All quantities that come out are in SI units, which end their names: ``force_n``, ``contact_radius_m``, ``time_s``.
"""

from __future__ import annotations

from typing import Any

from . import _springbed
from ._contact import Contact
from ._errors import ComputationError, Problem, SceneError
from ._fit import Estimate, Fit, fit
from ._half_space import HalfSpace, half_space
from ._result import ErrorEstimate, Figure, Result
from ._scene import SceneLike, source, written
from ._springbed import __version__
from ._sweep import Sweep, sweep

__all__ = [
    "ComputationError",
    "Contact",
    "ErrorEstimate",
    "Estimate",
    "Figure",
    "Fit",
    "HalfSpace",
    "Problem",
    "Result",
    "SceneError",
    "Sweep",
    "__version__",
    "check",
    "fit",
    "half_space",
    "run",
    "sweep",
]


def run(scene: SceneLike, /, **set: Any) -> Result:
    """Compute a scene.

    Parameters
    ----------
    scene
        RON or JSON text, the path of a file, or a dict in the form of JSON (``Result.scene`` is one). Tables that the
        scene names are looked for beside its file, or else in the working folder.
    **set
        Values by path, set before: ``run(scene, **{"bodies.0.young": "2 MPa", "history.0.to": 1e-6})``; numbers in SI
        units, or text with a unit.

    Raises
    ------
    SceneError
        The scene or a value is wrong: ``.problems`` has all of it, with places.
    ComputationError
        The scene is right and cannot be followed to its end.
    """
    given = source(scene)
    return Result(_springbed.run(given, written(set)), given.folder)


def check(scene: SceneLike) -> None:
    """Read a scene and raise :class:`SceneError` with everything that is wrong with it; compute nothing."""
    _springbed.check(source(scene))
