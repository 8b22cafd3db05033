//! Impact on a viscoelastic bed, springs let go one by one.

mod collocation;
mod energy;
mod law;
mod piece;
mod pressure;
mod step;
#[cfg(test)]
mod tests;

use super::{ImpactError, ImpactState, Projectile, Rebound};
use crate::contact::viscoelastic::Spectrum;
use crate::numerics::{extremum, root};
use crate::shape::Profile;
use law::{BedResponse, Kinematics, Shrinking};
use piece::{MotionPiece, MotionState};
use std::sync::Arc;
use step::{Collocation, SolvedStep};

/// A viscoelastic half-space that may be hit.
///
/// The mass slows down all the time it is in contact, F ≥ 0, so the contact grows once and shrinks
/// once and no spring is touched twice. The bed is continuous: the force follows from the memory
/// integrals of the motion and from when the spring at the edge was touched, without springs to
/// count. Steps of order nine (Radau), shortened to meet a tolerance, with Maxwell elements that
/// fade exactly however short their times. Bodies that adhere are driven by [`SteppedMass`](super::SteppedMass).
/// Check: Kelvin–Voigt with δ = (η/E∞)(E∞²Rv/m²)^{1/5} = 0.1 gives e = 0.83272.
#[derive(Debug, Clone)]
pub struct StruckHalfSpace {
    /// Springs' material.
    pub spectrum: Arc<Spectrum>,
    /// Profile of the indenter.
    pub profile: Arc<dyn Profile>,
}

/// The motion of a mass through a viscoelastic contact.
#[derive(Debug, Clone)]
pub struct Flight {
    model: StruckHalfSpace,
    impact: Projectile,
    loading: Vec<MotionPiece>,
    unloading: Vec<MotionPiece>,
    end: MotionState,
    /// The contact just before its end.
    last: BedResponse,
    parted: bool,
    error: f64,
}

/// Most steps of a run.
const MOST_STEPS: usize = 20_000;
/// The first tolerance is this part of the accuracy; each further run has a sixteenth of it.
const FIRST: f64 = 0.1;
const FINER: f64 = 1.0 / 16.0;
/// Tolerance from which a run that comes to no end has none.
const COARSEST: f64 = 1e-4;
/// The error stated is so many times the difference of two runs: where an end of a step falls by chance, sixteen
/// times the tolerance is not always many times the error.
const SAFETY: f64 = 4.0;
/// First step, in times of the impact.
const FIRST_STEP: f64 = 1e-6;
/// Least tolerance: below it rounding rules.
const LEAST: f64 = 1e-13;
/// Part of the tolerance below which a speed is none.
const RESTING: f64 = 0.1;
/// Part of the tolerance below which a time, in contact times, is none.
const BLINK: f64 = 1e-3;
/// Error that rounding leaves in any case.
const ROUNDING: f64 = 1e-11;

impl StruckHalfSpace {
    /// The motion of a mass, to a relative error of restitution, contact time, greatest depth and force of
    /// `accuracy` (default 1e-6; smaller costs steps as its ninth root, larger shows in the curves).
    ///
    /// Every run is compared with one of a sixteenth of its tolerance, until they agree; the error stated
    /// is the difference, which the finer one has less of, or what its steps say they miss, if that is more. Where
    /// rounding keeps the runs from their end, or from being good, coarser ones are tried as well.
    ///
    /// # Errors
    /// The contact would outgrow the profile, or comes to no end.
    pub fn flight(&self, impact: &Projectile, accuracy: f64) -> Result<Flight, ImpactError> {
        let (mut first, mut best) = (FIRST * accuracy, None::<Flight>);
        loop {
            let known = best.as_ref().map_or(f64::INFINITY, |best| best.error);
            self.agree(impact, accuracy, first, &mut best)?;
            let error = best.as_ref().map_or(f64::INFINITY, |best| best.error);
            if error <= accuracy || first >= COARSEST || error >= known && error < f64::INFINITY {
                return best.ok_or(ImpactError::NoEnd);
            }
            first /= FINER;
        }
    }

