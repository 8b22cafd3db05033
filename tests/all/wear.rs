//! Wear through whole scenes.

use springbed::prelude::*;
use springbed::run::record::{FORCE, Outcome, Record, WORN_VOLUME};
use std::fmt::Write;

fn outcome(wear: &str, history: &str, rest: &str) -> Outcome {
    let text = format!(
        r#"(shape: Paraboloid(radius: 1), bodies: (Elastic(young: 0.75, poisson: 0.5), Rigid),
            friction: Coulomb(coefficient: 0.3), {wear} history: [{history}], {rest})"#
    );
    let plan = Notation::Ron.plan(&text, &InMemory::default()).map_err(|problems| problems[0].clone()).unwrap();
    run(&plan, Wanted { fields: true, ..Wanted::NOTHING }).unwrap()
}

fn archard(coefficient: f64) -> String {
    format!("wear: Archard(coefficient: {coefficient:?}),")
}

fn number(outcome: &Outcome, name: &str) -> f64 {
    outcome.number(name).unwrap()
}

const SLIDES: &str = "Press(to: 1, over: 1), Slide(to: 2, over: 1), HoldForce(over: 1), Slide(to: -1, over: 2)";

/// Without a coefficient nothing changes, to the last bit, whatever is done.
#[test]
fn no_coefficient_no_change() {
    let shakes = "Indent(to: 1, over: 1), Shake(amplitude: 0.2, frequency: 1, cycles: 2.3), Retract(speed: 1)";
    for history in [SLIDES, shakes] {
        let (plain, unworn) = (outcome("", history, ""), outcome(&archard(0.0), history, ""));
        let bits = |outcome: &Outcome| {
            let states = outcome.records.iter().fold(String::new(), |mut text, record| {
                let _ = write!(text, "{:?}", Record { worn: None, ..*record });
                text
            });
            (states, outcome.fields.clone(), outcome.warnings.clone(), outcome.error_estimate.clone())
        };
        assert_eq!(bits(&plain), bits(&unworn));
        assert_eq!(number(&unworn, "worn_volume_m3").to_bits(), 0);
        assert!(plain.number("worn_volume_m3").is_none());
    }
}

/// Up to the first slide the scene is that without wear, to the last bit.
#[test]
fn before_the_first_slide_nothing_is_different() {
    let history = "Press(to: 1, over: 1), Indent(to: 1, over: 1), Slide(to: 2, over: 1)";
    let (plain, worn) = (outcome("", history, ""), outcome(&archard(0.1), history, ""));
    let until = |outcome: &Outcome| {
        let before = outcome.records.iter().filter(|record| record.entry < 2);
        before.map(|record| (record.normal, record.tangential, record.time)).collect::<Vec<_>>()
    };
    assert_eq!(until(&plain), until(&worn));
    assert_eq!(worn.records.iter().filter(|record| record.entry == 2).count(), 100);
}

/// V = k_w∫F ds, over ways to and fro and under another force.
#[test]
fn volume_adds_up_over_a_history() {
    let history = format!("{SLIDES}, Press(to: 0.3, over: 1), Slide(to: 4, over: 1)");
    let worn = outcome(&archard(0.02), &history, "");
    let right = 0.02 * (2.0 + 3.0 + 0.3 * 5.0);
    assert!((number(&worn, "worn_volume_m3") / right - 1.0).abs() < 1e-11);
    let volumes: Vec<f64> = worn.records.iter().filter_map(|record| (WORN_VOLUME.of)(record)).collect();
    assert!(volumes.windows(2).all(|pair| pair[1] >= pair[0]) && volumes.len() == worn.records.len());
    // All of it slips: F_x = μF to rounding. The work of F_x is lost, or stored in the springs it bends.
    let last = worn.records.last().unwrap().tangential.unwrap();
    assert!((last.force - 0.09).abs() < 1e-12);
    let lost = number(&worn, "friction_dissipated_j");
    let states: Vec<_> = worn.records.iter().filter_map(|record| record.tangential).collect();
    let work: f64 =
        states.windows(2).map(|pair| 0.5 * (pair[0].force + pair[1].force) * (pair[1].slide - pair[0].slide)).sum();
    assert!((lost + last.stored.unwrap()) / work - 1.0 < 0.02, "{lost} {work}");
    assert!(1.0 - (lost + last.stored.unwrap()) / work < 0.02, "{lost} {work}");
}

/// Records, and looks at fields, change nothing but what is shown.
#[test]
fn records_do_not_change_the_answer() {
    for history in [SLIDES, "Indent(to: 1, over: 1), Shake(amplitude: 0.2, frequency: 1, cycles: 7)"] {
        let (one, other) = (outcome(&archard(0.1), history, "steps: 3"), outcome(&archard(0.1), history, "steps: 41"));
        let (one, other) = (one.records.last().unwrap(), other.records.last().unwrap());
        assert_eq!((one.normal, one.tangential, one.worn), (other.normal, other.tangential, other.worn));
    }
}

