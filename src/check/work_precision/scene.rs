//! Any scene: its own solver at several accuracies, and beds of springs.

use super::{Answer, Effort, Method, Setting, Study};
use crate::input::quantity::Accuracy;
use crate::run::named::{Finding, Named};
use crate::run::record::Outcome;
use crate::run::{self, SimulationError, Wanted};
use crate::scene::plan::Plan;
use crate::scene::plan::SceneSettings;
use std::num::NonZeroUsize;

/// Accuracy of the reference.
const FINEST: f64 = 1e-8;

/// A scene by its own solver and by beds of springs, against its own solver at its finest.
///
/// The numbers compared are all named results, each relative to its own reference.
///
/// # Errors
/// The scene cannot be run.
pub fn study(setup: &Plan, effort: Effort) -> Result<Study, SimulationError> {
    let own = refined(setup, None, FINEST)?;
    let outcome = run::run(&own, Wanted::NOTHING)?;
    let exact = numbers(&outcome);
    let direct = outcome.plan.solver == "direct";
    let accuracies: &[f64] = if direct { &[1e-6] } else { &[1e-2, 1e-3, 1e-4, 1e-5, 1e-6] };
    let method = |name, setting, setup: Plan| {
        let exact = exact.clone();
        Method::new(name, setting, move || {
            let (setup, exact) = (setup.clone(), exact.clone());
            Some(move || answer(&run::run(&setup, Wanted::NOTHING).ok()?, &exact))
        })
    };
    let mut methods = Vec::new();
    for &accuracy in accuracies {
        methods.push(method(outcome.plan.solver, Setting::FREE, refined(setup, None, accuracy)?));
    }
    if own.direct().is_some() {
        for count in effort.decades(1, 5) {
            // A scene that cannot be computed on springs is refused under any number of them.
            let Ok(plan) = refined(setup, NonZeroUsize::new(count), FINEST) else { break };
            methods.push(method("springs", Setting::springs(count), plan));
        }
    }
    let title = if setup.scene.title.is_empty() { "scene" } else { &setup.scene.title };
    let reference =
        if direct { "the direct path".to_owned() } else { format!("the same solver asked for {FINEST:.0e}") };
    let values = vec![1.0; exact.len()];
    Ok(Study {
        case: "scene",
        about: format!("{title}: all named results"),
        quantity: "results",
        reference,
        orders: &[1.0, 2.0],
        exact: Answer { values, ..Answer::default() },
        methods,
    })
}

/// The scene with other springs and another accuracy.
fn refined(setup: &Plan, springs: Option<NonZeroUsize>, accuracy: f64) -> Result<Plan, SimulationError> {
    Ok(setup.with(SceneSettings { springs, accuracy: Accuracy::new(accuracy).ok(), ..setup.settings() })?)
}

/// Named results that are numbers above the noise of a sum that should vanish.
fn numbers(outcome: &Outcome) -> Vec<(String, f64)> {
    let number = |named: &Named| match named.finding {
        Finding::Number(number) if number.is_finite() && number.abs() > 1e-30 => Some((named.name(), number)),
        _ => None,
    };
    let noise = |named: &&Named| matches!(named.quantity, "work" | "dissipated");
    outcome.results.iter().filter(|named| !noise(named)).filter_map(number).collect()
}

fn answer(outcome: &Outcome, exact: &[(String, f64)]) -> Option<Answer> {
    let values = exact.iter().map(|(name, right)| Some(outcome.number(name)? / right));
    Some(Answer { values: values.collect::<Option<_>>()?, bytes: outcome.plan.state_bytes, ..Answer::default() })
}
