//! Values of a scene, read and set by the path of their place: `bodies.0.young`, `history[1].to`, `adhesion.work`.
//!
//! # Examples
//! ```
//! use springbed::scene::Scene;
//! use springbed::text::place::{Places, Value};
//!
//! let scene = Scene::from_ron(r#"(shape: Sphere(radius: "5 mm"), bodies: (Elastic(young: "1 MPa", poisson: 0.5), Rigid),
//!     history: [Indent(to: "10 um", over: 1)])"#)?;
//! let places = Places::of(&scene)?;
//! assert_eq!((places.number("bodies.0.young"), places.unit("bodies.0.young")), (Some(1e6), Some("Pa")));
//! // A value is given as in a scene: a number in SI units or text with its unit.
//! let stiffer = places.with(&[("bodies.0.young", Value::from("3 MPa"))])?;
//! assert_eq!(Places::of(&stiffer)?.number("bodies.0.young"), Some(3e6));
//! // What is wrong is told with what exists there.
//! let wrong = places.with(&[("bodies.0.yuong", Value::from(3e6))]).unwrap_err();
//! assert_eq!(wrong.path, "bodies.0.yuong");
//! assert!(wrong.message.contains("did you mean `young`?"));
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

use super::names::advice;
use crate::input::problem::Problem;
use crate::input::quantity::SI_UNITS;
use crate::scene::Scene;
/// A value as a scene in JSON has it, and one as it is written there.
pub use serde_json::{Value, json};

/// A scene whose values can be read and set by path.
///
/// A path names fields and counts the entries of lists and pairs from 0, `bodies.0.young` or `bodies[0].young`; the
/// name of a kind, such as `Elastic`, is no part of it.
#[derive(Debug, Clone, PartialEq)]
pub struct Places(Value);

impl Places {
    /// The places of a scene.
    ///
    /// # Errors
    /// A number that no text can hold.
    pub fn of(scene: &Scene) -> Result<Self, Problem> {
        serde_json::to_value(scene).map(Self).map_err(|error| Problem::new("", error.to_string()))
    }

    /// The scene with other values at some places, set one after another.
    ///
    /// # Errors
    /// A path that leads nowhere, a value that cannot stand there: the path, and what exists there or would be right.
    pub fn with<P: AsRef<str>>(&self, values: &[(P, Value)]) -> Result<Scene, Problem> {
        self.made(values).map_err(|(path, message)| self.culprit(values).unwrap_or(Problem { path, message }))
    }

    /// The number at a path in SI units, if there is one; a list of one number counts as it.
    #[must_use]
    pub fn number(&self, path: &str) -> Option<f64> {
        number(self.value(path)?)
    }

    /// All numbers of the scene in SI units with their paths, fields in the order of their names.
    #[must_use]
    pub fn numbers(&self) -> Vec<(String, f64)> {
        let mut found = Vec::new();
        collect(&self.0, "", &mut found);
        found
    }

    /// What stands at a path.
    #[must_use]
    pub fn value(&self, path: &str) -> Option<&Value> {
        steps(path).try_fold(&self.0, |at, step| match inside(at) {
            Value::Object(fields) => fields.get(step),
            Value::Array(entries) => entries.get(step.parse::<usize>().ok()?),
            _ => None,
        })
    }

    /// The SI unit of the number at a path, empty of a pure number: that in which the place takes it.
    #[must_use]
    pub fn unit(&self, path: &str) -> Option<&'static str> {
        let present = self.number(path)?;
        let takes = |unit: &str| {
            let scene = self.with(&[(path, Value::from(format!("{present:?} {unit}")))]);
            scene.is_ok_and(|scene| Self::of(&scene).is_ok_and(|places| places.number(path).is_some()))
        };
        SI_UNITS.into_iter().find(|unit| takes(unit))
    }

    fn made<P: AsRef<str>>(&self, values: &[(P, Value)]) -> Result<Scene, (String, String)> {
        let mut tree = self.0.clone();
        for (path, value) in values {
            *place(&mut tree, path.as_ref()).map_err(|message| (path.as_ref().to_owned(), message))? = value.clone();
        }
        let paths = || values.iter().map(|(path, _)| path.as_ref()).collect::<Vec<_>>().join(", ");
        serde_json::from_value(tree).map_err(|error| (paths(), told(&error.to_string())))
    }

    /// The first of several values that cannot even stand alone.
    fn culprit<P: AsRef<str>>(&self, values: &[(P, Value)]) -> Option<Problem> {
        let alone = |(path, value): &(P, Value)| self.made(&[(path.as_ref(), value.clone())]).err();
        let (path, message) = values.iter().find_map(alone)?;
        Some(Problem { path, message })
    }
}

