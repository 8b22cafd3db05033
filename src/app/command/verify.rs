//! `springbed verify`: every case against its exact answer.

use super::explain::Errors;
use super::{Common, report};
use crate::app::console::{Console, Failure};
use crate::app::export::{self, reports};
use crate::app::progress::Progress;
use crate::check::cases;
use crate::check::row::Row;
use crate::text::nearest;
use std::collections::BTreeSet;

/// How the verdicts are shown.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Form {
    /// A table for a person.
    Table,
    /// The text of VALIDATION.md, and what its matrix says of errors.
    Markdown(Errors),
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
    let progress = Progress::of("verify", console);
    let rows = report::verdicts(&cases, &|share| progress.done(share));
    drop(progress);
    match form {
        Form::Table => console.say(&reports::verdict_table(&rows))?,
        Form::Markdown(errors) => console.result(&export::validation(&cases, &rows, &errors.matrix()))?,
        Form::Json => console.result(&json(&rows)?)?,
    }
    outcome(&rows)
}

fn json(rows: &[Row]) -> Result<String, Failure> {
    let passed = rows.iter().all(Row::passed);
    let value = serde_json::json!({ "passed": passed, "cases": reports::objects(reports::VERDICTS, rows) });
    serde_json::to_string_pretty(&value).map_err(Failure::failed)
}

fn outcome(rows: &[Row]) -> Result<(), Failure> {
    let failed = report::beyond(rows);
    if failed.is_empty() {
        return Ok(());
    }
    let all = rows.len();
    Err(Failure::Failed(format!("{} of {all} cases outside their bounds: {}", failed.len(), failed.join(", "))))
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
        let mut row = cases::matching("hertz/steel ball")[0].verdict();
        assert!(outcome(std::slice::from_ref(&row)).is_ok());
        row.error = Some(1.0);
        assert!(matches!(outcome(&[row]), Err(Failure::Failed(text)) if text.contains("hertz/steel ball")));
    }
}
