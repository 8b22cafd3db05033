//! Pixels of a half-space that remember, attract each other or yield: against the beds that know the answer, against
//! closed forms, and under the laws that hold whatever the surface is.

use ndarray::Array2;
use springbed::prelude::*;
use springbed::run::record::{Outcome, Record};
use std::f64::consts::{PI, TAU};

const FIELDS: Wanted = Wanted { fields: true, ..Wanted::NOTHING };
const GEL: &str = "Viscoelastic(poisson: 0.5, shear: (equilibrium: 0.3e6, terms: [(modulus: 0.5e6, time: 0.1), (modulus: 0.2e6, time: 3)]))";
const RUBBER: &str = "Elastic(young: 2e6, poisson: 0.5)";

fn outcome(text: &str) -> Outcome {
    let motion: [(&str, &[f64]); 2] =
        [("time_s", &[0.0, 0.5, 1.0, 1.5, 2.0]), ("indentation_m", &[0.0, 5e-6, 10e-6, 7e-6, 4e-6])];
    let tables = InMemory::default().with_heights("wave.csv", wave()).with("motion.csv", &motion);
    let plan = Notation::Ron.plan(text, &tables).unwrap_or_else(|errors| panic!("{}", errors[0]));
    run(&plan, FIELDS).unwrap_or_else(|error| panic!("{error}"))
}

/// One wave of the amplitude 1 µm.
fn wave() -> Array2<f64> {
    Array2::from_shape_fn((32, 32), |(_, j)| 1e-6 * (TAU * j as f64 / 32.0).cos())
}

/// A ball of 5 mm.
fn ball(bodies: &str, history: &str, more: &str) -> Outcome {
    outcome(&format!("(shape: Paraboloid(radius: 5e-3), bodies: ({bodies}), history: [{history}], {more})"))
}

fn on_pixels(grid: usize) -> String {
    format!("solver: HalfSpace(grid: {grid}, window: 9e-4)")
}

/// Largest difference of what `of` tells of records of the same time, of the largest there is.
pub(super) fn apart(one: &Outcome, other: &Outcome, of: fn(&Record) -> f64) -> f64 {
    let (mut apart, mut largest, mut shared) = (0.0_f64, 0.0_f64, 0);
    for record in &one.records {
        let Some(same) = other.records.iter().find(|same| (same.time - record.time).abs() < 1e-12) else { continue };
        apart = apart.max((of(record) - of(same)).abs());
        largest = largest.max(of(record).abs());
        shared += 1;
    }
    assert!(shared > 3, "{shared} records of the same times");
    if largest > 0.0 { apart / largest } else { 0.0 }
}

fn force(record: &Record) -> f64 {
    record.normal.force
}

/// Ting's problem: pressed, held, half withdrawn. The bed is exact; the pixels err by (Δ/a)²/8 in the force, Δ/a = 1/16,
/// and the steps of the time by what is stated.
#[test]
fn what_remembers_is_that_of_the_bed() {
    let history = "Indent(to: 10e-6, over: 1), Hold(over: 1), Indent(to: 4e-6, over: 1)";
    let bodies = format!("{GEL}, Rigid");
    let bed = ball(&bodies, history, "steps: 10");
    let pixels = ball(&bodies, history, &format!("steps: 10, {}", on_pixels(64)));
    let second = 0.125 * (1.0_f64 / 16.0).powi(2);
    assert!(apart(&bed, &pixels, force) < second + 1e-4, "{}", apart(&bed, &pixels, force));
    // Energies are of the second order too, with twice the constant.
    for of in [|record: &Record| record.normal.stored.stored(), |record: &Record| record.normal.dissipated] {
        assert!(apart(&bed, &pixels, of) < 4.0 * second + 2e-4, "{}", apart(&bed, &pixels, of));
    }
    assert!(pixels.error_estimate.relative > apart(&bed, &pixels, force), "{:?}", pixels.error_estimate);
}

/// Creep under a dead load, from the same bed.
#[test]
fn creep_is_that_of_the_bed() {
    let history = "Press(to: 5e-3, over: 0.5), HoldForce(over: 5)";
    let bodies = format!("Rigid, {GEL}");
    let bed = ball(&bodies, history, "steps: 8");
    let pixels = ball(&bodies, history, &format!("steps: 8, {}", on_pixels(64)));
    let depth = |record: &Record| record.normal.indentation.unwrap_or(0.0);
    assert!(apart(&bed, &pixels, depth) < 5e-4, "{}", apart(&bed, &pixels, depth));
}

