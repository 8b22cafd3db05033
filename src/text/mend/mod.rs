//! Reading on after a fault: every wrong value, unknown name and missing field of a text, not the first alone.
//!
//! A parser stops at the first fault. So the text is read again with the fault mended: a value that cannot be
//! read is passed over and a [`StandIn`] takes its place, a field that is not known is passed over, a missing
//! one is supplied. What is not mended goes to the parser as it is, so that places and messages are its own. What
//! is read at last has no fault left but what was mended, so the rest of it can be judged.

mod watched;

pub use watched::Watched;

use super::names::nearest;
use super::standin::{Guise, StandIn};
use serde::de::{self, DeserializeSeed};
use std::cell::{Cell, RefCell};
use std::collections::{BTreeMap, BTreeSet};

/// Most faults that are looked for; each takes a reading of the text.
const MOST_FAULTS: usize = 100;
/// Most bytes that are read again to find them.
const MOST_BYTES: usize = 1 << 28;

/// What a parser says is wrong at the place it stopped at.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Wrong {
    /// The value.
    Value,
    /// A field that is not known.
    UnknownField(String),
    /// A field that is there for the second time.
    RepeatedField(String),
    /// A field that is not there.
    MissingField(String),
    /// The notation itself, so that nothing after it can be trusted.
    Notation,
}

/// What is wrong with a text, and what can be read of it all the same.
#[derive(Debug)]
pub struct Faulty<T, E> {
    /// Its faults.
    pub faults: Vec<E>,
    /// What was read with every fault mended, and where; `None` if not all could be.
    pub rest: Option<(Box<T>, Mends)>,
}

/// What was mended.
#[derive(Debug, Default)]
pub struct Mends {
    /// Paths of values that are not those of the text.
    pub values: Vec<String>,
    /// Fields that are not known and were passed over: the path of their holder, and their name.
    pub unknown: Vec<(String, String)>,
}

impl<T, E> Faulty<T, E> {
    /// The same faults, `told` in another way.
    pub fn told<F>(self, told: impl Fn(&E) -> F) -> Faulty<T, F> {
        Faulty { faults: self.faults.iter().map(told).collect(), rest: self.rest }
    }
}

impl<T, E> From<Vec<E>> for Faulty<T, E> {
    fn from(faults: Vec<E>) -> Self {
        Self { faults, rest: None }
    }
}

/// Reads a text of `length` bytes by `read` until all faults are found; `wrong` says what an error is about.
///
/// # Errors
/// All faults up to and with the first of the notation.
pub fn read_all<T, E>(
    length: usize,
    read: impl Fn(&Mending) -> Result<T, E>,
    wrong: impl Fn(&E) -> Wrong,
) -> Result<T, Faulty<T, E>> {
    let mut mending = Mending::default();
    let mut faults = Vec::new();
    loop {
        match (read(&mending), mending.stop()) {
            (Ok(value), _) if faults.is_empty() => return Ok(value),
            (Ok(value), _) => return Err(Faulty { faults, rest: Some((Box::new(value), mending.mends())) }),
            (Err(_), Stop::PassingOver) => return Err(faults.into()),
            (Err(_), Stop::StandIn(path)) => {
                if !mending.disguise(path) {
                    return Err(faults.into());
                }
            }
            (Err(error), Stop::At(path)) => {
                let wrong = wrong(&error);
                if !mending.told_by_its_misspelling(&path, &wrong) {
                    faults.push(error);
                }
                let mended = mending.mend(path, wrong);
                if !mended || faults.len() >= MOST_FAULTS || faults.len() * length > MOST_BYTES {
                    return Err(faults.into());
                }
            }
        }
    }
}

/// What is mended, and how far the present reading has come.
#[derive(Debug, Default)]
pub struct Mending {
    stand_ins: BTreeMap<String, Guise>,
    supplied: BTreeMap<String, Vec<String>>,
    unknown: BTreeSet<(String, String)>,
    repeated: BTreeSet<(String, String)>,
    path: RefCell<String>,
    state: Cell<State>,
}

