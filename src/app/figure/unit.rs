//! Prefixes of SI units, chosen so that the largest value shown lies between 1 and 1000.

use super::text;

const PREFIXES: [(i32, &str); 12] = [
    (-18, "a"),
    (-15, "f"),
    (-12, "p"),
    (-9, "n"),
    (-6, "µ"),
    (-3, "m"),
    (0, ""),
    (3, "k"),
    (6, "M"),
    (9, "G"),
    (12, "T"),
    (15, "P"),
];

/// Exponent n of the factor 10ⁿ taken out of the numbers on an axis whose largest magnitude is `largest` (SI).
pub(super) fn exponent(unit: &str, largest: f64) -> i32 {
    // a rounding below 1 µm is 1 µm, not 1000 nm
    let largest = largest * (1.0 + 1e-9);
    if largest <= 0.0 || plain(unit, largest) {
        return 0;
    }
    let step = 3 * power_of(unit);
    let wanted = step * decade(largest).div_euclid(step);
    // A volume of 10⁶ µm³ is 10⁻¹² m³, not 10⁻³ mm³.
    let fits = prefix(unit, wanted).is_some() && decade(largest) - wanted < MOST_DIGITS;
    if fits { wanted } else { 3 * decade(largest).div_euclid(3) }
}

/// Digits before the point that are still read at a glance.
const MOST_DIGITS: i32 = 5;

/// Whether the numbers need no factor: pure numbers near 1, seconds and metres without large prefixes.
fn plain(unit: &str, largest: f64) -> bool {
    match unit {
        "1" | "" | "%" | "°" => (1e-3..1e5).contains(&largest),
        "s" => (1.0..1e5).contains(&largest),
        _ => false,
    }
}

/// Floor of the decimal logarithm, exact at powers of ten.
pub(super) fn decade(value: f64) -> i32 {
    let text = format!("{value:e}");
    let exponent = text.split_once('e').and_then(|(_, e)| e.parse().ok());
    exponent.unwrap_or(0)
}

/// Letter of the factor 10ⁿ before `unit`, if there is one in use.
fn prefix(unit: &str, n: i32) -> Option<&'static str> {
    let highest = match unit {
        "1" | "" | "%" | "°" => return (n == 0).then_some(""),
        u if u.starts_with("kg") || u.starts_with('1') || u.starts_with('°') => 0,
        "s" => 0,
        u if u.starts_with('m') => 3,
        _ => 15,
    };
    let lowest = if unit.starts_with("kg") || unit.starts_with('1') { 0 } else { -18 };
    let letter = n / power_of(unit);
    let known = PREFIXES.iter().find(|(e, _)| e * power_of(unit) == n);
    known.filter(|_| (lowest..=highest).contains(&letter)).map(|(_, letter)| *letter)
}

/// Power of the first factor of a unit: 2 for `m^2` and `m²/N`.
fn power_of(unit: &str) -> i32 {
    let first = unit.split(['/', '·', '*', ' ']).next().unwrap_or("");
    match first.trim_start_matches(|c: char| c.is_alphabetic()) {
        "²" | "^2" => 2,
        "³" | "^3" => 3,
        "⁴" | "^4" => 4,
        _ => 1,
    }
}

/// Axis label with the unit in parentheses: `force F (mN)`.
pub(super) fn caption(label: &str, unit: &str, exponent: i32) -> String {
    let unit = raise(&text::clean(unit));
    let label = text::clean(label);
    let bare = matches!(unit.as_str(), "1" | "");
    let unit = match prefix(&unit, exponent) {
        Some(_) if bare => return label,
        Some(letter) => format!("{letter}{unit}"),
        None if bare => text::power(exponent),
        None => format!("{} {unit}", text::power(exponent)),
    };
    format!("{label} ({unit})").trim_start().to_owned()
}

/// Unit with raised exponents: `J/m^2` gives `J/m²`.
fn raise(unit: &str) -> String {
    let mut raised = false;
    let mut out = String::new();
    for c in unit.chars() {
        match c {
            '^' => raised = true,
            '-' | '0'..='9' if raised => out.push(text::raised(c)),
            _ => {
                raised = false;
                out.push(c);
            }
        }
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;

    fn label(unit: &str, largest: f64) -> String {
        caption("", unit, exponent(unit, largest))
    }

    #[test]
    fn prefixes_put_the_largest_value_between_1_and_1000() {
        assert_eq!(label("N", 0.0048), "(mN)");
        assert_eq!(label("m", 1e-6), "(µm)");
        assert_eq!(label("m", 9.99e-7), "(nm)");
        assert_eq!(label("m", 1e-6 * (1.0 - f64::EPSILON)), "(µm)");
        assert_eq!(label("Pa", 1.2e9), "(GPa)");
        assert_eq!(label("J", 3e-9), "(nJ)");
        assert_eq!(label("N/m", 2e5), "(kN/m)");
        assert_eq!(label("J/m^2", 0.05), "(mJ/m²)");
    }

    #[test]
    fn squares_take_the_square_of_the_prefix() {
        assert_eq!(exponent("m^2", 3e-11), -12);
        assert_eq!(label("m^2", 3e-11), "(µm²)");
        assert_eq!(label("m³", 2e-15), "(µm³)");
        assert_eq!(label("m³", 1e-12), "(10⁻¹² m³)");
    }

    #[test]
    fn what_has_no_prefix_takes_a_power_of_ten() {
        assert_eq!(label("s", 3e7), "(10⁶ s)");
        assert_eq!(label("s", 3600.0), "(s)");
        assert_eq!(label("N", 1e300), "(10³⁰⁰ N)");
        assert_eq!(label("1", 2e-6), "(10⁻⁶)");
        assert_eq!(label("kg", 2e-6), "(10⁻⁶ kg)");
    }

    #[test]
    fn pure_numbers_have_no_unit() {
        assert_eq!(caption("restitution e", "1", exponent("1", 0.9)), "restitution e");
    }
}
