//! Rows of the reports as lines for a person, CSV and JSON: each form reads the same columns.

use crate::app::machine::Machine;
use crate::check::row::{Row, Setting};
use crate::check::study::Study;
use serde_json::{Map, Value, json};
use std::fmt::Write;

/// A column of a report: its name, and the cell of a row.
pub type Heading = (&'static str, fn(&Row) -> Value);

/// Cases against their bounds.
pub const VERDICTS: &[Heading] = &[
    ("name", |row| row.case.into()),
    ("proof", |row| json!(row.proof)),
    ("error", |row| row.error.into()),
    ("bound", |row| row.bound.into()),
    ("passed", |row| row.passed().into()),
    ("why", |row| json!(row.why)),
];

/// The errors scenes are asked for, state, and have.
pub const STATED: &[Heading] = &[
    ("scene", |row| row.case.into()),
    ("solver", |row| row.method.into()),
    ("springs", |row| row.setting.springs.unwrap_or(0).into()),
    ("asked", |row| row.setting.accuracy.into()),
    ("estimated", |row| row.bound.into()),
    ("error", |row| row.error.into()),
    ("kept", |row| row.passed().into()),
    ("why", |row| json!(row.why)),
];

/// Error and time of the ways to compute a case.
pub const ACCURACY: &[Heading] = &[
    ("case", |row| row.case.into()),
    ("method", |row| row.method.into()),
    ("springs", |row| row.setting.springs.into()),
    ("grid", |row| row.setting.grid.into()),
    ("steps", |row| row.setting.steps.into()),
    ("error", |row| row.error.into()),
    ("radius_error", |row| row.errors.radius.map(f64::abs).into()),
    ("pressure_error", |row| row.errors.pressure.map(f64::abs).into()),
    ("time_s", |row| row.times.map(|times| times.warm).into()),
    ("setup_s", |row| row.times.map(|times| times.setup).into()),
    ("first_s", |row| row.times.map(|times| times.first).into()),
    ("bytes", |row| row.solved.bytes.into()),
    ("iterations", |row| row.solved.iterations.into()),
    ("why", |row| json!(row.why)),
];

/// Ranges of stiff and extreme values.
pub const STABILITY: &[Heading] = &[
    ("name", |row| name(row).into()),
    ("range", |row| row.over.map(|over| over.range).into()),
    ("against", |row| row.over.map(|over| over.against).into()),
    ("whose", |row| if held(row) { "ours" } else { "usual" }.into()),
    ("tried", |row| row.tried.into()),
    ("worst", |row| row.error.into()),
    ("bound", |row| row.bound.into()),
    ("broken", |row| row.broken.into()),
    ("passed", |row| row.passed().into()),
    ("why", |row| json!(row.why)),
];

/// Throughput of the kernels.
pub const SPEED: &[Heading] = &[
    ("kernel", |row| row.method.into()),
    ("counted", |row| row.setting.counted.map(|counted| counted.0).into()),
    ("size", |row| row.setting.counted.map(|counted| counted.1).into()),
    ("time_s", |row| row.times.map(|times| times.warm).into()),
    ("each_s", |row| each(row).into()),
    ("beside", |row| row.beside.map_or("", |beside| beside.0).into()),
    ("ratio", |row| row.beside.map(|beside| beside.1).into()),
    ("why", |row| json!(row.why)),
];

/// The name of a case within its group.
fn name(row: &Row) -> &'static str {
    row.case.split_once('/').map_or(row.case, |parts| parts.1)
}

/// Whether it is held to a bound; the usual way is only shown.
fn held(row: &Row) -> bool {
    row.bound.is_some_and(f64::is_finite)
}

/// Time of one of what is counted [s].
#[expect(clippy::cast_precision_loss, reason = "sizes are far below 2^53")]
fn each(row: &Row) -> Option<f64> {
    Some(row.times?.warm / row.setting.counted?.1 as f64)
}

/// The rows as JSON objects; a reason stands only where there is one.
#[must_use]
pub fn objects(headings: &[Heading], rows: &[Row]) -> Vec<Value> {
    let cell =
        |row, &(name, of): &Heading| Some((name.to_owned(), of(row))).filter(|cell| name != "why" || !cell.1.is_null());
    let object = |row| Value::Object(headings.iter().filter_map(|heading| cell(row, heading)).collect::<Map<_, _>>());
    rows.iter().map(object).collect()
}

