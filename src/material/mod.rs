//! Bodies, their materials and the effective moduli of a pair.
//!
//! # Examples
//! ```
//! use springbed::material::{Relaxation, Spectrum};
//!
//! // 1 MPa + 9 MPa·exp(−t/0.1 s): E*(0) = 10 MPa, and loss and storage at ω = 1/τ.
//! let rubber = Relaxation { equilibrium: 1e6, terms: vec![(9e6, 0.1)], viscosity: 0.0 };
//! let spectrum = Spectrum::new(&rubber);
//! assert_eq!(rubber.instantaneous(), 1e7);
//! assert!((spectrum.storage(10.0) / 5.5e6 - 1.0).abs() < 1e-14 && (spectrum.loss(10.0) / 4.5e6 - 1.0).abs() < 1e-14);
//! ```

mod layered;
mod power_law;
mod secular;
mod shares;
mod shear;
mod shift;
mod spectrum;

pub use layered::{Graded, Joint, Layer, Layered, Sheet, Stack, Under, Winkler};
pub use power_law::{PowerLaw, Series, Times};
pub use shares::Shares;
pub use shift::{Shift, ShiftError, Wlf};
pub use spectrum::Element;
pub use spectrum::{Mode, Spectrum};

use crate::input::problem::Problem;
use crate::input::quantity::{Duration, Modulus, Poisson, QuantityError, Stress, Temperature, Viscosity};
use crate::input::table::{TableError, Tables};
use serde::ser::SerializeStruct;
use serde::{Deserialize, Deserializer, Serialize, Serializer, de};
use std::{
    fmt,
    path::{Path, PathBuf},
};

/// One of the two bodies.
#[derive(Debug, Clone, PartialEq, Deserialize, Serialize)]
pub enum Body {
    /// Cannot deform.
    Rigid,
    /// Isotropic, linearly elastic half-space.
    Elastic(Elastic),
    /// Isotropic, linearly viscoelastic half-space.
    Viscoelastic(Viscoelastic),
    /// Layers on a base.
    Layered(Layered),
    /// A thin sheet of independent springs.
    Winkler(Winkler),
    /// A half-space whose modulus is a power of the depth.
    Graded(Graded),
    /// Isotropic, linearly elastic until it yields, then perfectly plastic.
    Plastic(Plastic),
}

impl Body {
    /// What it is called in a scene.
    #[must_use]
    pub fn name(&self) -> &'static str {
        match self {
            Self::Rigid => "Rigid",
            Self::Elastic(_) => "Elastic",
            Self::Viscoelastic(_) => "Viscoelastic",
            Self::Plastic(_) => "Plastic",
            Self::Layered(_) => "Layered",
            Self::Winkler(_) => "Winkler",
            Self::Graded(_) => "Graded",
        }
    }

    /// Poisson's ratio ν where it is the same at all depths; of a rigid body, of layers and of springs none.
    #[must_use]
    pub fn poisson(&self) -> Option<f64> {
        match self {
            Self::Elastic(elastic) => Some(elastic.poisson.si()),
            Self::Viscoelastic(viscoelastic) => Some(viscoelastic.poisson.si()),
            Self::Graded(graded) => Some(graded.poisson.si()),
            Self::Plastic(plastic) => Some(plastic.poisson.si()),
            Self::Rigid | Self::Layered(_) | Self::Winkler(_) => None,
        }
    }

    /// Yield stress Y [Pa] of an elastic body, if it is stated: there the contact is no longer known.
    #[must_use]
    pub fn yield_stress(&self) -> Option<f64> {
        match self {
            Self::Elastic(elastic) => elastic.yield_stress.map(Modulus::si),
            Self::Viscoelastic(_)
            | Self::Rigid
            | Self::Plastic(_)
            | Self::Layered(_)
            | Self::Winkler(_)
            | Self::Graded(_) => None,
        }
    }

    /// Largest pressure [Pa] that a body bears whose yielding is followed.
    #[must_use]
    pub fn hardness(&self) -> Option<f64> {
        match self {
            Self::Plastic(plastic) => Some(plastic.greatest_pressure()),
            Self::Rigid
            | Self::Elastic(_)
            | Self::Viscoelastic(_)
            | Self::Layered(_)
            | Self::Winkler(_)
            | Self::Graded(_) => None,
        }
    }

    /// The power law by which it relaxes, if it does by one.
    #[must_use]
    pub fn power_law(&self) -> Option<&PowerLaw> {
        match self {
            Self::Viscoelastic(body) => body.shear.power_law.as_ref(),
            Self::Layered(body) => {
                body.layers.iter().map(|layer| &layer.body).chain([body.base.as_ref()]).find_map(Self::power_law)
            }
            Self::Rigid | Self::Elastic(_) | Self::Winkler(_) | Self::Graded(_) | Self::Plastic(_) => None,
        }
    }

    /// Whether it relaxes.
    #[must_use]
    pub fn relaxes(&self) -> bool {
        match self {
            Self::Rigid | Self::Elastic(_) | Self::Plastic(_) | Self::Winkler(_) | Self::Graded(_) => false,
            Self::Viscoelastic(_) => true,
            Self::Layered(body) => body.layers.iter().any(|layer| layer.body.relaxes()) || body.base.relaxes(),
        }
    }

    /// Whether its stiffness depends on the depth.
    #[must_use]
    pub fn is_uneven(&self) -> bool {
        match self {
            Self::Rigid | Self::Elastic(_) | Self::Viscoelastic(_) | Self::Plastic(_) => false,
            Self::Layered(_) | Self::Winkler(_) | Self::Graded(_) => true,
        }
    }
}

