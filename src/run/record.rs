//! What a simulation gives back: records, fields, tables, named results. No clock, no path, no thread count.
//!
//! # Examples
//! ```
//! # #[cfg(feature = "text")] {
//! use springbed::prelude::*;
//! use springbed::run::record::FORCE;
//!
//! let text = r#"(shape: Paraboloid(radius: 1), bodies: (Elastic(young: 1, poisson: 0), Rigid),
//!     history: [Indent(to: 1, over: 1)])"#;
//! let plan = Notation::Ron.plan(text, &InMemory::default()).map_err(|errors| errors[0].clone())?;
//! let outcome = run(&plan, Wanted::NOTHING)?;
//! let last = outcome.records.last().unwrap();
//! assert!(((FORCE.of)(last).unwrap() - 4.0 / 3.0).abs() < 1e-14);
//! assert!(outcome.record_table().column("force").is_some());
//! # }
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

use super::named::{Finding, Named};
use super::table::{Column, Table};
use super::unit::Unit;
use crate::contact::state::Gliding;
use crate::contact::state::Joined;
use crate::contact::state::Normal;
use crate::contact::state::Tangential;
use crate::drive::machine::RatedState;
use crate::scene::parts::Parts;
use crate::shape::Boundary;
use crate::wear::Worn;
use ndarray::Array2;
use serde::Serialize;
use std::f64::consts::PI;

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
    /// Where a contact that glides or rolls over a bed with memory is, and what holds it back.
    pub gliding: Option<Gliding>,
    /// What has been worn off, if the scene has wear.
    pub worn: Option<Worn>,
    /// The real contact, where it is computed on pixels.
    pub pixels: Option<PixelContact>,
    /// What is joined, of a pad.
    pub joined: Option<Joined>,
    /// The machine, while it moves the contact.
    pub machine: Option<MachineState>,
    /// Where the far end of the spring is by which the contact is led [m], and its energy [J].
    pub spring: Option<(f64, f64)>,
}

/// A machine at one time: forces, and what has become of the energy.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct MachineState {
    /// Speed of the mass [m/s].
    pub speed: f64,
    /// Where the far end of the tangential spring has gone [m], of a contact that is drawn along.
    pub drawn: Option<f64>,
    /// Force of the spring and the weight on the mass [N].
    pub spring_force: f64,
    /// Kinetic energy [J].
    pub kinetic: f64,
    /// Energy of the spring [J].
    pub spring: f64,
    /// Energy [J] stored in the tangential deformation of the contact.
    pub sheared: Option<f64>,
    /// Rate and state of the contact, if its friction has them.
    pub rated: Option<RatedState>,
    /// Work done from outside so far, by the far end of the spring or the weight; before the machine, what led the
    /// contact there [J].
    pub work: f64,
    /// Energy lost in the damper so far [J].
    pub damped: f64,
}

impl Record {
    /// Way along the surface [m], if the scene has one.
    fn slide(&self) -> Option<f64> {
        self.tangential.map(|state| state.slide).or(self.gliding.map(|state| state.slide))
    }

    /// Area that sticks on pixels \[m²\], if there is friction.
    #[must_use]
    pub fn stick_area(&self) -> Option<f64> {
        self.pixels.and(self.tangential).map(|state| PI * state.stick_radius.powi(2))
    }

    /// Force against the motion along the surface [N], if the scene has one.
    #[must_use]
    pub fn tangential_force(&self) -> Option<f64> {
        self.tangential.map(|state| state.force).or(self.gliding.map(|state| state.resistance))
    }
}

/// The real contact of a state that is computed on pixels.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PixelContact {
    /// Area of contact [m²]: the pixels under pressure less what counting whole ones adds along the edges.
    pub area: f64,
    /// The same over the area of the window.
    pub area_fraction: f64,
    /// Mean distance of the surfaces [m]; `None` of a tip, where it is a matter of the window.
    pub mean_gap: Option<f64>,
    /// Largest pressure [Pa].
    pub peak_pressure: f64,
    /// Number of patches, joined over the sides of pixels.
    pub patches: usize,
    /// Whether a patch leads from a border to the opposite one, or on for ever.
    pub percolates: bool,
    /// Whether the gap does.
    pub gap_percolates: bool,
    /// Flow of a fluid through the gap per difference of its pressure [m³/(Pa s)], if that is asked for.
    pub leak: Option<f64>,
}

