//! Stiff and extreme values, each range against its exact answer or a law.

mod adhesion;
mod elastic;
mod friction;
mod long;
mod time;

pub(in crate::check) use time::EXPLICIT_EULER;

use crate::check::case::{Case, Proof, Question};
use crate::check::extreme::Extreme;

/// A case over a range of values; its weakness is the range.
const fn case(name: &'static str, extreme: Extreme, bound: f64, because: &'static str) -> Case {
    Case::new(name, Proof::Bound, bound, because).weak(extreme.range).asks(Question::Over(extreme))
}

/// Every range.
pub(super) fn all() -> Vec<Case> {
    [elastic::CASES, adhesion::CASES, time::CASES, friction::CASES, long::CASES].concat()
}
