//! What lies below a contact, beside a half-space and beside the usual series.

use crate::contact::state::Normal;
use crate::material::{Body, Joint, Layered};
use crate::scene::law::ContactLaw;
use crate::scene::plan::RoundPlan;
use crate::shape::Shape;
use std::f64::consts::{FRAC_2_PI, TAU};

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
    let film = film(plan, depth).map(|factor| {
        let off = 100.0 * (factor * half_space / state.force - 1.0);
        format!("weight of Gao, Chiu & Lee (1992) between film and substrate: {factor:.4} times, {off:+.1} %")
    });
    std::iter::once(format!("below the surface: the force is {ratio}")).chain(series).chain(film).collect()
}

/// E′/E_f′ of one bonded film on a base that gives, under a paraboloid whose contact is as wide as on a half-space; `None`
/// of another scene.
fn film(plan: &RoundPlan, depth: f64) -> Option<f64> {
    let Shape::Paraboloid(ball) = &plan.scene.shape else { return None };
    let Layered { layers, base, bond } = layered(plan)?;
    let ([layer], Body::Elastic(below)) = (layers.as_slice(), base.as_ref()) else { return None };
    let (Body::Elastic(film), Joint::Bonded) = (&layer.body, layer.bond.unwrap_or(*bond)) else { return None };
    let ratio = (ball.radius.si() * depth).sqrt() / layer.thickness.si();
    let weight = film_weight(ratio, film.poisson.si());
    Some(weight + (1.0 - weight) * below.plane_modulus() / film.plane_modulus())
}

/// Share I₀ of the film in E′ = E_s′ + (E_f′ − E_s′)I₀, E′ = E/(1 − ν²), x = a/h:
///
/// I₀ = (2/π)arctan(1/x) + [((1 − 2ν)/x)ln(1 + x²) − x/(1 + x²)]/(2π(1 − ν)).
///
/// `ratio` a/h, `poisson` ν of the film. Gao, Chiu & Lee 1992 weigh the shear moduli by it, for a flat punch, to first order
/// in their difference; E′ is what the analysis of thin films weighs (Menčík et al. 1997). Good to some per cent while the
/// moduli differ by less than a factor of two. Check: I₀ → 1 for a ≪ h, 0 for a ≫ h; ν = 0, x = 1: 1/2 + (ln 2 − 1/2)/2π.
#[must_use]
pub fn film_weight(ratio: f64, poisson: f64) -> f64 {
    let (x, square) = (ratio, ratio * ratio);
    let bent = (1.0 - 2.0 * poisson) * square.ln_1p() / x - x / (1.0 + square);
    FRAC_2_PI * x.recip().atan() + bent / (TAU * (1.0 - poisson))
}

/// The layered body of a scene that has one against a rigid one.
fn layered(plan: &RoundPlan) -> Option<&Layered> {
    match &plan.scene.bodies {
        (Body::Layered(body), Body::Rigid) | (Body::Rigid, Body::Layered(body)) => Some(body),
        _ => None,
    }
}

/// F/F_Hertz of an incompressible layer bonded to a rigid base under a paraboloid; `None` of another scene.
fn dimitriadis(plan: &RoundPlan, depth: f64) -> Option<f64> {
    let Shape::Paraboloid(ball) = &plan.scene.shape else { return None };
    let Layered { layers, base, bond } = layered(plan)?;
    let ([layer], Body::Rigid) = (layers.as_slice(), base.as_ref()) else { return None };
    let (Body::Elastic(gel), Joint::Bonded) = (&layer.body, layer.bond.unwrap_or(*bond)) else { return None };
    if gel.poisson.si() < 0.5 {
        return None;
    }
    Some(gel_series((ball.radius.si() * depth).sqrt() / layer.thickness.si()))
}

/// F/F_Hertz of an incompressible layer bonded to a rigid base under a paraboloid of the radius R, in χ = √(Rd)/h
/// (Dimitriadis et al. 2002, eq. 13).
#[must_use]
pub fn gel_series(chi: f64) -> f64 {
    1.0 + chi * (1.133 + chi * (1.283 + chi * (0.769 + chi * 0.0975)))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::ground::{Ground, Layers};
    use crate::material::{Sheet, Stack};
    use std::f64::consts::LN_2;

    /// One number by hand, the ends, and a film little stiffer than its base under a flat punch, for which it was made: of
    /// the difference of the moduli it tells the share of the film to some per cent.
    #[test]
    fn a_film_little_stiffer_than_its_base() {
        assert!((film_weight(1.0, 0.0) - 0.5 - (LN_2 - 0.5) / TAU).abs() < 1e-15);
        assert!((film_weight(1e-7, 0.3) - 1.0).abs() < 1e-6 && film_weight(1e7, 0.3).abs() < 1e-6);
        for a in [0.1, 0.5, 1.0, 2.0, 5.0] {
            let sheet = |shear: f64| Sheet { shear, poisson: 0.3, thickness: 1.0, joint: Joint::Bonded };
            let layers = Layers::new(vec![(1.0, Stack { sheets: vec![sheet(1.02)], base: Some(sheet(1.0)) })]);
            // k/2a of the film's own E*, in that of the base.
            let stiff = 1.02 * layers.measure(a) / a;
            let share = (stiff - 1.0) / 0.02;
            assert!((share - film_weight(a, 0.3)).abs() < 0.05, "{a}: {share} {}", film_weight(a, 0.3));
        }
    }
}
