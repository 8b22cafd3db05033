//! Tangential contacts with closed answers, run as whole scenes.

use crate::check::case::{Case, Proof, worst};
use crate::check::closed_forms;
use crate::check::tangential::{CattaneoMindlin, SavkoorBriggs, orowan_on_hertz};
use crate::contact::adhesion::{Adhesion, Jkr};
use crate::friction::{Coulomb, CoulombOrowan, Friction, PressureLaw, Strength};
use crate::input::quantity::{
    Amplitude, Displacement, Duration, Force, Frequency, Length, Modulus, Poisson, Positive, Ratio, Stress,
    WorkOfAdhesion,
};
use crate::input::table::InMemory;
use crate::material::{Body, Elastic};
use crate::run::record::{Outcome, Record};
use crate::run::{self, Wanted};
use crate::scene::Scene;
use crate::scene::history::{Entry, Indent, Oscillate, Press, Slide};
use crate::shape::{Cone, Paraboloid, Profile, RoundedPunch, Shape};
use std::f64::consts::PI;
use std::num::NonZeroUsize;

const ROUNDING: &str = "closed forms through a whole scene, a few dozen roundings";

pub(super) const CASES: &[Case] = &[
    Case {
        name: "friction/Cattaneo–Mindlin lens",
        proof: Proof::Rounding,
        bound: 1e-13,
        reason: ROUNDING,
        weak: "first loading at constant depth",
        error: || lens_first_loading().unwrap_or(f64::NAN),
    },
    Case {
        name: "friction/stick and slip under a lens",
        proof: Proof::Rounding,
        bound: 1e-13,
        reason: "a difference of two bowls, relative to the largest stress",
        weak: "first loading at constant depth",
        error: || lens_stress().unwrap_or(f64::NAN),
    },
    Case {
        name: "friction/cone",
        proof: Proof::Rounding,
        bound: 1e-12,
        reason: "the pressure of a cone is an area cosine: cancellation near the edge of stick",
        weak: "first loading at constant depth",
        error: || cone().unwrap_or(f64::NAN),
    },
    Case {
        name: "friction/punch with a rounded edge",
        proof: Proof::Rounding,
        bound: 1e-12,
        reason: "the closed form in the angle loses φ⁻² digits at φ = 0.3, and differences of it one more",
        weak: "no closed form of τ(r): its integral over the contact is F_x",
        error: || rounded_punch().unwrap_or(f64::NAN),
    },
    Case {
        name: "friction/Mindlin–Deresiewicz loop",
        proof: Proof::Rounding,
        bound: 1e-12,
        reason: "the loss of a cycle is a difference of two sums over ten cycles of 64 steps, each rounded",
        weak: "paraboloid at constant depth, amplitudes from 10⁻⁶ of gross slip to twice it",
        error: || loops().unwrap_or(f64::NAN),
    },
    Case {
        name: "friction/load taken off a sheared lens",
        proof: Proof::Rounding,
        bound: 1e-12,
        reason: ROUNDING,
        weak: "after one slide: F_x = μ[F(d) − F(d − u/m)] at every depth",
        error: || unloaded().unwrap_or(f64::NAN),
    },
    Case {
        name: "friction/slide and force grow together",
        proof: Proof::Bound,
        bound: 1e-6,
        reason: "the depth under a force is a curve, followed to the accuracy of the scene",
        weak: "stick only: F_x = ∫2G*a du with a = (3RF/4E*)^{1/3}",
        error: || growing_together().unwrap_or(f64::NAN),
    },
    Case {
        name: "friction/bed of springs",
        proof: Proof::Bound,
        bound: 1.0,
        reason: "|F_bed − F| ≤ μE*dΔx, half a cell of the variation; printed as the part of the bound used",
        weak: "one history of two slides",
        error: || bed().unwrap_or(f64::NAN),
    },
    Case {
        name: "friction/area drop of a sheared lens",
        proof: Proof::Rounding,
        bound: 1e-11,
        reason: "eqs. 10, 13 and 14 of Persson et al. 2008 at the force the scene gives; a root of a root",
        weak: "uniform stress, a paraboloid",
        error: || area_drop().unwrap_or(f64::NAN),
    },
    Case {
        name: "friction/peeling force of a lens",
        proof: Proof::Rounding,
        bound: 1e-12,
        reason: "eq. 11 of Persson et al. 2008",
        weak: "a paraboloid",
        error: || peeling_force().unwrap_or(f64::NAN),
    },
    Case {
        name: "friction/drop to Hertz",
        proof: Proof::Bound,
        bound: 5e-3,
        reason: "A_H/A_JKR ≈ 0.87 in figure 10 of Persson et al. 2008 has two digits",
        weak: "a rounded number",
        error: || drop_to_hertz().unwrap_or(f64::NAN),
    },
    Case {
        name: "friction/Coulomb–Orowan slider",
        proof: Proof::Rounding,
        bound: 1e-12,
        reason: "a quadrature with its panels cut at the corners of the law",
        weak: "paraboloid: πa²τ(1 − s²/3)",
        error: || orowan().unwrap_or(f64::NAN),
    },
];

