//! The continuous bed: no springs to count, no error of discretization.
//!
//! At any time the contact is a disc 0 ≤ x < a and the state of a spring depends on the height
//! c = g(x) of the indenter above it only. A motion falls into phases in which the edge stands
//! still, moves one way or jumps; the springs it passes join or leave at instants of their own, all others move
//! alike. The bed falls into panels in which the springs are smooth; the force is
//! F = 2E∞ ∫₀^a (d − g) dx + Σ ∫ 2 sᵢ dx, the second part made with the panel and evolved like a spring from then on.

use super::Spectrum;
use super::attraction::Attraction;
use super::front::{EdgePhase, Front, SightedSpring, Way, instants};
use super::ledger::Ledger;
use super::panel::{Grain, Lived, Panel, panels};
use super::spring::{Motion, Piece, Spring};
use crate::contact::error::BedError;
use crate::contact::model::Straight;
use crate::shape::{Profile, Rim};
use std::sync::Arc;

/// Bed without discretization in space or time.
#[derive(Debug, Clone)]
pub struct Memory {
    spectrum: Arc<Spectrum>,
    profile: Arc<dyn Profile>,
    attraction: Option<Attraction>,
    panels: Vec<Panel>,
    /// Number of panels held; they come first.
    held: usize,
    depth: f64,
    speed: f64,
    time: f64,
    work: f64,
    /// Whether work is counted: a look needs none.
    counts: bool,
}

impl Memory {
    /// A bed never touched, the indenter just above it.
    #[must_use]
    pub fn new(spectrum: Arc<Spectrum>, profile: Arc<dyn Profile>) -> Self {
        let panels = Vec::new();
        Self {
            spectrum,
            profile,
            attraction: None,
            panels,
            held: 0,
            depth: 0.0,
            speed: 0.0,
            time: 0.0,
            work: 0.0,
            counts: true,
        }
    }

    /// The bed with an attraction that holds the edge; to be given before the first touch.
    #[must_use]
    pub fn with(mut self, attraction: Attraction) -> Self {
        self.attraction = Some(attraction);
        self
    }

    /// When in a motion the bodies part [s] by the attraction giving way; `None` if they do not.
    ///
    /// # Errors
    /// As [`advance`](Self::advance).
    pub fn parting(&self, speed: f64, duration: f64) -> Result<Option<f64>, BedError> {
        if self.attraction.is_none() {
            return Ok(None);
        }
        let mut bed = self.clone();
        let mut walk = Walk::new(Motion { start: self.depth, speed, duration });
        while walk.rest.duration > 0.0 {
            let joined = bed.held > 0;
            bed.phase(&mut walk)?;
            if joined && bed.held == 0 {
                return Ok(Some(duration - walk.rest.duration));
            }
        }
        Ok(None)
    }

