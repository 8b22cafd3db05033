//! Attraction across the gap on pixels.

use crate::halfspace::Boundary;
use crate::scene::law::ElasticAdhesion;
use ndarray::{Array2, Zip};
use std::f64::consts::PI;

/// Pixels along the ring outside a contact in which an attraction of no range of its own acts.
const RING: f64 = 3.0;

/// Ranges after which what fades is over: less than 2e-8 of its stress and work is left.
const FADED: f64 = 18.0;
/// Part of the stress from which on a pixel of what fades is held.
const HELD: f64 = 0.01;

/// An attractive stress: constant up to a range (Dugdale 1960; Maugis 1992), or (w/ρ) e^(−g/ρ) across the gap g.
///
/// The stress acts in the contact too, where the pressure that keeps the bodies apart carries it. A pixel through which
/// the end of a constant one passes is pulled by the part of it that is nearer, as if the gap were straight across it, so that
/// forces change smoothly.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Attraction {
    /// Work of adhesion w \[J/m²\].
    work: f64,
    /// Attractive stress σ₀ \[Pa\] of bodies that touch.
    pub(super) stress: f64,
    fall: Fall,
}

/// How the stress goes on across the gap.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Fall {
    /// It ends.
    AtOnce,
    /// By a factor e over each range.
    ByAndBy,
}

impl Attraction {
    /// The attraction of a scene on pixels of the side `pixel` \[m\] with the modulus `modulus` E* \[Pa\].
    ///
    /// One of vanishing range is given the range at which the ring it acts in outside a wide contact,
    /// ℓ = πE*w/(4σ₀²) (Dugdale 1960; Maugis 1992), is three pixels long: as they shrink it becomes that of JKR.
    pub(super) fn of(law: ElasticAdhesion, pixel: f64, modulus: f64) -> Option<Self> {
        match law {
            // What has no stress is refused on pixels.
            ElasticAdhesion::None | ElasticAdhesion::Outside { .. } => None,
            ElasticAdhesion::Vanishing { work } => {
                Some(Self { work, stress: (PI * modulus * work / (4.0 * RING * pixel)).sqrt(), fall: Fall::AtOnce })
            }
            ElasticAdhesion::Finite { work, stress } => Some(Self { work, stress, fall: Fall::AtOnce }),
            ElasticAdhesion::Fading { work, range } => Some(Self { work, stress: work / range, fall: Fall::ByAndBy }),
        }
    }

    /// Range δ = w/σ₀ \[m\].
    pub(super) fn range(self) -> f64 {
        self.work / self.stress
    }

    /// Gap \[m\] beyond which nothing pulls.
    pub(super) fn reach(self) -> f64 {
        match self.fall {
            Fall::AtOnce => self.range(),
            Fall::ByAndBy => FADED * self.range(),
        }
    }

    /// Stress \[Pa\] above which a pixel is held.
    pub(super) fn faint(self) -> f64 {
        match self.fall {
            Fall::AtOnce => 0.0,
            Fall::ByAndBy => HELD * self.stress,
        }
    }

    /// e^(−g/ρ), zero where it is over.
    fn faded(self, gap: f64) -> f64 {
        if gap < self.reach() { (-gap / self.range()).exp() } else { 0.0 }
    }

    /// Length \[m\] of the ring outside a wide contact in which it acts.
    pub(super) fn ring(self, modulus: f64) -> f64 {
        PI * modulus * self.work / (4.0 * self.stress * self.stress)
    }

    /// Attractive stress \[Pa\] on each pixel under the gap `gap` \[m\], which differs by twice `half` across it.
    pub(super) fn pull(self, gap: &Array2<f64>, half: &Array2<f64>) -> Array2<f64> {
        if self.fall == Fall::ByAndBy {
            return gap.mapv(|gap| self.stress * self.faded(gap));
        }
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
        if self.fall == Fall::ByAndBy {
            return gap.fold(0.0, |sum, &gap| sum - self.work * self.faded(gap));
        }
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
