//! What a column of a data file may hold, the names it goes by and its units.

use crate::input::quantity::{Hertz, Metre, MetrePerSecond, Newton, Pascal, RadianPerSecond, Second, size_of};
use crate::scene::fit::Drive;
use std::f64::consts::TAU;

/// What a column may hold.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Quantity {
    /// Time [s].
    Time,
    /// Depth [m].
    Depth,
    /// Force [N].
    Force,
    /// Way of the piezo towards the sample [m].
    Piezo,
    /// Deflection of the cantilever [m].
    Deflection,
    /// Frequency [Hz].
    Frequency,
    /// Storage modulus [Pa].
    Storage,
    /// Loss modulus [Pa].
    Loss,
    /// Temperature [K].
    Temperature,
    /// Speed before an impact [m/s].
    Speed,
    /// Restitution of an impact.
    Restitution,
    /// Tangential displacement [m].
    Slide,
    /// Tangential force [N].
    Tangential,
}

/// Size of a unit: numerator and denominator.
pub type Size = (f64, f64);

impl Quantity {
    /// All of them.
    pub const ALL: [Self; 13] = [
        Self::Time,
        Self::Depth,
        Self::Force,
        Self::Piezo,
        Self::Deflection,
        Self::Frequency,
        Self::Storage,
        Self::Loss,
        Self::Temperature,
        Self::Speed,
        Self::Restitution,
        Self::Slide,
        Self::Tangential,
    ];

    /// What is looked for by its name in data of what `led` drives; moduli beside depth and force if that is `None`.
    #[must_use]
    pub fn wanted(led: Option<Drive>) -> &'static [Self] {
        match led {
            None | Some(Drive::Depth | Drive::Force) => &[
                Self::Time,
                Self::Depth,
                Self::Force,
                Self::Piezo,
                Self::Deflection,
                Self::Frequency,
                Self::Storage,
                Self::Loss,
                Self::Temperature,
            ],
            Some(Drive::Speed) => &[Self::Speed, Self::Restitution],
            Some(Drive::Slide) => &[Self::Time, Self::Slide, Self::Tangential],
        }
    }

    /// Its name in `--columns`.
    #[must_use]
    pub fn name(self) -> &'static str {
        self.names()[0]
    }

    /// Names by which a column is taken for it, small letters without blanks.
    pub fn names(self) -> &'static [&'static str] {
        match self {
            Self::Time => &["time", "t", "seconds", "timestamp", "zeit"],
            Self::Depth => &[
                "depth",
                "indentation",
                "d",
                "displacement",
                "penetration",
                "delta",
                "δ",
                "h",
                "z",
                "tipposition",
                "verticaltipposition",
                "eindringtiefe",
                "weg",
            ],
            Self::Force => &["force", "f", "load", "p", "normalforce", "kraft", "last"],
            Self::Piezo => &["piezo", "height", "measuredheight", "zsensor", "zpiezo", "heightmeasured"],
            Self::Deflection => &["deflection", "defl", "verticaldeflection", "cantileverdeflection"],
            Self::Frequency => &["frequency", "freq", "omega", "ω", "angularfrequency", "frequenz"],
            Self::Storage => &["storage", "storagemodulus", "g'", "e'", "g′", "e′"],
            Self::Loss => &["loss", "lossmodulus", "g''", "e''", "g″", "e″", "g\"", "e\""],
            Self::Temperature => &["temperature", "temp", "temperatur"],
            Self::Speed => &["speed", "velocity", "v", "impactspeed", "impactvelocity", "geschwindigkeit"],
            Self::Restitution => &["restitution", "e", "cor", "coefficientofrestitution", "stoßzahl"],
            Self::Slide => &["slide", "x", "u", "ux", "displacement", "tangentialdisplacement", "stroke", "weg"],
            Self::Tangential => TANGENTIAL,
        }
    }

    /// Size of a unit it may have.
    pub fn size(self, unit: &str) -> Option<Size> {
        let unit = unit.trim();
        match self {
            Self::Time => size_of::<Second>(unit),
            Self::Depth | Self::Piezo | Self::Deflection | Self::Slide => size_of::<Metre>(unit),
            Self::Force | Self::Tangential => size_of::<Newton>(unit),
            Self::Speed => size_of::<MetrePerSecond>(unit),
            Self::Restitution => (unit == "%").then_some((1.0, 100.0)),
            Self::Frequency if size_of::<Hertz>(unit).is_none() => {
                size_of::<RadianPerSecond>(unit).map(|(up, down)| (up, down * TAU))
            }
            Self::Frequency => size_of::<Hertz>(unit),
            Self::Storage | Self::Loss => size_of::<Pascal>(unit),
            Self::Temperature => ["K", "degC", "°C", "C"].contains(&unit).then_some((1.0, 1.0)),
        }
    }

    /// A unit it may have, for messages.
    pub fn example(self) -> &'static str {
        match self {
            Self::Time => "s",
            Self::Depth | Self::Piezo | Self::Deflection => "nm",
            Self::Force => "nN",
            Self::Speed => "mm/s",
            Self::Restitution => "%",
            Self::Slide => "um",
            Self::Tangential => "mN",
            Self::Frequency => "Hz",
            Self::Storage | Self::Loss => "kPa",
            Self::Temperature => "degC",
        }
    }

    /// What is added to a number of a unit: temperatures in degrees Celsius have another zero.
    pub fn zero(self, unit: Option<&str>) -> f64 {
        match self {
            Self::Temperature if unit.is_some_and(|unit| unit.trim().ends_with('C')) => CELSIUS,
            _ => 0.0,
        }
    }
}

/// 0 °C [K].
const CELSIUS: f64 = 273.15;

/// Names of tangential forces.
const TANGENTIAL: &[&str] = &[
    "tangential",
    "tangentialforce",
    "friction",
    "frictionforce",
    "lateralforce",
    "fx",
    "ft",
    "reibkraft",
    "reibungskraft",
];
