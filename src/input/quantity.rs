//! Checked numbers: a value in SI units with its dimension and the range that makes sense for it.
//!
//! A scene gives a quantity as a plain number in SI units or as text with a unit (`"10 mm"`).
//! Parsing is the only way in, so the rest of the program never meets a NaN, an infinity or a
//! negative radius.
//!
//! # Examples
//! ```
//! use springbed::input::quantity::{Length, Modulus};
//!
//! let young: Modulus = "210 GPa".parse()?;
//! assert_eq!(young.si(), 210e9);
//! assert!(Length::new(-1.0).is_err());
//! let wrong = "20 mJ".parse::<Length>().unwrap_err();
//! assert!(wrong.to_string().contains("expected a length"));
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

use serde::{Deserialize, Deserializer, Serialize, Serializer, de};
use std::{fmt, marker::PhantomData, str::FromStr};

/// Why a quantity was refused; the text says what it was and what would be right.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[error("{0}")]
pub struct QuantityError(String);

/// A physical dimension: its name, its SI unit and the other units it may be given in.
pub trait Dimension: Copy + fmt::Debug + 'static {
    /// Name in words, as used in messages.
    const NAME: &'static str;
    /// Accepted units with numerator and denominator of their size in SI units; the first is SI.
    ///
    /// The size is a quotient so that `10 mm` is exactly `10.0 / 1e3`, the nearest `f64` to 0.01.
    const UNITS: &'static [(&'static str, f64, f64)];
    /// Names and signs of the parts it may be given as the sum of; the last may be left out. None of most.
    const PARTS: &'static [(&'static str, f64)] = &[];
    /// Units that do not count from the zero of the SI unit, with what zero of them is in it. None of most.
    const ZEROS: &'static [(&'static str, f64)] = &[];
}

/// Which values make sense.
pub trait Domain: Copy + fmt::Debug + 'static {
    /// What would be right, in words.
    const RIGHT: &'static str;
    /// Whether `value` is in the range.
    fn holds(value: f64) -> bool;
}

macro_rules! dimension {
    (
        $(#[$doc:meta])* $name:ident, $words:literal, [$(($unit:literal, $up:expr, $down:expr)),+ $(,)?]
        $(, sum of [$(($part:literal, $sign:expr)),+ $(,)?])?
        $(, from [$(($scale:literal, $zero:expr)),+ $(,)?])?
    ) => {
        $(#[$doc])*
        #[derive(Debug, Clone, Copy, PartialEq, Eq)]
        pub struct $name;
        impl Dimension for $name {
            const NAME: &'static str = $words;
            const UNITS: &'static [(&'static str, f64, f64)] = &[$(($unit, $up, $down)),+];
            $(const PARTS: &'static [(&'static str, f64)] = &[$(($part, $sign)),+];)?
            $(const ZEROS: &'static [(&'static str, f64)] = &[$(($scale, $zero)),+];)?
        }
    };
}