/// An entry cut in two changes nothing beyond the error stated.
#[test]
fn an_entry_cut_in_two() {
    let whole = outcome(&archard(0.3), "Indent(to: 1, over: 1), Slide(to: 4, over: 4)", "");
    let cut = outcome(&archard(0.3), "Indent(to: 1, over: 1), Slide(to: 1, over: 1), Slide(to: 4, over: 3)", "");
    let bound = whole.error_estimate.relative;
    for name in ["final_force_n", "worn_volume_m3", "wear_depth_m", "final_contact_radius_m"] {
        assert!((number(&whole, name) / number(&cut, name) - 1.0).abs() < bound, "{name}");
    }
    assert!(bound < 0.05);
}

/// The error stated bounds what a four times finer bed changes.
#[test]
fn the_error_is_stated() {
    let of = |accuracy: &str| outcome(&archard(0.3), "Press(to: 1, over: 1), Slide(to: 4, over: 4)", accuracy);
    let (coarse, fine) = (of("accuracy: 1e-5"), of("accuracy: 1.6e-7"));
    for name in ["final_indentation_m", "wear_depth_m", "final_contact_radius_m"] {
        let off = (number(&coarse, name) / number(&fine, name) - 1.0).abs();
        assert!(off < coarse.error_estimate.relative, "{name} {off:e}");
    }
}

/// 10⁵ strokes end in the limiting shape: 0.883883 of the force, springs outside c that carry nothing.
#[test]
fn fretting_to_the_end() {
    let history = "Indent(to: 1, over: 1), Shake(amplitude: 0.225, frequency: 1, cycles: 100000)";
    let worn = outcome(&archard(0.1), history, "");
    let left = number(&worn, "final_force_n") / number(&worn, "largest_force_n");
    assert!((left - 0.883_883_476_483_184_4).abs() < 1e-5, "{left}");
    assert!((number(&worn, "final_stick_radius_m") - 0.5f64.sqrt()).abs() < 0.01);
    assert!(worn.records.len() < 500 && worn.table("profiles").is_some());
    let forces: Vec<f64> =
        worn.records.iter().filter(|record| record.entry == 1).filter_map(|record| (FORCE.of)(record)).collect();
    // It falls, to the error of the steps.
    assert!(forces.windows(2).all(|pair| pair[1] <= pair[0] * (1.0 + 1e-5)));
}

/// What is pressed down after wear comes up again as elastic bodies do, and parts.
#[test]
fn worn_bodies_part() {
    let history = "Indent(to: 1, over: 1), Slide(to: 3, over: 1), Retract(speed: 1)";
    let worn = outcome(&archard(0.2), history, "");
    let last = worn.records.last().unwrap();
    assert!(last.normal.force.abs() < 1e-12 && last.normal.indentation.unwrap() > 0.0);
    // The ledger: the work done is stored or was worn off with the pressure on it.
    let work = worn.records.windows(2).filter_map(|pair| {
        let depth = |record: &Record| record.normal.indentation;
        Some(0.5 * (pair[0].normal.force + pair[1].normal.force) * (depth(&pair[1])? - depth(&pair[0])?))
    });
    let (work, told) = (work.sum::<f64>(), number(&worn, "work_j"));
    assert!((work / told - 1.0).abs() < 2e-3, "{work} {told}");
}

/// A ball known by a table of its heights wears as the ball does.
#[test]
fn a_measured_ball_wears_as_a_ball() {
    let rows: Vec<f64> = (0..=80).map(|k| 0.05 * f64::from(k)).collect();
    let heights: Vec<f64> = rows.iter().map(|r| 0.5 * r * r).collect();
    let tables = InMemory::default().with("ball.csv", &[("radius_m", &rows), ("height_m", &heights)]);
    let of = |shape: &str| {
        let text = format!(
            "(shape: {shape}, bodies: (Elastic(young: 0.75, poisson: 0.5), Rigid), friction: Coulomb(coefficient: 0.3), \
            {} history: [Press(to: 1, over: 1), Slide(to: 2, over: 1)])",
            archard(0.2)
        );
        let plan = Notation::Ron.plan(&text, &tables).map_err(|problems| problems[0].clone()).unwrap();
        run(&plan, Wanted::NOTHING).unwrap()
    };
    let (measured, ball) = (of("Table(\"ball.csv\")"), of("Paraboloid(radius: 1)"));
    assert!((number(&measured, "worn_volume_m3") / 0.4 - 1.0).abs() < 1e-12);
    let depth = |outcome: &Outcome| outcome.records.last().unwrap().worn.unwrap().depth;
    assert!((depth(&measured) / depth(&ball) - 1.0).abs() < 1e-3, "{} {}", depth(&measured), depth(&ball));
}
