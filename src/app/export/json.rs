//! The JSON summary of a run.

use crate::run::named::Named;
use crate::run::record::{ErrorEstimate, Outcome};
use crate::scene::Scene;
use crate::scene::parts::Parts;
use serde::{Serialize, Serializer, ser::SerializeMap};

#[derive(Serialize)]
struct Summary<'a> {
    scene: Described<'a>,
    version: &'static str,
    plan: &'a Parts,
    results: Results<'a>,
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
struct Results<'a>(&'a [Named]);

impl Serialize for Results<'_> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut map = serializer.serialize_map(Some(self.0.len()))?;
        for named in self.0 {
            map.serialize_entry(&named.name(), &named.finding)?;
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
        results: Results(&outcome.results),
        error_estimate: &outcome.error_estimate,
        warnings: &outcome.warnings,
    };
    let mut text = serde_json::to_string_pretty(&summary)?;
    text.push('\n');
    Ok(text)
}

/// What `--json` prints of scenes whose JSON is known: of one the same shape as of many.
#[must_use]
pub fn json_of_all(scenes: &[String]) -> String {
    let scenes: Vec<&str> = scenes.iter().map(|json| json.trim_end()).collect();
    let version = env!("CARGO_PKG_VERSION");
    format!("{{\"version\": \"{version}\", \"scenes\": [\n{}\n]}}\n", scenes.join(",\n"))
}