/// What is being done at the present path.
#[derive(Debug, Default, Clone, Copy, PartialEq, Eq)]
enum State {
    #[default]
    Reading,
    PassingOver,
    StandingIn,
}

/// Where a reading stopped.
#[derive(Debug)]
enum Stop {
    /// At a value or in a structure of the text.
    At(String),
    /// In a value that was to be passed over: its notation is wrong.
    PassingOver,
    /// At a stand-in that will not do.
    StandIn(String),
}

impl Mending {
    /// Where the last reading stopped; the next one begins anew.
    fn stop(&self) -> Stop {
        let path = self.path.take();
        match self.state.take() {
            State::Reading => Stop::At(path),
            State::PassingOver => Stop::PassingOver,
            State::StandingIn => Stop::StandIn(path),
        }
    }

    /// Mends a fault at `path`; whether it is one that can be mended and was not already.
    fn mend(&mut self, path: String, wrong: Wrong) -> bool {
        match wrong {
            Wrong::Value => self.stand_ins.insert(path, Guise::Number).is_none(),
            Wrong::UnknownField(field) => self.unknown.insert((path, field)),
            Wrong::RepeatedField(field) => self.repeated.insert((path, field)),
            Wrong::MissingField(field) => {
                let supplied = self.supplied.entry(path).or_default();
                let lacks = !supplied.contains(&field);
                supplied.push(field);
                lacks
            }
            Wrong::Notation => false,
        }
    }

    /// What is mended.
    fn mends(self) -> Mends {
        let supplied = self
            .supplied
            .into_iter()
            .flat_map(|(path, fields)| fields.into_iter().map(move |field| (path.clone(), field)));
        let fields = supplied.chain(self.repeated).map(|(path, field)| format!("{path}.{field}"));
        Mends {
            values: self.stand_ins.into_keys().chain(fields).collect(),
            unknown: self.unknown.into_iter().collect(),
        }
    }

    /// Whether a missing field is there under a name like its own, of which is told already.
    fn told_by_its_misspelling(&self, path: &str, wrong: &Wrong) -> bool {
        let Wrong::MissingField(field) = wrong else { return false };
        let mut here = self.unknown.iter().filter(|(holder, _)| holder == path);
        here.any(|(_, unknown)| nearest(unknown, &[field]).is_some())
    }

    /// Tries another stand-in at `path`; whether there is one.
    fn disguise(&mut self, path: String) -> bool {
        let next = self.stand_ins.get(&path).copied().map_or(Some(Guise::Text), Guise::next);
        next.map(|guise| self.stand_ins.insert(path, guise)).is_some()
    }

    /// Does `read` one step further down the path; the path stays where it fails.
    fn inside<T, E>(&self, step: &str, read: impl FnOnce() -> Result<T, E>) -> Result<T, E> {
        let before = self.path.borrow().len();
        self.path.borrow_mut().push_str(step);
        let value = read()?;
        self.path.borrow_mut().truncate(before);
        Ok(value)
    }

    fn doing<T, E>(&self, state: State, act: impl FnOnce() -> Result<T, E>) -> Result<T, E> {
        self.state.set(state);
        let value = act()?;
        self.state.set(State::Reading);
        Ok(value)
    }

    fn stand_in<'de, S: DeserializeSeed<'de>, E: de::Error>(&self, seed: S, guise: Guise) -> Result<S::Value, E> {
        self.doing(State::StandingIn, || seed.deserialize(StandIn::new(guise)).map_err(de::Error::custom))
    }

    /// What is read by a `seed`, under the eyes of the mending.
    pub fn watch<S>(&self, seed: S) -> Watched<'_, S> {
        Watched { inner: seed, mending: self }
    }

    /// Whether the field `name` of the structure here is to be passed over; `before` are the names before it.
    fn passes_over(&self, name: &str, before: &[String]) -> bool {
        if self.unknown.is_empty() && self.repeated.is_empty() {
            return false;
        }
        let field = (self.path.borrow().clone(), name.to_owned());
        self.unknown.contains(&field) || self.repeated.contains(&field) && before.iter().any(|seen| seen == name)
    }
}

