//! Errors asked for, estimated and true, over scenes with exact answers.

use super::closed_forms;
use super::tangential::CattaneoMindlin;
use super::ting::Triangle;
use crate::contact::adhesion::{Adhesion, Jkr, Maugis};
use crate::friction::{Coulomb, Friction};
use crate::input::quantity::{
    Accuracy, Amplitude, Displacement, Duration, Force, Frequency, Length, Mass, Modulus, Poisson, Positive, Ratio,
    Speed, Stress, Viscosity, WorkOfAdhesion,
};
use crate::input::table::InMemory;
use crate::material::{Body, Elastic, Relaxation, Shear, Term, Terms, Viscoelastic};
use crate::run::record::{Outcome, Record};
use crate::run::{self, Wanted};
use crate::scene::Scene;
use crate::scene::history::{Entry, Hold, Impact, Indent, Oscillate, Press, Retract, Slide};
use crate::shape::{Cone, Paraboloid, Shape, Sphere, WavyParaboloid};
use rayon::prelude::*;
use serde::Serialize;
use std::f64::consts::PI;
use std::num::NonZeroUsize;

/// One scene at one accuracy, with the error it promises and the true one.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Row {
    /// Name of the scene.
    pub scene: &'static str,
    /// The solver chosen.
    pub solver: &'static str,
    /// Springs allocated.
    pub springs: usize,
    /// Relative error asked for.
    pub asked: f64,
    /// Relative error estimated by the run.
    pub estimated: f64,
    /// True relative error.
    pub error: f64,
    /// Whether the true error is within the estimate.
    pub kept: bool,
}

/// Pairs (computed, right).
type Pairs = Vec<(f64, f64)>;

/// A scene, and what of its results is known.
#[derive(Clone, Copy)]
struct Known {
    name: &'static str,
    scene: fn() -> Option<Scene>,
    compared: fn(&Outcome) -> Option<Pairs>,
    asked: &'static [f64],
    springs: &'static [usize],
}

const ONCE: &[f64] = &[1e-6];
const LADDER: &[f64] = &[1e-2, 1e-4, 1e-6];
const BEDS: &[usize] = &[100, 1000, 10_000];

const KNOWN: &[Known] = &[
    Known { name: "Hertz", scene: hertz, compared: hertz_compared, asked: ONCE, springs: BEDS },
    Known { name: "sphere", scene: sphere, compared: sphere_compared, asked: ONCE, springs: &[] },
    Known { name: "cone", scene: cone, compared: cone_compared, asked: ONCE, springs: BEDS },
    Known { name: "wavy paraboloid", scene: wavy, compared: wavy_compared, asked: ONCE, springs: &[] },
    Known { name: "JKR pulled away by depth", scene: jkr_depth, compared: jkr_compared, asked: ONCE, springs: BEDS },
    Known { name: "JKR a hair from pull-off", scene: jkr_hair, compared: jkr_hair_compared, asked: ONCE, springs: &[] },
    Known { name: "Maugis pull-off", scene: maugis, compared: maugis_compared, asked: ONCE, springs: &[] },
    Known { name: "Cattaneo–Mindlin", scene: mindlin, compared: mindlin_compared, asked: ONCE, springs: BEDS },
    Known { name: "Ting's triangle", scene: ting, compared: ting_compared, asked: LADDER, springs: &[] },
    Known { name: "creep", scene: creep, compared: creep_compared, asked: LADDER, springs: &[] },
    Known { name: "oscillation", scene: oscillation, compared: oscillation_compared, asked: LADDER, springs: &[] },
    Known { name: "Hertz impact", scene: impact, compared: impact_compared, asked: LADDER, springs: &[] },
];

/// Number of rows.
#[must_use]
pub fn count() -> usize {
    KNOWN.iter().map(|known| known.asked.len() + known.springs.len()).sum()
}

/// All scenes at all accuracies, in parallel, rows in their order; `done` is called after each.
pub fn rows(done: impl Fn() + Sync) -> Vec<Row> {
    let asked = |known: &'static Known| known.asked.iter().map(move |&asked| (known, asked, None));
    let beds = |known: &'static Known| known.springs.iter().map(move |&springs| (known, 1e-6, Some(springs)));
    let all: Vec<_> = KNOWN.iter().flat_map(|known| asked(known).chain(beds(known))).collect();
    let row = |&(known, asked, springs): &(&Known, f64, Option<usize>)| {
        let row = row(known, asked, springs);
        done();
        row
    };
    all.par_iter().map(row).collect()
}

