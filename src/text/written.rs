//! Numbers as they are written in the text of a scene: where each stands, and the text with others in their places.
//!
//! # Examples
//! ```
//! use springbed::text::written::{numbers, with};
//!
//! let text = r#"(shape: Sphere(radius: "5 mm"), bodies: (Elastic(young: 1e6, poisson: 0.5), Rigid))"#;
//! let found = numbers(text);
//! assert_eq!((found[0].path.as_str(), found[0].value, found[0].unit.as_str()), ("shape.radius", 5.0, "mm"));
//! // The unit stays; all else of the text too.
//! let changed = with(text, &[("shape.radius", 7.5), ("bodies.0.young", 2e6)]);
//! assert_eq!(changed, text.replace("5 mm", "7.5 mm").replace("1e6", "2000000"));
//! ```

use super::walk::values;
use std::ops::Range;

/// A number in the text of a scene.
#[derive(Debug, Clone, PartialEq)]
pub struct Written {
    /// Path of its place, as `history[0].to`.
    pub path: String,
    /// The number before its unit.
    pub value: f64,
    /// The unit as it is written; empty where there is none.
    pub unit: String,
    /// Bytes of the text.
    at: Range<usize>,
}

/// Fields that hold no quantity of the scene itself, and those that count.
const OTHERS: [&str; 5] = ["title", "fit", "sweep", "plots", "solver"];
const COUNTS: [&str; 6] = ["springs", "steps", "points", "seeds", "cycles", "n"];

/// The quantities of a scene in the order of its text; counts and what belongs to fits and sweeps are left out.
#[must_use]
pub fn numbers(text: &str) -> Vec<Written> {
    let quantity = |(path, at): (String, Range<usize>)| {
        let first = path.split(['.', '[']).next().unwrap_or("");
        let last = path.rsplit('.').next().unwrap_or("").split('[').next().unwrap_or("");
        if OTHERS.contains(&first) || COUNTS.contains(&last) {
            return None;
        }
        let (value, unit) = quantity(&text[at.clone()])?;
        Some(Written { path, value, unit: unit.to_owned(), at })
    };
    values(text).into_iter().filter_map(quantity).collect()
}

/// The text with other numbers at some paths, each in the unit written there; a path that is not there changes nothing.
#[must_use]
pub fn with<P: AsRef<str>>(text: &str, set: &[(P, f64)]) -> String {
    let mut changed = text.to_owned();
    // From the end, so that what stands before keeps its place.
    for number in numbers(text).iter().rev() {
        let Some((_, value)) = set.iter().find(|(path, _)| path.as_ref() == number.path) else { continue };
        let blank = if number.unit.is_empty() { "" } else { " " };
        let quoted = text[number.at.clone()].starts_with('"');
        let plain = *value == 0.0 || (1e-4..1e7).contains(&value.abs());
        let digits = if plain { value.to_string() } else { format!("{value:e}") };
        let new = format!("{digits}{blank}{}", number.unit);
        changed.replace_range(number.at.clone(), &if quoted { format!("\"{new}\"") } else { new });
    }
    changed
}

/// Number and unit of a token such as `1e6` or `"5 mm"`.
fn quantity(token: &str) -> Option<(f64, &str)> {
    let finite = |text: &str| text.parse().ok().filter(|value: &f64| value.is_finite());
    if token.starts_with(|c: char| c.is_ascii_digit() || matches!(c, '-' | '+' | '.')) {
        return finite(token).map(|value| (value, ""));
    }
    let inner = token.strip_prefix('"')?.strip_suffix('"')?.trim();
    let end = |c: char| c.is_whitespace() || c.is_alphabetic() && !matches!(c, 'e' | 'E') || matches!(c, '%' | '°');
    let (number, unit) = inner.split_at(inner.find(end).unwrap_or(inner.len()));
    let unit = unit.trim();
    let plausible = !unit.starts_with(|c: char| c.is_ascii_digit() || c == '.') && !unit.contains("..");
    finite(number).filter(|_| plausible && unit.len() < 16 && !unit.contains('.')).map(|value| (value, unit))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::Scene;
    use crate::text::Notation;
    use proptest::prelude::*;

    const SCENE: &str = r#"// 5 mm
(
    title: "3 mm",
    shape: Paraboloid(radius: "10 mm"), // "7 mm"
    bodies: (Elastic(young: "210 GPa", poisson: 0.3), Rigid),
    steps: 40,
    history: [Indent(to: "1 um", over: 1), Indent(to: "-1e-7 m", over: "1 s"), Table("2 curves.csv")],
    sweep: (set: [(path: "shape.radius", values: "1 mm..2 mm:3")]),
)"#;

    #[test]
    fn quantities_are_found_with_their_units_and_nothing_else() {
        let found: Vec<String> =
            numbers(SCENE).into_iter().map(|n| format!("{}={} {}", n.path, n.value, n.unit)).collect();
        assert_eq!(
            found,
            [
                "shape.radius=10 mm",
                "bodies.0.young=210 GPa",
                "bodies.0.poisson=0.3 ",
                "history[0].to=1 um",
                "history[0].over=1 ",
                "history[1].to=-0.0000001 m",
                "history[1].over=1 s",
            ]
        );
        let json = r#"{"shape": {"Sphere": {"radius": "5 mm"}}, "bodies": [{"Elastic": {"young": 1e6}}, "Rigid"]}"#;
        let paths: Vec<String> = numbers(json).into_iter().map(|number| number.path).collect();
        assert_eq!(paths, ["shape.radius", "bodies[0].young"]);
    }

    proptest! {
        /// What is put into the text is read from it again, to the bit, and the rest stays.
        #[test]
        fn what_is_put_in_is_read_again(digits in 1i32..9999, tens in -12i32..12, at in 0usize..7) {
            let value = f64::from(digits) * 10f64.powi(tens);
            let path = numbers(SCENE)[at].path.clone();
            let changed = with(SCENE, &[(&path, value)]);
            for (before, after) in numbers(SCENE).into_iter().zip(numbers(&changed)) {
                prop_assert_eq!(&before.path, &after.path);
                prop_assert_eq!(&before.unit, &after.unit);
                let right = if before.path == path { value } else { before.value };
                prop_assert_eq!(after.value.to_bits(), right.to_bits());
            }
        }
    }

    /// A text with its own numbers put in is the same scene.
    #[test]
    fn own_numbers_change_no_scene() {
        let own: Vec<(String, f64)> = numbers(SCENE).into_iter().map(|n| (n.path, n.value)).collect();
        let read = |text: &str| -> Scene { Notation::Ron.scene(text).unwrap() };
        assert_eq!(read(&with(SCENE, &own)), read(SCENE));
    }
}