/// The rows as CSV; a value that does not exist is empty.
///
/// # Errors
/// The table cannot be put together (never for rows of a report).
pub fn csv(headings: &[Heading], rows: &[Row]) -> Result<String, csv::Error> {
    let mut writer = csv::Writer::from_writer(Vec::new());
    let said = |heading: &&Heading| heading.0 != "why" || rows.iter().any(|row| row.why.is_some());
    let headings: Vec<&Heading> = headings.iter().filter(said).collect();
    writer.write_record(headings.iter().map(|heading| heading.0))?;
    for row in rows {
        writer.write_record(headings.iter().map(|heading| match heading.1(row) {
            Value::Null => String::new(),
            Value::String(text) => text,
            value => value.to_string(),
        }))?;
    }
    super::tables::text(writer)
}

/// Lines of cells below each other: the first and the last column to the left, the others to the right.
#[must_use]
pub fn aligned(lines: &[Vec<String>]) -> String {
    let columns = lines.iter().map(Vec::len).max().unwrap_or(0);
    let width = |at: usize| lines.iter().filter_map(|line| line.get(at)).map(|cell| cell.chars().count()).max();
    let widths: Vec<usize> = (0..columns).map(|at| width(at).unwrap_or(0)).collect();
    let mut text = String::new();
    for line in lines {
        let cells = line.iter().zip(&widths).enumerate().map(|(at, (cell, width))| match at {
            at if at == 0 || at + 1 == columns => format!("{cell:width$}"),
            _ => format!("{cell:>width$}"),
        });
        let _ = writeln!(text, "  {}", cells.collect::<Vec<_>>().join("  ").trim_end());
    }
    text
}

fn words<const N: usize>(words: [&str; N]) -> Vec<String> {
    words.map(str::to_owned).to_vec()
}

/// `ok`, or what is wrong.
fn word(row: &Row) -> String {
    match &row.why {
        Some(why) => format!("FAILED: {why}"),
        None if row.passed() => "ok".to_owned(),
        None => "FAILED".to_owned(),
    }
}

fn small(error: Option<f64>) -> String {
    error.map_or_else(String::new, |error| format!("{error:.1e}"))
}

/// The verdicts on cases, one block per group.
#[must_use]
pub fn verdict_table(rows: &[Row]) -> String {
    let mut text = String::new();
    let group = |row: &Row| row.case.split('/').next().unwrap_or_default();
    let line = |row: &Row| {
        let proof = row.proof.map_or("", |proof| proof.word());
        let bound = row.bound.map_or_else(String::new, |bound| format!("at most {bound:.0e}"));
        vec![name(row).to_owned(), small(row.error), bound, format!("{proof}  {}", word(row))]
    };
    let lines = aligned(&rows.iter().map(line).collect::<Vec<_>>());
    let mut before = "";
    for (row, line) in rows.iter().zip(lines.lines()) {
        if group(row) != before {
            before = group(row);
            let _ = writeln!(text, "{before}");
        }
        let _ = writeln!(text, "{line}");
    }
    let passed = rows.iter().filter(|row| row.passed()).count();
    let _ = writeln!(text, "{passed} of {} cases within their bounds", rows.len());
    text
}

/// Errors asked for, stated and true.
#[must_use]
pub fn stated_table(rows: &[Row]) -> String {
    let line = |row: &Row| {
        let springs = row.setting.springs.map_or_else(String::new, |count| count.to_string());
        let asked = row.setting.accuracy.map_or_else(String::new, |asked| format!("{asked:.0e}"));
        let cells = [name(row), row.method, &springs, &asked, &small(row.bound), &small(row.error), &word(row)];
        words(cells)
    };
    let head = words(["", "", "springs", "asked", "estimated", "true", ""]);
    let lines: Vec<_> = std::iter::once(head).chain(rows.iter().map(line)).collect();
    format!("errors asked for, estimated and true\n{}", aligned(&lines))
}

/// Error and time of the ways to compute cases; `rows` are those of each study.
#[must_use]
pub fn accuracy_table(studies: &[Study], rows: &[Vec<Row>], machine: &Machine) -> String {
    let mut text = String::new();
    for (study, rows) in studies.iter().zip(rows) {
        let _ = writeln!(text, "{}: {}; errors against: {}", study.case, study.about, study.reference);
        let head = words(["", "", "error", "time", "set-up", "first", "bytes", ""]);
        let lines: Vec<_> = std::iter::once(head).chain(rows.iter().map(way)).collect();
        text.push_str(&aligned(&lines));
    }
    let _ = writeln!(text, "{}; one solver at a time, least time of warm repeats", machine.line());
    text
}

