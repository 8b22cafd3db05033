//! The cases as VALIDATION.md.

use crate::check::case::{Case, Question};
use crate::check::row::Row;
use std::fmt::Write;

const HEAD: &str = "\
# Validation

Every case with a known answer: how it is proved, the largest relative error allowed and why, the
error reached, and where the case is weak. Strengths of proof, strongest first: *rounding* (an
identity or a limit), *bound* (a proved constant), *order* (a rate of convergence), *other method*
(another code, another method or a finer grid), *self* (detects change only).

Made by `springbed verify --markdown --measure > VALIDATION.md`; `springbed verify` shows the same cases
on your machine. A test keeps names, proofs, bounds and remarks true, and the errors reached within
their bounds; the last digit of an error reached may differ from machine to machine.
";

const COMBINATIONS: &str = "\
## Combinations

Which shape, bodies, adhesion, friction and drive are computed together (`springbed explain
--matrix`). What is computed has a letter for the solver and one for the strength of the proof: `Ar`
is solver A, proved to rounding. The strength is that of the part which is proved least: by a case
above, or by the laws that random scenes of all combinations are held against (*other method*). A
number is the reason of a refusal; `-` is no combination of its own. Rows in which nothing is computed
stand in one line with all their reasons; `--json` has each by itself, with the cases that prove it.
The scene of each combination, written for an error of 1e-3, is computed (`--measure`) and the decade
of its error told, `Ar-13` for 1e-13 to 1e-12: beside the closed form of a ball, else beside
the same scene at 1e-6, and what it says of itself where that makes no difference and on pixels.
Rough lines stand on 512 points and rough surfaces on 32² pixels there, so that all is done in minutes,
and single asperities jump in and off: decades of 1e-1 and 1e0 are theirs. A test runs one scene of
every combination that is computed; random ones are held against laws by `cargo run --release -p
benches --example random_scenes`.";

/// The text of VALIDATION.md, with the matrix of all combinations in words.
#[must_use]
pub fn validation(cases: &[Case], rows: &[Row], matrix: &str) -> String {
    let mut text = HEAD.to_owned();
    let mut group = "";
    for (case, row) in cases.iter().zip(rows) {
        let (of, name) = case.name.split_once('/').unwrap_or((case.name, case.name));
        if of != group {
            let _ = writeln!(text, "\n## {of}\n\n| case | proof | bound | reached | why this bound | weak where |");
            text.push_str("|---|---|---|---|---|---|\n");
            group = of;
        }
        let (proof, bound) = (case.proof.word(), case.bound);
        let reached = row.error.map_or_else(|| row.why.clone().unwrap_or_default(), |error| format!("{error:.0e}"));
        let (because, weak) = match &case.question {
            Question::Over(over) => {
                (format!("{}; {}", over.against, case.because), format!("tried over {}", over.range))
            }
            Question::Numbers(_) | Question::Stated(_) => (case.because.to_owned(), case.weak.to_owned()),
        };
        // A text that ends no cell of a table.
        let [because, weak] = [because, weak].map(|text| text.replace('|', "\\|"));
        let _ = writeln!(text, "| {name} | {proof} | {bound:e} | {reached} | {because} | {weak} |");
    }
    let _ = writeln!(text, "\n{COMBINATIONS}\n\n```text\n{matrix}\n```");
    text
}
