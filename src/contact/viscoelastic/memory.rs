//! The continuous bed: no springs to count, no error of discretization.
//!
//! At any time the contact is a disc 0 ≤ x < a and the state of a spring depends on the height
//! c = g(x) of the indenter above it only. The bed falls into a few strips that share their past;
//! within one motion the edge moves outwards first, then inwards, each at most once (see
//! [`spring`](super::spring)), so that two roots per motion place it. The force is
//! F = 2E∞ ∫₀^a (d − g) dx + Σ ∫ 2 sᵢ dx, the second part an integral over each strip, made once when
//! the strip comes to be and evolved like a spring from then on.

use super::Spectrum;
use super::attraction::{Attraction, Tear};
use super::ledger::Ledger;
use super::opening::{Edge, Opening};
use super::spring::{Motion, Spring};
use super::strip::{Detail, Ground, Past, Strip};
use crate::contact::error::BedError;
use crate::contact::model::Straight;
use crate::numerics::root;
use crate::shape::Profile;
use std::sync::Arc;

/// Bed without discretization in space or time.
#[derive(Debug, Clone)]
pub struct Memory {
    pub(super) ground: Ground,
    pub(super) strips: Vec<Strip>,
    /// Number of strips pressed; they come first.
    pub(super) pressed: usize,
    depth: f64,
    speed: f64,
    time: f64,
    work: f64,
}

impl Memory {
    /// A bed never touched, the indenter just above it.
    #[must_use]
    pub fn new(spectrum: Arc<Spectrum>, profile: Arc<dyn Profile>) -> Self {
        let ground = Ground { spectrum, profile, attraction: None };
        Self { ground, strips: Vec::new(), pressed: 0, depth: 0.0, speed: 0.0, time: 0.0, work: 0.0 }
    }

    /// The bed with an attraction that holds the edge; to be given before the first touch.
    #[must_use]
    pub fn with(mut self, attraction: Attraction) -> Self {
        self.ground.attraction = Some(attraction);
        self
    }

    /// When in a motion the bodies part [s] by the attraction giving way; `None` if they do not.
    ///
    /// # Errors
    /// As [`advance`](Self::advance).
    pub fn parting(&self, speed: f64, duration: f64) -> Result<Option<f64>, BedError> {
        let motion = Motion { start: self.depth, speed, duration };
        let reached = self.reached(&motion)?;
        let law = self.ground.attraction.filter(|_| speed <= 0.0 && reached > 0.0);
        Ok(law.and_then(|law| self.opened(&law, &motion, reached).parting()))
    }

    /// Moves at constant `speed` [m/s] for `duration` [s].
    ///
    /// # Errors
    /// The contact would outgrow the profile.
    pub fn advance(&mut self, speed: f64, duration: f64) -> Result<(), BedError> {
        self.follow(&Motion { start: self.depth, speed, duration }, Detail::Energy)
    }

    /// Moves to the depth `to` [m] in `duration` [s], and lands on it to the last bit.
    ///
    /// # Errors
    /// As [`advance`](Self::advance).
    pub fn reach(&mut self, to: f64, duration: f64) -> Result<(), BedError> {
        self.advance((to - self.depth) / duration, duration)?;
        self.depth = to;
        Ok(())
    }

    /// Moves along a straight piece, and lands on its end to the last bit.
    ///
    /// # Errors
    /// As [`advance`](Self::advance).
    pub fn follow_line(&mut self, line: &Straight) -> Result<(), BedError> {
        self.advance(line.speed, line.duration)?;
        self.depth = line.to;
        Ok(())
    }

    /// Takes the indenter far away at once, whatever holds the edge.
    pub fn leave(&mut self) {
        let attraction = self.ground.attraction;
        let held = if self.pressed > 0 { self.ground.profile.reduced(self.radius()) } else { 0.0 };
        let away = self.depth - 4.0 * (self.depth.abs() + held + self.ground.profile.reduced(self.reached_so_far()));
        self.ground.attraction = attraction.map(Attraction::without_work);
        // Upwards no profile ends.
        let _ = self.reach(away, self.ground.spectrum.instant());
        self.ground.attraction = attraction;
    }

    /// The largest radius ever touched [m].
    fn reached_so_far(&self) -> f64 {
        self.strips.last().map_or(0.0, |strip| strip.outer)
    }

    /// The bed after a motion, this one left as it is.
    ///
    /// # Errors
    /// As [`advance`](Self::advance).
    pub fn after(&self, speed: f64, duration: f64) -> Result<Self, BedError> {
        let mut bed = self.clone();
        bed.advance(speed, duration)?;
        Ok(bed)
    }

