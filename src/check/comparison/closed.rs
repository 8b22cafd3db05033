//! Closed forms of a round contact at its indentation.

use crate::check::case::Attempt;
use crate::check::closed_forms::{self, ClosedForm};
use crate::check::row::Found;
use crate::contact::elliptic::EllipticHertz;
use crate::numerics::root;
use crate::scene::law::ElasticAdhesion;
use crate::scene::plan::Plan;
use crate::shape::{Ellipsoid, Paraboloid, Shape};
use std::f64::consts::{FRAC_PI_2, PI};

/// The closed form of a state and its name; `None` where there is none.
pub(super) fn form(plan: &Plan, depth: f64) -> Attempt<Option<(&'static str, Found)>> {
    let (one, other) = &plan.scene.bodies;
    if one.is_uneven() || other.is_uneven() {
        return Ok(None);
    }
    let (shape, modulus) = (&plan.scene.shape, plan.pair.normal);
    match (plan.direct(), shape) {
        (Some(ElasticAdhesion::None), Shape::Ellipsoid(ellipsoid)) => elliptic(ellipsoid, modulus, depth).map(Some),
        (Some(ElasticAdhesion::None), _) => {
            Ok(axisymmetric(shape, depth)?.map(|contact| plain(shape, modulus, contact)))
        }
        (Some(ElasticAdhesion::Vanishing { work }), Shape::Paraboloid(ball)) => {
            jkr_ball(ball, modulus, work, depth).map(Some)
        }
        (Some(ElasticAdhesion::Outside { work }), Shape::Paraboloid(ball)) => {
            Ok(Some(dmt_ball(ball, modulus, work, depth)))
        }
        (
            Some(
                ElasticAdhesion::Vanishing { .. }
                | ElasticAdhesion::Outside { .. }
                | ElasticAdhesion::Finite { .. }
                | ElasticAdhesion::Fading { .. },
            )
            | None,
            _,
        ) => Ok(None),
    }
}

fn elliptic(ellipsoid: &Ellipsoid, modulus: f64, depth: f64) -> Attempt<(&'static str, Found)> {
    let radii = [ellipsoid.radius_x.si(), ellipsoid.radius_y.si()];
    let exact = EllipticHertz::at_indentation(radii, modulus, depth)?;
    let found = Found {
        indentation_m: Some(depth),
        force_n: Some(exact.force),
        contact_radius_m: Some((exact.semi_axes[0] * exact.semi_axes[1]).sqrt()),
        peak_pressure_pa: Some(exact.peak_pressure),
        ..Found::default()
    };
    Ok(("closed form (elliptic Hertz contact)", found))
}

fn plain(shape: &Shape, modulus: f64, contact: ClosedForm) -> (&'static str, Found) {
    let mean = modulus * contact.force / (PI * contact.radius * contact.radius);
    let of_power = |n: f64| modulus * n * contact.indentation / (PI * (n - 1.0) * contact.radius);
    let peak_pressure_pa = if let Shape::Power(power) = shape {
        Some(power.exponent.si()).filter(|n| *n > 1.0).map(of_power)
    } else {
        matches!(shape, Shape::Paraboloid(_)).then_some(1.5 * mean)
    };
    let found = Found {
        indentation_m: Some(contact.indentation),
        force_n: Some(modulus * contact.force),
        contact_radius_m: Some(contact.radius),
        peak_pressure_pa,
        ..Found::default()
    };
    ("closed form", found)
}

