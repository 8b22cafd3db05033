//! `springbed explain`: how a scene would be computed, and how well.

use super::Common;
use crate::app::console::{Console, Failure};
use crate::app::export::with_prefix;
use crate::app::run::compute;
use crate::app::scene_file::SceneFile;
use crate::check::matrix::{self, Cell, Verdict};
use crate::check::{one_piece, theory};
use crate::contact::adhesion::{AdhesionTraits, Range};
use crate::run::record::Outcome;
use crate::run::steady_sliding;
use crate::scene::plan::Plan;
use rayon::prelude::*;
use std::f64::consts::PI;
use std::fmt::Write;
use std::path::Path;

/// Explains a scene. It is computed once without its files, for the warnings are numbers.
///
/// # Errors
/// The scene is wrong or cannot be computed.
pub fn run(path: &Path, common: &Common, console: &Console) -> Result<(), Failure> {
    let scene = SceneFile::load(path).map_err(Failure::Scene)?;
    let outcome = compute(&scene.plan, &[]).map_err(Failure::failed)?;
    let text = if common.json { json(&scene.plan, &outcome)? } else { text(&scene.plan, &outcome) };
    console.result(&text)
}

/// What the matrix says of the errors that its scenes reach.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Errors {
    /// Nothing: no scene is computed.
    LeftOut,
    /// How far each is off: every scene is computed.
    Measured,
}

impl Errors {
    /// Told or not, as `measure` asks.
    #[must_use]
    pub fn asked(measure: bool) -> Self {
        if measure { Self::Measured } else { Self::LeftOut }
    }

    /// The matrix in words.
    #[must_use]
    pub fn matrix(self) -> String {
        match self {
            Self::LeftOut => matrix::in_words(&matrix::cells()),
            Self::Measured => matrix::measured(&matrix::cells()),
        }
    }
}

/// Shows the matrix of all combinations.
///
/// # Errors
/// It cannot be written.
pub fn matrix(errors: Errors, common: &Common, console: &Console) -> Result<(), Failure> {
    let text = if common.json { cells_as_json(&matrix::cells(), errors)? } else { errors.matrix() };
    console.result(&text)
}

fn cells_as_json(cells: &[Cell], errors: Errors) -> Result<String, Failure> {
    let object = |cell: &Cell| {
        let [shape, bodies, adhesion, friction, drive] = cell.names();
        let (solver, why) = match &cell.verdict {
            Verdict::Computed { solver } => (Some(*solver), None),
            Verdict::Refused { why } => (None, Some(why)),
        };
        let is_computed = solver.is_some();
        let reached = match errors {
            Errors::LeftOut => None,
            Errors::Measured => cell.reached().and_then(Result::ok),
        };
        serde_json::json!({
            "shape": shape, "bodies": bodies, "adhesion": adhesion, "friction": friction, "drive": drive,
            "solver": solver, "refused": why,
            "proof": is_computed.then(|| cell.proof().word()), "cases": is_computed.then(|| cell.cases()),
            "error": reached.map(|reached| reached.error), "against": reached.map(|reached| reached.against.word()),
        })
    };
    serde_json::to_string_pretty(&cells.par_iter().map(object).collect::<Vec<_>>()).map_err(Failure::failed)
}

fn text(plan: &Plan, outcome: &Outcome) -> String {
    let mut text = String::new();
    let mut line = |name: &str, value: &str| {
        let _ = writeln!(text, "{name:<16}{value}");
    };
    line("scene", &plan.scene.title);
    for (name, value, unit) in moduli(plan) {
        line(name, &with_prefix(value, unit));
    }
    let edge = plan.held_edge().map(|held| held.edge.in_words());
    for (name, words) in [("edge", edge), ("attraction", attraction(plan)), ("power law", power_law(plan))] {
        words.iter().for_each(|words| line(name, words));
    }
    let parts = &outcome.plan;
    line("solver", &format!("{}: {}", parts.solver, parts.reason));
    line("parts used", &parts.used.join(", "));
    line("parts left out", &parts.left_out.join(", "));
    line("springs", &parts.springs.to_string());
    line("bytes of state", &parts.state_bytes.to_string());
    line("accuracy asked", &format!("{:e}", plan.accuracy()));
    let estimate = &outcome.error_estimate;
    line("error expected", &format!("{:.0e} ({})", estimate.relative, estimate.basis));
    steady_sliding(plan, outcome).iter().for_each(|words| line("steady sliding", words));
    one_piece::in_words(plan, outcome).iter().for_each(|words| line("connectivity", words));
    theories(plan, outcome).iter().for_each(|words| line("theory", words));
    if outcome.warnings.is_empty() {
        line("warnings", "none");
    }
    for warning in &outcome.warnings {
        line("warning", warning);
    }
    text
}