    /// The force [N] and contact radius [m] after a motion, without the energies.
    ///
    /// # Errors
    /// As [`advance`](Self::advance).
    pub fn force_after(&self, speed: f64, duration: f64) -> Result<(f64, f64), BedError> {
        let mut bed = self.clone();
        bed.follow(&Motion { start: self.depth, speed, duration }, Detail::Force)?;
        Ok((bed.force(), bed.radius()))
    }

    fn follow(&mut self, motion: &Motion, detail: Detail) -> Result<(), BedError> {
        let before = self.radius();
        let reached = self.reached(motion)?;
        let (left, tear) = self.kept(motion, reached);
        self.work += self.steady_work(motion, before.min(left));
        for x in [self.dropped(motion, before), before, reached, left] {
            self.cut(x);
        }
        for k in 0..self.strips.len() {
            self.step(k, (before, reached, left), (motion, detail));
            // Springs touched or let go in this motion are without sums still.
            let strip = &mut self.strips[k];
            if strip.totals.is_none() && strip.past.age <= 0.0 && strip.past.motion == *motion {
                strip.past.torn = tear.clone().filter(|_| !strip.past.pressed);
                self.work += settled(&self.ground, strip, detail);
            }
        }
        self.reach_out(reached, (motion, detail));
        self.pressed = self.strips.iter().take_while(|strip| strip.past.pressed).count();
        (self.depth, self.speed, self.time) = (motion.end(), motion.speed, self.time + motion.duration);
        Ok(())
    }

    /// The largest radius touched in the motion, at least the present one.
    fn reached(&self, motion: &Motion) -> Result<f64, BedError> {
        for strip in &self.strips[self.pressed..] {
            if self.gap(strip, strip.outer, motion) > 0.0 {
                let gap = |x: f64| self.gap(strip, x, motion);
                return Ok(root::brent(gap, strip.inner, strip.outer).unwrap_or(strip.inner));
            }
        }
        let touched = self.strips.last().map_or(0.0, |strip| strip.outer);
        if motion.end() <= 0.0 || motion.speed <= 0.0 {
            return Ok(touched);
        }
        let edge = self.ground.profile.edge(motion.end());
        edge.map(|x| x.max(touched)).ok_or(BedError::BeyondProfile { indentation: motion.end() })
    }

    /// Least distance of the indenter from the free spring at `x` during the motion; negative if touched.
    fn gap(&self, strip: &Strip, x: f64, motion: &Motion) -> f64 {
        let c = self.ground.profile.reduced(x);
        let Spring::Free(free) = strip.past.spring(&self.ground, c) else { return 0.0 };
        let t = self.ground.spectrum.narrowest(&free, &Motion { start: motion.start - c, ..*motion });
        self.ground.spectrum.recovered(&free, t) - (motion.depth(t) - c)
    }

    /// The radius still pressed at the end of a motion that `reached` so far, and how the rest was torn off.
    fn kept(&self, motion: &Motion, reached: f64) -> (f64, Option<Arc<Tear>>) {
        if motion.speed > 0.0 || reached <= 0.0 {
            return (reached, None);
        }
        let Some(attraction) = &self.ground.attraction else {
            return (if motion.speed < 0.0 { self.left(motion, reached) } else { reached }, None);
        };
        let opened = self.opened(attraction, motion, reached);
        let tear = opened.tear(|x| self.ground.profile.reduced(x));
        (opened.left, Some(Arc::new(tear)))
    }

    /// How the edge that an attraction holds opens in a motion that `reached` so far.
    fn opened(&self, attraction: &Attraction, motion: &Motion, reached: f64) -> Opening {
        let load = |x: f64, motion: &Motion| self.continued_load(x, motion);
        Edge { load: &load, attraction, motion: *motion }.open_from(reached)
    }

    /// The radius beyond which a dashpot lets go at once as the motion begins: a border of its own.
    fn dropped(&self, motion: &Motion, before: f64) -> f64 {
        let drops = self.ground.spectrum.viscosity() > 0.0 && motion.speed < 0.0 && self.ground.attraction.is_none();
        if drops { self.left(&Motion { duration: 0.0, ..*motion }, before) } else { before }
    }

    /// Line load at the end of a motion of the spring at `x`, if nothing lets it go; zero before its touch.
    fn continued_load(&self, x: f64, motion: &Motion) -> f64 {
        let Some(strip) = self.strips.iter().find(|strip| x <= strip.outer) else { return 0.0 };
        let c = self.ground.profile.reduced(x);
        let seen = Motion { start: motion.start - c, ..*motion };
        match strip.past.spring(&self.ground, c) {
            Spring::Free(free) if self.ground.spectrum.touch(&free, &seen).is_none() => 0.0,
            _ => self.load_at_end(strip, x, motion),
        }
    }

