//! Viscoelastic contacts, run as whole scenes, against the solutions of Lee & Radok and of Ting.

use crate::check::case::{Case, Proof, worst};
use crate::contact::adhesion::{Adhesion, Edge, Jkr};
use crate::contact::viscoelastic::Spectrum;
use crate::input::quantity::{
    Amplitude, Displacement, Duration, Force, Frequency, Length, Poisson, Positive, Speed, Stress, Viscosity,
    WorkOfAdhesion,
};
use crate::input::table::InMemory;
use crate::material::{Body, Relaxation, Shear, Term, Terms, Viscoelastic};
use crate::numerics::quadrature;
use crate::numerics::root;
use crate::run::record::{Outcome, Record};
use crate::run::{self, Wanted};
use crate::scene::Scene;
use crate::scene::history::{Entry, Hold, Indent, Oscillate, Press, Retract};
use crate::shape::{FlatPunch, Paraboloid, Shape};
use std::f64::consts::{PI, TAU};
use std::num::NonZeroUsize;

const DIGITS: &str = "the references have seven to ten digits";
const QUADRATURE: &str = "sums of 32 nodes over panels that shrink towards the edge, against the same integrals in other variables: a few hundred roundings of the greatest force";

pub(super) const CASES: &[Case] = &[
    Case {
        name: "ting/triangles",
        proof: Proof::Other,
        bound: 5e-7,
        reason: DIGITS,
        weak: "one term each; the whole branch has two",
        error: || triangles().unwrap_or(f64::NAN),
    },
    Case {
        name: "ting/instants at which the force vanishes",
        proof: Proof::Rounding,
        bound: 1e-13,
        reason: "roots of I(t) = 2I(t − 1), I the primitive of E*, by bisection in double precision",
        weak: "three spectra of one term",
        error: || vanishing().unwrap_or(f64::NAN),
    },
    Case {
        name: "ting/whole unloading branch",
        proof: Proof::Rounding,
        bound: 1e-11,
        reason: QUADRATURE,
        weak: "relative to the greatest force; a paraboloid",
        error: || unloading(&TWO_TERMS).unwrap_or(f64::NAN),
    },
    Case {
        name: "ting/ten terms over ten decades",
        proof: Proof::Rounding,
        bound: 1e-11,
        reason: QUADRATURE,
        weak: "relative to the greatest force; a paraboloid",
        error: || unloading(&TEN_TERMS).unwrap_or(f64::NAN),
    },
    Case {
        name: "ting/error estimate over true error",
        proof: Proof::Bound,
        bound: 1.0,
        reason: "the estimate must not be smaller than the error",
        weak: "two spectra; the cone over thirty decades is a test of the bed",
        error: || true_over_estimated().unwrap_or(f64::NAN),
    },
    Case {
        name: "lee–radok/ramp and hold",
        proof: Proof::Rounding,
        bound: 1e-11,
        reason: QUADRATURE,
        weak: "a paraboloid",
        error: || ramp_and_hold().unwrap_or(f64::NAN),
    },
    Case {
        name: "lee–radok/step",
        proof: Proof::Rounding,
        bound: 1e-13,
        reason: "a jump is a ramp of 1e-20 of the shortest time: sums of one sign",
        weak: "a paraboloid",
        error: || step().unwrap_or(f64::NAN),
    },
    Case {
        name: "lee–radok/sinusoid",
        proof: Proof::Bound,
        bound: 2e-6,
        reason: "chords within 1e-6 of the depth and springs for half of it",
        weak: "a quarter of a cycle, while the contact grows",
        error: || sinusoid().unwrap_or(f64::NAN),
    },
    Case {
        name: "creep/a³ = (3R/4) ∫ J dF",
        proof: Proof::Rounding,
        bound: 1e-11,
        reason: "sums of one sign and one root; the ramp of 1e-12 of the shortest time",
        weak: "a paraboloid; force that does not fall",
        error: || creep().unwrap_or(f64::NAN),
    },
    Case {
        name: "oscillation/storage and loss of a punch",
        proof: Proof::Bound,
        bound: 1e-9,
        reason: "the first harmonics of path and force by two nodes per chord of a 256th of a cycle, fourth order; what is left of the start e^(−20/0.4)",
        weak: "a punch, whose edge stands still; of a ball the edge moves and only small loops agree",
        error: || loop_of_a_punch().unwrap_or(f64::NAN),
    },
    Case {
        name: "oscillation/small loop on a ball",
        proof: Proof::Order,
        bound: 2e-3,
        reason: "the edge moves by a thousandth of the radius: the loop differs from that of a still edge by as much",
        weak: "one amplitude",
        error: || loop_of_a_ball().unwrap_or(f64::NAN),
    },
    Case {
        name: "viscoelastic jkr/slow pull-off",
        proof: Proof::Order,
        bound: 2e-3,
        reason: "one part in 10⁴ of the relaxation is left at this speed; near its vertical tangent the force shows the root",
        weak: "approaches the limit only",
        error: || slow_pull_off().unwrap_or(f64::NAN),
    },
    Case {
        name: "viscoelastic/ten records or a thousand",
        proof: Proof::Rounding,
        bound: 1e-12,
        reason: "a record looks and changes nothing: the same roundings",
        weak: "one history",
        error: || ten_or_a_thousand().unwrap_or(f64::NAN),
    },
];

