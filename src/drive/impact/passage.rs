//! Impact of elastic bodies: energy alone gives the motion, jump by jump.

use super::{ImpactError, ImpactState, Projectile, Rebound};
use crate::contact::adhesion::line::Energy;
use crate::contact::direct::{Jump, QuasiStatic};
use crate::numerics::chebyshev::Chebyshev;
use crate::numerics::{extremum, root};
use std::convert::Infallible;
use std::f64::consts::PI;

/// The way of a mass through an elastic contact, with or without adhesion.
///
/// At every depth the contact is the one a slow machine of prescribed depth would find, so that
/// ½mv² + stored energy + energy lost in jumps is the kinetic energy at first touch. Without adhesion
/// nothing is lost, e = 1. With attraction of vanishing range on a convex shape the contact jumps on at
/// d = 0 and off at the turning point of the branch: e = √(1 − (v_s/v)²), v_s = √(2W/m) with W the work
/// from the one to the other. A wavy shape jumps on its way too. Below v_s the mass does not come
/// free; it is followed until it rests on its way out.
/// Check: Hertz, contact time 2.943275184324705 x₀/v with x₀ = (15mv²/(16E*√R))^{2/5} (Johnson 1985,
/// eq. 11.23). Valid while v is far below the speed of sound and the edge runs far faster than the mass.
#[derive(Debug, Clone)]
pub struct Passage {
    impact: Projectile,
    legs: Vec<StableStretch>,
    /// Kinetic energy left as the bodies part [J]; `None` if they stay together.
    left: Option<f64>,
    lost: f64,
}

/// A stretch between two jumps, in one direction.
#[derive(Debug, Clone)]
struct StableStretch {
    /// The contact somewhere on this stretch.
    contact: QuasiStatic,
    from: f64,
    to: f64,
    /// Energy lost in jumps before [J].
    spent: f64,
    /// Times [s] over the angle φ, d = from + (to − from) sin²(φ/2), part by part.
    clock: Vec<Chebyshev>,
    /// Estimate of the error of the duration [s].
    error: f64,
}

/// Places in a leg at which the kinetic energy is looked at.
const LOOKS: u32 = 24;
/// Most parts a leg is cut into for its duration.
const MOST_PARTS: usize = 64;
/// Places at which the pace of a part is met.
const PLACES: usize = 32;

impl Passage {
    /// The way of a mass through a contact such as `contact`, from first touch on; `accuracy` is the relative error of the
    /// contact time aimed at (default 1e-6; smaller costs panels of a quadrature that converges fast).
    ///
    /// # Errors
    /// The kinetic energy carries the contact beyond its profile, or an equilibrium is not found.
    pub fn new(contact: &QuasiStatic, impact: Projectile, accuracy: f64) -> Result<Self, ImpactError> {
        let mut passage = Self { impact, legs: Vec::new(), left: None, lost: 0.0 };
        let deepest = passage.inwards(contact.apart())?;
        passage.outwards(deepest)?;
        for leg in &mut passage.legs {
            leg.time(&impact, accuracy);
        }
        Ok(passage)
    }

    /// What comes of the impact.
    #[must_use]
    pub fn rebound(&self) -> Rebound {
        let turn = self.turn();
        let deepest = self.legs.get(turn).map_or(0.0, |leg| leg.to);
        let duration: f64 = self.legs.iter().map(StableStretch::duration).sum();
        let error: f64 = self.legs.iter().map(|leg| leg.error).sum();
        let restitution = self.left.map_or(0.0, |left| (left / self.impact.energy()).max(0.0).sqrt());
        Rebound {
            contact_time: self.left.map(|_| duration),
            greatest_depth: deepest,
            greatest_force: self.deepest().map_or(0.0, |contact| contact.present().balance.force),
            restitution,
            lost: if self.left.is_some() { self.lost } else { self.impact.energy() },
            error: (error / duration.max(f64::MIN_POSITIVE)).max(ROUNDING),
        }
    }

