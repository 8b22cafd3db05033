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

use crate::contact::adhesion::dmt::DmtBall;
use crate::contact::adhesion::equilibrium::Balance;
use crate::contact::adhesion::line::EdgeLine;
use crate::contact::foundation::Foundation;
use crate::contact::plane::WavyContact;
use crate::contact::state::Normal;
use crate::run::record::Record;
use crate::scene::law::ElasticAdhesion;
use crate::scene::plan::{Plan, PlanePlan};

/// Change of the contact radius, over the largest radius, from which a straight line is seen as one.
const COARSE: f64 = 0.02;
/// Relative difference of depths that are the same.
const SAME: f64 = 1e-6;
/// The most states put between two records.
const MOST: f64 = 50.0;

/// The records of a branch with states of the same branch between those that are far apart.
///
/// Near first touch and near pull-off a contact moves far in a short piece of depth, a ∝ √d. For elastic contacts
/// without range of attraction, where a state follows from its radius in closed form; of a wavy section in one piece; of bodies that relax for a contact
/// that has only grown, d = g(a), its force and time along the straight line between two records.
#[must_use]
pub fn filled(plan: &Plan, records: &[Record]) -> Vec<Record> {
    let (line, ground) = (line(plan), plan.ground());
    let between = |pair: &[Record], radius: f64| match (&line, &ground, plan) {
        (Some(line), Some(ground), _) => {
            let at = |radius: f64| line(ground.profile().place(radius));
            pair.iter().all(|record| lies_on(&at, record)).then(|| between_two(&at(radius), radius, &pair[0]))
        }
        (None, Some(ground), _) => grown(ground, radius, pair),
        (None, None, Plan::Plane(plane)) => wavy(plane, radius, pair),
        (None, None, _) | (Some(_), None, _) => None,
    };
    let radius = |record: &Record| record.normal.contact_radius.unwrap_or(0.0);
    let largest = records.iter().map(radius).fold(0.0, f64::max);
    let mut filled: Vec<Record> = records.iter().take(1).copied().collect();
    for pair in records.windows(2) {
        let (from, to) = (radius(&pair[0]), radius(&pair[1]));
        let count = ((to - from).abs() / (COARSE * largest)).min(MOST).ceil();
        let steps = std::iter::successors(Some(1.0), |k| Some(k + 1.0)).take_while(|k| *k < count);
        filled.extend(steps.map_while(|k| between(pair, from + (to - from) * k / count)));
        filled.push(pair[1]);
    }
    filled
}

/// The equilibrium curve of the scene, if its states are those of the direct path.
fn line(plan: &Plan) -> Option<Box<dyn Fn(f64) -> Balance>> {
    let (ground, adhesion) = (plan.ground()?, plan.direct()?);
    if let ElasticAdhesion::Outside { work } = adhesion {
        let ball = DmtBall::new(ground, work);
        return Some(Box::new(move |a| ball.at(a)));
    }
    let line = EdgeLine::new(ground, adhesion.work_at_edge()?);
    Some(Box::new(move |a| line.at(a)))
}

/// The state near `radius` between two records of a wavy section: that of a force between theirs, for F ∝ a².
fn wavy(plan: &PlanePlan, radius: f64, pair: &[Record]) -> Option<Record> {
    let [from, to] = [&pair[0], &pair[1]].map(|record| record.normal.contact_radius);
    let (from, to) = (from?, to?);
    let share = (radius * radius - from * from) / (to * to - from * from);
    let along = |of: fn(&Record) -> f64| of(&pair[0]) + share * (of(&pair[1]) - of(&pair[0]));
    let (force, time) = (along(|record| record.normal.force), along(|record| record.time));
    let normal = WavyContact::new(plan.section.clone(), plan.pair.normal).state_under(force)?;
    Some(Record { normal, time, ..pair[0] })
}

/// The state at `radius` between two records of a contact whose edge is where the undeformed profile meets the surface.
fn grown(ground: &Foundation, radius: f64, pair: &[Record]) -> Option<Record> {
    let profile = ground.profile();
    let touched = |radius: f64| profile.reduced(profile.place(radius));
    let [from, to] =
        [&pair[0], &pair[1]].map(|record| Some((record.normal.indentation?, record.normal.contact_radius?)));
    let (from, to) = (from?, to?);
    let is_edge = |(depth, radius): (f64, f64)| (touched(radius) - depth).abs() <= SAME * to.0;
    if !(is_edge(from) && is_edge(to) && to.0 > from.0) {
        return None;
    }
    let depth = touched(radius);
    let share = (depth - from.0) / (to.0 - from.0);
    let along = |of: fn(&Record) -> f64| of(&pair[0]) + share * (of(&pair[1]) - of(&pair[0]));
    let (force, time) = (along(|record| record.normal.force), along(|record| record.time));
    let normal = Normal { indentation: Some(depth), contact_radius: Some(radius), force, ..pair[0].normal };
    Some(Record { normal, time, ..pair[0] })
}

/// Whether a record is a state of the curve: one whose edge a shear pulls in is not.
fn lies_on(curve: &impl Fn(f64) -> Balance, record: &Record) -> bool {
    let (Some(depth), Some(radius)) = (record.normal.indentation, record.normal.contact_radius) else {
        return false;
    };
    let state = curve(radius);
    let scale = depth.abs().max(state.indentation.abs());
    (state.indentation - depth).abs() <= SAME * scale
}

fn between_two(state: &Balance, radius: f64, like: &Record) -> Record {
    let normal = Normal {
        indentation: Some(state.indentation),
        force: state.force,
        contact_radius: Some(radius),
        ..like.normal
    };
    Record { normal, ..*like }
}