fn way(row: &Row) -> Vec<String> {
    let time =
        |of: fn(crate::check::clock::Times) -> f64| row.times.map_or_else(String::new, |times| seconds(of(times)));
    let times = [time(|times| times.warm), time(|times| times.setup), time(|times| times.first)];
    let why = row.why.as_ref().map_or_else(String::new, |why| format!("no answer: {why}"));
    let first = [row.method.to_owned(), fineness(&row.setting), small(row.error)];
    first.into_iter().chain(times).chain([row.solved.bytes.to_string(), why]).collect()
}

/// Stiff and extreme values, the range and what it is held against below each.
#[must_use]
pub fn stability_table(rows: &[Row], machine: &Machine) -> String {
    let line = |row: &Row| {
        let bound = row.bound.filter(|_| held(row)).map_or("–".to_owned(), |bound| format!("{bound:.0e}"));
        let word = if held(row) { word(row) } else { "the usual way".to_owned() };
        let (tried, broken) = (row.tried.to_string(), row.broken.to_string());
        words([name(row), &tried, &small(row.error), &bound, &broken, &word])
    };
    let head = words(["", "scenes", "worst error", "bound", "broken", ""]);
    let lines: Vec<_> = std::iter::once(head).chain(rows.iter().map(line)).collect();
    let table = aligned(&lines);
    let below = rows.iter().map(|row| row.over.map(|over| format!("      {}\n      {}\n", over.range, over.against)));
    let below = std::iter::once(None).chain(below).map(Option::unwrap_or_default);
    let text: String = table.lines().zip(below).map(|(line, below)| format!("{line}\n{below}")).collect();
    format!("{text}{}\n", machine.line())
}

/// Throughput of the kernels.
#[must_use]
pub fn speed_table(rows: &[Row], machine: &Machine) -> String {
    let line = |row: &Row| {
        let (counted, size) = row.setting.counted.unwrap_or(("", 1));
        let time = row.times.map_or_else(String::new, |times| seconds(times.warm));
        let each = each(row).map_or_else(String::new, |time| format!("{} each", seconds(time)));
        let ratio = row.beside.map(|(what, ratio)| format!("{ratio:.2} times {what}"));
        let last = row.why.as_ref().map(|why| format!("FAILED: {why}")).or(ratio).unwrap_or_default();
        words([row.method, &size.to_string(), counted, &time, &each, &last])
    };
    let lines: Vec<_> = rows.iter().map(line).collect();
    format!("{}{}; one kernel at a time, least time of warm repeats\n", aligned(&lines), machine.line())
}

/// A time with three digits and its prefix.
fn seconds(time: f64) -> String {
    let (size, unit) = match time {
        t if t >= 1.0 => (t, "s"),
        t if t >= 1e-3 => (1e3 * t, "ms"),
        t if t >= 1e-6 => (1e6 * t, "µs"),
        t => (1e9 * t, "ns"),
    };
    let decimals = if size < 9.995 {
        2
    } else if size < 99.95 {
        1
    } else {
        0
    };
    format!("{size:.decimals$} {unit}")
}

/// Springs, pixels and steps in few letters.
fn fineness(setting: &Setting) -> String {
    let part = |count: Option<usize>, of: fn(usize) -> String| count.map(of);
    let parts = [
        part(setting.springs, |n| n.to_string()),
        part(setting.grid, |n| format!("{n}²")),
        part(setting.steps, |n| format!("/{n}")),
    ];
    parts.into_iter().flatten().collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn times_carry_three_digits_and_their_prefix() {
        for (time, text) in [(2.5, "2.50 s"), (0.012_34, "12.3 ms"), (1.234e-4, "123 µs"), (9.999e-7, "1000 ns")] {
            assert_eq!(seconds(time), text);
        }
    }

    #[test]
    fn a_row_without_an_answer_says_why_in_every_form() {
        let row = Row { case: "hertz/ball", bound: Some(1e-14), ..Row::of(Err("no contact".into())) };
        let rows = [row, Row { case: "hertz/cone", bound: Some(1e-14), ..Row::of(Ok(0.0)) }];
        assert!(verdict_table(&rows).contains("FAILED: no contact") && verdict_table(&rows).contains("1 of 2 cases"));
        assert!(csv(VERDICTS, &rows).unwrap().contains("hertz/ball,,,1e-14,false,no contact"));
        let objects = objects(VERDICTS, &rows);
        assert!(objects[0]["why"] == "no contact" && objects[0]["error"].is_null() && objects[1].get("why").is_none());
    }
}
