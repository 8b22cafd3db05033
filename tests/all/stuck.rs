//! An adhesive contact that sticks everywhere, in scenes: where its edge gives way, energies, the way back, depth beside force.

use proptest::prelude::*;
use springbed::input::table::InMemory;
use springbed::run::curves::between::filled;
use springbed::run::record::{Outcome, Record};
use springbed::run::{self, Wanted};
use springbed::text::Notation;
use std::f64::consts::PI;

/// E* = 4/3, α = G*/E* = 2/3 of an incompressible body on a rigid one; w = 0.05.
const MODULUS: f64 = 4.0 / 3.0;
const RATIO: f64 = 2.0 / 3.0;
const WORK: f64 = 0.05;
const SHAPES: [&str; 5] = [
    "Paraboloid(radius: 1)",
    "Cone(slope: 0.6)",
    "Power(coefficient: 0.5, exponent: 3)",
    "FlatPunch(radius: 0.7)",
    "TruncatedParaboloid(flat_radius: 0.3, radius: 1)",
];

fn outcome(shape: &str, steps: u32, history: &str) -> Outcome {
    let text = format!(
        "(shape: {shape}, bodies: (Elastic(young: 1, poisson: 0.5), Rigid), adhesion: Jkr(work: 0.05), friction: Stuck, steps: {steps}, history: [{history}])"
    );
    let plan = Notation::Ron.plan(&text, &InMemory::default()).unwrap_or_else(|errors| panic!("{errors:#?}"));
    run::run(&plan, Wanted::NOTHING).unwrap()
}

fn last(outcome: &Outcome) -> Record {
    *outcome.records.last().unwrap()
}

fn number(outcome: &Outcome, name: &str) -> f64 {
    outcome.number(name).unwrap_or_else(|| panic!("no {name}: {:?}", outcome.results))
}

fn kept(record: &Record) -> f64 {
    let tangential = record.tangential.unwrap();
    record.normal.stored.stored()
        + record.normal.dissipated
        + tangential.stored.unwrap()
        + tangential.dissipated.unwrap()
}

/// Where the edge gives way is told, whatever the records: as it is about to, under more than any other, and afterwards, with
/// what was lost between.
#[test]
fn the_edge_is_told_as_it_gives_way() {
    for (led, deep) in [("Indent", 0.1), ("Press", 0.3)] {
        let text = format!(
            "(shape: {}, bodies: (Elastic(young: 1, poisson: 0.5), Rigid), adhesion: Jkr(work: 0.05), friction: Stuck, steps: 3, history: [{led}(to: {deep}, over: 1), Slide(to: -7, over: 1)])",
            SHAPES[0]
        );
        let plan = Notation::Ron.plan(&text, &InMemory::default()).unwrap();
        let told = run::run(&plan, Wanted { instants: true, ..Wanted::NOTHING }).unwrap().records;
        let slid: Vec<(&Record, f64)> = told
            .iter()
            .filter(|record| record.entry == 1)
            .map(|record| (record, record.tangential_force().unwrap()))
            .collect();
        let at = slid.windows(2).position(|pair| (pair[0].0.time - pair[1].0.time).abs() <= 0.0).unwrap();
        let [(before, most), (after, left)] = [slid[at], slid[at + 1]];
        assert!(slid.iter().all(|&(_, force)| most <= force) && most < 0.0 && left.abs() <= 0.0, "{slid:?}");
        let slides = [before, after].map(|record| record.tangential.unwrap().slide);
        assert!(
            (slides[0] - slides[1]).abs() <= 0.0 && (slides[0] / -7.0 - (before.time - 1.0)).abs() < 1e-12,
            "{slides:?}"
        );
        // Beyond rounding what is stored and lost is the same; under a force the weight gives of itself.
        let sunk = after.normal.indentation.unwrap() - before.normal.indentation.unwrap();
        let given = if led == "Press" { deep * sunk } else { 0.0 };
        assert!((kept(after) - kept(before) - given).abs() < 1e-12 * kept(after), "{led}: {before:?} {after:?}");
        assert!(after.tangential.unwrap().dissipated > before.tangential.unwrap().dissipated);
    }
}

/// A figure puts states of the contact at rest only between records of it: none of an edge that shear has pulled in.
#[test]
fn nothing_at_rest_is_drawn_of_an_edge_pulled_in() {
    let text = format!(
        "(shape: {}, bodies: (Elastic(young: 1, poisson: 0.5), Rigid), adhesion: Jkr(work: 0.05), friction: Stuck, steps: 4, history: [Press(to: 0.3, over: 1), Slide(to: -7, over: 1)])",
        SHAPES[0]
    );
    let plan = Notation::Ron.plan(&text, &InMemory::default()).unwrap();
    let told = run::run(&plan, Wanted { instants: true, ..Wanted::NOTHING }).unwrap().records;
    let (pressed, slid): (Vec<Record>, Vec<Record>) = told.into_iter().partition(|record| record.entry == 0);
    assert!(filled(&plan, &pressed).len() > 2 * pressed.len());
    let ends = |records: &[Record]| {
        let depths = records.iter().filter_map(|record| record.normal.indentation);
        depths.fold((f64::INFINITY, 0.0), |(least, most): (f64, f64), depth| (least.min(depth), most.max(depth)))
    };
    assert_eq!(ends(&filled(&plan, &slid)), ends(&slid), "{slid:?}");
}

