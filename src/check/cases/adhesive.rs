//! Adhesive contacts with closed answers.

use crate::check::case::{Attempt, Case, Pairs, Proof};
use crate::check::contacts::{dmt, jkr, maugis, paraboloid};
use crate::check::sketch::si;
use crate::contact::adhesion::equilibrium::Balance;
use crate::contact::adhesion::{Adhesion, Capillary, Range};
use crate::contact::direct::Jump;
use crate::input::quantity::{ContactAngle, Length, SurfaceTension};
use crate::shape::{Cone, FlatPunch, Profile};
use std::f64::consts::PI;
use std::sync::Arc;

const ROUNDING: &str = "a root to two units in the last place and sums of one sign; a hundred roundings allowed";

pub(super) const CASES: &[Case] = &[
    Case::new("jkr/pull-off under force", Proof::Rounding, 1e-13, ROUNDING)
        .weak("one profile in dimensionless form; the property tests span the decades")
        .by(force_pull_off),
    Case::new("jkr/pull-off under depth", Proof::Rounding, 1e-13, ROUNDING)
        .weak("the contact radius at a turning point is known to the square root of its depth")
        .by(depth_pull_off),
    Case::new("jkr/first touch and zero load", Proof::Rounding, 1e-13, ROUNDING)
        .weak("two points of the stable branch only")
        .by(touch_and_zero_load),
    Case::new("jkr/radius under load", Proof::Rounding, 1e-12, ROUNDING)
        .weak("closed form of Johnson, Kendall & Roberts 1971 as in Persson et al. 2008, eq. 1")
        .by(radius_under_load),
    Case::new("jkr/work to detach", Proof::Rounding, 1e-7, "the reference 7.092196 has seven digits")
        .weak("the reference is rounded")
        .by(work_to_detach),
    Case::new("jkr/cone", Proof::Rounding, 1e-13, ROUNDING).weak("one slope").by(cone),
    Case::new("jkr/flat punch", Proof::Rounding, 1e-13, "F = −√(8πE*wb³), lost 2πwb² (Kendall 1971)")
        .weak("one punch")
        .by(flat_punch),
    Case::new("jkr/edge stress", Proof::Rounding, 1e-13, "K_I = √(2E*w) at any load, from the edge load −q(a)/√(πa)")
        .weak("the paraboloid only")
        .by(edge_stress),
    Case::new(
        "jkr/pull-off behind a spring",
        Proof::Rounding,
        2e-7,
        "lost where dF/dd = −k, with F and d of JKR's closed form at the radius of the jump",
    )
    .weak("the radius at a turning point is known to the square root of rounding")
    .by(behind_a_spring),
    Case::new(
        "dmt/ball",
        Proof::Rounding,
        1e-13,
        "F = (4/3)E*√R d^{3/2} − 2πwR, torn off by 2πwR (Derjaguin et al. 1975)",
    )
    .weak("the paraboloid only: other shapes have no such force")
    .by(dmt_ball),
    Case::new("dmt/limit of hard bodies", Proof::Other, 2e-3, "Maugis' contact at λ = 0.001, away from it by some λ")
        .weak("the first order in λ is not known in closed form")
        .by(dmt_limit),
    Case::new(
        "maugis/pull-off over λ",
        Proof::Rounding,
        1e-12,
        "references with thirty digits from the closed equations; roots within roots",
    )
    .weak("the paraboloid only: no closed equations exist for other shapes")
    .by(maugis_pull_off),
    Case::new(
        "maugis/bridge of liquid",
        Proof::Rounding,
        1e-12,
        "w = 2γ cos θ and σ₀ = γ/r_K at λ = 1, where a ball is torn off by 1.60073491125409 πwR",
    )
    .weak("the paraboloid only: no closed equations exist for other shapes")
    .by(bridge_pull_off),
];

/// The first jump of a motion.
pub(super) fn first(jumps: &[Jump]) -> Attempt<Jump> {
    jumps.first().copied().ok_or_else(|| "the bodies do not part".into())
}

/// The state just before the bodies part: brought to zero force and pulled to `force`.
pub(super) fn pulled(profile: Arc<dyn Profile>, modulus: f64, work: f64, force: f64) -> Attempt<Balance> {
    let mut contact = jkr(profile, modulus, work);
    contact.press(0.0)?;
    Ok(first(&contact.press(force)?)?.before)
}