dimension!(
    /// Length, in metres.
    Metre, "a length", [
        ("m", 1.0, 1.0), ("km", 1e3, 1.0), ("cm", 1.0, 1e2), ("mm", 1.0, 1e3), ("um", 1.0, 1e6),
        ("nm", 1.0, 1e9), ("pm", 1.0, 1e12), ("angstrom", 1.0, 1e10), ("Å", 1.0, 1e10),
    ]
);
dimension!(
    /// Stress or modulus, in pascals.
    Pascal, "a pressure", [
        ("Pa", 1.0, 1.0), ("kPa", 1e3, 1.0), ("MPa", 1e6, 1.0), ("GPa", 1e9, 1.0), ("TPa", 1e12, 1.0),
        ("mPa", 1.0, 1e3), ("N/m^2", 1.0, 1.0), ("N/mm^2", 1e6, 1.0), ("bar", 1e5, 1.0),
    ]
);
dimension!(
    /// Force, in newtons.
    Newton, "a force", [
        ("N", 1.0, 1.0), ("kN", 1e3, 1.0), ("MN", 1e6, 1.0), ("mN", 1.0, 1e3), ("uN", 1.0, 1e6),
        ("nN", 1.0, 1e9), ("pN", 1.0, 1e12),
    ]
);
dimension!(
    /// Time, in seconds.
    Second, "a time", [
        ("s", 1.0, 1.0), ("ms", 1.0, 1e3), ("us", 1.0, 1e6), ("ns", 1.0, 1e9), ("ps", 1.0, 1e12),
        ("min", 60.0, 1.0), ("h", 3600.0, 1.0), ("d", 86400.0, 1.0),
    ]
);
dimension!(
    /// Energy per area, in joules per square metre; of adhesion w = γ₁ + γ₂ − γ₁₂, with the energies γ₁ and γ₂ of both
    /// surfaces and γ₁₂ of the interface between them (Dupré).
    JoulePerSquareMetre, "a work of adhesion", [
        ("J/m^2", 1.0, 1.0), ("mJ/m^2", 1.0, 1e3), ("uJ/m^2", 1.0, 1e6), ("N/m", 1.0, 1.0), ("mN/m", 1.0, 1e3),
    ],
    sum of [("surface_1", 1.0), ("surface_2", 1.0), ("interface", -1.0)]
);
dimension!(
    /// Tension of a liquid surface, in newtons per metre.
    NewtonPerMetreOfLine, "a surface tension", [
        ("N/m", 1.0, 1.0), ("mN/m", 1.0, 1e3), ("dyn/cm", 1.0, 1e3), ("J/m^2", 1.0, 1.0), ("mJ/m^2", 1.0, 1e3),
    ]
);
dimension!(
    /// Stiffness, in newtons per metre.
    NewtonPerMetre, "a stiffness", [
        ("N/m", 1.0, 1.0), ("kN/m", 1e3, 1.0), ("mN/m", 1.0, 1e3), ("N/mm", 1e3, 1.0), ("nN/nm", 1.0, 1.0), ("pN/nm", 1.0, 1e3),
    ]
);
dimension!(
    /// Velocity, in metres per second.
    MetrePerSecond, "a speed", [
        ("m/s", 1.0, 1.0), ("km/s", 1e3, 1.0), ("cm/s", 1.0, 1e2), ("mm/s", 1.0, 1e3), ("um/s", 1.0, 1e6),
        ("nm/s", 1.0, 1e9), ("km/h", 1.0, 3.6), ("mm/min", 1.0, 6e4), ("um/min", 1.0, 6e7),
    ]
);
dimension!(
    /// Angular velocity, in radians per second.
    RadianPerSecond, "an angular speed", [("rad/s", 1.0, 1.0), ("1/s", 1.0, 1.0), ("krad/s", 1e3, 1.0)]
);
dimension!(
    /// Frequency, in hertz (cycles per second).
    Hertz, "a frequency", [
        ("Hz", 1.0, 1.0), ("mHz", 1.0, 1e3), ("uHz", 1.0, 1e6), ("kHz", 1e3, 1.0), ("MHz", 1e6, 1.0),
        ("GHz", 1e9, 1.0), ("1/s", 1.0, 1.0),
    ]
);
dimension!(
    /// Mass, in kilograms.
    Kilogram, "a mass", [
        ("kg", 1.0, 1.0), ("t", 1e3, 1.0), ("g", 1.0, 1e3), ("mg", 1.0, 1e6), ("ug", 1.0, 1e9),
        ("ng", 1.0, 1e12), ("pg", 1.0, 1e15),
    ]
);
dimension!(
    /// Dynamic viscosity, in pascal seconds.
    PascalSecond, "a viscosity", [
        ("Pa s", 1.0, 1.0), ("mPa s", 1.0, 1e3), ("kPa s", 1e3, 1.0), ("MPa s", 1e6, 1.0), ("GPa s", 1e9, 1.0),
    ]
);
dimension!(
    /// Force per speed of a damper, in newton seconds per metre.
    NewtonSecondPerMetre, "a damping", [
        ("N s/m", 1.0, 1.0), ("kN s/m", 1e3, 1.0), ("mN s/m", 1.0, 1e3), ("uN s/m", 1.0, 1e6), ("N s/mm", 1e3, 1.0),
        ("kg/s", 1.0, 1.0),
    ]
);
dimension!(
    /// Volume per work, in square metres per newton (cubic metres per newton metre).
    SquareMetrePerNewton, "a wear coefficient", [
        ("m^2/N", 1.0, 1.0), ("1/Pa", 1.0, 1.0), ("mm^2/N", 1.0, 1e6), ("um^2/N", 1.0, 1e12), ("mm^3/(N m)", 1.0, 1e9),
        ("mm^3/Nm", 1.0, 1e9), ("um^3/(N m)", 1.0, 1e18), ("um^3/Nm", 1.0, 1e18), ("m^3/(N m)", 1.0, 1.0),
    ]
);
dimension!(
    /// Angle, in radians.
    Radian, "an angle", [
        ("rad", 1.0, 1.0), ("deg", std::f64::consts::PI, 180.0), ("°", std::f64::consts::PI, 180.0), ("mrad", 1.0, 1e3),
    ]
);
dimension!(
    /// Temperature, in kelvins; a difference has no zero and is a number of kelvins.
    Kelvin, "a temperature", [("K", 1.0, 1.0), ("mK", 1.0, 1e3), ("degC", 1.0, 1.0), ("°C", 1.0, 1.0)],
    from [("degC", 273.15), ("°C", 273.15)]
);
dimension!(
    /// Difference of temperatures, in kelvins.
    KelvinApart, "a difference of temperatures", [("K", 1.0, 1.0), ("mK", 1.0, 1e3)]
);
dimension!(
    /// A plain ratio without a unit.
    Unity, "a plain number", [("", 1.0, 1.0), ("1", 1.0, 1.0), ("%", 1.0, 1e2)]
);