    /// Runs from the tolerance `first` on, until two agree or rounding keeps them from their end; the best of them.
    fn agree(
        &self,
        impact: &Projectile,
        accuracy: f64,
        first: f64,
        best: &mut Option<Flight>,
    ) -> Result<(), ImpactError> {
        let mut tolerance = first;
        let mut coarse = None::<Rebound>;
        loop {
            let mut fine = match self.run(impact, tolerance) {
                Err(ImpactError::NoEnd) => return Ok(()),
                run => run?,
            };
            let rebound = fine.rebound();
            if let Some(coarse) = coarse {
                // Runs that took the same steps agree without being right: what the steps themselves miss counts too.
                fine.error = SAFETY * rebound.difference(&coarse).max(fine.misfit()).max(tolerance).max(ROUNDING);
                let is_done = fine.error <= accuracy || tolerance <= LEAST;
                if best.as_ref().is_none_or(|best| fine.error < best.error) {
                    *best = Some(fine);
                }
                if is_done {
                    return Ok(());
                }
            }
            coarse = Some(rebound);
            tolerance = (FINER * tolerance).max(LEAST);
        }
    }

    fn run(&self, impact: &Projectile, tolerance: f64) -> Result<Flight, ImpactError> {
        let depth = self.depth_scale(impact)?;
        let (loading, turned) = self.load(impact, depth, tolerance)?;
        let end = loading.last().map(|solved| solved.end.clone()).unwrap_or_default();
        let last = loading.last().map_or(BedResponse::default(), |solved| solved.answer);
        let loading = loading.into_iter().map(|solved| solved.piece).collect();
        let mut flight = Flight {
            model: self.clone(),
            impact: *impact,
            loading,
            unloading: Vec::new(),
            end,
            last,
            parted: false,
            error: 0.0,
        };
        if turned {
            flight.unload(tolerance)?;
        }
        Ok(flight)
    }

    /// The contact while it grows; whether the mass turns or stays in a liquid.
    fn load(&self, impact: &Projectile, depth: f64, tolerance: f64) -> Result<(Vec<SolvedStep>, bool), ImpactError> {
        let terms = vec![0.0; self.spectrum.terms().len()];
        let flat = 2.0 * self.edge(0.0)? * self.spectrum.viscosity() * impact.speed;
        let mut now = MotionState {
            speed: impact.speed,
            acceleration: -flat / impact.mass,
            memory: terms.clone(),
            sums: terms,
            ..MotionState::default()
        };
        // The contact grows like a root at first, which no polynomial follows: a first step that does not matter.
        let mut pace = Pace::new(impact.speed * tolerance, FIRST_STEP * depth / impact.speed);
        let mut steps: Vec<SolvedStep> = Vec::new();
        while pace.tries < MOST_STEPS {
            let step = Collocation {
                model: self,
                mass: impact.mass,
                start: &now,
                span: pace.span,
                shrinking: None,
                negligible: pace.negligible(),
            };
            let Some(mut solved) = pace.accepted(&step)? else { continue };
            let turned = solved.end.speed.abs() <= pace.negligible();
            if solved.end.speed < 0.0 && !turned {
                pace.cut(&solved, crossing(|theta| solved.piece.speed(theta)));
                continue;
            }
            if turned {
                solved.end.speed = 0.0;
            }
            now = solved.end.clone();
            let rests = self.rests(&now, impact, RESTING * tolerance);
            steps.push(solved);
            if turned || rests {
                return Ok((steps, !rests));
            }
        }
        Err(ImpactError::NoEnd)
    }

    /// Whether a liquid has taken all but a part `least` of the speed and can give no more than it back.
    fn rests(&self, now: &MotionState, impact: &Projectile, least: f64) -> bool {
        let to_come: f64 = self.spectrum.terms().iter().zip(&now.sums).map(|(term, s)| s.abs() * term.time).sum();
        self.spectrum.equilibrium() <= 0.0 && now.speed.abs() + to_come / impact.mass <= least * impact.speed
    }

