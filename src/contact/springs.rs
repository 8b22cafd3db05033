//! The classical bed of N springs, the method under study.
//!
//! Spring i stands on both sides of the axis where the measure of its foundation is s = (i + ½)h, on a
//! half-space at x = (i + ½)h, with the stiffness E*h (Popov & Heß 2015, eq. 3.1). Springs join and part one by one; between two such events the force
//! is linear in the depth, so the work is known exactly and the energy ledger closes.
//!
//! # Examples
//! ```
//! use springbed::contact::springs::SpringBed;
//! use springbed::contact::foundation::Foundation;
//! use springbed::input::quantity::Length;
//! use springbed::shape::Paraboloid;
//! use std::sync::Arc;
//!
//! // Hertz, R = E* = 1: −1/4 ≤ (F_bed/F − 1)(a/h)² ≤ 1/8 while springs are counted, less between them.
//! let ground = Foundation::new(Arc::new(Paraboloid { radius: Length::new(1.0)? }), 1.0);
//! let mut bed = SpringBed::new(ground, 200, 2.0, 0.0);
//! bed.indent(1.0);
//! assert!((bed.force() / (4.0 / 3.0) - 1.0).abs() < 0.25 * 0.01f64.powi(2));
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

use crate::contact::foundation::Foundation;
use crate::contact::spring_loads::{SeenSpring, SpringLoads};
use crate::shape::{Profile, Rim};
use ndarray::Array1;

/// How the contact radius and the force at the edge are read off the bed.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum EdgeLocation {
    /// By counting springs: of first order in the spring width.
    AtSprings,
    /// Between the last spring that holds and the first that does not: of second order.
    BetweenSprings,
}

/// A bed of independent springs under a profile.
#[derive(Debug, Clone)]
pub struct SpringBed {
    ground: Foundation,
    /// Width h of a spring, in the measure [m].
    spacing: f64,
    work_of_adhesion: f64,
    location: EdgeLocation,
    /// g at the springs [m].
    reduced: Array1<f64>,
    /// Depth at which a spring parts: g − Δl [m].
    threshold: Array1<f64>,
    /// Springs in contact, a prefix of the bed.
    attached: usize,
    /// Sum of g over the springs in contact [m].
    attached_sum: f64,
    /// Sum of d − g over the springs in contact [m], carried from event to event.
    deflection: f64,
    wall: bool,
    indentation: f64,
    /// A pull keeps the bodies apart.
    parted: bool,
    work: f64,
}

/// Radius [m] of a bed that is just wide enough for contacts up to the radius `largest` [m].
#[must_use]
pub fn reach_for(profile: &dyn Profile, largest: f64) -> f64 {
    match profile.rim() {
        Rim::Wall(end) if largest >= end => end,
        Rim::None | Rim::Wall(_) | Rim::End(_) if largest > 0.0 => (1.0 + 1.0 / 16.0) * largest,
        Rim::None | Rim::Wall(_) | Rim::End(_) => profile.scale(),
    }
}

impl SpringBed {
    /// `springs` springs on `ground` out to the radius `reach` [m], with the work of adhesion `work` [J/m²].
    #[must_use]
    #[expect(clippy::cast_precision_loss, reason = "no bed has 2^53 springs")]
    pub fn new(ground: Foundation, springs: usize, reach: f64, work: f64) -> Self {
        let spacing = reach / springs as f64;
        let place = |i: usize| (i as f64 + 0.5) * spacing;
        let reduced = Array1::from_shape_fn(springs, |i| ground.depth(place(i)));
        let threshold = Array1::from_shape_fn(springs, |i| reduced[i] - ground.elongation(place(i), work));
        let wall = matches!(ground.profile().rim(), Rim::Wall(end) if reach >= end);
        Self {
            ground,
            spacing,
            work_of_adhesion: work,
            location: EdgeLocation::BetweenSprings,
            reduced,
            threshold,
            attached: 0,
            attached_sum: 0.0,
            deflection: 0.0,
            wall,
            indentation: 0.0,
            parted: false,
            work: 0.0,
        }
    }