impl PixelContact {
    /// Bodies that do not press on each other.
    pub const APART: Self = Self {
        area: 0.0,
        area_fraction: 0.0,
        mean_gap: None,
        peak_pressure: 0.0,
        patches: 0,
        percolates: false,
        gap_percolates: true,
        leak: None,
    };
}

/// Pressure, gap and shear on pixels: under the largest force, or the largest along the surface where bodies slide.
#[derive(Debug, Clone, PartialEq)]
pub struct ContactMap {
    /// Pressure [Pa], rows along y and columns along x.
    pub pressure: Array2<f64>,
    /// Distance of the surfaces [m], zero in contact; infinite where there is no material.
    pub gap: Array2<f64>,
    /// Shear stress [Pa] along x, if there is friction and it is known.
    pub shear: Option<Array2<f64>>,
    /// Width and height of a pixel [m].
    pub pixel: [f64; 2],
    /// What happens at the edge.
    pub boundary: Boundary,
    /// Normal force [N].
    pub force: f64,
}

/// Time.
pub const TIME: Column<Record> = Column::new("time", Unit::SECOND, "time t", |record| Some(record.time));
/// Indentation.
pub const INDENTATION: Column<Record> =
    Column::new("indentation", Unit::METRE, "indentation d", |record| record.normal.indentation);
/// Normal force.
pub const FORCE: Column<Record> = Column::new("force", Unit::NEWTON, "force F", |record| Some(record.normal.force));
/// Contact radius.
pub const CONTACT_RADIUS: Column<Record> =
    Column::new("contact_radius", Unit::METRE, "contact radius a", |record| record.normal.contact_radius);
/// Stiffness.
pub const STIFFNESS: Column<Record> =
    Column::new("stiffness", Unit::NEWTON_PER_METRE, "stiffness k", |record| Some(record.normal.stiffness));
/// Tangential displacement.
pub const SLIDE: Column<Record> = Column::new("slide", Unit::METRE, "tangential displacement uₓ", Record::slide);
/// Tangential force.
pub const TANGENTIAL_FORCE: Column<Record> =
    Column::new("tangential_force", Unit::NEWTON, "tangential force Fₓ", Record::tangential_force);
/// Radius of the sticking part.
pub const STICK_RADIUS: Column<Record> = Column::new("stick_radius", Unit::METRE, "stick radius c", |record| {
    record.normal.contact_radius.and(Some(record.tangential?.stick_radius))
});
/// Area of a sheared adhesive contact over that at rest.
pub const AREA_RATIO: Column<Record> =
    Column::new("area_ratio", Unit::ONE, "A/A₀", |record| record.tangential?.area_ratio);

/// Where the contact of a moving body begins.
pub const LEADING_EDGE: Column<Record> =
    Column::new("leading_edge", Unit::METRE, "leading edge", |record| record.gliding?.leading_edge);
/// Where it ends.
pub const TRAILING_EDGE: Column<Record> =
    Column::new("trailing_edge", Unit::METRE, "trailing edge", |record| record.gliding?.trailing_edge);
/// Area of contact on pixels, and of the summits of a pad.
pub const AREA: Column<Record> =
    Column::new("area", Unit::SQUARE_METRE, "area of contact A", |record| match record.pixels {
        Some(pixels) => Some(pixels.area),
        None => record.joined?.area,
    });

/// Columns every scene has.
const NORMAL: &[Column<Record>] = &[
    TIME,
    INDENTATION,
    FORCE,
    CONTACT_RADIUS,
    STIFFNESS,
    Column::new("stored", Unit::JOULE, "stored energy", |record| Some(record.normal.stored.stored())),
    Column::new("dissipated", Unit::JOULE, "dissipated energy", |record| Some(record.normal.dissipated)),
];
/// Columns of a scene with friction.
const TANGENTIAL: &[Column<Record>] = &[
    SLIDE,
    TANGENTIAL_FORCE,
    STICK_RADIUS,
    Column::new("friction_dissipated", Unit::JOULE, "energy lost to friction", |record| record.tangential?.dissipated),
];
/// Columns of a sheared adhesive contact.
const SHEARED: &[Column<Record>] = &[AREA_RATIO];