/// The numbers in a value at a path.
fn collect(value: &Value, path: &str, found: &mut Vec<(String, f64)>) {
    let below = |step: &str| if path.is_empty() { step.to_owned() } else { format!("{path}.{step}") };
    match inside(value) {
        value if number(value).is_some() => found.extend(number(value).map(|number| (path.to_owned(), number))),
        Value::Object(fields) => fields.iter().for_each(|(name, value)| collect(value, &below(name), found)),
        Value::Array(entries) => {
            entries.iter().enumerate().for_each(|(at, value)| collect(value, &below(&at.to_string()), found));
        }
        _ => {}
    }
}

fn number(value: &Value) -> Option<f64> {
    match value {
        Value::Array(entries) if entries.len() == 1 => entries[0].as_f64(),
        value => value.as_f64(),
    }
}

/// Names of fields and numbers of entries on the way to a path.
fn steps(path: &str) -> impl Iterator<Item = &str> {
    path.split(['.', '[', ']']).filter(|step| !step.is_empty())
}

/// The name of a kind that stands around its fields, as JSON has it.
fn kind(value: &Value) -> Option<&str> {
    let fields = value.as_object().filter(|fields| fields.len() == 1)?;
    fields.keys().next().map(String::as_str).filter(|name| name.starts_with(char::is_uppercase))
}

/// The fields of a kind, or the value itself.
fn inside(value: &Value) -> &Value {
    kind(value).map_or(value, |kind| &value[kind])
}

fn inside_mut(value: &mut Value) -> &mut Value {
    match kind(value).map(str::to_owned) {
        Some(kind) => &mut value[kind],
        None => value,
    }
}

/// The place at a path; one that a structure may lack is made in it.
fn place<'v>(tree: &'v mut Value, path: &str) -> Result<&'v mut Value, String> {
    let all: Vec<&str> = steps(path).collect();
    if all.is_empty() {
        return Err("is no path: expected one such as bodies.0.young".to_owned());
    }
    let mut at = tree;
    for (number, &step) in all.iter().enumerate() {
        let holder = || if number == 0 { "the scene".to_owned() } else { all[..number].join(".") };
        let last = number + 1 == all.len();
        if let Value::Object(fields) = inside(at)
            && !last
            && !fields.contains_key(step)
        {
            let known: Vec<&str> = fields.keys().map(String::as_str).collect();
            return Err(format!("{} has no `{step}`: {}", holder(), advice(step, &known)));
        }
        at = match inside_mut(at) {
            Value::Object(fields) => fields.entry(step.to_owned()).or_insert(Value::Null),
            Value::Array(entries) => {
                let count = entries.len();
                let entry = step.parse().ok().and_then(|entry: usize| entries.get_mut(entry));
                entry.ok_or_else(|| match count {
                    0 => format!("{} is empty: there is no entry `{step}`", holder()),
                    _ => format!("{} has no entry `{step}`: expected one of 0 to {}", holder(), count - 1),
                })?
            }
            held => {
                return Err(format!("{} is {held} and holds no `{step}`: expected the path to end there", holder()));
            }
        };
    }
    Ok(at)
}

