//! Layers, a sheet of springs and a graded body, run as whole scenes: E* of the top, its thickness and the modulus of
//! the springs are 1, a paraboloid with g = x²/10.

use crate::check::case::{Attempt, Case, Pairs, Proof};
use crate::check::sketch::{Sketch, ball, beside, elastic, relaxing, si};
use crate::check::ways;
use crate::material::{Body, Graded, Joint, Layer, Layered, Relaxation, Winkler};
use std::f64::consts::PI;

const DIGITS: &str = "numbers given to 11 digits, from the integral equation solved apart";
const FORMULA: &str = "closed forms; tables of 20 nodes, a few dozen roundings";

pub(super) const CASES: &[Case] = &[
    Case::new("ground/incompressible layer bonded to a rigid base", Proof::Rounding, 5e-11, DIGITS)
        .weak("one thickness wide")
        .by(incompressible)
        .ways(ways::ground::gel),
    Case::new("ground/layer that slides on a rigid base", Proof::Rounding, 5e-11, DIGITS)
        .weak("three thicknesses wide")
        .by(sliding),
    Case::new("ground/layer on a softer base", Proof::Rounding, 5e-11, DIGITS)
        .weak("a force at three radii")
        .by(soft_base),
    Case::new("ground/stiff film", Proof::Rounding, 5e-11, DIGITS)
        .weak("three thicknesses wide")
        .by(film)
        .ways(ways::ground::film),
    Case::new("ground/jkr on a layer", Proof::Rounding, 5e-11, DIGITS)
        .weak("one depth, after the jump into contact")
        .by(adhesive),
    Case::new(
        "ground/jkr pull-off from a graded body",
        Proof::Rounding,
        1e-10,
        "the least force of a flat minimum; tables of 20 nodes",
    )
    .weak("one exponent; it does not depend on the modulus")
    .by(graded),
    Case::new("ground/sheet of springs", Proof::Rounding, 1e-12, FORMULA).weak("a paraboloid").by(springs),
    Case::new("ground/viscoelastic layer", Proof::Order, 1e-8, "pressed in during 1e-9 of the relaxation time")
        .weak("a step of the depth, held")
        .by(relaxing_layer),
    Case::new("ground/equal layers", Proof::Rounding, 1e-12, FORMULA)
        .weak("two layers and a base of one material")
        .by(equal),
];

fn layer(body: Body, thickness: f64) -> Attempt<Layer> {
    Ok(Layer { body, thickness: si(thickness)?, bond: None })
}

fn on(layers: Vec<Layer>, base: Body, bond: Joint) -> Body {
    Body::Layered(Layered { layers, base: Box::new(base), bond })
}

/// A layer with E* = 1 on a base.
fn one_layer(poisson: f64, base: Body, bond: Joint) -> Attempt<Body> {
    Ok(on(vec![layer(elastic(1.0 - poisson * poisson, poisson)?, 1.0)?], base, bond))
}

/// A layer with E* = 1 on a base whose shear modulus is `contrast` times less.
fn on_base(contrast: f64, [top, below]: [f64; 2]) -> Attempt<Body> {
    let shear = 0.5 * (1.0 - top) / contrast;
    one_layer(top, elastic(2.0 * shear * (1.0 + below), below)?, Joint::Bonded)
}

fn over(body: Attempt<Body>) -> Sketch {
    Sketch::of(ball(10.0)).body(body)
}

fn state(body: Attempt<Body>, depth: f64, [radius, force]: [f64; 2]) -> Attempt<Pairs> {
    let outcome = over(body).indent(depth, 1.0).run()?;
    beside(&outcome, &[("final_contact_radius_m", radius), ("final_force_n", force)])
}

fn incompressible() -> Attempt<Pairs> {
    state(one_layer(0.5, Body::Rigid, Joint::Bonded), 0.055941548556, [1.0, 0.188_066_689_92])
}

fn sliding() -> Attempt<Pairs> {
    state(one_layer(0.2, Body::Rigid, Joint::Sliding), 0.50410444640, [3.0, 8.032_578_023_1])
}

fn soft_base() -> Attempt<Pairs> {
    let mut pairs = Pairs::new();
    for (radius, force) in [(0.3, 0.0036601061658), (1.0, 0.178_013_781_48), (3.0, 10.958392636)] {
        let outcome = over(on_base(0.1, [0.5, 0.3])).press(force, 1.0).run()?;
        pairs.extend(beside(&outcome, &[("final_contact_radius_m", radius)])?);
    }
    Ok(pairs)
}

fn film() -> Attempt<Pairs> {
    state(on_base(10.0, [0.3, 0.3]), 1.4136473981, [3.0, 0.849_350_809_51])
}

/// A layer on a rigid base, and a stiff film, with w = 1e-3 and a = 1.
fn adhesive() -> Attempt<Pairs> {
    let bonded = over(one_layer(0.5, Body::Rigid, Joint::Bonded)).jkr(1e-3, None).indent(0.027347159332, 1.0).run()?;
    beside(&bonded, &[("final_contact_radius_m", 1.0), ("final_force_n", -0.018884392816)])
}

/// F = −(3+n)πwR/2 (Heß 2016), the radius of the paraboloid f = r²/2R being 10.
fn graded() -> Attempt<Pairs> {
    let body = Body::Graded(Graded { young: si(3.0)?, depth: si(0.2)?, exponent: si(0.4)?, poisson: si(0.3)? });
    let outcome = over(Ok(body)).jkr(1e-3, None).press(0.0, 1.0).press(-1.0, 1.0).run()?;
    beside(&outcome, &[("pull_off_force_n", -1.7 * PI * 1e-3 * 10.0)])
}

/// F = πMRd²/h, a² = 2Rd.
fn springs() -> Attempt<Pairs> {
    let body = Body::Winkler(Winkler { modulus: si(1.0)?, thickness: si(1.0)? });
    state(Ok(body), 0.2, [2.0, PI * 10.0 * 0.04])
}

/// A step of the depth: F(t) = E*(t)/E*(0) times that of the elastic layer.
fn relaxing_layer() -> Attempt<Pairs> {
    let relaxation = Relaxation { equilibrium: 0.25, terms: vec![(0.75, 1.0)], viscosity: 0.0 };
    let body = on(vec![layer(relaxing(&relaxation)?, 1.0)?], Body::Rigid, Joint::Bonded);
    let outcome = over(Ok(body)).indent(0.055941548556, 1e-9).hold(2.0).run()?;
    let left = 0.25 + 0.75 * (-2.0f64).exp();
    beside(&outcome, &[("final_contact_radius_m", 1.0), ("final_force_n", left * 0.188_066_689_92)])
}

/// E* = 1, F = (2/3)·2a³/10 and d = a²/10.
fn equal() -> Attempt<Pairs> {
    let body = || elastic(0.91, 0.3);
    let layered = on(vec![layer(body()?, 0.3)?, layer(body()?, 2.0)?], body()?, Joint::Bonded);
    state(Ok(layered), 0.1, [1.0, 4.0 / 30.0])
}
