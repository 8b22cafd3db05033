//! Motions of a machine.

use crate::input::quantity::{Displacement, Duration, Length, Velocity};
use serde::{Deserialize, Serialize};

/// The far end of the tangential spring goes on at a speed; what is prescribed of depth or force stays.
#[derive(Debug, Clone, PartialEq, Deserialize, Serialize)]
#[serde(deny_unknown_fields)]
pub struct Drive {
    /// Speed of the far end [m/s]; backwards below zero, at zero it stands still.
    pub speed: Velocity,
    /// Duration [s].
    pub over: Duration,
}

/// The mass is let go beside the present depth, which the spring and the weight hold.
#[derive(Debug, Clone, PartialEq, Deserialize, Serialize)]
#[serde(deny_unknown_fields)]
pub struct Ring {
    /// How much deeper it is let go [m]; less deep below zero.
    pub amplitude: Displacement,
    /// Duration [s].
    pub over: Duration,
}

/// The mass falls from rest and bounces until it lies.
#[derive(Debug, Clone, PartialEq, Deserialize, Serialize)]
#[serde(deny_unknown_fields)]
pub struct Fall {
    /// Height above the first touch [m].
    pub height: Length,
    /// Longest duration [s].
    pub over: Duration,
}

/// A motion of a machine in numbers.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum MachineMotion {
    /// The far end of the tangential spring goes on.
    Drive {
        /// Its speed [m/s].
        speed: f64,
    },
    /// The mass swings about the present depth.
    Ring {
        /// How much deeper it is let go [m].
        amplitude: f64,
    },
    /// The mass falls and bounces.
    Fall {
        /// Height above the first touch [m].
        height: f64,
    },
}

/// What a history entry asks of a machine.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct MachineEntry {
    /// Number of the history entry.
    pub entry: usize,
    /// The motion.
    pub motion: MachineMotion,
    /// Duration, of a fall the longest [s].
    pub over: f64,
    /// Number of records, at equal times.
    pub records: usize,
}

/// Records of a motion unless the scene says otherwise: some swings on paper.
pub(super) const RECORDS: usize = 1000;

impl Drive {
    pub(super) fn motion(&self) -> (MachineMotion, f64) {
        (MachineMotion::Drive { speed: self.speed.si() }, self.over.si())
    }
}

impl Ring {
    pub(super) fn motion(&self) -> (MachineMotion, f64) {
        (MachineMotion::Ring { amplitude: self.amplitude.si() }, self.over.si())
    }
}

impl Fall {
    pub(super) fn motion(&self) -> (MachineMotion, f64) {
        (MachineMotion::Fall { height: self.height.si() }, self.over.si())
    }
}

impl MachineMotion {
    /// Whether it moves the mass along the surface.
    #[must_use]
    pub fn is_along(self) -> bool {
        match self {
            Self::Drive { .. } => true,
            Self::Ring { .. } | Self::Fall { .. } => false,
        }
    }
}
