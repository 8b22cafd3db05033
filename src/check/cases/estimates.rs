//! The error a scene states beside its true one: R = 1, and E* = 1 where nothing relaxes.

use crate::check::case::{Attempt, Case, Pairs, Proof, Question};
use crate::check::closed_forms::{self, ClosedForm};
use crate::check::measured::{Creeping, DEPTH, SLOPE, triangle};
use crate::check::sketch::{Sketch, ball, beside, elastic, relaxing, si};
use crate::check::stated::Stated;
use crate::check::tangential::CattaneoMindlin;
use crate::check::ways;
use crate::contact::adhesion::{Adhesion, Maugis};
use crate::numerics::quadrature;
use crate::run::record::{Outcome, Record};
use crate::shape::{Cone, Shape, Sphere, WavyParaboloid};
use std::f64::consts::PI;

const BOUND: &str = "the error stated must not be smaller than the true one, printed as the part of it used";

const fn case(name: &'static str, scene: fn() -> Sketch, known: fn(&Outcome) -> Attempt<Pairs>) -> Case {
    let stated = Stated { scene, known, asked: &[1e-6], springs: &[] };
    Case::new(name, Proof::Bound, 1.0, BOUND).weak("one scene").asks(Question::Stated(stated))
}

/// By beds of springs too.
const fn with_beds(case: Case) -> Case {
    let Question::Stated(stated) = case.question else { return case };
    case.weak("one scene, by its own solver and by 100 to 10 000 springs")
        .asks(Question::Stated(Stated { springs: &[100, 1000, 10_000], ..stated }))
}

/// At three accuracies.
const fn at_three(case: Case) -> Case {
    let Question::Stated(stated) = case.question else { return case };
    case.weak("one scene, asked for 1e-2, 1e-4 and 1e-6")
        .asks(Question::Stated(Stated { asked: &[1e-2, 1e-4, 1e-6], ..stated }))
}

pub(super) const CASES: &[Case] = &[
    with_beds(case("estimate/Hertz", hertz, |outcome| at_end(outcome, closed_forms::hertz(1.0, DEPTH))))
        .ways(ways::elastic::hertz),
    case("estimate/sphere", sphere, |outcome| at_end(outcome, closed_forms::sphere(1.0, 1.0))),
    with_beds(case("estimate/cone", cone, |outcome| at_end(outcome, closed_forms::cone(SLOPE, DEPTH))))
        .ways(ways::elastic::cone),
    case("estimate/wavy paraboloid", wavy, |outcome| beside(outcome, &WAVY)),
    with_beds(case("estimate/JKR pulled away by depth", jkr_depth, |outcome| {
        beside(outcome, &[("pull_off_force_n", -1.5 * PI * WORK)])
    }))
    .ways(ways::adhesion::pull_off),
    case("estimate/JKR a hair from pull-off", jkr_hair, jkr_hair_known),
    case("estimate/Maugis pull-off", maugis, |outcome| {
        beside(outcome, &[("pull_off_force_n", -1.600_734_911_254_09 * MAUGIS)])
    }),
    with_beds(case("estimate/Cattaneo–Mindlin", mindlin, mindlin_known)).ways(ways::friction::mindlin_loop),
    at_three(case("estimate/Ting's triangle", ting, ting_known)).ways(ways::viscoelastic::ting),
    at_three(case("estimate/creep", creep, creep_known)).ways(ways::viscoelastic::creep),
    at_three(case("estimate/oscillation", oscillation, oscillation_known)),
    at_three(case("estimate/Hertz impact", || Sketch::of(ball(1.0)).impact(SPEED), impact_known))
        .ways(ways::impact::hertz),
];

fn at_end(outcome: &Outcome, right: ClosedForm) -> Attempt<Pairs> {
    beside(outcome, &[("final_force_n", right.force), ("final_contact_radius_m", right.radius)])
}

fn hertz() -> Sketch {
    Sketch::of(ball(1.0)).indent(DEPTH, 1.0)
}

/// a/R = tanh 1.
fn sphere() -> Sketch {
    let sphere = si(1.0).map(|radius| Shape::Sphere(Sphere { radius }));
    Sketch::of(sphere).indent(closed_forms::sphere(1.0, 1.0).indentation, 1.0)
}

fn cone() -> Sketch {
    Sketch::of(si(SLOPE).map(|slope| Shape::Cone(Cone { slope }))).indent(DEPTH, 1.0)
}

/// The contact of radius 0.6: its depth and N = F/(2E*) were made with thirty digits.
const WAVY: [(&str, f64); 2] = [("final_contact_radius_m", 0.6), ("final_force_n", 2.0 * 0.146_846_890_799_377_52)];