/// In full contact of a wave the mean pressure is the load, and the amplitude E*(t)πh/λ, whatever has been: exact.
#[test]
fn a_wave_in_full_contact_relaxes_as_the_body_does() {
    let outcome = outcome(&format!(
        "(shape: HeightMap(\"wave.csv\", 1e-6), bodies: ({GEL}, Rigid), history: [Press(to: 1e-3, over: 1e-9), HoldForce(over: 2)],
          steps: 4, solver: HalfSpace(boundary: Periodic))"
    ));
    let modulus = |t: f64| 4.0 * (0.3e6 + 0.5e6 * (-t / 0.1).exp() + 0.2e6 * (-t / 3.0).exp());
    for record in outcome.records.iter().filter(|record| record.time > 1e-9) {
        let amplitude = record.pixels.unwrap().peak_pressure - 1e-3 / (32e-6_f64 * 32e-6);
        // The ramp of a nanosecond is forgotten but for 1e-8.
        let right = modulus(record.time) * PI * 1e-6 / 32e-6;
        assert!((amplitude / right - 1.0).abs() < 1e-6, "{} {amplitude:e} {right:e}", record.time);
    }
}

/// A term without weight remembers nothing: the elastic states, to the residual of the solver.
#[test]
fn a_term_of_no_weight_changes_nothing() {
    let history = "Indent(to: 10e-6, over: 1), Indent(to: 4e-6, over: 1)";
    let idle = "Viscoelastic(poisson: 0.5, shear: (equilibrium: 0.5e6, terms: [(modulus: 0, time: 0.1)]))";
    let more = format!("steps: 4, {}", on_pixels(32));
    let elastic = ball("Elastic(shear: 0.5e6, poisson: 0.5), Rigid", history, &more);
    let weightless = ball(&format!("{idle}, Rigid"), history, &more);
    for of in [force, |record: &Record| record.normal.stored.elastic, |record: &Record| record.normal.stiffness] {
        assert!(apart(&elastic, &weightless, of) < 1e-6);
    }
    assert!(weightless.records.iter().all(|record| record.normal.dissipated.abs() < 1e-20));
    // An attraction that takes no work to part is none: what it pulls is its stress on the area, 3e-6 of the force.
    let apart_by = |work: f64| {
        let adhesion = format!("adhesion: Maugis(work: {work:e}, stress: 0.1), {more}");
        apart(&elastic, &ball("Elastic(shear: 0.5e6, poisson: 0.5), Rigid", history, &adhesion), force)
    };
    assert!(apart_by(1e-10) < 1e-5, "{}", apart_by(1e-10));
}

/// A history cut in two, or given as a table of the same motion, or with the bodies the other way round, is the same.
#[test]
fn the_way_a_history_is_written_does_not_matter() {
    let more = format!("steps: 6, {}", on_pixels(32));
    let whole = ball(&format!("{GEL}, Rigid"), "Indent(to: 10e-6, over: 1), Indent(to: 4e-6, over: 1)", &more);
    let halves = "Indent(to: 5e-6, over: 0.5), Indent(to: 10e-6, over: 0.5), Indent(to: 4e-6, over: 1)";
    let cut = ball(&format!("{GEL}, Rigid"), halves, &more);
    let swapped = ball(&format!("Rigid, {GEL}"), "Indent(to: 10e-6, over: 1), Indent(to: 4e-6, over: 1)", &more);
    // A record at each row, and as many steps between two of them as the time asks for.
    let table = ball(&format!("{GEL}, Rigid"), "Table(\"motion.csv\")", &on_pixels(32));
    for other in [cut, table] {
        // Both by different steps, each of which leaves 1e-4.
        assert!(apart(&other, &whole, force) < 3e-4, "{}", apart(&other, &whole, force));
    }
    assert!(apart(&whole, &swapped, force) < 1e-15);
}

/// What is done on it is stored or lost: ∫F dd, by the trapezoid, against the elements' own loss.
#[test]
fn the_ledger_of_what_remembers_closes() {
    let history = "Indent(to: 10e-6, over: 1), Hold(over: 0.5), Indent(to: 0, over: 1)";
    let outcome = ball(&format!("{GEL}, Rigid"), history, &format!("steps: 40, {}", on_pixels(32)));
    let mut work = 0.0;
    for pair in outcome.records.windows(2) {
        let [one, two] = [&pair[0].normal, &pair[1].normal];
        work += 0.5 * (one.force + two.force) * (two.indentation.unwrap() - one.indentation.unwrap());
        assert!(two.dissipated >= one.dissipated);
    }
    let last = outcome.records.last().unwrap().normal;
    // The trapezoid of d^{3/2} on forty records: (1/40)^{3/2}/2 and less.
    assert!(((last.stored.stored() + last.dissipated) / work - 1.0).abs() < 2e-3, "{work:e} {last:?}");
}

