//! Plane shapes: a wave on the half-plane in closed form, a wavy parabola by its Chebyshev series.

use super::contact::{ContactError, Event, NormalContact};
use super::follow::follow;
use super::{Contact, SimulationError, Wanted, results};
use crate::contact::adhesion::equilibrium::Control;
use crate::contact::adhesion::line::Energy;
use crate::contact::plane::{ConnectivityError, PlaneContact, WavyParabola, Westergaard};
use crate::contact::state::Normal;
use crate::numerics::root;
use crate::run::named::Named;
use crate::run::record::{ErrorEstimate, Outcome, Record};
use crate::run::unit::Unit;
use crate::scene::plan::{CappedCoulomb, PlanePlan, Section};
use crate::shape::{PlaneWave, PlaneWavy};
use std::f64::consts::PI;

/// Why a plane contact cannot follow.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
pub enum PlaneError {
    /// The wave is flat.
    #[error(
        "an indentation of {indentation:e} m is beyond full contact at {full:e} m, where it no longer decides the force: expected Press(to: …)"
    )]
    FullContact {
        /// Indentation asked for [m].
        indentation: f64,
        /// Indentation of full contact [m].
        full: f64,
    },
    /// The contact is wider than the datum.
    #[error("the half width {half_width:e} m of the contact reaches the datum: expected a `datum` well above it")]
    Datum {
        /// Half width [m].
        half_width: f64,
    },
    /// The waves cannot be resolved.
    #[error(transparent)]
    Waves(#[from] ConnectivityError),
}

/// Runs a scene with a plane shape.
pub(super) fn run(plan: &PlanePlan, wanted: Wanted) -> Result<Outcome, SimulationError> {
    match &plan.section {
        Section::Wave { wave, sliding } => run_wave(plan, wave, *sliding, wanted),
        Section::Wavy(wavy) => run_wavy(plan, wavy, wanted),
    }
}

fn run_wave(
    plan: &PlanePlan,
    shape: &PlaneWave,
    sliding: Option<CappedCoulomb>,
    wanted: Wanted,
) -> Result<Outcome, SimulationError> {
    let (amplitude, wavelength) = (shape.amplitude.si(), shape.wavelength.si());
    let wave = Westergaard { modulus: plan.pair.normal, amplitude, wavelength };
    let contact = WaveContact { wave, width: shape.width(), pressure: 0.0 };
    let area = contact.area();
    let (mut outcome, _) = outcome(plan, Box::new(contact), wanted)?;
    let largest = outcome.records.iter().map(|record| record.normal.force).fold(0.0, f64::max) / area;
    let mut add = |quantity, unit, value| outcome.results.push(Named::number(quantity, unit, value));
    add("largest_mean_pressure", Unit::PASCAL, largest);
    add("full_contact_pressure", Unit::PASCAL, wave.full_contact_pressure());
    add("rms_slope", Unit::ONE, wave.rms_slope());
    if let Some(CappedCoulomb { coefficient, cap }) = sliding {
        let sliding = wave.sliding(largest, (coefficient, cap));
        add("gross_sliding_force", Unit::NEWTON, sliding.mean_shear * area);
        add("capped_half_width", Unit::METRE, sliding.capped_half_width);
    }
    Ok(outcome)
}

fn run_wavy(plan: &PlanePlan, shape: &PlaneWavy, wanted: Wanted) -> Result<Outcome, SimulationError> {
    let contact = WavyContact { shape, modulus: plan.pair.normal, load: 0.0, piece: None };
    let (mut outcome, broken) = outcome(plan, Box::new(contact), wanted)?;
    outcome.results.push(Named::answer("in_one_piece", broken.is_none()));
    outcome.results.push(Named::number("rms_slope", Unit::ONE, shape.rms_slope()));
    if let Some(force) = broken {
        outcome.warnings.push(format!(
            "under {force:.4e} N the contact is not in one piece, as under other forces that are missing here: it leaks; `explain` tells the least load that seals"
        ));
    }
    Ok(outcome)
}

