//! The pull-off of a ball after Johnson, Kendall and Roberts.

use super::EDGES;
use crate::check::case::Attempt;
use crate::check::contacts::{jkr, paraboloid};
use crate::check::row::{Computed, Setting};
use crate::check::study::{Method, Study, Thoroughness};
use crate::contact::direct::QuasiStatic;
use crate::contact::foundation::Foundation;
use crate::contact::springs::SpringBed;
use crate::shape::Paraboloid;
use std::f64::consts::PI;
use std::sync::Arc;

/// Depth from which the ball is pulled away; R = E* = w = 1.
const DEPTH: f64 = 2.0;
/// Depth reached: the last stable one is −1.608772.
const AWAY: f64 = -1.6;
/// Records of the retraction of a bed.
const RECORDS: u32 = 400;

/// Least force of a ball pulled away, −(3/2)πwR.
pub fn pull_off(effort: Thoroughness) -> Attempt<Study> {
    let mut methods = vec![Method::new("direct path", Setting::FREE, || {
        let ball = paraboloid(1.0)?;
        Ok(move || direct(&ball))
    })];
    for (name, location) in EDGES {
        methods.extend(effort.decades(2, 5).map(|count| {
            let prepare = move || {
                let bed = SpringBed::new(Foundation::new(paraboloid(1.0)?, 1.0), count, 3.2, 1.0).with_edge(location);
                Ok(move || Ok(springs(bed.clone())))
            };
            Method::new(name, Setting::springs(count), prepare)
        }));
    }
    Ok(Study {
        case: "jkr",
        about: "a ball pulled away by its depth: pull-off force".to_owned(),
        quantity: "pull-off force",
        reference: "closed form −(3/2)πwR".to_owned(),
        exact: Computed { values: vec![-1.5 * PI], ..Computed::default() },
        methods,
    })
}

fn direct(ball: &Arc<Paraboloid>) -> Attempt<Computed> {
    let mut contact = jkr(ball.clone(), 1.0, 1.0);
    contact.indent(DEPTH)?;
    let from = contact.present().balance.reach;
    contact.indent(AWAY)?;
    let turns = contact.force_turns(from, contact.present().balance.reach)?;
    let least = turns.first().ok_or("the force has no turning point")?;
    Ok(Computed { values: vec![least.force], bytes: size_of::<QuasiStatic>(), ..Computed::default() })
}

fn springs(mut bed: SpringBed) -> Computed {
    bed.indent(DEPTH);
    let step = (DEPTH - AWAY) / f64::from(RECORDS);
    let forces = (1..=RECORDS).map(|k| {
        bed.indent(DEPTH - f64::from(k) * step);
        bed.force()
    });
    let least = forces.fold(f64::INFINITY, f64::min);
    Computed { values: vec![least], bytes: bed.bytes(), ..Computed::default() }
}