/// At d = 0 X = 2πaw/E* − a⁴/R² is greatest at a³ = πwR²/2E*, where αu² = (3/2)πaw/E*.
#[test]
fn a_ball_at_no_depth_gives_way_where_theory_says() {
    let run = outcome(SHAPES[0], 4, "Indent(to: 1, over: 1), Indent(to: 0, over: 1), Slide(to: 0.01, over: 1)");
    let a = (0.5 * PI * WORK / MODULUS).cbrt();
    let slide = (1.5 * PI * a * WORK / MODULUS / RATIO).sqrt();
    assert!((number(&run, "peel_radius_m") / a - 1.0).abs() < 1e-7);
    assert!((number(&run, "peel_slide_m") / slide - 1.0).abs() < 1e-12);
    assert!((number(&run, "peel_force_n") / (2.0 * RATIO * MODULUS * a * slide) - 1.0).abs() < 1e-7);
}

proptest! {
    #![proptest_config(crate::laws::cases(48))]

    /// Work along the surface is stored, and where the edge gives way what was stored beyond the contact without adhesion is lost.
    #[test]
    fn energies_add_up(shape in 0usize..5, by_force in 0u8..2, load in 2i32..20, part in 5i32..30) {
        let load = f64::from(load) / 20.0;
        let lead = if by_force > 0 { "Press" } else { "Indent" };
        let begin = format!("{lead}(to: {load:e}, over: 1)");
        let limit = number(&outcome(SHAPES[shape], 2, &format!("{begin}, Slide(to: 1e-6, over: 1)")), "peel_slide_m");
        let to = f64::from(part) / 20.0 * limit;
        let steps = 4000;
        let run = outcome(SHAPES[shape], steps, &format!("{begin}, Slide(to: {to:e}, over: 1)"));
        let slid: Vec<Record> = run.records.iter().filter(|record| record.entry == 1).copied().collect();
        let start = run.records.iter().rfind(|record| record.entry == 0).unwrap();
        let (mut before, mut paid, mut gone) = (*start, 0.0, false);
        for record in &slid {
            let (one, two) = (before.tangential.unwrap(), record.tangential.unwrap());
            let lost = two.dissipated.unwrap() - one.dissipated.unwrap();
            prop_assert!(lost >= 0.0);
            if lost > 0.0 {
                // Up to the limit it has gone on as before.
                prop_assert!(!gone && part >= 20);
                let force = number(&run, "peel_force_n");
                paid += 0.5 * (one.force + force) * (limit - one.slide);
                gone = true;
            } else {
                paid += 0.5 * (one.force + two.force) * (two.slide - one.slide);
            }
            if by_force > 0 {
                paid += load * (record.normal.indentation.unwrap() - before.normal.indentation.unwrap());
            }
            before = *record;
        }
        prop_assert_eq!(gone, part > 20);
        let scale = paid.abs().max(kept(&before).abs());
        // Trapezia of 4000 steps, of a curve with a root at its end.
        prop_assert!((kept(&before) - kept(start) - paid).abs() < 1e-4 * scale, "{} {paid}", kept(&before) - kept(start));
    }

    /// Below the limit the way does not matter: cut, shaken, forth and back, under depth or force.
    #[test]
    fn below_the_limit_the_way_does_not_matter(shape in 0usize..5, load in 2i32..20, part in 1i32..19) {
        let load = f64::from(load) / 20.0;
        let begin = format!("Press(to: {load:e}, over: 1)");
        let limit = number(&outcome(SHAPES[shape], 2, &format!("{begin}, Slide(to: 1e-6, over: 1)")), "peel_slide_m");
        let to = f64::from(part) / 20.0 * limit;
        let once = last(&outcome(SHAPES[shape], 1, &format!("{begin}, Slide(to: {to:e}, over: 1)")));
        let forth = last(&outcome(
            SHAPES[shape],
            2,
            &format!("{begin}, Slide(to: {:e}, over: 1), Slide(to: {:e}, over: 2), Slide(to: {to:e}, over: 1)", 0.7 * to, -0.9 * to),
        ));
        let (one, other) = (once.tangential.unwrap(), forth.tangential.unwrap());
        prop_assert!((one.force / other.force - 1.0).abs() < 1e-12);
        prop_assert!(other.dissipated.unwrap().abs() <= 0.0);
        // Swapped bodies are the same pair; at the depth of this one the force is that of this one.
        let depth = once.normal.indentation.unwrap();
        let rest = outcome(SHAPES[shape], 1, &begin);
        let deep = format!("Indent(to: {:e}, over: 1)", last(&rest).normal.indentation.unwrap());
        prop_assert!(depth <= last(&rest).normal.indentation.unwrap() + 1e-15);
        let limit = number(&outcome(SHAPES[shape], 2, &format!("{deep}, Slide(to: 1e-6, over: 1)")), "peel_slide_m");
        let small = last(&outcome(SHAPES[shape], 1, &format!("{deep}, Slide(to: {:e}, over: 1)", 1e-3 * limit)));
        let a = last(&rest).normal.contact_radius.unwrap();
        // To first order the contact sticks with 2G*a.
        let right = 2.0 * RATIO * MODULUS * a * 1e-3 * limit;
        prop_assert!((small.tangential.unwrap().force / right - 1.0).abs() < 1e-4);
    }
}

/// Beyond the limit the contact without adhesion is left and slides freely.
#[test]
fn what_is_left_is_the_contact_without_adhesion() {
    let run = outcome(SHAPES[0], 4, "Press(to: 0.5, over: 1), Slide(to: 3, over: 1)");
    let end = last(&run);
    let hertz = (0.75 * 0.5 / MODULUS).cbrt();
    assert!((end.normal.contact_radius.unwrap() / hertz - 1.0).abs() < 1e-12);
    assert!((end.normal.force / 0.5 - 1.0).abs() < 1e-12 && end.tangential.unwrap().force.abs() <= 0.0);
    assert!(end.tangential.unwrap().dissipated.unwrap() > 0.0);
}
