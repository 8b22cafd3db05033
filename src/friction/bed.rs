//! The plain bed of Coulomb springs, twin of the memory of turning points.
//!
//! # Examples
//! ```
//! use springbed::friction::{CoulombBed, Grip, Pose};
//! use springbed::input::quantity::Length;
//! use springbed::shape::Paraboloid;
//!
//! // The same numbers spring by spring: F_x → μF = 0.4 as the whole contact slips.
//! let ball = Paraboloid { radius: Length::new(1.0)? };
//! let grip = Grip { normal_modulus: 1.0, tangential_modulus: 1.0, coefficient: 0.3 };
//! let mut bed = CoulombBed::new(&ball, grip, 1000.try_into()?, 1.1)?;
//! let forces = bed.advance(&[Pose { indentation: 1.0, slide: 0.0 }, Pose { indentation: 1.0, slide: 1.0 }]);
//! assert!(forces[0].abs() < 1e-15 && (forces[1] - 0.4).abs() < 1e-5);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

use super::FrictionError;
use super::turning::{Grip, Pose};
use crate::shape::Profile;
use ndarray::Array1;
use std::num::NonZeroUsize;

/// Springs that go through a whole history while they are in cache.
const BLOCK: usize = 2048;

/// Springs updated side by side; their sum is formed in this order on every machine.
const LANES: usize = 8;

/// N equal springs under one half of the contact, at the middle of their cells of width Δx.
///
/// Each spring sticks until |q_x| = μq: its slip s is moved to the nearest value with
/// |u − s| ≤ m (d − g), m = μE*/G* (radial return). For a straight step this is exact spring by
/// spring, because a spring touched or left within the step is followed from or to that instant;
/// what remains is the sum over springs, whose error is at most μE*dΔx (half a cell of the variation
/// of q_x, which is at most μE*d, on either side).
#[derive(Debug, Clone)]
pub struct CoulombBed {
    grip: Grip,
    width: f64,
    /// Depth g(x) at which each spring is touched, ascending.
    depths: Array1<f64>,
    slips: Array1<f64>,
    at: Pose,
}

/// A straight step as all springs of a bed see it.
#[derive(Clone, Copy)]
struct BedStep {
    from: Pose,
    to: Pose,
    reach: f64,
}

impl CoulombBed {
    /// A bed of `springs` springs between the axis and the distance `radius` [m].
    ///
    /// # Errors
    /// The profile ends before `radius`.
    #[expect(clippy::cast_precision_loss, reason = "no bed has 2^53 springs")]
    pub fn new(profile: &dyn Profile, grip: Grip, springs: NonZeroUsize, radius: f64) -> Result<Self, FrictionError> {
        let width = radius / springs.get() as f64;
        let depths = Array1::from_shape_fn(springs.get(), |k| profile.reduced((k as f64 + 0.5) * width));
        if depths.iter().any(|depth| depth.is_nan()) {
            return Err(FrictionError::BeyondRadius { radius });
        }
        Ok(Self::of_depths(depths, grip, width))
    }

    /// A bed of springs of the width `width` [m], touched at the depths `depths` [m], which ascend.
    #[must_use]
    pub fn of_depths(depths: Array1<f64>, grip: Grip, width: f64) -> Self {
        Self { grip, width, slips: Array1::zeros(depths.len()), depths, at: Pose::default() }
    }

    /// Moves on straight lines along `path`; the tangential force [N] at each of its points.
    ///
    /// Springs do not know of each other, so a block of them goes the whole way at once.
    pub fn advance(&mut self, path: &[Pose]) -> Vec<f64> {
        let mut sums = vec![0.0; path.len()];
        let (depths, slips) = (self.depths.as_slice().unwrap_or(&[]), self.slips.as_slice_mut().unwrap_or(&mut []));
        for (depths, slips) in depths.chunks(BLOCK).zip(slips.chunks_mut(BLOCK)) {
            let mut from = self.at;
            for (&to, sum) in path.iter().zip(&mut sums) {
                *sum += BedStep { from, to, reach: self.grip.reach() }.take(depths, slips);
                from = to;
            }
        }
        self.at = path.last().copied().unwrap_or(self.at);
        let scale = 2.0 * self.grip.tangential_modulus * self.width;
        sums.iter().map(|sum| scale * sum).collect()
    }

    /// Tangential displacements v [m] of all springs; zero outside the contact.
    #[must_use]
    pub fn displacements(&self) -> Array1<f64> {
        let at = self.at;
        let spring = |(&depth, &slip): (&f64, &f64)| if depth < at.indentation { at.slide - slip } else { 0.0 };
        self.depths.iter().zip(&self.slips).map(spring).collect()
    }

    /// Depths g(x) [m] at which the springs are touched.
    #[must_use]
    pub fn depths(&self) -> &Array1<f64> {
        &self.depths
    }
}

impl BedStep {
    /// Moves the springs of a block; Σ v over those in contact.
    fn take(self, depths: &[f64], slips: &mut [f64]) -> f64 {
        let touched = |position: Pose| depths.partition_point(|&depth| depth < position.indentation);
        let (before, after) = (touched(self.from), touched(self.to));
        for (depth, slip) in depths.iter().zip(slips.iter_mut()).take(after).skip(before) {
            *slip = self.slide_at(*depth);
        }
        match (depths.get(..after), slips.get_mut(..after)) {
            (Some(depths), Some(slips)) => self.relax(depths, slips),
            _ => 0.0,
        }
    }

    /// The slide at which the step passes the depth `depth`.
    fn slide_at(self, depth: f64) -> f64 {
        let fraction = (depth - self.from.indentation) / (self.to.indentation - self.from.indentation);
        self.from.slide + fraction * (self.to.slide - self.from.slide)
    }

    /// Radial return of springs in contact; Σ v.
    fn relax(self, depths: &[f64], slips: &mut [f64]) -> f64 {
        let mut sums = [0.0; LANES];
        let (mut lanes, mut rows) = (slips.chunks_exact_mut(LANES), depths.chunks_exact(LANES));
        for (slips, depths) in lanes.by_ref().zip(rows.by_ref()) {
            for k in 0..LANES {
                sums[k] += self.spring(depths[k], &mut slips[k]);
            }
        }
        let rest = lanes.into_remainder().iter_mut().zip(rows.remainder());
        sums.iter().sum::<f64>() + rest.map(|(slip, &depth)| self.spring(depth, slip)).sum::<f64>()
    }

    /// Radial return of one spring; its displacement v.
    #[inline]
    fn spring(self, depth: f64, slip: &mut f64) -> f64 {
        let limit = self.reach * (self.to.indentation - depth);
        let free = self.to.slide - *slip;
        // Comparisons instead of min and max: no NaN comes here, and they are single instructions.
        let held = if free > limit { limit } else { free };
        let held = if held < -limit { -limit } else { held };
        *slip = self.to.slide - held;
        held
    }
}
