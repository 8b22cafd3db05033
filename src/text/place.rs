//! A value at a place in a scene.
//!
//! A place is written as the names of fields and the numbers of list entries, joined by points: `bodies.0.young`,
//! `adhesion.work`, `history.1.to`, `shape.radius`. The kind of a part (`Elastic`, `Jkr`) may be left out.
//!
//! # Examples
//! ```
//! use springbed::scene::Scene;
//! use springbed::text::place::Draft;
//!
//! let scene = Scene::from_ron(r#"(shape: Sphere(radius: "5 mm"), bodies: (Elastic(young: "1 MPa", poisson: 0.5), Rigid),
//!     history: [Indent(to: "10 um", over: 1)])"#)?;
//! let softer = Draft::of(&scene)?.with("bodies.0.young", "20 kPa")?;
//! assert_eq!(softer.number("bodies.0.young")?, 20e3);
//! assert!(softer.scene()? != scene);
//! let wrong = softer.number("bodies.0.yung").unwrap_err();
//! assert!(wrong.to_string().contains("did you mean `young`"));
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

use super::names::{FIELDS, advice};
use crate::scene::Scene;
use serde::Deserialize;
use serde_json::Value;

/// Why there is no such value at a place.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[error("{path}: {message}")]
pub struct PlaceError {
    /// The place as it was given.
    pub path: String,
    /// What is wrong with it, and what is there.
    pub message: String,
}

impl PlaceError {
    fn new(path: &str, message: impl Into<String>) -> Self {
        Self { path: path.to_owned(), message: message.into() }
    }
}

/// A scene whose values can be set one by one.
#[derive(Debug, Clone, PartialEq)]
pub struct Draft(Value);

impl Draft {
    /// The values of a scene.
    ///
    /// # Errors
    /// The scene holds a number that cannot be written down.
    pub fn of(scene: &Scene) -> Result<Self, PlaceError> {
        serde_json::to_value(scene).map(Self).map_err(|error| PlaceError::new("scene", error.to_string()))
    }

    /// The same values with `value` at the place `path`: a number in SI units, or text with a unit such as `10 mm`.
    ///
    /// # Errors
    /// There is no such place, or the value does not fit it.
    pub fn with(mut self, path: &str, value: &str) -> Result<Self, PlaceError> {
        let number = serde_json::from_str::<Value>(value).ok().filter(Value::is_number);
        self.set(path, number.unwrap_or_else(|| Value::String(value.trim().to_owned())))?;
        let scene = self.scene().map_err(|error| PlaceError::new(path, error.message))?;
        Self::of(&scene)
    }

    /// Sets the number `si` [SI unit] at the place `path`.
    ///
    /// # Errors
    /// There is no such place.
    pub fn set_number(&mut self, path: &str, si: f64) -> Result<(), PlaceError> {
        self.set(path, Value::from(si))
    }

    /// The number [SI unit] at the place `path`.
    ///
    /// # Errors
    /// There is no such place, or no number in it.
    pub fn number(&self, path: &str) -> Result<f64, PlaceError> {
        let mut at = &self.0;
        for name in path.split('.') {
            at = step(opened(at, name), name).map_err(|message| PlaceError::new(path, message))?;
        }
        at.as_f64().ok_or_else(|| PlaceError::new(path, format!("holds {}: expected a number", kind(at))))
    }

    /// The scene with these values; whether they fit together [`resolve`](Scene::resolve) says.
    ///
    /// # Errors
    /// A value is out of its range.
    pub fn scene(&self) -> Result<Scene, PlaceError> {
        Scene::deserialize(&self.0).map_err(|error| PlaceError::new("scene", error.to_string()))
    }

    fn set(&mut self, path: &str, value: Value) -> Result<(), PlaceError> {
        let mut at = &mut self.0;
        for name in path.split('.') {
            at = step_mut(opened_mut(at, name), name).map_err(|message| PlaceError::new(path, message))?;
        }
        *at = value;
        Ok(())
    }
}

/// The fields of a part; its kind, which has one name in capitals, is passed over unless `name` is it.
fn opened<'v>(at: &'v Value, name: &str) -> &'v Value {
    match at.as_object().and_then(|fields| fields.iter().next().filter(|_| fields.len() == 1)) {
        Some((only, inside)) if is_kind(only) && only != name => inside,
        _ => at,
    }
}

