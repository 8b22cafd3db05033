//! Worn contacts with known answers, run as whole scenes on rubber: E* = 1 and G* = 2/3.

use crate::check::case::{Attempt, Case, Pairs, Proof};
use crate::check::sketch::{Sketch, ball, result, si};
use crate::numerics::quadrature;
use crate::run::record::Outcome;
use crate::shape::{FlatPunch, Shape};
use std::f64::consts::{FRAC_1_PI, FRAC_1_SQRT_2, FRAC_PI_2};

pub(super) const CASES: &[Case] = &[
    Case::new(
        "wear/Archard's volume",
        Proof::Rounding,
        1e-12,
        "Σ M_ij = h_i: forces of the rings sum to that of the bed",
    )
    .weak("constant force; the property tests take any shape and load")
    .by(volume),
    Case::new(
        "wear/punch under a constant force",
        Proof::Order,
        1e-3,
        "100 cells, second order but for the cell at the wall",
    )
    .weak("the limit, k_w E* s = 30 b; the way to it only in the tests")
    .by(punch),
    Case::new(
        "wear/fretting's limit",
        Proof::Bound,
        1e-5,
        "what is left to wear falls without end, and the border of stick is one of cells",
    )
    .weak("ball, constant depth, c = a/√2")
    .by(fretting),
    Case::new("wear/no coefficient, no change", Proof::Rounding, 0.0, "the same scene, to the bit")
        .weak("one scene")
        .by(nothing),
];

fn sliding() -> Sketch {
    Sketch::of(ball(1.0)).coulomb(0.3).archard(0.1).press(4.0 / 3.0, 1.0).slide(3.0)
}

fn volume() -> Attempt<Pairs> {
    let outcome = sliding().run()?;
    Ok(vec![(result(&outcome, "worn_volume_m3")?, 0.1 * 4.0 / 3.0 * 3.0)])
}

fn punch() -> Attempt<Pairs> {
    let shape = si(1.0).map(|radius| Shape::FlatPunch(FlatPunch { radius }));
    let outcome = Sketch::of(shape).coulomb(0.3).archard(1.0).press(1.0, 1.0).slide(30.0).run()?;
    let column = |name: &str| numbers(&outcome, name);
    let (path, radius, worn) = (column("path")?, column("radius")?, column("worn_depth")?);
    let last = path.partition_point(|path| *path < 30.0);
    let elliptic = |k: f64| quadrature::panel(|t| (1.0 - (k * t.sin()).powi(2)).sqrt(), 0.0, FRAC_PI_2);
    let limit = |r: f64| 4.0 * FRAC_1_PI * FRAC_1_PI * (FRAC_PI_2 - elliptic(r));
    let rise = |k: usize| (1.0 + worn[k] - worn[last], 1.0 + limit(radius[k]) - limit(radius[last]));
    Ok((last..path.len()).map(rise).collect())
}

/// A column of the table of profiles.
fn numbers(outcome: &Outcome, name: &str) -> Attempt<Vec<f64>> {
    let column = outcome.table("profiles").and_then(|table| table.column(name)).ok_or("the scene has no profiles")?;
    Ok(column.numbers().iter().copied().flatten().collect())
}

fn fretting() -> Attempt<Pairs> {
    // m = μE*/G* = 0.45: the springs outside c = a/√2 slip after m(d − c²).
    let outcome = Sketch::of(ball(1.0)).coulomb(0.3).archard(1.0).indent(1.0, 1.0).shake(0.225, 1.0, 2000.0).run()?;
    Ok(vec![(result(&outcome, "final_force_n")?, 4.0 / 3.0 * 1.25 * FRAC_1_SQRT_2)])
}

fn nothing() -> Attempt<Pairs> {
    let plain = Sketch::of(ball(1.0)).coulomb(0.3).press(4.0 / 3.0, 1.0).slide(3.0).run()?;
    let unworn = Sketch::of(ball(1.0)).coulomb(0.3).archard(0.0).press(4.0 / 3.0, 1.0).slide(3.0).run()?;
    let forces = unworn.records.iter().zip(&plain.records);
    Ok(forces.map(|(one, other)| (one.normal.force + one.time, other.normal.force + other.time)).collect())
}