/// Isotropic, linearly elastic material; a scene gives Young's modulus `young` or the shear modulus `shear`.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Elastic {
    /// Young's modulus E [Pa].
    pub young: Modulus,
    /// Poisson's ratio ν.
    pub poisson: Poisson,
    /// Yield stress in uniaxial tension [Pa]; if given, a contact pressure beyond first yield is a warning.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub yield_stress: Option<Modulus>,
}

impl<'de> Deserialize<'de> for Elastic {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        /// As a scene writes it, with one of two moduli.
        #[derive(Deserialize)]
        #[serde(rename = "Elastic", deny_unknown_fields)]
        struct Written {
            young: Option<Modulus>,
            shear: Option<Modulus>,
            poisson: Poisson,
            yield_stress: Option<Modulus>,
        }
        let Written { young, shear, poisson, yield_stress } = Written::deserialize(deserializer)?;
        let young = match (young, shear) {
            (Some(young), None) => young,
            (None, Some(shear)) => young_of_shear(shear, poisson).map_err(de::Error::custom)?,
            (None, None) => return Err(de::Error::missing_field("young")),
            (Some(_), Some(_)) => {
                return Err(de::Error::custom("an Elastic body has both `young` and `shear`: expected one of the two"));
            }
        };
        Ok(Self { young, poisson, yield_stress })
    }
}

/// E = 2G(1+ν).
fn young_of_shear(shear: Modulus, poisson: Poisson) -> Result<Modulus, QuantityError> {
    Modulus::new(2.0 * shear.si() * (1.0 + poisson.si()))
}

/// Isotropic material, linearly elastic until it yields and perfectly plastic from then on; a scene gives the yield stress
/// or the hardness.
#[derive(Debug, Clone, PartialEq)]
pub struct Plastic {
    /// Young's modulus E [Pa].
    pub young: Modulus,
    /// Poisson's ratio ν.
    pub poisson: Poisson,
    /// What it bears.
    pub limit: PlasticLimit,
}

/// What a body that yields bears.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum PlasticLimit {
    /// Yield stress Y [Pa] in uniaxial tension: it yields under 1.6 Y.
    YieldStress(Modulus),
    /// Largest pressure H [Pa] itself, some 2.8 Y where all of a contact yields (Tabor 1951).
    Hardness(Modulus),
}

impl Serialize for Plastic {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut written = serializer.serialize_struct("Plastic", 3)?;
        written.serialize_field("young", &self.young)?;
        written.serialize_field("poisson", &self.poisson)?;
        match &self.limit {
            PlasticLimit::YieldStress(stress) => written.serialize_field("yield_stress", stress)?,
            PlasticLimit::Hardness(hardness) => written.serialize_field("hardness", hardness)?,
        }
        written.end()
    }
}

