//! Verdicts on the cases, for a person and as VALIDATION.md.

use crate::check::case::{Case, Verdict};
use std::fmt::Write;

/// The group of a case and its name within.
fn parts(name: &str) -> (&str, &str) {
    name.split_once('/').unwrap_or((name, name))
}

/// The verdicts in aligned lines, one block per group.
#[must_use]
pub fn verdict_table(verdicts: &[Verdict]) -> String {
    let width = verdicts.iter().map(|verdict| parts(verdict.name).1.chars().count()).max().unwrap_or(0);
    let mut text = String::new();
    let mut group = "";
    for verdict in verdicts {
        let (of, name) = parts(verdict.name);
        if of != group {
            let _ = writeln!(text, "{of}");
            group = of;
        }
        let word = if verdict.passed { "ok" } else { "FAILED" };
        let (error, bound, proof) = (verdict.error, verdict.bound, verdict.proof.word());
        let _ = writeln!(text, "  {name:width$}  {error:>8.1e}  at most {bound:<7.0e}  {proof:<12}  {word}");
    }
    let passed = verdicts.iter().filter(|verdict| verdict.passed).count();
    let _ = writeln!(text, "{passed} of {} cases within their bounds", verdicts.len());
    text
}

const HEAD: &str = "\
# Validation

Every case with a known answer: how it is proved, the largest relative error allowed and why, the
error reached, and where the case is weak. Strengths of proof, strongest first: *rounding* (an
identity or a limit), *bound* (a proved constant), *order* (a rate of convergence), *other method*
(another code, another method or a finer grid), *self* (detects change only).

Made by `springbed verify --markdown > VALIDATION.md`; `springbed verify` shows the same cases on
your machine. A test keeps names, proofs, bounds and remarks true, and the errors reached within
their bounds; the last digit of an error reached may differ from machine to machine.
";

/// The text of VALIDATION.md.
#[must_use]
pub fn validation(cases: &[Case], verdicts: &[Verdict]) -> String {
    let mut text = HEAD.to_owned();
    let mut group = "";
    for (case, verdict) in cases.iter().zip(verdicts) {
        let (of, name) = parts(case.name);
        if of != group {
            let _ = writeln!(text, "\n## {of}\n\n| case | proof | bound | reached | why this bound | weak where |");
            text.push_str("|---|---|---|---|---|---|\n");
            group = of;
        }
        let proof = case.proof.word();
        let (bound, reached) = (case.bound, verdict.error);
        let (reason, weak) = (cell(case.reason), cell(case.weak));
        let _ = writeln!(text, "| {name} | {proof} | {bound:e} | {reached:.0e} | {reason} | {weak} |");
    }
    text
}

/// A text that ends no cell of a table.
fn cell(text: &str) -> String {
    text.replace('|', "\\|")
}
