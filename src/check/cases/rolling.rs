//! Bodies that roll with traction, run as whole scenes, against closed forms and Kalker's table.

use crate::check::case::{Attempt, Case, Pairs, Proof};
use crate::check::sketch::{Sketch, ball, beside, elastic, result, si};
use crate::run::record::Outcome;
use crate::run::table::{Filled, Table};
use crate::shape::{Cylinder, Shape};
use std::f64::consts::PI;

pub(super) const CASES: &[Case] = &[
    Case::new(
        "rolling/Carter",
        Proof::Rounding,
        1e-11,
        "ξ = (μa/R)[1 − √(1 − T/μP)] with a = √(4PR/πE*W): the half width is found from the force to some roundings",
    )
    .weak("the law of the code itself; from the stress on strips in its own tests")
    .by(carter),
    Case::new(
        "rolling/Carter, energy",
        Proof::Order,
        2e-3,
        "∫τ dx = T/W and ∫τs dx = Tξv/W by trapezia on 32 cosine pieces of a zone: a half ellipse as a polygon, π²/(6·32²) below",
    )
    .weak("stress and slip of one table, held against its curve")
    .by(energy),
    Case::new("rolling/ball, small creepage", Proof::Bound, 1e-6, "T = 4/(2 − ν) Ga²ξ up to ξ/ξₛ = 1e-6 of itself")
        .weak("the bed's own limit; Kalker's lies 70 to 95 % above it")
        .by(linear),
    Case::new(
        "rolling/ball, full slip",
        Proof::Rounding,
        1e-12,
        "T = μP from ξₛ = 2μ(E*/G*)a/R on, and the cube below it: the radius is found from the force to some roundings",
    )
    .weak("the law of the code itself; spring by spring in its own tests")
    .by(saturation),
    Case::new(
        "rolling/ball, Kalker",
        Proof::Other,
        1e-6,
        "dT/dξ = C₁₁Ga² with the coefficients of his table at ν = 0, ¼ and ½, whose three digits stand for themselves",
    )
    .weak("the slope that is told beside the bed, not that of the bed")
    .by(kalker),
];

const FRICTION: f64 = 0.3;

/// Young's modulus, radius, width and force of a steel roller.
const ROLLER: [f64; 4] = [210e9, 0.01, 0.02, 1e4];

fn roller() -> Sketch {
    let [young, radius, width, force] = ROLLER;
    let shape = || Ok(Shape::Cylinder(Cylinder { radius: si(radius)?, datum: si(radius)?, width: Some(si(width)?) }));
    let steel = || elastic(young, 0.3);
    Sketch::of(shape()).body(steel()).other(steel()).coulomb(FRICTION).steps(2).press(force, 1.0)
}

/// Half width of its contact, and the creepage of full slip.
fn of_roller() -> (f64, f64) {
    let [young, radius, width, force] = ROLLER;
    let half_width = (4.0 * force * radius / (PI * 0.5 * young / 0.91 * width)).sqrt();
    (half_width, FRICTION * half_width / radius)
}

fn carter() -> Attempt<Pairs> {
    let (half_width, full_slip) = of_roller();
    let mut pairs = Vec::new();
    for part in [-0.9, -0.5, 0.01, 0.3, 0.75, 0.999] {
        let force = part * FRICTION * ROLLER[3];
        let stuck = (1.0 - f64::abs(part)).sqrt();
        let creepage = (full_slip * (1.0 - stuck)).copysign(part);
        let right =
            [("creepage", creepage), ("stick_width_m", 2.0 * half_width * stuck), ("tangential_force_n", force)];
        pairs.extend(beside(&roller().pull(2.0, &[force]).run()?, &right)?);
        let right = [("tangential_force_n", force), ("friction_power_w", 2.0 * force * creepage)];
        pairs.extend(beside(&roller().creep(2.0, &[creepage]).run()?, &right)?);
    }
    Ok(pairs)
}

fn column<'t>(table: &'t Table, name: &str) -> Attempt<&'t Filled> {
    Ok(table.column(name).ok_or("no such column")?)
}