    /// The radius still pressed at the end of a motion outwards that `reached` so far.
    fn left(&self, motion: &Motion, reached: f64) -> f64 {
        let mut outer = reached;
        for strip in self.strips.iter().rev().filter(|strip| strip.inner < reached) {
            let load = |x: f64| self.load_at_end(strip, x, motion);
            outer = outer.min(strip.outer);
            if load(outer) >= 0.0 {
                return outer;
            }
            if load(strip.inner) > 0.0 {
                return root::brent(load, strip.inner, outer).unwrap_or(outer);
            }
        }
        0.0
    }

    /// Line load at the end of the motion of the spring at `x`, if it is not let go.
    fn load_at_end(&self, strip: &Strip, x: f64, motion: &Motion) -> f64 {
        let (spectrum, c) = (&self.ground.spectrum, self.ground.profile.reduced(x));
        let seen = Motion { start: motion.start - c, ..*motion };
        match strip.past.spring(&self.ground, c) {
            Spring::Pressed(s) => spectrum.load_after((seen.start, &s), seen.speed, seen.duration),
            Spring::Free(mut free) => {
                let touch = spectrum.touch(&free, &seen).unwrap_or_else(|| spectrum.narrowest(&free, &seen));
                spectrum.recover(&mut free, touch);
                let mut s = vec![0.0; spectrum.terms().len()];
                spectrum.loads_of_free(&free, &mut s);
                spectrum.load_after((seen.depth(touch), &s), seen.speed, seen.duration - touch)
            }
        }
    }

    /// Adds a strip for the springs touched for the first time.
    fn reach_out(&mut self, reached: f64, (motion, detail): (&Motion, Detail)) {
        let inner = self.strips.last().map_or(0.0, |strip| strip.outer);
        if reached > inner {
            let past = Past::new(&self.ground.spectrum, None, *motion, true);
            let mut strip = Strip::new((inner, reached), past);
            self.work += settled(&self.ground, &mut strip, detail);
            self.strips.push(strip);
        }
    }

    /// Cuts the strip that holds `x` in two.
    fn cut(&mut self, x: f64) {
        let Some(k) = self.strips.iter().position(|strip| strip.inner < x && x < strip.outer) else { return };
        let outer = Strip::new((x, self.strips[k].outer), self.strips[k].past.clone());
        let inner = Strip::new((self.strips[k].inner, x), outer.past.clone());
        self.strips[k] = inner;
        self.strips.insert(k + 1, outer);
    }

    /// Takes a strip, all of one kind, through the motion.
    fn step(&mut self, k: usize, (before, reached, left): (f64, f64, f64), (motion, detail): (&Motion, Detail)) {
        let (ground, strip) = (&self.ground, &mut self.strips[k]);
        let middle = 0.5 * (strip.inner + strip.outer);
        let (was, is, met) = (middle < before, middle < left, middle < reached);
        if was == is && (was || !met) {
            strip.fill(ground, detail);
            self.work += strip.pass(&ground.spectrum, motion);
            return;
        }
        let past = Past::new(&ground.spectrum, Some(Arc::new(strip.past.clone())), *motion, is);
        *strip = Strip::new((strip.inner, strip.outer), past);
    }

    /// Work against E∞ and η of the springs pressed throughout a motion, up to the radius `a`.
    fn steady_work(&self, motion: &Motion, a: f64) -> f64 {
        let spectrum = &self.ground.spectrum;
        let mean = Motion { start: motion.depth(0.5 * motion.duration), ..*motion };
        let steady = self.displaced(mean.start, a) * spectrum.equilibrium();
        motion.speed * motion.duration * (steady + 2.0 * a * spectrum.viscosity() * motion.speed)
    }

    /// 2 ∫₀^a (d − g) dx [m²].
    fn displaced(&self, d: f64, a: f64) -> f64 {
        let profile = &self.ground.profile;
        if a > 0.0 { 2.0 * (profile.load_integral(a) + a * (d - profile.reduced(a))) } else { 0.0 }
    }

    /// Normal force [N].
    #[must_use]
    pub fn force(&self) -> f64 {
        let (spectrum, a) = (&self.ground.spectrum, self.radius());
        let elements: f64 = self.strips[..self.pressed].iter().map(Strip::load).sum();
        let dashpot = 2.0 * a * spectrum.viscosity() * self.speed;
        spectrum.equilibrium() * self.displaced(self.depth, a) + elements + dashpot
    }

