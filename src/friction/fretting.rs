//! Fretting maps: where in the contact friction takes its energy.
//!
//! # Examples
//! ```
//! use springbed::friction::{FrettingMap, Grip, Pose};
//! use springbed::input::quantity::Length;
//! use springbed::shape::Paraboloid;
//!
//! // R = E* = G* = d = 1, μ = 0.3, shaken by ±0.225: nothing is lost inside a/2, where the springs stick.
//! let ball = Paraboloid { radius: Length::new(1.0)? };
//! let grip = Grip { normal_modulus: 1.0, tangential_modulus: 1.0, coefficient: 0.3 };
//! let mut map = FrettingMap::new(&ball, grip, &[0.0, 0.45, 0.55, 0.9]);
//! for slide in [0.0, 0.225, -0.225, 0.225] {
//!     map.advance(Pose { indentation: 1.0, slide });
//! }
//! let lost = map.energy();
//! assert!(lost[0] == 0.0 && lost[1] == 0.0 && lost[2] > 0.0 && lost[3] > lost[2]);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

use super::turning::{Grip, Pose};
use crate::shape::{Profile, Rim};
use std::f64::consts::FRAC_2_PI;
use std::sync::Arc;

/// Energy lost to friction by spring, gathered along a history: the fretting map.
///
/// The springs stand at chosen distances x from the axis; each follows every straight step exactly.
/// ∫₀^a of the energy per length is the energy lost in the contact.
#[derive(Debug, Clone)]
pub struct FrettingMap {
    grip: Grip,
    at: Pose,
    springs: Vec<MappedSpring>,
}

/// One spring of a map.
#[derive(Debug, Clone, Copy)]
struct MappedSpring {
    x: f64,
    depth: f64,
    slip: f64,
    /// Energy lost, divided by G* [m²].
    lost: f64,
    /// Way slipped since it was last taken [m].
    way: f64,
}

impl FrettingMap {
    /// A map over springs at the distances `positions` ≥ 0 from the axis [m], ascending.
    #[must_use]
    pub fn new(profile: &dyn Profile, grip: Grip, positions: &[f64]) -> Self {
        Self::of_depths(grip, positions.iter().map(|&x| (x, profile.reduced(x))))
    }

    /// A map over springs by distance from the axis and depth [m] at which each is touched, both ascending.
    #[must_use]
    pub fn of_depths(grip: Grip, springs: impl Iterator<Item = (f64, f64)>) -> Self {
        let spring = |(x, depth)| MappedSpring { x, depth, slip: 0.0, lost: 0.0, way: 0.0 };
        Self { grip, at: Pose::default(), springs: springs.map(spring).collect() }
    }

    /// Moves on a straight line to `to`.
    pub fn advance(&mut self, to: Pose) {
        let reach = self.grip.reach();
        for spring in &mut self.springs {
            spring.step((self.at, to), reach);
        }
        self.at = to;
    }

    /// Energy lost per length over x [J/m] at each position, both halves of the bed together.
    #[must_use]
    pub fn energy(&self) -> Vec<f64> {
        self.springs.iter().map(|spring| 2.0 * self.grip.tangential_modulus * spring.lost).collect()
    }
}

/// Energy lost to friction by radius, gathered along a history: the map of wear.
///
/// Energy per area at the radius r [J/m²], ∫ μp(r) ds(r), with the slip of the surface
/// s(r) = (2/π)∫₀^r s(x) dx/√(r²−x²): where the surface slips, no spring further in does, and the
/// shear stress there is μp. ∫ of it over the contact is the energy lost. With Archard's law it is
/// proportional to the depth of wear.
///
/// s(x) is taken as linear between neighbouring positions. While the depth changes, p is the mean of
/// both ends of a step.
#[derive(Debug, Clone)]
pub struct WearMap {
    profile: Arc<dyn Profile>,
    springs: FrettingMap,
    energy: Vec<f64>,
}

impl WearMap {
    /// A map over the radii `radii` ≥ 0 [m], ascending.
    #[must_use]
    pub fn new(profile: Arc<dyn Profile>, grip: Grip, radii: &[f64]) -> Self {
        let springs = FrettingMap::new(profile.as_ref(), grip, radii);
        Self { profile, springs, energy: vec![0.0; radii.len()] }
    }

    /// Moves on a straight line to `to`.
    pub fn advance(&mut self, to: Pose) {
        let from = self.springs.at.indentation;
        let level = (to.indentation - from).abs() <= 0.0;
        if !level {
            self.settle((from, from));
        }
        self.springs.advance(to);
        if !level {
            self.settle((from, to.indentation));
        }
    }

    /// The springs under the surface, at the same positions.
    #[must_use]
    pub fn springs(&self) -> &FrettingMap {
        &self.springs
    }

    /// Energy lost per area [J/m²] at each radius.
    pub fn energy(&mut self) -> &[f64] {
        let depth = self.springs.at.indentation;
        self.settle((depth, depth));
        &self.energy
    }