/// ∫ of the columns `names`, multiplied, over the places of a contact.
fn integral(outcome: &Outcome, names: &[&str]) -> Attempt<f64> {
    let table = outcome.table("rolling").ok_or("no table of the contact")?;
    let numbers = |name: &str| Ok::<_, Box<dyn std::error::Error + Send + Sync>>(column(table, name)?.numbers());
    let (places, columns) = (numbers("place")?, names.iter().map(|name| numbers(name)).collect::<Result<Vec<_>, _>>()?);
    let at = |row: usize| columns.iter().map(|column| column[row].unwrap_or(f64::NAN)).product::<f64>();
    let piece = |row: usize| Some(0.5 * (places[row + 1]? - places[row]?) * (at(row) + at(row + 1)));
    let pieces: Option<Vec<f64>> = (0..places.len().saturating_sub(1)).map(piece).collect();
    Ok(pieces.ok_or("a place is missing")?.into_iter().sum())
}

fn energy() -> Attempt<Pairs> {
    let (width, full_slip) = (ROLLER[2], of_roller().1);
    let mut pairs = Vec::new();
    for part in [0.2, 0.6, 1.0, 1.4] {
        let outcome = roller().creep(2.0, &[part * full_slip]).run()?;
        let force = result(&outcome, "tangential_force_n")?;
        let power = result(&outcome, "friction_power_w")?;
        pairs.push((width * integral(&outcome, &["shear_stress"])?, force));
        pairs.push((width * integral(&outcome, &["shear_stress", "slip_speed"])?, power));
        pairs.push((width * integral(&outcome, &["heat_flux"])?, power));
    }
    Ok(pairs)
}

/// Equal balls of G = 1 and Poisson's ratio `poisson`, R = 1 together, a = 0.01.
fn balls(poisson: f64) -> Sketch {
    let body = || elastic(2.0 * (1.0 + poisson), poisson);
    let force = 4.0 / 3.0 / (1.0 - poisson) * 1e-6;
    Sketch::of(ball(1.0)).body(body()).other(body()).coulomb(FRICTION).steps(2).press(force, 1.0)
}

/// E*/G* of such balls.
fn ratio(poisson: f64) -> f64 {
    (2.0 - poisson) / (2.0 - 2.0 * poisson)
}

fn linear() -> Attempt<Pairs> {
    let mut pairs = Vec::new();
    for poisson in [0.0, 0.25, 0.3, 0.5] {
        let creepage = 1e-6 * 2.0 * FRICTION * ratio(poisson) * 0.01;
        let right = [("tangential_force_n", 4.0 / (2.0 - poisson) * 1e-4 * creepage)];
        pairs.extend(beside(&balls(poisson).creep(1.0, &[creepage]).run()?, &right)?);
    }
    Ok(pairs)
}

fn saturation() -> Attempt<Pairs> {
    let poisson = 0.3;
    let (full_slip, limit) = (2.0 * FRICTION * ratio(poisson) * 0.01, FRICTION * 4.0 / 3.0 / 0.7 * 1e-6);
    let mut pairs = Vec::new();
    for part in [0.1f64, 0.5, 0.9, 1.0, 1.1, 100.0] {
        let force = limit * (1.0 - (1.0 - part.min(1.0)).powi(3));
        let right = [("tangential_force_n", force), ("full_slip_creepage", full_slip), ("largest_traction_n", limit)];
        pairs.extend(beside(&balls(poisson).creep(1.0, &[part * full_slip]).run()?, &right)?);
    }
    Ok(pairs)
}

fn kalker() -> Attempt<Pairs> {
    let mut pairs = Vec::new();
    for (poisson, coefficient) in [(0.0, 3.40), (0.25, 4.12), (0.5, 5.20)] {
        let creepage = 1e-7 * FRICTION * 0.01;
        let right = [
            ("kalker_creep_stiffness_n", coefficient * 1e-4),
            ("kalker_tangential_force_n", coefficient * 1e-4 * creepage),
        ];
        pairs.extend(beside(&balls(poisson).creep(1.0, &[creepage]).run()?, &right)?);
    }
    Ok(pairs)
}