macro_rules! range {
    ($(#[$doc:meta])* $name:ident, $right:literal, $value:ident => $holds:expr) => {
        $(#[$doc])*
        #[derive(Debug, Clone, Copy, PartialEq, Eq)]
        pub struct $name;
        impl Domain for $name {
            const RIGHT: &'static str = $right;
            fn holds($value: f64) -> bool {
                $holds
            }
        }
    };
}

range!(/** Any finite number. */ Finite, "a finite number", value => value.is_finite());
range!(/** A finite number above zero. */ AboveZero, "above zero", value => value > 0.0);
range!(/** A finite number, zero or above. */ NotNegative, "zero or above", value => value >= 0.0);
range!(/** Poisson's ratio of a stable isotropic solid. */ PoissonRange, "above -1 and at most 0.5", value => value > -1.0 && value <= 0.5);
range!(/** A relative error one can aim at. */ AccuracyRange, "between 1e-14 and 0.1", value => (1e-14..=0.1).contains(&value));
range!(/** Hurst exponent of a self-affine surface. */ HurstRange, "above 0 and at most 1", value => value > 0.0 && value <= 1.0);
range!(/** Exponent of a modulus that grows with the depth. */ GradingRange, "from 0 to below 1", value => (0.0..1.0).contains(&value));
range!(/** Exponent of a relaxation by a power of time. */ RelaxationRange, "above 0 and below 1", value => value > 0.0 && value < 1.0);
range!(/** Angle of incidence measured from the surface normal. */ IncidenceRange, "from 0 (head-on) to below 90 degrees",
    value => (0.0..std::f64::consts::FRAC_PI_2).contains(&value));

range!(/** Angle between the axis of a cone and its flank. */ HalfAngleRange, "above 0 and below 90 degrees",
    value => value > 0.0 && value < std::f64::consts::FRAC_PI_2);
range!(/** Angle between a liquid and a solid that it wets. */ WettingRange, "from 0 (complete wetting) to below 90 degrees",
    value => (0.0..std::f64::consts::FRAC_PI_2).contains(&value));

/// A checked number of dimension `D` in the range `R`, stored in SI units.
pub struct Quantity<D, R>(f64, PhantomData<(D, R)>);

/// A positive length [m].
pub type Length = Quantity<Metre, AboveZero>;
/// A length of either sign [m], such as an indentation.
pub type Displacement = Quantity<Metre, Finite>;
/// A length that may vanish [m].
pub type Amplitude = Quantity<Metre, NotNegative>;
/// A positive modulus or stress [Pa].
pub type Modulus = Quantity<Pascal, AboveZero>;
/// A modulus or stress that may vanish [Pa].
pub type Stress = Quantity<Pascal, NotNegative>;
/// A force of either sign [N], compression positive.
pub type Force = Quantity<Newton, Finite>;
/// A positive time [s].
pub type Duration = Quantity<Second, AboveZero>;
/// Work of adhesion [J/m²]: the energy to part a unit of area.
pub type WorkOfAdhesion = Quantity<JoulePerSquareMetre, NotNegative>;
/// A positive tension of a liquid surface [N/m].
pub type SurfaceTension = Quantity<NewtonPerMetreOfLine, AboveZero>;
/// A positive stiffness of a spring [N/m].
pub type SpringStiffness = Quantity<NewtonPerMetre, AboveZero>;
/// A stiffness that may vanish [N/m].
pub type Stiffness = Quantity<NewtonPerMetre, NotNegative>;
/// Force per speed of a damper [N s/m], zero for none.
pub type Damping = Quantity<NewtonSecondPerMetre, NotNegative>;
/// A speed of either sign [m/s].
pub type Velocity = Quantity<MetrePerSecond, Finite>;
/// A positive speed [m/s].
pub type Speed = Quantity<MetrePerSecond, AboveZero>;
/// An angular speed of either sign [rad/s].
pub type Spin = Quantity<RadianPerSecond, Finite>;
/// A positive frequency [Hz].
pub type Frequency = Quantity<Hertz, AboveZero>;
/// A positive mass [kg].
pub type Mass = Quantity<Kilogram, AboveZero>;
/// A viscosity [Pa s], zero for none.
pub type Viscosity = Quantity<PascalSecond, NotNegative>;
/// A positive viscosity of a fluid [Pa s].
pub type FluidViscosity = Quantity<PascalSecond, AboveZero>;
/// Volume worn per path and normal force [m²/N], zero for none.
pub type WearCoefficient = Quantity<SquareMetrePerNewton, NotNegative>;
/// Poisson's ratio.
pub type Poisson = Quantity<Unity, PoissonRange>;
/// A positive plain number.
pub type Positive = Quantity<Unity, AboveZero>;
/// An absolute temperature [K].
pub type Temperature = Quantity<Kelvin, AboveZero>;
/// A positive difference of temperatures [K].
pub type TemperatureDifference = Quantity<KelvinApart, AboveZero>;
/// A plain number, zero or above.
pub type Ratio = Quantity<Unity, NotNegative>;
/// Creepage of a body that rolls, of either sign: the difference of the speeds of both surfaces over that of rolling.
pub type Creepage = Quantity<Unity, Finite>;
/// A relative error to aim at.
pub type Accuracy = Quantity<Unity, AccuracyRange>;
/// Hurst exponent.
pub type Hurst = Quantity<Unity, HurstRange>;
/// Exponent n of E = E₀(z/z₀)ⁿ.
pub type GradingExponent = Quantity<Unity, GradingRange>;
/// Exponent β of G = G₀(t/t₀)^−β.
pub type RelaxationExponent = Quantity<Unity, RelaxationRange>;
/// Angle of incidence [rad] from the surface normal.
pub type IncidenceAngle = Quantity<Radian, IncidenceRange>;
/// Angle [rad] between the axis of a cone and its flank.
pub type HalfAngle = Quantity<Radian, HalfAngleRange>;
/// Contact angle [rad] of a liquid that wets, through the liquid.
pub type ContactAngle = Quantity<Radian, WettingRange>;

impl<D: Dimension, R: Domain> Quantity<D, R> {
    /// A checked quantity from a number in SI units.
    ///
    /// # Errors
    /// The value is not finite or outside the range.
    pub fn new(si: f64) -> Result<Self, QuantityError> {
        Self::checked(si, || shown(si, D::UNITS[0].0))
    }

    /// `given` is how a value that cannot be is named.
    fn checked(si: f64, given: impl FnOnce() -> String) -> Result<Self, QuantityError> {
        if si.is_finite() && R::holds(si) {
            return Ok(Self(si, PhantomData));
        }
        let fault = if si.is_nan() {
            "is not a number"
        } else if si.is_infinite() {
            "is infinite or too large to compute with"
        } else {
            "is out of range"
        };
        Err(QuantityError(format!("{} {fault}: expected {}, {}", given(), D::NAME, R::RIGHT)))
    }
}

impl<D, R> Quantity<D, R> {
    /// The value in SI units.
    #[must_use]
    pub const fn si(self) -> f64 {
        self.0
    }
}

fn shown(si: f64, unit: &str) -> String {
    if unit.is_empty() { format!("{si:?}") } else { format!("{si:?} {unit}") }
}

/// Splits `"10 mm"` into the number and the unit.
fn split(text: &str) -> (&str, &str) {
    let text = text.trim();
    let numeric = |c: char| c.is_ascii_digit() || matches!(c, '.' | '+' | '-' | '_');
    let mut end = 0;
    for (at, c) in text.char_indices() {
        let exponent = matches!(c, 'e' | 'E')
            && end > 0
            && text[at + 1..].starts_with(|n: char| n.is_ascii_digit() || n == '-' || n == '+');
        if !(numeric(c) || exponent) {
            break;
        }
        end = at + c.len_utf8();
    }
    (&text[..end], text[end..].trim())
}

fn same_unit(given: &str, known: &str) -> bool {
    let plain =
        |text: &str| text.replace(['µ', 'μ'], "u").replace('²', "^2").replace('³', "^3").replace(['·', '*'], " ");
    plain(given) == plain(known)
}

impl<D: Dimension, R: Domain> FromStr for Quantity<D, R> {
    type Err = QuantityError;

    fn from_str(text: &str) -> Result<Self, QuantityError> {
        let si_unit = D::UNITS[0].0;
        let known = || D::UNITS.iter().map(|u| u.0).filter(|u| !u.is_empty()).collect::<Vec<_>>().join(", ");
        let (number, unit) = split(text);
        let value: f64 = number.replace('_', "").parse().map_err(|_| {
            QuantityError(format!(
                "\"{text}\" does not start with a number: expected {} such as \"10 {si_unit}\"",
                D::NAME
            ))
        })?;
        let Some(&(known_unit, up, down)) = D::UNITS.iter().find(|u| same_unit(unit, u.0)) else {
            if unit.starts_with(',') {
                let right = text.replacen(',', ".", 1);
                return Err(QuantityError(format!("\"{text}\" has a comma: expected a decimal point, \"{right}\"")));
            }
            let fault = if unit.is_empty() { "has no unit".to_owned() } else { format!("has the unit \"{unit}\"") };
            return Err(QuantityError(format!("\"{text}\" {fault}: expected {} in one of {}", D::NAME, known())));
        };
        let zero = D::ZEROS.iter().find(|zero| zero.0 == known_unit).map_or(0.0, |zero| zero.1);
        Self::checked(value * up / down + zero, || format!("\"{text}\""))
    }
}

/// The SI units of all dimensions; that of a plain number is empty.
pub const SI_UNITS: [&str; 16] = [
    Metre::UNITS[0].0,
    Pascal::UNITS[0].0,
    Newton::UNITS[0].0,
    Second::UNITS[0].0,
    JoulePerSquareMetre::UNITS[0].0,
    NewtonPerMetre::UNITS[0].0,
    MetrePerSecond::UNITS[0].0,
    RadianPerSecond::UNITS[0].0,
    Hertz::UNITS[0].0,
    Kilogram::UNITS[0].0,
    PascalSecond::UNITS[0].0,
    NewtonSecondPerMetre::UNITS[0].0,
    SquareMetrePerNewton::UNITS[0].0,
    Radian::UNITS[0].0,
    Kelvin::UNITS[0].0,
    Unity::UNITS[0].0,
];

/// Size of `unit` in SI units of the dimension `D`, as numerator and denominator; `None` of a unit it does not have.
///
/// ```
/// # use springbed::input::quantity::{Metre, size_of};
/// assert_eq!(size_of::<Metre>("µm"), Some((1.0, 1e6)));
/// assert_eq!(size_of::<Metre>("nN"), None);
/// ```
#[must_use]
pub fn size_of<D: Dimension>(unit: &str) -> Option<(f64, f64)> {
    D::UNITS.iter().find(|known| same_unit(unit, known.0)).map(|&(_, up, down)| (up, down))
}

struct QuantityVisitor<D, R>(PhantomData<(D, R)>);

/// The sum of named parts, each given like a quantity of its own, zero or above.
fn sum_of_parts<'de, D: Dimension, A: de::MapAccess<'de>>(mut map: A) -> Result<f64, A::Error> {
    let mut given = vec![None; D::PARTS.len()];
    while let Some(name) = map.next_key::<String>()? {
        let Some(at) = D::PARTS.iter().position(|part| part.0 == name) else {
            let known: Vec<&str> = D::PARTS.iter().map(|part| part.0).collect();
            return Err(de::Error::custom(format!("there is no part `{name}`: expected {}", known.join(", "))));
        };
        given[at] = Some(map.next_value::<Quantity<D, NotNegative>>()?.si());
    }
    let last = D::PARTS.len() - 1;
    let parts = D::PARTS.iter().zip(given).enumerate();
    let signed = parts.map(|(at, ((name, sign), value))| match value {
        Some(value) => Ok(sign * value),
        None if at == last => Ok(0.0),
        None => Err(de::Error::missing_field(name)),
    });
    signed.sum()
}

impl<'de, D: Dimension, R: Domain> de::Visitor<'de> for QuantityVisitor<D, R> {
    type Value = Quantity<D, R>;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let unit = D::UNITS[0].0;
        if unit.is_empty() {
            return write!(f, "{}", D::NAME);
        }
        write!(f, "{} (a number in {unit} or text with a unit such as \"10 {unit}\")", D::NAME)
    }

    fn visit_f64<E: de::Error>(self, value: f64) -> Result<Self::Value, E> {
        Quantity::new(value).map_err(E::custom)
    }

    #[expect(clippy::cast_precision_loss, reason = "a whole number above 2^53 in a scene is a rounded number anyway")]
    fn visit_i64<E: de::Error>(self, value: i64) -> Result<Self::Value, E> {
        self.visit_f64(value as f64)
    }

    #[expect(clippy::cast_precision_loss, reason = "a whole number above 2^53 in a scene is a rounded number anyway")]
    fn visit_u64<E: de::Error>(self, value: u64) -> Result<Self::Value, E> {
        self.visit_f64(value as f64)
    }

    fn visit_str<E: de::Error>(self, text: &str) -> Result<Self::Value, E> {
        text.parse().map_err(E::custom)
    }

    fn visit_map<A: de::MapAccess<'de>>(self, map: A) -> Result<Self::Value, A::Error> {
        if D::PARTS.is_empty() {
            return Err(de::Error::invalid_type(de::Unexpected::Map, &self));
        }
        Quantity::new(sum_of_parts::<D, A>(map)?).map_err(de::Error::custom)
    }
}

