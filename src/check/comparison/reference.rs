//! What the errors are relative to: a closed form, or the finest grid, or the direct path.

use super::methods::Scenario;
use super::{Method, Row, State};
use crate::check::closed_forms::{self, Contact};
use crate::contact::adhesion::Adhesion;
use crate::contact::elliptic::EllipticHertz;
use crate::numerics::root;
use crate::shape::Shape;
use std::f64::consts::{FRAC_PI_2, PI};

/// Fills in the errors; gives the name and the state of the reference.
pub(super) fn of(scenario: &Scenario<'_>, rows: &mut [Row]) -> (String, State) {
    let known = if scenario.replayed { closed_form(scenario) } else { None };
    let (mut name, mut state, own) = match known {
        Some((name, state)) => (name.to_owned(), state, None),
        None => finest(scenario, rows),
    };
    let direct = rows.iter().position(|row| row.method == Method::Direct);
    let mut own_pressure = own;
    if let (None, Some(at)) = (state.peak_pressure_pa, direct.filter(|_| own.is_none())) {
        state.peak_pressure_pa = rows[at].state.peak_pressure_pa;
        if state.peak_pressure_pa.is_some() {
            name.push_str("; largest pressure: direct path");
            own_pressure = Some(at);
        }
    }
    for (at, row) in rows.iter_mut().enumerate() {
        let error = |value: f64, right: f64| Some(value / right - 1.0).filter(|error| error.is_finite());
        if own != Some(at) {
            row.force_error = error(row.state.force_n, state.force_n);
            let radii = row.state.contact_radius_m.zip(state.contact_radius_m);
            row.radius_error = radii.and_then(|(value, right)| error(value, right));
        }
        if own_pressure != Some(at) {
            let pressures = row.state.peak_pressure_pa.zip(state.peak_pressure_pa);
            row.pressure_error = pressures.and_then(|(value, right)| error(value, right));
        }
    }
    (name, state)
}

/// The finest half-space grid, else the direct path, with the number of its row.
fn finest(scenario: &Scenario<'_>, rows: &[Row]) -> (String, State, Option<usize>) {
    let grids = rows.iter().enumerate().filter(|(_, row)| row.method == Method::HalfSpace);
    if let Some((at, row)) = grids.max_by_key(|(_, row)| row.grid) {
        let n = row.grid.unwrap_or(0);
        return (format!("half-space on {n}² pixels, the finest grid"), row.state, Some(at));
    }
    let at = rows.iter().position(|row| row.method == Method::Direct);
    ("direct path, exact for this model".to_owned(), at.map_or(scenario.most, |at| rows[at].state), at)
}

/// The closed form of the state at its indentation.
fn closed_form(scenario: &Scenario<'_>) -> Option<(&'static str, State)> {
    let (shape, modulus) = (&scenario.setup.scene.shape, scenario.setup.pair.normal);
    let d = scenario.most.indentation_m;
    match &scenario.setup.scene.adhesion {
        None => {}
        Some(Adhesion::Jkr(jkr)) => return jkr_ball(shape, (modulus, jkr.work.si()), d),
        Some(Adhesion::Maugis(_)) => return None,
    }
    if let Shape::Ellipsoid(ellipsoid) = shape {
        let radii = [ellipsoid.radius_x.si(), ellipsoid.radius_y.si()];
        let exact = EllipticHertz::at_indentation(radii, modulus, d).ok()?;
        let state = State {
            indentation_m: d,
            force_n: exact.force,
            contact_radius_m: Some((exact.semi_axes[0] * exact.semi_axes[1]).sqrt()),
            peak_pressure_pa: Some(exact.peak_pressure),
            ..State::default()
        };
        return Some(("closed form (elliptic Hertz contact)", state));
    }
    let contact = axisymmetric(shape, d)?;
    let mean = modulus * contact.force / (PI * contact.radius * contact.radius);
    let peak_pressure_pa = match shape {
        Shape::Paraboloid(_) => Some(1.5 * mean),
        Shape::Power(power) if power.exponent.si() > 1.0 => {
            let n = power.exponent.si();
            Some(modulus * n * d / (PI * (n - 1.0) * contact.radius))
        }
        _ => None,
    };
    let state = State {
        indentation_m: d,
        force_n: modulus * contact.force,
        contact_radius_m: Some(contact.radius),
        peak_pressure_pa,
        ..State::default()
    };
    Some(("closed form", state))
}

/// The contact of E* = 1 without adhesion.
fn axisymmetric(shape: &Shape, d: f64) -> Option<Contact> {
    let at_angle = |form: &dyn Fn(f64) -> Contact| {
        let angle = root::brent(|angle| form(angle).indentation - d, 0.0, FRAC_PI_2 * (1.0 - 1e-12)).ok()?;
        Some(form(angle))
    };
    match shape {
        Shape::Paraboloid(s) => Some(closed_forms::hertz(s.radius.si(), d)),
        Shape::Sphere(s) => {
            let of = |t: f64| closed_forms::sphere(s.radius.si(), t);
            // t tanh t = d/R, between √(d/R) and d/R + √(d/R).
            let low = (d / s.radius.si()).sqrt();
            Some(of(root::brent(|t| of(t).indentation - d, 0.5 * low, low + low * low).ok()?))
        }
        Shape::Cone(s) => Some(closed_forms::cone(s.slope.si(), d)),
        Shape::Power(s) => {
            let unit = closed_forms::power(s.coefficient.si(), s.exponent.si(), 1.0).indentation;
            Some(closed_forms::power(s.coefficient.si(), s.exponent.si(), (d / unit).powf(1.0 / s.exponent.si())))
        }
        Shape::FlatPunch(s) => Some(closed_forms::flat_punch(s.radius.si(), d)),
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
                return Some(ball);
            }
            at_angle(&|angle| closed_forms::rounded_cone(s.radius.si(), s.slope.si(), angle))
        }
        _ => None,
    }
}

/// JKR ball at an indentation: d = a²/R − √(2πaw/E*), F = 4E*a³/3R − √(8πE*wa³), on the branch of wide contacts.
fn jkr_ball(shape: &Shape, (modulus, work): (f64, f64), d: f64) -> Option<(&'static str, State)> {
    let Shape::Paraboloid(ball) = shape else { return None };
    let radius = ball.radius.si();
    let stretch = |a: f64| (2.0 * PI * a * work / modulus).sqrt();
    // dd/da = 0 at a³ = πwR²/8E*; the branch begins there.
    let least = (PI * work * radius * radius / (8.0 * modulus)).cbrt();
    let wide = (radius * d.max(0.0)).sqrt() + 8.0 * least;
    let a = root::brent(|a| a * a / radius - stretch(a) - d, least, wide).ok()?;
    let force = 4.0 * modulus * a.powi(3) / (3.0 * radius) - (8.0 * PI * modulus * work).sqrt() * a * a.sqrt();
    let state = State { indentation_m: d, force_n: force, contact_radius_m: Some(a), ..State::default() };
    Some(("closed form (Johnson, Kendall & Roberts)", state))
}