/// Maugis' contact over his λ, loading: the bed is exact.
#[test]
fn an_attraction_of_finite_range_is_that_of_maugis() {
    let history = "Indent(to: 10e-6, over: 1), Indent(to: -2e-6, over: 1)";
    for stress in [5e3, 20e3, 40e3] {
        let adhesion = format!("adhesion: Maugis(work: 0.05, stress: {stress:e}), steps: 6");
        let bed = ball(&format!("{RUBBER}, Rigid"), history, &adhesion);
        let pixels = ball(&format!("{RUBBER}, Rigid"), history, &format!("{adhesion}, {}", on_pixels(96)));
        let error = apart(&bed, &pixels, force);
        assert!(error < 2.5e-3, "{stress:e}: {error:e}");
        assert!(pixels.warnings.iter().all(|warning| !warning.contains("ring")), "{:?}", pixels.warnings);
    }
}

/// An attraction that ends takes hold of a disc at once when bodies come within its range: its radius is c = 8σ₀R/(πE*), where
/// what σ₀ lifts at its edge, 4σ₀c/(πE*), is c²/2R, and lost is (2/3)σ₀²c³/E*, the work of the stress less what is stored. After
/// that nothing jumps and nothing is lost, and the way the history is written does not matter, however few records.
#[test]
fn a_smooth_way_of_bodies_that_attract_loses_what_their_first_touch_does() {
    let (stress, modulus) = (20e3, 2e6 / 0.75);
    let radius = 8.0 * stress * 5e-3 / (PI * modulus);
    let touch = 2.0 / 3.0 * stress * stress * radius.powi(3) / modulus;
    let lost = |outcome: &Outcome| outcome.records.iter().map(|record| record.normal.dissipated).fold(0.0, f64::max);
    let there = "Indent(to: 10e-6, over: 1), Indent(to: 4e-6, over: 1)";
    let more = |grid: usize| format!("adhesion: Maugis(work: 0.05, stress: 20e3), steps: 4, {}", on_pixels(grid));
    let [whole, finer] = [48, 96].map(|grid| ball(&format!("{RUBBER}, Rigid"), there, &more(grid)));
    let [coarse, fine] = [&whole, &finer].map(|outcome| (lost(outcome) / touch - 1.0).abs());
    assert!(coarse < 0.15 && fine < 0.05 && fine < 0.5 * coarse, "{coarse:e} {fine:e}");
    let halves = "Indent(to: 5e-6, over: 0.5), Indent(to: 10e-6, over: 0.5), Indent(to: 4e-6, over: 1)";
    let ways = [
        ball(&format!("{RUBBER}, Rigid"), halves, &more(48)),
        ball(&format!("{RUBBER}, Rigid"), "Table(\"motion.csv\")", &more(48)),
        ball(&format!("Rigid, {RUBBER}"), there, &more(48)),
    ];
    for way in &ways {
        // The rounds of contact and attraction end at 1e-5 of the stress.
        assert!(apart(way, &whole, force) < 1e-5, "{}", apart(way, &whole, force));
    }
    assert!(ways.iter().all(|way| (lost(way) - lost(&whole)).abs() < 1e-3 * touch));
}

