//! What theories say of a scene, beside what is computed.

use super::ground;
use super::{
    GreenwoodWilliamson, StiffnessLaw, SummitStatistics, area_fraction, contact_conductance, plasticity_index,
};
use crate::contact::state::Normal;
use crate::material::Body;
use crate::numerics::root::RootError;
use crate::scene::law::ElasticAdhesion;
use crate::scene::plan::Plan;
use crate::scene::surface::Source;
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
        Plan::Impact(_)
        | Plan::Plane(_)
        | Plan::Rough(_)
        | Plan::RoughImpact(_)
        | Plan::Pad(_)
        | Plan::HalfSpace(_) => of_roughness(plan, state.force, state.stiffness),
    }
}

/// Area, summits, plasticity and conductance of a rough scene under the force [N], with its normal stiffness [N/m].
///
/// The area theories ask for a nominally flat surface of elastic bodies and no adhesion; else they say nothing.
#[must_use]
pub fn of_roughness(plan: &Plan, force: f64, stiffness: f64) -> Vec<String> {
    let Some(surface) = plan.surface() else { return Vec::new() };
    let (roughness, modulus) = (surface.roughness(), plan.pair.normal);
    let mut lines = Vec::new();
    if let Some(flat) = NominallyFlat::of(plan).filter(|_| force > 0.0) {
        let share = flat.persson(force);
        lines.push(format!(
            "Persson: {share:.3e} of the nominal area touches under {force:.3e} N, rather a quarter more"
        ));
        lines.push(flat.in_words(force / flat.area).unwrap_or_else(|why| {
            let pressure = force / flat.area;
            format!("Greenwood and Williamson: no separation within 30 deviations carries {pressure:.3e} Pa ({why})")
        }));
    }
    if let Some((hardness, from)) = hardness(plan) {
        let index = plasticity_index(modulus, roughness.rms_slope, hardness);
        let fate = if index < 2.0 / 3.0 { "summits stay elastic at any load" } else { "summits yield" };
        lines.push(format!("plasticity index {index:.3}: {fate} ({from})"));
    }
    if plan.fills_half_spaces() {
        let length = contact_conductance(stiffness, modulus, 1.0);
        lines.push(format!(
            "Barber: the conductance of the contact is {length:.3e} m over the sum of both resistivities"
        ));
    }
    lines
}

/// Hardness [Pa] of the softer body, and where it is from.
fn hardness(plan: &Plan) -> Option<(f64, String)> {
    let bodies = [&plan.scene.bodies.0, &plan.scene.bodies.1];
    let least = |of: fn(&Body) -> Option<f64>| bodies.into_iter().filter_map(of).reduce(f64::min);
    if let Some(hardness) = least(Body::hardness) {
        return Some((hardness, "the hardness given".to_owned()));
    }
    least(Body::yield_stress).map(|stress| (HARDNESS * stress, format!("hardness {HARDNESS} times the yield stress")))
}

/// A rough surface, nominally flat, of elastic bodies without adhesion: what the theories of real contact are made for.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct NominallyFlat {
    roughness: Roughness,
    /// E* [Pa].
    modulus: f64,
    /// Nominal area [m²].
    area: f64,
}

impl NominallyFlat {
    /// That of a scene, if it is one.
    #[must_use]
    pub fn of(plan: &Plan) -> Option<Self> {
        let bare = match plan {
            Plan::Rough(_) | Plan::RoughImpact(_) => {
                plan.rough().is_some_and(|rough| rough.works.is_none() && rough.hardness.is_none())
            }
            Plan::HalfSpace(pixels) => {
                let elastic = pixels.relaxation.is_none() && pixels.hardness.is_none() && pixels.ground.is_none();
                elastic && pixels.attraction == ElasticAdhesion::None
            }
            Plan::Round(_) | Plan::Impact(_) | Plan::Plane(_) | Plan::Pad(_) => false,
        };
        let surface = plan.surface().filter(|_| bare && plan.profile().is_none())?;
        let area = match (plan, &surface.source) {
            (Plan::HalfSpace(pixels), Source::Map(map)) => {
                let cut = |side: f64| pixels.window.map_or(side, |window| window.min(side));
                let (x, y) = map.sides();
                cut(x) * cut(y)
            }
            (_, Source::Map(_) | Source::Spectrum(_)) => surface.length() * surface.length(),
        };
        Some(Self { roughness: surface.roughness(), modulus: plan.pair.normal, area })
    }

    /// Nominal area [m²].
    #[must_use]
    pub fn area(&self) -> f64 {
        self.area
    }

    /// The power of the force [N] through points of the stiffness [N/m]; `None` for fewer than two.
    #[must_use]
    pub fn stiffness_law(&self, points: &[(f64, f64)]) -> Option<StiffnessLaw> {
        StiffnessLaw::fitted(points, (self.modulus, self.roughness.rms_height, self.area.sqrt()))
    }

    /// Stiffness [N/m] under a force [N] by such a law.
    #[must_use]
    pub fn stiffness(&self, law: StiffnessLaw, force: f64) -> f64 {
        let whole = self.modulus * self.area.sqrt();
        law.prefactor * whole * (force / (whole * self.roughness.rms_height)).powf(law.exponent)
    }

    /// Share of the nominal area that touches under a force [N], after Persson.
    #[must_use]
    pub fn persson(&self, force: f64) -> f64 {
        area_fraction(force / self.area, self.modulus, self.roughness.rms_slope)
    }

    /// The same on summits that each stand alone; `None` where no separation carries it, or where there would be more than all.
    #[must_use]
    pub fn greenwood_williamson(&self, force: f64) -> Option<f64> {
        let contact = self.summits();
        let share = contact.area_fraction(contact.separation(force / self.area).ok()?);
        Some(share).filter(|&share| share <= 1.0)
    }

    fn summits(&self) -> GreenwoodWilliamson {
        GreenwoodWilliamson { summits: SummitStatistics::of(&self.roughness), modulus: self.modulus }
    }

    /// Greenwood and Williamson at the nominal pressure [Pa].
    fn in_words(&self, pressure: f64) -> Result<String, RootError> {
        let contact = self.summits();
        let separation = contact.separation(pressure)?;
        let (share, radius) = (contact.area_fraction(separation), contact.summits.radius);
        let summits = contact.summits_in_contact(separation);
        Ok(format!(
            "Greenwood and Williamson: {share:.3e} on {summits:.3e} summits per m² of radius {radius:.3e} m, each on its own"
        ))
    }
}
