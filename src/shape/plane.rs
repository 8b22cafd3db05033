//! Plane shapes: long bodies whose section is a wave or a wavy parabola.

use crate::input::quantity::{Amplitude, Length};
use serde::{Deserialize, Serialize};
use std::f64::consts::{PI, SQRT_2};

/// Cylinder lying on its side: f(x) = x²/2R, long across.
///
/// F = πE*Wa²/4R with the half width a and the width W. The displacement of a half-plane grows with the logarithm of the
/// distance: it is zero at the distance `datum` L, of the order of the size of the body, and the indentation is
/// d = (a²/2R)(ln(2L/a) + ½). Force and half width do not depend on L; with adhesion, memory and friction
/// neither do, but where depth or slide are prescribed.
#[derive(Debug, Clone, PartialEq, Deserialize, Serialize)]
#[serde(deny_unknown_fields)]
pub struct Cylinder {
    /// Radius R [m].
    pub radius: Length,
    /// Distance at which the half-plane is at rest [m].
    pub datum: Length,
    /// Width across the section [m]; 1 m if absent, so that forces are forces per length.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub width: Option<Length>,
}

/// Sinusoidal surface Δ(1 − cos(2πx/λ)), long across; one period of it is computed (Westergaard 1939).
///
/// Forces are those of one period of the given width, indentation counts from the mean plane of the half-plane's surface.
#[derive(Debug, Clone, PartialEq, Deserialize, Serialize)]
#[serde(deny_unknown_fields)]
pub struct PlaneWave {
    /// Amplitude Δ [m], half the height from trough to crest.
    pub amplitude: Length,
    /// Wavelength λ [m].
    pub wavelength: Length,
    /// Width across the section [m]; 1 m if absent, so that forces are forces per length.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub width: Option<Length>,
}

/// Parabola x²/2R with waves Σ A(1 − cos(2πx/λ)), long across, pressed by a force (Kudish, Cohen & Vyletel).
///
/// Computed while the contact is in one piece. The displacement of a half-plane grows with the logarithm of the distance: it is zero
/// at the distance `datum`, of the order of the size of the body; only indentation and stiffness depend on it.
#[derive(Debug, Clone, PartialEq, Deserialize, Serialize)]
#[serde(deny_unknown_fields)]
pub struct PlaneWavy {
    /// Radius of curvature R [m].
    pub radius: Length,
    /// Waves on the parabola.
    pub waves: Vec<PlaneRipple>,
    /// Distance at which the half-plane is at rest [m].
    pub datum: Length,
    /// Width across the section [m]; 1 m if absent, so that forces are forces per length.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub width: Option<Length>,
}

/// One wave on a parabola.
#[derive(Debug, Clone, PartialEq, Deserialize, Serialize)]
#[serde(deny_unknown_fields)]
pub struct PlaneRipple {
    /// Amplitude A [m], half the height from trough to crest.
    pub amplitude: Amplitude,
    /// Wavelength λ [m].
    pub wavelength: Length,
}

impl Cylinder {
    /// Width across the section [m].
    #[must_use]
    pub fn width(&self) -> f64 {
        self.width.map_or(1.0, Length::si)
    }
}

impl PlaneWave {
    /// Width across the section [m].
    #[must_use]
    pub fn width(&self) -> f64 {
        self.width.map_or(1.0, Length::si)
    }

    /// Root mean square slope √2 πΔ/λ.
    #[must_use]
    pub fn rms_slope(&self) -> f64 {
        SQRT_2 * PI * self.amplitude.si() / self.wavelength.si()
    }
}

impl PlaneWavy {
    /// Width across the section [m].
    #[must_use]
    pub fn width(&self) -> f64 {
        self.width.map_or(1.0, Length::si)
    }

    /// Height of the waves [m] at a place x [m].
    #[must_use]
    pub fn ripple(&self, x: f64) -> f64 {
        // 1 − cos = 2 sin², without cancellation.
        self.sum(|amplitude, k| 2.0 * amplitude * (0.5 * k * x).sin().powi(2))
    }

    /// Slope of the waves at a place x [m].
    #[must_use]
    pub fn ripple_slope(&self, x: f64) -> f64 {
        self.sum(|amplitude, k| amplitude * k * (k * x).sin())
    }

    /// Root mean square slope of the waves.
    #[must_use]
    pub fn rms_slope(&self) -> f64 {
        self.sum(|amplitude, k| 0.5 * (amplitude * k).powi(2)).sqrt()
    }

    fn sum(&self, term: impl Fn(f64, f64) -> f64) -> f64 {
        let of = |wave: &PlaneRipple| term(wave.amplitude.si(), std::f64::consts::TAU / wave.wavelength.si());
        self.waves.iter().map(of).sum()
    }
}