    /// Relative error of the force, estimated: [`force_error`](Self::force_error) over the force.
    #[must_use]
    pub fn error_estimate(&self) -> f64 {
        if self.pressed > 0 { self.force_error() / self.force().abs() } else { 0.0 }
    }

    /// Error of the force [N], estimated: every sum against one made anew with panels of half the
    /// width, and the rounding of as many operations as made it.
    #[must_use]
    pub fn force_error(&self) -> f64 {
        let held = &self.strips[..self.pressed];
        let off: f64 = held.iter().map(|strip| (strip.checked_load(&self.ground) - strip.load()).abs()).sum();
        let elements: f64 = held.iter().map(|strip| strip.load().abs()).sum();
        let steady = self.ground.spectrum.equilibrium() * self.displaced(self.depth, self.radius());
        off + 512.0 * f64::EPSILON * (steady.abs() + elements)
    }

    /// Contact radius [m].
    #[must_use]
    pub fn radius(&self) -> f64 {
        self.pressed.checked_sub(1).map_or(0.0, |last| self.strips[last].outer)
    }

    /// Indentation [m].
    #[must_use]
    pub fn indentation(&self) -> f64 {
        self.depth
    }

    /// Time [s].
    #[must_use]
    pub fn time(&self) -> f64 {
        self.time
    }

    /// Stiffness 2E(0)a [N/m] against a sudden step of the depth.
    #[must_use]
    pub fn stiffness(&self) -> f64 {
        2.0 * self.ground.spectrum.instantaneous() * self.radius()
    }

    /// Work done so far, energy in the springs, and their difference, the heat [J].
    #[must_use]
    pub fn ledger(&self) -> Ledger {
        let (spectrum, profile, a) = (&self.ground.spectrum, &self.ground.profile, self.radius());
        let elements: f64 = self.strips.iter().map(|strip| strip.stored(spectrum)).sum();
        let over = self.depth - if a > 0.0 { profile.reduced(a) } else { self.depth };
        let squares = if a > 0.0 { profile.energy_integral(a) } else { 0.0 };
        let squares = squares + over * (self.displaced(self.depth, a) - over * a);
        let stored = spectrum.equilibrium() * squares + elements;
        Ledger { work: self.work, stored, dissipated: self.work - stored }
    }

    /// Line load q(x) [N/m] at the distance `x` from the axis.
    #[must_use]
    pub fn line_load(&self, x: f64) -> f64 {
        let strip = self.strips[..self.pressed].iter().find(|strip| x <= strip.outer);
        strip.map_or(0.0, |strip| strip.line_load(&self.ground, x, (self.depth, self.speed)))
    }

    /// The springs' material.
    #[must_use]
    pub fn spectrum(&self) -> Arc<Spectrum> {
        self.ground.spectrum.clone()
    }

    /// The shape of the indenter.
    #[must_use]
    pub fn profile(&self) -> Arc<dyn Profile> {
        self.ground.profile.clone()
    }

    /// What holds the edge, if anything.
    #[must_use]
    pub fn attraction(&self) -> Option<&Attraction> {
        self.ground.attraction.as_ref()
    }

    /// Number of strips.
    #[must_use]
    pub fn strips(&self) -> usize {
        self.strips.len()
    }

    /// The spring at the distance `x` from the axis.
    #[must_use]
    pub fn spring(&self, x: f64) -> Spring {
        let strip = self.strips.iter().find(|strip| x <= strip.outer);
        let untouched = || Spring::untouched(&self.ground.spectrum);
        strip.map_or_else(untouched, |strip| strip.past.spring(&self.ground, self.ground.profile.reduced(x)))
    }

    /// Bytes of state.
    #[must_use]
    pub fn bytes(&self) -> usize {
        let numbers = 12 + 3 * self.ground.spectrum.terms().len() + self.ground.spectrum.modes().len();
        size_of::<f64>() * numbers * self.strips.len()
    }
}

/// Makes the sums of a strip just touched or let go; its work [J] where energies are followed.
fn settled(ground: &Ground, strip: &mut Strip, detail: Detail) -> f64 {
    if detail == Detail::Energy {
        return strip.settle(ground);
    }
    strip.fill(ground, detail);
    0.0
}

#[cfg(test)]
mod tests {
    use super::super::laws::{Recipe, TRIANGLES, history, recipe, unit_ball};
    use super::super::{layout::Layout, lazy::Lazy};
    use super::*;
    use crate::input::quantity::{Length, Positive};
    use crate::material::Relaxation;
    use crate::shape::{Cone, FlatPunch};
    use proptest::prelude::*;
    use std::f64::consts::PI;

