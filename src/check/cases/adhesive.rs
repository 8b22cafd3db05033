//! Adhesive contacts with closed answers.

use crate::check::case::{Case, Proof, worst};
use crate::contact::adhesion::equilibrium::BranchError;
use crate::contact::adhesion::line::EdgeLine;
use crate::contact::adhesion::range::RangeDisc;
use crate::contact::direct::QuasiStatic;
use crate::contact::foundation::HalfSpace;
use crate::input::quantity::{Length, Positive};
use crate::shape::{Cone, FlatPunch, Paraboloid, Profile};
use std::f64::consts::PI;
use std::sync::Arc;

const ROUNDING: &str = "a root to two units in the last place and sums of one sign; a hundred roundings allowed";

pub(super) const CASES: &[Case] = &[
    Case {
        name: "jkr/pull-off under force",
        proof: Proof::Rounding,
        bound: 1e-13,
        reason: ROUNDING,
        weak: "one profile in dimensionless form; the property tests span the decades",
        error: || force_pull_off().unwrap_or(f64::NAN),
    },
    Case {
        name: "jkr/pull-off under depth",
        proof: Proof::Rounding,
        bound: 1e-13,
        reason: ROUNDING,
        weak: "the contact radius at a turning point is known to the square root of its depth",
        error: || depth_pull_off().unwrap_or(f64::NAN),
    },
    Case {
        name: "jkr/first touch and zero load",
        proof: Proof::Rounding,
        bound: 1e-13,
        reason: ROUNDING,
        weak: "two points of the stable branch only",
        error: || touch_and_zero_load().unwrap_or(f64::NAN),
    },
    Case {
        name: "jkr/radius under load",
        proof: Proof::Rounding,
        bound: 1e-12,
        reason: ROUNDING,
        weak: "closed form of Johnson, Kendall & Roberts 1971 as in Persson et al. 2008, eq. 1",
        error: || radius_under_load().unwrap_or(f64::NAN),
    },
    Case {
        name: "jkr/work to detach",
        proof: Proof::Rounding,
        bound: 1e-7,
        reason: "the reference 7.092196 has seven digits",
        weak: "the reference is rounded",
        error: || work_to_detach().unwrap_or(f64::NAN),
    },
    Case {
        name: "jkr/cone",
        proof: Proof::Rounding,
        bound: 1e-13,
        reason: ROUNDING,
        weak: "one slope",
        error: || cone().unwrap_or(f64::NAN),
    },
    Case {
        name: "jkr/flat punch",
        proof: Proof::Rounding,
        bound: 1e-13,
        reason: "F = −√(8πE*wb³), lost 2πwb² (Kendall 1971)",
        weak: "one punch",
        error: || flat_punch().unwrap_or(f64::NAN),
    },
    Case {
        name: "jkr/edge stress",
        proof: Proof::Rounding,
        bound: 1e-13,
        reason: "K_I = √(2E*w) at any load, from the edge load −q(a)/√(πa)",
        weak: "the paraboloid only",
        error: || edge_stress().unwrap_or(f64::NAN),
    },
    Case {
        name: "maugis/pull-off over λ",
        proof: Proof::Rounding,
        bound: 1e-12,
        reason: "references with thirty digits from the closed equations; roots within roots",
        weak: "the paraboloid only: no closed equations exist for other shapes",
        error: || maugis_pull_off().unwrap_or(f64::NAN),
    },
];

fn ball() -> Option<Paraboloid> {
    Some(Paraboloid { radius: Length::new(1.0).ok()? })
}

fn unit_jkr<P: Profile + Clone + 'static>(profile: &P) -> QuasiStatic {
    QuasiStatic::new(EdgeLine::new(HalfSpace::new(Arc::new(profile.clone()), 1.0), 1.0))
}

/// (πwR)-scaled turning point under force: a = (9π/8)^{1/3}, F = −1.5π.
fn force_pull_off() -> Option<f64> {
    let ball = ball()?;
    let mut contact = unit_jkr(&ball);
    contact.press(1.0).ok()?;
    let before = contact.press(-5.0).ok()?.first()?.before;
    Some(worst(&[
        (before.force, -1.5 * PI),
        (before.contact_radius, (1.125 * PI).cbrt()),
        (before.indentation, -0.773_416_931_570_034),
    ]))
}

fn depth_pull_off() -> Option<f64> {
    let ball = ball()?;
    let mut contact = unit_jkr(&ball);
    contact.indent(0.5).ok()?;
    let before = contact.indent(-2.0).ok()?.first()?.before;
    Some(worst(&[
        (before.force, -5.0 / 6.0 * PI),
        (before.contact_radius, 0.732_295_943_780_762),
        (before.indentation, -1.608_772_047_833_27),
    ]))
}