fn opened_mut<'v>(at: &'v mut Value, name: &str) -> &'v mut Value {
    let passed = at.as_object().and_then(|fields| fields.keys().next().filter(|_| fields.len() == 1)).cloned();
    match passed {
        Some(only) if is_kind(&only) && only != name => &mut at[only.as_str()],
        _ => at,
    }
}

fn is_kind(name: &str) -> bool {
    name.starts_with(char::is_uppercase)
}

/// What stands under `name`.
fn step<'v>(at: &'v Value, name: &str) -> Result<&'v Value, String> {
    let found = match at {
        Value::Array(entries) => name.parse::<usize>().ok().and_then(|number| entries.get(number)),
        _ => at.get(name),
    };
    found.ok_or_else(|| missing(at, name))
}

fn step_mut<'v>(at: &'v mut Value, name: &str) -> Result<&'v mut Value, String> {
    if at.get("history").is_some() && FIELDS.contains(&name) && at.get(name).is_none() {
        // What a scene may leave out can be put in.
        at[name] = Value::Null;
    }
    step(at, name)?;
    let found = match name.parse::<usize>() {
        Ok(number) if at.is_array() => at.get_mut(number),
        _ => at.get_mut(name),
    };
    found.ok_or_else(String::new)
}

fn missing(at: &Value, name: &str) -> String {
    match at {
        Value::Array(entries) => {
            let last = entries.len().saturating_sub(1);
            format!("there is no entry `{name}` in a list of {}: expected a number from 0 to {last}", entries.len())
        }
        Value::Object(fields) => {
            let known: Vec<&str> = fields.keys().map(String::as_str).collect();
            format!("there is no `{name}` here: {}", advice(name, &known))
        }
        other => format!("there is no `{name}` in {}: expected the path to end before it", kind(other)),
    }
}

/// A value in words.
fn kind(value: &Value) -> String {
    match value {
        Value::Array(entries) => format!("a list of {}", entries.len()),
        Value::Object(fields) => {
            format!("the fields {}", fields.keys().map(String::as_str).collect::<Vec<_>>().join(", "))
        }
        other => format!("`{other}`"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn draft() -> Draft {
        let text = r#"(shape: Paraboloid(radius: 1), bodies: (Viscoelastic(poisson: 0.5, shear: (equilibrium: 1,
            terms: [(modulus: 2, time: 3)])), Rigid), history: [Indent(to: 1, over: 1)])"#;
        Draft::of(&Scene::from_ron(text).unwrap()).unwrap()
    }

    #[test]
    fn places_lead_through_kinds_and_lists() {
        let draft = draft();
        assert_eq!(draft.number("bodies.0.shear.terms.0.modulus"), Ok(2.0));
        assert_eq!(draft.number("bodies.0.Viscoelastic.shear.terms.0.time"), Ok(3.0));
        assert_eq!(draft.number("history.0.to"), Ok(1.0));
        let set = draft.with("shape.radius", "10 mm").unwrap().with("accuracy", "1e-5").unwrap();
        assert_eq!(set.number("shape.radius"), Ok(0.01));
        assert_eq!(set.number("accuracy"), Ok(1e-5));
    }

    #[test]
    fn a_wrong_place_says_what_is_there() {
        let error = |path: &str| draft().number(path).unwrap_err().to_string();
        assert_eq!(error("shape.radus"), "shape.radus: there is no `radus` here: expected `radius`");
        assert!(error("bodies.2.young").contains("no entry `2` in a list of 2: expected a number from 0 to 1"));
        assert!(error("shape").contains("holds the fields"));
        assert!(error("shape.radius.x").contains("no `x` in `1.0`"));
        assert!(error("bodies.1.young").contains("no `young` in `\"Rigid\"`"));
        assert!(error("").contains("there is no ``"));
        assert!(error("adhesion.work").contains("there is no `adhesion`"));
        let wrong = draft().with("shape.radius", "-1 mm").unwrap_err().to_string();
        assert!(wrong.starts_with("shape.radius: \"-1 mm\" is out of range"), "{wrong}");
        assert!(draft().with("shape.radius", "1 kg").is_err());
    }
}
