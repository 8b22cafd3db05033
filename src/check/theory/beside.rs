//! What theories say of a scene, beside what is computed.

use super::ground;
use super::{GreenwoodWilliamson, SummitStatistics, area_fraction, contact_conductance, plasticity_index};
use crate::contact::state::Normal;
use crate::material::Body;
use crate::numerics::root::RootError;
use crate::scene::plan::Plan;
use crate::shape::rough::Roughness;

/// Hardness over yield stress of metals (Tabor 1951).
const HARDNESS: f64 = 2.8;

/// Of a rough scene in the state `state` area, summits, plasticity and conductance; of one on layers how far it is from
/// one on a half-space.
///
/// Empty of others.
#[must_use]
pub fn in_words(plan: &Plan, state: &Normal) -> Vec<String> {
    match plan {
        Plan::Round(round) => ground::in_words(round, state),
        Plan::Impact(_) | Plan::Plane(_) | Plan::Rough(_) | Plan::RoughImpact(_) | Plan::HalfSpace(_) => {
            of_roughness(plan, state.force, state.stiffness)
        }
    }
}

/// Area, summits, plasticity and conductance of a rough scene under the force [N], with its normal stiffness [N/m].
///
/// The area theories ask for a nominally flat surface and no adhesion; else they say nothing.
#[must_use]
pub fn of_roughness(plan: &Plan, force: f64, stiffness: f64) -> Vec<String> {
    let Some(rough) = plan.rough() else { return Vec::new() };
    let (surface, roughness, modulus) = (&rough.surface, rough.surface.roughness(), plan.pair.normal);
    let mut lines = Vec::new();
    if rough.base.is_none() && rough.works.is_none() && force > 0.0 {
        let pressure = force / (surface.length() * surface.length());
        let share = area_fraction(pressure, modulus, roughness.rms_slope);
        lines.push(format!(
            "Persson: {share:.3e} of the nominal area touches under {force:.3e} N, rather a quarter more"
        ));
        lines.push(of_summits(&roughness, modulus, pressure).unwrap_or_else(|why| {
            format!("Greenwood and Williamson: no separation within 30 deviations carries {pressure:.3e} Pa ({why})")
        }));
    }
    let (one, other) = &plan.scene.bodies;
    if let Some(stress) = [one, other].into_iter().filter_map(Body::yield_stress).reduce(f64::min) {
        let index = plasticity_index(modulus, roughness.rms_slope, HARDNESS * stress);
        let fate = if index < 2.0 / 3.0 { "summits stay elastic at any load" } else { "summits yield" };
        lines.push(format!("plasticity index {index:.3}: {fate} (hardness {HARDNESS} times the yield stress)"));
    }
    let length = contact_conductance(stiffness, modulus, 1.0);
    lines.push(format!("Barber: the conductance of the contact is {length:.3e} m over the sum of both resistivities"));
    lines
}

/// Greenwood and Williamson at the nominal pressure [Pa].
fn of_summits(roughness: &Roughness, modulus: f64, pressure: f64) -> Result<String, RootError> {
    let contact = GreenwoodWilliamson { summits: SummitStatistics::of(roughness), modulus };
    let separation = contact.separation(pressure)?;
    let (share, radius) = (contact.area_fraction(separation), contact.summits.radius);
    let summits = contact.summits_in_contact(separation);
    Ok(format!(
        "Greenwood and Williamson: {share:.3e} on {summits:.3e} summits per m² of radius {radius:.3e} m, each on its own"
    ))
}