/// What acts across the gap: stress, range and, under a tip of the radius R on E*, λ = σ₀(9R/2πwE*²)^{1/3} between the
/// limits of hard and soft bodies (Maugis 1992).
fn attraction(plan: &Plan) -> Option<String> {
    let AdhesionTraits { work, range: Range::Finite(stress), .. } = plan.scene.adhesion.as_ref()?.traits() else {
        return None;
    };
    let modulus = plan.pair.normal;
    let between = plan.scene.shape.tip_radius().map_or_else(String::new, |radius| {
        let lambda = stress * (4.5 * radius / (PI * work * modulus * modulus)).cbrt();
        format!("; λ = {lambda:.3}: below 0.1 that of hard bodies (DMT), above 5 that of soft ones (JKR)")
    });
    let (range, work) = (with_prefix(work / stress, "m"), with_prefix(work, "J/m²"));
    Some(format!("{} up to a gap of {range}, w = {work}{between}", with_prefix(stress, "Pa")))
}

/// The series that stands for a power law, if the bodies relax by one.
fn power_law(plan: &Plan) -> Option<String> {
    let (times, relaxation) = (plan.times()?, plan.relaxation()?);
    let [shortest, longest] = [times.shortest, times.longest].map(|time| with_prefix(time, "s"));
    let terms = relaxation.terms.len();
    Some(format!(
        "{terms} Prony terms and a modulus that does not relax, from {shortest} to {longest} within {:.0e}; E*(0) and E*(∞) are those of the series, of the law they are infinite and zero",
        times.error()
    ))
}

/// What theories of rough contact say of the largest force of the scene.
fn theories(plan: &Plan, outcome: &Outcome) -> Vec<String> {
    let states = outcome.records.iter().map(|record| &record.normal);
    let largest = states.max_by(|one, other| one.force.total_cmp(&other.force));
    largest.map_or_else(Vec::new, |state| theory::in_words(plan, state))
}

/// Effective moduli by name, and the viscosity of a dashpot beside them, with their units; no G* of a dashpot alone.
fn moduli(plan: &Plan) -> Vec<(&'static str, f64, &'static str)> {
    let along = ("G*", plan.pair.tangential, "Pa");
    let Some(relaxation) = plan.relaxation() else { return vec![("E*", plan.pair.normal, "Pa"), along] };
    let at_once = relaxation.instantaneous();
    let mut rows = vec![("E*(0)", at_once, "Pa"), ("E*(∞)", relaxation.equilibrium, "Pa")];
    rows.extend((relaxation.viscosity > 0.0).then_some(("η*", relaxation.viscosity, "Pa s")));
    rows.extend((at_once > 0.0).then_some(along));
    rows
}

fn json(plan: &Plan, outcome: &Outcome) -> Result<String, Failure> {
    let value = serde_json::json!({
        "title": plan.scene.title,
        "pair": plan.pair,
        "relaxation": plan.relaxation(),
        "plan": outcome.plan,
        "accuracy": plan.accuracy(),
        "error_estimate": outcome.error_estimate,
        "connectivity": one_piece::in_words(plan, outcome),
        "steady_sliding": steady_sliding(plan, outcome),
        "theories": theories(plan, outcome),
        "warnings": outcome.warnings,
    });
    serde_json::to_string_pretty(&value).map_err(Failure::failed)
}
