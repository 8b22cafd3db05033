//! What lies below a contact, beside a half-space and beside the usual series.

use crate::contact::state::Normal;
use crate::material::{Body, Joint, Layered};
use crate::scene::law::ContactLaw;
use crate::scene::plan::RoundPlan;
use crate::shape::Shape;

/// How far a contact without adhesion is from one on a half-space of its topmost layer in the state `state`, and what the
/// usual series would say; empty on a half-space.
#[must_use]
pub fn in_words(plan: &RoundPlan, state: &Normal) -> Vec<String> {
    let (Some(depth), Some(shape), None) = (state.indentation, plan.profile.bare(), &plan.scene.adhesion) else {
        return Vec::new();
    };
    let Some(radius) =
        shape.edge(depth).filter(|_| depth > 0.0 && state.force > 0.0 && matches!(plan.contact, ContactLaw::Direct(_)))
    else {
        return Vec::new();
    };
    let half_space = 2.0 * plan.pair.normal * shape.load_integral(radius);
    let ratio = format!(
        "{:.4} times that of a half-space of its topmost material at the depth {depth:.3e} m",
        state.force / half_space
    );
    let series = dimitriadis(plan, depth).map(|factor| {
        let off = 100.0 * (factor * half_space / state.force - 1.0);
        format!("series of Dimitriadis et al. (2002) for a bonded incompressible layer: {factor:.4} times, {off:+.1} %")
    });
    std::iter::once(format!("below the surface: the force is {ratio}")).chain(series).collect()
}

/// F/F_Hertz of an incompressible layer bonded to a rigid base under a paraboloid of the radius R, in χ = √(Rd)/h
/// (Dimitriadis et al. 2002, eq. 13); `None` of another scene.
fn dimitriadis(plan: &RoundPlan, depth: f64) -> Option<f64> {
    let Shape::Paraboloid(ball) = &plan.scene.shape else { return None };
    let (one, other) = &plan.scene.bodies;
    let body = match (one, other) {
        (Body::Layered(body), Body::Rigid) | (Body::Rigid, Body::Layered(body)) => body,
        _ => return None,
    };
    let Layered { layers, base, bond } = body;
    let ([layer], Body::Rigid) = (layers.as_slice(), base.as_ref()) else { return None };
    let (Body::Elastic(gel), Joint::Bonded) = (&layer.body, layer.bond.unwrap_or(*bond)) else { return None };
    if gel.poisson.si() < 0.5 {
        return None;
    }
    let chi = (ball.radius.si() * depth).sqrt() / layer.thickness.si();
    Some(1.0 + chi * (1.133 + chi * (1.283 + chi * (0.769 + chi * 0.0975))))
}