    /// The same bed with another way to read the edge.
    #[must_use]
    pub fn with_edge(mut self, location: EdgeLocation) -> Self {
        self.location = location;
        self
    }

    /// Whether a pull keeps the bodies apart.
    #[must_use]
    pub fn is_parted(&self) -> bool {
        self.parted
    }

    /// Number of springs.
    #[must_use]
    pub fn springs(&self) -> usize {
        self.reduced.len()
    }

    /// Bytes of the bed's arrays.
    #[must_use]
    pub fn bytes(&self) -> usize {
        2 * self.springs() * size_of::<f64>()
    }

    /// Moves to the depth `to` [m]: springs join and part one by one on the way.
    pub fn indent(&mut self, to: f64) {
        self.parted = false;
        while let Some(depth) = self.next_to_part().filter(|&depth| depth > to) {
            self.move_to(depth.min(self.indentation));
            self.part();
        }
        while let Some(depth) = self.next_to_join().filter(|&depth| depth <= to) {
            self.move_to(depth.max(self.indentation));
            self.join();
        }
        self.move_to(to);
        self.settle();
    }

    /// Depth [m] at which a retraction to `to` [m] passes its least force, just before a spring parts;
    /// `None` if the force is least at one of its ends, but for the load of a single spring.
    #[must_use]
    #[expect(clippy::cast_precision_loss, reason = "no bed has 2^53 springs")]
    pub fn least_force_above(&self, to: f64) -> Option<f64> {
        let mut sum: f64 = self.reduced.iter().take(self.attached).sum();
        let mut least = (self.attached as f64 * self.indentation - sum, None);
        let mut held = self.attached;
        while let Some(next) = held.checked_sub(1).filter(|&next| self.threshold[next] > to) {
            let depth = self.threshold[next].min(self.indentation);
            let load = held as f64 * depth - sum;
            if load < least.0 {
                least = (load, Some(depth));
            }
            (sum, held) = (sum - self.reduced[next], next);
        }
        let single = if held < self.springs() { self.reduced[held] - self.threshold[held] } else { 0.0 };
        least.1.filter(|_| held as f64 * to - sum > least.0 + single)
    }

    /// Moves to the force `to` [N]; `false` if the bodies part on the way.
    ///
    /// While springs join or part by themselves the machine keeps its force and does its work with it.
    pub fn press(&mut self, to: f64) -> bool {
        let mut held = if self.attached == 0 { 0.0 } else { self.counted_force() };
        if self.attached == 0 && to >= 0.0 {
            self.indentation = self.indentation.max(self.reduced[0].max(0.0));
            self.join();
        }
        while let Some(depth) = self.next_to_join().filter(|&depth| depth <= self.depth_under(to)) {
            let next = self.force_at(depth).max(held).min(to);
            self.move_under((held, next));
            held = next;
            self.join();
        }
        while let Some(depth) = self.next_to_part().filter(|&depth| depth > self.depth_under(to)) {
            let next = self.force_at(depth).min(held).max(to);
            self.move_under((held, next));
            held = next;
            self.part();
        }
        if self.attached > 0 {
            self.move_under((held, to));
        }
        self.settle();
        self.parted = self.attached == 0 && to < 0.0;
        self.attached > 0
    }

    /// Depth [m] below which a retraction from here leaves no spring in contact; 0 without adhesion.
    #[must_use]
    pub fn last_depth(&self) -> f64 {
        self.threshold.iter().take(self.attached).copied().fold(0.0, f64::min)
    }

    /// Depth at which the outermost spring parts, if there is one.
    fn next_to_part(&self) -> Option<f64> {
        let held = self.attached.checked_sub(1)?;
        Some(self.threshold[held])
    }

    /// Depth at which the next spring joins; the first one joins at geometric touch.
    fn next_to_join(&self) -> Option<f64> {
        if self.attached == 0 { self.reduced.first().copied() } else { self.threshold.get(self.attached).copied() }
    }

    fn join(&mut self) {
        self.attached_sum += self.reduced[self.attached];
        self.deflection += self.indentation - self.reduced[self.attached];
        self.attached += 1;
    }

