"""Contacts for a time loop of one's own: arrays of them, moved in one call."""

from __future__ import annotations

from typing import TYPE_CHECKING, Callable, NamedTuple, Optional, Sequence, Union

import numpy as np

from . import _springbed

if TYPE_CHECKING:
    from numpy.typing import ArrayLike

Floats = Union[float, Sequence[float], np.ndarray]


class _Parts(NamedTuple):
    shape: str
    size: list[float]
    modulus: Optional[list[float]]
    relaxation: Optional[tuple[float, list[tuple[float, float]], float]]
    work: Optional[list[float]]
    stress: Optional[list[float]]
    tangential_modulus: Optional[list[float]]
    friction: Optional[list[float]]


#: What the makers of contacts take beside the size.
_PARTS = """
Parameters
----------
modulus
    E* [Pa] of elastic bodies, 1/E* = (1−ν₁²)/E₁ + (1−ν₂²)/E₂.
relaxation
    E*(t) of viscoelastic bodies instead: equilibrium modulus [Pa], terms of modulus [Pa] and time [s], viscosity
    [Pa s].
work
    Work of adhesion w [J/m²] (Johnson, Kendall & Roberts).
stress
    Attractive stress σ₀ [Pa] up to the gap w/σ₀ (Maugis).
tangential_modulus, friction
    G* [Pa] and the coefficient μ of Coulomb friction; not with adhesion.
count
    Number of contacts, if no argument is an array.
"""


def _maker(shape: str, about: str) -> "Callable[..., Contact]":
    """A maker of contacts of a shape: one signature and one text for all of them."""

    def make(
        cls: "type[Contact]",
        size: Floats,
        /,
        *,
        modulus: Optional[Floats] = None,
        relaxation: Optional[tuple[float, list[tuple[float, float]], float]] = None,
        work: Optional[Floats] = None,
        stress: Optional[Floats] = None,
        tangential_modulus: Optional[Floats] = None,
        friction: Optional[Floats] = None,
        count: Optional[int] = None,
    ) -> "Contact":
        if (modulus is None) == (relaxation is None):
            raise TypeError("a contact needs its modulus or its relaxation, one of the two")
        if friction is not None and tangential_modulus is None:
            raise TypeError("friction needs the tangential_modulus")
        listed = [_listed(part) for part in (size, modulus, work, stress, tangential_modulus, friction)]
        lengths = {len(part) for part in listed if part is not None} | ({count} if count is not None else set())
        if len(lengths - {1}) > 1:
            raise ValueError(f"arrays of {sorted(lengths - {1})} contacts do not go together: expected one length")
        sizes, moduli, works, stresses, tangential, coefficients = listed
        assert sizes is not None
        parts = _Parts(shape, sizes, moduli, relaxation, works, stresses, tangential, coefficients)
        return cls(_springbed.Contact(parts, max(lengths)))

    make.__name__ = shape
    make.__qualname__ = f"Contact.{shape}"
    make.__doc__ = f"{about}\n{_PARTS}"
    return classmethod(make)  # type: ignore[return-value]


class Contact:
    """Contacts that remember: each has its own state, all are moved together.

    Made by :meth:`sphere`, :meth:`paraboloid` or :meth:`cone`; every argument is one number for all contacts or one for
    each. Everything is in SI units. Contacts without memory of time (elastic ones) need no ``seconds``.

    >>> ball = Contact.paraboloid(0.01, modulus=230.77e9)
    >>> ball.advance(1e-6)
    >>> float(ball.force[0])  # doctest: +ELLIPSIS
    30.76...
    """

    def __init__(self, inner: "_springbed.Contact") -> None:
        self._inner = inner

    sphere = _maker("sphere", "Spheres of the radius R [m].")
    paraboloid = _maker("paraboloid", "Paraboloids of the radius of curvature R [m].")
    cone = _maker("cone", "Cones f = r·slope, of the slope of the flank.")

    def __len__(self) -> int:
        return len(self._inner)

    def copy(self) -> "Contact":
        """The same contacts in the same states, to be moved on their own."""
        return Contact(self._inner.copy())

    def advance(self, depth: ArrayLike, slide: ArrayLike = 0.0, seconds: float = 0.0) -> None:
        """Move on straight lines to indentations ``depth`` [m] and tangential displacements ``slide`` [m].

        ``seconds`` [s] matter to viscoelastic bodies only. Of several contacts that cannot be moved the first is told by
        a :class:`ComputationError`; the others have been moved.
        """
        self._inner.advance(self._array(depth), self._array(slide), float(seconds))

    def press(self, force: ArrayLike) -> None:
        """Move to normal forces [N], nothing sliding; elastic bodies only."""
        self._inner.press(self._array(force))

    @property
    def force(self) -> np.ndarray:
        """Normal forces [N]."""
        return self._inner.state("force")

    @property
    def indentation(self) -> np.ndarray:
        """Indentations [m]; NaN where a pull has parted the bodies."""
        return self._inner.state("indentation")

    @property
    def contact_radius(self) -> np.ndarray:
        """Contact radii [m]."""
        return self._inner.state("contact_radius")

    @property
    def tangential_force(self) -> np.ndarray:
        """Tangential forces [N]; zero without friction."""
        return self._inner.state("tangential_force")

    @property
    def stick_radius(self) -> np.ndarray:
        """Radii of stick [m]; of the whole contact without friction."""
        return self._inner.state("stick_radius")

    @property
    def stiffness(self) -> np.ndarray:
        """Stiffnesses dF/dd [N/m] at constant contact radius."""
        return self._inner.state("stiffness")

    @property
    def stored(self) -> np.ndarray:
        """Stored energies [J]."""
        return self._inner.state("stored")

    @property
    def dissipated(self) -> np.ndarray:
        """Energies lost so far [J], in jumps, by friction or in the material."""
        return self._inner.state("dissipated")

    @property
    def joined(self) -> np.ndarray:
        """Whether the bodies touch or attract each other."""
        return self._inner.state("joined") > 0.0

    def pressure(self, radius: ArrayLike, contact: int = 0) -> np.ndarray:
        """Pressure [Pa] of one contact at radii [m]."""
        return self._inner.pressure(contact, np.atleast_1d(np.asarray(radius, dtype=float)))

    def _array(self, values: ArrayLike) -> np.ndarray:
        array = np.ascontiguousarray(np.atleast_1d(np.asarray(values, dtype=float)))
        if array.shape not in ((1,), (len(self),)):
            raise ValueError(f"an array of the shape {array.shape} for {len(self)} contacts: expected one value or one each")
        return array


def _listed(part: Optional[Floats]) -> Optional[list[float]]:
    if part is None:
        return None
    array = np.atleast_1d(np.asarray(part, dtype=float))
    if array.ndim != 1 or array.size == 0:
        raise ValueError(f"an array of the shape {array.shape}: expected one value or one for each contact")
    return array.tolist()