    /// Bytes of its state.
    #[must_use]
    pub fn bytes(&self) -> usize {
        let bytes = |times: &Chebyshev| size_of::<Chebyshev>() + size_of::<f64>() * (1 + times.degree());
        self.legs.iter().map(|leg| size_of::<StableStretch>() + leg.clock.iter().map(bytes).sum::<usize>()).sum()
    }

    /// The contact at the greatest depth.
    #[must_use]
    pub fn deepest(&self) -> Option<QuasiStatic> {
        let leg = self.legs.get(self.turn())?;
        Some(leg.at(leg.to))
    }

    /// States at `count` + 1 equal times from first touch to the end, with those on both sides of the jumps and where the pull
    /// is greatest.
    #[must_use]
    pub fn moments(&self, count: usize) -> Vec<ImpactState> {
        let duration: f64 = self.legs.iter().map(StableStretch::duration).sum();
        let mut moments = vec![self.touch()];
        let mut start = 0.0;
        for leg in &self.legs {
            let end = start + leg.duration();
            let time = |k: usize| duration * k as f64 / count as f64;
            let inside = (1..count).map(time).filter(|&t| t > start && t < end);
            let pull = leg.strongest_pull().map(|phi| (start + leg.time_at(phi), leg.depth(phi)));
            let times = std::iter::once(start).chain(inside).chain(std::iter::once(end));
            let mut places: Vec<(f64, f64)> = times.map(|t| (t, leg.depth_at(t - start))).chain(pull).collect();
            places.sort_by(|one, other| one.0.total_cmp(&other.0));
            moments.extend(places.into_iter().map(|(t, depth)| leg.moment(&self.impact, t, depth)));
            start = end;
        }
        moments.extend(self.parted(start));
        moments.dedup();
        moments
    }

    /// Just before the bodies first act on each other.
    fn touch(&self) -> ImpactState {
        let depth = self.legs.first().map_or(0.0, |leg| leg.from);
        ImpactState { depth, speed: self.impact.speed, ..ImpactState::default() }
    }

    /// Just after they have come free.
    fn parted(&self, time: f64) -> Option<ImpactState> {
        let depth = self.legs.last()?.to;
        let speed = -(2.0 * self.left? / self.impact.mass).sqrt();
        Some(ImpactState { depth, speed, time, dissipated: self.lost, ..self.touch() })
    }

    /// Number of the leg that ends at the greatest depth.
    fn turn(&self) -> usize {
        self.legs.iter().rposition(|leg| leg.to > leg.from).unwrap_or(0)
    }

    /// Kinetic energy [J] on a leg at the depth `d`.
    fn kinetic(&self, leg: &StableStretch, d: f64) -> f64 {
        self.impact.energy() - leg.stored(d).stored() - leg.spent
    }

    /// Follows the contact inwards to where the kinetic energy is used up; the contact there.
    fn inwards(&mut self, mut contact: QuasiStatic) -> Result<StableStretch, ImpactError> {
        let mut from = contact.first_touch();
        // What holds the bodies from the first touch on.
        self.lost += contact.indent(from)?.iter().map(|jump| jump.dissipated).sum::<f64>();
        // Under a flat the reduced profile says nothing of the depth; any length will do, for it doubles.
        let scale = contact.profile().scale();
        let mut step = contact.profile().reduced(scale).min(scale).max(1e-6 * scale).max(from.abs());
        loop {
            let mut ahead = contact.clone();
            match ahead.indent(from + step) {
                Ok(jumps) => {
                    if let Some(leg) = self.walk(contact, (from, from + step), &jumps)? {
                        return Ok(leg);
                    }
                    (contact, from, step) = (ahead, from + step, 2.0 * step);
                }
                Err(_) if step > 1e-9 * (from.abs() + step) && step > f64::MIN_POSITIVE => step *= 0.5,
                Err(_) => {
                    let energy = self.impact.energy() - contact.energy().stored() - self.lost;
                    return Err(ImpactError::BeyondProfile { energy });
                }
            }
        }
    }