/// A scene that cannot be run keeps no promise.
fn row(known: &Known, asked: f64, springs: Option<usize>) -> Row {
    let outcome = run(known, asked, springs);
    let pairs = outcome.as_ref().and_then(known.compared);
    let error = pairs.map_or(f64::NAN, |pairs| super::case::worst(&pairs));
    let estimated = outcome.as_ref().map_or(f64::NAN, |outcome| outcome.error_estimate.relative);
    let plan = outcome.map(|outcome| outcome.plan);
    Row {
        scene: known.name,
        solver: plan.as_ref().map_or("–", |plan| plan.solver),
        springs: plan.map_or(0, |plan| plan.springs),
        asked,
        estimated,
        error,
        kept: error <= estimated,
    }
}

fn run(known: &Known, asked: f64, springs: Option<usize>) -> Option<Outcome> {
    let accuracy = Some(Accuracy::new(asked).ok()?);
    let scene = Scene { accuracy, springs: springs.and_then(NonZeroUsize::new), ..(known.scene)()? };
    run::run(&scene.resolve(&InMemory::default()).ok()?, Wanted::NOTHING).ok()
}

fn scene(shape: Shape, body: Body, history: Vec<Entry>) -> Scene {
    Scene {
        title: String::new(),
        shape,
        bodies: (body, Body::Rigid),
        adhesion: None,
        friction: None,
        history,
        accuracy: None,
        springs: None,
        steps: None,
        plots: None,
    }
}

/// E* = 1 and, with ν = 0.5, G* = 2/3.
fn unit() -> Option<Body> {
    let (young, poisson) = (Modulus::new(0.75).ok()?, Poisson::new(0.5).ok()?);
    Some(Body::Elastic(Elastic { young, poisson, yield_stress: None }))
}

/// E*(t) = 4G(t) of an incompressible standard linear solid.
fn solid(equilibrium: f64, terms: &[(f64, f64)], viscosity: f64) -> Option<Body> {
    let term = |&(modulus, time): &(f64, f64)| {
        Some(Term { modulus: Stress::new(modulus).ok()?, time: Duration::new(time).ok()? })
    };
    let terms = Terms::List(terms.iter().map(term).collect::<Option<_>>()?);
    let (equilibrium, viscosity) = (Stress::new(equilibrium).ok()?, Viscosity::new(viscosity).ok()?);
    let shear = Shear { equilibrium, terms, viscosity };
    Some(Body::Viscoelastic(Viscoelastic { poisson: Poisson::new(0.5).ok()?, shear }))
}

fn ball() -> Option<Shape> {
    Some(Shape::Paraboloid(Paraboloid { radius: Length::new(1.0).ok()? }))
}

fn indent(to: f64) -> Option<Entry> {
    Some(Entry::Indent(Indent { to: Displacement::new(to).ok()?, over: Duration::new(1.0).ok()? }))
}

fn press(to: f64) -> Option<Entry> {
    Some(Entry::Press(Press { to: Force::new(to).ok()?, over: Duration::new(1.0).ok()? }))
}

const DEPTH: f64 = 0.01;

fn hertz() -> Option<Scene> {
    Some(scene(ball()?, unit()?, vec![indent(DEPTH)?]))
}

fn at_end(outcome: &Outcome, right: closed_forms::Contact) -> Option<Pairs> {
    let last = outcome.records.last()?.normal;
    Some(vec![(last.force, right.force), (last.contact_radius?, right.radius)])
}

fn hertz_compared(outcome: &Outcome) -> Option<Pairs> {
    at_end(outcome, closed_forms::hertz(1.0, DEPTH))
}

/// a/R = tanh 1.
fn sphere() -> Option<Scene> {
    let depth = closed_forms::sphere(1.0, 1.0).indentation;
    Some(scene(Shape::Sphere(Sphere { radius: Length::new(1.0).ok()? }), unit()?, vec![indent(depth)?]))
}

fn sphere_compared(outcome: &Outcome) -> Option<Pairs> {
    at_end(outcome, closed_forms::sphere(1.0, 1.0))
}

fn cone() -> Option<Scene> {
    Some(scene(Shape::Cone(Cone { slope: Positive::new(0.1).ok()? }), unit()?, vec![indent(DEPTH)?]))
}

fn cone_compared(outcome: &Outcome) -> Option<Pairs> {
    at_end(outcome, closed_forms::cone(0.1, DEPTH))
}

const WAVY: (f64, f64) = (0.001, 0.25);

