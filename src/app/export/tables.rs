//! CSV tables of records and fields.

use crate::friction::oblique::BallRebound;
use crate::run::record::{Ensemble, FrettingRow, ImpactRow, Impacts, Incidence, Outcome, Record};

/// The records, one row each; columns of a part appear only if the scene has it.
///
/// # Errors
/// The table cannot be put together (never for records of a simulation).
pub fn record_table(outcome: &Outcome) -> Result<String, csv::Error> {
    let sheared = outcome.records.iter().any(|record| record.tangential.is_some());
    let mut header =
        vec!["time_s", "indentation_m", "force_n", "contact_radius_m", "stiffness_n_per_m", "stored_j", "dissipated_j"];
    if sheared {
        header.extend(["slide_m", "tangential_force_n", "stick_radius_m", "friction_dissipated_j"]);
    }
    let peels = outcome.records.iter().any(|record| area_ratio(record).is_some());
    header.extend(peels.then_some("area_ratio"));
    let row = |record| cells(record, sheared).into_iter().chain(peels.then(|| area_ratio(record))).collect();
    let rows = outcome.records.iter().map(row);
    table(&header, rows)
}

/// A/A_JKR of a sheared adhesive contact.
fn area_ratio(record: &Record) -> Option<f64> {
    record.tangential.and_then(|state| state.area_ratio)
}

fn cells(record: &Record, sheared: bool) -> Vec<Option<f64>> {
    let normal = &record.normal;
    let mut row = vec![
        Some(record.time),
        normal.indentation,
        Some(normal.force),
        normal.contact_radius,
        Some(normal.stiffness),
        Some(normal.stored.stored()),
        Some(normal.dissipated),
    ];
    if sheared {
        let part = |of: fn(&crate::friction::state::Tangential) -> f64| record.tangential.as_ref().map(of);
        row.extend([part(|t| t.slide), part(|t| t.force), part(|t| t.stick_radius)]);
        row.push(record.tangential.and_then(|state| state.dissipated));
    }
    row
}

/// Mean and scatter over an ensemble, one row per record.
///
/// # Errors
/// The table cannot be put together (never for an ensemble of a simulation).
pub fn ensemble_table(ensemble: &Ensemble) -> Result<String, csv::Error> {
    let mut header = vec!["time_s".to_owned()];
    for (name, unit) in [("indentation", "m"), ("force", "n"), ("stiffness", "n_per_m")] {
        header.extend(["mean", "deviation", "least", "greatest"].map(|which| format!("{name}_{which}_{unit}")));
    }
    let header: Vec<&str> = header.iter().map(String::as_str).collect();
    let rows = ensemble.rows.iter().map(|row| {
        let columns = [row.indentation, row.force, row.stiffness].map(|s| [s.mean, s.deviation, s.range.0, s.range.1]);
        std::iter::once(row.time).chain(columns.concat()).map(Some).collect()
    });
    table(&header, rows)
}

/// Pressure and surface profiles, one block of rows per field, named in the first column; with the
/// shear stress if the scene has friction.
///
/// # Errors
/// The table cannot be put together (never for fields of a simulation).
pub fn pressure_table(outcome: &Outcome) -> Result<String, csv::Error> {
    let sheared = outcome.records.iter().any(|record| record.tangential.is_some());
    let mut header = vec!["profile", "time_s", "radius_m", "pressure_pa", "surface_displacement_m"];
    header.extend(sheared.then_some("shear_pa"));
    let mut writer = csv::Writer::from_writer(Vec::new());
    writer.write_record(header)?;
    for field in &outcome.fields {
        for row in &field.rows {
            let numbers = [Some(field.time), Some(row.radius), row.pressure, row.displacement];
            let shear = sheared.then_some(row.shear);
            let cells = numbers.into_iter().chain(shear).map(cell);
            writer.write_record(std::iter::once(field.label.clone()).chain(cells))?;
        }
    }
    text(writer)
}