impl<'de, D: Dimension, R: Domain> Deserialize<'de> for Quantity<D, R> {
    fn deserialize<T: Deserializer<'de>>(deserializer: T) -> Result<Self, T::Error> {
        deserializer.deserialize_any(QuantityVisitor(PhantomData))
    }
}

impl<D, R> Serialize for Quantity<D, R> {
    fn serialize<T: Serializer>(&self, serializer: T) -> Result<T::Ok, T::Error> {
        serializer.serialize_f64(self.0)
    }
}

impl<D, R> Clone for Quantity<D, R> {
    fn clone(&self) -> Self {
        *self
    }
}

impl<D, R> Copy for Quantity<D, R> {}

impl<D, R> Default for Quantity<D, R>
where
    Quantity<D, R>: ZeroIsRight,
{
    fn default() -> Self {
        Self(0.0, PhantomData)
    }
}

/// Quantities that may be zero and are zero when a scene leaves them out.
pub trait ZeroIsRight {}
impl<D> ZeroIsRight for Quantity<D, NotNegative> {}

impl<D, R> fmt::Debug for Quantity<D, R> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{:?}", self.0)
    }
}

impl<D, R> PartialEq for Quantity<D, R> {
    fn eq(&self, other: &Self) -> bool {
        self.0 == other.0
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn units_divide_so_that_decimal_values_are_the_nearest_number() {
        assert_eq!("10 mm".parse::<Length>().unwrap(), Length::new(0.01).unwrap());
        assert_eq!("0.3 um".parse::<Length>().unwrap(), Length::new(3e-7).unwrap());
        assert_eq!("1e-3 µm".parse::<Length>().unwrap(), Length::new(1e-9).unwrap());
        assert_eq!("50 mJ/m²".parse::<WorkOfAdhesion>().unwrap(), WorkOfAdhesion::new(0.05).unwrap());
        assert_eq!("2e3Pa".parse::<Modulus>().unwrap(), Modulus::new(2e3).unwrap());
    }

    #[test]
    fn a_refusal_says_what_it_was_and_what_would_be_right() {
        let text = |r: Result<Length, QuantityError>| r.unwrap_err().to_string();
        assert!(text("10".parse()).contains("has no unit: expected a length in one of m, km"));
        assert!(text("10 MPa".parse()).contains("has the unit \"MPa\": expected a length"));
        assert!(text("-1 mm".parse()).contains("\"-1 mm\" is out of range: expected a length, above zero"));
        assert!(text("1,5 mm".parse()).contains("has a comma: expected a decimal point, \"1.5 mm\""));
        assert!(text("ten mm".parse()).contains("does not start with a number"));
        assert!(text(Length::new(f64::NAN)).contains("is not a number"));
        assert!(text("1e400 m".parse()).contains("is infinite"));
    }
}
