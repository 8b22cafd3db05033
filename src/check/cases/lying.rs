//! A lying cylinder and a wave, run as whole scenes: E* = W = 1, R = 1 with the half-plane at rest at the distance 1, or
//! Δ = 0.01 and λ = 1.

use crate::check::case::{Attempt, Case, Pairs, Proof};
use crate::check::sketch::{Sketch, beside, relaxing, result, si};
use crate::check::ting::TingTriangle;
use crate::material::Relaxation;
use crate::numerics::{extremum, quadrature};
use crate::shape::{Cylinder, PlaneWave, Shape};
use std::f64::consts::PI;

const CLOSED: &str = "closed forms in the half width, a few dozen roundings; the place of an edge in the bed counts ln(2L/a) times in it";
const SUMS: &str =
    "sums over panels against the same integral over the half width: a few hundred roundings of the greatest force";

pub(super) const CASES: &[Case] = &[
    Case::new("cylinder/hertz", Proof::Rounding, 1e-12, CLOSED)
        .weak("one force; half width, depth, energy and pressure in the middle")
        .by(hertz),
    Case::new("cylinder/jkr under a force", Proof::Rounding, 1e-12, CLOSED)
        .weak("one force; the way there by a jump into contact")
        .by(adhesive),
    Case::new("cylinder/jkr pull-off", Proof::Rounding, 1e-12, CLOSED)
        .weak("the force of a slow retraction, which does not depend on the datum")
        .by(pull_off),
    Case::new("cylinder/partial slip", Proof::Rounding, 1e-11, CLOSED)
        .weak("one slide, to half of the contact")
        .by(partial_slip),
    Case::new(
        "cylinder/creep under a force",
        Proof::Rounding,
        1e-11,
        "sums of one sign and one root; what rounds the depth rounds the half width ln(2L/a) times",
    )
    .weak("one term; a force that does not fall")
    .by(creep),
    Case::new("cylinder/ting's triangle", Proof::Rounding, 1e-10, SUMS)
        .weak("one term; force and half width after the turn")
        .by(triangle),
    Case::new("wave/jkr under a force", Proof::Rounding, 1e-12, CLOSED)
        .weak("one force, after the jump into contact; depth, half width and energies")
        .by(adhesive_wave),
    Case::new(
        "wave/jkr closes",
        Proof::Rounding,
        1e-11,
        "the top of a curve by its slope, another by comparison of values",
    )
    .weak("the force from which on no open contact is in equilibrium")
    .by(closing_wave),
    Case::new("wave/partial slip", Proof::Rounding, 1e-11, CLOSED)
        .weak("one slide, to half of the contact")
        .by(slipping_wave),
    Case::new("wave/slow relaxation", Proof::Order, 2e-6, "one part in 10⁶ of the relaxation is left")
        .weak("approaches the elastic wave only")
        .by(relaxed_wave),
];

const RISE: f64 = 0.01;

fn wave() -> Attempt<Shape> {
    Ok(Shape::PlaneWave(PlaneWave { amplitude: si(RISE)?, wavelength: si(1.0)?, width: None }))
}

/// Westergaard: p̄ = πΔ sin²(πa), d = Δt(1 − ln t) with t = sin²(πa).
fn share(a: f64) -> f64 {
    (PI * a).sin().powi(2)
}

fn wave_depth(a: f64) -> f64 {
    RISE * share(a) * (1.0 - share(a).ln())
}

/// The strips that are pulled up at the edge: √(2E*wλ tan(πa)) (Johnson 1995).
fn pulled(a: f64, w: f64) -> f64 {
    (2.0 * w * (PI * a).tan()).sqrt()
}

fn adhesive_wave() -> Attempt<Pairs> {
    let (a, w) = (0.2, 1e-5);
    let outcome = Sketch::of(wave()).jkr(w, None).press(PI * RISE * share(a) - pulled(a, w), 1.0).fields()?;
    let right = [
        ("final_contact_radius_m", a),
        ("final_indentation_m", wave_depth(a) + pulled(a, w) * share(a).ln() / PI),
        ("largest_stress_intensity_pa_sqrt_m", (2.0 * w).sqrt()),
        ("final_stored_surface_j", -2.0 * a * w),
    ];
    beside(&outcome, &right)
}

/// The force at which the contact jumps to a closed one is the greatest of any open one.
fn closing_wave() -> Attempt<Pairs> {
    let w = 1e-4;
    let open = |a: f64| PI * RISE * share(a) - pulled(a, w);
    let right = extremum::greatest(open, 0.2, 0.49).value;
    let outcome = Sketch::of(wave()).jkr(w, None).press(PI * RISE, 1.0).run()?;
    let closes = outcome.records.windows(2).find(|pair| pair[1].normal.stiffness.is_infinite());
    let before = closes.map(|pair| pair[0].normal.force).ok_or("the wave does not close")?;
    Ok(vec![(before, right), (outcome.records.last().map_or(0.0, |last| last.normal.stored.surface), -w)])
}

fn slipping_wave() -> Attempt<Pairs> {
    let (a, c, mu) = (0.3, 0.15, 0.3);
    let sketch = Sketch::of(wave()).coulomb(mu).press(PI * RISE * share(a), 1.0);
    let outcome = sketch.slide(mu * (wave_depth(a) - wave_depth(c))).run()?;
    let right = mu * PI * RISE * (share(a) - share(c));
    beside(&outcome, &[("final_stick_radius_m", c), ("final_tangential_force_n", right)])
}