fn wavy() -> Option<Scene> {
    let (amplitude, wavelength) = (Amplitude::new(WAVY.0).ok()?, Length::new(WAVY.1).ok()?);
    let shape = WavyParaboloid { radius: Length::new(1.0).ok()?, amplitude, wavelength };
    Some(scene(Shape::WavyParaboloid(shape), unit()?, vec![indent(0.365_807_593_708_617_6)?]))
}

/// The contact of radius 0.6: its depth and N = F/(2E*) were made with thirty digits.
fn wavy_compared(outcome: &Outcome) -> Option<Pairs> {
    let last = outcome.records.last()?.normal;
    Some(vec![(last.contact_radius?, 0.6), (last.force, 2.0 * 0.146_846_890_799_377_52)])
}

fn sticky(scene: Scene, work: f64) -> Option<Scene> {
    let adhesion = Adhesion::Jkr(Jkr { work: WorkOfAdhesion::new(work).ok()?, edge: None });
    Some(Scene { adhesion: Some(adhesion), ..scene })
}

/// w such that depths are of the order of 10⁻³ R.
const WORK: f64 = 1e-5;

fn jkr_depth() -> Option<Scene> {
    let retract = Entry::Retract(Retract { speed: Speed::new(1e-3).ok()? });
    sticky(scene(ball()?, unit()?, vec![indent(2e-3)?, retract]), WORK)
}

fn jkr_compared(outcome: &Outcome) -> Option<Pairs> {
    Some(vec![(outcome.number("pull_off_force_n")?, -1.5 * PI * WORK)])
}

/// The force 10⁻¹² short of pull-off: the radius is known to 10⁻¹⁰.
const HAIR: f64 = 1e-12;

fn jkr_hair() -> Option<Scene> {
    sticky(scene(ball()?, unit()?, vec![press(0.0)?, press(-1.5 * PI * WORK * (1.0 - HAIR))?]), WORK)
}

fn jkr_hair_compared(outcome: &Outcome) -> Option<Pairs> {
    let (last, pull) = (outcome.records.last()?.normal, 1.5 * PI * WORK);
    let radius = (0.75 * pull * (1.0 + HAIR.sqrt()).powi(2)).cbrt();
    Some(vec![(last.force, -pull * (1.0 - HAIR)), (last.contact_radius?, radius)])
}

/// K = 4E*/3 = 1, R = 1, πw = u and λ = 1: σ₀ = (u)^{1/3}/2.
const MAUGIS: f64 = 1e-6;

fn maugis() -> Option<Scene> {
    let (young, poisson) = (Modulus::new(0.5625).ok()?, Poisson::new(0.5).ok()?);
    let body = Body::Elastic(Elastic { young, poisson, yield_stress: None });
    let (work, stress) = (WorkOfAdhesion::new(MAUGIS / PI).ok()?, Modulus::new(0.5 * MAUGIS.cbrt()).ok()?);
    let retract = Entry::Retract(Retract { speed: Speed::new(1e-3).ok()? });
    let adhesion = Some(Adhesion::Maugis(Maugis { work, stress }));
    Some(Scene { adhesion, ..scene(ball()?, body, vec![press(MAUGIS)?, retract]) })
}

/// Reference by golden section on the closed equations with thirty digits, as in the case of the pull-off over λ.
fn maugis_compared(outcome: &Outcome) -> Option<Pairs> {
    Some(vec![(outcome.number("pull_off_force_n")?, -1.600_734_911_254_09 * MAUGIS)])
}

const COEFFICIENT: f64 = 0.3;

fn lens() -> CattaneoMindlin {
    let hertz = closed_forms::hertz(1.0, DEPTH);
    CattaneoMindlin {
        force: hertz.force,
        contact_radius: hertz.radius,
        tangential_modulus: 2.0 / 3.0,
        coefficient: COEFFICIENT,
    }
}

fn mindlin() -> Option<Scene> {
    let friction = Some(Friction::Coulomb(Coulomb { coefficient: Ratio::new(COEFFICIENT).ok()? }));
    let to = Displacement::new(0.6 * lens().reach()).ok()?;
    let slide = Entry::Slide(Slide { to, over: Duration::new(1.0).ok()? });
    Some(Scene { friction, ..scene(ball()?, unit()?, vec![indent(DEPTH)?, slide]) })
}

fn mindlin_compared(outcome: &Outcome) -> Option<Pairs> {
    let last = outcome.records.last()?.tangential?;
    Some(vec![(last.force, lens().tangential_force(0.6 * lens().reach()))])
}

fn ting() -> Option<Scene> {
    Some(scene(ball()?, solid(0.1, &[(0.9, 0.2)], 0.0)?, vec![indent(DEPTH)?, indent(0.0)?]))
}