impl<'de> Deserialize<'de> for Plastic {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        /// As a scene writes it, with one of two limits.
        #[derive(Deserialize)]
        #[serde(rename = "Plastic", deny_unknown_fields)]
        struct Written {
            young: Modulus,
            poisson: Poisson,
            yield_stress: Option<Modulus>,
            hardness: Option<Modulus>,
        }
        let Written { young, poisson, yield_stress, hardness } = Written::deserialize(deserializer)?;
        let limit = match (yield_stress, hardness) {
            (Some(stress), None) => PlasticLimit::YieldStress(stress),
            (None, Some(hardness)) => PlasticLimit::Hardness(hardness),
            (None, None) => return Err(de::Error::missing_field("yield_stress")),
            (Some(_), Some(_)) => {
                return Err(de::Error::custom(
                    "a Plastic body has both `yield_stress` and `hardness`: expected one of the two",
                ));
            }
        };
        Ok(Self { young, poisson, limit })
    }
}

/// Isotropic, linearly viscoelastic material with a constant Poisson's ratio.
#[derive(Debug, Clone, PartialEq, Deserialize, Serialize)]
#[serde(deny_unknown_fields)]
pub struct Viscoelastic {
    /// Poisson's ratio ν, constant in time.
    pub poisson: Poisson,
    /// Relaxation in shear; with a shift that at its reference temperature.
    pub shear: Shear,
    /// Temperature T [K], with a shift.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub temperature: Option<Temperature>,
    /// How the temperature shifts the times.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub shift: Option<Shift>,
}

/// Relaxation function in shear, G(t) = G∞ + Σ Gᵢ e^(−t/τᵢ) + G₀(t/t₀)^(−β), and a parallel dashpot η.
///
/// A scene writes it `(equilibrium: …, terms: […], viscosity: …)`, or `PowerLaw(modulus: …, exponent: …, time: …)` with the
/// others beside it if there are any.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Shear {
    /// Equilibrium modulus G∞ [Pa]; zero for a liquid.
    pub equilibrium: Stress,
    /// Terms Gᵢ, τᵢ of the Prony series.
    pub terms: Terms,
    /// Viscosity η [Pa s] of a parallel dashpot (Kelvin–Voigt).
    pub viscosity: Viscosity,
    /// Power law G₀, β, t₀.
    pub power_law: Option<PowerLaw>,
}

/// The terms of a Prony series: a list, or a table with columns `time_s,modulus_pa`.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[serde(untagged)]
pub enum Terms {
    /// Terms in the scene.
    List(Vec<Term>),
    /// Terms in a file next to the scene.
    Table(PathBuf),
}

impl Default for Terms {
    fn default() -> Self {
        Self::List(Vec::new())
    }
}

/// One Maxwell element: modulus Gᵢ [Pa] and relaxation time τᵢ [s].
#[derive(Debug, Clone, Copy, PartialEq, Deserialize, Serialize)]
#[serde(deny_unknown_fields)]
pub struct Term {
    /// Modulus Gᵢ [Pa].
    pub modulus: Stress,
    /// Relaxation time τᵢ [s].
    pub time: Duration,
}

struct TermsVisitor;

impl<'de> de::Visitor<'de> for TermsVisitor {
    type Value = Terms;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("a list of terms [(modulus: \"1 MPa\", time: \"1 s\"), …] or the path of a table with columns time_s,modulus_pa")
    }

    fn visit_str<E: de::Error>(self, path: &str) -> Result<Terms, E> {
        Ok(Terms::Table(path.into()))
    }

    fn visit_seq<A: de::SeqAccess<'de>>(self, mut seq: A) -> Result<Terms, A::Error> {
        let mut terms = Vec::new();
        while let Some(term) = seq.next_element()? {
            terms.push(term);
        }
        Ok(Terms::List(terms))
    }
}

impl<'de> Deserialize<'de> for Terms {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        deserializer.deserialize_any(TermsVisitor)
    }
}

/// Relaxation of the effective modulus E*(t) = E∞ + Σ Eᵢ e^(−t/τᵢ), with a parallel dashpot η [Pa s].
///
/// For a viscoelastic half-space against a rigid one, E*(t) = 2G(t)/(1−ν).
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Relaxation {
    /// E∞ [Pa].
    pub equilibrium: f64,
    /// Pairs (Eᵢ [Pa], τᵢ [s]).
    pub terms: Vec<(f64, f64)>,
    /// η [Pa s] of the parallel dashpot, in the scale of E*.
    pub viscosity: f64,
}

