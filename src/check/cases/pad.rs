//! Pads of scattered heights, run as whole scenes: springs of one stiffness in all and heights of the deviation 1, or one
//! summit in the mean with R = E* = 1.

use crate::check::case::{Attempt, Case, Pairs, Proof};
use crate::check::sketch::{Sketch, result, si};
use crate::contact::adhesion::{Adhesion, Jkr};
use crate::material::{Body, Winkler};
use crate::numerics::quadrature;
use crate::shape::{Pad, Shape, Summits};
use std::f64::consts::{FRAC_2_SQRT_PI, FRAC_PI_2, PI, SQRT_2, TAU};

pub(super) const CASES: &[Case] = &[
    Case::new("pad/springs", Proof::Rounding, 1e-13, "closed form: F = Nkσ/√(2π) at the mean plane")
        .weak("one depth")
        .by(springs),
    Case::new(
        "pad/pull-off over preload",
        Proof::Rounding,
        1e-12,
        "closed forms: springs that have touched hold until the first of them is stretched by s",
    )
    .weak("a preload to the mean plane, of springs that hold far")
    .by(preloaded),
    Case::new(
        "pad/greatest pull-off",
        Proof::Rounding,
        1e-12,
        "Mills's ratio is √(π/2) at zero: with that stretch F = kσ(1 − π/2)/√(2π)",
    )
    .weak("one stretch")
    .by(greatest),
    Case::new(
        "pad/Greenwood and Williamson",
        Proof::Rounding,
        1e-11,
        "Gauss's rule on panels of less than a deviation, beside the same over heights",
    )
    .weak("one separation; force and area")
    .by(bare),
    Case::new("pad/equal heights", Proof::Order, 1e-6, "second order in the deviation, a thousandth of the radius")
        .weak("the limit of one ball of JKR, under a force")
        .by(equal),
];

/// A square of one square metre; the springs of a sheet of one pascal and one metre are one newton per metre in all.
fn pad(deviation: f64, radius: Option<f64>) -> Attempt<Shape> {
    let summits = |radius| -> Attempt<Summits> { Ok(Summits { number: si(1.0)?, radius: si(radius)? }) };
    let summits = radius.map(summits).transpose()?;
    Ok(Shape::Pad(Pad { side: si(1.0)?, deviation: si(deviation)?, summits }))
}

fn sheet() -> Attempt<Body> {
    Ok(Body::Winkler(Winkler { modulus: si(1.0)?, thickness: si(1.0)? }))
}

/// Springs that hold up to the stretch `stretch` [m] and join as they touch.
fn adhesive(stretch: f64) -> Sketch {
    let jkr = || Ok(Adhesion::Jkr(Jkr { work: si(0.5 * stretch * stretch)?, closing: Some(si(0.0)?), edge: None }));
    Sketch::of(pad(1.0, None)).body(sheet()).adhesion(jkr())
}

fn springs() -> Attempt<Pairs> {
    let outcome = Sketch::of(pad(1.0, None)).body(sheet()).indent(0.0, 1.0).run()?;
    Ok(vec![
        (result(&outcome, "final_force_n")?, 1.0 / TAU.sqrt()),
        (result(&outcome, "final_stored_elastic_j")?, 0.25),
        (result(&outcome, "largest_joined_share")?, 0.5),
    ])
}

/// All that has touched holds at d = −s: F = kσ[φ(0) − s/2], the least where the rest lets go from there on.
fn preloaded() -> Attempt<Pairs> {
    let outcome = adhesive(4.0).indent(0.0, 1.0).retract(1.0).run()?;
    let preload = 1.0 / TAU.sqrt();
    Ok(vec![(result(&outcome, "pull_off_over_preload")?, 2.0 / preload - 1.0)])
}

fn greatest() -> Attempt<Pairs> {
    let outcome = adhesive(FRAC_PI_2.sqrt()).indent(5.0, 1.0).retract(1.0).run()?;
    let exact = (1.0 - FRAC_PI_2) / TAU.sqrt();
    Ok(vec![(result(&outcome, "greatest_pull_off_force_n")?, exact), (result(&outcome, "pull_off_force_n")?, exact)])
}

fn bare() -> Attempt<Pairs> {
    let outcome = Sketch::of(pad(1.0, Some(1.0))).indent(-1.0, 1.0).run()?;
    // ∫ sⁿ φ(1 + s) ds, by s = t² without a root.
    let over = |n: i32| {
        let density =
            |t: f64| 2.0 * t.powi(n + 1) * (-0.5 * (1.0 + t * t).powi(2)).exp() * 0.5 * FRAC_2_SQRT_PI / SQRT_2;
        quadrature::equal_panels(density, (0.0, 3.5), 0.25)
    };
    Ok(vec![
        (result(&outcome, "final_force_n")?, 4.0 / 3.0 * over(3)),
        (result(&outcome, "largest_area_m2")?, PI * over(2)),
    ])
}

fn equal() -> Attempt<Pairs> {
    let outcome = Sketch::of(pad(1e-3, Some(1.0))).jkr(1.0, None).press(1.0, 1.0).run()?;
    Ok(vec![(result(&outcome, "greatest_pull_off_force_n")?, -1.5 * PI)])
}
