//! The JSON summary of a run.

use crate::run::record::{ErrorEstimate, Outcome, Value};
use crate::scene::Scene;
use crate::scene::plan::Plan;
use serde::{Serialize, Serializer, ser::SerializeMap};

#[derive(Serialize)]
struct Summary<'a> {
    scene: Described<'a>,
    version: &'static str,
    plan: &'a Plan,
    results: Named<'a>,
    error_estimate: &'a ErrorEstimate,
    warnings: &'a [String],
}

#[derive(Serialize)]
struct Described<'a> {
    title: &'a str,
    file: &'a str,
    resolved: &'a Scene,
}

/// Named results, in their order.
struct Named<'a>(&'a [(&'static str, Value)]);

impl Serialize for Named<'_> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut map = serializer.serialize_map(Some(self.0.len()))?;
        for (name, value) in self.0 {
            map.serialize_entry(name, value)?;
        }
        map.end()
    }
}

/// The JSON text of an outcome; `file` is the name of the scene's file.
///
/// # Errors
/// The scene or the results cannot be written as JSON.
pub fn json(scene: &Scene, file: &str, outcome: &Outcome) -> Result<String, serde_json::Error> {
    let summary = Summary {
        scene: Described { title: &scene.title, file, resolved: scene },
        version: env!("CARGO_PKG_VERSION"),
        plan: &outcome.plan,
        results: Named(&outcome.results),
        error_estimate: &outcome.error_estimate,
        warnings: &outcome.warnings,
    };
    let mut text = serde_json::to_string_pretty(&summary)?;
    text.push('\n');
    Ok(text)
}