/// E* = 1 and G* = 2/3: rubber on a rigid body, elastically similar.
const TANGENTIAL: f64 = 2.0 / 3.0;
const COEFFICIENT: f64 = 0.3;
/// m = μE*/G*.
const REACH: f64 = COEFFICIENT / TANGENTIAL;

fn scene(shape: Shape, friction: Friction, history: Vec<Entry>) -> Option<Scene> {
    let rubber = Elastic { young: Modulus::new(0.75).ok()?, poisson: Poisson::new(0.5).ok()?, yield_stress: None };
    Some(Scene {
        title: String::new(),
        shape,
        bodies: (Body::Elastic(rubber), Body::Rigid),
        adhesion: None,
        friction: Some(friction),
        history,
        accuracy: None,
        springs: None,
        steps: NonZeroUsize::new(4),
        plots: None,
    })
}

fn run_with(scene: Scene, tables: &InMemory) -> Option<Outcome> {
    let setup = scene.resolve(tables).ok()?;
    run::run(&setup, Wanted { fields: true, ..Wanted::NOTHING }).ok()
}

fn run(scene: Scene) -> Option<Outcome> {
    run_with(scene, &InMemory::default())
}

fn coulomb() -> Option<Friction> {
    Some(Friction::Coulomb(Coulomb { coefficient: Ratio::new(COEFFICIENT).ok()? }))
}

fn indent(to: f64) -> Option<Entry> {
    Some(Entry::Indent(Indent { to: Displacement::new(to).ok()?, over: Duration::new(1.0).ok()? }))
}

fn press(to: f64) -> Option<Entry> {
    Some(Entry::Press(Press { to: Force::new(to).ok()?, over: Duration::new(1.0).ok()? }))
}

fn slide(to: f64) -> Option<Entry> {
    Some(Entry::Slide(Slide { to: Displacement::new(to).ok()?, over: Duration::new(1.0).ok()? }))
}

fn lens() -> Option<Shape> {
    Some(Shape::Paraboloid(Paraboloid { radius: Length::new(1.0).ok()? }))
}

/// Where each entry of the history has ended.
fn ends(outcome: &Outcome) -> impl Iterator<Item = &Record> {
    outcome.records.chunk_by(|one, next| one.entry == next.entry).filter_map(|entry| entry.last())
}

/// A lens pressed by one radius of curvature and slid to parts of the reach.
fn slid_lens(parts: &[f64]) -> Option<Outcome> {
    let mut history = vec![indent(1.0)?];
    for part in parts {
        history.push(slide(part * REACH)?);
    }
    run(scene(lens()?, coulomb()?, history)?)
}