    /// Moves at constant `speed` [m/s] for `duration` [s].
    ///
    /// # Errors
    /// The contact would outgrow the profile.
    pub fn advance(&mut self, speed: f64, duration: f64) -> Result<(), BedError> {
        let motion = Motion { start: self.depth, speed, duration };
        let mut walk = Walk::new(motion);
        while walk.rest.duration > 0.0 {
            self.phase(&mut walk)?;
        }
        (self.depth, self.speed, self.time) = (motion.end(), speed, self.time + duration);
        Ok(())
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
        let attraction = self.attraction;
        let reached = self.panels.last().map_or(0.0, |panel| panel.outer);
        let height = if reached > 0.0 { self.profile.reduced(reached) } else { 0.0 };
        let away = self.depth - 4.0 * (self.depth.abs() + height);
        self.attraction = attraction.map(Attraction::without_work);
        // Upwards no profile ends.
        let _ = self.reach(away, self.spectrum.instant());
        self.attraction = attraction;
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

    /// The force [N] and contact radius [m] after a motion, this bed left as it is.
    ///
    /// # Errors
    /// As [`advance`](Self::advance).
    pub fn force_after(&self, speed: f64, duration: f64) -> Result<(f64, f64), BedError> {
        let mut bed = Self { counts: false, ..self.clone() };
        bed.advance(speed, duration)?;
        Ok((bed.force(), bed.radius()))
    }

    /// The first phase of what is left of a motion.
    fn phase(&mut self, walk: &mut Walk) -> Result<(), BedError> {
        let motion = walk.rest;
        let step = if walk.stalls < MOST_STALLS {
            self.next(&motion, walk.least)?
        } else {
            walk.stalls -= 1;
            PhaseStep { duration: walk.least.min(motion.duration), change: None }
        };
        if step.change.is_none() {
            walk.least *= 4.0;
        } else if step.duration > PROGRESS * walk.whole {
            (walk.least, walk.stalls) = (walk.shortest, 0);
        } else {
            walk.stalls += 1;
        }
        self.take(&motion.lasting(step.duration), step.change);
        self.depth = motion.depth(step.duration);
        walk.rest = motion.after(step.duration);
        Ok(())
    }

    /// What happens first in a motion.
    fn next(&self, motion: &Motion, least: f64) -> Result<PhaseStep, BedError> {
        let see = |way: Way, x: f64| self.seen(way, x);
        let borders: Vec<f64> = self.panels.iter().map(|panel| panel.outer).collect();
        let front = self.front(motion, least, &borders, &see);
        let (phase, way) = front.phase();
        let (duration, change) = match phase {
            EdgePhase::Still(duration) => (duration, None),
            EdgePhase::Moves { to, duration } => {
                let to = if front.is_spent(way, duration) { 0.0 } else { to };
                if way == Way::Closing && to >= front.limit && matches!(self.profile.rim(), Rim::End(_)) {
                    return Err(BedError::BeyondProfile { indentation: motion.depth(duration) });
                }
                (duration, Some(self.change(way, to, &motion.lasting(duration), &|x| front.instant(way, x, duration))))
            }
            EdgePhase::Creeps(path) => {
                let &(to, duration) = path.last().unwrap_or(&(front.edge, 0.0));
                (duration, Some(self.change(way, to, &motion.lasting(duration), &|x| instant_of(&path, x))))
            }
            EdgePhase::Jumps(to) => (0.0, Some(self.change(way, to, &motion.lasting(0.0), &|_| 0.0))),
        };
        Ok(PhaseStep { duration, change })
    }

    fn front<'b>(
        &'b self,
        motion: &Motion,
        least: f64,
        borders: &'b [f64],
        see: &'b dyn Fn(Way, f64) -> SightedSpring,
    ) -> Front<'b> {
        Front {
            spectrum: &self.spectrum,
            attraction: self.attraction.as_ref(),
            profile: self.profile.as_ref(),
            see,
            edge: self.radius(),
            limit: match self.profile.rim() {
                Rim::None => f64::MAX,
                Rim::Wall(end) | Rim::End(end) => end,
            },
            borders,
            scale: self.profile.scale(),
            feature: self.profile.feature().unwrap_or(f64::INFINITY),
            motion: *motion,
            least: least.min(motion.duration),
            instants: instants(&self.spectrum, motion.duration),
        }
    }

    /// The springs between the edge and the radius `to` at the end of a motion in which they join or leave, each at
    /// its `instant`.
    fn change(&self, way: Way, to: f64, motion: &Motion, instant: &dyn Fn(f64) -> f64) -> Change {
        let edge = self.radius();
        let (inner, outer) = (edge.min(to), edge.max(to));
        let own = self.panels.iter().map(|panel| panel.outer).chain(self.profile.breaks(outer));
        let mut borders: Vec<f64> = own.filter(|&x| inner < x && x < outer).chain([inner, outer]).collect();
        borders.sort_by(f64::total_cmp);
        borders.dedup();
        let lived = |x: f64| self.lived(way, x, motion, instant(x));
        let lengths = motion.start.abs().max(motion.end().abs()) + self.profile.reduced(outer);
        let (scale, most) = match way {
            Way::Closing => (self.spectrum.equilibrium() * lengths, self.spectrum.instantaneous() * lengths),
            Way::Opening => (lengths, lengths),
        };
        let grain = Grain { scale, tolerance: self.tolerance(), floor: 2.0 * f64::EPSILON * most };
        let (panels, work) = panels(&self.spectrum, &borders, motion.speed, grain, &lived);
        Change { inner, outer, panels, work }
    }

    /// What the polynomials of the panels may miss: no more than the way of an edge that obeys a rate law.
    fn tolerance(&self) -> f64 {
        let followed = self.attraction.as_ref().filter(|attraction| attraction.has_rate());
        followed.map_or(SMOOTH, |attraction| SMOOTH.max(0.1 * attraction.accuracy()))
    }

    /// The spring at `x` after a motion in which it joins or leaves at the time `at`.
    fn lived(&self, way: Way, x: f64, motion: &Motion, at: f64) -> Lived {
        let (spectrum, height) = (&self.spectrum, self.profile.reduced(x));
        let seen = Motion { start: motion.start - height, ..*motion };
        let (u, rest) = (seen.depth(at), motion.duration - at);
        let mut impulse = 0.0;
        let mut pressed = |u: f64, s: &mut [f64], duration: f64| {
            impulse = spectrum.impulse(&Piece::Pressed { u, s, speed: seen.speed, duration });
            spectrum.press(s, seen.speed, duration);
        };
        let spring = match (way, self.spring_on(way, x)) {
            (Way::Closing, Spring::Free(mut free)) => {
                spectrum.recover(&mut free, at);
                let mut s = vec![0.0; spectrum.terms().len()];
                spectrum.loads_of_free(&free, &mut s);
                if let Some(attraction) = &self.attraction {
                    attraction.moved(spectrum, (spectrum.recovered(&free, 0.0), u), &mut s);
                }
                pressed(u, &mut s, rest);
                Spring::Pressed(s)
            }
            (Way::Opening, Spring::Pressed(mut s)) => {
                pressed(seen.start, &mut s, at);
                let mut free = match &self.attraction {
                    Some(attraction) => {
                        let load = spectrum.load(u, &s, seen.speed);
                        attraction.let_go(spectrum, u, load, &mut s)
                    }
                    None => spectrum.let_go(u, &s),
                };
                spectrum.recover(&mut free, rest);
                Spring::Free(free)
            }
            (_, spring) => spring,
        };
        Lived { spring, impulse }
    }

    /// A motion, with what happens to the springs at the edge.
    fn take(&mut self, motion: &Motion, change: Option<Change>) {
        let edge = self.radius();
        let change = change.unwrap_or(Change { inner: edge, outer: edge, panels: Vec::new(), work: 0.0 });
        self.work += change.work + self.steady_work(motion, change.inner);
        self.cut(change.inner);
        self.cut(change.outer);
        let first = self.panels.partition_point(|panel| panel.outer <= change.inner);
        let last = self.panels.partition_point(|panel| panel.inner < change.outer).max(first);
        for (k, panel) in self.panels.iter_mut().enumerate() {
            if k < first || k >= last {
                if self.counts {
                    self.work += panel.work(&self.spectrum, motion);
                }
                panel.pass(&self.spectrum, motion);
            }
        }
        let count = change.panels.len();
        self.panels.splice(first..last, change.panels);
        self.merge(first, first + count);
        self.held = self.panels.iter().take_while(|panel| panel.held).count();
    }

    /// Makes one panel of two where that loses nothing, at the borders from `first` to `last`.
    fn merge(&mut self, first: usize, last: usize) {
        for k in (first.max(1)..=last).rev() {
            let (Some(one), Some(two)) = (self.panels.get(k - 1), self.panels.get(k)) else { continue };
            if let Some(joined) = one.joined_with(two, &self.spectrum, self.tolerance()) {
                self.panels.splice(k - 1..=k, [joined]);
            }
        }
    }

    /// Cuts the panel that holds `x` in two.
    fn cut(&mut self, x: f64) {
        let Some(k) = self.panels.iter().position(|panel| panel.inner < x && x < panel.outer) else { return };
        let halves = self.panels[k].cut(&self.spectrum, x);
        self.panels.splice(k..=k, halves);
    }

    /// The panel at the distance `x` from the axis, at the edge the one whose springs may go `way`.
    fn panel(&self, way: Way, x: f64) -> Option<&Panel> {
        let k = self.panels.partition_point(|panel| panel.outer < x);
        self.panels.get(match way {
            Way::Opening => k.min(self.held.saturating_sub(1)),
            Way::Closing => k.max(self.held),
        })
    }

    fn spring_on(&self, way: Way, x: f64) -> Spring {
        self.panel(way, x).map_or_else(|| Spring::untouched(&self.spectrum), |panel| panel.spring(x))
    }

    fn seen(&self, way: Way, x: f64) -> SightedSpring {
        SightedSpring {
            spring: self.spring_on(way, x),
            height: self.profile.reduced(x),
            doubt: self.panel(way, x).map_or(0.0, Panel::doubt),
        }
    }

    /// Work against E∞ and η of the springs held throughout a motion, up to the radius `a`.
    fn steady_work(&self, motion: &Motion, a: f64) -> f64 {
        let spectrum = &self.spectrum;
        let mean = motion.depth(0.5 * motion.duration);
        let steady = self.displaced(mean, a) * spectrum.equilibrium();
        motion.speed * motion.duration * (steady + 2.0 * a * spectrum.viscosity() * motion.speed)
    }

    /// 2 ∫₀^a (d − g) dx [m²].
    fn displaced(&self, d: f64, a: f64) -> f64 {
        let profile = &self.profile;
        if a > 0.0 { 2.0 * (profile.load_integral(a) + a * (d - profile.reduced(a))) } else { 0.0 }
    }

    /// Normal force [N].
    #[must_use]
    pub fn force(&self) -> f64 {
        let (spectrum, a) = (&self.spectrum, self.radius());
        let elements: f64 = self.panels[..self.held].iter().map(Panel::load).sum();
        let dashpot = 2.0 * a * spectrum.viscosity() * self.speed;
        spectrum.equilibrium() * self.displaced(self.depth, a) + elements + dashpot
    }

    /// Relative error of the force, estimated: [`force_error`](Self::force_error) over the force.
    #[must_use]
    pub fn error_estimate(&self) -> f64 {
        if self.held > 0 { self.force_error() / self.force().abs() } else { 0.0 }
    }

    /// Error of the force [N], estimated: what the polynomials miss of the sums, and the rounding of as many
    /// operations as made them.
    #[must_use]
    pub fn force_error(&self) -> f64 {
        let held = &self.panels[..self.held];
        let missed: f64 = held.iter().map(Panel::missed).sum();
        let elements: f64 = held.iter().map(|panel| panel.load().abs()).sum();
        let steady = self.spectrum.equilibrium() * self.displaced(self.depth, self.radius());
        missed + 512.0 * f64::EPSILON * (steady.abs() + elements)
    }

    /// Contact radius [m].
    #[must_use]
    pub fn radius(&self) -> f64 {
        self.held.checked_sub(1).map_or(0.0, |last| self.panels[last].outer)
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
        2.0 * self.spectrum.instantaneous() * self.radius()
    }

    /// Work done so far, energy in the springs, and their difference, the heat [J].
    #[must_use]
    pub fn ledger(&self) -> Ledger {
        let (spectrum, profile, a) = (&self.spectrum, &self.profile, self.radius());
        let elements: f64 = self.panels.iter().map(|panel| panel.stored(spectrum)).sum();
        let over = self.depth - if a > 0.0 { profile.reduced(a) } else { self.depth };
        let squares = if a > 0.0 { profile.energy_integral(a) } else { 0.0 };
        let squares = squares + over * (self.displaced(self.depth, a) - over * a);
        let stored = spectrum.equilibrium() * squares + elements;
        Ledger { work: self.work, stored, dissipated: self.work - stored }
    }

    /// Energy −wA of the closed surfaces [J], A = πa².
    #[must_use]
    pub fn surface_energy(&self) -> f64 {
        let work = self.attraction.as_ref().map_or(0.0, Attraction::work);
        -work * self.profile.contact_area(self.radius())
    }

    /// The springs' material.
    #[must_use]
    pub fn spectrum(&self) -> Arc<Spectrum> {
        self.spectrum.clone()
    }

    /// The shape of the indenter.
    #[must_use]
    pub fn profile(&self) -> Arc<dyn Profile> {
        self.profile.clone()
    }

    /// What holds the edge, if anything.
    #[must_use]
    pub fn attraction(&self) -> Option<&Attraction> {
        self.attraction.as_ref()
    }

    /// Whether no spring has ever been touched.
    #[must_use]
    pub fn is_untouched(&self) -> bool {
        self.panels.is_empty()
    }

    /// The panels of springs held, and those of springs let go or never touched.
    pub(super) fn sides(&self) -> [&[Panel]; 2] {
        let (held, free) = self.panels.split_at(self.held);
        [held, free]
    }

    /// Speed of the last motion [m/s].
    pub(super) fn speed(&self) -> f64 {
        self.speed
    }

    /// Borders of the panels [m] from the axis outwards, those of springs held or of all ever touched.
    pub(super) fn ends(&self, held: bool) -> Vec<f64> {
        let panels = if held { &self.panels[..self.held] } else { &self.panels[..] };
        let start = panels.first().map(|panel| panel.inner);
        start.into_iter().chain(panels.iter().map(|panel| panel.outer)).collect()
    }

    /// Bytes of state.
    #[must_use]
    pub fn bytes(&self) -> usize {
        self.panels.iter().map(Panel::bytes).sum()
    }
}