/// JKR, as the range shrinks with the pixels: the force at a depth comes nearer, and so do the pull-off and what its jumps lose,
/// which takes no notice of how many records there are.
#[test]
fn jkr_is_the_limit_of_small_pixels() {
    let error = |grid: usize| {
        let of = |steps: usize| {
            let more = format!("adhesion: Jkr(work: 0.05), steps: {steps}, {}", on_pixels(grid));
            ball(&format!("{RUBBER}, Rigid"), "Indent(to: 8e-6, over: 1), Retract(speed: 1e-5)", &more)
        };
        let (outcome, more) = (of(16), of(40));
        let deepest = outcome.records.iter().find(|record| (record.time - 1.0).abs() < 1e-12).unwrap();
        let bed = ball(
            &format!("{RUBBER}, Rigid"),
            "Indent(to: 8e-6, over: 1), Retract(speed: 1e-5)",
            "adhesion: Jkr(work: 0.05)",
        );
        let there = bed.records.iter().find(|record| (record.time - 1.0).abs() < 1e-12).unwrap();
        let pull_off = 1.5 * PI * 0.05 * 5e-3;
        let losses: Vec<f64> = outcome.records.iter().map(|record| record.normal.dissipated).collect();
        assert!(losses.windows(2).all(|pair| pair[1] >= pair[0]), "{losses:?}");
        let lost = |outcome: &Outcome| outcome.records.last().unwrap().normal.dissipated;
        assert!((lost(&more) / lost(&outcome) - 1.0).abs() < 0.02, "{:e} {:e}", lost(&more), lost(&outcome));
        assert!(outcome.records.last().unwrap().pixels.unwrap().area <= 0.0);
        [
            (force(deepest) / force(there) - 1.0).abs(),
            (-outcome.number("pull_off_force_n").unwrap() / pull_off - 1.0).abs(),
            1.0 - lost(&outcome) / lost(&bed),
        ]
    };
    let (coarse, fine) = (error(32), error(96));
    // On few pixels the force is right by chance: one in a hundred of it is a pixel.
    assert!(coarse[0] < 0.003 && fine[0] < 0.002, "{coarse:?} {fine:?}");
    assert!(fine[1] < 0.03, "{coarse:?} {fine:?}");
    assert!(fine[2] < 0.6 * coarse[2], "{coarse:?} {fine:?}");
}

/// An accuracy of a thousandth asks for less, not for no answer: gap and attraction find each other as they do by default,
/// and are within half a pixel of a finer grid as stated.
#[test]
fn a_coarse_accuracy_is_met_too() {
    let law = "adhesion: Maugis(work: 0.02, stress: 2e4), steps: 4";
    let of =
        |more: &str| ball(&format!("{RUBBER}, {RUBBER}"), "Indent(to: 1e-5, over: 1), Indent(to: 2e-6, over: 1)", more);
    let (coarse, default) =
        (of(&format!("{law}, accuracy: 1e-3, {}", on_pixels(32))), of(&format!("{law}, {}", on_pixels(32))));
    assert!(apart(&coarse, &default, force) < 1e-3);
    let fine = of(&format!("{law}, {}", on_pixels(96)));
    let radius = |record: &Record| record.normal.contact_radius.unwrap_or(0.0);
    assert!(apart(&fine, &coarse, radius) < coarse.error_estimate.relative);
}

/// The range is never shorter than the pixels without a word.
#[test]
fn pixels_too_coarse_for_the_range_are_told() {
    let more = format!("adhesion: Maugis(work: 0.05, stress: 1e6), steps: 2, {}", on_pixels(32));
    let outcome = ball(&format!("{RUBBER}, Rigid"), "Indent(to: 5e-6, over: 1)", &more);
    assert!(outcome.warnings.iter().any(|warning| warning.contains("pixels long")), "{:?}", outcome.warnings);
}

/// A body too hard to yield is elastic; one that yields bears no more than its hardness, keeps its dent, and comes back
/// to where it was when it is loaded again.
#[test]
fn what_yields_keeps_its_dent() {
    let steel = |hardness: f64| format!("Plastic(young: 200e9, poisson: 0.3, hardness: {hardness:e}), Rigid");
    let history = "Press(to: 60, over: 1), Press(to: 0, over: 1), Press(to: 60, over: 1)";
    let pressed = |bodies: &str| {
        outcome(&format!(
            "(shape: Paraboloid(radius: 1e-3), bodies: ({bodies}), history: [{history}], steps: 5, solver: HalfSpace(grid: 64, window: 3e-4))"
        ))
    };
    let (hard, elastic) = (pressed(&steel(1e15)), pressed("Elastic(young: 200e9, poisson: 0.3), Rigid"));
    let depth = |record: &Record| record.normal.indentation.unwrap();
    assert!(apart(&hard, &elastic, depth) < 1e-8 && hard.number("residual_depth_m") == Some(0.0));
    let soft = pressed(&steel(1.6e9));
    let at = |time: f64| *soft.records.iter().find(|record| (record.time - time).abs() < 1e-9).unwrap();
    assert!(soft.records.iter().all(|record| record.pixels.unwrap().peak_pressure <= 1.6e9));
    assert!((depth(&at(3.0)) / depth(&at(1.0)) - 1.0).abs() < 1e-9);
    assert!((at(3.0).normal.dissipated / at(1.0).normal.dissipated - 1.0).abs() < 1e-6);
    // Fully plastic: the area is the force over the hardness, but for its elastic rim.
    let area = at(1.0).pixels.unwrap().area * 1.6e9 / 60.0;
    assert!((0.95..1.05).contains(&area), "{area}");
    assert!(depth(&at(2.0)) > 0.5 * depth(&at(1.0)) && soft.number("residual_depth_m").unwrap() > 0.0);
    // Work done on the way in and out is what has been lost.
    let work: f64 = soft
        .records
        .windows(2)
        .map(|pair| 0.5 * (force(&pair[0]) + force(&pair[1])) * (depth(&pair[1]) - depth(&pair[0])))
        .sum();
    let last = soft.records.last().unwrap().normal;
    assert!(((last.stored.stored() + last.dissipated) / work - 1.0).abs() < 0.03, "{work:e} {last:?}");
}

