//! One body against a rigid one, and springs in series.

use super::Spectrum;
use super::layered::Under;
use super::power_law::Times;
use crate::input::table::Tables;

/// Moduli of one body against a rigid one; infinite for a rigid body.
pub(super) struct Stiffness {
    pub(super) normal: f64,
    pub(super) tangential: f64,
    /// (1−2ν)/(2(1−ν)), β against a rigid body.
    pub(super) coupling: f64,
}

impl Stiffness {
    pub(super) const RIGID: Self = Self { normal: f64::INFINITY, tangential: f64::INFINITY, coupling: 0.0 };

    pub(super) fn new(normal: f64, poisson: f64) -> Self {
        let tangential = normal * 2.0 * (1.0 - poisson) / (2.0 - poisson);
        Self { normal, tangential, coupling: (0.5 - poisson) / (1.0 - poisson) }
    }
}

/// One of two bodies, alone against a rigid one.
pub(super) struct Alone {
    /// Its moduli at once.
    pub(super) stiffness: Stiffness,
    /// What it relaxes by, if it gives at all.
    pub(super) spectrum: Option<Spectrum>,
    /// What lies below its surface.
    pub(super) under: Under,
}

/// What is known beside a body itself.
#[derive(Clone, Copy)]
pub(super) struct Known<'k> {
    pub(super) tables: &'k dyn Tables,
    pub(super) times: Option<Times>,
}

/// The shares of two springs in the compliance of both in series, and their stiffness; one of them is finite.
pub(super) fn in_series(one: f64, two: f64) -> ((f64, f64), f64) {
    if one <= two {
        let ratio = one / two;
        ((1.0 / (1.0 + ratio), ratio / (1.0 + ratio)), one / (1.0 + ratio))
    } else {
        let ((second, first), together) = in_series(two, one);
        ((first, second), together)
    }
}
