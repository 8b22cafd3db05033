"""Height maps pressed on a half-space, pixel by pixel."""

from __future__ import annotations

from typing import TYPE_CHECKING, NamedTuple, Optional, Union

import numpy as np

from . import _springbed

if TYPE_CHECKING:
    from numpy.typing import ArrayLike


class HalfSpace(NamedTuple):
    """A height map pressed on an elastic half-space, in SI units."""

    force: float
    """Normal force [N]."""
    indentation: float
    """Approach [m] of the zero level of the heights and the undeformed surface."""
    contact_area: float
    """Area of the pixels in contact [m²]."""
    contact_radius: float
    """Radius [m] of the contact, from its area."""
    area_fraction: float
    """Part of the map that is in contact."""
    peak_pressure: float
    """Largest pressure [Pa]."""
    residual: float
    """Relative residual, computed from the pressure returned."""
    iterations: int
    """Iterations on the finest grid."""
    pressure: np.ndarray
    """Pressure [Pa] on each pixel."""
    displacement: np.ndarray
    """Displacement [m] of each pixel into the half-space."""


class _Pressed(NamedTuple):
    modulus: float
    force: Optional[float]
    indentation: Optional[float]
    periodic: bool
    tolerance: float


def half_space(
    heights: "ArrayLike",
    pixel: Union[float, tuple[float, float]],
    *,
    modulus: float,
    force: Optional[float] = None,
    indentation: Optional[float] = None,
    periodic: bool = False,
    tolerance: float = 1e-8,
) -> HalfSpace:
    """Press a height map on an elastic half-space without friction or adhesion.

    Parameters
    ----------
    heights
        Heights [m] of the rigid indenter, upwards, away from the half-space: r²/2R of a ball; inf where it has no
        material.
    pixel
        Width and height of a pixel [m], or both in one number.
    modulus
        E* [Pa].
    force, indentation
        What is prescribed, one of the two [N] or [m].
    periodic
        Whether the map repeats; otherwise the half-space goes on without load.
    tolerance
        Relative residual to reach.

    Raises
    ------
    ComputationError
        A height or number makes no sense, or the iteration does not converge.
    """
    if (force is None) == (indentation is None):
        raise TypeError("half_space needs the force or the indentation, one of the two")
    sides = (pixel, pixel) if isinstance(pixel, (int, float)) else tuple(pixel)
    map_ = np.ascontiguousarray(np.asarray(heights, dtype=float))
    pressed = _Pressed(float(modulus), force, indentation, periodic, tolerance)
    return HalfSpace(**_springbed.half_space(map_, list(sides), pressed))
