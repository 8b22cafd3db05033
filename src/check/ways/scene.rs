//! Any scene: its own solver at several accuracies, and beds of springs.

use crate::check::case::Attempt;
use crate::check::row::{Computed, Setting};
use crate::check::sketch::result;
use crate::check::study::{Method, Study, Thoroughness};
use crate::input::quantity::Accuracy;
use crate::run::named::{Finding, Named};
use crate::run::record::Outcome;
use crate::run::{self, SimulationError, Wanted};
use crate::scene::plan::{Plan, SceneSettings};
use std::num::NonZeroUsize;

/// Accuracy of the reference.
const FINEST: f64 = 1e-8;
/// Accuracies of the solver itself, where it heeds them.
const COARSER: [f64; 5] = [1e-2, 1e-3, 1e-4, 1e-5, 1e-6];

/// A scene by its own solver and by beds of springs, against its own solver at its finest.
///
/// The numbers compared are all named results, each relative to its own reference.
///
/// # Errors
/// The scene cannot be run.
pub fn scene(plan: &Plan, effort: Thoroughness) -> Attempt<Study> {
    let finest = run::run(&refined(plan, None, FINEST)?, Wanted::NOTHING)?;
    let coarse = run::run(&refined(plan, None, COARSER[0])?, Wanted::NOTHING)?;
    let exact = numbers(&finest);
    let method = |name, setting, refined: Result<Plan, SimulationError>| {
        let exact = exact.clone();
        Method::new(name, setting, move || {
            let (plan, exact) = (refined.clone()?, exact.clone());
            Ok(move || solved(&plan, &exact))
        })
    };
    // An error that does not change with the accuracy asked for is that of a path without steps.
    let free = coarse.error_estimate == finest.error_estimate;
    let accuracies = if free { &COARSER[4..] } else { &COARSER[..] };
    let mut methods: Vec<Method> = Vec::new();
    methods
        .extend(accuracies.iter().map(|&asked| method(finest.plan.solver, Setting::FREE, refined(plan, None, asked))));
    // A scene that cannot be computed on springs says so once.
    let takes = refined(plan, NonZeroUsize::new(10), FINEST).is_ok();
    let counts = effort.decades(1, 5).take(if takes { usize::MAX } else { 1 });
    methods.extend(
        counts.map(|count| method("springs", Setting::springs(count), refined(plan, NonZeroUsize::new(count), FINEST))),
    );
    let title = if plan.scene.title.is_empty() { "scene" } else { &plan.scene.title };
    let solver = finest.plan.solver;
    let reference = if free { format!("the {solver} path") } else { format!("the same solver asked for {FINEST:.0e}") };
    Ok(Study {
        case: "scene",
        about: format!("{title}: all named results"),
        quantity: "results",
        reference,
        exact: Computed { values: vec![1.0; exact.len()], ..Computed::default() },
        methods,
    })
}

/// The scene with other springs and another accuracy.
fn refined(plan: &Plan, springs: Option<NonZeroUsize>, accuracy: f64) -> Result<Plan, SimulationError> {
    let accuracy = Accuracy::new(accuracy).map_err(|error| SimulationError::Refused(error.to_string()))?;
    Ok(plan.with(SceneSettings { springs, accuracy: Some(accuracy), ..plan.settings() })?)
}

/// Named results that are numbers above the noise of a sum that should vanish.
fn numbers(outcome: &Outcome) -> Vec<(String, f64)> {
    let number = |named: &Named| match named.finding {
        Finding::Number(number) if number.is_finite() && number.abs() > 1e-30 => Some((named.name(), number)),
        Finding::Number(_) | Finding::Answer(_) | Finding::Count(_) => None,
    };
    let noise = |named: &&Named| matches!(named.quantity, "work" | "dissipated");
    outcome.results.iter().filter(|named| !noise(named)).filter_map(number).collect()
}

fn solved(plan: &Plan, exact: &[(String, f64)]) -> Attempt<Computed> {
    let outcome = run::run(plan, Wanted::NOTHING)?;
    let values = exact.iter().map(|(name, right)| Ok(result(&outcome, name)? / right));
    Ok(Computed { values: values.collect::<Attempt<_>>()?, bytes: outcome.plan.state_bytes, ..Computed::default() })
}
