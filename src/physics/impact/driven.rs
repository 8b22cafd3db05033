//! Impact on a viscoelastic bed, springs let go one by one.

use super::{Impact, Rebound};
use crate::physics::root;
use crate::physics::shape::Profile;
use crate::physics::viscoelastic::Spectrum;
use crate::physics::viscoelastic::drive::{Bed, Springs};
use crate::physics::viscoelastic::layout::Layout;
use crate::physics::viscoelastic::memory::BedError;
use std::sync::Arc;

/// A viscoelastic half-space that may be hit.
///
/// In a step of the duration h the depth goes straight, with the mean w of the speeds at both ends:
/// m(v₁ − v₀) = −∫F dt. The impulse of the bed along a straight piece is exact, and
/// m(v₁² − v₀²)/2 = −w∫F dt is its work: kinetic energy, stored energy and heat add up to rounding
/// however long the steps. Of second order in h.
#[derive(Debug, Clone)]
pub struct Driven {
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

struct Flight<'i> {
    impact: &'i Impact,
    bed: Springs,
    speed: f64,
    time: f64,
    most: Rebound,
}

impl Driven {
    /// What comes of an impact.
    ///
    /// # Errors
    /// The contact would outgrow the profile.
    pub fn rebound(&self, impact: &Impact) -> Result<Rebound, BedError> {
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
        let mut flight = Flight { impact, bed, speed: impact.speed, time: 0.0, most };
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
    fn depth_scale(&self, impact: &Impact) -> f64 {
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

impl Flight<'_> {
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::physics::material::Relaxation;
    use crate::physics::quantity::Length;
    use crate::physics::shape::Paraboloid;

    /// Kelvin–Voigt ball with δ = (η/E∞)(E∞²Rv/m²)^{1/5}, E∞ = R = m = v = 1.
    fn kelvin_voigt(delta: f64, springs: usize, steps: f64) -> Rebound {
        let relaxation = Relaxation { equilibrium: 1.0, terms: vec![], viscosity: delta };
        let driven = Driven {
            spectrum: Arc::new(Spectrum::new(&relaxation)),
            profile: Arc::new(Paraboloid { radius: Length::new(1.0).unwrap() }),
            springs,
            steps,
        };
        driven.rebound(&Impact { mass: 1.0, speed: 1.0 }).unwrap()
    }

    /// A bed of springs let go one by one; five digits, the last one uncertain.
    #[test]
    fn restitution_of_kelvin_voigt() {
        let table = [(0.01, 0.98089), (0.05, 0.91012), (0.1, 0.83272), (0.2, 0.70673), (0.5, 0.46894), (1.0, 0.28082)];
        for (delta, restitution) in table {
            let seen = kelvin_voigt(delta, 500, 200.0).restitution;
            assert!((seen - restitution).abs() < 1e-5, "{delta}: {seen}");
        }
    }

    /// e = 1 − 1.9412δ + C₂δ² + O(δ³), C₂ = (3/5)·1.9412² + (5/6)(15/16)^{1/5} = 3.0837.
    ///
    /// The first part of C₂ is that of a law that keeps tension (Ramírez et al. 1999); springs that let
    /// go spare the tension of a ring of the width η|ḋ|/(2aE), which is worth η²∫ḋ²dd/(2aE). Bound: the
    /// digits of 1.9412 and a term of 6δ³, which the table above allows for.
    #[test]
    fn small_damping() {
        let second = 0.6 * 1.9412f64.powi(2) + 5.0 / 6.0 * (15.0f64 / 16.0).powf(0.2);
        for delta in [0.001, 0.003] {
            let seen = kelvin_voigt(delta, 1000, 800.0).restitution;
            let series = 1.0 - 1.9412 * delta + second * delta * delta;
            assert!((seen - series).abs() < 5e-5 * delta + 6.0 * delta.powi(3), "{delta}: {seen} {series}");
        }
    }

    /// No damping: Hertz. Bound: second order in springs (0.25·(4.85/500)²) and steps.
    #[test]
    fn without_damping_it_is_hertz() {
        let seen = kelvin_voigt(0.0, 500, 200.0);
        let depth = (15.0f64 / 16.0).powf(0.4);
        assert!((seen.restitution - 1.0).abs() < 1e-5, "{seen:?}");
        assert!((seen.contact_time.unwrap() / depth / 2.943_275_184_324_705 - 1.0).abs() < 1e-4, "{seen:?}");
        assert!((seen.greatest_depth / depth - 1.0).abs() < 1e-4, "{seen:?}");
    }

    /// A Maxwell element so slow, or so fast, that it is elastic.
    #[test]
    fn limits_of_one_term() {
        for (time, stiffness) in [(1e12, 4.0), (1e-12, 1.0)] {
            let relaxation = Relaxation { equilibrium: 1.0, terms: vec![(3.0, time)], viscosity: 0.0 };
            let profile = Arc::new(Paraboloid { radius: Length::new(1.0).unwrap() });
            let driven = Driven { spectrum: Arc::new(Spectrum::new(&relaxation)), profile, springs: 500, steps: 200.0 };
            let seen = driven.rebound(&Impact { mass: 1.0, speed: 1.0 }).unwrap();
            let depth = (15.0f64 / 16.0 / stiffness).powf(0.4);
            assert!((seen.greatest_depth / depth - 1.0).abs() < 1e-4, "{seen:?}");
            assert!((seen.restitution - 1.0).abs() < 1e-5, "{seen:?}");
        }
    }

    /// A liquid without elasticity at long times gives a rebound only if it is hit fast.
    #[test]
    fn liquid_swallows_a_slow_ball() {
        let relaxation = Relaxation { equilibrium: 0.0, terms: vec![(1.0, 1e-3)], viscosity: 0.0 };
        let profile = Arc::new(Paraboloid { radius: Length::new(1.0).unwrap() });
        let driven = Driven { spectrum: Arc::new(Spectrum::new(&relaxation)), profile, springs: 200, steps: 50.0 };
        let seen = driven.rebound(&Impact { mass: 1.0, speed: 1.0 }).unwrap();
        assert!(seen.restitution < 0.05, "{seen:?}");
    }
}
