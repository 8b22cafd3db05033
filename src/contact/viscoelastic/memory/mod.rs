//! The continuous bed: no springs to count, no error of discretization.
//!
//! At any time the contact is a disc 0 ≤ x < a and the state of a spring depends on the height
//! c = g(x) of the indenter above it only. A motion falls into phases in which the edge stands
//! still, moves one way or jumps; the springs it passes join or leave at instants of their own, all others move
//! alike. The bed falls into panels in which the springs are smooth; the force is
//! F = 2E∞ ∫₀^a (d − g) dx + Σ ∫ 2 sᵢ dx, the second part made with the panel and evolved like a spring from then on.
//!
//! # Examples
//! ```
//! use springbed::contact::viscoelastic::{Spectrum, memory::Memory};
//! use springbed::input::quantity::Length;
//! use springbed::material::Relaxation;
//! use springbed::shape::Paraboloid;
//! use std::sync::Arc;
//!
//! // A Maxwell liquid that is drawn back as slowly as it was pressed parts before it is back at its first surface.
//! let ball = Arc::new(Paraboloid { radius: Length::new(1.0)? });
//! let liquid = Arc::new(Spectrum::new(&Relaxation { equilibrium: 0.0, terms: vec![(1.0, 1.0)], viscosity: 0.0 }));
//! let mut bed = Memory::new(liquid, ball);
//! bed.advance(0.01, 1.0)?;
//! let parted = bed.parting(-0.01, 1.0)?.ok_or("it parts")?;
//! assert!(0.0 < parted && parted < 1.0);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

#[cfg(test)]
mod look_tests;
mod phases;
#[cfg(test)]
mod tests;

use super::Spectrum;
use super::attraction::Attraction;
use super::front::{SightedSpring, Way};
use super::ledger::Ledger;
use super::panel::Panel;
use super::spring::{Motion, Spring};
use crate::contact::error::BedError;
use crate::contact::model::Straight;
use crate::shape::Profile;
use phases::Walk;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

/// Bed without discretization in space or time.
#[derive(Debug, Clone)]
pub struct Memory {
    spectrum: Arc<Spectrum>,
    profile: Arc<dyn Profile>,
    attraction: Option<Attraction>,
    panels: Vec<Panel>,
    /// Number of panels held; they come first.
    held: usize,
    /// Number of pasts that springs have had so far.
    pasts: u64,
    depth: f64,
    speed: f64,
    time: f64,
    work: f64,
    /// What a polynomial may miss of a corner between two panels that become one, relative to the loads.
    corner: f64,
    /// Whether work is counted: a look needs none.
    counts: bool,
    /// What a look knows that does not know all springs.
    sight: Option<Sight>,
}

/// What a look at the bed knows of its springs.
#[derive(Debug, Clone)]
struct Sight {
    /// Part of the radius beside the edge in which it knows those that have been let go.
    beside_edge: f64,
    /// Whether it has asked for another one.
    is_asked_too_much: Arc<AtomicBool>,
}

impl Sight {
    fn of(beside_edge: f64) -> Option<Self> {
        Some(Self { beside_edge, is_asked_too_much: Arc::default() })
    }
}