/// The state just before the bodies part: brought to first touch and retracted to `depth`.
pub(super) fn retracted(profile: Arc<dyn Profile>, modulus: f64, work: f64, depth: f64) -> Attempt<Balance> {
    let mut contact = jkr(profile, modulus, work);
    contact.indent(0.0)?;
    Ok(first(&contact.indent(depth)?)?.before)
}

/// (πwR)-scaled turning point under force: a = (9π/8)^{1/3}, F = −1.5π.
fn force_pull_off() -> Attempt<Pairs> {
    let ball = paraboloid(1.0)?;
    let mut contact = jkr(ball.clone(), 1.0, 1.0);
    contact.press(1.0)?;
    let before = first(&contact.press(-5.0)?)?.before;
    let depth = (before.indentation, -0.773_416_931_570_034);
    Ok(vec![(before.force, -1.5 * PI), (before.contact_radius, (1.125 * PI).cbrt()), depth])
}

fn depth_pull_off() -> Attempt<Pairs> {
    let ball = paraboloid(1.0)?;
    let mut contact = jkr(ball.clone(), 1.0, 1.0);
    contact.indent(0.5)?;
    let before = first(&contact.indent(-2.0)?)?.before;
    let radius = (before.contact_radius, 0.732_295_943_780_762);
    Ok(vec![(before.force, -5.0 / 6.0 * PI), radius, (before.indentation, -1.608_772_047_833_27)])
}

fn touch_and_zero_load() -> Attempt<Pairs> {
    let ball = paraboloid(1.0)?;
    let (mut touched, mut free) = (jkr(ball.clone(), 1.0, 1.0), jkr(ball.clone(), 1.0, 1.0));
    touched.indent(0.0)?;
    free.press(0.0)?;
    let (touched, free) = (touched.present().balance, free.present().balance);
    Ok(vec![
        (touched.contact_radius, 1.845_270_148_644_028),
        (touched.force, -4.0 / 3.0 * PI),
        (free.contact_radius, 2.417_987_931_024_707),
        (free.indentation, 1.948_888_544_860_377),
    ])
}

/// a³ = (3R/4E*)(√F_a + √(F + F_a))², F_a = (3/2)πwR.
fn radius_under_load() -> Attempt<Pairs> {
    let (radius, modulus, work) = (2.5e-3, 6.4e6, 0.042);
    let lens = paraboloid(radius)?;
    let pull = 1.5 * PI * work * radius;
    let one = |load: f64| {
        let mut contact = jkr(lens.clone(), modulus, work);
        contact.press(load)?;
        let right = (0.75 * radius / modulus * (pull.sqrt() + (load + pull).sqrt()).powi(2)).cbrt();
        Ok((contact.present().balance.contact_radius, right))
    };
    [1e-6, 1e-3, 0.048, 1.0].into_iter().map(one).collect()
}

fn work_to_detach() -> Attempt<Pairs> {
    let ball = paraboloid(1.0)?;
    let mut contact = jkr(ball.clone(), 1.0, 1.0);
    contact.indent(0.0)?;
    let start = contact.energy().stored();
    Ok(vec![(first(&contact.indent(-2.0)?)?.dissipated - start, 7.092_196)])
}

fn cone() -> Attempt<Pairs> {
    let (slope, work, modulus) = (0.2, 0.7, 3.0);
    let cone = Arc::new(Cone { slope: si(slope)? });
    let by_force = pulled(cone.clone(), modulus, work, -1e6)?;
    let by_depth = retracted(cone, modulus, work, -1e6)?;
    let unit = work * work / (PI * modulus * slope * slope * slope);
    Ok(vec![
        (by_force.force, -54.0 * unit),
        (by_force.contact_radius, 18.0 * work / (PI * modulus * slope * slope)),
        (by_depth.indentation, -work / (modulus * slope)),
        (by_depth.force, -6.0 * unit),
    ])
}

fn flat_punch() -> Attempt<Pairs> {
    let (radius, work, modulus) = (0.3, 0.7, 3.0);
    let punch = Arc::new(FlatPunch { radius: si(radius)? });
    let mut contact = jkr(punch.clone(), modulus, work);
    let touched = first(&contact.indent(0.0)?)?;
    let off = first(&contact.indent(-1e3)?)?;
    Ok(vec![
        (off.before.force, -(8.0 * PI * modulus * work * radius * radius * radius).sqrt()),
        (touched.dissipated + off.dissipated, 2.0 * PI * work * radius * radius),
    ])
}

