//! Attraction across the gap on pixels.

use crate::halfspace::Boundary;
use crate::scene::law::ElasticAdhesion;
use ndarray::{Array2, Zip};
use std::f64::consts::PI;

/// Pixels along the ring outside a contact in which an attraction of no range of its own acts.
const RING: f64 = 3.0;

/// A constant attractive stress up to a range (Dugdale 1960; Maugis 1992).
///
/// The stress acts in the contact too, where the pressure that keeps the bodies apart carries it. A pixel through which
/// the end of the range passes is pulled by the part of it that is nearer, as if the gap were straight across it, so that
/// forces change smoothly.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Attraction {
    /// Work of adhesion w \[J/m²\].
    work: f64,
    /// Attractive stress σ₀ \[Pa\].
    pub(super) stress: f64,
}

impl Attraction {
    /// The attraction of a scene on pixels of the side `pixel` \[m\] with the modulus `modulus` E* \[Pa\].
    ///
    /// One of vanishing range is given the range at which the ring it acts in outside a wide contact,
    /// ℓ = πE*w/(4σ₀²) (Dugdale 1960; Maugis 1992), is three pixels long: as they shrink it becomes that of JKR.
    pub(super) fn of(law: ElasticAdhesion, pixel: f64, modulus: f64) -> Option<Self> {
        match law {
            ElasticAdhesion::None => None,
            ElasticAdhesion::Vanishing { work } => {
                Some(Self { work, stress: (PI * modulus * work / (4.0 * RING * pixel)).sqrt() })
            }
            ElasticAdhesion::Finite { work, stress } => Some(Self { work, stress }),
        }
    }

    /// Range δ = w/σ₀ \[m\].
    pub(super) fn range(self) -> f64 {
        self.work / self.stress
    }

    /// Length \[m\] of the ring outside a wide contact in which it acts.
    pub(super) fn ring(self, modulus: f64) -> f64 {
        PI * modulus * self.work / (4.0 * self.stress * self.stress)
    }

    /// Attractive stress \[Pa\] on each pixel under the gap `gap` \[m\], which differs by twice `half` across it.
    pub(super) fn pull(self, gap: &Array2<f64>, half: &Array2<f64>) -> Array2<f64> {
        Zip::from(gap).and(half).map_collect(|&gap, &half| {
            let near = self.range() - gap;
            if near >= half {
                self.stress
            } else if near <= -half {
                0.0
            } else {
                self.stress * 0.5 * (near + half) / half
            }
        })
    }

    /// Energy of the attraction \[J per m² of a pixel\], zero far apart.
    pub(super) fn energy(self, gap: &Array2<f64>, half: &Array2<f64>) -> f64 {
        Zip::from(gap).and(half).fold(0.0, |sum, &gap, &half| {
            let near = self.range() - gap;
            sum - self.stress
                * if near >= half {
                    near
                } else if near <= -half {
                    0.0
                } else {
                    0.25 * (near + half).powi(2) / half
                }
        })
    }
}

/// Half of what the gap \[m\] differs across each pixel.
pub(super) fn half_differences(gap: &Array2<f64>, boundary: Boundary) -> Array2<f64> {
    Array2::from_shape_fn(gap.dim(), |at| half_difference(gap, at, boundary))
}

/// Half of what the gap differs across a pixel, where it is known on both sides.
fn half_difference(gap: &Array2<f64>, (row, column): (usize, usize), boundary: Boundary) -> f64 {
    let (rows, columns) = gap.dim();
    let next = |index: usize, count: usize| match boundary {
        Boundary::Periodic => [(index + count - 1) % count, (index + 1) % count],
        Boundary::Free => [index.saturating_sub(1), (index + 1).min(count - 1)],
    };
    let ([above, below], [left, right]) = (next(row, rows), next(column, columns));
    let difference = |one: f64, other: f64| {
        let difference = 0.25 * (one - other).abs();
        if difference.is_finite() { difference } else { 0.0 }
    };
    difference(gap[[above, column]], gap[[below, column]]) + difference(gap[[row, left]], gap[[row, right]])
}