impl Relaxation {
    /// E*(0), the instantaneous modulus [Pa] (the dashpot apart).
    #[must_use]
    pub fn instantaneous(&self) -> f64 {
        self.equilibrium + self.terms.iter().map(|term| term.0).sum::<f64>()
    }
}

/// Effective moduli of a pair of bodies.
///
/// 1/E* = (1−ν₁²)/E₁ + (1−ν₂²)/E₂ and 1/G* = (2−ν₁)/(4G₁) + (2−ν₂)/(4G₂), where a rigid body adds
/// nothing (Popov, Contact Mechanics and Friction, eqs. 5.26 and 8.22). Of a viscoelastic body the instantaneous moduli are meant,
/// of one that is a dashpot alone its viscosities [Pa s] in their place;
/// with a constant ν the ratio G*/E* = 2(1−ν)/(2−ν) holds at all times.
/// Check: E = 210 GPa, ν = 0.3 on a rigid body gives E* = 230.77 GPa and G* = 190.05 GPa.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Pair {
    /// E* [Pa], above zero.
    pub normal: f64,
    /// G* [Pa], above zero.
    pub tangential: f64,
    /// Dundurs' β = ½ [(1−2ν₁)/G₁ − (1−2ν₂)/G₂] / [(1−ν₁)/G₁ + (1−ν₂)/G₂] (Johnson 1985,
    /// eq. 5.3): normal and tangential contact are independent where it vanishes.
    pub coupling: f64,
}

impl Pair {
    /// The same pair in plane strain: a line load moves the surface along itself by the same law whether it presses or
    /// shears, G* = E* (Johnson 1985, eq. 2.25).
    #[must_use]
    pub fn long_across(self) -> Self {
        Self { tangential: self.normal, ..self }
    }
}

/// Moduli of one body against a rigid one; infinite for a rigid body.
struct Stiffness {
    normal: f64,
    tangential: f64,
    /// (1−2ν)/(2(1−ν)), β against a rigid body.
    coupling: f64,
}

impl Stiffness {
    const RIGID: Self = Self { normal: f64::INFINITY, tangential: f64::INFINITY, coupling: 0.0 };

    fn new(normal: f64, poisson: f64) -> Self {
        let tangential = normal * 2.0 * (1.0 - poisson) / (2.0 - poisson);
        Self { normal, tangential, coupling: (0.5 - poisson) / (1.0 - poisson) }
    }
}

impl Elastic {
    /// E/(1−ν²) [Pa], the modulus against a rigid body.
    #[must_use]
    pub fn plane_modulus(&self) -> f64 {
        self.stiffness().normal
    }

    fn stiffness(&self) -> Stiffness {
        let poisson = self.poisson.si();
        Stiffness::new(self.young.si() / ((1.0 - poisson) * (1.0 + poisson)), poisson)
    }
}

/// Limiting pressure over yield stress: that of first yield below a ball of ν ≈ 0.3 (Johnson 1985, §6.1).
pub const YIELD_PRESSURE: f64 = 1.6;

impl Plastic {
    /// Largest pressure [Pa].
    #[must_use]
    pub fn greatest_pressure(&self) -> f64 {
        match self.limit {
            PlasticLimit::YieldStress(stress) => YIELD_PRESSURE * stress.si(),
            PlasticLimit::Hardness(hardness) => hardness.si(),
        }
    }

    /// As it is before it yields.
    fn elastic(&self) -> Elastic {
        Elastic { young: self.young, poisson: self.poisson, yield_stress: None }
    }
}

