//! What jumps of contacts on pixels lose, and what the steps of their histories leave: the same whatever the steps are.

use springbed::prelude::*;
use springbed::run::record::Outcome;

fn outcome(shape: &str, bodies: &str, rest: &str) -> Outcome {
    let text = format!("(shape: {shape}, bodies: ({bodies}), solver: HalfSpace(grid: 32), {rest})");
    let plan = Notation::Ron.plan(&text, &InMemory::default()).unwrap_or_else(|errors| panic!("{}", errors[0]));
    run(&plan, Wanted::NOTHING).unwrap_or_else(|error| panic!("{error}"))
}

/// Thirty-two points of a line that repeats after the length `length` [m], of the deviation `rms` [m].
fn line(rms: f64, length: f64) -> String {
    let (long, short) = (length, 0.2 * length);
    format!(
        "RoughLine(spectrum: SelfAffine(hurst: 0.8, rms: {rms:e}, long: {long:e}, short: {short:e}), length: {length:e}, points: 32)"
    )
}

fn lost(outcome: &Outcome) -> f64 {
    outcome.number("dissipated_j").unwrap()
}

/// What is lost in every one of these numbers of records is within a part `part` of the first.
fn loses_the_same(steps: &[u32], part: f64, with: impl Fn(u32) -> Outcome) {
    let lost: Vec<f64> = steps.iter().map(|&steps| lost(&with(steps))).collect();
    assert!(lost.iter().all(|other| (other / lost[0] - 1.0).abs() < part), "{lost:?}");
}

/// A force that is led from where bodies draw each other in lets them jump at once: the force is at no time beyond the ends
/// of the step, however far they go.
#[test]
fn bodies_jump_under_a_force_in_any_steps() {
    let half = "Elastic(young: 6.3e7, poisson: 0.5)";
    let history = "history: [Press(to: 1e-4, over: 1e-6), Indent(to: 1.1e-8, over: 1e-6)], accuracy: 1e-3";
    loses_the_same(&[4, 64], 3e-3, |steps| {
        let rest = format!("adhesion: Exponential(work: 0.1125, range: 1.78e-7), {history}, steps: {steps}");
        outcome(&line(2.8e-7, 5.62e-5), &format!("{half}, {half}"), &rest)
    });
}

/// A range far below a pixel and what it is displaced by: the pull is a small part of the stress, and comes to rest beside
/// itself, not beside the stress.
#[test]
fn small_pulls_are_found_too() {
    let history = "history: [Indent(to: -2.2e-5, over: 1e-3)], accuracy: 1e-3, steps: 4";
    let rest = format!("adhesion: Maugis(work: 112, stress: 6.32e9), {history}");
    let drawn = outcome(&line(5e-5, 1e-2), "Elastic(young: 6.32e10, poisson: 0.5), Rigid", &rest);
    let stored = -drawn.records[0].normal.stored.stored();
    assert!(stored > 0.0 && lost(&drawn) < 1e-3 * stored, "{:e} of {stored:e}", lost(&drawn));
}

/// Edges that are held from pixel to pixel and let go one after the other, by a ball drawn off a layer, in steps far longer
/// than the range of what attracts.
#[test]
fn a_ball_is_drawn_off_in_any_steps() {
    let body = "Elastic(young: 3.5565588200778455e8, poisson: 0.5)";
    let layered = format!("Layered(layers: [(body: {body}, thickness: 3.162277660168379e-2)], base: Rigid), {body}");
    let maugis = "adhesion: Maugis(work: 6.324555320336759e-4, stress: 6.324555320336758e5)";
    loses_the_same(&[4, 8, 16], 1e-3, |steps| {
        let rest =
            format!("{maugis}, history: [Indent(to: -3.1622776601683795e-5, over: 1)], accuracy: 1e-3, steps: {steps}");
        outcome("Paraboloid(radius: 1.5811388300841897e-1)", &layered, &rest)
    });
    loses_the_same(&[4, 8], 1e-3, |steps| {
        let rest = format!("history: [Indent(to: -4e-10, over: 1)], accuracy: 1e-3, steps: {steps}");
        let body = "Elastic(young: 6.324555320336758e7, poisson: 0.5), Rigid";
        outcome("Paraboloid(radius: 5e-7)", body, &format!("adhesion: Jkr(work: 3.5565588200778452e-9), {rest}"))
    });
}