fn edge_stress() -> Attempt<Pairs> {
    let ball = paraboloid(1.0)?;
    let mut contact = jkr(ball.clone(), 1.0, 1.0);
    let mut at = |depth| {
        contact.indent(depth)?;
        Ok((contact.loaded().stress_intensity(), 2f64.sqrt()))
    };
    [0.0, 1.0, -1.0].into_iter().map(&mut at).collect()
}

/// R = E* = w = 1: −(dF/da)/(dd/da) where the contact jumps off, and k.
fn behind_a_spring() -> Attempt<Pairs> {
    let one = |stiffness: f64| {
        let mut contact = jkr(paraboloid(1.0)?, 1.0, 1.0).on_a_spring(stiffness);
        contact.press(1.0)?;
        let a = first(&contact.indent(-1e6)?)?.before.contact_radius;
        let stretch = (2.0 * PI * a).sqrt();
        Ok(((3.0 * stretch - 4.0 * a * a) / (2.0 * a - 0.5 * stretch / a), stiffness))
    };
    [0.01, 0.3, 1.0, 10.0, 100.0].into_iter().map(one).collect()
}

/// E* = 3, R = 2, w = 0.5: 2πwR = 2π, and at F = 0 Hertz's radius under it.
fn dmt_ball() -> Attempt<Pairs> {
    let mut contact = dmt(paraboloid(2.0)?, 3.0, 0.5);
    contact.indent(0.25)?;
    let pressed = contact.present().balance;
    contact.press(0.0)?;
    let free = contact.present().balance;
    let torn = first(&contact.press(-7.0)?)?.before;
    Ok(vec![
        (pressed.force, 4.0 * 2f64.sqrt() * 0.125 - 2.0 * PI),
        (free.contact_radius, (0.75 * 2.0 * 2.0 * PI / 3.0).cbrt()),
        (torn.force, -2.0 * PI),
    ])
}

/// K = 1, R = 1, πw = 1: forces in units of πwR.
fn dmt_limit() -> Attempt<Pairs> {
    let mut hard = maugis(paraboloid(1.0)?, 0.75, 1.0 / PI, 0.5e-3)?;
    let mut limit = dmt(paraboloid(1.0)?, 0.75, 1.0 / PI);
    let mut at = |force| {
        hard.press(force)?;
        limit.press(force)?;
        Ok((hard.present().balance.contact_radius, limit.present().balance.contact_radius))
    };
    [3.0, 0.0, -1.0].into_iter().map(&mut at).collect()
}

/// The pull-off force of a ball with K = 1, R = 1 and πw = 1: the units are one and σ₀ = λ/2.
pub(super) fn maugis_force(lambda: f64) -> Attempt<f64> {
    let ball = paraboloid(1.0)?;
    let mut contact = maugis(ball.clone(), 0.75, 1.0 / PI, 0.5 * lambda)?;
    contact.press(0.0)?;
    Ok(contact.press(-3.0)?.last().ok_or("the bodies do not part")?.before.force)
}

/// The same ball, held by a liquid that wets at 60 degrees: w = γ.
fn bridge_pull_off() -> Attempt<Pairs> {
    let tension = 1.0 / PI;
    let bridge = Capillary {
        tension: SurfaceTension::new(tension)?,
        angle: ContactAngle::new(PI / 3.0)?,
        kelvin_radius: Length::new(2.0 * tension)?,
    };
    let adhesion = Adhesion::Capillary(bridge);
    let Range::Finite(stress) = adhesion.traits().range else { return Err("a bridge has a range".into()) };
    let mut contact = maugis(paraboloid(1.0)?, 0.75, adhesion.traits().work, stress)?;
    contact.press(0.0)?;
    let torn = contact.press(-3.0)?.last().ok_or("the bodies do not part")?.before.force;
    Ok(vec![(torn, -1.600_734_911_254_09)])
}

/// References by golden section on the closed equations with thirty digits.
fn maugis_pull_off() -> Attempt<Pairs> {
    let references = [
        (0.01, -1.998_287_784_321_51),
        (0.1, -1.950_594_892_123_43),
        (0.5, -1.718_245_274_886_17),
        (1.0, -1.600_734_911_254_09),
        (5.0, -1.506_349_967_716_04),
    ];
    references.into_iter().map(|(lambda, right)| Ok((maugis_force(lambda)?, right))).collect()
}