/// All records, relative to the largest.
fn ting_compared(outcome: &Outcome) -> Option<Pairs> {
    let relaxation = Relaxation { equilibrium: 0.4, terms: vec![(3.6, 0.2)], viscosity: 0.0 };
    let exact = Triangle { relaxation, radius: 1.0, speed: DEPTH, turn: 1.0 };
    let most = exact.at(1.0).0;
    let pair = |record: &Record| (1.0 + record.normal.force / most, 1.0 + exact.at(record.time).0 / most);
    Some(outcome.records.iter().map(pair).collect())
}

const LOAD: f64 = 1e-3;

/// The force rises in 10⁻³ s and stays for 2 s, E* = 1 + e^{−t}.
fn creep() -> Option<Scene> {
    let rise = Press { to: Force::new(LOAD).ok()?, over: Duration::new(1e-3).ok()? };
    let stay = Hold { over: Duration::new(2.0).ok()? };
    Some(scene(ball()?, solid(0.25, &[(0.25, 1.0)], 0.0)?, vec![Entry::Press(rise), Entry::HoldForce(stay)]))
}

/// a³ = (3R/4) ∫ J dF with J = 1 − ½e^{−t/2}.
fn creep_compared(outcome: &Outcome) -> Option<Pairs> {
    let last = outcome.records.last()?.normal;
    let delayed = (2.0 / 1e-3) * (-1.0f64).exp() * -(-0.5e-3f64).exp_m1();
    Some(vec![(last.contact_radius?, (0.75 * LOAD * (1.0 - 0.5 * delayed)).cbrt()), (last.force, LOAD)])
}

const CYCLES: f64 = 0.25;

/// A quarter of a cycle about a depth held until all has relaxed: the contact only grows.
fn oscillation() -> Option<Scene> {
    let wave = Oscillate {
        amplitude: Amplitude::new(0.5 * DEPTH).ok()?,
        frequency: Frequency::new(1.0).ok()?,
        cycles: Positive::new(CYCLES).ok()?,
    };
    let rest = Entry::Hold(Hold { over: Duration::new(100.0).ok()? });
    let history = vec![indent(DEPTH)?, rest, Entry::Oscillate(wave)];
    Some(scene(ball()?, solid(0.1, &[(0.9, 0.2)], 0.0)?, history))
}

/// Lee & Radok: F = (4/3)√R ∫ E*(t−s) d(d^{3/2}) over the sine, by quadrature.
fn oscillation_compared(outcome: &Outcome) -> Option<Pairs> {
    let angle = |s: f64| 2.0 * PI * s;
    let depth = |s: f64| DEPTH * (1.0 + 0.5 * angle(s).sin());
    let speed = |s: f64| PI * DEPTH * angle(s).cos();
    let modulus = |t: f64| 0.4 + 3.6 * (-t / 0.2).exp();
    let rising = crate::numerics::quadrature::equal_panels(
        |s| 1.5 * depth(s).sqrt() * speed(s) * modulus(CYCLES - s),
        (0.0, CYCLES),
        0.02,
    );
    let last = outcome.records.last()?.normal;
    Some(vec![(last.force, 4.0 / 3.0 * (0.4 * DEPTH.powf(1.5) + rising))])
}

fn struck(body: Body) -> Option<Scene> {
    let hit = Impact { mass: Mass::new(1.0).ok()?, speed: vec![Speed::new(0.1).ok()?], angle: None, spin: None };
    Some(scene(ball()?, body, vec![Entry::Impact(hit)]))
}

fn impact() -> Option<Scene> {
    struck(unit()?)
}

fn impact_compared(outcome: &Outcome) -> Option<Pairs> {
    let depth = (15.0f64 / 16.0 * 0.01).powf(0.4);
    Some(vec![
        (outcome.number("contact_time_s")?, 2.943_275_184_324_705 * depth / 0.1),
        (outcome.number("largest_indentation_m")?, depth),
    ])
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_estimate_bounds_the_true_error() {
        let broken: Vec<Row> = rows(|| ()).into_iter().filter(|row| !row.kept).collect();
        assert!(broken.is_empty(), "{broken:#?}");
    }

    #[test]
    fn a_scene_that_cannot_be_run_keeps_no_promise() {
        let known = Known { compared: |_| None, ..KNOWN[0] };
        assert!(!row(&known, 1e-6, None).kept);
        let known = Known { scene: || None, ..KNOWN[0] };
        assert!(!row(&known, 1e-6, None).kept);
    }
}