/// G∞ and pairs (Gᵢ, τᵢ); with ν = ½, E* = 4G.
struct Material<'m>(f64, &'m [(f64, f64)]);

const TWO_TERMS: Material<'static> = Material(0.25, &[(0.75, 0.3), (0.5, 5.0)]);
const TEN_TERMS: Material<'static> = Material(
    0.1,
    &[
        (1.0, 1e-7),
        (0.9, 1e-6),
        (0.8, 1e-5),
        (0.7, 1e-4),
        (0.6, 1e-3),
        (0.5, 1e-2),
        (0.4, 0.1),
        (0.3, 1.0),
        (0.2, 10.0),
        (0.1, 1e3),
    ],
);
/// Speed [m/s] of the triangles; they turn after a second. R = 1 m.
const SPEED: f64 = 0.01;

impl Material<'_> {
    fn body(&self) -> Option<Body> {
        let term = |&(modulus, time): &(f64, f64)| {
            Some(Term { modulus: Stress::new(modulus).ok()?, time: Duration::new(time).ok()? })
        };
        let terms = Terms::List(self.1.iter().map(term).collect::<Option<_>>()?);
        let shear = Shear { equilibrium: Stress::new(self.0).ok()?, terms, viscosity: Viscosity::default() };
        Some(Body::Viscoelastic(Viscoelastic { poisson: Poisson::new(0.5).ok()?, shear }))
    }

    fn spectrum(&self) -> Spectrum {
        let terms = self.1.iter().map(|&(modulus, time)| (4.0 * modulus, time)).collect();
        Spectrum::new(&Relaxation { equilibrium: 4.0 * self.0, terms, viscosity: 0.0 })
    }

    /// ∫₀^x E* dt.
    fn primitive(&self, x: f64) -> f64 {
        4.0 * (self.0 * x + self.1.iter().map(|&(g, tau)| -g * tau * (-x / tau).exp_m1()).sum::<f64>())
    }

    /// (4/3) ∫₀^first E*(t−s) d(d^{3/2}) for d = vs, by s = first·σ² and panels towards s = t and s = first.
    fn force(&self, t: f64, first: f64) -> f64 {
        let at = |lag: f64| {
            let s = (first - lag).max(0.0);
            self.modulus((t - first) + lag) * s.sqrt()
        };
        let breaks: Vec<f64> = (1..=60).rev().map(|k| first * 0.5f64.powi(k)).collect();
        let (near, far) = (&breaks[..], first * 0.5);
        let inner = quadrature::panels(at, (0.0, far), near);
        // Towards s = 0 the root is taken away.
        let outer =
            quadrature::panel(|root| 2.0 * root * root * self.modulus(t - root * root), 0.0, (first - far).sqrt());
        2.0 * SPEED.powf(1.5) * (inner + outer)
    }

    fn modulus(&self, t: f64) -> f64 {
        4.0 * (self.0 + self.1.iter().map(|&(g, tau)| g * (-t / tau).exp()).sum::<f64>())
    }
}

