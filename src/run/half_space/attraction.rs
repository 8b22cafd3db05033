//! Attraction across the gap on pixels.

use super::within;
use crate::halfspace::Boundary;
use crate::scene::law::ElasticAdhesion;
use ndarray::Array2;
use std::f64::consts::PI;

/// Pixels along the ring outside a contact in which an attraction of no range of its own acts.
const RING: f64 = 3.0;

/// Ranges after which what fades is over: less than 2e-8 of its stress and work is left.
const FADED: f64 = 18.0;
/// Part of a range by which what ends does so before.
const SHORT_OF: f64 = 1e-9;
/// Part of the stress from which on a pixel of what fades is held.
const HELD: f64 = 0.01;

/// An attractive stress: constant up to a range (Dugdale 1960; Maugis 1992), or (w/ρ) e^(−g/ρ) across the gap g.
///
/// The stress acts in the contact too, where the pressure that keeps the bodies apart carries it. A pixel through which
/// the end of a constant one passes is pulled by the part of it that is nearer ([`within`]), so that forces change smoothly.
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

    /// Range \[m\] of what ends, short of it by a little: where it is exactly as far, nothing is left but rounding.
    fn end(self) -> f64 {
        self.range() * (1.0 - SHORT_OF)
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

    /// Range ρ \[m\] of what fades.
    pub(super) fn fading(self) -> Option<f64> {
        (self.fall == Fall::ByAndBy).then(|| self.range())
    }

    /// Attractive stress \[Pa\] across the gap `gap` \[m\].
    pub(super) fn at(self, gap: f64) -> f64 {
        match self.fall {
            _ if gap >= self.reach() => 0.0,
            Fall::AtOnce => self.stress,
            Fall::ByAndBy => self.stress * (-gap / self.range()).exp(),
        }
    }

    /// Energy \[J/m²\] across the gap `gap` \[m\], zero far apart.
    pub(super) fn energy_at(self, gap: f64) -> f64 {
        match self.fall {
            Fall::AtOnce => -self.stress * (self.range() - gap).max(0.0),
            Fall::ByAndBy => -self.range() * self.at(gap),
        }
    }

    /// Length \[m\] of the ring outside a wide contact in which it acts.
    pub(super) fn ring(self, modulus: f64) -> f64 {
        PI * modulus * self.work / (4.0 * self.stress * self.stress)
    }

    /// Attractive stress \[Pa\] on each pixel under the gap `gap` \[m\].
    pub(super) fn pull(self, gap: &Array2<f64>, boundary: Boundary) -> Array2<f64> {
        match self.fall {
            Fall::AtOnce => self.stress * within::shares(gap, self.end(), boundary),
            Fall::ByAndBy => gap.mapv(|gap| self.at(gap)),
        }
    }

    /// Energy of the attraction \[J per m² of a pixel\], zero far apart.
    pub(super) fn energy(self, gap: &Array2<f64>, boundary: Boundary) -> f64 {
        match self.fall {
            Fall::AtOnce => -self.stress * within::depth(gap, self.end(), boundary),
            Fall::ByAndBy => gap.fold(0.0, |sum, &gap| sum + self.energy_at(gap)),
        }
    }
}
