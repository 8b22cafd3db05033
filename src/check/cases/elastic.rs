//! Elastic contacts with closed answers.

use crate::check::case::{Attempt, Case, Pairs, Proof};
use crate::check::contacts::{indented, paraboloid, plain};
use crate::check::sketch::si;
use crate::contact::elliptic;
use crate::contact::foundation::Foundation;
use crate::contact::loaded::Loaded;
use crate::contact::springs::{EdgeLocation, SpringBed};
use crate::numerics::quadrature;
use crate::shape::{FlatPunch, Paraboloid, Power, Profile};
use std::f64::consts::PI;
use std::sync::Arc;

const ROUNDING: &str = "closed forms, a dozen roundings";

pub(super) const CASES: &[Case] = &[
    Case::new("hertz/steel ball", Proof::Rounding, 1e-14, ROUNDING)
        .weak("one state; the property tests span the decades")
        .by(steel_ball),
    Case::new("hertz/rail and wheel", Proof::Bound, 0.03, "Popov's answer 1.0 GPa and 6.8 mm has two digits")
        .weak("a rounded book answer (Popov, Contact Mechanics and Friction, ch. 5, problem 1)")
        .by(rail_and_wheel),
    Case::new("power/stretch factors", Proof::Rounding, 1e-12, "references with twelve digits")
        .weak("the factor κₙ, not a contact")
        .by(stretch_factors),
    Case::new(
        "power/force and pressure",
        Proof::Rounding,
        1e-12,
        "F = 2n/(n+1) E*da; ∫p dA = F by quadrature with a root end",
    )
    .weak("the pressure is checked through its integral")
    .by(power_law),
    Case::new("punch/force, pressure and surface", Proof::Rounding, 1e-14, ROUNDING)
        .weak("one radius; the property tests span the decades")
        .by(flat_punch),
    Case::new(
        "stress/hertz on the axis",
        Proof::Rounding,
        1e-12,
        "σ_zz and σ_xx as Popov 2010, eqs. 5.47 and 5.48; a quadrature over punches",
    )
    .weak("the axis only")
    .by(stress_on_axis),
    Case::new("stress/depth of the largest shear", Proof::Bound, 0.02, "the book's 0.49 a at ν = 0.33 has two digits")
        .weak("a rounded book answer")
        .by(depth_of_largest_shear),
    Case::new(
        "ellipsoid/mean radius",
        Proof::Rounding,
        1e-12,
        "elliptic Hertz contact with thirty digits: −0.99 % and −5.08 % of the force at R₁/R₂ = 2 and 5",
    )
    .weak("says how wrong the effective radius is; nothing else is computed with it")
    .by(ellipsoid),
    Case::new(
        "bed/hertz envelope",
        Proof::Bound,
        1.0,
        "−1/4 ≤ ε(a/h)² ≤ 1/8 + (h/a)²/384, printed as the part of the envelope used",
    )
    .weak("the paraboloid only")
    .by(bed_envelope),
];

fn steel_ball() -> Attempt<Pairs> {
    let ball = paraboloid(0.01)?;
    let contact = indented(ball.clone(), 210e9 / 0.91, 1e-6)?;
    let state = contact.present().balance;
    let pressure = (contact.loaded().pressure(0.0), 1.469_122_551_617_495e9);
    Ok(vec![(state.force, 30.769_230_769_230_77), (state.contact_radius, 1e-4), pressure])
}

fn rail_and_wheel() -> Attempt<Pairs> {
    let wheel = paraboloid(0.5)?;
    let mut contact = plain(wheel.clone(), 210e9 / 0.91 / 2.0);
    contact.press(1e5)?;
    Ok(vec![(contact.loaded().pressure(0.0), 1.0e9), (contact.present().balance.contact_radius, 6.8e-3)])
}

fn power(coefficient: f64, exponent: f64) -> Attempt<Arc<Power>> {
    Ok(Arc::new(Power { coefficient: si(coefficient)?, exponent: si(exponent)? }))
}

