//! States between records, where a curve is too bent for a straight line from one to the next.
//!
//! # Examples
//! ```
//! # #[cfg(feature = "text")] {
//! use springbed::prelude::*;
//! use springbed::run::curves::between::filled;
//!
//! let text = r#"(shape: Paraboloid(radius: 1), bodies: (Elastic(young: 1, poisson: 0), Rigid),
//!     history: [Indent(to: 1, over: 1)], steps: 2)"#;
//! let plan = Notation::Ron.plan(text, &InMemory::default()).map_err(|errors| errors[0].clone())?;
//! // Two records of a curve a ∝ √d, and the states between them: a² = Rd.
//! let outcome = run(&plan, Wanted::NOTHING)?;
//! let curve = filled(&plan, &outcome.records);
//! assert!(curve.len() > 10 && curve.iter().all(|record| {
//!     let (d, a) = (record.normal.indentation.unwrap(), record.normal.contact_radius.unwrap());
//!     (a * a - d).abs() < 1e-15
//! }));
//! # }
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

use crate::contact::adhesion::line::EdgeLine;
use crate::contact::state::Normal;
use crate::run::record::Record;
use crate::scene::plan::Plan;

/// Change of the contact radius, over the largest radius, from which a straight line is seen as one.
const COARSE: f64 = 0.02;
/// The most states put between two records.
const MOST: f64 = 50.0;

/// The records of a branch with states of the same branch between those that are far apart.
///
/// Near first touch and near pull-off a contact moves far in a short piece of depth, a ∝ √d. Only for
/// elastic contacts without range of attraction, where a state follows from its radius in closed form.
#[must_use]
pub fn filled(plan: &Plan, records: &[Record]) -> Vec<Record> {
    let Some(line) = line(plan) else { return records.to_vec() };
    let radius = |record: &Record| record.normal.contact_radius.unwrap_or(0.0);
    let largest = records.iter().map(radius).fold(0.0, f64::max);
    let mut filled: Vec<Record> = records.iter().take(1).copied().collect();
    for pair in records.windows(2) {
        let (from, to) = (radius(&pair[0]), radius(&pair[1]));
        let count = ((to - from).abs() / (COARSE * largest)).min(MOST).ceil();
        let steps = std::iter::successors(Some(1.0), |k| Some(k + 1.0)).take_while(|k| *k < count);
        filled.extend(steps.map(|k| at(&line, from + (to - from) * k / count, &pair[0])));
        filled.push(pair[1]);
    }
    filled
}

/// The equilibrium curve of the scene, if its states are those of the direct path.
fn line(plan: &Plan) -> Option<EdgeLine> {
    Some(EdgeLine::new(plan.ground()?, plan.direct()?.work_at_edge()?))
}

fn at(line: &EdgeLine, radius: f64, like: &Record) -> Record {
    let state = line.at(line.ground().profile().place(radius));
    let normal = Normal {
        indentation: Some(state.indentation),
        force: state.force,
        contact_radius: Some(radius),
        ..like.normal
    };
    Record { normal, ..*like }
}