    /// Adds the legs between the jumps of a motion; the last one, if the mass comes to rest on it.
    fn walk(
        &mut self,
        mut contact: QuasiStatic,
        (start, end): (f64, f64),
        jumps: &[Jump],
    ) -> Result<Option<StableStretch>, ImpactError> {
        let mut from = start;
        for (k, jump) in jumps.iter().enumerate() {
            let at = jump.before.indentation;
            if let Some(rest) = self.leg(&contact, (from, at))? {
                return Ok(Some(rest));
            }
            self.lost += jump.dissipated;
            let next = jumps.get(k + 1).map_or(end, |next| next.before.indentation);
            contact.indent(if next.is_finite() { 0.5 * (at + next) } else { at })?;
            from = at;
        }
        self.leg(&contact, (from, end))
    }

    /// Adds a leg as far as the mass gets on it; the leg if it rests at its end.
    fn leg(&mut self, contact: &QuasiStatic, (from, to): (f64, f64)) -> Result<Option<StableStretch>, ImpactError> {
        let mut contact = contact.clone();
        contact.indent(0.5 * (from + to))?;
        let mut leg = StableStretch { contact, from, to, spent: self.lost, clock: Vec::new(), error: 0.0 };
        let depth = |k: u32| leg.depth(PI * f64::from(k) / f64::from(LOOKS));
        let rest = (1..=LOOKS).find(|&k| self.kinetic(&leg, depth(k)) < 0.0);
        if let Some(k) = rest {
            let (near, far) = (depth(k - 1), depth(k));
            leg.to = root::brent(|d| self.kinetic(&leg, d), near, far).unwrap_or(near);
        }
        let rests = rest.is_some().then(|| leg.clone());
        match self.legs.last_mut() {
            // A stretch that was cut for no jump is one with the one before.
            Some(last) if last.continues(&leg) => last.to = leg.to,
            _ => self.legs.push(leg),
        }
        Ok(rests)
    }

    /// Follows the contact back to where the bodies part or the mass rests.
    fn outwards(&mut self, deepest: StableStretch) -> Result<(), ImpactError> {
        let contact = deepest.contact.clone();
        let mut back = contact.clone();
        let mut jumps = back.indent(-f64::MAX)?;
        let parting = jumps.pop_if(|jump| jump.after.is_none());
        let end = parting.map_or(contact.first_touch(), |jump| jump.before.indentation);
        if self.walk(contact, (deepest.to, end), &jumps)?.is_some() {
            return Ok(());
        }
        self.lost += parting.map_or(0.0, |jump| jump.dissipated);
        self.left = Some(self.impact.energy() - self.lost).filter(|&left| left > 0.0);
        Ok(())
    }
}

/// Relative error of closed forms, roots within roots included.
const ROUNDING: f64 = 1e-11;

impl StableStretch {
    fn depth(&self, phi: f64) -> f64 {
        let (sine, cosine) = (0.5 * phi).sin_cos();
        // From the nearer end, free of cancellation.
        if phi < 0.5 * PI {
            self.from + (self.to - self.from) * sine * sine
        } else {
            self.to - (self.to - self.from) * cosine * cosine
        }
    }

    /// Whether `next` goes on where this one ends, in the same direction and without a jump.
    fn continues(&self, next: &Self) -> bool {
        let same_way = (self.to - self.from) * (next.to - next.from) > 0.0;
        same_way && self.to.total_cmp(&next.from).is_eq() && self.spent.total_cmp(&next.spent).is_eq()
    }

    /// The contact at the depth `d` of this leg.
    fn at(&self, d: f64) -> QuasiStatic {
        let mut contact = self.contact.clone();
        // On a stable branch between its ends nothing can fail.
        let _ = contact.indent(d);
        contact
    }

    fn stored(&self, d: f64) -> Energy {
        self.at(d).energy()
    }

    fn speed(&self, impact: &Projectile, d: f64) -> f64 {
        let left = impact.energy() - self.stored(d).stored() - self.spent;
        (2.0 * left.max(0.0) / impact.mass).sqrt()
    }