    fn part(&mut self) {
        self.attached -= 1;
        self.attached_sum -= self.reduced[self.attached];
        self.deflection -= self.indentation - self.reduced[self.attached];
    }

    /// Sums anew what rounding has gathered over the events of a motion.
    fn settle(&mut self) {
        self.attached_sum = self.reduced.iter().take(self.attached).sum();
        self.deflection = self.reduced.iter().take(self.attached).map(|g| self.indentation - g).sum();
    }

    fn move_to(&mut self, depth: f64) {
        let before = self.counted_force();
        let path = depth - self.indentation;
        self.indentation = depth;
        self.deflection += self.count() * path;
        self.work += 0.5 * (before + self.counted_force()) * path;
    }

    /// Moves to the depth of the force `to` [N], the machine's force going from `from` to `to`.
    fn move_under(&mut self, (from, to): (f64, f64)) {
        let path = self.depth_under(to) - self.indentation;
        self.indentation += path;
        self.deflection += self.count() * path;
        self.work += 0.5 * (from + to) * path;
    }

    fn depth_under(&self, force: f64) -> f64 {
        (force / (2.0 * self.ground.modulus() * self.spacing) + self.attached_sum) / self.count()
    }

    fn force_at(&self, depth: f64) -> f64 {
        2.0 * self.ground.modulus() * self.spacing * (self.count() * depth - self.attached_sum)
    }

    #[expect(clippy::cast_precision_loss, reason = "no bed has 2^53 springs")]
    fn count(&self) -> f64 {
        self.attached as f64
    }

    /// Sum of the loads of the springs in contact [N].
    fn counted_force(&self) -> f64 {
        2.0 * self.ground.modulus() * self.spacing * self.deflection
    }

    /// Indentation [m].
    #[must_use]
    pub fn indentation(&self) -> f64 {
        self.indentation
    }

    /// Normal force [N].
    #[must_use]
    pub fn force(&self) -> f64 {
        let beyond = self.covered() - self.count() * self.spacing;
        self.counted_force() + 2.0 * self.ground.modulus() * beyond * self.edge_deflection()
    }

    /// Contact radius [m].
    #[must_use]
    pub fn contact_radius(&self) -> f64 {
        self.covered()
    }

    /// Measure of the contact [m].
    fn covered(&self) -> f64 {
        let counted = self.count() * self.spacing;
        if self.attached == 0 || self.location == EdgeLocation::AtSprings || self.at_wall() {
            return counted;
        }
        self.edge_place().map_or(counted, |place| counted + (place - 0.5) * self.spacing)
    }

    fn at_wall(&self) -> bool {
        self.wall && self.attached == self.springs()
    }

    /// Place of the edge between the last spring in contact (0) and the next (1).
    fn edge_place(&self) -> Option<f64> {
        let next = self.threshold.get(self.attached)?;
        let last = self.threshold[self.attached - 1];
        Some(((self.indentation - last) / (next - last)).clamp(0.0, 1.0))
    }

    /// d − g at the edge [m], by interpolation.
    fn edge_deflection(&self) -> f64 {
        let (Some(place), Some(next)) = (self.edge_place_if_any(), self.reduced.get(self.attached)) else { return 0.0 };
        let last = self.reduced[self.attached - 1];
        self.indentation - (last + place * (next - last))
    }

    fn edge_place_if_any(&self) -> Option<f64> {
        if self.attached == 0 { None } else { self.edge_place() }
    }

    /// Elastic energy of the springs [J].
    #[must_use]
    pub fn elastic_energy(&self) -> f64 {
        let squares = self.reduced.iter().take(self.attached).map(|g| (self.indentation - g).powi(2));
        self.ground.modulus() * self.spacing * squares.sum::<f64>()
    }

    /// Energy of the closed surface [J].
    #[must_use]
    pub fn surface_energy(&self) -> f64 {
        -self.work_of_adhesion * self.ground.profile().contact_area(self.count() * self.spacing)
    }

