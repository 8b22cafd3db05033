//! The plain twin: a bed of springs let go one by one, steps of second order.

use crate::contact::viscoelastic::Spectrum;
use crate::contact::viscoelastic::drive::{Bed, Springs};
use crate::contact::viscoelastic::layout::Layout;
use crate::contact::viscoelastic::memory::BedError;
use crate::drive::impact::{Projectile, Rebound};
use crate::numerics::root;
use crate::shape::Profile;
use std::sync::Arc;

/// A viscoelastic half-space that may be hit.
///
/// In a step of the duration h the depth goes straight, with the mean w of the speeds at both ends:
/// m(v₁ − v₀) = −∫F dt. The impulse of the bed along a straight piece is exact, and
/// m(v₁² − v₀²)/2 = −w∫F dt is its work: kinetic energy, stored energy and heat add up to rounding
/// however long the steps. Of second order in h.
#[derive(Debug, Clone)]
pub struct Twin {
    /// Springs' material.
    pub spectrum: Arc<Spectrum>,
    /// Profile of the indenter.
    pub profile: Arc<dyn Profile>,
    /// Number of springs across the largest contact.
    pub springs: usize,
    /// Steps per characteristic time of the impact.
    pub steps: f64,
}

/// Steps after which a mass that does not come back counts as stuck.
const MOST_STEPS: usize = 200_000;

struct TwinFlight<'i> {
    impact: &'i Projectile,
    bed: Springs,
    speed: f64,
    time: f64,
    most: Rebound,
}

impl Twin {
    /// What comes of an impact.
    ///
    /// # Errors
    /// The contact would outgrow the profile.
    pub fn rebound(&self, impact: &Projectile) -> Result<Rebound, BedError> {
        let depth = self.depth_scale(impact);
        let radius = self.profile.edge(depth).ok_or(BedError::BeyondProfile { indentation: depth })?;
        let layout = Layout::graded(self.profile.as_ref(), (radius / 64.0, radius), self.springs);
        let most = Rebound {
            contact_time: None,
            greatest_depth: 0.0,
            greatest_force: 0.0,
            restitution: 0.0,
            lost: 0.0,
            error: 0.0,
        };
        let bed = Springs::new(self.spectrum.clone(), self.profile.clone(), layout);
        let mut flight = TwinFlight { impact, bed, speed: impact.speed, time: 0.0, most };
        let longest = depth / impact.speed / self.steps;
        // The force rises from zero like a root: steps in geometric progression at first.
        let mut step = 1e-6 * longest;
        for _ in 0..MOST_STEPS {
            if flight.step(step)? || flight.speed.abs() < 1e-9 * impact.speed && flight.bed.state().force <= 0.0 {
                break;
            }
            step = longest.min(0.1 * flight.time + 1e-6 * longest);
        }
        Ok(flight.most)
    }

    /// Depth at which the work against E(0) and the dashpot has used up the kinetic energy.
    fn depth_scale(&self, impact: &Projectile) -> f64 {
        let energy = 0.5 * impact.mass * impact.speed * impact.speed;
        let stiff = self.spectrum.instantaneous();
        let work = |d: f64| {
            let Some(a) = self.profile.edge(d) else { return f64::MAX };
            let over = d - self.profile.reduced(a);
            let squares = self.profile.energy_integral(a) + over * (2.0 * self.profile.load_integral(a) + over * a);
            stiff * squares + self.spectrum.viscosity() * impact.speed * a * d - energy
        };
        let mut high = self.profile.reduced(self.profile.scale());
        while work(high) < 0.0 {
            high *= 2.0;
        }
        let mut low = high;
        while work(low) > 0.0 && low > 1e-300 {
            (low, high) = (0.5 * low, low);
        }
        root::brent(work, low, high).unwrap_or(high)
    }
}

impl TwinFlight<'_> {
    /// One step; whether the bodies have parted in it.
    fn step(&mut self, duration: f64) -> Result<bool, BedError> {
        let mean = self.mean_speed(duration)?;
        let parted = mean < 0.0 && !self.bed.impulse_after(mean, duration)?.1;
        let duration = if parted { self.parting(mean, duration)? } else { duration };
        self.bed.advance(mean, duration)?;
        self.speed -= self.bed.bed().impulse() / self.impact.mass;
        self.time += duration;
        let most = &mut self.most;
        most.greatest_depth = most.greatest_depth.max(self.bed.bed().indentation());
        most.greatest_force = most.greatest_force.max(self.bed.bed().force());
        most.restitution = if parted { -self.speed / self.impact.speed } else { 0.0 };
        let kinetic = |v: f64| 0.5 * self.impact.mass * v * v;
        most.lost = kinetic(self.impact.speed) - if parted { kinetic(self.speed) } else { 0.0 };
        most.contact_time = parted.then_some(self.time);
        Ok(parted)
    }

    /// w = v₀ − ½∫F dt/m with the impulse along w itself.
    fn mean_speed(&mut self, duration: f64) -> Result<f64, BedError> {
        let mass = self.impact.mass;
        let mut mean = self.speed - 0.5 * self.bed.bed().force() * duration / mass;
        let mut last: Option<(f64, f64)> = None;
        for _ in 0..20 {
            let impulse = self.bed.impulse_after(mean, duration)?.0;
            let miss = self.speed - 0.5 * impulse / mass - mean;
            let slope = last.map_or(-1.0, |(w, m)| (miss - m) / (mean - w));
            last = Some((mean, miss));
            let better = mean - miss / if slope.is_finite() && slope < -0.5 { slope } else { -1.0 };
            if (better - mean).abs() <= 1e-12 * self.impact.speed {
                break;
            }
            mean = better;
        }
        Ok(mean)
    }

    /// When in the step the last spring is let go.
    fn parting(&mut self, mean: f64, duration: f64) -> Result<f64, BedError> {
        let (mut low, mut high) = (0.0, duration);
        for _ in 0..48 {
            let middle = 0.5 * (low + high);
            let held = self.bed.impulse_after(mean, middle)?.1;
            *(if held { &mut low } else { &mut high }) = middle;
        }
        Ok(high)
    }
}