    /// Depth [m] at which the work against E(0) and the dashpot has used up the kinetic energy.
    ///
    /// # Errors
    /// The contact would outgrow the profile.
    pub fn depth_scale(&self, impact: &Projectile) -> Result<f64, ImpactError> {
        let stiff = self.spectrum.instantaneous();
        let work = |d: f64| {
            let Some(a) = self.profile.edge(d) else { return f64::MAX };
            stiff * self.square_integral(d, a) + self.spectrum.viscosity() * impact.speed * a * d - impact.energy()
        };
        let scale = self.profile.scale();
        let mut high = self.profile.reduced(scale).min(scale).max(1e-6 * scale);
        while work(high) < 0.0 && high < f64::MAX {
            high *= 2.0;
        }
        let mut low = high;
        while work(low) > 0.0 && low > 1e-300 {
            (low, high) = (0.5 * low, low);
        }
        Ok(root::brent(work, low, high).unwrap_or(high))
    }
}

impl Flight {
    /// The contact while it shrinks.
    fn unload(&mut self, tolerance: f64) -> Result<(), ImpactError> {
        let (model, loading) = (self.model.clone(), std::mem::take(&mut self.loading));
        let law = Shrinking::new(&model, &loading);
        self.last.touched = law.full;
        let turn = self.end.time;
        let mut pace = Pace::new(self.impact.speed * tolerance, 1e-3 * turn);
        pace.blink = BLINK * tolerance * turn;
        let mut done = Ok(false);
        while matches!(done, Ok(false)) && pace.tries < MOST_STEPS {
            done = self.lift(law, &mut pace);
        }
        self.loading = loading;
        if done? { Ok(()) } else { Err(ImpactError::NoEnd) }
    }

    /// One step of the way out; whether it was the last.
    fn lift(&mut self, law: Shrinking<'_>, pace: &mut Pace) -> Result<bool, ImpactError> {
        let step = Collocation {
            model: law.model,
            mass: self.impact.mass,
            start: &self.end,
            span: pace.span,
            shrinking: Some((law, self.last.touched)),
            negligible: pace.negligible(),
        };
        let Some(mut solved) = pace.accepted(&step)? else { return Ok(false) };
        if !solved.answer.joined {
            return Ok(self.parts(&law, pace, solved));
        }
        if solved.end.speed > pace.negligible() {
            pace.cut(&solved, crossing(|theta| -solved.piece.speed(theta)));
            return Ok(false);
        }
        let rests = solved.end.speed > 0.0;
        if rests {
            solved.end.speed = 0.0;
        }
        self.end = solved.end;
        self.last = solved.answer;
        self.unloading.push(solved.piece);
        Ok(rests)
    }

    /// A step in which the bodies part: whether this is at one of its ends; otherwise it is cut there.
    fn parts(&mut self, law: &Shrinking<'_>, pace: &mut Pace, solved: SolvedStep) -> bool {
        let part = self.release(law, &solved.piece);
        self.parted = (1.0 - part).min(part) * solved.piece.span <= pace.blink;
        if !self.parted {
            pace.cut(&solved, part);
        } else if part > 0.5 {
            self.end = solved.end;
            self.unloading.push(solved.piece);
        }
        self.parted
    }

    /// Where in a piece the last spring is let go: at its very beginning if the one before has ended there but for rounding.
    fn release(&self, law: &Shrinking<'_>, piece: &MotionPiece) -> f64 {
        let load = |theta: f64| {
            let memory = piece.memory(&self.model.spectrum, theta);
            let time = piece.start.time + theta * piece.span;
            law.first(&Kinematics { time, depth: piece.depth(theta), speed: piece.speed(theta), memory: &memory })
        };
        if load(0.0) <= 0.0 { 0.0 } else { crossing(load) }
    }

    /// What comes of the impact.
    #[must_use]
    pub fn rebound(&self) -> Rebound {
        let deepest = self.loading.last().map_or(0.0, |piece| piece.depth(1.0));
        let restitution = if self.parted { (-self.end.speed / self.impact.speed).max(0.0) } else { 0.0 };
        let accelerations = self.loading.iter().chain(&self.unloading).map(strongest);
        Rebound {
            contact_time: self.parted.then_some(self.end.time),
            greatest_depth: deepest,
            greatest_force: self.impact.mass * accelerations.fold(0.0, f64::max),
            restitution,
            lost: self.impact.energy() * (1.0 - restitution) * (1.0 + restitution),
            error: self.error,
        }
    }

