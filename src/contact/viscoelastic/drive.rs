//! Ways to drive a bed, whatever it is made of.

use super::Spectrum;
use super::layout::Layout;
use super::lazy::Lazy;
use super::ledger::Ledger;
use super::memory::{BedError, Memory};
use super::pressing::Pressing;
pub use super::pressing::Ramp;
use crate::shape::Profile;
use std::f64::consts::TAU;
use std::sync::Arc;

/// State of a viscoelastic contact.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct State {
    /// Indentation [m].
    pub indentation: f64,
    /// Normal force [N].
    pub force: f64,
    /// Contact radius [m].
    pub contact_radius: f64,
    /// Stiffness 2E(0)a [N/m] against a sudden step.
    pub stiffness: f64,
    /// Work, stored energy and heat [J] since the beginning.
    pub ledger: Ledger,
}

/// A bed that can be moved at constant speed, and asked what would be if it were.
pub trait Bed: Clone {
    /// State after a motion at constant `speed` [m/s] for `duration` [s], taken back.
    ///
    /// # Errors
    /// The contact would outgrow the profile.
    fn state_after(&mut self, speed: f64, duration: f64) -> Result<State, BedError>;

    /// Force [N] after a motion, taken back.
    ///
    /// # Errors
    /// As [`state_after`](Self::state_after).
    fn force_after(&mut self, speed: f64, duration: f64) -> Result<f64, BedError> {
        Ok(self.glance(speed, duration)?.0)
    }

    /// Force [N] and contact radius [m] after a motion, taken back.
    ///
    /// # Errors
    /// As [`state_after`](Self::state_after).
    fn glance(&mut self, speed: f64, duration: f64) -> Result<(f64, f64), BedError>;

    /// Moves to the depth `to` [m] in `duration` [s], and lands on it to the last bit.
    ///
    /// # Errors
    /// As [`state_after`](Self::state_after).
    fn reach(&mut self, to: f64, duration: f64) -> Result<(), BedError>;

    /// The springs' material.
    fn spectrum(&self) -> &Spectrum;

    /// Moves at constant `speed` [m/s] for `duration` [s].
    ///
    /// # Errors
    /// As [`state_after`](Self::state_after).
    fn advance(&mut self, speed: f64, duration: f64) -> Result<(), BedError>;

    /// State now.
    fn state(&self) -> State;
}

impl Bed for Memory {
    fn state_after(&mut self, speed: f64, duration: f64) -> Result<State, BedError> {
        Ok(self.after(speed, duration)?.state())
    }

    fn glance(&mut self, speed: f64, duration: f64) -> Result<(f64, f64), BedError> {
        Memory::force_after(self, speed, duration)
    }

    fn reach(&mut self, to: f64, duration: f64) -> Result<(), BedError> {
        Memory::reach(self, to, duration)
    }

    fn spectrum(&self) -> &Spectrum {
        &self.ground.spectrum
    }

    fn advance(&mut self, speed: f64, duration: f64) -> Result<(), BedError> {
        Memory::advance(self, speed, duration)
    }

    fn state(&self) -> State {
        State {
            indentation: self.indentation(),
            force: self.force(),
            contact_radius: self.radius(),
            stiffness: self.stiffness(),
            ledger: self.ledger(),
        }
    }
}

/// A lazy bed that grows with the contact.
#[derive(Debug, Clone)]
pub struct Springs {
    bed: Lazy,
    profile: Arc<dyn Profile>,
    instantaneous: f64,
}

impl Springs {
    /// A bed never touched, or in the state `before` left behind; `count` springs as far as `radius` [m].
    #[must_use]
    pub fn new(spectrum: Arc<Spectrum>, profile: Arc<dyn Profile>, layout: Layout) -> Self {
        let instantaneous = spectrum.instantaneous();
        Self { bed: Lazy::new(spectrum, layout), profile, instantaneous }
    }

    /// The springs of a continuous bed, at the places of `layout`.
    #[must_use]
    pub fn of(memory: &Memory, layout: Layout) -> Self {
        let (spectrum, profile) = memory.ground();
        let instantaneous = spectrum.instantaneous();
        let bed = Lazy::continued(spectrum, layout, memory.indentation(), |x| memory.spring(x));
        Self { bed, profile, instantaneous }
    }

    /// ∫ F dt [N s] over a motion, and whether the bodies touch at its end; taken back.
    ///
    /// # Errors
    /// The contact would outgrow the profile.
    pub fn impulse_after(&mut self, speed: f64, duration: f64) -> Result<(f64, bool), BedError> {
        self.widen(self.bed.indentation() + speed * duration)?;
        Ok(self.bed.tried(speed, duration, |bed| (bed.impulse(), bed.pressed() > 0)))
    }

    /// The bed.
    #[must_use]
    pub fn bed(&self) -> &Lazy {
        &self.bed
    }