/// A state of a contact in one piece, or of none at all.
fn is_known(record: &Record) -> bool {
    record.normal.contact_radius.is_some()
}

/// The outcome of a plane contact, and the largest force [N] under which it is not in one piece.
fn outcome<'s>(
    plan: &'s PlanePlan,
    normal: Box<dyn NormalContact + 's>,
    wanted: Wanted,
) -> Result<(Outcome, Option<f64>), SimulationError> {
    let run = follow(&plan.stages, Contact { normal, tangential: None }, wanted)?;
    let (records, broken): (Vec<_>, Vec<_>) = run.records.into_iter().partition(is_known);
    let outcome = Outcome {
        results: results::named(None, &records, &run.fields),
        records,
        fields: run.fields,
        tables: Vec::new(),
        error_estimate: ErrorEstimate {
            relative: 1e-11,
            basis: "closed form or Chebyshev series of the half-plane: rounding".to_owned(),
        },
        warnings: run.notes,
        plan: plan.parts(),
    };
    Ok((outcome, broken.iter().map(|record| record.normal.force).reduce(f64::max)))
}

/// One period of a wave, d = Δt(1 − ln t) with t = sin²(πa/λ) = p̄/p*: the compliance of a row of flat punches,
/// dd/dp̄ = −(2λ/πE*) ln sin(πa/λ), integrated.
#[derive(Debug, Clone)]
struct WaveContact {
    wave: Westergaard,
    width: f64,
    /// Mean pressure [Pa].
    pressure: f64,
}

impl WaveContact {
    /// Nominal area of a period [m²].
    fn area(&self) -> f64 {
        self.wave.wavelength * self.width
    }

    /// Share t = p̄/p* of full contact, at most 1.
    fn share(&self) -> f64 {
        (self.pressure / self.wave.full_contact_pressure()).clamp(0.0, 1.0)
    }

    fn pressed(&self, indentation: f64) -> Result<f64, PlaneError> {
        let full = self.wave.amplitude;
        if indentation > full {
            return Err(PlaneError::FullContact { indentation, full });
        }
        let depth = indentation / full;
        let share = if depth > 0.0 { root::brent(|t| grown(t) - depth, 0.0, 1.0).unwrap_or(1.0) } else { 0.0 };
        Ok(share * self.wave.full_contact_pressure())
    }
}

/// t(1 − ln t), 0 at t = 0.
fn grown(t: f64) -> f64 {
    if t > 0.0 { t * (1.0 - t.ln()) } else { 0.0 }
}

impl NormalContact for WaveContact {
    fn advance(&mut self, control: Control, to: f64, _over: f64) -> Result<Vec<Event>, ContactError> {
        self.pressure = match control {
            Control::Indentation => self.pressed(to)?,
            Control::Force => to / self.area(),
        };
        Ok(Vec::new())
    }

    fn state(&self) -> Normal {
        let t = self.share();
        let log = if t > 0.0 { t.ln() } else { 0.0 };
        let unit = self.area() * self.wave.full_contact_pressure() * self.wave.amplitude;
        Normal {
            indentation: Some(self.wave.amplitude * grown(t)),
            force: self.pressure * self.area(),
            contact_radius: Some(self.wave.half_width(self.pressure)),
            // πE*/(−2 ln sin(πa/λ)) per width; infinite in full contact, zero at first touch.
            stiffness: if t > 0.0 { PI * self.wave.modulus * self.width / -log } else { 0.0 },
            stored: Energy { elastic: unit * t * t * (0.25 - 0.5 * log), surface: 0.0 },
            dissipated: 0.0,
        }
    }

    fn last_depth(&self, _speed: f64) -> Result<f64, ContactError> {
        Ok(0.0)
    }

    fn pressure(&self, r: f64) -> Option<f64> {
        // The field goes on into the neighbouring periods.
        let period = self.wave.wavelength;
        Some(self.wave.pressure(r - period * (r / period).round(), self.pressure))
    }

    fn surface(&self, _r: f64) -> Option<f64> {
        None
    }

    fn stress_intensity(&self) -> Option<f64> {
        None
    }