/// Panels on either side of the edge that looks at the bed know one by one: few are enough for most, and the next looks
/// know more.
const NEAREST: usize = 3;
const NEAR: usize = 24;
const WIDER: usize = 192;
/// Part of the radius beside the edge in which a look knows the springs that have been let go: where the edge only goes back
/// none is asked for but the next one.
const JUST_BESIDE: f64 = 1e-13;
const BESIDE_EDGE: f64 = 1e-3;
/// Part of the accuracy of pieces that corners between them may be.
const CORNER: f64 = 0.03;

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
            pasts: 0,
            depth: 0.0,
            speed: 0.0,
            time: 0.0,
            work: 0.0,
            corner: 0.0,
            counts: true,
            sight: None,
        }
    }

    /// The bed with an attraction that holds the edge; to be given before the first touch.
    #[must_use]
    pub fn with(mut self, attraction: Attraction) -> Self {
        self.attraction = Some(attraction);
        self
    }

    /// The bed led in straight pieces that meet what they follow to a relative error of `accuracy`: each leaves a corner in the
    /// springs that join or leave then, and those that are less than they are known are not kept.
    #[must_use]
    pub fn in_pieces(mut self, accuracy: f64) -> Self {
        self.corner = CORNER * accuracy;
        self
    }

    /// When in a motion the bodies part [s]: the attraction gives way, or the last spring leaves; `None` if they do not.
    ///
    /// # Errors
    /// As [`advance`](Self::advance).
    pub fn parting(&self, speed: f64, duration: f64) -> Result<Option<f64>, BedError> {
        let mut bed = self.clone();
        let mut walk = Walk::new(Motion { start: self.depth, speed, duration });
        while walk.rest.duration > 0.0 {
            let joined = bed.held > 0;
            bed.phase(&mut walk)?;
            if joined && bed.held == 0 {
                return Ok(Some(walk.ended.unwrap_or(duration - walk.rest.duration)));
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
        while walk.rest.duration > 0.0 && !self.fails() {
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
        let speed = (to - self.depth) / duration;
        self.advance(speed, duration)?;
        self.land(to, speed)
    }

    /// Moves along a straight piece, and lands on its end to the last bit.
    ///
    /// # Errors
    /// As [`advance`](Self::advance).
    pub fn follow_line(&mut self, line: &Straight) -> Result<(), BedError> {
        self.advance(line.speed, line.duration)?;
        self.land(line.to, line.speed)
    }

    /// At the depth `to` [m], reached at the speed `speed` [m/s]: bodies that it brings to where they just touch are drawn
    /// together there.
    fn land(&mut self, to: f64, speed: f64) -> Result<(), BedError> {
        self.depth = to;
        if speed > 0.0 && self.held == 0 && self.attraction.is_some() {
            self.phase(&mut Walk::new(Motion { start: to, speed: 0.0, duration: self.spectrum.instant() }))?;
        }
        Ok(())
    }

    /// Takes the indenter far away at once: in no time every element of a spring gives alike, whatever held it. The depth
    /// [m] at which an edge that opens by its own law lets go; `None` where that takes its time, or holds all the way.
    pub fn leave(&mut self) -> Option<f64> {
        let reached = self.panels.last().map_or(0.0, |panel| panel.outer);
        let height = self.profile.reduced(if reached > 0.0 { reached } else { self.profile.scale() });
        let far = 4.0 * (self.depth.abs() + height);
        let instant = self.spectrum.instant();
        let has_rate = self.attraction.as_ref().is_some_and(Attraction::has_rate);
        let follows = !has_rate && self.spectrum.viscosity() <= 0.0;
        // Upwards no profile ends.
        let parting = follows.then(|| self.parting(-far / instant, instant).ok().flatten()).flatten();
        let last = parting.map(|time| self.depth - far * (time / instant));
        self.let_go();
        self.depth -= far;
        last
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
        self.force_seen(&self.near(), speed, duration)
    }

    /// The same, with the bed [`near`](Self::near) the edge already at hand: what a look costs then does not grow with the
    /// panels behind, as long as it does not lead to them.
    ///
    /// # Errors
    /// As [`advance`](Self::advance).
    pub(super) fn force_seen(&self, near: &Self, speed: f64, duration: f64) -> Result<(f64, f64), BedError> {
        let whole = |sight: Option<Sight>| Self { counts: false, sight, ..self.clone() };
        let looks: [&dyn Fn() -> Self; 5] = [
            &|| near.outline(NEAREST, JUST_BESIDE),
            &|| near.outline(NEAR, BESIDE_EDGE),
            &|| self.outline(WIDER, BESIDE_EDGE),
            &|| whole(Sight::of(BESIDE_EDGE)),
            &|| whole(None),
        ];
        let mut seen = Ok((0.0, 0.0));
        for look in looks {
            let mut bed = look();
            let outcome = bed.advance(speed, duration);
            seen = outcome.map(|()| (bed.force(), bed.radius()));
            if !bed.fails() {
                break;
            }
        }
        seen
    }

    /// The bed as most looks at it need it, however many panels lie behind.
    pub(super) fn near(&self) -> Self {
        self.outline(NEAR, BESIDE_EDGE)
    }

    /// The bed with the panels on either side of the edge up to so many and the one at the axis, and of the others, which
    /// all move alike, the sums. A look that leads to them has to be made at more of the bed.
    fn outline(&self, most: usize, beside_edge: f64) -> Self {
        let (axis, first) = (self.held.min(1), self.held.saturating_sub(most));
        let last = (self.held + most).min(self.panels.len());
        let (inner, outer) = (self.panels.get(axis..first).unwrap_or(&[]), &self.panels[last..]);
        let mut panels = Vec::with_capacity(2 * most.min(self.panels.len()) + 3);
        panels.extend_from_slice(&self.panels[..axis]);
        panels.extend(Panel::sum_of(&self.spectrum, inner));
        panels.extend_from_slice(&self.panels[first.max(axis)..last]);
        panels.extend(Panel::sum_of(&self.spectrum, outer));
        let held = self.held - inner.len() + usize::from(!inner.is_empty());
        let (spectrum, profile) = (self.spectrum.clone(), self.profile.clone());
        Self { spectrum, profile, panels, held, counts: false, sight: Sight::of(beside_edge), ..*self }
    }

    /// Whether a look has asked for a spring that it does not know.
    fn fails(&self) -> bool {
        self.sight.as_ref().is_some_and(|sight| sight.is_asked_too_much.load(Ordering::Relaxed))
    }

    /// The panel at the distance `x` from the axis, at the edge the one whose springs may go `way`.
    fn panel(&self, way: Way, x: f64) -> Option<&Panel> {
        let k = self.panels.partition_point(|panel| panel.outer < x);
        let panel = self.panels.get(match way {
            Way::Opening => k.min(self.held.saturating_sub(1)),
            Way::Closing => k.max(self.held),
        });
        if let (Some(sight), true) = (&self.sight, panel.is_some_and(Panel::is_sum)) {
            sight.is_asked_too_much.store(true, Ordering::Relaxed);
        }
        panel
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
