//! Stresses below the surface with known answers.

use crate::check::case::{Attempt, Case, Pairs, Proof};
use crate::check::contacts::paraboloid;
use crate::check::sketch::si;
use crate::contact::foundation::Foundation;
use crate::contact::loaded::Loaded;
use crate::contact::punch::Stresses;
use crate::contact::subsurface::FirstYield;
use crate::shape::FlatPunch;
use std::f64::consts::PI;
use std::sync::Arc;

const TWELVE_DIGITS: &str = "references with twelve decimals, by Boussinesq's point loads and quadrature of 25 digits";

pub(super) const CASES: &[Case] = &[
    Case::new("stress/hertz off the axis", Proof::Other, 2e-10, TWELVE_DIGITS)
        .weak("three places; the property tests take any shape and place")
        .by(hertz),
    Case::new("stress/below a flat punch", Proof::Other, 2e-10, TWELVE_DIGITS).weak("one place").by(flat_punch),
    Case::new("stress/first yield of a ball", Proof::Other, 2e-9, "p₀/Y with eleven digits; F goes with its cube")
        .weak("three of Poisson's ratios")
        .by(first_yield),
    Case::new(
        "stress/trailing edge of a sliding ball",
        Proof::Bound,
        1e-4,
        "p₀[(1−2ν)/3 + πμ(4+ν)/8] at the surface (Hamilton 1983); σ leaves it with the root of the depth, here 1e-9 a",
    )
    .weak("one place of the field of friction; the property tests have Cerruti's point loads")
    .by(trailing_edge),
    Case::new("stress/far away", Proof::Bound, 1e-9, "a point load to the square of a/R = 1e-5")
        .weak("the axis, where nothing cancels")
        .by(far_away),
];

/// A ball with the contact radius one and p₀ = 1.
fn ball() -> Attempt<Loaded> {
    Ok(Loaded::elastic(Foundation::new(paraboloid(1.0)?, 0.5 * PI), 1.0, 0.0))
}

fn beside(found: Stresses, right: [f64; 4]) -> Pairs {
    [found.radial, found.hoop, found.axial, found.shear].into_iter().zip(right).collect()
}

fn hertz() -> Attempt<Pairs> {
    let field = ball()?.field(0.3);
    let places = [
        (0.5, 0.5, [-0.162_947_161_611, -0.142_309_653_636, -0.650_850_826_035, -0.153_645_038_156]),
        (1.0, 0.2, [-0.188_203_749_364, -0.138_080_182_064, -0.191_552_679_283, -0.173_352_792_240]),
        (2.0, 1.0, [-0.053_464_272_216, -0.008_222_032_631, -0.025_647_239_127, -0.041_498_104_625]),
    ];
    Ok(places.into_iter().flat_map(|(r, z, right)| beside(field.at(r, z), right)).collect())
}

fn flat_punch() -> Attempt<Pairs> {
    let punch = Arc::new(FlatPunch { radius: si(1.0)? });
    // Of the mean pressure one: F = 2q(a)a = π.
    let field = Loaded::elastic(Foundation::new(punch, 1.0), 1.0, 0.5 * PI).field(0.3);
    let right = [-0.196_653_226_654, -0.226_827_927_495, -0.622_363_469_300, -0.009_495_785_578];
    Ok(beside(field.at(0.5, 0.5), right))
}

fn first_yield() -> Attempt<Pairs> {
    let ground = Foundation::new(paraboloid(2.0)?, 3.0);
    let force = |(poisson, ratio): (f64, f64)| {
        let first = FirstYield::of(&ground, poisson, 0.01, 0.0).ok_or("no first yield")?;
        // F = π³R²p₀³/6E*².
        Ok((first.force, PI.powi(3) * 4.0 * (0.01 * ratio).powi(3) / (6.0 * 9.0)))
    };
    [(0.3, 1.612_796_563_0), (0.5, 1.877_239_337_1), (0.25, 1.554_347_432_4)].into_iter().map(force).collect()
}

fn trailing_edge() -> Attempt<Pairs> {
    let field = ball()?.field(0.3).dragged(0.5);
    Ok(vec![(field.at(-1.0, 0.0).radial, 0.4 / 3.0 + PI * 0.5 * 4.3 / 8.0)])
}

fn far_away() -> Attempt<Pairs> {
    let loaded = ball()?;
    let z = 1e5;
    Ok(vec![(loaded.field(0.3).at(0.0, z).axial, -1.5 * loaded.force() / (PI * z * z))])
}