    /// Relative errors of the speed, summed over the steps, and of the greatest force in its step.
    fn misfit(&self) -> f64 {
        let pieces = || self.loading.iter().chain(&self.unloading);
        let speed: f64 = pieces().map(|piece| piece.missed).sum();
        let forces = pieces().map(|piece| (strongest(piece), piece.missed / piece.span));
        let (most, off) = forces.max_by(|x, y| x.0.total_cmp(&y.0)).unwrap_or((1.0, 0.0));
        (speed / self.impact.speed).max(off / most.max(f64::MIN_POSITIVE))
    }

    /// Depth [m] at the time `t` [s] since the first touch.
    #[must_use]
    pub fn depth(&self, t: f64) -> f64 {
        self.piece_at(t).map_or(0.0, |piece| piece.depth(piece.part(t)))
    }

    /// When the bodies part, or the mass has come to rest [s].
    #[must_use]
    pub fn duration(&self) -> f64 {
        self.end.time
    }

    /// Steps of the finest run.
    #[must_use]
    pub fn steps(&self) -> usize {
        self.loading.len() + self.unloading.len()
    }

    /// Bytes of its state.
    #[must_use]
    pub fn bytes(&self) -> usize {
        self.steps() * (size_of::<MotionPiece>() + 2 * size_of::<f64>() * self.model.spectrum.terms().len())
    }

    /// The motion at the time `t` [s].
    fn piece_at(&self, t: f64) -> Option<&MotionPiece> {
        let turn = self.loading.last().map_or(0.0, MotionPiece::end);
        piece::at(if t <= turn || self.unloading.is_empty() { &self.loading } else { &self.unloading }, t)
    }
}

/// Greatest deceleration in a piece: the best of a few places, and the top about it.
fn strongest(piece: &MotionPiece) -> f64 {
    const LOOKS: u32 = 16;
    let at = |theta: f64| -piece.acceleration(theta);
    let looks = (0..=LOOKS).map(|k| f64::from(k) / f64::from(LOOKS));
    let best = looks.max_by(|&x, &y| at(x).total_cmp(&at(y))).unwrap_or(0.0);
    let cell = 1.0 / f64::from(LOOKS);
    at(best).max(extremum::greatest(at, (best - cell).max(0.0), (best + cell).min(1.0)).value)
}

/// Where a function that is positive at the beginning of a step passes zero.
fn crossing(of: impl Fn(f64) -> f64) -> f64 {
    root::brent(of, 0.0, 1.0).unwrap_or(1.0)
}

/// The length of the steps.
struct Pace {
    /// Duration of the next step [s].
    span: f64,
    /// Error of the speed that a step may have [m/s].
    tolerance: f64,
    /// Time that is no matter [s].
    blink: f64,
    /// Steps tried.
    tries: usize,
}

impl Pace {
    fn new(tolerance: f64, span: f64) -> Self {
        Self { span, tolerance, blink: 0.0, tries: 0 }
    }

    fn negligible(&self) -> f64 {
        1e-3 * self.tolerance
    }

    /// The step solved, if it is good enough; sets the length of the next one.
    fn accepted(&mut self, step: &Collocation<'_>) -> Result<Option<SolvedStep>, ImpactError> {
        self.tries += 1;
        let Some(solved) = step.solve()? else {
            self.span = 0.25 * step.span;
            return Ok(None);
        };
        let ratio = self.tolerance / solved.error.max(1e-300);
        let wanted = 0.8 * ratio.powf(1.0 / 6.0);
        if ratio < 1.0 {
            self.span = step.span * wanted.clamp(0.1, 0.8);
            return Ok(None);
        }
        self.span = step.span * wanted.clamp(0.5, 3.0);
        Ok(Some(solved))
    }

    /// The step `solved` again, shortened to the part `part`.
    fn cut(&mut self, solved: &SolvedStep, part: f64) {
        self.span = part * solved.piece.span;
    }
}