/// What polynomials may miss of the springs where nothing else errs, relative to their loads.
const SMOOTH: f64 = 1e-14;

/// Part of a motion below which an edge that moves gets nowhere: then there may be rounding alone, and the longer it
/// stands still the sooner there is more.
const PROGRESS: f64 = 1e-4;

/// Phases that get nowhere before the edge stands still for a while.
const MOST_STALLS: u32 = 256;

/// What is left of a motion on the way through it.
struct Walk {
    rest: Motion,
    /// How long all of it lasts [s].
    whole: f64,
    /// Phases that got nowhere.
    stalls: u32,
    /// The shortest time the edge may stand still [s]: below it there is only rounding.
    shortest: f64,
    /// The same now: longer each time that nothing has happened.
    least: f64,
}

impl Walk {
    fn new(motion: Motion) -> Self {
        let shortest = 1e-15 * motion.duration;
        Self { rest: motion, whole: motion.duration, stalls: 0, shortest, least: shortest }
    }
}

/// What happens first in a motion.
struct PhaseStep {
    duration: f64,
    change: Option<Change>,
}

/// Springs between two radii [m] that join or leave, as they are afterwards, and the work [J] done on them meanwhile.
struct Change {
    inner: f64,
    outer: f64,
    panels: Vec<Panel>,
    work: f64,
}