fn stretch_factors() -> Attempt<Pairs> {
    let factors = [
        (1.0, PI / 2.0),
        (2.0, 2.0),
        (3.0, 0.75 * PI),
        (4.0, 8.0 / 3.0),
        (0.5, 1.311_028_777_146),
        (2.5, 2.185_047_961_910),
    ];
    factors.into_iter().map(|(n, right)| Ok((power(1.0, n)?.reduced(1.0), right))).collect()
}

fn power_law() -> Attempt<Pairs> {
    let mut pairs = Vec::new();
    for n in [1.5, 2.5, 4.0] {
        let shape = power(3.0, n)?;
        let contact = indented(shape.clone(), 2.0, 0.1)?;
        let state = contact.present().balance;
        pairs.push((state.force, 2.0 * n / (n + 1.0) * 2.0 * 0.1 * state.contact_radius));
        let ring = |inner: f64, _outer: f64| contact.loaded().pressure(inner) * 2.0 * PI * inner;
        pairs.push((quadrature::panel_with_root_ends(ring, state.contact_radius), state.force));
    }
    Ok(pairs)
}

fn flat_punch() -> Attempt<Pairs> {
    let (b, modulus, d) = (0.3, 2.0, 1e-3);
    let punch = Arc::new(FlatPunch { radius: si(b)? });
    let contact = indented(punch.clone(), modulus, d)?;
    Ok(vec![
        (contact.present().balance.force, 2.0 * modulus * b * d),
        (contact.loaded().pressure(0.6 * b), modulus * d / (PI * 0.8 * b)),
        (contact.loaded().surface(2.0 * b), d / 3.0),
        (contact.energy().elastic, modulus * b * d * d),
    ])
}

/// A ball of R = 1 pressed to a = 0.1 with E* = 1: p₀ = 2a/π.
fn loaded(ball: Arc<Paraboloid>) -> Loaded {
    Loaded::elastic(Foundation::new(ball, 1.0), 0.1, 0.0)
}

fn stress_on_axis() -> Attempt<Pairs> {
    let ball = paraboloid(1.0)?;
    let peak = 0.2 / PI;
    let at = |part: f64| {
        let row = loaded(ball.clone()).on_axis(0.1 * part, 0.33);
        let spread = 0.5 / (1.0 + part * part);
        let radial = -peak * (1.33 * (1.0 - part * (1.0 / part).atan()) - spread);
        [(row.axial, -2.0 * peak * spread), (row.radial, radial)]
    };
    Ok([0.01, 0.1, 0.49, 1.0, 3.0].map(at).concat())
}

fn depth_of_largest_shear() -> Attempt<Pairs> {
    let deepest = loaded(paraboloid(1.0)?).hardest(0.33).ok_or("no depth")?;
    Ok(vec![(deepest.depth / 0.1, 0.49)])
}

fn ellipsoid() -> Attempt<Pairs> {
    let error = |ratio: f64| elliptic::mean_radius_error([1.0, ratio]);
    Ok(vec![(error(2.0)?, -0.009_894_417_835_467_63), (error(5.0)?, -0.050_836_018_243_976_77)])
}

/// The largest part of the proved envelope that a scan over the place of the edge uses.
fn bed_envelope() -> Attempt<Pairs> {
    let ground = Foundation::new(paraboloid(1.0)?, 1.0);
    let (springs, reach) = (200, 0.04);
    let spacing = reach / f64::from(springs);
    let part = |k: i32| {
        let d = 4e-4 * (1.0 + 1e-3 * f64::from(k));
        let mut bed = SpringBed::new(ground.clone(), 200, reach, 0.0).with_edge(EdgeLocation::AtSprings);
        bed.indent(d);
        let scaled = (bed.force() / (4.0 / 3.0 * d.powf(1.5)) - 1.0) * d / (spacing * spacing);
        let highest = 0.125 + spacing * spacing / d / 384.0;
        if scaled > 0.0 { scaled / highest } else { scaled / -0.25 }
    };
    // A rounding of the force is 1e-12 of the envelope at this width.
    Ok(vec![((0..400).map(part).fold(0.0, f64::max) - 1e-9, 0.0)])
}
