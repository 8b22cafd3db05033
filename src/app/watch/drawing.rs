//! A scene from its text to what the page shows of it.

use crate::app::export;
use crate::app::fault::Fault;
use crate::app::medium::Medium;
use crate::app::run::{Format, compute_watched};
use crate::app::scene_file::SceneFile;
use crate::run::in_pieces;
use crate::text::written::{Written, numbers};
use serde::Serialize;
use std::path::{Path, PathBuf};

/// What came out of a text.
#[derive(Debug, Clone, Default, Serialize)]
pub struct Drawn {
    /// Title of the scene.
    pub title: String,
    /// What is wrong with the text; then there is nothing else.
    pub faults: Vec<Told>,
    /// The figure for wide and narrow pages.
    pub figures: Option<[String; 2]>,
    /// Results with their names.
    pub results: Vec<(String, String)>,
    /// Physics to beware of.
    pub warnings: Vec<String>,
    /// Tables the scene reads.
    #[serde(skip)]
    pub tables: Vec<PathBuf>,
}

/// A fault with its place.
#[derive(Debug, Clone, Serialize)]
pub struct Told {
    file: String,
    line: Option<usize>,
    column: Option<usize>,
    message: String,
    source: Option<String>,
}

impl From<Fault> for Told {
    fn from(fault: Fault) -> Self {
        let (line, column) = fault.position.map(|at| (at.line, at.column)).unzip();
        let file = fault.file.file_name().unwrap_or_default().to_string_lossy().into_owned();
        Self { file, line, column, message: fault.message, source: fault.line }
    }
}

/// A number of the text as a slider.
#[derive(Debug, Clone, Serialize)]
pub struct Slider {
    path: String,
    value: f64,
    unit: String,
}

impl From<Written> for Slider {
    fn from(Written { path, value, unit, .. }: Written) -> Self {
        Self { path, value, unit }
    }
}

/// Most sliders on a page.
const MOST: usize = 60;

/// The sliders of a text.
#[must_use]
pub fn sliders(text: &str) -> Vec<Slider> {
    numbers(text).into_iter().take(MOST).map(Slider::from).collect()
}

/// Reads the text of the file at `path`, computes the scene and draws it; `done` is told the share of the work that is
/// behind, where it is long.
#[must_use]
pub fn drawn(path: &Path, text: &str, done: &(dyn Fn(f64) + Sync)) -> Drawn {
    match SceneFile::of(path, text.to_owned()) {
        Err(faults) => Drawn { faults: told(faults), ..Drawn::default() },
        Ok(scene) => of_scene(&scene, done),
    }
}

/// What is told of faults.
#[must_use]
pub fn told(faults: Vec<Fault>) -> Vec<Told> {
    faults.into_iter().map(Told::from).collect()
}

fn of_scene(scene: &SceneFile, done: &(dyn Fn(f64) + Sync)) -> Drawn {
    let base = Drawn { title: scene.plan.scene.title.clone(), tables: scene.tables.clone(), ..Drawn::default() };
    let failed = |why: String| Drawn { faults: told(vec![Fault::whole(&scene.path, why)]), ..base.clone() };
    let outcome = match compute_watched(&scene.plan, &[Format::Svg], done) {
        Ok(outcome) => outcome,
        Err(error) => return failed(error.to_string()),
    };
    if let Some(why) = in_pieces(&outcome) {
        return failed(why.to_owned());
    }
    let figure = export::figures(&scene.plan, &outcome);
    let results = outcome.results.iter().map(|named| (named.quantity.replace('_', " "), export::shown(named)));
    Drawn {
        figures: Some([Medium::Screen, Medium::Paper].map(|medium| figure.drawn(medium))),
        results: results.collect(),
        warnings: outcome.warnings,
        ..base
    }
}