    /// Turns the ways gathered between two depths into energy per area.
    fn settle(&mut self, depths: (f64, f64)) {
        let springs = &mut self.springs.springs;
        if springs.iter().all(|spring| spring.way <= 0.0) {
            return;
        }
        let depths = [depths.0, depths.1];
        let edges = depths.map(|d| if d > 0.0 { self.profile.edge(d) } else { None });
        let half = 0.5 * self.springs.grip.coefficient * self.springs.grip.normal_modulus;
        for (k, energy) in self.energy.iter_mut().enumerate() {
            let at = |(&edge, d)| pressure(self.profile.as_ref(), springs[k].x, edge, d);
            let pressure: f64 = edges.iter().zip(depths).map(at).sum();
            *energy += half * pressure * surface_slip(&springs[..=k]);
        }
        for spring in springs {
            spring.way = 0.0;
        }
    }
}

/// Pressure at the radius `r` divided by E* [1], at a contact radius and depth.
fn pressure(profile: &dyn Profile, r: f64, edge: Option<f64>, depth: f64) -> f64 {
    let Some(a) = edge.filter(|&a| r < a) else { return 0.0 };
    let load = match profile.rim() {
        Rim::Wall(b) => (depth - profile.reduced(b)).max(0.0),
        Rim::None | Rim::End(_) => 0.0,
    };
    profile.pressure_integral(r, a) + load * profile.edge_pressure(r, a)
}

/// (2/π)∫₀^r s(x) dx/√(r²−x²) at the last spring, s linear between springs.
fn surface_slip(springs: &[MappedSpring]) -> f64 {
    let Some(&last) = springs.last() else { return 0.0 };
    let r = last.x;
    if r <= 0.0 {
        return last.way;
    }
    let turn = |x: f64| (x / r).min(1.0).asin();
    let root = |x: f64| ((r - x) * (r + x)).max(0.0).sqrt();
    let cell = |pair: &[MappedSpring]| {
        let (low, high) = (pair[0], pair[1]);
        let slope = (high.way - low.way) / (high.x - low.x);
        (low.way - slope * low.x) * (turn(high.x) - turn(low.x)) + slope * (root(low.x) - root(high.x))
    };
    let first = springs[0].way * turn(springs[0].x);
    FRAC_2_PI * (first + springs.windows(2).map(cell).sum::<f64>())
}

impl MappedSpring {
    /// Follows a straight step while the spring is in contact.
    fn step(&mut self, (from, to): (Pose, Pose), reach: f64) {
        let (mut low, mut high) = (from.indentation - self.depth, to.indentation - self.depth);
        let (mut start, mut end) = (from.slide, to.slide);
        if low <= 0.0 && high <= 0.0 {
            return;
        }
        let passing = from.slide + low / (low - high) * (to.slide - from.slide);
        if low <= 0.0 {
            (low, start, self.slip) = (0.0, passing, passing);
        }
        if high < 0.0 {
            (high, end) = (0.0, passing);
        }
        let limit = reach * high;
        let slip = end - (end - self.slip).clamp(-limit, limit);
        let way = (slip - self.slip).abs();
        let side = (slip - self.slip).signum();
        let growth = reach * (high - low);
        let rate = growth / (side * (end - start) - growth);
        let mean = if rate.is_finite() { (limit - 0.5 * rate * way).max(0.5 * limit) } else { limit };
        self.slip = slip;
        self.way += way;
        self.lost += way * mean;
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::friction::TangentialMemory;
    use crate::input::quantity::Length;
    use crate::shape::Paraboloid;
    use std::f64::consts::PI;

    /// Both maps sum to the energy lost, over a cycle at constant depth and while the depth changes.
    #[test]
    fn both_maps_sum_to_the_loss() {
        let shape = Paraboloid { radius: Length::new(1.0).unwrap() };
        let grip = Grip { normal_modulus: 1.0, tangential_modulus: 0.8, coefficient: 0.3 };
        let n = 800;
        let cell = 1.0 / f64::from(n);
        let radii: Vec<f64> = (0..n).map(|k| (f64::from(k) + 0.5) * cell).collect();
        let mut memory = TangentialMemory::new(Arc::new(shape.clone()), grip);
        let (mut springs, mut wear) =
            (FrettingMap::new(&shape, grip, &radii), WearMap::new(Arc::new(shape.clone()), grip, &radii));
        let reach = grip.reach();
        for (depth, part) in [(1.0, 0.0), (1.0, 0.6), (1.0, -0.6), (1.0, 0.6), (0.9, 0.5), (0.95, 0.9), (0.95, 3.0)] {
            for to in (1..=4)
                .map(|k| {
                    let from = memory.position();
                    let part = reach * part;
                    let t = 1.0 / f64::from(5 - k);
                    Pose {
                        indentation: from.indentation + t * (depth - from.indentation),
                        slide: from.slide + t * (part - from.slide),
                    }
                })
                .collect::<Vec<_>>()
            {
                memory.advance(to).unwrap();
                springs.advance(to);
                wear.advance(to);
            }
            let lost = memory.state().dissipated;
            let by_spring: f64 = springs.energy().iter().map(|energy| energy * cell).sum();
            let by_radius: f64 = radii.iter().zip(wear.energy()).map(|(r, energy)| 2.0 * PI * r * energy * cell).sum();
            // Sums over cells: second order inside, the root of the pressure at the edge Δx^{3/2}.
            assert!((by_spring - lost).abs() <= 1e-4 * lost, "{by_spring} {lost}");
            assert!((by_radius - lost).abs() <= 5e-3 * lost, "{by_radius} {lost}");
        }
    }
}