    fn joined(&self) -> bool {
        self.pressure > 0.0
    }

    fn reach(&self) -> f64 {
        self.wave.half_width(self.pressure)
    }

    fn snapshot(&self) -> Box<dyn NormalContact + '_> {
        Box::new(self.clone())
    }
}

/// A wavy parabola; `piece` is its contact while it is in one piece.
#[derive(Debug, Clone)]
struct WavyContact<'s> {
    shape: &'s PlaneWavy,
    modulus: f64,
    /// Load per width [N/m].
    load: f64,
    piece: Option<PlaneContact>,
}

impl WavyContact<'_> {
    /// Height of the section [m].
    fn height(&self, x: f64) -> f64 {
        0.5 * x * x / self.shape.radius.si() + self.shape.ripple(x)
    }

    /// Means of the height over the contact: with the weight of a flat punch [m], and with the pressure [N].
    fn means(&self, piece: &PlaneContact) -> (f64, f64) {
        let nodes = 4 * piece.series().len();
        let (mut flat, mut pressed) = (0.0, 0.0);
        for j in 0..nodes {
            let (sine, cosine) = (PI * (j as f64 + 0.5) / nodes as f64).sin_cos();
            let x = piece.half_width * cosine;
            let height = self.height(x) / nodes as f64;
            flat += height;
            pressed += PI * piece.half_width * height * sine * piece.pressure(x);
        }
        (flat, pressed)
    }

    /// ln(2D/c), D the datum.
    fn distance(&self, piece: &PlaneContact) -> f64 {
        (2.0 * self.shape.datum.si() / piece.half_width).ln()
    }
}

impl NormalContact for WavyContact<'_> {
    fn advance(&mut self, _control: Control, to: f64, _over: f64) -> Result<Vec<Event>, ContactError> {
        self.load = to / self.shape.width();
        let slope = |x: f64| self.shape.ripple_slope(x);
        let parabola = WavyParabola { modulus: self.modulus, radius: self.shape.radius.si(), slope: &slope };
        self.piece = if self.load > 0.0 { parabola.symmetric(self.load).map_err(PlaneError::from)? } else { None };
        match &self.piece {
            Some(piece) if piece.half_width >= self.shape.datum.si() => {
                Err(PlaneError::Datum { half_width: piece.half_width }.into())
            }
            _ => Ok(Vec::new()),
        }
    }

    /// d = ⟨h⟩ + (2P/πE*) ln(2D/c), ⟨h⟩ the mean with the weight of a flat punch, for ln|x − s| has the mean ln(c/2) with it.
    fn state(&self) -> Normal {
        let (width, force) = (self.shape.width(), self.load * self.shape.width());
        let Some(piece) = &self.piece else {
            let contact_radius = (self.load <= 0.0).then_some(0.0);
            return Normal { indentation: contact_radius, force, contact_radius, ..Normal::default() };
        };
        let (flat, pressed) = self.means(piece);
        let depth = flat + 2.0 * self.load / (PI * self.modulus) * self.distance(piece);
        Normal {
            indentation: Some(depth),
            force,
            contact_radius: Some(piece.half_width),
            stiffness: width * PI * self.modulus / (2.0 * self.distance(piece)),
            stored: Energy { elastic: 0.5 * width * (self.load * depth - pressed), surface: 0.0 },
            dissipated: 0.0,
        }
    }

    fn last_depth(&self, _speed: f64) -> Result<f64, ContactError> {
        Ok(0.0)
    }

    fn pressure(&self, r: f64) -> Option<f64> {
        self.piece.as_ref().map(|piece| piece.pressure(r))
    }

    fn surface(&self, _r: f64) -> Option<f64> {
        None
    }

    fn stress_intensity(&self) -> Option<f64> {
        None
    }

    fn joined(&self) -> bool {
        self.piece.is_some()
    }

    fn reach(&self) -> f64 {
        self.piece.as_ref().map_or(0.0, |piece| piece.half_width)
    }

    fn snapshot(&self) -> Box<dyn NormalContact + '_> {
        Box::new(self.clone())
    }
}
