//! What is prescribed during a stage of a history.
//!
//! # Examples
//! ```
//! use springbed::drive::course::{Path, Wave};
//!
//! // Half-way through a ramp, and a quarter of the way through a sine, where it turns.
//! assert_eq!(Path::To(2.0).at(1.0, 0.5, 10.0), 1.5);
//! let wave = Path::Wave(Wave { amplitude: 0.1, frequency: 1.0 });
//! assert_eq!(wave.turns(1.0), [0.25, 0.75]);
//! assert!((wave.at(1.0, 0.25, 1.0) - 1.1).abs() < 1e-15);
//! ```

use crate::contact::adhesion::equilibrium::Control;
use std::f64::consts::TAU;

/// How a prescribed quantity moves during a stage.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Path {
    /// Linearly to this value.
    To(f64),
    /// Stays.
    Stay,
    /// On at this speed [m/s].
    Steady {
        /// Speed [m/s].
        speed: f64,
    },
    /// amplitude·sin(2π·frequency·t) about the present value.
    Wave(Wave),
    /// Back at this speed [m/s] until the bodies part.
    UntilParted {
        /// Speed [m/s].
        speed: f64,
    },
}

/// A sine.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Wave {
    /// Amplitude [m].
    pub amplitude: f64,
    /// Frequency [Hz].
    pub frequency: f64,
}

impl Wave {
    /// The wave at the time `t` [s].
    #[must_use]
    pub fn at(self, t: f64) -> f64 {
        self.amplitude * (TAU * (t * self.frequency).fract()).sin()
    }

    /// Its speed at the time `t` [s].
    #[must_use]
    pub fn speed_at(self, t: f64) -> f64 {
        TAU * self.frequency * self.amplitude * (TAU * (t * self.frequency).fract()).cos()
    }
}

impl Path {
    /// The value that starts at `from` at the part `part` of a stage that lasts `over` [s].
    #[must_use]
    pub fn at(self, from: f64, part: f64, over: f64) -> f64 {
        match self {
            Self::To(to) if part >= 1.0 => to,
            Self::To(to) => from + part * (to - from),
            Self::Stay | Self::UntilParted { .. } => from,
            Self::Steady { speed } => from + speed * part * over,
            Self::Wave(wave) => from + wave.at(part * over),
        }
    }

    /// Whether it is a sine.
    #[must_use]
    pub fn is_wave(self) -> bool {
        match self {
            Self::Wave(_) => true,
            Self::To(_) | Self::Stay | Self::Steady { .. } | Self::UntilParted { .. } => false,
        }
    }

    /// The parts of a stage of `over` [s] at which the path turns.
    #[must_use]
    pub fn turns(self, over: f64) -> Vec<f64> {
        let Self::Wave(Wave { frequency, .. }) = self else { return Vec::new() };
        let turn = |j: u32| (0.5 * f64::from(j) + 0.25) / (frequency * over);
        (0..u32::MAX).map(turn).take_while(|part| *part < 1.0).collect()
    }
}

/// How much of a history a stage is.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Extent {
    /// A whole entry.
    Entry,
    /// One row of a table.
    Row,
}

/// A stage as a drive sees it: all of it is known when it begins.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Course {
    /// What is prescribed.
    pub control: Control,
    /// How it moves; never until the bodies part, which is a depth by then.
    pub normal: Path,
    /// How the tangential displacement moves.
    pub tangential: Path,
    /// Duration [s]; zero for a jump.
    pub over: f64,
    /// Whether the stage is one of many of a table.
    pub extent: Extent,
}
