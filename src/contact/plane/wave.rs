//! One period of a wave on the half-plane.

use super::Westergaard;
use crate::contact::adhesion::line::Energy;
use crate::contact::error::{ContactError, PlaneError};
use crate::contact::model::{ContactModel, Event, Glance, Loading, Pull, Straight};
use crate::contact::state::Normal;
use crate::numerics::root;
use std::f64::consts::PI;

/// One period of a wave, d = Δt(1 − ln t) with t = sin²(πa/λ) = p̄/p*: the compliance of a row of flat punches,
/// dd/dp̄ = −(2λ/πE*) ln sin(πa/λ), integrated.
#[derive(Debug, Clone)]
pub struct WaveContact {
    wave: Westergaard,
    width: f64,
    /// Mean pressure [Pa].
    pressure: f64,
}

impl WaveContact {
    /// A period of `wave` over the width `width` [m], just touching.
    #[must_use]
    pub fn new(wave: Westergaard, width: f64) -> Self {
        Self { wave, width, pressure: 0.0 }
    }

    /// Nominal area of a period [m²].
    #[must_use]
    pub fn area(&self) -> f64 {
        self.wave.wavelength * self.width
    }

    /// Share t = p̄/p* of full contact, at most 1.
    fn share(&self) -> f64 {
        (self.pressure / self.wave.full_contact_pressure()).clamp(0.0, 1.0)
    }

    /// Mean pressure [Pa] at a depth [m].
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

impl ContactModel for WaveContact {
    fn follow(&mut self, piece: &Straight) -> Result<Vec<Event>, ContactError> {
        self.pressure = self.pressed(piece.to)?;
        Ok(Vec::new())
    }

    fn look(&mut self, piece: &Straight) -> Result<Glance, ContactError> {
        let pressure = self.pressed(piece.to)?;
        Ok(Glance { force: pressure * self.area(), contact_radius: self.wave.half_width(pressure) })
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

    fn joined(&self) -> bool {
        self.pressure > 0.0
    }

    fn loading(&self) -> Option<Box<dyn Loading + '_>> {
        self.joined().then(|| Box::new(self.clone()) as Box<dyn Loading>)
    }

    fn copy(&self) -> Box<dyn ContactModel> {
        Box::new(self.clone())
    }

    fn press(&mut self, pull: &Pull) -> Option<Result<Vec<Event>, ContactError>> {
        self.pressure = pull.force / self.area();
        Some(Ok(Vec::new()))
    }

    fn last_depth(&self) -> Option<Result<f64, ContactError>> {
        Some(Ok(0.0))
    }
}

impl Loading for WaveContact {
    fn contact_radius(&self) -> f64 {
        self.wave.half_width(self.pressure)
    }

    fn pressure(&self, x: f64) -> Option<f64> {
        // The field goes on into the neighbouring periods.
        let period = self.wave.wavelength;
        Some(self.wave.pressure(x - period * (x / period).round(), self.pressure))
    }
}