/// What a reader says of a wrong value, a wrong name with those that are known.
fn told(message: &str) -> String {
    let mut quoted = message.split('`');
    let (what, found) = (quoted.next().unwrap_or(""), quoted.next().unwrap_or(""));
    if !matches!(what, "unknown field " | "unknown variant ") {
        return message.to_owned();
    }
    let known: Vec<&str> = quoted.skip(1).step_by(2).collect();
    format!("there is no `{found}`: {}", advice(found, &known))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn places() -> Places {
        let scene = Scene::from_ron(
            r#"(shape: Table("tip.csv"), bodies: (Elastic(young: 1e6, poisson: 0.5), Rigid), adhesion: Jkr(work: 0.05),
            history: [Impact(mass: 1, speed: 2)])"#,
        );
        Places::of(&scene.unwrap()).unwrap()
    }

    fn wrong(path: &str, value: impl Into<Value>) -> String {
        places().with(&[(path, value.into())]).unwrap_err().to_string()
    }

    #[test]
    fn what_is_set_is_read_back_and_nothing_else_changes() {
        let before = places();
        let set = [("history[0].speed", Value::from("3 km/h")), ("springs", 100.into()), ("shape", "Cone".into())];
        for (path, value, number) in [("history.0.speed", "3.6 km/h", 1.0), ("adhesion.work", "7 mJ/m^2", 0.007)] {
            let after = Places::of(&before.with(&[(path, Value::from(value))]).unwrap()).unwrap();
            assert_eq!(after.number(path), Some(number));
            let back = after.with(&[(path, before.value(path).unwrap().clone())]).unwrap();
            assert_eq!(Places::of(&back).unwrap(), before);
        }
        let scene = before.with(&set[..2]).unwrap();
        assert_eq!(scene.springs.map(std::num::NonZero::get), Some(100));
        assert!(before.with(&set).is_err());
    }

    #[test]
    fn every_number_is_found_under_its_path() {
        let numbers = places().numbers();
        let paths: Vec<&str> = numbers.iter().map(|(path, _)| path.as_str()).collect();
        let right = [
            "adhesion.work",
            "bodies.0.poisson",
            "bodies.0.young",
            "history.0.angle",
            "history.0.mass",
            "history.0.speed",
            "history.0.spin",
        ];
        assert!(paths.iter().all(|path| right.contains(path)) && paths.len() >= 5, "{paths:?}");
        assert!(numbers.iter().all(|(path, number)| places().number(path) == Some(*number)));
    }

    #[test]
    fn every_unit_is_found() {
        let units = ["bodies.0.young", "bodies.0.poisson", "adhesion.work", "history.0.mass", "history.0.speed"]
            .map(|path| places().unit(path));
        assert_eq!(units, ["Pa", "", "J/m^2", "kg", "m/s"].map(Some));
        assert_eq!(places().unit("shape"), None);
    }

    #[test]
    fn a_wrong_path_names_what_exists_there() {
        assert_eq!(
            wrong("friction.coefficient", 1),
            "friction.coefficient: the scene has no `friction`: \
             expected one of adhesion, bodies, history, shape, title"
                .replace("             ", "")
        );
        assert!(wrong("adhesoin", 1).starts_with("adhesoin: there is no `adhesoin`: did you mean `adhesion`?"));
        assert_eq!(wrong("history.1.mass", 1), "history.1.mass: history has no entry `1`: expected one of 0 to 0");
        assert!(wrong("bodies.0.young.x", 1).contains("bodies.0.young is 1000000.0 and holds no `x`"));
        assert!(wrong("bodies.0.yuong", 1).contains("did you mean `young`? Known: "));
        assert!(wrong("", 1).contains("expected one such as bodies.0.young"));
    }

    #[test]
    fn a_wrong_value_is_told_with_its_place() {
        assert!(wrong("adhesion.work", "5 mJ").starts_with("adhesion.work: \"5 mJ\" has the unit \"mJ\": expected"));
        let both = [("bodies.0.young", Value::from(1)), ("bodies.0.poisson", Value::from(0.7))];
        assert_eq!(places().with(&both).unwrap_err().path, "bodies.0.poisson");
    }
}