/// Columns of a body that glides or rolls over a bed with memory.
const GLIDING: &[Column<Record>] = &[SLIDE, TANGENTIAL_FORCE, LEADING_EDGE, TRAILING_EDGE];
/// Volume worn off.
pub const WORN_VOLUME: Column<Record> =
    Column::new("worn_volume", Unit::CUBIC_METRE, "worn volume V", |record| Some(record.worn?.volume));
/// Largest depth worn off.
pub const WEAR_DEPTH: Column<Record> =
    Column::new("wear_depth", Unit::METRE, "largest worn depth", |record| Some(record.worn?.depth));
/// Columns of a scene with wear.
const WORN: &[Column<Record>] = &[WORN_VOLUME, WEAR_DEPTH];
/// Speed of the mass of a machine.
pub const SPEED: Column<Record> =
    Column::new("speed", Unit::METRE_PER_SECOND, "speed of the mass", |record| Some(record.machine?.speed));
/// Where the far end of the spring of a machine is.
pub const DRAWN: Column<Record> =
    Column::new("drawn", Unit::METRE, "far end of the spring", |record| record.machine?.drawn);
/// Force of the spring of a machine.
pub const SPRING_FORCE: Column<Record> =
    Column::new("spring_force", Unit::NEWTON, "spring force", |record| Some(record.machine?.spring_force));
/// Columns of a machine.
const MACHINE: &[Column<Record>] = &[
    SPEED,
    SPRING_FORCE,
    Column::new("kinetic", Unit::JOULE, "kinetic energy", |record| Some(record.machine?.kinetic)),
    Column::new("spring", Unit::JOULE, "energy of the spring", |record| Some(record.machine?.spring)),
    Column::new("work", Unit::JOULE, "work from outside", |record| Some(record.machine?.work)),
    Column::new("damped", Unit::JOULE, "energy lost in the damper", |record| Some(record.machine?.damped)),
];
/// Where the far end of the spring is by which a contact is led, d + F/k.
pub const FAR_END: Column<Record> =
    Column::new("far_end", Unit::METRE, "far end of the spring", |record| Some(record.spring?.0));
/// Columns of a contact that is led by a spring.
const LED: &[Column<Record>] =
    &[FAR_END, Column::new("spring", Unit::JOULE, "energy of the spring", |record| Some(record.spring?.1))];
/// Columns of a machine along the surface.
const DRIVEN: &[Column<Record>] =
    &[DRAWN, Column::new("tangential_stored", Unit::JOULE, "energy of the shear", |record| record.machine?.sheared)];
/// Speed of slip of a contact with rate and state.
pub const SLIP_SPEED: Column<Record> =
    Column::new("slip_speed", Unit::METRE_PER_SECOND, "speed of slip V", |record| Some(record.machine?.rated?.speed));
/// Its state.
pub const STATE: Column<Record> =
    Column::new("state", Unit::SECOND, "state θ", |record| Some(record.machine?.rated?.state));
/// Columns of a contact with rate and state.
const RATED: &[Column<Record>] = &[SLIP_SPEED, STATE];
/// Columns of a contact on pixels.
const PIXELS: &[Column<Record>] = &[
    AREA,
    Column::new("area_fraction", Unit::ONE, "share of the area A/A₀", |record| Some(record.pixels?.area_fraction)),
    Column::new("mean_gap", Unit::METRE, "mean gap", |record| record.pixels?.mean_gap),
    Column::new("peak_pressure", Unit::PASCAL, "largest pressure", |record| Some(record.pixels?.peak_pressure)),
    Column::new("contact_patches", Unit::ONE, "patches of contact", |record| count(record.pixels?.patches)),
];

/// What the gap lets through.
pub const LEAK: Column<Record> =
    Column::new("leak_conductance", Unit::CUBIC_METRE_PER_PASCAL_SECOND, "leak conductance Q/Δp", |record| {
        record.pixels?.leak
    });
/// Area that sticks on pixels.
pub const STICK_AREA: Column<Record> =
    Column::new("stick_area", Unit::SQUARE_METRE, "area that sticks", Record::stick_area);
/// Share of the springs or summits of a pad that are joined.
pub const JOINED_SHARE: Column<Record> =
    Column::new("joined_share", Unit::ONE, "share that is joined", |record| Some(record.joined?.share));