fn ball() -> Option<Shape> {
    Some(Shape::Paraboloid(Paraboloid { radius: Length::new(1.0).ok()? }))
}

fn indent(to: f64, over: f64) -> Option<Entry> {
    Some(Entry::Indent(Indent { to: Displacement::new(to).ok()?, over: Duration::new(over).ok()? }))
}

fn hold(over: f64) -> Option<Entry> {
    Some(Entry::Hold(Hold { over: Duration::new(over).ok()? }))
}

fn scene(material: &Material<'_>, shape: Shape, history: Vec<Entry>) -> Option<Scene> {
    Some(Scene {
        title: String::new(),
        shape,
        bodies: (material.body()?, Body::Rigid),
        adhesion: None,
        friction: None,
        history,
        accuracy: None,
        springs: None,
        steps: NonZeroUsize::new(20),
        plots: None,
    })
}

fn run(scene: Scene) -> Option<Outcome> {
    run_with(scene, &InMemory::default())
}

fn run_with(scene: Scene, tables: &InMemory) -> Option<Outcome> {
    run::run(&scene.resolve(tables).ok()?, Wanted::NOTHING).ok()
}

fn triangle(material: &Material<'_>) -> Option<Outcome> {
    run(scene(material, ball()?, vec![indent(SPEED, 1.0)?, indent(0.0, 1.0)?])?)
}

fn force_at(outcome: &Outcome, time: f64) -> Option<f64> {
    outcome.records.iter().find(|record| (record.time - time).abs() < 1e-9).map(|record| record.normal.force)
}

/// Material, pairs of time and force, and when the force vanishes.
type ForceTimes = (Material<'static>, &'static [(f64, f64)], f64);

const TRIANGLES: [ForceTimes; 3] = [
    (
        Material(0.1, &[(0.9, 0.2)]),
        &[(1.0, 1.806_718_02e-3), (1.1, 6.847_747e-4), (1.2, 9.472_905e-5)],
        1.246_434_166_337_735_8,
    ),
    (Material(0.5, &[(0.5, 0.2)]), &[(1.0, 3.374_102_65e-3), (1.3, 1.202_475e-3)], 1.807_048_721_673_473_2),
    (Material(0.01, &[(0.99, 0.01)]), &[(1.0, 1.321_353_24e-4)], 1.041_430_677_251_722_6),
];

fn triangles() -> Option<f64> {
    let mut pairs = Vec::new();
    for (material, forces, _) in &TRIANGLES {
        let outcome = triangle(material)?;
        for &(time, force) in *forces {
            pairs.push((force_at(&outcome, time)?, force));
        }
    }
    let two = triangle(&TWO_TERMS)?;
    for (time, force) in
        [(0.5, 0.002_171_497_338), (1.0, 0.005_262_688_380), (1.2, 0.002_530_129_213), (1.4, 0.000_916_887_196)]
    {
        pairs.push((force_at(&two, time)?, force));
    }
    Some(worst(&pairs))
}

/// The first record without contact after the turn.
fn parting(records: &[Record]) -> Option<f64> {
    let apart = |record: &&Record| record.time > 1.0 && record.normal.contact_radius.is_some_and(|a| a <= 0.0);
    records.iter().find(apart).map(|record| record.time)
}

fn vanishing() -> Option<f64> {
    let one = |(material, _, time): &ForceTimes| Some((parting(&triangle(material)?.records)?, *time));
    Some(worst(&TRIANGLES.iter().map(one).collect::<Option<Vec<_>>>()?))
}

/// Ting (1966): ∫ over (t₁, t) of E*(t−s) ḋ ds = 0 gives I(t−t₁) = 2I(t−1) with I the primitive of E*.
fn unloading(material: &Material<'_>) -> Option<f64> {
    deviation(material, &triangle(material)?)
}

