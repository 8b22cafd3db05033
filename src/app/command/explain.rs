//! `springbed explain`: how a scene would be computed, and how well.

use super::Common;
use crate::app::console::{Console, Failure};
use crate::app::export::with_prefix;
use crate::app::run::compute;
use crate::app::scene_file::SceneFile;
use crate::check::{one_piece, theory};
use crate::run::record::Outcome;
use crate::scene::plan::Plan;
use std::fmt::Write;
use std::path::Path;

/// Explains a scene. It is computed once without its files, for the warnings are numbers.
///
/// # Errors
/// The scene is wrong or cannot be computed.
pub fn run(path: &Path, common: &Common, console: &Console) -> Result<(), Failure> {
    let scene = SceneFile::load(path).map_err(Failure::Scene)?;
    let outcome = compute(&scene.setup, &[]).map_err(Failure::failed)?;
    let text = if common.json { json(&scene.setup, &outcome)? } else { text(&scene.setup, &outcome) };
    console.result(&text)
}

fn text(setup: &Plan, outcome: &Outcome) -> String {
    let mut text = String::new();
    let mut line = |name: &str, value: &str| {
        let _ = writeln!(text, "{name:<16}{value}");
    };
    line("scene", &setup.scene.title);
    for (name, value) in moduli(setup) {
        line(name, &with_prefix(value, "Pa"));
    }
    if let Some(held) = setup.held_edge() {
        line("edge", &held.edge.in_words());
    }
    let plan = &outcome.plan;
    line("solver", &format!("{}: {}", plan.solver, plan.reason));
    line("parts used", &plan.used.join(", "));
    line("parts left out", &plan.left_out.join(", "));
    line("springs", &plan.springs.to_string());
    line("bytes of state", &plan.state_bytes.to_string());
    line("accuracy asked", &format!("{:e}", setup.accuracy()));
    let estimate = &outcome.error_estimate;
    line("error expected", &format!("{:.0e} ({})", estimate.relative, estimate.basis));
    for words in one_piece::in_words(setup, outcome) {
        line("connectivity", &words);
    }
    for words in theories(setup, outcome) {
        line("theory", &words);
    }
    if outcome.warnings.is_empty() {
        line("warnings", "none");
    }
    for warning in &outcome.warnings {
        line("warning", warning);
    }
    text
}

/// What theories of rough contact say of the largest force of the scene.
fn theories(setup: &Plan, outcome: &Outcome) -> Vec<String> {
    let states = outcome.records.iter().map(|record| &record.normal);
    let largest = states.max_by(|one, other| one.force.total_cmp(&other.force));
    largest.map_or_else(Vec::new, |state| theory::in_words(setup, state.force, state.stiffness))
}

/// Effective moduli by name [Pa].
fn moduli(setup: &Plan) -> Vec<(&'static str, f64)> {
    let mut rows = vec![("G*", setup.pair.tangential)];
    match setup.relaxation() {
        None => rows.insert(0, ("E*", setup.pair.normal)),
        Some(relaxation) => {
            rows.insert(0, ("E*(∞)", relaxation.equilibrium));
            rows.insert(0, ("E*(0)", relaxation.instantaneous()));
        }
    }
    rows
}

fn json(setup: &Plan, outcome: &Outcome) -> Result<String, Failure> {
    let value = serde_json::json!({
        "title": setup.scene.title,
        "pair": setup.pair,
        "relaxation": setup.relaxation(),
        "plan": outcome.plan,
        "accuracy": setup.accuracy(),
        "error_estimate": outcome.error_estimate,
        "connectivity": one_piece::in_words(setup, outcome),
        "theories": theories(setup, outcome),
        "warnings": outcome.warnings,
    });
    serde_json::to_string_pretty(&value).map_err(Failure::failed)
}