const MINDLIN: CattaneoMindlin =
    CattaneoMindlin { force: 4.0 / 3.0, contact_radius: 1.0, tangential_modulus: TANGENTIAL, coefficient: COEFFICIENT };

/// Parts of the reach, to gross slip.
const PARTS: [f64; 7] = [1e-12, 1e-6, 0.01, 0.3, 0.75, 0.99, 1.5];

fn lens_first_loading() -> Option<f64> {
    let outcome = slid_lens(&PARTS)?;
    let mut pairs = Vec::new();
    for (record, part) in ends(&outcome).skip(1).zip(PARTS) {
        let state = record.tangential?;
        pairs.push((state.force, MINDLIN.tangential_force(part * REACH)));
        // c near the axis comes from the small depth that is left: (c/a)² is exact to rounding.
        pairs.push((1.0 + state.stick_radius.powi(2), 1.0 + MINDLIN.stick_radius(part * REACH).powi(2)));
        pairs.push((state.stiffness, 2.0 * TANGENTIAL * state.stick_radius));
    }
    Some(worst(&pairs))
}

/// Largest deviation of the last field's τ(r) from `right`, relative to the largest stress.
fn stress_error(outcome: &Outcome, right: impl Fn(f64) -> f64) -> Option<f64> {
    let field = outcome.fields.last()?;
    let inside = field.rows.iter().filter(|row| row.radius < field.contact_radius * (1.0 - 1e-9));
    let pairs: Vec<(f64, f64)> = inside.filter_map(|row| Some((row.shear?, right(row.radius)))).collect();
    let most = pairs.iter().map(|pair| pair.1.abs()).filter(|stress| stress.is_finite()).fold(0.0, f64::max);
    let worst = pairs.iter().filter(|pair| pair.1.is_finite()).map(|pair| (pair.0 - pair.1).abs()).fold(0.0, f64::max);
    (pairs.len() > 64).then_some(worst / most)
}

fn lens_stress() -> Option<f64> {
    let mut errors = Vec::new();
    // No border of stick at a radius of the field: there the root turns a rounding into 10⁻⁸.
    for part in [0.3, 0.77, 1.5] {
        let outcome = slid_lens(&[part])?;
        let c = MINDLIN.stick_radius(part * REACH);
        errors.push((stress_error(&outcome, |r| MINDLIN.shear_stress(r, c))?, 0.0));
    }
    Some(worst(&errors))
}

/// F_x = μ[F(d) − F(g(c))] and u_x = m(d − g(c)); τ = μ[p(r; a) − p(r; c)].
fn cone() -> Option<f64> {
    let slope = 0.2;
    let shape = Cone { slope: Positive::new(slope).ok()? };
    let (whole, c) = (closed_forms::cone(slope, 1.0), 0.4);
    let stuck = closed_forms::cone(slope, shape.reduced(c * whole.radius));
    let history = vec![indent(1.0)?, slide(REACH * (1.0 - stuck.indentation))?];
    let outcome = run(scene(Shape::Cone(shape), coulomb()?, history)?)?;
    let state = outcome.records.last()?.tangential?;
    let pressure = |a: f64, r: f64| if r < a { closed_forms::cone_pressure(slope, a, r) } else { 0.0 };
    let stress = stress_error(&outcome, |r| COEFFICIENT * (pressure(whole.radius, r) - pressure(stuck.radius, r)))?;
    Some(worst(&[
        (state.force, COEFFICIENT * (whole.force - stuck.force)),
        (state.stick_radius, stuck.radius),
        (1.0 + stress, 1.0),
    ]))
}