impl Viscoelastic {
    /// E*(t) = 2G(t)/(1−ν) against a rigid body (Popov & Heß 2015, eq. 7.9), terms in the order given; a power law, which
    /// stands for nothing without `times`, as its series between them.
    ///
    /// # Errors
    /// The table of terms cannot be read or holds a term that makes no sense.
    pub fn relaxation(&self, tables: &dyn Tables, times: Option<Times>) -> Result<Relaxation, TableError> {
        let scale = 2.0 / (1.0 - self.poisson.si());
        let terms = match &self.shear.terms {
            Terms::List(terms) => terms.iter().map(|term| (term.modulus.si(), term.time.si())).collect(),
            Terms::Table(path) => terms_of_table(path, tables)?,
        };
        let shift = self.shift.as_ref().zip(self.temperature);
        let shifted = shift.and_then(|(shift, temperature)| shift.factor(temperature.si(), tables).ok()).unwrap_or(1.0);
        let series = self.shear.power_law.zip(times).map(|(law, times)| law.series(times.at_reference(shifted)));
        let (beyond, series) = series.map_or((0.0, Vec::new()), |series| (series.equilibrium, series.terms));
        Ok(Relaxation {
            equilibrium: scale * (self.shear.equilibrium.si() + beyond),
            terms: terms.into_iter().chain(series).map(|(modulus, time)| (scale * modulus, shifted * time)).collect(),
            viscosity: shifted * (scale * self.shear.viscosity.si()),
        })
    }
}

fn terms_of_table(path: &Path, tables: &dyn Tables) -> Result<Vec<(f64, f64)>, TableError> {
    let columns = tables.columns(path, &["time_s", "modulus_pa"])?;
    let [times, moduli] = &columns.values[..] else {
        return Err(TableError::whole(path, "expected the columns time_s,modulus_pa"));
    };
    if times.is_empty() {
        return Err(TableError::whole(path, "has no rows: expected at least one term of the Prony series"));
    }
    for ((&time, &modulus), &row) in times.iter().zip(moduli).zip(&columns.rows) {
        Duration::new(time).map_err(|error| TableError::at(path, row, format!("time_s: {error}")))?;
        Stress::new(modulus).map_err(|error| TableError::at(path, row, format!("modulus_pa: {error}")))?;
    }
    Ok(moduli.iter().copied().zip(times.iter().copied()).collect())
}

/// Two bodies that are pressed together.
#[derive(Debug, Clone, PartialEq)]
pub struct Joined {
    /// Effective moduli; instantaneous ones of a viscoelastic pair.
    pub pair: Pair,
    /// E*(t) if one of the bodies is viscoelastic.
    pub relaxation: Option<Relaxation>,
    /// What lies below the surfaces.
    pub under: Under,
}

/// One of two bodies, alone against a rigid one.
struct Alone {
    /// Its moduli at once.
    stiffness: Stiffness,
    /// What it relaxes by, if it gives at all.
    spectrum: Option<Spectrum>,
    /// What lies below its surface.
    under: Under,
}

/// What `bodies` are together; `None` for two rigid ones, which make no pair.
///
/// Each half-space is pressed in by its own 1/E*ᵢ(p) times the same pressure, whatever its ν: the sum is
/// exact for constant ν, in the normal direction and without friction.
///
/// A power law is known between `times`; `None` too where there is one, and no times.
///
/// # Errors
/// A table of terms is wrong, or a body has no modulus; all problems at once.
pub fn joined(
    bodies: &(Body, Body),
    tables: &dyn Tables,
    times: Option<Times>,
) -> Result<Option<Joined>, Vec<Problem>> {
    let known = Known { tables, times };
    let (one, two) = (alone(&bodies.0, "bodies.0", known), alone(&bodies.1, "bodies.1", known));
    let (one, two) = match (one, two) {
        (Ok(one), Ok(two)) => (one, two),
        (one, two) => return Err(one.err().into_iter().chain(two.err()).flatten().collect()),
    };
    if times.is_none() && [&bodies.0, &bodies.1].into_iter().any(|body| body.power_law().is_some()) {
        return Ok(None);
    }
    let pair = Pair::of(&one.stiffness, &two.stiffness);
    let (shares, _) = in_series(one.stiffness.normal, two.stiffness.normal);
    let under = Under::both(one.under, two.under, shares);
    let both = match (one.spectrum, two.spectrum) {
        (None, None) => return Ok(None),
        (Some(spectrum), None) | (None, Some(spectrum)) => spectrum,
        (Some(one), Some(two)) => one.in_series_with(&two),
    };
    if !bodies.0.relaxes() && !bodies.1.relaxes() {
        return Ok(Some(Joined { pair, relaxation: None, under }));
    }
    Ok(Some(Joined {
        pair: pair.as_stiff_as(both.instantaneous()),
        relaxation: Some(both.relaxation_function()),
        under,
    }))
}