/// Where slopes before a step and in it agree by chance, what the trapezoid finds too little tells as much as what it finds
/// too much.
#[test]
fn a_way_that_turns_among_jumps_loses_the_same() {
    let shape = line(8.891397050194613e-11, 1.7782794100389228e-8);
    loses_the_same(&[4, 8], 5e-3, |steps| {
        let history = "history: [Indent(to: 1.7782794100389226e-10, over: 3e-3), Retract(speed: 1e-7)]";
        let rest = format!("{history}, accuracy: 1e-3, steps: {steps}");
        let pull = "adhesion: Exponential(work: 1.9999999999999998e-4, range: 1.7782794100389226e-12)";
        outcome(&shape, "Elastic(young: 1687023975.5710468, poisson: 0.5), Rigid", &format!("{pull}, {rest}"))
    });
}

/// On a surface that repeats, what pulls in one place lifts the others, and two patches that a long step would join at once
/// join one after the other: bodies that remember next to nothing, which are led by the short steps, lose the same.
#[test]
fn patches_of_what_repeats_join_one_after_the_other() {
    let shape = line(1.5811388300841896e-8, 3.162277660168379e-6);
    let rest = "adhesion: Capillary(tension: 1e-5, angle: 0, kelvin_radius: 1.5811388300841896e-9), \
                history: [Indent(to: -2e-10, over: 5)], accuracy: 1e-3, steps: 4";
    let relaxing =
        "Viscoelastic(poisson: 0.5, shear: (equilibrium: 56234.13251903491, terms: [(modulus: 5.6e-6, time: 1)]))";
    let elastic = "Elastic(young: 168702.39755710473, poisson: 0.5)";
    let [one, other] = [relaxing, elastic].map(|body| {
        lost(&outcome(&shape, &format!("{body}, Elastic(young: 1.1246826503806982e5, poisson: 0.5)"), rest))
    });
    assert!((one / other - 1.0).abs() < 1e-6, "{one:e} {other:e}");
}

/// Where a step goes on as the last one did the dashpots follow the rate at its end: four times the steps leave a sixteenth.
#[test]
fn a_dashpot_is_followed_to_the_second_order() {
    let body =
        "Viscoelastic(poisson: 0.5, shear: (equilibrium: 1e6, terms: [(modulus: 2e6, time: 1)], viscosity: 3e6))";
    let depth = |steps: u32| {
        let history = "history: [Press(to: 1e-3, over: 1), Press(to: 1e-4, over: 10)], accuracy: 0.1";
        let rest = format!("{history}, steps: {steps}");
        let pressed = outcome("Paraboloid(radius: 5e-3)", &format!("{body}, Rigid"), &rest);
        pressed.records.last().and_then(|record| record.normal.indentation).unwrap()
    };
    let [coarse, fine, exact] = [16, 64, 512].map(depth);
    let [one, other] = [coarse, fine].map(|depth| (depth / exact - 1.0).abs());
    assert!(other < one / 8.0 && other < 5e-4, "{one:e} {other:e}");
}

/// What the steps leave of the energies lost is told, of a hold on bodies that relax within a small part of it.
#[test]
fn what_the_steps_leave_is_told() {
    let body = "Viscoelastic(poisson: 0.5, shear: (equilibrium: 1.78e6, terms: [(modulus: 1e7, time: 0.3)])), Rigid";
    let capillary = "adhesion: Capillary(tension: 1e-3, angle: 0, kelvin_radius: 2.8e-8)";
    let held = |steps: u32| {
        let rest = format!("{capillary}, history: [Hold(over: 100)], accuracy: 1e-3, steps: {steps}");
        outcome("Paraboloid(radius: 5e-3)", body, &rest)
    };
    let [coarse, fine] = [2, 64].map(held);
    let energy = fine.records.iter().map(|record| record.normal.stored.stored().abs()).fold(0.0, f64::max);
    let told = coarse.number("error_of_steps").unwrap();
    let off = (lost(&coarse) - lost(&fine)).abs() / energy;
    assert!(off <= told && told < 5e-2, "{off:e} {told:e}");
}

/// Records at touch are led by the depth, whatever leads the rest: a peak between the pixels tells there too.
#[test]
fn touch_between_pixels_is_told_of_bodies_that_attract() {
    let rest = "adhesion: Exponential(work: 1.12, range: 5.62e-7), accuracy: 1e-3, steps: 4, \
                history: [Press(to: -5.6e-4, over: 3e-4), Press(to: 0, over: 3e-5)]";
    let told = outcome(&line(5e-7, 1e-4), "Winkler(modulus: 3.16e8, thickness: 5e-5), Rigid", rest).error_estimate;
    assert!(told.basis.contains("of the largest force"), "{}", told.basis);
}
