//! Impacts of bodies that yield.

use super::table::ImpactRow;
use super::{Followed, RECORDS};
use crate::contact::model::ContactModel;
use crate::contact::plastic::{PlasticContact, YieldingBall};
use crate::drive::impact::{PlasticPassage, Projectile};
use crate::run::named::Named;
use crate::run::unit::Unit;
use crate::run::{Wanted, fields, plastic};
use crate::scene::plan::ImpactPlan;
use std::num::NonZeroUsize;

/// Follows an impact; records and fields only where `wanted`.
pub fn follow(plan: &ImpactPlan, ball: &YieldingBall, impact: Projectile, wanted: Option<Wanted>) -> Followed {
    let passage = PlasticPassage::new(*ball, impact);
    let rebound = passage.rebound();
    let records = plan.scene.steps.map_or(RECORDS, NonZeroUsize::get);
    let moments = if wanted.is_some() { passage.moments(records) } else { Vec::new() };
    let time = moments.iter().max_by(|x, y| x.depth.total_cmp(&y.depth)).map_or(0.0, |moment| moment.time);
    let deepest = pressed(ball, passage.deepest());
    let loading = deepest.loading();
    let peak_pressure = loading.as_ref().and_then(|loading| loading.peak());
    let radius = loading.as_ref().map_or(0.0, |loading| loading.contact_radius());
    let field = wanted.filter(|wanted| wanted.fields);
    let field = field.and_then(|_| fields::field(&deepest, "greatest depth".to_owned(), time));
    let row = ImpactRow { speed: impact.speed, rebound, oblique: None, peak_pressure };
    Followed { row, moments, radius, field, loaded: None, bytes: size_of::<PlasticPassage>() }
}

/// The contact at its greatest depth [m].
fn pressed(ball: &YieldingBall, depth: f64) -> PlasticContact {
    let mut contact = PlasticContact::new(*ball);
    contact.go_to(depth);
    contact
}

/// First yield, the speed at which it begins, and the dent that is left, of the impact of the records.
pub fn results(plan: &ImpactPlan, row: &ImpactRow) -> Vec<Named> {
    let Some(ball) = plan.law.bodies().yielding() else { return Vec::new() };
    let speed = ball.yield_speed(plan.impact.mass.si());
    let first = Named::number("first_yield_speed", Unit::METRE_PER_SECOND, speed);
    plastic::of_ball(ball, row.rebound.greatest_depth).into_iter().chain([first]).collect()
}