/// The fretting map: energy lost to friction over the distance from the axis.
///
/// # Errors
/// The table cannot be put together (never for a map of a simulation).
pub fn fretting_table(outcome: &Outcome) -> Result<String, csv::Error> {
    let rows = outcome.fretting.iter();
    let cells = |row: &FrettingRow| vec![Some(row.position), Some(row.per_area), Some(row.per_length)];
    table(&["radius_m", "energy_j_per_m2", "spring_energy_j_per_m"], rows.map(cells))
}

/// Impacts, one row each.
///
/// # Errors
/// The table cannot be put together (never for impacts of a simulation).
pub fn impact_table(impacts: &Impacts) -> Result<String, csv::Error> {
    let oblique = impacts.rows.iter().any(|row| row.oblique.is_some());
    let mut header = vec![
        "speed_m_per_s",
        "restitution",
        "rebound_speed_m_per_s",
        "contact_time_s",
        "greatest_depth_m",
        "largest_force_n",
        "peak_pressure_pa",
        "sticks",
        "lost_j",
    ];
    if oblique {
        header.extend(OBLIQUE);
    }
    table(&header, impacts.rows.iter().map(impact_cells))
}

/// Columns of an oblique impact.
const OBLIQUE: [&str; 7] = [
    "rebound_angle_rad",
    "rebound_spin_rad_per_s",
    "tangential_restitution",
    "impulse_ratio",
    "local_incidence",
    "local_rebound",
    "friction_dissipated_j",
];

fn impact_cells(row: &ImpactRow) -> Vec<Option<f64>> {
    let rebound = &row.rebound;
    let mut cells = vec![
        Some(row.speed),
        Some(rebound.restitution),
        Some(row.rebound_speed()),
        rebound.contact_time,
        Some(rebound.greatest_depth),
        Some(rebound.greatest_force),
        row.peak_pressure,
        Some(f64::from(u8::from(rebound.sticks()))),
        Some(rebound.lost),
    ];
    cells.extend(row.oblique.iter().flat_map(oblique_cells));
    cells
}

fn oblique_cells(rebound: &BallRebound) -> [Option<f64>; 7] {
    let numbers = [
        rebound.angle,
        rebound.flight.spin,
        rebound.tangential_restitution,
        rebound.impulse_ratio,
        rebound.psi.0,
        rebound.psi.1,
        rebound.dissipated,
    ];
    numbers.map(Some)
}

/// The impact of the scene at other angles of incidence, one row each.
///
/// # Errors
/// The table cannot be put together (never for impacts of a simulation).
pub fn incidence_table(impacts: &Impacts) -> Result<String, csv::Error> {
    let header: Vec<&str> = std::iter::once("angle_rad").chain(OBLIQUE).collect();
    let cells = |incidence: &Incidence| {
        std::iter::once(Some(incidence.angle)).chain(oblique_cells(&incidence.rebound)).collect::<Vec<_>>()
    };
    table(&header, impacts.incidence.iter().map(cells))
}

fn table(header: &[&str], rows: impl Iterator<Item = Vec<Option<f64>>>) -> Result<String, csv::Error> {
    let mut writer = csv::Writer::from_writer(Vec::new());
    writer.write_record(header)?;
    for row in rows {
        writer.write_record(row.into_iter().map(cell))?;
    }
    text(writer)
}

/// The shortest text that reads back as the same number; empty where there is none.
pub(super) fn cell(value: Option<f64>) -> String {
    // Adding zero turns −0 into 0.
    value.filter(|value| value.is_finite()).map_or_else(String::new, |value| format!("{:?}", value + 0.0))
}

pub(super) fn text(writer: csv::Writer<Vec<u8>>) -> Result<String, csv::Error> {
    let bytes = writer.into_inner().map_err(|error| std::io::Error::other(error.to_string()))?;
    String::from_utf8(bytes).map_err(|error| std::io::Error::other(error).into())
}
