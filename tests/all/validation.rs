//! VALIDATION.md says what the cases are.

use springbed::app::export::validation;
use springbed::check::{case::Case, cases, matrix};

/// Column of the error reached.
const REACHED: usize = 4;

/// Cells of a row of a table; the borders count as cells.
fn cells(line: &str) -> Vec<String> {
    line.split(" | ").map(|cell| cell.trim_matches(['|', ' ']).to_owned()).collect()
}

fn is_case(line: &str) -> bool {
    line.starts_with("| ") && !line.starts_with("| case ")
}

/// A mark of the matrix, such as `Ar-13`, without the decade of the error; any other word as it is.
fn without_decade(word: &str) -> &str {
    let mark = word.get(..2).filter(|mark| mark.chars().all(|letter| letter.is_ascii_alphabetic()));
    mark.filter(|_| word[2..].parse::<i32>().is_ok()).unwrap_or(word)
}

/// The text with the errors reached left out: they differ in the last digit from machine to machine.
fn without_reached(text: &str) -> Vec<Vec<String>> {
    let row = |line: &str| {
        if !is_case(line) {
            return line.split_whitespace().map(|word| without_decade(word).to_owned()).collect();
        }
        let mut cells = cells(line);
        cells.remove(REACHED - 1);
        cells
    };
    text.lines().map(row).collect()
}

#[test]
fn the_file_names_every_case_with_its_proof_bound_and_weakness() {
    let written = std::fs::read_to_string(concat!(env!("CARGO_MANIFEST_DIR"), "/VALIDATION.md")).unwrap();
    let cases = cases::all();
    let verdicts: Vec<_> = cases.iter().map(Case::verdict).collect();
    let fresh = validation(&cases, &verdicts, &matrix::in_words(&matrix::cells()));
    let (written, fresh) = (without_reached(&written), without_reached(&fresh));
    for (line, (written, fresh)) in written.iter().zip(&fresh).enumerate() {
        assert!(written == fresh, "line {}: {written:?}, now {fresh:?}: {MEND}", line + 1);
    }
    assert!(written.len() == fresh.len(), "{} lines, now {}: {MEND}", written.len(), fresh.len());
}

#[test]
fn every_error_in_the_file_is_within_its_bound() {
    let written = std::fs::read_to_string(concat!(env!("CARGO_MANIFEST_DIR"), "/VALIDATION.md")).unwrap();
    let mut rows = 0;
    for line in written.lines().filter(|line| is_case(line)) {
        let cells = cells(line);
        let [bound, reached] = [REACHED - 2, REACHED - 1].map(|column| cells[column].parse::<f64>().unwrap());
        // One digit of the error is written; rounded up it may pass the bound by half a unit.
        assert!(reached <= 1.5 * bound, "{line}");
        rows += 1;
    }
    assert_eq!(rows, cases::all().len());
}

const MEND: &str = "`cargo run --release -- verify --markdown --measure > VALIDATION.md` writes it anew";