/// A body that remembers is attracted as Maugis has it where it is slow, and comes back while it is torn off: pressed
/// again after a thousand of its times it has forgotten.
#[test]
fn what_remembers_is_attracted_too() {
    let law = "adhesion: Maugis(work: 0.05, stress: 20e3)";
    let slow = "Viscoelastic(poisson: 0.5, shear: (equilibrium: 0.5e6, terms: [(modulus: 0.2e6, time: 1e-3)]))";
    let elastic = "Elastic(shear: 0.5e6, poisson: 0.5)";
    let steps = format!("{law}, steps: 4, {}", on_pixels(48));
    let history = "Indent(to: 8e-6, over: 1e3), Indent(to: 2e-6, over: 1e3)";
    let [relaxed, right] = [slow, elastic].map(|body| ball(&format!("{body}, Rigid"), history, &steps));
    // The bodies come within reach at once, when the term bears its part; later each step leaves τ/Δt of that, 1e-3/250.
    let later = |record: &Record| if record.time > 0.0 { force(record) } else { 0.0 };
    assert!(apart(&right, &relaxed, later) < 1e-3, "{}", apart(&right, &relaxed, later));
    let torn = "Press(to: 1e-3, over: 1), Press(to: -3e-3, over: 1), HoldForce(over: 10), Press(to: 1e-3, over: 1)";
    let outcome = ball(&format!("{slow}, Rigid"), torn, &steps);
    let at = |time: f64| {
        let record = outcome.records.iter().find(|record| (record.time - time).abs() < 1e-9);
        record.unwrap().normal.indentation.unwrap()
    };
    assert!((at(13.0) / at(1.0) - 1.0).abs() < 2e-2, "{} {}", at(13.0), at(1.0));
}

/// What pixels cannot follow is refused with what would be right.
#[test]
fn edges_that_pixels_do_not_have_are_refused() {
    let refused = |bodies: &str, adhesion: &str| {
        let text = format!(
            "(shape: Paraboloid(radius: 5e-3), bodies: ({bodies}, Rigid), adhesion: {adhesion}, history: [Indent(to: 1e-6, over: 1)], solver: HalfSpace())"
        );
        Notation::Ron.plan(&text, &InMemory::default()).unwrap_err()[0].to_string()
    };
    for (bodies, adhesion) in
        [(GEL, "Jkr(work: 0.05, edge: Relaxed)"), (GEL, "Jkr(work: 0.05)"), (RUBBER, "Jkr(work: 0.05, closing: 0.01)")]
    {
        let said = refused(bodies, adhesion);
        assert!(said.contains("expected Maugis(work"), "{said}");
    }
}

/// A force beyond pull-off tears the bodies apart, who stay so while they are pulled, and are joined by a push.
#[test]
fn a_force_beyond_pull_off_tears_the_bodies_apart() {
    let history = "Press(to: 1e-3, over: 1), Press(to: -2e-3, over: 1), HoldForce(over: 1), Press(to: 1e-3, over: 1)";
    let more = format!("adhesion: Maugis(work: 0.05, stress: 20e3), steps: 3, {}", on_pixels(48));
    let outcome = ball(&format!("{RUBBER}, Rigid"), history, &more);
    let torn = |from: f64, to: f64| {
        let between = outcome.records.iter().filter(move |record| (from..=to).contains(&record.time));
        between.map(|record| record.normal.indentation.is_none()).collect::<Vec<_>>()
    };
    assert!(torn(0.0, 1.5).iter().all(|torn| !torn) && torn(1.99, 3.5).iter().all(|torn| *torn));
    assert!(outcome.records.last().unwrap().normal.indentation.is_some());
    assert!(outcome.warnings.iter().any(|warning| warning.contains("passes pull-off")), "{:?}", outcome.warnings);
}
