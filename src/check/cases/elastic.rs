//! Elastic contacts with closed answers.

use crate::check::case::{Case, Proof, worst};
use crate::contact::adhesion::line::EdgeLine;
use crate::contact::direct::QuasiStatic;
use crate::contact::elliptic;
use crate::contact::foundation::HalfSpace;
use crate::contact::loaded::Loaded;
use crate::contact::springs::{EdgeLocation, SpringBed};
use crate::input::quantity::{Length, Positive};
use crate::shape::{FlatPunch, Paraboloid, Power, Profile};
use std::f64::consts::PI;
use std::sync::Arc;

const ROUNDING: &str = "closed forms, a dozen roundings";

pub(super) const CASES: &[Case] = &[
    Case {
        name: "hertz/steel ball",
        proof: Proof::Rounding,
        bound: 1e-14,
        reason: ROUNDING,
        weak: "one state; the property tests span the decades",
        error: || steel_ball().unwrap_or(f64::NAN),
    },
    Case {
        name: "hertz/rail and wheel",
        proof: Proof::Bound,
        bound: 0.03,
        reason: "Popov's answer 1.0 GPa and 6.8 mm has two digits",
        weak: "a rounded book answer (Popov, Contact Mechanics and Friction, ch. 5, problem 1)",
        error: || rail_and_wheel().unwrap_or(f64::NAN),
    },
    Case {
        name: "power/stretch factors",
        proof: Proof::Rounding,
        bound: 1e-12,
        reason: "references with twelve digits",
        weak: "the factor κₙ, not a contact",
        error: || stretch_factors().unwrap_or(f64::NAN),
    },
    Case {
        name: "power/force and pressure",
        proof: Proof::Rounding,
        bound: 1e-12,
        reason: "F = 2n/(n+1) E*da; ∫p dA = F by quadrature with a root end",
        weak: "the pressure is checked through its integral",
        error: || power_law().unwrap_or(f64::NAN),
    },
    Case {
        name: "punch/force, pressure and surface",
        proof: Proof::Rounding,
        bound: 1e-14,
        reason: ROUNDING,
        weak: "one radius; the property tests span the decades",
        error: || flat_punch().unwrap_or(f64::NAN),
    },
    Case {
        name: "stress/hertz on the axis",
        proof: Proof::Rounding,
        bound: 1e-12,
        reason: "σ_zz and σ_xx as Popov 2010, eqs. 5.47 and 5.48; a quadrature over punches",
        weak: "the axis only",
        error: || stress_on_axis().unwrap_or(f64::NAN),
    },
    Case {
        name: "stress/depth of the largest shear",
        proof: Proof::Bound,
        bound: 0.02,
        reason: "the book's 0.49 a at ν = 0.33 has two digits",
        weak: "a rounded book answer",
        error: || depth_of_largest_shear().unwrap_or(f64::NAN),
    },
    Case {
        name: "ellipsoid/mean radius",
        proof: Proof::Rounding,
        bound: 1e-12,
        reason: "elliptic Hertz contact with thirty digits: −0.99 % and −5.08 % of the force at R₁/R₂ = 2 and 5",
        weak: "says how wrong the effective radius is; nothing else is computed with it",
        error: || ellipsoid().unwrap_or(f64::NAN),
    },
    Case {
        name: "bed/hertz envelope",
        proof: Proof::Bound,
        bound: 1.0,
        reason: "−1/4 ≤ ε(a/h)² ≤ 1/8 + (h/a)²/384, printed as the part of the envelope used",
        weak: "the paraboloid only",
        error: || bed_envelope().unwrap_or(f64::NAN),
    },
];

fn indented<P: Profile + Clone + 'static>(profile: &P, modulus: f64, d: f64) -> Option<QuasiStatic> {
    let mut contact = QuasiStatic::new(EdgeLine::new(HalfSpace::new(Arc::new(profile.clone()), modulus), 0.0));
    contact.indent(d).ok()?;
    Some(contact)
}

fn steel_ball() -> Option<f64> {
    let ball = Paraboloid { radius: Length::new(0.01).ok()? };
    let contact = indented(&ball, 210e9 / 0.91, 1e-6)?;
    let state = contact.present().balance;
    Some(worst(&[
        (state.force, 30.769_230_769_230_77),
        (state.contact_radius, 1e-4),
        (contact.pressure(0.0), 1.469_122_551_617_495e9),
    ]))
}

fn rail_and_wheel() -> Option<f64> {
    let wheel = Paraboloid { radius: Length::new(0.5).ok()? };
    let modulus = 210e9 / 0.91 / 2.0;
    let mut contact = QuasiStatic::new(EdgeLine::new(HalfSpace::new(Arc::new(wheel.clone()), modulus), 0.0));
    contact.press(1e5).ok()?;
    Some(worst(&[(contact.pressure(0.0), 1.0e9), (contact.present().balance.contact_radius, 6.8e-3)]))
}