    /// Makes the bed wide enough for the depth `d` [m].
    fn widen(&mut self, d: f64) -> Result<(), BedError> {
        if d > self.bed.layout().height.last().copied().unwrap_or(0.0) {
            let a = self.profile.edge(d).ok_or(BedError::BeyondProfile { indentation: d })?;
            if !matches!(self.profile.rim(), crate::shape::Rim::Wall(_)) {
                self.bed.extend(self.profile.as_ref(), 1.25 * a);
            }
        }
        Ok(())
    }
}

impl Bed for Springs {
    fn state_after(&mut self, speed: f64, duration: f64) -> Result<State, BedError> {
        self.widen(self.bed.indentation() + speed * duration)?;
        let instantaneous = self.instantaneous;
        Ok(self.bed.tried(speed, duration, |bed| state_of(bed, instantaneous)))
    }

    fn glance(&mut self, speed: f64, duration: f64) -> Result<(f64, f64), BedError> {
        self.widen(self.bed.indentation() + speed * duration)?;
        Ok(self.bed.tried(speed, duration, |bed| (bed.force(), bed.radius())))
    }

    fn reach(&mut self, to: f64, duration: f64) -> Result<(), BedError> {
        self.widen(to)?;
        self.bed.reach(to, duration);
        Ok(())
    }

    fn spectrum(&self) -> &Spectrum {
        self.bed.spectrum()
    }

    fn advance(&mut self, speed: f64, duration: f64) -> Result<(), BedError> {
        self.widen(self.bed.indentation() + speed * duration)?;
        self.bed.advance(speed, duration);
        Ok(())
    }

    fn state(&self) -> State {
        state_of(&self.bed, self.instantaneous)
    }
}

fn state_of(bed: &Lazy, instantaneous: f64) -> State {
    let contact_radius = bed.radius();
    State {
        indentation: bed.indentation(),
        force: bed.force(),
        contact_radius,
        stiffness: 2.0 * instantaneous * contact_radius,
        ledger: bed.ledger(),
    }
}

/// States at the times `records` [s] of a motion at constant `speed`; the last one ends it.
///
/// # Errors
/// The contact would outgrow the profile.
pub fn indent(bed: &mut impl Bed, speed: f64, records: &[f64]) -> Result<Vec<State>, BedError> {
    let Some((&end, inner)) = records.split_last() else { return Ok(Vec::new()) };
    let mut states = inner.iter().map(|&t| bed.state_after(speed, t)).collect::<Result<Vec<_>, _>>()?;
    bed.advance(speed, end)?;
    states.push(bed.state());
    Ok(states)
}

/// States at `records` [s] of d₀ + A sin 2πft, followed in chords that leave the arc by at most
/// `accuracy`·A.
///
/// # Errors
/// The contact would outgrow the profile.
pub fn oscillate(
    bed: &mut impl Bed,
    (amplitude, frequency): (f64, f64),
    records: &[f64],
    accuracy: f64,
) -> Result<Vec<State>, BedError> {
    // A chord over the angle α leaves its arc by 1 − cos(α/2) ≈ α²/8.
    let chord = (8.0 * accuracy).sqrt().min(0.1) / (TAU * frequency);
    let center = bed.state().indentation;
    let depth = |t: f64| center + amplitude * (TAU * (frequency * t).fract()).sin();
    let mut states = Vec::with_capacity(records.len());
    let last = records.last().copied().unwrap_or(0.0);
    let mut now = 0.0;
    for &record in records {
        while record - now > 1e-9 * chord {
            // The chords' ends do not depend on the records: a record cuts a chord without bending it.
            let end = last.min(chord * (now / chord + 1e-9).floor() + chord);
            let speed = (depth(end) - bed.state().indentation) / (end - now);
            let until = end.min(record);
            bed.advance(speed, until - now)?;
            now = until;
        }
        states.push(bed.state());
    }
    Ok(states)
}

/// States at `records` [s] of a bed under a prescribed force, in the pieces of [`Pressing`].
///
/// # Errors
/// The contact would outgrow the profile.
pub fn press(bed: &mut impl Bed, ramp: &Ramp, records: &[f64]) -> Result<Vec<State>, BedError> {
    let end = records.last().copied().unwrap_or(0.0);
    let mut pressing = Pressing::new(*ramp, end);
    let mut states = Vec::with_capacity(records.len());
    let mut now = 0.0;
    while let Some(piece) = pressing.next(bed)? {
        while let Some(&t) = records.get(states.len()).filter(|&&t| t < piece.until) {
            states.push(bed.state_after(piece.speed, t - now)?);
        }
        bed.advance(piece.speed, piece.until - now)?;
        now = piece.until;
    }
    states.resize(records.len(), bed.state());
    Ok(states)
}

#[cfg(test)]
mod tests {
    use super::super::creep::Creep;
    use super::super::laws::unit_ball;
    use super::*;
    use crate::input::quantity::Length;
    use crate::material::Relaxation;
    use crate::shape::FlatPunch;

