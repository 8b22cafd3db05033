//! `springbed verify`: every case against its exact answer.

use super::Common;
use crate::app::console::{Console, Failure};
use crate::app::export;
use crate::check::case::{Case, Verdict};
use crate::check::cases;
use crate::text::nearest;
use rayon::prelude::*;
use std::collections::BTreeSet;

/// How the verdicts are shown.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Form {
    /// A table for a person.
    Table,
    /// The text of VALIDATION.md.
    Markdown,
    /// JSON.
    Json,
}

impl Form {
    /// The form the common flags ask for.
    #[must_use]
    pub fn of(common: &Common) -> Self {
        if common.json { Self::Json } else { Self::Table }
    }
}

/// Runs the cases whose name contains `filter`, on all threads, and shows them in their order.
///
/// # Errors
/// No case has such a name, or a case is outside its bound.
pub fn run(filter: &str, form: Form, console: &Console) -> Result<(), Failure> {
    let cases = cases::matching(filter);
    if cases.is_empty() {
        return Err(Failure::Usage(unmatched(filter)));
    }
    let progress = console.progress(cases.len(), "cases");
    let verdicts: Vec<Verdict> = cases.par_iter().map(Case::verdict).inspect(|_| progress.inc(1)).collect();
    progress.finish_and_clear();
    match form {
        Form::Table => console.say(&export::verdict_table(&verdicts))?,
        Form::Markdown => console.result(&export::validation(&cases, &verdicts))?,
        Form::Json => console.result(&json(&verdicts)?)?,
    }
    outcome(&verdicts)
}

fn json(verdicts: &[Verdict]) -> Result<String, Failure> {
    let passed = verdicts.iter().all(|verdict| verdict.passed);
    let value = serde_json::json!({ "passed": passed, "cases": verdicts });
    serde_json::to_string_pretty(&value).map_err(Failure::failed)
}

fn outcome(verdicts: &[Verdict]) -> Result<(), Failure> {
    let failed: Vec<&str> = verdicts.iter().filter(|verdict| !verdict.passed).map(|verdict| verdict.name).collect();
    if failed.is_empty() {
        return Ok(());
    }
    Err(Failure::Failed(format!(
        "{} of {} cases outside their bounds: {}",
        failed.len(),
        verdicts.len(),
        failed.join(", ")
    )))
}

/// What to say of a filter that no name contains: the nearest word of a name, and the groups.
fn unmatched(filter: &str) -> String {
    let names: Vec<&'static str> = cases::all().iter().map(|case| case.name).collect();
    let words = names.iter().flat_map(|name| {
        let parts = name.split('/');
        let single = name.split(|letter: char| !letter.is_alphanumeric()).filter(|word| word.chars().count() > 2);
        parts.chain(single).chain([*name])
    });
    let words: Vec<&str> = words.collect();
    let groups: BTreeSet<&str> = names.iter().filter_map(|name| name.split('/').next()).collect();
    let groups = groups.into_iter().collect::<Vec<_>>().join(", ");
    match nearest(filter, &words) {
        Some(word) => format!("no case has `{filter}` in its name: did you mean `{word}`? Groups: {groups}"),
        None => format!("no case has `{filter}` in its name: expected a part of a name; groups: {groups}"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_filter_without_a_match_names_a_near_one_and_the_groups() {
        for (wrong, near) in [("jrk", "`jkr`"), ("hertz/stel ball", "`hertz/steel ball`"), ("evelope", "`envelope`")] {
            let said = unmatched(wrong);
            assert!(said.contains(near) && said.contains("Groups: ") && said.contains("hertz, "), "{said}");
        }
        assert!(unmatched("zzzzzzzzzz").contains("expected a part of a name"));
    }

    #[test]
    fn a_case_outside_its_bound_is_named() {
        let mut verdicts = cases::verdicts("hertz/steel ball");
        assert!(outcome(&verdicts).is_ok());
        verdicts[0].passed = false;
        assert!(matches!(outcome(&verdicts), Err(Failure::Failed(text)) if text.contains("hertz/steel ball")));
    }
}