#[cfg(test)]
mod tests {
    use crate::text::Notation;

    /// Line, column and message of all faults.
    fn faults(notation: Notation, text: &str) -> Vec<(usize, usize, String)> {
        let errors = notation.scene(text).unwrap_err();
        errors.into_iter().map(|error| (error.position.line, error.position.column, error.message)).collect()
    }

    fn begins(found: &[(usize, usize, String)], right: &[(usize, usize, &str)]) {
        assert_eq!(found.len(), right.len(), "{found:#?}");
        for (found, right) in found.iter().zip(right) {
            assert!((found.0, found.1) == (right.0, right.1) && found.2.contains(right.2), "{found:?}, not {right:?}");
        }
    }

    const RON: &str = r#"(
    shape: Sphere(radius: "5 kg"),
    bodies: (Elastic(young: -1, poison: 0.5), Rigid),
    adhesion: Jkrr(work: 0.05),
    history: [Indent(to: ten, over: 1), Indent(to: 0, over: 1, after: 2), Hold(over: 0)],
    springs: 10,
)"#;

    #[test]
    fn all_faults_of_a_text_are_found_in_its_order() {
        let right = [
            (2, 27, "shape.radius: \"5 kg\" has the unit"),
            (3, 29, "bodies.0.young: -1.0 Pa is out of range"),
            (3, 33, "Elastic has no field `poison`: did you mean `poisson`?"),
            (4, 15, "unknown adhesion `Jkrr`"),
            (5, 26, "history[0].to: `ten` cannot stand here"),
            (5, 64, "Indent has no field `after`"),
            (5, 86, "history[2].over: 0.0 s is out of range"),
        ];
        begins(&faults(Notation::Ron, RON), &right);
    }

    #[test]
    fn all_faults_of_json_too() {
        let text = r#"{"shape": {"Sphere": {"radius": "5 kg"}},
 "bodies": [{"Elastic": {"young": -1, "poison": 0.5}}, "Rigit"],
 "history": [{"Indent": {"to": [], "over": 1}}], "springs": 0}"#;
        let right = [
            (1, 33, "shape.radius: \"5 kg\" has the unit"),
            (2, 35, "bodies[0].young: -1.0 Pa is out of range"),
            (2, 39, "unknown field `poison`"),
            (2, 56, "unknown variant `Rigit`"),
            (3, 33, "invalid type: sequence"),
            (3, 61, "springs: invalid value"),
        ];
        begins(&faults(Notation::Json, text), &right);
    }

    #[test]
    fn several_missing_fields_and_one_given_twice() {
        let text = "(title: \"x\", title: \"y\", bodies: (Elastic(young: 1), Rigid))";
        let right = [
            (1, 1, "lacks the field `history`"),
            (1, 1, "lacks the field `shape`"),
            (1, 14, "`title` of Scene is given twice"),
            (1, 35, "lacks the field `poisson`"),
        ];
        begins(&faults(Notation::Ron, text), &right);
    }

    /// What is told after a broken bracket would be guesswork.
    #[test]
    fn nothing_is_told_of_what_follows_a_broken_notation() {
        let found = faults(Notation::Ron, &RON.replace("0.5), Rigid", "0.5, Rigid"));
        let last = found.last().unwrap();
        assert!((last.0 <= 4) && found.iter().any(|fault| fault.0 == 2), "{found:#?}");
        assert_eq!(faults(Notation::Ron, "(shape: Cone(slope: 10 deg").len(), 1);
    }

    /// A text with more faults than a person reads is not read a thousand times.
    #[test]
    fn the_number_of_faults_is_bounded() {
        let text = format!("(history: [{}])", "Indent(to: x, over: 0), ".repeat(1000));
        assert_eq!(faults(Notation::Ron, &text).len(), super::MOST_FAULTS);
    }
}