    fn solid() -> Arc<Spectrum> {
        let terms = vec![(3.0, 0.3), (2.0, 5.0)];
        Arc::new(Spectrum::new(&Relaxation { equilibrium: 1.0, terms, viscosity: 0.0 }))
    }

    /// Sudden load: a³ = (3R/4) F J(t). Bound: rounding, and the ramp of 1e-12 s.
    #[test]
    fn creep_under_a_sudden_load() {
        let spectrum = solid();
        let creep = Creep::new(spectrum.clone(), Arc::new(unit_ball())).after(1e-3, 1e-12);
        for t in [0.0, 1e-6, 0.1, 1.0, 30.0, 1e9] {
            let cube = creep.after(1e-3, t).indentation().unwrap().powf(1.5);
            let exact = 0.75e-3 * spectrum.creep(t);
            assert!((cube / exact - 1.0).abs() < 1e-11, "{t}: {cube:e} {exact:e}");
        }
    }

    /// The bed driven to a force against the exact creep. Bound: the accuracy asked for, and the cells.
    #[test]
    fn driven_creep_is_exact_creep() {
        let (spectrum, ball): (_, Arc<dyn Profile>) = (solid(), Arc::new(unit_ball()));
        let exact = Creep::new(spectrum.clone(), ball.clone());
        let layout = Layout::graded(ball.as_ref(), (1e-3, 0.1), 2000);
        let mut bed = Springs::new(spectrum, ball, layout);
        let up =
            press(&mut bed, &Ramp { from: 0.0, rate: 1e-3, accuracy: 1e-5, scale: 1e-3 }, &[0.25, 0.5, 1.0]).unwrap();
        let held =
            press(&mut bed, &Ramp { from: 1e-3, rate: 0.0, accuracy: 1e-5, scale: 1e-3 }, &[0.1, 1.0, 10.0]).unwrap();
        let top = exact.after(1e-3, 1.0);
        let expected = [0.25, 0.5, 1.0].map(|t| exact.after(1e-3 * t, t));
        let expected = expected.into_iter().chain([0.1, 1.0, 10.0].map(|t| top.after(1e-3, t)));
        for (seen, exact) in up.iter().chain(&held).zip(expected) {
            let d = exact.indentation().unwrap();
            assert!((seen.indentation / d - 1.0).abs() < 3e-5, "{} {d}", seen.indentation);
        }
    }

    /// Unloading by force, and waiting unloaded: the force is met, the contact shrinks.
    #[test]
    fn unloaded_by_force() {
        let ball: Arc<dyn Profile> = Arc::new(unit_ball());
        let mut bed = Memory::new(solid(), ball);
        indent(&mut bed, 0.01, &[1.0]).unwrap();
        let force = bed.force();
        let ramp = Ramp { from: force, rate: -0.5 * force, accuracy: 1e-4, scale: force };
        let seen = press(&mut bed, &ramp, &[0.5, 1.0, 1.5]).unwrap();
        for (state, part) in seen.iter().zip([0.75, 0.5, 0.25]) {
            assert!((state.force / force - part).abs() < 1e-4, "{} {part}", state.force / force);
        }
        assert!(seen.windows(2).all(|pair| pair[1].contact_radius < pair[0].contact_radius));
    }

    /// A flat punch is linear: F = F₀ + 2bA(E′ sin ωt + E″ cos ωt) once the start is forgotten.
    #[test]
    fn oscillation_gives_storage_and_loss() {
        let terms = vec![(3.0, 0.05), (2.0, 0.4)];
        let spectrum = Arc::new(Spectrum::new(&Relaxation { equilibrium: 1.0, terms, viscosity: 0.02 }));
        let punch: Arc<dyn Profile> = Arc::new(FlatPunch { radius: Length::new(0.5).unwrap() });
        let layout = Layout::uniform(punch.as_ref(), 0.5, 10);
        let mut bed = Springs::new(spectrum.clone(), punch, layout);
        indent(&mut bed, 1.0, &[1.0]).unwrap();
        indent(&mut bed, 0.0, &[100.0]).unwrap();
        let records: Vec<f64> = (1..=400).map(|k| f64::from(k) / 40.0).collect();
        let seen = oscillate(&mut bed, (0.01, 1.0), &records, 1e-7).unwrap();
        for (state, t) in seen.iter().zip(&records).skip(360) {
            let part = 0.01 * (spectrum.storage(TAU) * (TAU * t).sin() + spectrum.loss(TAU) * (TAU * t).cos());
            // Chords: 1e-7 of the depth, and of the speed the root of it where there is a dashpot.
            assert!(
                (state.force - 1.0 - part).abs() < 1e-6 + 0.02 * 0.01 * TAU * 1e-3,
                "{t}: {}",
                state.force - 1.0 - part
            );
        }
    }
}
