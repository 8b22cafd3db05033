//! The short table printed after a run.

use crate::run::named::{Finding, Named};
use crate::run::record::Outcome;
use std::fmt::Write;

const PREFIXES: [(f64, &str); 11] = [
    (1e12, "T"),
    (1e9, "G"),
    (1e6, "M"),
    (1e3, "k"),
    (1.0, ""),
    (1e-3, "m"),
    (1e-6, "µ"),
    (1e-9, "n"),
    (1e-12, "p"),
    (1e-15, "f"),
    (1e-18, "a"),
];

/// The named results as aligned lines, with SI prefixes.
#[must_use]
pub fn summary(title: &str, outcome: &Outcome) -> String {
    let mut text = String::new();
    let rows: Vec<(String, String)> = outcome.results.iter().map(row).collect();
    let width = rows.iter().map(|row| row.0.chars().count()).max().unwrap_or(0);
    if !title.is_empty() {
        let _ = writeln!(text, "{title}");
    }
    for (name, value) in rows {
        let _ = writeln!(text, "  {name:width$}  {value}");
    }
    let estimate = &outcome.error_estimate;
    let _ = writeln!(text, "  {:width$}  {:.0e} ({})", "relative error", estimate.relative, estimate.basis);
    text
}

fn row(named: &Named) -> (String, String) {
    let symbol = named.unit.symbol;
    let shown = match named.finding {
        Finding::Number(number) if named.unit.prefixed => with_prefix(number, symbol),
        Finding::Number(number) => format!("{} {symbol}", digits(number)),
        Finding::Answer(_) | Finding::Count(_) => named.finding.to_string(),
    };
    (named.quantity.replace('_', " "), shown.trim_end().to_owned())
}

/// A number with six digits and an SI prefix, such as `30.7692 N`.
#[must_use]
pub fn with_prefix(number: f64, unit: &str) -> String {
    let size = number.abs();
    if size <= 0.0 {
        return format!("0 {unit}");
    }
    // A number that rounds up to 1000 belongs to the next prefix.
    match PREFIXES.iter().find(|prefix| size * (1.0 + 5e-7) >= prefix.0) {
        Some(prefix) if size < 1e15 => format!("{} {}{unit}", digits(number / prefix.0), prefix.1),
        _ => format!("{number:.5e} {unit}"),
    }
}

/// Six significant digits without trailing zeros.
fn digits(number: f64) -> String {
    if number.abs() <= 0.0 {
        return "0".to_owned();
    }
    let exponent = number.abs().log10().floor();
    if !(-5.0..7.0).contains(&exponent) {
        return format!("{number:.5e}");
    }
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "between 0 and 10")]
    let decimals = (5.0 - exponent).clamp(0.0, 10.0) as usize;
    let text = format!("{number:.decimals$}");
    if text.contains('.') { text.trim_end_matches('0').trim_end_matches('.').to_owned() } else { text }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_carry_their_prefix() {
        assert_eq!(with_prefix(30.769_230_769, "N"), "30.7692 N");
        assert_eq!(with_prefix(1e-4, "m"), "100 µm");
        assert_eq!(with_prefix(1.469e9, "Pa"), "1.469 GPa");
        assert_eq!(with_prefix(-0.000_999_999_9, "N"), "-1 mN");
        assert_eq!(with_prefix(0.0, "J"), "0 J");
        assert_eq!(with_prefix(1e30, "J"), "1.00000e30 J");
    }
}