fn rounded_punch() -> Option<f64> {
    let (flat_radius, edge_radius) = (0.3, 1.7);
    let shape =
        RoundedPunch { flat_radius: Length::new(flat_radius).ok()?, edge_radius: Length::new(edge_radius).ok()? };
    let at = |angle: f64| closed_forms::rounded_punch(flat_radius, edge_radius, angle);
    let whole = at(1.1);
    let mut pairs = Vec::new();
    for angle in [0.3, 0.7, 1.0] {
        let stuck = at(angle);
        let history = vec![indent(whole.indentation)?, slide(REACH * (whole.indentation - stuck.indentation))?];
        let outcome = run(scene(Shape::RoundedPunch(shape.clone()), coulomb()?, history)?)?;
        let state = outcome.records.last()?.tangential?;
        pairs.push((state.force, COEFFICIENT * (whole.force - stuck.force)));
        pairs.push((state.stick_radius, stuck.radius));
    }
    Some(worst(&pairs))
}

fn shaken(amplitude: f64) -> Option<Outcome> {
    let shake = Oscillate {
        amplitude: Amplitude::new(amplitude).ok()?,
        frequency: Frequency::new(1.0).ok()?,
        cycles: Positive::new(10.0).ok()?,
    };
    run(scene(lens()?, coulomb()?, vec![indent(1.0)?, Entry::Shake(shake)])?)
}

fn loops() -> Option<f64> {
    let mut pairs = Vec::new();
    for part in [1e-6, 1e-3, 0.1, 0.5, 0.9, 1.0, 2.0] {
        let lost = shaken(part * REACH)?.number("dissipated_per_cycle_j")?;
        pairs.push((lost, MINDLIN.loss_per_cycle(part * REACH)));
    }
    Some(worst(&pairs))
}

/// What sticks after the slide u keeps v = u, and what has slipped follows its limit m(d − g) down.
fn unloaded() -> Option<f64> {
    let slid = 0.4;
    let load = |depth: f64| if depth > 0.0 { closed_forms::hertz(1.0, depth).force } else { 0.0 };
    let history = vec![indent(1.0)?, slide(slid * REACH)?, indent(0.1)?];
    let outcome = run(Scene { steps: NonZeroUsize::new(9), ..scene(lens()?, coulomb()?, history)? })?;
    let pairs = outcome.records.iter().filter(|record| record.entry == 2);
    let pairs: Option<Vec<_>> = pairs
        .map(|record| {
            let depth = record.normal.indentation?;
            Some((record.tangential?.force, COEFFICIENT * (load(depth) - load(depth - slid))))
        })
        .collect();
    Some(worst(&pairs?))
}

/// A table in which the force rises to 1 while the body slides too little to slip: F_x = ¾·2G*a u.
fn growing_together() -> Option<f64> {
    let slid = 1e-3;
    let rows = ([0.0, 1.0], [0.0, 1.0], [0.0, slid]);
    let tables = InMemory::default().with("h.csv", &[("time_s", &rows.0), ("force_n", &rows.1), ("slide_m", &rows.2)]);
    let outcome = run_with(scene(lens()?, coulomb()?, vec![Entry::Table("h.csv".into())])?, &tables)?;
    let last = outcome.records.last()?;
    let right = 0.75 * 2.0 * TANGENTIAL * 0.75f64.cbrt() * slid;
    Some(worst(&[(last.tangential?.force, right)]))
}

fn bed() -> Option<f64> {
    let history = vec![indent(1.0)?, slide(0.8 * REACH)?, slide(-0.3 * REACH)?];
    let exact = run(scene(lens()?, coulomb()?, history.clone())?)?;
    let springs = 500u16;
    let bed = run(Scene { springs: NonZeroUsize::new(usize::from(springs)), ..scene(lens()?, coulomb()?, history)? })?;
    let width = (1.0 + 1.0 / 16.0) / f64::from(springs);
    let used = |pair: (&Record, &Record)| {
        let difference = (pair.0.tangential?.force - pair.1.tangential?.force).abs();
        Some(difference / (COEFFICIENT * pair.0.normal.indentation? * width).max(f64::MIN_POSITIVE))
    };
    let parts: Option<Vec<f64>> = exact.records.iter().zip(&bed.records).skip(1).map(used).collect();
    parts?.into_iter().reduce(f64::max)
}

