//! A scene from its text to its results.

use crate::columns::columns;
use crate::errors::{failed, of_places, of_text};
use crate::watch::watched;
use clap::ValueEnum;
use pyo3::prelude::*;
use pyo3::types::{PyBytes, PyDict};
use springbed::app::export;
use springbed::app::medium::Medium;
use springbed::app::picture::of_svg;
use springbed::app::run::{Format, compute};
use springbed::app::table_file::TableFiles;
use springbed::input::problem::Problem;
use springbed::run::in_pieces;
use springbed::run::named::Finding;
use springbed::run::record::Outcome;
use springbed::scene::plan::Plan;
use springbed::text::place::{Places, Value};
use springbed::text::{Notation, TextError};
use std::path::PathBuf;

/// A scene as the package hands it over: its text, whether that is JSON, and the folder of its tables.
#[derive(Debug, Clone, FromPyObject)]
pub struct Source {
    text: String,
    json: bool,
    pub folder: PathBuf,
}

/// What is wrong with a source or with what is set in it.
pub enum Wrong {
    Text(Vec<TextError>),
    Places(Vec<Problem>),
    Failed(String),
}

impl Wrong {
    pub fn raised(self, py: Python<'_>) -> PyErr {
        match self {
            Self::Text(errors) => of_text(py, &errors),
            Self::Places(problems) => of_places(py, &problems),
            Self::Failed(why) => failed(py, why),
        }
    }
}

impl Source {
    /// The tables beside the scene.
    pub fn tables(&self) -> TableFiles {
        TableFiles::beside(&self.folder.join("scene"))
    }

    /// The plan of the scene.
    pub fn plan(&self) -> Result<Plan, Wrong> {
        let notation = if self.json { Notation::Json } else { Notation::Ron };
        notation.plan(&self.text, &self.tables()).map_err(Wrong::Text)
    }

    /// The plan of the scene with the values `set`, each a path and a value in JSON.
    fn plan_with(&self, set: &[(String, String)]) -> Result<Plan, Wrong> {
        let plan = self.plan()?;
        if set.is_empty() {
            return Ok(plan);
        }
        let one = |problem| Wrong::Places(vec![problem]);
        let value = |(path, text): &(String, String)| value(text).map(|value| (path.clone(), value));
        let set = set.iter().map(value).collect::<Result<Vec<_>, _>>().map_err(one)?;
        let scene = Places::of(&plan.scene).and_then(|places| places.with(&set)).map_err(one)?;
        scene.resolve(&self.tables()).map_err(Wrong::Places)
    }
}

/// The value in a JSON text.
pub fn value(text: &str) -> Result<Value, Problem> {
    text.parse().map_err(|error| Problem::new("", format!("{text} is no value: {error}")))
}

/// A scene computed: what a figure needs besides.
struct Computed {
    plan: Plan,
    outcome: Outcome,
}

fn computed(source: &Source, set: &[(String, String)], formats: &[Format]) -> Result<Computed, Wrong> {
    let plan = source.plan_with(set)?;
    let outcome = compute(&plan, formats).map_err(|error| Wrong::Failed(error.to_string()))?;
    match in_pieces(&outcome) {
        Some(why) => Err(Wrong::Failed(why.to_owned())),
        None => Ok(Computed { plan, outcome }),
    }
}

/// Computes a scene with the values `set`; gives what `springbed.Result` is made of.
#[pyfunction]
pub fn run<'py>(py: Python<'py>, source: Source, set: Vec<(String, String)>) -> PyResult<Bound<'py, PyDict>> {
    let Computed { plan, outcome } =
        watched(py, move |_| computed(&source, &set, &[Format::Csv]))?.map_err(|wrong| wrong.raised(py))?;
    let failed = |error: &dyn std::fmt::Display| failed(py, error.to_string());
    let parts = PyDict::new(py);
    let results = PyDict::new(py);
    for named in &outcome.results {
        match named.finding {
            Finding::Number(number) => results.set_item(named.name(), number)?,
            Finding::Answer(yes) => results.set_item(named.name(), yes)?,
            Finding::Count(count) => results.set_item(named.name(), count)?,
        }
    }
    parts.set_item("results", results)?;
    parts.set_item("warnings", &outcome.warnings)?;
    parts.set_item("error_estimate", (outcome.error_estimate.relative, &outcome.error_estimate.basis))?;
    parts.set_item("plan", serde_json::to_string(&outcome.plan).map_err(|error| failed(&error))?)?;
    parts.set_item("scene", serde_json::to_string(&plan.scene).map_err(|error| failed(&error))?)?;
    parts.set_item("records", columns(py, outcome.record_table())?)?;
    let tables = PyDict::new(py);
    for table in outcome.tables {
        tables.set_item(table.name, columns(py, table)?)?;
    }
    parts.set_item("tables", tables)?;
    Ok(parts)
}

/// A value of an enumeration of the program by its name.
fn named<E: ValueEnum>(py: Python<'_>, name: &str) -> PyResult<E> {
    let known = || E::value_variants().iter().filter_map(|kind| Some(kind.to_possible_value()?.get_name().to_owned()));
    E::from_str(name, true).map_err(|_| {
        failed(py, format!("{name} is not known: expected one of {}", known().collect::<Vec<_>>().join(", ")))
    })
}

/// A figure in SVG as the bytes of a file of another format; a raster of so many dots per inch.
#[pyfunction]
pub fn picture<'py>(py: Python<'py>, svg: String, format: &str, dpi: u32) -> PyResult<Bound<'py, PyBytes>> {
    let format: Format = named(py, format)?;
    let bytes = py.detach(|| of_svg(svg, format, dpi)).map_err(|error| failed(py, error.to_string()))?;
    Ok(PyBytes::new(py, &bytes))
}

/// The figure of a scene as SVG.
#[pyfunction]
pub fn figure(py: Python<'_>, source: Source, style: &str) -> PyResult<String> {
    let medium: Medium = named(py, style)?;
    let drawn = move |_: &_| {
        let Computed { plan, outcome } = computed(&source, &[], &[Format::Csv, Format::Svg])?;
        Ok(export::figures(&plan, &outcome).drawn(medium))
    };
    watched(py, drawn)?.map_err(|wrong: Wrong| wrong.raised(py))
}

/// Reads a scene and says what is wrong with it.
#[pyfunction]
pub fn check(py: Python<'_>, source: Source) -> PyResult<()> {
    source.plan().map(drop).map_err(|wrong| wrong.raised(py))
}