fn deviation(material: &Material<'_>, outcome: &Outcome) -> Option<f64> {
    let largest = outcome.number("largest_force_n")?;
    let end = root::brent(|t| material.primitive(t) - 2.0 * material.primitive(t - 1.0), 1.0, 2.0).unwrap_or(2.0);
    let mut pairs = Vec::new();
    for record in outcome.records.iter().filter(|record| record.time > 0.0) {
        let t = record.time;
        let right = if t <= 1.0 {
            material.force(t, t)
        } else if t >= end {
            0.0
        } else {
            let wanted = 2.0 * material.primitive(t - 1.0);
            // In the lag beyond t − 1, which may be far shorter than t.
            let lag = root::brent(|lag| material.primitive((t - 1.0) + lag) - wanted, 0.0, 1.0).ok()?;
            material.force(t, 1.0 - lag)
        };
        pairs.push((1.0 + record.normal.force / largest, 1.0 + right / largest));
    }
    let parted = parting(&outcome.records);
    if end < 2.0 {
        pairs.push((parted?, end));
    }
    Some(worst(&pairs))
}

fn true_over_estimated() -> Option<f64> {
    let one = |material: &Material<'_>| {
        let outcome = triangle(material)?;
        Some(deviation(material, &outcome)? / outcome.error_estimate.relative)
    };
    Some(one(&TWO_TERMS)?.max(one(&TEN_TERMS)?))
}

fn ramp_and_hold() -> Option<f64> {
    let outcome = run(scene(&TEN_TERMS, ball()?, vec![indent(SPEED, 1.0)?, hold(9.0)?])?)?;
    let largest = outcome.number("largest_force_n")?;
    let pair = |record: &Record| {
        (1.0 + record.normal.force / largest, 1.0 + TEN_TERMS.force(record.time, record.time.min(1.0)) / largest)
    };
    Some(worst(&outcome.records[1..].iter().map(pair).collect::<Vec<_>>()))
}

fn step() -> Option<f64> {
    let times = [0.0, 1e-8, 1e-3, 0.2, 5.0, 1e4];
    let tables = InMemory::default().with("step.csv", &[("time_s", &times), ("indentation_m", &[0.01; 6])]);
    let outcome = run_with(scene(&TEN_TERMS, ball()?, vec![Entry::Table("step.csv".into())])?, &tables)?;
    let last = |time: f64| outcome.records.iter().rfind(|record| (record.time - time).abs() <= 0.0);
    let pair = |&time: &f64| Some((last(time)?.normal.force, 4.0 / 3.0 * 1e-3 * TEN_TERMS.modulus(time)));
    Some(worst(&times.iter().map(pair).collect::<Option<Vec<_>>>()?))
}

/// A step to d₀, then d₀ + A sin 2πft for a quarter of a cycle.
fn sinusoid() -> Option<f64> {
    let (depth, amplitude) = (0.01, 0.004);
    let wave = Oscillate {
        amplitude: Amplitude::new(amplitude).ok()?,
        frequency: Frequency::new(0.5).ok()?,
        cycles: Positive::new(0.25).ok()?,
    };
    let tables = InMemory::default().with("step.csv", &[("time_s", &[0.0, 1e-9]), ("indentation_m", &[depth; 2])]);
    let history = vec![Entry::Table("step.csv".into()), Entry::Oscillate(wave)];
    let outcome = run_with(scene(&TWO_TERMS, ball()?, history)?, &tables)?;
    let force = |t: f64| {
        let rise = |s: f64| {
            let d = depth + amplitude * (PI * s).sin();
            TWO_TERMS.modulus(t - s) * 1.5 * d.sqrt() * amplitude * PI * (PI * s).cos()
        };
        4.0 / 3.0 * (depth.powf(1.5) * TWO_TERMS.modulus(t + 1e-9) + quadrature::panel(rise, 0.0, t))
    };
    let waves = outcome.records.iter().filter(|record| record.entry == 1 && record.time > 1e-6);
    let pairs: Vec<(f64, f64)> = waves.map(|record| (record.normal.force, force(record.time - 1e-9))).collect();
    (!pairs.is_empty()).then(|| worst(&pairs))
}