    fn bed(spectrum: Arc<Spectrum>) -> Memory {
        Memory::new(spectrum, Arc::new(unit_ball()))
    }

    fn solid(equilibrium: f64, terms: &[(f64, f64)]) -> Arc<Spectrum> {
        Arc::new(Spectrum::new(&Relaxation { equilibrium, terms: terms.to_vec(), viscosity: 0.0 }))
    }

    /// Bound: seven digits given.
    #[test]
    fn triangles_to_all_digits() {
        for triangle in TRIANGLES {
            let mut bed = bed(triangle.spectrum());
            bed.advance(0.01, 1.0).unwrap();
            for &(t, force) in triangle.forces {
                let seen = bed.after(-0.01, t - 1.0).unwrap().force();
                assert!((seen / force - 1.0).abs() < 5e-7, "{t}: {seen:e} {force:e}");
            }
            assert!(bed.after(-0.01, triangle.parting - 1.0 - 1e-5).unwrap().radius() > 0.0);
            assert!(bed.after(-0.01, triangle.parting - 1.0 + 1e-5).unwrap().radius() <= 0.0);
        }
    }

    /// Two terms, with the touch time t₁ of the spring that is just let go; bound: the digits given.
    #[test]
    fn two_terms_to_all_digits() {
        let mut bed = bed(solid(1.0, &[(3.0, 0.3), (2.0, 5.0)]));
        assert!((bed.after(0.01, 0.5).unwrap().force() - 0.002_171_497_338).abs() < 1e-12);
        bed.advance(0.01, 1.0).unwrap();
        assert!((bed.force() - 0.005_262_688_380).abs() < 1e-12);
        for (t, force, touched) in [(1.2, 0.002_530_129_213, 0.735_572_69), (1.4, 0.000_916_887_196, 0.406_330_48)] {
            let seen = bed.after(-0.01, t - 1.0).unwrap();
            assert!((seen.force() - force).abs() < 1e-12, "{:e}", seen.force());
            assert!((seen.radius().powi(2) / 0.01 - touched).abs() < 1e-8, "{}", seen.radius());
        }
    }

    /// A cone is known in closed form: F = (4/(πt))[½E∞d² + Σ Eᵢv²τᵢ²(y − 1 + e^(−y))], y = T/τᵢ.
    ///
    /// Terms from 1e-15 to 1e15 s at once, twice the same and one equal to the ramp; bound: rounding.
    #[test]
    fn cone_over_thirty_decades() {
        let terms: Vec<(f64, f64)> =
            (-15..=15).flat_map(|k| [(1.0 + 0.1 * f64::from(k * k), 10f64.powi(k)); 2]).collect();
        let spectrum = Arc::new(Spectrum::new(&Relaxation { equilibrium: 0.5, terms, viscosity: 0.0 }));
        for k in -12..=9 {
            let (time, speed) = (10f64.powi(k), 10f64.powi(-k));
            let cone = Cone { slope: Positive::new(1.0).unwrap() };
            let mut bed = Memory::new(spectrum.clone(), Arc::new(cone));
            bed.advance(speed, time).unwrap();
            let part = |term: &super::super::Element| {
                let y = time / term.time;
                // y − 1 + e^(−y), by its series where the difference would lose digits.
                let series = || (2..24).rev().fold(0.0, |sum, k| 1.0 - y / f64::from(k + 1) * sum) * 0.5 * y * y;
                let lag = if y < 1.0 { series() } else { y + (-y).exp_m1() };
                term.modulus * (speed * term.time).powi(2) * lag
            };
            let exact = 4.0 / PI * (0.25 + spectrum.terms().iter().map(part).sum::<f64>());
            let error = (bed.force() / exact - 1.0).abs();
            assert!(error < 1e-12, "{k}: {error:e}");
            assert!(error <= bed.error_estimate(), "{k}: {error:e} {:e}", bed.error_estimate());
        }
    }

    /// Up and down, without springs met again: two motions or five hundred, to rounding.
    #[test]
    fn two_motions_or_five_hundred() {
        let spectrum = solid(1.0, &[(3.0, 0.3), (2.0, 5.0), (40.0, 1e-6)]);
        let (mut once, mut often) = (bed(spectrum.clone()), bed(spectrum));
        once.advance(0.01, 1.0).unwrap();
        once.advance(-0.01, 0.4).unwrap();
        for speed in [0.01, -0.01] {
            let (count, duration) = if speed > 0.0 { (400, 1.0) } else { (100, 0.4) };
            (0..count).for_each(|_| often.advance(speed, duration / f64::from(count)).unwrap());
        }
        assert!((once.force() / often.force() - 1.0).abs() < 1e-12, "{:e} {:e}", once.force(), often.force());
        assert!((once.ledger().work / often.ledger().work - 1.0).abs() < 1e-10);
    }

