//! What is told of bodies that yield.

use super::named::Named;
use super::unit::Unit;
use crate::contact::plastic::YieldingBall;
use crate::run::record::Record;
use crate::scene::plan::RoundPlan;

/// Force and depth of first yield, and the dent that is left.
pub fn results(plan: &RoundPlan, records: &[Record]) -> Vec<Named> {
    let deepest = records.iter().filter_map(|record| record.normal.indentation).fold(0.0, f64::max);
    plan.contact.bodies().yielding().map(|ball| of_ball(ball, deepest)).unwrap_or_default()
}

/// The same of a ball pressed to the depth `deepest` [m].
pub fn of_ball(ball: &YieldingBall, deepest: f64) -> Vec<Named> {
    vec![
        Named::number("first_yield_force", Unit::NEWTON, ball.yield_force()),
        Named::number("first_yield_indentation", Unit::METRE, ball.yield_depth()),
        Named::number("residual_depth", Unit::METRE, ball.let_go(deepest).residual),
    ]
}