fn creep() -> Option<f64> {
    let force = 1e-3;
    let press = Entry::Press(Press { to: Force::new(force).ok()?, over: Duration::new(1e-13).ok()? });
    let rest = Entry::HoldForce(Hold { over: Duration::new(1e3).ok()? });
    let outcome = run(scene(&TWO_TERMS, ball()?, vec![press, rest])?)?;
    let spectrum = TWO_TERMS.spectrum();
    let held = outcome.records.iter().filter(|record| record.entry == 1);
    let pair =
        |record: &Record| Some((record.normal.contact_radius?.powi(3), 0.75 * force * spectrum.creep(record.time)));
    Some(worst(&held.map(pair).collect::<Option<Vec<_>>>()?))
}

const FAST: Material<'static> = Material(0.25, &[(0.75, 0.05), (0.5, 0.4)]);

fn moduli(shape: Shape, amplitude: f64) -> Option<f64> {
    let wave = Oscillate {
        amplitude: Amplitude::new(amplitude).ok()?,
        frequency: Frequency::new(1.0).ok()?,
        cycles: Positive::new(20.0).ok()?,
    };
    let history = vec![indent(0.01, 1.0)?, hold(40.0)?, Entry::Oscillate(wave)];
    let outcome = run(scene(&FAST, shape, history)?)?;
    let spectrum = FAST.spectrum();
    Some(worst(&[
        (outcome.number("storage_modulus_pa")?, spectrum.storage(TAU)),
        (outcome.number("loss_modulus_pa")?, spectrum.loss(TAU)),
    ]))
}

fn loop_of_a_punch() -> Option<f64> {
    moduli(Shape::FlatPunch(FlatPunch { radius: Length::new(0.5).ok()? }), 1e-3)
}

fn loop_of_a_ball() -> Option<f64> {
    moduli(ball()?, 2e-5)
}

/// Slow retraction reaches JKR's pull-off with E∞ = 1: F = −(5/6)πwR at d = −1.608772 (w²π²R/E∞²)^{1/3}/….
fn slow_pull_off() -> Option<f64> {
    let soft = Material(0.25, &[(1.25, 1.0), (0.125, 30.0)]);
    let history = vec![indent(5.0, 1e6)?, hold(1e6)?, Entry::Retract(Retract { speed: Speed::new(1e-7).ok()? })];
    let adhesion = Jkr { work: WorkOfAdhesion::new(1.0).ok()?, edge: Some(Edge::Relaxed) };
    let slow = Scene { adhesion: Some(Adhesion::Jkr(adhesion)), ..scene(&soft, ball()?, history)? };
    let outcome = run(slow)?;
    let last = outcome.records.iter().rfind(|record| record.normal.force < 0.0)?;
    Some(worst(&[
        (last.normal.force, -5.0 / 6.0 * PI),
        (last.normal.indentation?, -1.608_772_047_833_27),
        (outcome.number("pull_off_force_n")?, -1.5 * PI),
    ]))
}

fn ten_or_a_thousand() -> Option<f64> {
    let history = || {
        Some(vec![
            indent(0.01, 1.0)?,
            hold(0.3)?,
            indent(0.006, 0.2)?,
            hold(2.0)?,
            indent(0.012, 1.0)?,
            indent(-0.001, 1.0)?,
        ])
    };
    let with = |steps| run(Scene { steps: NonZeroUsize::new(steps), ..scene(&TWO_TERMS, ball()?, history()?)? });
    let (few, many) = (with(10)?, with(1000)?);
    let names = ["largest_force_n", "largest_contact_radius_m", "work_j", "dissipated_j", "final_time_s"];
    let mut pairs = Vec::new();
    for name in names {
        pairs.push((few.number(name)?, many.number(name)?));
    }
    pairs.push((parting(&few.records)?, parting(&many.records)?));
    Some(worst(&pairs))
}