    /// p(r) = (2/πR) ∫ E(t−s) d√(a²(s)−r²) while the contact grows; bound: the quadrature here.
    #[test]
    fn pressure_while_growing() {
        let spectrum = solid(1.0, &[(3.0, 0.3), (2.0, 5.0)]);
        let mut bed = bed(spectrum.clone());
        bed.advance(0.01, 1.0).unwrap();
        for r in [0.0, 0.02, 0.07, 0.099] {
            let first = r * r / 0.01;
            let at = |sigma: f64| spectrum.relaxation(1.0 - first - sigma * sigma);
            let exact = 2.0 / PI * 0.1 * crate::numerics::quadrature::panel(at, 0.0, (1.0 - first).sqrt());
            assert!((bed.pressure(r) / exact - 1.0).abs() < 1e-9, "{r}: {:e} {exact:e}", bed.pressure(r));
        }
    }

    /// Slow against the relaxation, JKR of E∞: pull-off under displacement control at −(5/6)πwR,
    /// d = −1.608772. Bound: one part in 10⁴ of the relaxation left at that speed, of which the force
    /// near its vertical tangent shows the root.
    #[test]
    fn slow_retraction_is_jkr() {
        let spectrum = solid(1.0, &[(5.0, 1.0), (0.5, 30.0)]);
        let mut bed = bed(spectrum.clone()).with(Attraction::relaxed(1.0, &spectrum));
        bed.advance(5e-6, 1e6).unwrap();
        bed.advance(0.0, 1e6).unwrap();
        let time = bed.parting(-1e-7, 1e8).unwrap().unwrap();
        let last = bed.after(-1e-7, time * (1.0 - 1e-12)).unwrap();
        assert!((last.force() / (-5.0 / 6.0 * PI) - 1.0).abs() < 1e-3, "{}", last.force());
        assert!((last.indentation() + 1.608_772).abs() < 1e-4, "{}", last.indentation());
        assert!(bed.after(-1e-7, time * (1.0 + 1e-9)).unwrap().radius() <= 0.0);
    }

    /// Elastic: pull-off of a ball and of a flat punch, F = −√(8πE*wb³), to rounding.
    #[test]
    fn elastic_pull_off() {
        let elastic = solid(1.0, &[]);
        let mut ball = bed(elastic.clone()).with(Attraction::instantaneous(1.0, &elastic));
        ball.advance(5.0, 1.0).unwrap();
        let time = ball.parting(-1.0, 10.0).unwrap().unwrap();
        assert!((5.0 - time + 1.608_772_047_833_27).abs() < 1e-13, "{}", 5.0 - time);
        let punch = Arc::new(FlatPunch { radius: Length::new(0.5).unwrap() });
        let mut punch = Memory::new(elastic.clone(), punch).with(Attraction::relaxed(1.0, &elastic));
        punch.advance(1.0, 1.0).unwrap();
        let time = punch.parting(-1.0, 10.0).unwrap().unwrap();
        let last = punch.after(-1.0, time * (1.0 - 1e-14)).unwrap();
        assert!((last.force() + PI.sqrt()).abs() < 1e-11, "{}", last.force());
    }

    /// The faster the edge, the stronger: three speeds with the law of Gent & Schultz.
    #[test]
    fn pull_off_grows_with_the_speed() {
        let spectrum = solid(1.0, &[(2.0, 1.0)]);
        let law = Attraction::with_rate(1.0, &spectrum, (1e-3, 0.5));
        let least = |speed: f64| {
            let mut bed = bed(spectrum.clone()).with(law);
            bed.advance(2e-3, 1e3).unwrap();
            bed.advance(0.0, 1e3).unwrap();
            let time = bed.parting(-speed, 8.0 / speed).unwrap().unwrap();
            let at = |k: i32| bed.force_after(-speed, time * f64::from(k) / 40.0).unwrap().0;
            (1..=40).map(at).fold(0.0, f64::min)
        };
        let forces = [1e-5, 1e-4, 1e-3].map(least);
        assert!(
            forces[0] < -5.0 / 6.0 * PI && forces[1] < 1.05 * forces[0] && forces[2] < 1.05 * forces[1],
            "{forces:?}"
        );
    }

