//! Impact on elastic springs that are touched one by one: harmonic motions from touch to touch.
//!
//! # Examples
//! ```
//! use springbed::contact::rough::RoughContact;
//! use springbed::drive::impact::{Projectile, SpringPassage};
//! use springbed::shape::rough::{Rings, RoughLine, RoughnessSpectrum};
//!
//! // Roughness that vanishes leaves a flat, a spring E*L: half a period π√(m/E*L), and all speed given back.
//! let spectrum = RoughnessSpectrum::table(&[(6.4, 1e-30), (64.0, 1e-33)])?;
//! let line = RoughLine::new(&Rings::of(&spectrum, 1.0, 1000)?, 7);
//! let contact = RoughContact::new(&line, 1000, 4.0, None)?;
//! let passage = SpringPassage::elastic(contact.bed(), Projectile { mass: 1.0, speed: 1.0 });
//! let rebound = passage.rebound();
//! assert!((rebound.contact_time.unwrap() - std::f64::consts::FRAC_PI_2).abs() < 1e-9);
//! assert!((rebound.greatest_depth - 0.5).abs() < 1e-9 && rebound.restitution == 1.0);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

use super::{Projectile, Rebound};
use crate::contact::error::ContactError;
use crate::contact::model::{ContactModel, Straight};
use crate::contact::rough::{AdhesiveRough, BedState, RoughBed};
use crate::contact::state::Normal;

/// The way of a mass through a bed of elastic springs, with or without adhesion.
///
/// Between the touch of one spring and that of the next, m d̈ = −F − K(d − d₀) with the force F and the stiffness K at
/// d₀: a harmonic motion, ω² = K/m, whose speed follows from the energy and whose duration from the angle between
/// (v, F/mω) at both ends. Nothing is approximated; what remains is the rounding of sums over the springs. Of bodies
/// that adhere springs close and open as in the slow motion of [`AdhesiveRough`], and what that loses is lost to the mass.
#[derive(Debug, Clone)]
pub struct SpringPassage {
    impact: Projectile,
    /// Where the springs that carry change, first touch, greatest depth and end among them.
    corners: Vec<Corner>,
    /// Number of the corner at the greatest depth.
    turn: usize,
    /// Least and greatest force [N].
    forces: (f64, f64),
    /// Kinetic energy left as the bodies part [J]; `None` if they stay together.
    left: Option<f64>,
}

/// The motion as the springs that carry change.
#[derive(Debug, Clone, Copy)]
struct Corner {
    time: f64,
    depth: f64,
    /// Speed towards the bed [m/s].
    speed: f64,
    /// Force [N] and stiffness [N/m] behind it.
    force: f64,
    stiffness: f64,
}

/// Relative error of the sums over the springs and of the durations.
const ROUNDING: f64 = 1e-12;

impl SpringPassage {
    /// The way through a bed without adhesion: the way out mirrors the way in.
    #[must_use]
    pub fn elastic(bed: &RoughBed, impact: Projectile) -> Self {
        let top = bed.at_energy(impact.energy());
        let mut touches: Vec<BedState> =
            bed.touches().take_while(|touch| touch.indentation < top.indentation).collect();
        touches.push(top);
        let speeds = speeds_below(&touches, impact.mass);
        let mut corners: Vec<Corner> = touches
            .iter()
            .zip(speeds)
            .map(|(at, speed)| Corner {
                time: 0.0,
                depth: at.indentation - bed.first_touch(),
                speed,
                force: at.force,
                stiffness: at.stiffness,
            })
            .collect();
        clock(&mut corners, impact.mass);
        let turn = corners.len() - 1;
        let end = 2.0 * corners[turn].time;
        // On the way out a spring is let go where it was touched: what carries then is what carried before it.
        let mut carried: Vec<f64> = corners[..turn].iter().map(|corner| corner.stiffness).collect();
        carried.rotate_right(usize::from(turn > 0));
        carried.iter_mut().take(1).for_each(|none| *none = 0.0);
        let back: Vec<Corner> = corners[..turn]
            .iter()
            .zip(carried)
            .rev()
            .map(|(corner, stiffness)| Corner { time: end - corner.time, speed: -corner.speed, stiffness, ..*corner })
            .collect();
        corners.extend(back);
        Self { impact, corners, turn, forces: (0.0, top.force), left: Some(impact.energy()) }
    }