/// What is known beside a body itself.
#[derive(Clone, Copy)]
struct Known<'k> {
    tables: &'k dyn Tables,
    times: Option<Times>,
}

fn alone(body: &Body, path: &str, known: Known<'_>) -> Result<Alone, Vec<Problem>> {
    let under = Under::HalfSpaces;
    Ok(match body {
        Body::Rigid => Alone { stiffness: Stiffness::RIGID, spectrum: None, under },
        Body::Elastic(body) => elastic(body),
        Body::Plastic(body) => elastic(&body.elastic()),
        Body::Viscoelastic(body) => {
            let relaxation = instantly_stiff(body, path, known).map_err(|problem| vec![problem])?;
            let modulus = relaxation.instantaneous();
            let at_once = if modulus > 0.0 { modulus } else { relaxation.viscosity };
            let stiffness = Stiffness::new(at_once, body.poisson.si());
            Alone { stiffness, spectrum: Some(Spectrum::new(&relaxation)), under }
        }
        Body::Layered(body) => layered::layered(body, path, known)?,
        Body::Winkler(body) => layered::winkler(body),
        Body::Graded(body) => layered::graded(body),
    })
}

fn elastic(body: &Elastic) -> Alone {
    let spectrum = Some(Spectrum::elastic(body.plane_modulus()));
    Alone { stiffness: body.stiffness(), spectrum, under: Under::HalfSpaces }
}

/// E*(t) against a rigid body, above zero at once, or with a dashpot alone.
fn instantly_stiff(body: &Viscoelastic, path: &str, known: Known<'_>) -> Result<Relaxation, Problem> {
    if let Some(problem) = badly_shifted(body, path, known.tables) {
        return Err(problem);
    }
    let relaxation = body
        .relaxation(known.tables, known.times)
        .map_err(|error| Problem::new(format!("{path}.shear.terms"), error.to_string()))?;
    if relaxation.instantaneous() > 0.0 || relaxation.viscosity > 0.0 || body.shear.power_law.is_some() {
        return Ok(relaxation);
    }
    let message = "has no modulus above zero: expected an equilibrium modulus, at least one term or a viscosity";
    Err(Problem::new(format!("{path}.shear"), message))
}

/// A temperature without a shift, a shift without a temperature, or one where the law has no value.
fn badly_shifted(body: &Viscoelastic, path: &str, tables: &dyn Tables) -> Option<Problem> {
    match (body.temperature, &body.shift) {
        (None, None) => None,
        (Some(_), None) => Some(Problem::new(
            format!("{path}.temperature"),
            "without a shift it changes nothing: expected shift: Wlf(c1: …, c2: …, reference: …) beside it, or no temperature",
        )),
        (None, Some(_)) => Some(Problem::new(
            format!("{path}.shift"),
            "lacks the temperature to which it shifts: expected temperature: \"20 degC\" or the like, or no shift",
        )),
        (Some(temperature), Some(shift)) => {
            let place = |error: &ShiftError| match error {
                ShiftError::Cold { .. } | ShiftError::Outside { .. } => "temperature",
                ShiftError::Table(_) => "shift",
            };
            let error = shift.factor(temperature.si(), tables).err()?;
            Some(Problem::new(format!("{path}.{}", place(&error)), error.to_string()))
        }
    }
}

impl Pair {
    fn of(one: &Stiffness, two: &Stiffness) -> Self {
        let (shares, normal) = in_series(one.normal, two.normal);
        let (_, tangential) = in_series(one.tangential, two.tangential);
        Self { normal, tangential, coupling: shares.0 * one.coupling - shares.1 * two.coupling }
    }

    /// The same with E* = `normal` [Pa], if it is above zero, and G* in its ratio to it.
    fn as_stiff_as(self, normal: f64) -> Self {
        if normal > 0.0 { Self { normal, tangential: normal * (self.tangential / self.normal), ..self } } else { self }
    }
}