/// The PDMS lens of Persson et al. 2008, section 4.
const PDMS: SavkoorBriggs = SavkoorBriggs { radius: 2.5e-3, modulus: 6.4e6, work: 0.042, ratio: 0.0 };
const LOAD: f64 = 0.048;

/// α of a uniform stress at ν = 1/2, written out: π²/16.
fn pdms() -> SavkoorBriggs {
    SavkoorBriggs { ratio: PI * PI / 16.0, ..PDMS }
}

fn sheared_lens(stress: f64) -> Option<Outcome> {
    let shape = Shape::Paraboloid(Paraboloid { radius: Length::new(PDMS.radius).ok()? });
    let law = PressureLaw { shear: Strength::Constant(Stress::new(stress).ok()?), slope: Ratio::new(0.0).ok()? };
    let pressed = scene(shape, Friction::Pressure(law), vec![press(LOAD)?, slide(1e-6)?])?;
    let pdms = Elastic { young: Modulus::new(4.8e6).ok()?, poisson: Poisson::new(0.5).ok()?, yield_stress: None };
    let adhesion = Jkr { work: WorkOfAdhesion::new(PDMS.work).ok()?, edge: None };
    run(Scene { bodies: (Body::Elastic(pdms), Body::Rigid), adhesion: Some(Adhesion::Jkr(adhesion)), ..pressed })
}

fn area_drop() -> Option<f64> {
    let lens = pdms();
    let hertz = 0.75 * lens.radius * LOAD / lens.modulus;
    let mut pairs = Vec::new();
    for stress in [0.0, 1e3, 1e4, 3e4, 4e4] {
        let last = *sheared_lens(stress)?.records.last()?;
        let (a, shear) = (last.normal.contact_radius?, last.tangential?.force);
        let cube = SavkoorBriggs::cube_over_hertz(lens.ratio, lens.adhesion_force() / LOAD, shear / LOAD);
        let rest = SavkoorBriggs::cube_over_hertz(lens.ratio, lens.adhesion_force() / LOAD, 0.0);
        pairs.push((a, lens.contact_radius(LOAD, shear)));
        pairs.push((a.powi(3) / hertz, cube));
        pairs.push((last.tangential?.area_ratio?, (cube / rest).powf(2.0 / 3.0)));
        pairs.push((shear, PI * a * a * stress));
        pairs.push((last.normal.force, LOAD));
    }
    Some(worst(&pairs))
}

fn peeling_force() -> Option<f64> {
    let found = sheared_lens(3e4)?.number("critical_tangential_force_n")?;
    Some(worst(&[(found, pdms().critical_force(LOAD))]))
}

fn drop_to_hertz() -> Option<f64> {
    let outcome = sheared_lens(1e5)?;
    Some(worst(&[(outcome.number("area_ratio")?, 0.87), (outcome.number("hertz_area_ratio")?, 0.87)]))
}

fn orowan() -> Option<f64> {
    let mut pairs = Vec::new();
    for cap in [1e-3, 0.03, 0.2, 10.0] {
        let law = CoulombOrowan { coefficient: Ratio::new(COEFFICIENT).ok()?, shear_limit: Modulus::new(cap).ok()? };
        let history = vec![indent(1.0)?, slide(-1.0)?];
        let outcome = run(scene(lens()?, Friction::CoulombOrowan(law), history)?)?;
        let right = orowan_on_hertz(4.0 / 3.0, 1.0, (COEFFICIENT, cap));
        pairs.push((outcome.records.last()?.tangential?.force, -right));
        pairs.push((outcome.number("friction_dissipated_j")?, right));
        pairs.push((outcome.number("friction_coefficient")?, 0.75 * right));
    }
    Some(worst(&pairs))
}
