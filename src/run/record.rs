//! What a simulation gives back: records, fields, named results. No clock, no path, no thread count.

use crate::contact::state::Normal;
use crate::contact::stress::StressRow;
use crate::drive::impact::Rebound;
use crate::friction::oblique;
use crate::friction::state::Tangential;
use crate::scene::plan::Plan;
use crate::shape::rough::Scatter;
use serde::Serialize;

/// State of the contact at one time.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Record {
    /// Number of the history entry it belongs to.
    pub entry: usize,
    /// Time [s].
    pub time: f64,
    /// State of the normal contact.
    pub normal: Normal,
    /// State of the tangential contact, if the scene has friction.
    pub tangential: Option<Tangential>,
}

/// Pressure and surface displacement over the radius, at one time.
#[derive(Debug, Clone, PartialEq)]
pub struct Field {
    /// What the field belongs to, such as "end of entry 1".
    pub label: String,
    /// Time [s].
    pub time: f64,
    /// Contact radius [m].
    pub contact_radius: f64,
    /// Stress intensity K_I at the edge [Pa √m], if the edge is singular.
    pub stress_intensity: Option<f64>,
    /// Rows of the field, from the axis outwards.
    pub rows: Vec<FieldRow>,
}

/// One radius of a [`Field`].
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FieldRow {
    /// Radius r [m].
    pub radius: f64,
    /// Pressure p(r) [Pa], `None` where it is singular.
    pub pressure: Option<f64>,
    /// Surface displacement u_z(r) [m].
    pub displacement: Option<f64>,
    /// Shear stress τ(r) [Pa], if the scene has friction; `None` where it is singular.
    pub shear: Option<f64>,
}

/// Energy lost to friction at one position, gathered over the whole history.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FrettingRow {
    /// Distance from the axis [m]: of a spring x, and of the surface r.
    pub position: f64,
    /// Energy per length over x lost by the springs of both halves of the bed [J/m].
    pub per_length: f64,
    /// Energy per area lost at the surface [J/m²]; wear is proportional to it.
    pub per_area: f64,
}

/// A named number or answer.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
#[serde(untagged)]
pub enum Value {
    /// A number in the SI unit its name ends with.
    Number(f64),
    /// A yes or no.
    Answer(bool),
    /// A count.
    Count(usize),
}

/// Estimate of the relative error of forces and radii, and how it was made.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct ErrorEstimate {
    /// Relative to the largest force and radius of the scene.
    pub relative: f64,
    /// How it was made.
    pub basis: String,
}

/// One impact of a scene.
#[derive(Debug, Clone, PartialEq)]
pub struct ImpactRow {
    /// Speed before [m/s], along the path.
    pub speed: f64,
    /// What comes of the normal motion.
    pub rebound: Rebound,
    /// Largest pressure [Pa], if there is a finite one.
    pub peak_pressure: Option<f64>,
    /// What comes of the tangential motion, if it is oblique.
    pub oblique: Option<oblique::BallRebound>,
}

impl ImpactRow {
    /// Speed of the centre after the impact [m/s]; zero if the bodies stay together.
    #[must_use]
    pub fn rebound_speed(&self) -> f64 {
        match &self.oblique {
            None => self.rebound.restitution * self.speed,
            Some(oblique) => oblique.flight.normal_speed.hypot(oblique.flight.tangential_speed),
        }
    }
}

/// An oblique impact at one angle of incidence.
#[derive(Debug, Clone, PartialEq)]
pub struct Incidence {
    /// Angle of incidence from the normal [rad].
    pub angle: f64,
    /// What comes of it.
    pub rebound: oblique::BallRebound,
}

/// The impacts of a scene.
#[derive(Debug, Clone, PartialEq)]
pub struct Impacts {
    /// One per speed, in the order given.
    pub rows: Vec<ImpactRow>,
    /// The greatest speed at other angles of incidence; empty unless the scene's own is oblique.
    pub incidence: Vec<Incidence>,
}

/// What came out of a scene.
#[derive(Debug, Clone, PartialEq)]
pub struct Outcome {
    /// Records in order of time.
    pub records: Vec<Record>,
    /// Pressure and surface, at the end of each entry and at the largest depth; empty if not asked for.
    pub fields: Vec<Field>,
    /// Stresses on the axis at the largest force; empty if not asked for.
    pub stresses: Vec<StressRow>,
    /// Where friction took its energy, from the axis outwards; empty if not asked for or not a matter
    /// of the scene.
    pub fretting: Vec<FrettingRow>,
    /// Named results in a fixed order.
    pub results: Vec<(&'static str, Value)>,
    /// Estimate of the error.
    pub error_estimate: ErrorEstimate,
    /// Physics a user must know.
    pub warnings: Vec<String>,
    /// What was used.
    pub plan: Plan,
    /// Impacts one by one, if the scene is one.
    pub impacts: Option<Impacts>,
    /// Scatter over the members of an ensemble; the records are their means.
    pub ensemble: Option<Ensemble>,
}

/// Mean and scatter over many random surfaces.
#[derive(Debug, Clone, PartialEq)]
pub struct Ensemble {
    /// Number of members.
    pub members: usize,
    /// One row per record.
    pub rows: Vec<EnsembleRow>,
}

/// One record of an [`Ensemble`].
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct EnsembleRow {
    /// Mean time [s].
    pub time: f64,
    /// Indentation d [m].
    pub indentation: Scatter,
    /// Normal force F [N].
    pub force: Scatter,
    /// Stiffness dF/dd [N/m].
    pub stiffness: Scatter,
}

impl Outcome {
    /// The number with this name, if the scene has it.
    #[must_use]
    pub fn number(&self, name: &str) -> Option<f64> {
        self.results.iter().find(|entry| entry.0 == name).and_then(|entry| match entry.1 {
            Value::Number(number) => Some(number),
            _ => None,
        })
    }
}