fn relaxed_wave() -> Attempt<Pairs> {
    let sketch = Sketch::of(wave()).body(relaxing(&soft())).indent(wave_depth(0.3), 1.0).hold(8.0);
    beside(&sketch.run()?, &[("final_force_n", PI * RISE * share(0.3)), ("final_contact_radius_m", 0.3)])
}

fn cylinder() -> Attempt<Shape> {
    Ok(Shape::Cylinder(Cylinder { radius: si(1.0)?, datum: si(1.0)?, width: None }))
}

/// Force of a half width (Johnson 1985, eq. 4.43).
fn force(a: f64) -> f64 {
    0.25 * PI * a * a
}

/// Depth of a half width, from the mean of −(2/πE*) p ln(|x − s|/L) over the contact.
fn depth(a: f64) -> f64 {
    0.5 * a * a * ((2.0 / a).ln() + 0.5)
}

fn hertz() -> Attempt<Pairs> {
    let outcome = Sketch::of(cylinder()).press(force(0.1), 1.0).fields()?;
    let right = [
        ("final_contact_radius_m", 0.1),
        ("final_indentation_m", depth(0.1)),
        // U = ½(Pd − ∫ph), ∫ph = Pa²/8R.
        ("final_stored_elastic_j", 0.5 * force(0.1) * (depth(0.1) - 0.01 / 8.0)),
        ("peak_pressure_pa", 0.05),
    ];
    beside(&outcome, &right)
}

/// P = πE*a²/4R − √(2πE*aw) (Barquins 1988; Chaudhury et al. 1996); the strip that is pulled up gives way by
/// its own compliance.
fn adhesive() -> Attempt<Pairs> {
    let (a, w) = (0.1, 1e-5);
    let edge = (2.0 * PI * a * w).sqrt();
    let outcome = Sketch::of(cylinder()).jkr(w, None).press(force(a) - edge, 1.0).fields()?;
    let right = [
        ("final_contact_radius_m", a),
        ("final_indentation_m", depth(a) - edge * 2.0 / PI * (2.0 / a).ln()),
        ("largest_stress_intensity_pa_sqrt_m", (2.0 * w).sqrt()),
        ("final_stored_surface_j", -2.0 * a * w),
    ];
    beside(&outcome, &right)
}

/// Where dP/da = 0: a³ = 2wR²/πE*.
fn pull_off() -> Attempt<Pairs> {
    let w = 1e-5;
    let a = (2.0 * w / PI).cbrt();
    let outcome = Sketch::of(cylinder()).jkr(w, None).press(force(0.1), 1.0).retract(1e-3).run()?;
    beside(&outcome, &[("pull_off_force_n", force(a) - (2.0 * PI * a * w).sqrt())])
}

/// c is where the depth less u/μ stands, and F_x = μ(P(a) − P(c)): c² = a²(1 − F_x/μP) (Johnson 1985, eq. 7.25).
fn partial_slip() -> Attempt<Pairs> {
    let (a, c, mu) = (0.1, 0.05, 0.3);
    let sketch = Sketch::of(cylinder()).coulomb(mu).press(force(a), 1.0).slide(mu * (depth(a) - depth(c)));
    let outcome = sketch.fields()?;
    let mut pairs = beside(
        &outcome,
        &[("final_stick_radius_m", c), ("final_tangential_force_n", mu * force(a) * (1.0 - (c / a).powi(2)))],
    )?;
    // τ = μ(p(a) − p(c)) in the middle.
    let last = outcome.fields.last().and_then(|field| field.rows.first()).ok_or("there is no field")?;
    pairs.push((last.shear.ok_or("there is no shear stress")?, mu * 0.5 * (a - c)));
    Ok(pairs)
}

fn soft() -> Relaxation {
    Relaxation { equilibrium: 1.0, terms: vec![(3.0, 0.5)], viscosity: 0.0 }
}

/// πa²/4R = ∫ J dP with J = 1 − ¾e^(−t/2).
fn creep() -> Attempt<Pairs> {
    let grown = 1.0 - 1.5 * ((-1.5f64).exp() - (-2f64).exp());
    let sketch = Sketch::of(cylinder()).body(relaxing(&soft())).press(0.01, 1.0).hold_force(3.0);
    let a = (0.04 / PI * grown).sqrt();
    beside(&sketch.run()?, &[("final_contact_radius_m", a), ("final_indentation_m", depth(a))])
}

/// As over a ball (Ting 1966): the integral over the strips that touched before t₁, at a half width that was there then.
fn triangle() -> Attempt<Pairs> {
    let greatest = depth(0.1);
    let (speed, ball) = (greatest, TingTriangle { relaxation: soft(), radius: 1.0, speed: greatest, turn: 1.0 });
    let sketch = Sketch::of(cylinder()).body(relaxing(&soft())).steps(20).indent(greatest, 1.0).indent(0.0, 1.0);
    let outcome = sketch.run()?;
    let reference = result(&outcome, "largest_force_n")?;
    let mut pairs = Vec::new();
    for record in outcome.records.iter().filter(|record| record.time > 0.0) {
        let touched = ball.at(record.time)?.1.powi(2) / speed;
        let Some(a) = record.normal.contact_radius.filter(|&a| a > 0.0) else { continue };
        pairs.push((depth(a), speed * touched));
        let at = |a: f64| 0.5 * PI * a * ball.modulus(record.time - depth(a) / speed);
        let breaks: Vec<f64> = (1..16).map(|k| a * f64::from(k) / 16.0).collect();
        let force = quadrature::panels(at, (0.0, a), &breaks);
        pairs.push((1.0 + (record.normal.force - force) / reference, 1.0));
    }
    if pairs.len() < 40 { Err("the bodies parted too early".into()) } else { Ok(pairs) }
}