fn stretch_factors() -> Option<f64> {
    let of = |n: f64, right: f64| {
        let power = Power { coefficient: Positive::new(1.0).ok()?, exponent: Positive::new(n).ok()? };
        Some((power.reduced(1.0), right))
    };
    let pairs: Option<Vec<_>> = [
        (1.0, PI / 2.0),
        (2.0, 2.0),
        (3.0, 0.75 * PI),
        (4.0, 8.0 / 3.0),
        (0.5, 1.311_028_777_146),
        (2.5, 2.185_047_961_910),
    ]
    .into_iter()
    .map(|(n, right)| of(n, right))
    .collect();
    Some(worst(&pairs?))
}

fn power_law() -> Option<f64> {
    let mut pairs = Vec::new();
    for n in [1.5, 2.5, 4.0] {
        let power = Power { coefficient: Positive::new(3.0).ok()?, exponent: Positive::new(n).ok()? };
        let contact = indented(&power, 2.0, 0.1)?;
        let state = contact.present().balance;
        pairs.push((state.force, 2.0 * n / (n + 1.0) * 2.0 * 0.1 * state.contact_radius));
        let a = state.contact_radius;
        let ring = |inner: f64, _outer: f64| contact.pressure(inner) * 2.0 * PI * inner;
        pairs.push((crate::numerics::quadrature::panel_with_root_ends(ring, a), state.force));
    }
    Some(worst(&pairs))
}

fn flat_punch() -> Option<f64> {
    let (b, modulus, d) = (0.3, 2.0, 1e-3);
    let punch = FlatPunch { radius: Length::new(b).ok()? };
    let contact = indented(&punch, modulus, d)?;
    Some(worst(&[
        (contact.present().balance.force, 2.0 * modulus * b * d),
        (contact.pressure(0.6 * b), modulus * d / (PI * 0.8 * b)),
        (contact.surface(2.0 * b), d / 3.0),
        (contact.energy().elastic, modulus * b * d * d),
    ]))
}

/// A ball of R = 1 pressed to a = 0.1 with E* = 1: p₀ = 2a/π.
fn loaded(ball: &Paraboloid) -> Loaded {
    Loaded::elastic(HalfSpace::new(Arc::new(ball.clone()), 1.0), 0.1, 0.0)
}

fn stress_on_axis() -> Option<f64> {
    let ball = Paraboloid { radius: Length::new(1.0).ok()? };
    let peak = 0.2 / PI;
    let at = |part: f64| {
        let row = loaded(&ball).on_axis(0.1 * part, 0.33);
        let spread = 0.5 / (1.0 + part * part);
        let radial = -peak * (1.33 * (1.0 - part * (1.0 / part).atan()) - spread);
        [(row.axial, -2.0 * peak * spread), (row.radial, radial)]
    };
    Some(worst(&[0.01, 0.1, 0.49, 1.0, 3.0].map(at).concat()))
}

fn depth_of_largest_shear() -> Option<f64> {
    let ball = Paraboloid { radius: Length::new(1.0).ok()? };
    let deepest = loaded(&ball).hardest(0.33)?;
    Some(worst(&[(deepest.depth / 0.1, 0.49)]))
}

fn ellipsoid() -> Option<f64> {
    let error = |ratio: f64| elliptic::mean_radius_error([1.0, ratio]).ok();
    Some(worst(&[(error(2.0)?, -0.009_894_417_835_467_63), (error(5.0)?, -0.050_836_018_243_976_77)]))
}

/// The largest part of the proved envelope that a scan over the place of the edge uses.
fn bed_envelope() -> Option<f64> {
    let ground = HalfSpace::new(Arc::new(Paraboloid { radius: Length::new(1.0).ok()? }), 1.0);
    let (springs, reach) = (200, 0.04);
    let spacing = reach / f64::from(springs);
    let part = |k: i32| {
        let d = 4e-4 * (1.0 + 1e-3 * f64::from(k));
        let mut bed = SpringBed::new(ground.clone(), (200, reach), 0.0).with_edge(EdgeLocation::AtSprings);
        bed.indent(d);
        let scaled = (bed.force() / (4.0 / 3.0 * d.powf(1.5)) - 1.0) * d / (spacing * spacing);
        let highest = 0.125 + spacing * spacing / d / 384.0;
        if scaled > 0.0 { scaled / highest } else { scaled / -0.25 }
    };
    // A rounding of the force is 1e-12 of the envelope at this width.
    Some((0..400).map(part).fold(0.0, f64::max) - 1e-9)
}