/// When an edge that moves inwards along a path of radii and times is at the radius `x` [s].
fn instant_of(path: &[(f64, f64)], x: f64) -> f64 {
    let k = path.partition_point(|&(a, _)| a > x).clamp(1, path.len().max(2) - 1);
    let (Some(&(far, early)), Some(&(near, late))) = (path.get(k - 1), path.get(k)) else { return 0.0 };
    let part = if far > near { ((far - x) / (far - near)).clamp(0.0, 1.0) } else { 1.0 };
    early + part * (late - early)
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

    /// A Maxwell element of 1e-14 s drawn back: its load is below the rounding of the touch until that has relaxed.
    #[test]
    fn a_liquid_lets_go_at_once() {
        let recipe = Recipe { equilibrium: None, terms: vec![(0, -140)], viscosity: None };
        let mut bed = bed(Arc::new(Spectrum::new(&recipe.relaxation())));
        bed.advance(3.25, 0.08).unwrap();
        assert!(bed.radius() > 0.5);
        bed.advance(-0.013, 20.0).unwrap();
        assert!(bed.radius() <= 0.0 && bed.force() == 0.0, "{:e} {:e}", bed.radius(), bed.force());
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
            let glassy = 4.0 / 3.0 * bed.spectrum.instantaneous();
            for motion in history {
                bed.advance(motion.speed, motion.duration).unwrap();
            }
            let (ends, inside) = (bed.ends(true), bed.radius() * (1.0 - f64::EPSILON));
            let panel = |pair: &[f64]| {
                // Rounding must not put it on the edge, where the pressure of a liquid has no bound.
                let ring = |r: f64, _: f64| {
                    let r = (pair[0] + r).min(inside);
                    2.0 * PI * r * bed.pressure(r)
                };
                crate::numerics::quadrature::panel_with_root_ends(ring, pair[1] - pair[0])
            };
            let sum: f64 = ends.windows(2).map(panel).sum();
            prop_assert!((sum - bed.force()).abs() < 1e-7 * glassy, "{sum:e} {:e}", bed.force());
        }

        /// While the contact grows the force lies between those of E∞ and E(0) and is linear in E(t), but for the
        /// errors it states.
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
                (bed.force(), bed.indentation(), bed.force_error())
            };
            let (force, depth, error) = of(&both);
            let elastic = |modulus: f64| 4.0 / 3.0 * modulus * depth.powf(1.5);
            let instantaneous = Spectrum::new(&both).instantaneous();
            prop_assert!(force + error >= elastic(equilibrium) && force - error <= elastic(instantaneous));
            let (one, other) = (of(&one), of(&other));
            let errors = error + one.2 + other.2;
            let off = (force - one.0 - other.0).abs();
            prop_assert!(off <= errors, "{force:e} {one:?} {other:?}");
            prop_assert!(off <= 1e-11 * force + 1e-15 * elastic(instantaneous), "{force:e} {one:?} {other:?}");
            prop_assert!(force + errors >= one.0, "a greater modulus, a greater force");
        }

        /// See [`steps_do_not_matter`].
        #[test]
        fn answer_does_not_depend_on_the_steps(recipe in recipe(4), history in history(5), pieces in 2u32..6) {
            steps_do_not_matter(&recipe, &history, pieces)?;
        }
    }
}