fn touch_and_zero_load() -> Option<f64> {
    let ball = ball()?;
    let mut touched = unit_jkr(&ball);
    touched.indent(0.0).ok()?;
    let mut free = unit_jkr(&ball);
    free.press(0.0).ok()?;
    let (touched, free) = (touched.present().balance, free.present().balance);
    Some(worst(&[
        (touched.contact_radius, 1.845_270_148_644_028),
        (touched.force, -4.0 / 3.0 * PI),
        (free.contact_radius, 2.417_987_931_024_707),
        (free.indentation, 1.948_888_544_860_377),
    ]))
}

/// a³ = (3R/4E*)(√F_a + √(F + F_a))², F_a = (3/2)πwR.
fn radius_under_load() -> Option<f64> {
    let radius = 2.5e-3;
    let (modulus, work) = (6.4e6, 0.042);
    let lens = Paraboloid { radius: Length::new(radius).ok()? };
    let pull = 1.5 * PI * work * radius;
    let one = |load: f64| -> Result<(f64, f64), BranchError> {
        let mut contact = QuasiStatic::new(EdgeLine::new(HalfSpace::new(Arc::new(lens.clone()), modulus), work));
        contact.press(load)?;
        let right = (0.75 * radius / modulus * (pull.sqrt() + (load + pull).sqrt()).powi(2)).cbrt();
        Ok((contact.present().balance.contact_radius, right))
    };
    let pairs: Result<Vec<_>, _> = [1e-6, 1e-3, 0.048, 1.0].into_iter().map(one).collect();
    Some(worst(&pairs.ok()?))
}

fn work_to_detach() -> Option<f64> {
    let ball = ball()?;
    let mut contact = unit_jkr(&ball);
    contact.indent(0.0).ok()?;
    let start = contact.energy().stored();
    let jump = *contact.indent(-2.0).ok()?.first()?;
    Some(worst(&[(jump.dissipated - start, 7.092_196)]))
}

fn cone() -> Option<f64> {
    let (slope, work, modulus) = (0.2, 0.7, 3.0);
    let cone = Cone { slope: Positive::new(slope).ok()? };
    let contact = || QuasiStatic::new(EdgeLine::new(HalfSpace::new(Arc::new(cone.clone()), modulus), work));
    let mut pulled = contact();
    pulled.press(0.0).ok()?;
    let by_force = pulled.press(-1e6).ok()?.first()?.before;
    let mut retracted = contact();
    retracted.indent(0.0).ok()?;
    let by_depth = retracted.indent(-1e6).ok()?.first()?.before;
    let unit = work * work / (PI * modulus * slope * slope * slope);
    Some(worst(&[
        (by_force.force, -54.0 * unit),
        (by_force.contact_radius, 18.0 * work / (PI * modulus * slope * slope)),
        (by_depth.indentation, -work / (modulus * slope)),
        (by_depth.force, -6.0 * unit),
    ]))
}

fn flat_punch() -> Option<f64> {
    let (radius, work, modulus) = (0.3, 0.7, 3.0);
    let punch = FlatPunch { radius: Length::new(radius).ok()? };
    let line = EdgeLine::new(HalfSpace::new(Arc::new(punch.clone()), modulus), work);
    let mut contact = QuasiStatic::new(line);
    let touched = *contact.indent(0.0).ok()?.first()?;
    let off = *contact.indent(-1e3).ok()?.first()?;
    Some(worst(&[
        (off.before.force, -(8.0 * PI * modulus * work * radius * radius * radius).sqrt()),
        (touched.dissipated + off.dissipated, 2.0 * PI * work * radius * radius),
    ]))
}

fn edge_stress() -> Option<f64> {
    let ball = ball()?;
    let mut contact = unit_jkr(&ball);
    let mut pairs = Vec::new();
    for d in [0.0, 1.0, -1.0] {
        contact.indent(d).ok()?;
        pairs.push((contact.stress_intensity(), 2f64.sqrt()));
    }
    Some(worst(&pairs))
}

/// With K = 1, R = 1 and πw = 1 the units are one and σ₀ = λ/2. References by golden section on the
/// closed equations with thirty digits.
fn maugis_pull_off() -> Option<f64> {
    let ball = ball()?;
    let references = [
        (0.01, -1.998_287_784_321_51),
        (0.1, -1.950_594_892_123_43),
        (0.5, -1.718_245_274_886_17),
        (1.0, -1.600_734_911_254_09),
        (5.0, -1.506_349_967_716_04),
    ];
    let one = |(lambda, right): (f64, f64)| {
        let disc = RangeDisc::new(HalfSpace::new(Arc::new(ball.clone()), 0.75), 1.0 / PI, 0.5 * lambda).ok()?;
        let mut contact = QuasiStatic::new(disc);
        contact.press(0.0).ok()?;
        Some((contact.press(-3.0).ok()?.last()?.before.force, right))
    };
    let pairs: Option<Vec<_>> = references.into_iter().map(one).collect();
    Some(worst(&pairs?))
}