/// Columns of a pad.
const JOINED: &[Column<Record>] = &[JOINED_SHARE];
/// Columns of a pad with summits.
const TOUCHED: &[Column<Record>] = &[AREA];
/// Columns of friction on pixels.
const STICKING: &[Column<Record>] = &[STICK_AREA];
/// Columns of a gap with a fluid in it.
const LEAKING: &[Column<Record>] = &[LEAK];

#[expect(clippy::cast_precision_loss, reason = "pixels are far fewer than 2^53")]
fn count(count: usize) -> Option<f64> {
    Some(count as f64)
}

/// The columns of records: those of a part appear if the scene has it.
#[must_use]
pub fn columns(records: &[Record]) -> Vec<Column<Record>> {
    let rubs = records.iter().any(|record| record.tangential.is_some());
    let peels = records.iter().any(|record| record.tangential.is_some_and(|state| state.area_ratio.is_some()));
    let glides = records.iter().any(|record| record.gliding.is_some());
    let wears = records.iter().any(|record| record.worn.is_some());
    let pixels = records.iter().any(|record| record.pixels.is_some());
    let leaks = records.iter().any(|record| record.pixels.is_some_and(|pixels| pixels.leak.is_some()));
    let sticks = records.iter().any(|record| record.stick_area().is_some());
    let joined = records.iter().any(|record| record.joined.is_some());
    let touched = records.iter().any(|record| record.joined.is_some_and(|joined| joined.area.is_some()));
    let driven = records.iter().any(|record| record.machine.is_some());
    let drawn = records.iter().any(|record| record.machine.is_some_and(|machine| machine.drawn.is_some()));
    let rated = records.iter().any(|record| record.machine.is_some_and(|machine| machine.rated.is_some()));
    let led = records.iter().any(|record| record.spring.is_some());
    let machine = [(MACHINE, driven), (DRIVEN, drawn), (RATED, rated), (LED, led)];
    let parts = [(TANGENTIAL, rubs), (SHEARED, peels), (GLIDING, glides), (WORN, wears), (PIXELS, pixels)];
    std::iter::once((NORMAL, true))
        .chain(parts)
        .chain([(STICKING, sticks), (LEAKING, leaks), (JOINED, joined), (TOUCHED, touched)])
        .chain(machine)
        .filter_map(|(columns, present)| present.then_some(columns))
        .flatten()
        .copied()
        .collect()
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
    /// Largest pressure [Pa], between the rows too, where it is not infinite.
    pub peak: Option<f64>,
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

/// Estimate of the relative error of forces and radii, and how it was made.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct ErrorEstimate {
    /// Relative to the largest force and radius of the scene.
    pub relative: f64,
    /// How it was made.
    pub basis: String,
}

/// What came out of a scene.
#[derive(Debug, Clone, PartialEq)]
pub struct Outcome {
    /// Records in order of time.
    pub records: Vec<Record>,
    /// Pressure and surface, at the end of each entry and at the largest depth; empty if not asked for.
    pub fields: Vec<Field>,
    /// Pressure and gap on pixels under the largest force; `None` if not asked for, or not on pixels.
    pub map: Option<ContactMap>,
    /// Tables beside that of the records, such as those of pressure, of stresses, of impacts.
    pub tables: Vec<Table>,
    /// Named results in a fixed order.
    pub results: Vec<Named>,
    /// Estimate of the error.
    pub error_estimate: ErrorEstimate,
    /// Physics a user must know.
    pub warnings: Vec<String>,
    /// What was used.
    pub plan: Parts,
}

impl Outcome {
    /// The result with this name, if the scene has it.
    #[must_use]
    pub fn named(&self, name: &str) -> Option<Finding> {
        self.results.iter().find(|named| named.is_called(name)).map(|named| named.finding)
    }

    /// The number with this name, if the scene has it.
    #[must_use]
    pub fn number(&self, name: &str) -> Option<f64> {
        match self.named(name)? {
            Finding::Number(number) => Some(number),
            Finding::Answer(_) | Finding::Count(_) => None,
        }
    }

    /// The table with this name, if the scene has it.
    #[must_use]
    pub fn table(&self, name: &str) -> Option<&Table> {
        self.tables.iter().find(|table| table.name == name)
    }

    /// The records as a table; it has no name.
    #[must_use]
    pub fn record_table(&self) -> Table {
        Table::new("").with(&columns(&self.records), self.records.iter())
    }
}
