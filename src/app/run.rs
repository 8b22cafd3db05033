//! A scene from its plan to the bytes of its files.
//!
//! # Examples
//! ```
//! use springbed::app::{run, scene_file};
//!
//! let text = r#"(shape: Paraboloid(radius: 1), bodies: (Elastic(young: 1, poisson: 0), Rigid),
//!     history: [Indent(to: 1, over: 1)])"#;
//! let plan = scene_file::plan("ball.ron".as_ref(), text).map_err(|faults| faults[0].message.clone())?;
//! let asked = run::Asked::of(&[run::Format::Csv]);
//! let products = run::products(&plan, "ball.ron", &run::compute(&plan, &asked.formats)?, &asked)?;
//! assert!(products[0].ending == ".csv" && products[0].content.starts_with(b"time_s,"));
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

use super::export;
pub use super::format::Format;
use super::picture::{Drawing, PictureError};
use crate::run::record::Outcome;
use crate::run::{self, SimulationError, Wanted};
use crate::scene::Plot;
use crate::scene::plan::Plan;

/// Files wanted, and how the figures among them are drawn.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct Asked {
    /// Their formats.
    pub formats: Vec<Format>,
    /// How figures are drawn.
    pub drawing: Drawing,
}

impl Asked {
    /// Files of the `formats`, figures for a screen.
    #[must_use]
    pub fn of(formats: &[Format]) -> Self {
        Self { formats: formats.to_owned(), drawing: Drawing::default() }
    }
}

/// A file to be written: what follows the stem of the scene's name, and the bytes.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Product {
    /// Ending such as `.csv` or `.pressure.csv`.
    pub ending: String,
    /// Content.
    pub content: Vec<u8>,
}

/// Why a scene gave no files.
#[derive(Debug, thiserror::Error)]
pub enum RunError {
    /// The computation failed.
    #[error(transparent)]
    Simulation(#[from] SimulationError),
    /// A table could not be put together.
    #[error("the table could not be written: {0}")]
    Table(#[from] csv::Error),
    /// The summary could not be put together.
    #[error("the summary could not be written: {0}")]
    Json(#[from] serde_json::Error),
    /// A figure could not be drawn.
    #[error(transparent)]
    Picture(#[from] PictureError),
}

/// Computes a scene, with what the `formats` need and nothing else.
///
/// # Errors
/// The computation failed.
pub fn compute(plan: &Plan, formats: &[Format]) -> Result<Outcome, RunError> {
    compute_watched(plan, formats, &|_| ())
}

/// Computes a scene; `done` is told the share of the work that is behind, from any thread, where it is long.
///
/// # Errors
/// The computation failed.
pub fn compute_watched(plan: &Plan, formats: &[Format], done: &(dyn Fn(f64) + Sync)) -> Result<Outcome, RunError> {
    let plotted = |plot| plan.scene.plots.as_ref().is_some_and(|plots| plots.contains(&plot));
    let figure = formats.iter().any(|format| format.is_picture());
    let drawn = figure || formats.contains(&Format::Csv);
    let wanted = Wanted {
        fields: formats.contains(&Format::Csv)
            || formats.contains(&Format::Json)
            || figure
                && (plan.scene.plots.is_none()
                    || [Plot::Pressure, Plot::Shear, Plot::Contact].into_iter().any(plotted)),
        stresses: drawn && (plotted(Plot::Stress) || plotted(Plot::Field)),
        bed: drawn && plotted(Plot::Bed),
        surface: drawn && plotted(Plot::Surface),
        fretting: formats.contains(&Format::Csv) || figure,
        instants: true,
    };
    Ok(run::run_watched(plan, wanted, done)?)
}

/// Endings of the files that hold pressure, gap and shear on pixels.
const ARRAYS: [&str; 3] = [".pressure.npy", ".gap.npy", ".shear.npy"];

/// Endings of all files a scene can give, known before it is computed.
#[must_use]
pub fn endings(plan: &Plan, formats: &[Format]) -> Vec<String> {
    let mut endings = Vec::new();
    if formats.contains(&Format::Csv) {
        endings.push(".csv".to_owned());
        endings.extend(run::tables(plan).iter().map(|name| format!(".{name}.csv")));
        if let Plan::HalfSpace(plan) = plan {
            let arrays = ARRAYS.len() - usize::from(plan.friction.is_none());
            endings.extend(ARRAYS[..arrays].iter().map(|&ending| ending.to_owned()));
        }
    }
    endings.extend(formats.contains(&Format::Json).then(|| ".json".to_owned()));
    let pictures = formats.iter().filter(|format| cfg!(feature = "plot") && format.is_picture());
    endings.extend(pictures.map(|format| format!(".{}", format.ending())));
    endings
}

/// The files of an outcome; `file` is the name of the scene's file.
///
/// # Errors
/// A file could not be put together.
pub fn products(plan: &Plan, file: &str, outcome: &Outcome, asked: &Asked) -> Result<Vec<Product>, RunError> {
    let formats = &asked.formats;
    let mut products = Vec::new();
    if formats.contains(&Format::Csv) {
        products
            .push(Product { ending: ".csv".to_owned(), content: export::csv(&outcome.record_table())?.into_bytes() });
        for table in &outcome.tables {
            products
                .push(Product { ending: format!(".{}.csv", table.name), content: export::csv(table)?.into_bytes() });
        }
    }
    if let Some(map) = outcome.map.as_ref().filter(|_| formats.contains(&Format::Csv)) {
        let arrays = ARRAYS.into_iter().zip([&map.pressure, &map.gap].into_iter().chain(&map.shear));
        products
            .extend(arrays.map(|(ending, array)| Product { ending: ending.to_owned(), content: export::npy(array) }));
    }
    if formats.contains(&Format::Json) {
        products.push(Product {
            ending: ".json".to_owned(),
            content: export::json(&plan.scene, file, outcome)?.into_bytes(),
        });
    }
    #[cfg(feature = "plot")]
    if formats.iter().any(|format| format.is_picture()) {
        let figure = export::figures(plan, outcome);
        for &format in formats {
            let picture = asked.drawing.bytes(&figure, format)?;
            products.extend(picture.map(|content| Product { ending: format!(".{}", format.ending()), content }));
        }
    }
    Ok(products)
}