    /// dt/dφ: the half sine takes away the root at the turning point and at the ends of a branch.
    fn pace(&self, impact: &Projectile, phi: f64) -> f64 {
        let speed = self.speed(impact, self.depth(phi));
        if speed > 0.0 { 0.5 * (self.to - self.from).abs() * phi.sin() / speed } else { 0.0 }
    }

    /// Sets the clock, in twice as many parts until the duration changes by less than is aimed at.
    fn time(&mut self, impact: &Projectile, accuracy: f64) {
        let mut parts = 1;
        self.clock = self.clock_of(impact, parts);
        loop {
            let finer = self.clock_of(impact, 2 * parts);
            let before = self.duration();
            self.clock = finer;
            self.error = (self.duration() - before).abs();
            parts *= 2;
            if self.error <= (0.1 * accuracy).min(1e-9) * self.duration() || parts >= MOST_PARTS {
                return;
            }
        }
    }

    /// The times as polynomials: a place at a time is a root of one of them, without another look at the contact.
    fn clock_of(&self, impact: &Projectile, parts: usize) -> Vec<Chebyshev> {
        let width = PI / parts as f64;
        let mut time = 0.0;
        let part = |k: usize| {
            let (low, high) = (width * k as f64, width * (k + 1) as f64);
            let times = Chebyshev::of(|phi| self.pace(impact, phi), PLACES, (low, high)).integral(time);
            time = times.at(high);
            times
        };
        (0..parts).map(part).collect()
    }

    fn duration(&self) -> f64 {
        self.clock.last().map_or(0.0, |times| times.at(PI))
    }

    /// The angle at which the pull of a leg outwards is greatest, unless that is at one of its ends.
    fn strongest_pull(&self) -> Option<f64> {
        if self.to >= self.from {
            return None;
        }
        let pull = |phi: f64| Ok::<_, Infallible>(-self.at(self.depth(phi)).present().balance.force);
        // A pull that is small beside what pressed the bodies is so only just before they part.
        let angle = |k: u32| if k < LOOKS { PI * (1.0 - 0.5f64.powi(k.cast_signed())) } else { PI };
        let angles: Vec<f64> = (0..=LOOKS).map(angle).collect();
        let Ok(turn) = extremum::turn(pull, &angles);
        turn.filter(|peak| peak.value > 0.0).map(|peak| peak.place)
    }

    /// The time [s] of this leg at the angle `phi`.
    fn time_at(&self, phi: f64) -> f64 {
        let part = self.clock.partition_point(|times| times.high() < phi).min(self.clock.len() - 1);
        self.clock[part].at(phi)
    }

    /// The depth at the time `t` of this leg.
    fn depth_at(&self, t: f64) -> f64 {
        let part = self.clock.partition_point(|times| times.at(times.high()) < t).min(self.clock.len() - 1);
        let times = &self.clock[part];
        self.depth(root::within(|phi| times.at(phi) - t, times.low(), times.high()))
    }

    fn moment(&self, impact: &Projectile, time: f64, depth: f64) -> ImpactState {
        let contact = self.at(depth);
        let balance = contact.present().balance;
        let speed = self.speed(impact, depth).copysign(self.to - self.from);
        let (force, radius, stored) = (balance.force, balance.contact_radius, contact.energy());
        ImpactState { time, depth, speed, force, radius, stored, dissipated: self.spent }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::contact::adhesion::line::EdgeLine;
    use crate::contact::adhesion::range::RangeDisc;
    use crate::contact::foundation::Foundation;
    use crate::input::quantity::{Amplitude, Length, Positive};
    use crate::shape::{Cone, FlatPunch, Paraboloid, Profile, TruncatedCone, WavyParaboloid};
    use proptest::prelude::*;
    use std::sync::Arc;

    fn paraboloid(radius: f64) -> Paraboloid {
        Paraboloid { radius: Length::new(radius).unwrap() }
    }

    fn jkr<P: Profile + Clone + 'static>(profile: &P, modulus: f64, work: f64) -> QuasiStatic {
        QuasiStatic::new(EdgeLine::new(Foundation::new(Arc::new(profile.clone()), modulus), work))
    }

