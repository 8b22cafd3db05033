//! What an analysis of the unloading would say of the bodies (Oliver & Pharr, J. Mater. Res. 7, 1564, 1992).

use super::named::Named;
use super::unit::Unit;
use crate::numerics::root;
use crate::run::record::Record;
use crate::scene::law::Bodies;
use crate::scene::plan::RoundPlan;
use crate::shape::{Profile, Shape};
use std::f64::consts::PI;

/// ε of paraboloids and of what lies between them and cones, of cones, of flat punches.
const ROUND: f64 = 0.75;
const SHARP: f64 = 0.72;
const FLAT: f64 = 1.0;
/// Most doublings of a radius.
const DOUBLINGS: usize = 200;

/// The first unloading from the largest force.
struct Unloading {
    force: f64,
    depth: f64,
    stiffness: f64,
}

/// Contact depth h_c = d − εF/S, E* = (√π/2)S/√A and H = F/A with A(h_c) of the shape: S = dF/dd at the start of unloading.
/// Of elastic bodies or those that yield, without adhesion.
///
/// Exact for an elastic paraboloid and a punch; a cone on a half-space has ε = 0.7268, by which E* comes out 0.5 % low. After
/// Thornton's plastic loading E* comes out low, down to E*/√2: he lets the contact grow as a² = Rd, half of the depth lying
/// below its edge, where the area function of the undeformed ball meets 2a²; bodies that yield sink in less.
pub(super) fn results(plan: &RoundPlan, records: &[Record]) -> Vec<Named> {
    let Some(unloading) = unloading(plan, records) else { return Vec::new() };
    let shape = plan.profile.bare().unwrap_or(plan.profile.as_ref());
    let Unloading { force, depth, stiffness } = unloading;
    let below = depth - epsilon(&plan.scene.shape) * force / stiffness;
    let Some(radius) = radius_at(shape, below.max(0.0)).filter(|radius| *radius > 0.0) else { return Vec::new() };
    vec![
        Named::number("contact_depth", Unit::METRE, below),
        Named::number("hardness", Unit::PASCAL, force / (PI * radius * radius)),
        Named::number("oliver_pharr_modulus", Unit::PASCAL, 0.5 * stiffness / radius),
    ]
}

/// Why the modulus of the unloading is not that of the bodies, if they yield.
pub(super) fn remark(plan: &RoundPlan, records: &[Record]) -> Option<String> {
    let ball = plan.contact.bodies().yielding()?;
    let deepest = unloading(plan, records)?.depth;
    (deepest > ball.yield_depth()).then(|| {
        "oliver_pharr_modulus_pa is below E*, at most by √2: Thornton's contact grows as a² = Rd while it yields, so that half of the depth lies below its edge, where the area function of the ball takes it for twice as large".to_owned()
    })
}

fn unloading(plan: &RoundPlan, records: &[Record]) -> Option<Unloading> {
    let bodies = plan.contact.bodies();
    if plan.scene.adhesion.is_some() || plan.profile.is_plane() || matches!(bodies, Bodies::Viscoelastic(..)) {
        return None;
    }
    let falls =
        |pair: &&[Record]| pair[1].normal.indentation < pair[0].normal.indentation && pair[0].normal.force > 0.0;
    let turns = records.windows(2).filter(falls).map(|pair| &pair[0].normal);
    let top = turns.reduce(|one, other| if other.force > one.force { other } else { one })?;
    // A ball that yields is stiffer on the way out than the record on the way in says.
    let stiffness = match bodies.yielding() {
        Some(ball) => 2.0 * ball.modulus * top.contact_radius?,
        None => top.stiffness,
    };
    Some(Unloading { force: top.force, depth: top.indentation?, stiffness }).filter(|_| stiffness > 0.0)
}

fn epsilon(shape: &Shape) -> f64 {
    if matches!(shape, Shape::Cone(_)) {
        SHARP
    } else if matches!(shape, Shape::FlatPunch(_)) {
        FLAT
    } else {
        ROUND
    }
}

/// The radius [m] at which the profile has the height `height` [m]; at its rim where it does not come so high.
fn radius_at(shape: &dyn Profile, height: f64) -> Option<f64> {
    let rim = shape.rim().radius();
    if shape.flat_radius() >= rim {
        return Some(rim);
    }
    let wider = std::iter::successors(Some(shape.scale()), |radius| Some(2.0 * radius));
    let above = wider.take(DOUBLINGS).map(|radius| radius.min(rim)).find(|&r| r >= rim || shape.height(r) >= height)?;
    let is_low = above >= rim && shape.height(rim) < height;
    Some(if is_low { rim } else { root::within(|r| shape.height(r) - height, 0.0, above) })
}