    /// The way through a bed that adheres, which just touches.
    ///
    /// # Errors
    /// The contact would reach the ends of its line.
    pub fn adhesive(bed: &AdhesiveRough, impact: Projectile) -> Result<Self, ContactError> {
        let mut way =
            Way { bed: bed.clone(), impact, kinetic: impact.energy(), corners: Vec::new(), forces: (0.0, 0.0) };
        way.inwards()?;
        let turn = way.corners.len() - 1;
        let left = way.outwards();
        let mut corners = way.corners;
        clock(&mut corners, impact.mass);
        Ok(Self { impact, corners, turn, forces: way.forces, left })
    }

    /// What comes of the impact.
    #[must_use]
    pub fn rebound(&self) -> Rebound {
        let energy = self.impact.energy();
        let restitution = self.left.map_or(0.0, |left| (left / energy).sqrt());
        Rebound {
            contact_time: self.left.map(|_| self.duration()),
            greatest_depth: self.corners[self.turn].depth,
            greatest_force: self.forces.1,
            restitution,
            lost: self.left.map_or(energy, |left| energy - left),
            error: ROUNDING,
        }
    }

    /// Greatest pull on the way, the least force [N]; zero where nothing holds.
    #[must_use]
    pub fn pull_off_force(&self) -> f64 {
        self.forces.0
    }

    /// Time [s] from first touch until the bodies part, or the mass rests on its way out.
    #[must_use]
    pub fn duration(&self) -> f64 {
        self.corners.last().map_or(0.0, |corner| corner.time)
    }

    /// Bytes of its state.
    #[must_use]
    pub fn bytes(&self) -> usize {
        self.corners.len() * size_of::<Corner>()
    }

    /// Depth [m] and speed [m/s] at the time `time` [s].
    #[must_use]
    pub fn at(&self, time: f64) -> (f64, f64) {
        let behind = self.corners.partition_point(|corner| corner.time <= time);
        let from = self.corners[behind.saturating_sub(1)];
        from.after(time - from.time, self.impact.mass)
    }

    /// States of `contact`, which just touches, at `count` + 1 equal times from first touch to the end, and just after
    /// the bodies have parted.
    ///
    /// # Errors
    /// The contact is another one, and cannot follow.
    pub fn moments(&self, contact: &mut dyn ContactModel, count: usize) -> Result<Vec<(f64, Normal)>, ContactError> {
        let (deepest, end) = (self.corners[self.turn], self.duration());
        let last = self.corners.last().map_or(0.0, |last| last.depth);
        let mut moments = vec![(0.0, contact.state())];
        let (mut now, mut depth) = (0.0, 0.0);
        let mut go = |to: (f64, f64)| {
            let piece = Straight::between(depth, to.1, to.0 - now);
            (now, depth) = to;
            contact.follow(&piece).map(|_| (to.0, contact.state()))
        };
        let mut turned = false;
        for k in 1..=count {
            let time = if k < count { end * k as f64 / count as f64 } else { end };
            if time > deepest.time && !turned {
                turned = true;
                go((deepest.time, deepest.depth))?;
            }
            moments.push(go((time, if k < count { self.at(time).0 } else { last }))?);
        }
        if self.left.is_some() {
            // What opens at a depth is open just above it.
            let apart = go((end, last - f64::EPSILON * last.abs().max(deepest.depth)))?.1;
            moments.push((end, Normal { indentation: Some(last), ..apart }));
            moments.dedup();
        }
        Ok(moments)
    }
}

/// Speeds [m/s] at states of the bed of which the last is one of rest: from there down only sums of positive terms.
fn speeds_below(states: &[BedState], mass: f64) -> Vec<f64> {
    let mut kinetic = 0.0;
    let mut speeds = vec![0.0];
    for pair in states.windows(2).rev() {
        kinetic += 0.5 * (pair[0].force + pair[1].force) * (pair[1].indentation - pair[0].indentation);
        speeds.push((2.0 * kinetic / mass).sqrt());
    }
    speeds.reverse();
    speeds
}

/// Sets the times of the corners.
fn clock(corners: &mut [Corner], mass: f64) {
    for k in 1..corners.len() {
        corners[k].time = corners[k - 1].time + corners[k - 1].duration(&corners[k], mass);
    }
}