    /// Without attraction the edge lets go at q = 0: an attraction of no work is none.
    #[test]
    fn no_work_is_no_attraction() {
        let spectrum = solid(1.0, &[(3.0, 0.3), (2.0, 5.0)]);
        let mut plain = bed(spectrum.clone());
        let mut held = bed(spectrum.clone()).with(Attraction::relaxed(0.0, &spectrum));
        for (speed, duration) in [(0.01, 1.0), (-0.01, 0.3), (0.0, 0.2), (-0.01, 0.3)] {
            plain.advance(speed, duration).unwrap();
            held.advance(speed, duration).unwrap();
            assert!((plain.force() / held.force() - 1.0).abs() < 1e-4, "{:e} {:e}", plain.force(), held.force());
        }
    }

    /// The continuous bed against 500 springs up to the radius 1.
    ///
    /// A spring nearer to the axis is pressed whenever one further out is, so it has given way more:
    /// −dq/dg grows outwards, at most to E(0), and q(x) is concave up to the edge. The midpoint rule is
    /// off by −∫ K dq′ with 0 ≤ K ≤ Δx²/8 (Peano), and q′ falls to −E(0)g′(a) at most before it jumps to
    /// zero: 2·Δx²/8·E(0)·2a for both halves, 3/8 Δx² of the force of E(0) at a = 1. (−1/4 to 1/8
    /// holds for a parabola with one edge; a slow motion before a fast one bends q within one cell.)
    /// The work is off by the integral of that over the way gone.
    fn limit_of_many_springs(recipe: &Recipe, history: &[Motion]) -> Result<(), TestCaseError> {
        let spectrum = Arc::new(Spectrum::new(&recipe.relaxation()));
        let glassy = 4.0 / 3.0 * spectrum.instantaneous();
        let bound = 0.375 / 250_000.0 * glassy;
        let mut lazy = Lazy::new(spectrum.clone(), Layout::uniform(&unit_ball(), 1.0, 500));
        let mut bed = bed(spectrum);
        let (mut heat, mut way) = (0.0, 0.0);
        for motion in history {
            lazy.advance(motion.speed, motion.duration);
            bed.advance(motion.speed, motion.duration).unwrap();
            way += (motion.speed * motion.duration).abs();
            prop_assert!((lazy.force() - bed.force()).abs() < bound, "{:e} {:e}", lazy.force(), bed.force());
            let (a, b) = (lazy.ledger(), bed.ledger());
            prop_assert!(b.dissipated >= heat - 1e-11 * glassy, "{heat:e} {b:?}");
            heat = b.dissipated;
            prop_assert!((a.work - b.work).abs() <= bound * way, "{a:?} {b:?}");
            prop_assert!((a.stored - b.stored).abs() < 1.0 / 250_000.0 * glassy, "{a:?} {b:?}");
        }
        Ok(())
    }

    /// Every motion at once or in pieces, springs let go and met again included.
    ///
    /// Bound: 1e-9 of the greatest force (the panels of strips with more than one contact), 1e-11 of the
    /// force of the instantaneous modulus, of whose depths a force may be a small difference, and the
    /// dashpot's 2η|v| √δ: each piece rounds the depth anew, and where the bodies just touch a depth
    /// of δ opens a contact of the radius √δ.
    fn steps_do_not_matter(recipe: &Recipe, history: &[Motion], pieces: u32) -> Result<(), TestCaseError> {
        let spectrum = Arc::new(Spectrum::new(&recipe.relaxation()));
        let (glassy, viscosity) = (4.0 / 3.0 * spectrum.instantaneous(), spectrum.viscosity());
        let (mut once, mut often) = (bed(spectrum.clone()), bed(spectrum));
        let (mut greatest, mut rounding) = (0f64, 0.0);
        for motion in history {
            once.advance(motion.speed, motion.duration).unwrap();
            for _ in 0..pieces {
                often.advance(motion.speed, motion.duration / f64::from(pieces)).unwrap();
                rounding += f64::EPSILON * motion.start.abs().max(motion.end().abs());
            }
            greatest = greatest.max(once.force());
            let bound = 1e-9 * greatest + 1e-11 * glassy + 2.0 * viscosity * motion.speed.abs() * rounding.sqrt();
            prop_assert!((once.force() - often.force()).abs() <= bound, "{:e} {:e}", once.force(), often.force());
        }
        Ok(())
    }

    #[test]
    fn a_dashpot_that_just_touches() {
        let recipe = Recipe { equilibrium: None, terms: vec![(0, 0)], viscosity: Some(0) };
        let away = Motion { start: 0.0, speed: -0.01, duration: 1.0 };
        let back = Motion { start: -0.01, speed: 0.01, duration: 1.0 };
        steps_do_not_matter(&recipe, &[away, back], 3).unwrap();
    }

