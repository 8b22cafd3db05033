//! The pull-off of a ball after Johnson, Kendall and Roberts.

use super::{Answer, Effort, Method, Setting, Study};
use crate::contact::adhesion::line::EdgeLine;
use crate::contact::direct::QuasiStatic;
use crate::contact::foundation::HalfSpace;
use crate::contact::springs::{EdgeLocation, SpringBed};
use crate::input::quantity::Length;
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
pub(super) fn pull_off(effort: Effort) -> Option<Study> {
    let mut methods = vec![Method::new("direct path", Setting::FREE, || {
        let ball = ball()?;
        Some(move || direct(&ball))
    })];
    for (name, location) in
        [("springs, edge between", EdgeLocation::BetweenSprings), ("springs, counted", EdgeLocation::AtSprings)]
    {
        methods.extend(effort.decades(2, 5).map(|count| {
            let prepare = move || {
                let bed = SpringBed::new(HalfSpace::new(Arc::new(ball()?), 1.0), (count, 3.2), 1.0).with_edge(location);
                Some(move || Some(springs(bed.clone())))
            };
            Method::new(name, Setting::springs(count), prepare)
        }));
    }
    Some(Study {
        case: "jkr",
        about: "a ball pulled away by its depth: pull-off force".to_owned(),
        quantity: "pull-off force",
        reference: "closed form −(3/2)πwR".to_owned(),
        orders: &[1.0, 2.0],
        exact: Answer { values: vec![-1.5 * PI], ..Answer::default() },
        methods,
    })
}

fn ball() -> Option<Paraboloid> {
    Some(Paraboloid { radius: Length::new(1.0).ok()? })
}

fn direct(ball: &Paraboloid) -> Option<Answer> {
    let mut contact = QuasiStatic::new(EdgeLine::new(HalfSpace::new(Arc::new(ball.clone()), 1.0), 1.0));
    contact.indent(DEPTH).ok()?;
    let from = contact.present().balance.reach;
    contact.indent(AWAY).ok()?;
    let turns = contact.force_turns(from, contact.present().balance.reach).ok()?;
    let values = vec![turns.first()?.force];
    Some(Answer { values, bytes: size_of::<QuasiStatic>(), ..Answer::default() })
}

fn springs(mut bed: SpringBed) -> Answer {
    bed.indent(DEPTH);
    let step = (DEPTH - AWAY) / f64::from(RECORDS);
    let forces = (1..=RECORDS).map(|k| {
        bed.indent(DEPTH - f64::from(k) * step);
        bed.force()
    });
    let least = forces.fold(f64::INFINITY, f64::min);
    Answer { values: vec![least], bytes: bed.bytes(), ..Answer::default() }
}