impl Corner {
    /// Time [s] to the next one: ωt is the angle between (v, a) and (v₁, a₁), a = F/mω, whose sine is without
    /// cancellation a(v − v₁) + (a₁ − a)v, v − v₁ = h(F + F₁)/m(v + v₁).
    fn duration(&self, next: &Self, mass: f64) -> f64 {
        let way = next.depth - self.depth;
        if way.abs() <= 0.0 {
            return 0.0;
        }
        let rate = (self.stiffness / mass).sqrt();
        let end = self.force + self.stiffness * way;
        let slowed = way * (self.force + end) / (mass * (self.speed + next.speed));
        let (a, b) = (self.force / (mass * rate), end / (mass * rate));
        let sine = a * slowed + rate * way * self.speed;
        sine.atan2(self.speed * next.speed + a * b) / rate
    }

    /// Depth [m] and speed [m/s] a time [s] after it.
    fn after(&self, time: f64, mass: f64) -> (f64, f64) {
        let rate = (self.stiffness / mass).sqrt();
        if rate <= 0.0 {
            return (self.depth + self.speed * time, self.speed);
        }
        let ((sine, cosine), half) = ((rate * time).sin_cos(), (0.5 * rate * time).sin());
        let pull = self.force / (mass * rate);
        let way = (self.speed * sine - 2.0 * pull * half * half) / rate;
        (self.depth + way, self.speed * cosine - pull * sine)
    }
}

/// A mass on its way through a bed that adheres, event by event.
struct Way {
    bed: AdhesiveRough,
    impact: Projectile,
    /// Kinetic energy [J].
    kinetic: f64,
    corners: Vec<Corner>,
    /// Least and greatest force so far [N].
    forces: (f64, f64),
}

impl Way {
    /// Notes where the springs have changed; `side` is 1 on the way in, −1 on the way out.
    fn corner(&mut self, side: f64) -> Normal {
        let now = self.bed.state();
        let speed = side * (2.0 * self.kinetic / self.impact.mass).sqrt();
        let depth = now.indentation.unwrap_or(0.0);
        self.corners.push(Corner { time: 0.0, depth, speed, force: now.force, stiffness: now.stiffness });
        self.note(now.force);
        now
    }

    fn note(&mut self, force: f64) {
        self.forces = (self.forces.0.min(force), self.forces.1.max(force));
    }

    /// As far in as the kinetic energy carries.
    fn inwards(&mut self) -> Result<(), ContactError> {
        loop {
            let now = self.corner(1.0);
            let from = now.indentation.unwrap_or(0.0);
            let way = self.bed.closes_next() - from;
            let left = self.kinetic - way * (now.force + 0.5 * now.stiffness * way);
            if now.stiffness > 0.0 && (left.is_nan() || left <= 0.0) {
                self.rest(&now, 1.0)?;
                return Ok(());
            }
            self.note(now.force + now.stiffness * way);
            self.kinetic = left;
            self.bed.let_close()?;
        }
    }

    /// Back until the bodies part; the kinetic energy then [J], or `None` if it is used up before.
    fn outwards(&mut self) -> Option<f64> {
        while self.bed.joined() {
            let now = self.bed.state();
            let way = self.bed.opens_next() - now.indentation.unwrap_or(0.0);
            let left = self.kinetic - way * (now.force + 0.5 * now.stiffness * way);
            if left < 0.0 {
                // It is above the depth at which the next spring opens.
                self.rest(&now, -1.0).ok()?;
                return None;
            }
            self.note(now.force + now.stiffness * way);
            self.kinetic = left;
            self.bed.let_open();
            self.corner(-1.0);
        }
        Some(self.kinetic)
    }