    /// Exact force 1.237 375 363 128 97 (quadrature to 30 digits); 500 springs are off by −0.25002 Δx².
    #[test]
    fn a_slow_motion_before_a_fast_one() {
        let recipe = Recipe { equilibrium: None, terms: vec![(0, -7)], viscosity: None };
        let (slow, fast) = (10f64.powf(1.4), 10f64.powf(-2.1));
        let history = [
            Motion { start: 0.0, speed: 0.12 / slow, duration: slow },
            Motion { start: 0.12, speed: 0.87 / fast, duration: fast },
        ];
        limit_of_many_springs(&recipe, &history).unwrap();
        let mut bed = bed(Arc::new(Spectrum::new(&recipe.relaxation())));
        history.iter().for_each(|motion| bed.advance(motion.speed, motion.duration).unwrap());
        assert!((bed.force() / 1.237_375_363_128_97 - 1.0).abs() < 1e-13, "{:e}", bed.force());
    }

    proptest! {
        #![proptest_config(crate::laws::cases(48))]

        /// See [`limit_of_many_springs`].
        #[test]
        fn is_the_limit_of_many_springs(recipe in recipe(5), history in history(6)) {
            limit_of_many_springs(&Recipe { viscosity: None, ..recipe }, &history)?;
        }

        /// 2π ∫ p r dr = F, whatever the history; bound: the quadrature over r here.
        #[test]
        fn pressure_adds_up_to_the_force(recipe in recipe(3), history in history(4)) {
            let recipe = Recipe { viscosity: None, ..recipe };
            let mut bed = bed(Arc::new(Spectrum::new(&recipe.relaxation())));
            let glassy = 4.0 / 3.0 * bed.ground.spectrum.instantaneous();
            for motion in history {
                bed.advance(motion.speed, motion.duration).unwrap();
            }
            let held = &bed.strips[..bed.pressed];
            let mut ends: Vec<f64> = held.iter().flat_map(|strip| strip.panel_ends(&bed.ground)).collect();
            ends.dedup();
            let panel = |pair: &[f64]| {
                let ring = |r: f64, _: f64| 2.0 * PI * (pair[0] + r) * bed.pressure(pair[0] + r);
                crate::numerics::quadrature::panel_with_root_ends(ring, pair[1] - pair[0])
            };
            let sum: f64 = ends.windows(2).map(panel).sum();
            prop_assert!((sum - bed.force()).abs() < 1e-7 * glassy, "{sum:e} {:e}", bed.force());
        }

        /// While the contact grows the force lies between those of E∞ and E(0) and is linear in E(t).
        #[test]
        fn bounds_and_superposition(one in recipe(4), other in recipe(4), steps in prop::collection::vec((0i32..20, -40i32..40), 1..5)) {
            let (one, other) = (one.relaxation(), other.relaxation());
            let terms = one.terms.iter().chain(&other.terms).copied().collect();
            let equilibrium = one.equilibrium + other.equilibrium;
            let both = Relaxation { equilibrium, terms, viscosity: 0.0 };
            let of = |relaxation: &Relaxation| {
                let relaxation = Relaxation { viscosity: 0.0, ..relaxation.clone() };
                let mut bed = bed(Arc::new(Spectrum::new(&relaxation)));
                for (rise, k) in &steps {
                    let duration = 10f64.powf(0.1 * f64::from(*k));
                    bed.advance(0.01 * f64::from(*rise) / duration, duration).unwrap();
                }
                (bed.force(), bed.indentation())
            };
            let (force, depth) = of(&both);
            let elastic = |modulus: f64| 4.0 / 3.0 * modulus * depth.powf(1.5);
            let instantaneous = Spectrum::new(&both).instantaneous();
            prop_assert!(force >= elastic(equilibrium) * (1.0 - 1e-12) && force <= elastic(instantaneous) * (1.0 + 1e-12));
            let sum = of(&one).0 + of(&other).0;
            prop_assert!((force - sum).abs() <= 1e-11 * force, "{force:e} {sum:e}");
            prop_assert!(force >= of(&one).0 * (1.0 - 1e-12), "a greater modulus, a greater force");
        }

        /// See [`steps_do_not_matter`].
        #[test]
        fn answer_does_not_depend_on_the_steps(recipe in recipe(4), history in history(5), pieces in 2u32..6) {
            steps_do_not_matter(&recipe, &history, pieces)?;
        }
    }
}