fn wavy() -> Sketch {
    let shape = || Ok(WavyParaboloid { radius: si(1.0)?, amplitude: si(0.001)?, wavelength: si(0.25)? });
    Sketch::of(shape().map(Shape::WavyParaboloid)).indent(0.365_807_593_708_617_6, 1.0)
}

/// w such that depths are of the order of 10⁻³ R.
const WORK: f64 = 1e-5;

fn jkr_depth() -> Sketch {
    Sketch::of(ball(1.0)).jkr(WORK, None).indent(2e-3, 1.0).retract(1e-3)
}

/// The force 10⁻¹² short of pull-off: the radius is known to 10⁻¹⁰.
const HAIR: f64 = 1e-12;
const PULL: f64 = 1.5 * PI * WORK;

fn jkr_hair() -> Sketch {
    Sketch::of(ball(1.0)).jkr(WORK, None).press(0.0, 1.0).press(-PULL * (1.0 - HAIR), 1.0)
}

fn jkr_hair_known(outcome: &Outcome) -> Attempt<Pairs> {
    let radius = (0.75 * PULL * (1.0 + HAIR.sqrt()).powi(2)).cbrt();
    beside(outcome, &[("final_force_n", -PULL * (1.0 - HAIR)), ("final_contact_radius_m", radius)])
}

/// K = 4E*/3 = 1, πw = u and λ = 1: σ₀ = u^{1/3}/2; the reference is that of the pull-off over λ.
const MAUGIS: f64 = 1e-6;

fn maugis() -> Sketch {
    let law = || Ok(Adhesion::Maugis(Maugis { work: si(MAUGIS / PI)?, stress: si(0.5 * MAUGIS.cbrt())? }));
    Sketch::of(ball(1.0)).body(elastic(0.5625, 0.5)).adhesion(law()).press(MAUGIS, 1.0).retract(1e-3)
}

fn lens() -> CattaneoMindlin {
    CattaneoMindlin::on_ball(DEPTH, 2.0 / 3.0, 0.3)
}

fn mindlin() -> Sketch {
    hertz().coulomb(0.3).slide(0.6 * lens().reach())
}

fn mindlin_known(outcome: &Outcome) -> Attempt<Pairs> {
    beside(outcome, &[("final_tangential_force_n", lens().tangential_force(0.6 * lens().reach()))])
}

fn ting() -> Sketch {
    hertz().body(relaxing(&triangle().relaxation)).indent(0.0, 1.0)
}

/// All records, relative to the largest.
fn ting_known(outcome: &Outcome) -> Attempt<Pairs> {
    let exact = triangle();
    let most = exact.at(1.0)?.0;
    let pair = |record: &Record| Ok(((record.normal.force - exact.at(record.time)?.0) / most, 0.0));
    outcome.records.iter().map(pair).collect()
}

const CREEPING: Creeping = Creeping { force: 1e-3, rise: 1e-3 };

fn creep() -> Sketch {
    let body = relaxing(&Creeping::relaxation());
    Sketch::of(ball(1.0)).body(body).press(CREEPING.force, CREEPING.rise).hold_force(2.0)
}

fn creep_known(outcome: &Outcome) -> Attempt<Pairs> {
    beside(outcome, &[("final_contact_radius_m", CREEPING.radius(2.0)), ("final_force_n", CREEPING.force)])
}

const CYCLES: f64 = 0.25;

/// A quarter of a cycle about a depth held until all has relaxed: the contact only grows.
fn oscillation() -> Sketch {
    hertz().body(relaxing(&triangle().relaxation)).hold(100.0).oscillate(0.5 * DEPTH, 1.0, CYCLES)
}

/// Lee & Radok: F = (4/3)√R ∫ E*(t−s) d(d^{3/2}) over the sine, by quadrature.
fn oscillation_known(outcome: &Outcome) -> Attempt<Pairs> {
    let angle = |s: f64| 2.0 * PI * s;
    let depth = |s: f64| DEPTH * (1.0 + 0.5 * angle(s).sin());
    let speed = |s: f64| PI * DEPTH * angle(s).cos();
    let exact = triangle();
    let rate = |s| 1.5 * depth(s).sqrt() * speed(s) * exact.modulus(CYCLES - s);
    let rising = quadrature::equal_panels(rate, (0.0, CYCLES), 0.02);
    let relaxed = exact.relaxation.equilibrium * DEPTH.powf(1.5);
    beside(outcome, &[("final_force_n", 4.0 / 3.0 * (relaxed + rising))])
}

const SPEED: f64 = 0.1;

/// Mass 1: x₀ = (15v²/16)^{2/5}, time 2.943275 x₀/v.
fn impact_known(outcome: &Outcome) -> Attempt<Pairs> {
    let depth = (0.9375 * SPEED * SPEED).powf(0.4);
    let time = 2.943_275_184_324_705 * depth / SPEED;
    beside(outcome, &[("contact_time_s", time), ("largest_indentation_m", depth)])
}