    /// Moves to where the mass rests: F x + ½K x² = kinetic energy on the way in.
    fn rest(&mut self, now: &Normal, side: f64) -> Result<(), ContactError> {
        let (force, stiffness) = (side * now.force, now.stiffness);
        let root = (force * force + 2.0 * stiffness * self.kinetic).sqrt();
        let way = if force > 0.0 { 2.0 * self.kinetic / (force + root) } else { (root - force) / stiffness };
        let from = now.indentation.unwrap_or(0.0);
        self.bed.follow(&Straight::between(from, from + side * way, 0.0))?;
        self.kinetic = 0.0;
        self.corner(side);
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::contact::rough::{EdgeWorks, RoughContact};
    use crate::input::quantity::Length;
    use crate::shape::Paraboloid;
    use crate::shape::rough::{Rings, RoughLine, RoughnessSpectrum};

    const MASS: f64 = 2.0;

    /// A line of the length 1 of an rms height of about `height`.
    fn line(height: f64) -> RoughLine {
        let spectrum = RoughnessSpectrum::table(&[(6.4, height * height), (64.0, 1e-3 * height * height)]).unwrap();
        RoughLine::new(&Rings::of(&spectrum, 1.0, 1000).unwrap(), 7)
    }

    fn rough() -> RoughContact {
        RoughContact::new(&line(1e-3), 1000, 3.0, None).unwrap()
    }

    /// Over from a few springs to all of them: the greatest depth takes the kinetic energy, 1e-13 being the rounding of
    /// sums over a thousand springs.
    #[test]
    fn the_greatest_depth_takes_the_kinetic_energy() {
        let contact = rough();
        let bed = contact.bed();
        for speed in [1e-7, 1e-5, 1e-4, 1e-3, 1e-2, 1.0] {
            let impact = Projectile { mass: MASS, speed };
            let passage = SpringPassage::elastic(bed, impact);
            let rebound = passage.rebound();
            let taken = bed.at_indentation(bed.first_touch() + rebound.greatest_depth);
            // The depth counts from first touch, so that ε of the gap is in it.
            let coarse = f64::EPSILON * bed.first_touch().abs() * taken.force / taken.energy;
            assert!((taken.energy / impact.energy() - 1.0).abs() < 1e-13 + 2.0 * coarse, "{speed}");
            assert!((passage.corners[0].speed / speed - 1.0).abs() < 1e-13 + coarse, "{speed}");
            assert!((rebound.restitution - 1.0).abs() <= 0.0 && rebound.lost.abs() <= 0.0);
        }
    }

    /// Against m d̈ = −F in steps (Verlet), whose error is (ωh)²/24 of a motion of half a period of N steps,
    /// (π/N)²/24 = 1e-11 for N = 2e5; kinks where springs are touched add as much again.
    #[test]
    fn an_elastic_impact_is_that_of_small_steps() {
        let contact = rough();
        let bed = contact.bed();
        for speed in [1e-4, 1e-3, 1e-2] {
            let passage = SpringPassage::elastic(bed, Projectile { mass: MASS, speed });
            let rebound = passage.rebound();
            let (steps, end) = (200_000, passage.duration());
            let step = end / f64::from(steps);
            let braked = |depth: f64| bed.at_indentation(bed.first_touch() + depth).force / MASS;
            let (mut depth, mut fast, mut brake) = (0.0, speed, 0.0);
            let mut off: f64 = 0.0;
            for k in 1..=steps {
                depth += step * (fast - 0.5 * step * brake);
                let before = std::mem::replace(&mut brake, braked(depth));
                fast -= 0.5 * step * (before + brake);
                if k % 1000 == 0 && k < steps {
                    let (right, speed) = passage.at(step * f64::from(k));
                    off = off
                        .max((depth - right).abs() / rebound.greatest_depth)
                        .max((fast - speed).abs() / rebound.greatest_depth * end / 10.0);
                }
            }
            assert!(off < 1e-8 && depth.abs() < 1e-8 * rebound.greatest_depth, "{speed}: {off:e} {depth:e}");
        }
    }

    /// Roughness that vanishes leaves Hertz's impact, T = 2.943275 (15/16)^{2/5} (m²/E*²Rv)^{1/5}, to the order of the
    /// springs, (a/Δx)⁻² = 1e-4.
    #[test]
    fn vanishing_roughness_is_the_impact_of_the_ball() {
        let ball = Paraboloid { radius: Length::new(1.0).unwrap() };
        let contact = RoughContact::new(&line(1e-15), 1000, 1e6, Some(&ball)).unwrap();
        // ½mv² = (8/15) E*√R d^{5/2} with d = 0.01.
        let speed = (2.0 * 8.0 / 15.0 * 1e6 * 1e-5 / MASS).sqrt();
        let rebound = SpringPassage::elastic(contact.bed(), Projectile { mass: MASS, speed }).rebound();
        let time = 2.943_275_184_324_705 * 0.9375f64.powf(0.4) * (MASS * MASS / (1e12 * speed)).powf(0.2);
        assert!((rebound.greatest_depth / 0.01 - 1.0).abs() < 2e-4, "{rebound:?}");
        assert!((rebound.contact_time.unwrap() / time - 1.0).abs() < 2e-4, "{rebound:?} {time}");
    }

    fn adhesive(opening: f64, closing: f64) -> AdhesiveRough {
        AdhesiveRough::new(&line(1e-3), 1000, 3.0, None, EdgeWorks { opening, closing }).unwrap()
    }

    /// Without work of adhesion the springs that close one by one are the elastic bed. Bound: rounding of their sums.
    #[test]
    fn without_work_an_adhesive_impact_is_the_elastic_one() {
        for speed in [1e-4, 1e-3, 1e-2] {
            let impact = Projectile { mass: MASS, speed };
            let one = SpringPassage::adhesive(&adhesive(0.0, 0.0), impact).unwrap().rebound();
            let two = SpringPassage::elastic(rough().bed(), impact).rebound();
            assert!(one.difference(&two) < 1e-10 && one.lost.abs() < 1e-10 * impact.energy(), "{one:?} {two:?}");
        }
    }

    /// Kinetic energy, what is stored and what is lost are the energy at first touch at all times; a mass that is fast
    /// enough comes free with less speed, a slow one sticks. Bound: rounding of the sums over the springs.
    #[test]
    fn the_energy_of_an_adhesive_impact_adds_up() {
        for (opening, closing) in [(1e-4, 1e-4), (1e-4, 3e-5), (1e-4, 0.0)] {
            let mut contact = adhesive(opening, closing);
            let impact = Projectile { mass: MASS, speed: 2e-2 };
            let passage = SpringPassage::adhesive(&contact, impact).unwrap();
            let rebound = passage.rebound();
            assert!(rebound.lost > 1e-5 * impact.energy() && rebound.restitution > 0.1, "{rebound:?}");
            let slow = Projectile { speed: 3e-5, ..impact };
            assert!(SpringPassage::adhesive(&contact, slow).unwrap().rebound().sticks());
            let moments = passage.moments(&mut contact, 50).unwrap();
            for (time, normal) in &moments {
                let (depth, speed) = passage.at(*time);
                assert!((normal.indentation.unwrap() - depth).abs() < 1e-12 * rebound.greatest_depth);
                let all = 0.5 * MASS * speed * speed + normal.stored.stored() + normal.dissipated;
                assert!((all / impact.energy() - 1.0).abs() < 1e-10, "{time}: {all:e} {:e}", impact.energy());
            }
            let last = moments.last().unwrap().1;
            assert!(last.force.abs() <= 0.0 && (last.dissipated / rebound.lost - 1.0).abs() < 1e-9, "{last:?}");
            assert!(passage.pull_off_force() < 0.0);
        }
    }

    /// Against m d̈ = −F in 40000 steps whose force is that at their beginning: of first order, ωh = 1e-4.
    #[test]
    fn an_adhesive_impact_is_that_of_small_steps() {
        let (mut contact, impact) = (adhesive(1e-5, 3e-6), Projectile { mass: MASS, speed: 5e-3 });
        let passage = SpringPassage::adhesive(&contact, impact).unwrap();
        let rebound = passage.rebound();
        let step = passage.duration() / 40_000.0;
        let (mut depth, mut fast, mut time) = (0.0, impact.speed, 0.0);
        contact.follow(&Straight::between(0.0, 0.0, 0.0)).unwrap();
        while contact.joined() {
            fast -= step * contact.state().force / MASS;
            let from = depth;
            depth += step * fast;
            contact.follow(&Straight::between(from, depth, step)).unwrap();
            time += step;
        }
        assert!((-fast / impact.speed - rebound.restitution).abs() < 1e-3, "{fast:e} {rebound:?}");
        assert!((time / rebound.contact_time.unwrap() - 1.0).abs() < 1e-3, "{time:e} {rebound:?}");
    }
}