    fn passage(contact: &QuasiStatic, mass: f64, speed: f64) -> Passage {
        Passage::new(contact, Projectile { mass, speed }, 1e-9).unwrap()
    }

    /// Kinetic, stored and lost energy at every moment are the kinetic energy at first touch.
    fn ledger(passage: &Passage) -> f64 {
        let mass = passage.impact.mass;
        let total = |m: &ImpactState| 0.5 * mass * m.speed * m.speed + m.stored.stored() + m.dissipated;
        passage.moments(50).iter().map(|m| (total(m) / passage.impact.energy() - 1.0).abs()).fold(0.0, f64::max)
    }

    proptest! {
        /// Hertz over 20 decades; bound: rounding of roots and quadrature.
        #[test]
        fn hertz(m in -100i32..100, v in -50i32..50) {
            let power = |k: i32| 10f64.powf(0.1 * f64::from(k));
            let profile = paraboloid(0.3);
            let contact = jkr(&profile, 7.0, 0.0);
            let impact = Projectile { mass: power(m), speed: power(v) };
            let seen = Passage::new(&contact, impact, 1e-9).unwrap().rebound();
            let depth = (15.0 * impact.mass * impact.speed.powi(2) / (16.0 * 7.0 * 0.3f64.sqrt())).powf(0.4);
            prop_assert!((seen.greatest_depth / depth - 1.0).abs() < 1e-13);
            let time = seen.contact_time.unwrap() * impact.speed / depth;
            prop_assert!((time / 2.943_275_184_324_705 - 1.0).abs() < seen.error, "{time} {:e}", seen.error);
            prop_assert!((seen.restitution - 1.0).abs() < 1e-15);
        }

        /// e = √(1 − (v_s/v)²) for any convex shape, W as the direct path itself loses it over a slow loop;
        /// and the ledger at every moment. Bound: rounding, of e² near the sticking speed.
        #[test]
        fn adhesive(ratio in 2i32..60, cone in prop::bool::ANY, scale in -60i32..60) {
            let length = 10f64.powf(0.1 * f64::from(scale));
            let tip = Cone { slope: Positive::new(0.3).unwrap() };
            let contact = if cone { jkr(&tip, 2.0, 0.7 * length) } else { jkr(&paraboloid(length), 2.0, 0.7 * length) };
            let mut slow = contact.clone();
            let mut lost: f64 = slow.indent(0.0).unwrap().iter().map(|jump| jump.dissipated).sum();
            lost += slow.indent(-f64::MAX).unwrap().iter().map(|jump| jump.dissipated).sum::<f64>();
            let sticking = (2.0 * lost).sqrt();
            let ratio = 0.49 * f64::from(ratio);
            let seen = passage(&contact, 1.0, ratio * sticking);
            let rebound = seen.rebound();
            let exact = (1.0 - ratio.powi(-2)).max(0.0).sqrt();
            prop_assert!((rebound.restitution - exact).abs() < 1e-12, "{} {exact}", rebound.restitution);
            prop_assert_eq!(rebound.sticks(), ratio <= 1.0);
            prop_assert!(ledger(&seen) < 1e-9, "{:e}", ledger(&seen));
        }
    }

    /// Work to detach 7.092196 in units of one (seven digits).
    #[test]
    fn adhesive_ball() {
        let profile = paraboloid(1.0);
        let contact = jkr(&profile, 1.0, 1.0);
        let sticking = (2.0 * 7.092_196f64 / 3.0).sqrt();
        for ratio in [1.01, 1.5, 4.0] {
            let exact = (1.0 - 1.0f64 / (ratio * ratio)).sqrt();
            let seen = passage(&contact, 3.0, ratio * sticking).rebound();
            assert!((seen.restitution / exact - 1.0).abs() < 1e-5, "{}", seen.restitution);
        }
        assert!(passage(&contact, 3.0, 0.99 * sticking).rebound().sticks());
    }