/// The contact of E* = 1 without adhesion.
fn axisymmetric(shape: &Shape, d: f64) -> Attempt<Option<ClosedForm>> {
    let at_angle = |form: &dyn Fn(f64) -> ClosedForm| {
        let angle = root::brent(|angle| form(angle).indentation - d, 0.0, FRAC_PI_2 * (1.0 - 1e-12))?;
        Ok(Some(ClosedForm { indentation: d, ..form(angle) }))
    };
    match shape {
        Shape::Paraboloid(s) => Ok(Some(closed_forms::hertz(s.radius.si(), d))),
        Shape::Sphere(s) => sphere(s.radius.si(), d).map(Some),
        Shape::Cone(s) => Ok(Some(closed_forms::cone(s.slope.si(), d))),
        Shape::Power(s) => Ok(Some(power(s.coefficient.si(), s.exponent.si(), d))),
        Shape::FlatPunch(s) => Ok(Some(closed_forms::flat_punch(s.radius.si(), d))),
        Shape::TruncatedCone(s) => {
            at_angle(&|angle| closed_forms::truncated_cone(s.flat_radius.si(), s.slope.si(), angle))
        }
        Shape::TruncatedParaboloid(s) => {
            at_angle(&|angle| closed_forms::truncated_paraboloid(s.flat_radius.si(), s.radius.si(), angle))
        }
        Shape::RoundedPunch(s) => {
            at_angle(&|angle| closed_forms::rounded_punch(s.flat_radius.si(), s.edge_radius.si(), angle))
        }
        Shape::RoundedCone(s) => {
            let ball = closed_forms::hertz(s.radius.si(), d);
            if ball.radius <= s.radius.si() * s.slope.si() {
                return Ok(Some(ball));
            }
            at_angle(&|angle| closed_forms::rounded_cone(s.radius.si(), s.slope.si(), angle))
        }
        Shape::Spheres(_)
        | Shape::WavyParaboloid(_)
        | Shape::Ellipsoid(_)
        | Shape::Table(_)
        | Shape::SmoothTable(_)
        | Shape::RoughLine(_)
        | Shape::HeightMap(..)
        | Shape::Topography(_)
        | Shape::Tips(_)
        | Shape::Cylinder(_)
        | Shape::PlaneWave(_)
        | Shape::PlaneWavy(_)
        | Shape::Pad(_) => Ok(None),
    }
}

/// The rapidity t of a sphere: t tanh t = d/R, between √(d/R) and d/R + √(d/R).
fn sphere(radius: f64, d: f64) -> Attempt<ClosedForm> {
    let of = |t: f64| closed_forms::sphere(radius, t);
    let low = (d / radius).sqrt();
    let rapidity = root::brent(|t| of(t).indentation - d, 0.5 * low, low + low * low)?;
    Ok(ClosedForm { indentation: d, ..of(rapidity) })
}

/// d grows as aⁿ.
fn power(coefficient: f64, exponent: f64, d: f64) -> ClosedForm {
    let unit = closed_forms::power(coefficient, exponent, 1.0).indentation;
    let contact = closed_forms::power(coefficient, exponent, (d / unit).powf(1.0 / exponent));
    ClosedForm { indentation: d, ..contact }
}

/// DMT ball at an indentation: Hertz's contact less 2πwR.
fn dmt_ball(ball: &Paraboloid, modulus: f64, work: f64, d: f64) -> (&'static str, Found) {
    let hertz = closed_forms::hertz(ball.radius.si(), d);
    let force = modulus * hertz.force - 2.0 * PI * work * ball.radius.si();
    let (indentation_m, force_n) = (Some(d), Some(force));
    let found = Found { indentation_m, force_n, contact_radius_m: Some(hertz.radius), ..Found::default() };
    ("closed form (Derjaguin, Muller & Toporov)", found)
}

/// JKR ball at an indentation: d = a²/R − √(2πaw/E*), F = 4E*a³/3R − √(8πE*wa³), on the branch of wide contacts.
fn jkr_ball(ball: &Paraboloid, modulus: f64, work: f64, d: f64) -> Attempt<(&'static str, Found)> {
    let radius = ball.radius.si();
    let stretch = |a: f64| (2.0 * PI * a * work / modulus).sqrt();
    // dd/da = 0 at a³ = πwR²/8E*; the branch begins there.
    let least = (PI * work * radius * radius / (8.0 * modulus)).cbrt();
    let wide = (radius * d.max(0.0)).sqrt() + 8.0 * least;
    let a = root::brent(|a| a * a / radius - stretch(a) - d, least, wide)?;
    let force = 4.0 * modulus * a.powi(3) / (3.0 * radius) - (8.0 * PI * modulus * work).sqrt() * a * a.sqrt();
    let (indentation_m, force_n) = (Some(d), Some(force));
    let found = Found { indentation_m, force_n, contact_radius_m: Some(a), ..Found::default() };
    Ok(("closed form (Johnson, Kendall & Roberts)", found))
}
