//! What a fit is asked for, and its answer for a file or a curve.
//!
//! # Examples
//! ```
//! use springbed::app::fitting::Fitting;
//! use springbed::fit::Curve;
//! use springbed::prelude::*;
//! use springbed::scene::{Scene, fit::Measured};
//!
//! // F = (4/3)E*√R d^{3/2} with E* = 4/3 kPa and R = 1 mm.
//! let depth: Vec<f64> = (0..50).map(|k| f64::from(k) * 1e-7).collect();
//! let force = depth.iter().map(|d| 4.0 / 3.0 * 4e3 / 3.0 * (1e-3 * d.powi(3)).sqrt()).collect();
//! let curve = Curve { rows: (0..50).collect(), depth, force, time: None };
//! let scene = Scene::from_ron(r#"(shape: Paraboloid(radius: "1 mm"), bodies: (Elastic(young: "5 kPa", poisson: 0.5), Rigid),
//!     history: [Indent(to: "10 um", over: 1)])"#)?;
//! let measured = Measured { free: vec!["bodies.0.young=100 Pa..1 MPa".to_owned()], ..Measured::default() };
//! let fitted = Fitting::new(&measured, &scene)?.of_curve("a curve", curve, &InMemory::default())?;
//! assert!((fitted.fit.parameters[0].value / 1e3 - 1.0).abs() < 1e-6);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

use super::data_file::{Data, Wanted};
use super::export::Fitted;
use super::fault::Fault;
use crate::contact::adhesion::equilibrium::Control;
use crate::fit::{Curve, Free, Options, Question};
use crate::input::quantity::{Displacement, Force, SpringStiffness};
use crate::input::table::Tables;
use crate::scene::Scene;
use crate::scene::fit::Measured;
use std::path::Path;

/// A question to curves, and the columns in which their files have it.
#[derive(Debug, Clone)]
pub struct Fitting {
    question: Question,
    wanted: Wanted,
}

impl Fitting {
    /// What `measured` asks of a scene.
    ///
    /// # Errors
    /// Columns, a free parameter or a range are not right.
    pub fn new(measured: &Measured, scene: &Scene) -> Result<Self, String> {
        let wanted = Wanted::read(&measured.columns, measured.spring.map(SpringStiffness::si));
        let wanted = wanted.map_err(|what| format!("columns: {what}"))?;
        let Measured { baseline, contact, drive, way, loss, .. } = *measured;
        let mut options = Options { baseline, contact, drive, way, loss, ..Options::default() };
        let question = |options| Question::new(scene, &measured.free, options).map_err(|error| error.to_string());
        if !measured.range.is_empty() {
            let control = question(options)?.control();
            options.range = range(&measured.range, control).map_err(|what| format!("range: {what}"))?;
        }
        Ok(Self { question: question(options)?, wanted })
    }

    /// What is free.
    #[must_use]
    pub fn free(&self) -> &[Free] {
        self.question.free()
    }

    /// The answer for the file at `path`; `tables` are those of the scene.
    ///
    /// # Errors
    /// The file cannot be read, has no such curve, or the curve cannot be fitted.
    pub fn of_file(&self, path: &Path, tables: &dyn Tables) -> Result<Fitted, String> {
        let said = |fault: Fault| format!("{}: {}", fault.file.display(), fault.message);
        let data = Data::load(path, &self.wanted).map_err(said)?;
        let curve = data.curve().map_err(said)?;
        let fitted = self.of_curve(&path.display().to_string(), curve, tables)?;
        Ok(Fitted { data_notes: data.notes, ..fitted })
    }

    /// The answer for a curve that is called `name`; `tables` are those of the scene.
    ///
    /// # Errors
    /// The curve cannot be fitted.
    pub fn of_curve(&self, name: &str, curve: Curve, tables: &dyn Tables) -> Result<Fitted, String> {
        let fit = self.question.fit(&curve, tables).map_err(|error| error.to_string())?;
        let scene = self.question.scene(&fit.values).map_err(|error| error.to_string())?;
        Ok(Fitted { file: name.to_owned(), scene, curve, fit, data_notes: Vec::new() })
    }
}

fn range(text: &str, control: Control) -> Result<(f64, f64), String> {
    let (low, high) = text.split_once("..").ok_or_else(|| format!("\"{text}\" is no range: expected LO..HI"))?;
    let end = |text: &str, open: f64| match control {
        _ if text.trim().is_empty() => Ok(open),
        Control::Indentation => text.parse().map(Displacement::si).map_err(|error| error.to_string()),
        Control::Force => text.parse().map(Force::si).map_err(|error| error.to_string()),
    };
    let (low, high) = (end(low, f64::NEG_INFINITY)?, end(high, f64::INFINITY)?);
    if low < high { Ok((low, high)) } else { Err(format!("\"{text}\" is empty: expected the smaller end first")) }
}
