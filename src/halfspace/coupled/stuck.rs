//! Shear under Coulomb's law on pressures that are given.

use super::response::{Along, CoupledResponse, Work};
use crate::halfspace::HalfSpaceError;
use crate::halfspace::vector::{dot, fold};

/// States that a step may be worse than before it is cut short.
const LOOK_BACK: usize = 10;
/// Part of the fall that is foreseen which a step must bring.
const ENOUGH: f64 = 1e-4;

/// Shear that the bounds let through, where the surface would go without it.
///
/// Sought is the least of ½ q·Aq + q·w with |q| ≤ g on each pixel: where |q| < g nothing slips, Aq + w = 0, and where
/// |q| = g what slips does so against the shear (Kalker 1990, § 4.2). Found by projected gradients with steps of the
/// inverse curvature (Birgin, Martínez & Raydan 2000).
pub(super) struct Stuck<'b> {
    pub(super) response: &'b CoupledResponse,
    /// Largest shear stress g \[Pa\].
    pub(super) bounds: &'b [f64],
    /// Slip w \[m\] that there would be without shear.
    pub(super) free: &'b Along,
    /// Slip \[m\] that is none.
    pub(super) tolerance: f64,
    pub(super) most: usize,
}

/// Shear and the slip under it.
pub(super) struct Found {
    pub(super) shear: Along,
    /// Slip Aq + w \[m\].
    pub(super) slip: Along,
    /// Largest miss of the law \[m\].
    pub(super) residual: f64,
}

impl Stuck<'_> {
    /// From the shear `start`.
    pub(super) fn solve(&self, start: &Along, work: &mut Work) -> Result<Found, HalfSpaceError> {
        let mut shear = start.clone();
        self.project(&mut shear);
        let mut slip = self.slip(&shear, work);
        let compliance = self.response.compliance();
        let (mut step, mut energy) = (compliance.recip(), 0.0);
        let mut behind = [energy; LOOK_BACK];
        let mut residual = f64::INFINITY;
        for iteration in 0..self.most {
            residual = self.residual(&shear, &slip);
            if residual <= self.tolerance {
                // What rounding has added on the way is taken off.
                let slip = self.slip(&shear, work);
                let residual = self.residual(&shear, &slip);
                return Ok(Found { shear, slip, residual });
            }
            let change = self.change(&shear, &slip, step);
            let moved = self.response.by_shear(&change, work);
            let (fall, bend) = (both(&slip, &change), both(&change, &moved));
            let most = behind.iter().copied().fold(f64::NEG_INFINITY, f64::max);
            let whole = energy + fall + 0.5 * bend <= most + ENOUGH * fall;
            let part = if whole || bend <= 0.0 { 1.0 } else { (-fall / bend).min(1.0) };
            energy += part * (fall + 0.5 * part * bend);
            behind[iteration % LOOK_BACK] = energy;
            add(&mut shear, part, &change);
            add(&mut slip, part, &moved);
            if bend > 0.0 {
                step = both(&change, &change) / bend;
            }
        }
        Err(HalfSpaceError::NotConverged { iterations: self.most, residual, tolerance: self.tolerance })
    }

    fn slip(&self, shear: &Along, work: &mut Work) -> Along {
        let mut slip = self.response.by_shear(shear, work);
        add(&mut slip, 1.0, self.free);
        slip
    }

    /// From the shear to what a step against the slip and the bounds make of it.
    fn change(&self, shear: &Along, slip: &Along, step: f64) -> Along {
        let mut change = shear.clone();
        add(&mut change, -step, slip);
        self.project(&mut change);
        add(&mut change, -1.0, shear);
        change
    }

    fn project(&self, [x, y]: &mut Along) {
        for ((x, y), &bound) in x.iter_mut().zip(y).zip(self.bounds) {
            let size = length(*x, *y);
            if size > bound {
                let part = if bound > 0.0 { bound / size } else { 0.0 };
                (*x, *y) = (part * *x, part * *y);
            }
        }
    }

    /// How far the law is missed: by the slip where shear may still grow, and by what turns it where it may not.
    fn residual(&self, shear: &Along, slip: &Along) -> f64 {
        let compliance = self.response.compliance();
        let miss = |index: usize| {
            let bound = self.bounds[index];
            if bound <= 0.0 {
                return 0.0;
            }
            let [x, y] = [0, 1].map(|axis| shear[axis][index] - slip[axis][index] / compliance);
            let size = length(x, y);
            let part = if size > bound { bound / size } else { 1.0 };
            compliance * length(part * x - shear[0][index], part * y - shear[1][index])
        };
        fold(self.bounds.len(), |range| range.map(miss).fold(0.0, f64::max), 0.0, f64::max)
    }
}

/// Length of a vector whose squares are numbers, faster than `hypot`.
fn length(x: f64, y: f64) -> f64 {
    (x * x + y * y).sqrt()
}

/// Σ of the products of both parts.
pub(super) fn both(one: &Along, other: &Along) -> f64 {
    dot(&one[0], &other[0]) + dot(&one[1], &other[1])
}

/// Adds `part` of a field.
pub(super) fn add(to: &mut Along, part: f64, field: &Along) {
    for (to, field) in to.iter_mut().zip(field) {
        crate::halfspace::vector::update(to, field, |place, value| *place += part * value);
    }
}