    /// Work done on the bed so far [J].
    #[must_use]
    pub fn work(&self) -> f64 {
        self.work
    }

    /// k(a) [N/m], dF/dd at constant contact radius.
    #[must_use]
    pub fn stiffness(&self) -> f64 {
        self.ground.stiffness(self.contact_radius())
    }
}

impl SpringBed {
    /// Loads of the springs in contact, as a value.
    #[must_use]
    pub fn spring_loads(&self) -> SpringLoads {
        let half = 0.5 * self.spacing;
        let spring = |i: usize| {
            let displacement = self.indentation - self.reduced[i];
            let (place, load) = (half + i as f64 * self.spacing, self.ground.modulus() * displacement);
            SeenSpring { place, load, weight: 2.0 * self.spacing, displacement }
        };
        let edge = self.ground.modulus() * self.edge_deflection();
        SpringLoads::new(self.ground.shared_profile(), self.indentation, self.attached, spring)
            .with_edge(self.contact_radius(), edge)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::input::quantity::Length;
    use crate::shape::Paraboloid;
    use proptest::prelude::*;
    use std::f64::consts::PI;
    use std::sync::Arc;

    fn ground() -> Foundation {
        Foundation::new(Arc::new(Paraboloid { radius: Length::new(1.0).unwrap() }), 1.0)
    }

    proptest! {
        /// The midpoint rule on d − g with a clipped end. With nh = a + δ, |δ| ≤ h/2, the relative error is
        /// −(3/2)(δ/a)² − (1/2)(δ/a)³ + (1+δ/a)(h/a)²/8, so −1/4 ≤ ε(a/h)² ≤ 1/8 + (h/a)²/384, both ends
        /// reached (the upper one at δ = h²/24a).
        #[test]
        fn hertz_stays_in_the_envelope(k in 1i32..400, n in 20usize..400) {
            let d = 1e-3 * (0.3 + 0.0017 * f64::from(k));
            let mut bed = SpringBed::new(ground(), n, 0.04, 0.0).with_edge(EdgeLocation::AtSprings);
            bed.indent(d);
            let exact = 4.0 / 3.0 * d.powf(1.5);
            let scaled = (bed.force() / exact - 1.0) * d / bed.spacing.powi(2);
            let highest = 0.125 + bed.spacing.powi(2) / d / 384.0;
            prop_assert!((-0.25 - 1e-9..=highest + 1e-9).contains(&scaled), "{scaled}");
        }

        /// Depth and force control agree on the way up, and the ledger of an elastic bed closes.
        #[test]
        fn both_controls_agree(k in 1i32..400, n in 20usize..400) {
            let d = 1e-3 * (0.3 + 0.0017 * f64::from(k));
            let mut bed = SpringBed::new(ground(), n, 0.04, 0.0);
            let mut pressed = bed.clone();
            bed.indent(d);
            prop_assert!(pressed.press(bed.counted_force()));
            prop_assert!((pressed.indentation() / d - 1.0).abs() < 1e-12);
            prop_assert!((bed.work() / bed.elastic_energy() - 1.0).abs() < 1e-12);
            bed.indent(0.0);
            prop_assert!(bed.work().abs() < 1e-12 * pressed.elastic_energy());
        }
    }

    /// The force at pull-off: of first order if springs are counted, better between springs.
    #[test]
    fn jkr_edge_lies_between_springs() {
        for springs in [200, 800] {
            let mut bed = SpringBed::new(ground(), springs, 3.0, 1.0);
            bed.indent(0.5);
            bed.indent(-1.2);
            let a = bed.contact_radius();
            let residual = a * a - (2.0 * PI * a).sqrt() + 1.2;
            let h = 3.0 / springs as f64;
            // Linear interpolation of g − Δl over one spring: h²/8 of its second derivative, < 1/2.
            assert!(residual.abs() < h * h, "{residual}");
            let exact = 2.0 * (2.0 / 3.0 * a.powi(3) - a * (2.0 * PI * a).sqrt());
            assert!((bed.force() - exact).abs() < 2.0 * h * h, "{} {exact}", bed.force());
        }
    }
}