/// The shares of two springs in the compliance of both in series, and their stiffness; one of them is finite.
fn in_series(one: f64, two: f64) -> ((f64, f64), f64) {
    if one <= two {
        let ratio = one / two;
        ((1.0 / (1.0 + ratio), ratio / (1.0 + ratio)), one / (1.0 + ratio))
    } else {
        let ((second, first), together) = in_series(two, one);
        ((first, second), together)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::input::table::InMemory;
    use proptest::prelude::*;

    fn elastic(young: f64, poisson: f64) -> Body {
        let (young, poisson) = (Modulus::new(young).unwrap(), Poisson::new(poisson).unwrap());
        Body::Elastic(Elastic { young, poisson, yield_stress: None })
    }

    fn of(one: Body, two: Body) -> Pair {
        joined(&(one, two), &InMemory::default(), None).unwrap().unwrap().pair
    }

    fn rubber(terms: Terms) -> Body {
        let shear =
            Shear { equilibrium: Stress::new(0.1).unwrap(), terms, viscosity: Viscosity::default(), power_law: None };
        Body::Viscoelastic(Viscoelastic { poisson: Poisson::new(0.5).unwrap(), shear, temperature: None, shift: None })
    }

    /// Bound: a handful of roundings.
    fn near(value: f64, right: f64) -> bool {
        (value - right).abs() <= 8.0 * f64::EPSILON * right.abs()
    }

    #[test]
    fn steel_on_a_rigid_body() {
        let steel = of(elastic(210e9, 0.3), Body::Rigid);
        assert!(near(steel.normal, 210e9 / 0.91) && near(steel.tangential, 210e9 / 0.91 * 1.4 / 1.7));
        assert!(near(steel.coupling, 0.2 / 0.7));
    }

    #[test]
    fn a_viscoelastic_body_relaxes_from_its_instantaneous_modulus() {
        let term = Term { modulus: Stress::new(0.9).unwrap(), time: Duration::new(0.2).unwrap() };
        let bodies = (Body::Rigid, rubber(Terms::List(vec![term])));
        let Joined { pair, relaxation, .. } = joined(&bodies, &InMemory::default(), None).unwrap().unwrap();
        let relaxation = relaxation.unwrap();
        assert!(near(pair.normal, 4.0) && near(relaxation.equilibrium, 0.4));
        assert_eq!(relaxation.terms, [(3.6, 0.2)]);
        assert!(near(pair.tangential / pair.normal, 2.0 / 3.0), "an incompressible body: α = 2(1−ν)/(2−ν)");
    }

    #[test]
    fn a_wrong_table_of_terms_names_its_row() {
        let tables = InMemory::default().with("p.csv", &[("time_s", &[1.0, 0.0]), ("modulus_pa", &[1.0, 1.0])]);
        let bodies = (rubber(Terms::Table("p.csv".into())), Body::Rigid);
        let problems = joined(&bodies, &tables, None).unwrap_err();
        assert_eq!(problems[0].path, "bodies.0.shear.terms");
        assert!(problems[0].message.starts_with("p.csv, row 3: time_s: 0.0 s is out of range"), "{}", problems[0]);
    }

    #[test]
    fn bodies_that_make_no_pair() {
        assert_eq!(joined(&(Body::Rigid, Body::Rigid), &InMemory::default(), None).unwrap(), None);
    }

    proptest! {
        /// Order does not matter, compliances add, and nothing overflows over 600 decades.
        #[test]
        fn compliances_add(k in -300i32..300, j in -300i32..300, n in -9i32..=5, m in -9i32..=5) {
            let (one, two) = (10f64.powi(k), 10f64.powi(j));
            let (first, second) = (elastic(one, 0.1 * f64::from(n)), elastic(two, 0.1 * f64::from(m)));
            let (ab, ba) = (of(first.clone(), second.clone()), of(second.clone(), first.clone()));
            prop_assert_eq!(ab.normal.to_bits(), ba.normal.to_bits());
            prop_assert_eq!(ab.tangential.to_bits(), ba.tangential.to_bits());
            let (a, b) = (of(first, Body::Rigid), of(second, Body::Rigid));
            let (soft, stiff) = if a.normal < b.normal { (a.normal, b.normal) } else { (b.normal, a.normal) };
            prop_assert!(near(ab.normal * (1.0 + soft / stiff), soft));
            prop_assert!(near((ab.coupling + ba.coupling) + 1.0, 1.0) && ab.coupling.abs() <= 0.75);
        }
    }
}