    /// A flat punch is an oscillator: half a period and the depth v√(m/k), k = 2E*b.
    #[test]
    fn flat_punch_is_an_oscillator() {
        let punch = FlatPunch { radius: Length::new(0.5).unwrap() };
        let seen = passage(&jkr(&punch, 2.0, 0.0), 8.0, 3.0).rebound();
        assert!((seen.contact_time.unwrap() / (PI * 2.0) - 1.0).abs() < 1e-12, "{seen:?}");
        assert!((seen.greatest_depth / 6.0 - 1.0).abs() < 1e-12, "{seen:?}");
    }

    /// A wavy adhesive ball jumps from wave to wave, in and out, and loses energy each time.
    #[test]
    fn wavy_ball_closes_its_ledger() {
        let shape = WavyParaboloid {
            radius: Length::new(1.0).unwrap(),
            amplitude: Amplitude::new(2e-3).unwrap(),
            wavelength: Length::new(0.1).unwrap(),
        };
        let contact = jkr(&shape, 1.0, 2e-4);
        let smooth = paraboloid(1.0);
        for speed in [0.05, 0.1, 0.3] {
            let seen = passage(&contact, 1.0, speed);
            assert!(ledger(&seen) < 1e-9, "{speed}: {:e}", ledger(&seen));
            let jumps = seen.legs.len();
            assert!(jumps > 4, "{speed}: {jumps} legs");
            let plain = passage(&jkr(&smooth, 1.0, 2e-4), 1.0, speed).rebound();
            assert!(seen.rebound().restitution < plain.restitution);
        }
    }

    /// Attraction of finite range starts before the bodies touch; the longer it reaches the less is lost.
    #[test]
    fn finite_range_closes_its_ledger() {
        let profile = paraboloid(1.0);
        let mut last = 1.0 + 1e-12;
        for stress in [0.05, 0.5, 2.0] {
            let disc = RangeDisc::new(Foundation::new(Arc::new(profile.clone()), 0.75), 1.0 / PI, stress).unwrap();
            let contact = QuasiStatic::new(disc);
            let seen = passage(&contact, 1.0, 3.0);
            assert!(ledger(&seen) < 1e-9, "{stress}: {:e}", ledger(&seen));
            let restitution = seen.rebound().restitution;
            assert!(restitution < last, "{stress}: {restitution} {last}");
            last = restitution;
        }
    }

    /// A kink in the shape slows the quadrature; the estimate still bounds the true error.
    #[test]
    fn the_error_is_known_where_the_shape_has_a_kink() {
        let shape = TruncatedCone { flat_radius: Length::new(0.3).unwrap(), slope: Positive::new(0.2).unwrap() };
        let contact = jkr(&shape, 1.0, 0.0);
        let coarse = Passage::new(&contact, Projectile { mass: 1.0, speed: 0.1 }, 1e-2).unwrap().rebound();
        let fine = passage(&contact, 1.0, 0.1).rebound();
        let off = coarse.contact_time.unwrap() / fine.contact_time.unwrap() - 1.0;
        assert!(off.abs() <= coarse.error, "{off:e} {:e}", coarse.error);
    }

    /// The records stand where they stand however many there are.
    #[test]
    fn moments_do_not_depend_on_their_number() {
        let profile = paraboloid(1.0);
        let seen = passage(&jkr(&profile, 1.0, 1.0), 3.0, 5.0);
        let (few, many) = (seen.moments(10), seen.moments(100));
        for moment in few {
            let same = many.iter().find(|other| {
                (other.time - moment.time).abs() <= 1e-12 && (other.dissipated - moment.dissipated).abs() < 1e-12
            });
            assert!(same.is_some_and(|other| (other.depth - moment.depth).abs() < 1e-10), "{moment:?}");
        }
    }
}
