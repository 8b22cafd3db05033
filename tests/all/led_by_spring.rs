//! A contact led by the far end of a spring, in scenes: the instability of an adhesive contact, the limits of a prescribed
//! depth and force, cuts, tables, and the balance of energies.

use proptest::prelude::*;
use springbed::input::table::InMemory;
use springbed::run::record::{Outcome, Record};
use springbed::run::{self, Wanted};
use springbed::text::Notation;
use std::f64::consts::PI;

/// E* = 2 MPa/0.75, R = 10 mm, w = 50 mJ/m².
const MODULUS: f64 = 2e6 / 0.75;
const RADIUS: f64 = 1e-2;
const WORK: f64 = 0.05;
const JKR: &str = "adhesion: Jkr(work: 0.05),";
const SHAPES: [(&str, &str); 5] = [
    ("Paraboloid(radius: 1e-2)", JKR),
    ("Cone(slope: 0.05)", JKR),
    ("WavyParaboloid(radius: 1e-2, amplitude: 2e-7, wavelength: 1e-4)", JKR),
    ("TruncatedParaboloid(flat_radius: 1e-4, radius: 1e-2)", JKR),
    ("Paraboloid(radius: 1e-2)", "adhesion: Maugis(work: 0.05, stress: 2e4),"),
];

fn outcome((shape, adhesion): (&str, &str), (machine, steps): (&str, u32), history: &str) -> Outcome {
    let text = format!(
        "(shape: {shape}, bodies: (Elastic(young: 2e6, poisson: 0.5), Rigid), {adhesion} {machine} steps: {steps}, history: [{history}])"
    );
    run_with(&text, &InMemory::default())
}

fn run_with(text: &str, tables: &InMemory) -> Outcome {
    let plan = Notation::Ron.plan(text, tables).unwrap_or_else(|errors| panic!("{errors:#?}"));
    run::run(&plan, Wanted::NOTHING).unwrap()
}

fn spring(stiffness: f64) -> String {
    format!("machine: (stiffness: {stiffness:e}),")
}

/// The records on both sides of the last jump.
fn parting(outcome: &Outcome) -> (Record, Record) {
    let records = &outcome.records;
    let last =
        records.windows(2).rfind(|pair| pair[1].normal.contact_radius == Some(0.0) && pair[0].normal.force < 0.0);
    let pair = last.unwrap_or_else(|| panic!("{records:#?}"));
    (pair[0], pair[1])
}

/// dF/dd of JKR's ball at the contact radius a.
fn stiffness_of_contact(a: f64) -> f64 {
    let stretch = (2.0 * PI * a * WORK / MODULUS).sqrt();
    let force = 4.0 * MODULUS * a * a / RADIUS - 3.0 * MODULUS * stretch;
    force / (2.0 * a / RADIUS - 0.5 * stretch / a)
}

proptest! {
    #![proptest_config(crate::laws::cases(64))]

    /// The ball parts where the contact falls by as much as the spring takes, between the pull-offs of a depth and of a force.
    #[test]
    fn a_ball_jumps_off_where_its_stiffness_is_that_of_the_spring(decade in -100i32..200) {
        let stiffness = 10f64.powf(0.02 * f64::from(decade));
        let run = outcome(SHAPES[0], (&spring(stiffness), 5), "Press(to: 1e-3, over: 1), Retract(speed: 1e-6)");
        let (last, after) = parting(&run);
        let (a, force) = (last.normal.contact_radius.unwrap(), last.normal.force);
        // The radius at a turning point is known to the root of rounding.
        prop_assert!((stiffness_of_contact(a) / -stiffness - 1.0).abs() < 1e-5, "{}", stiffness_of_contact(a));
        let unit = PI * WORK * RADIUS;
        prop_assert!(force >= -1.5 * unit * (1.0 + 1e-12) && force <= -5.0 / 6.0 * unit * (1.0 - 1e-12));
        // All that was stored is lost, the spring's share with it.
        let lost = after.normal.dissipated - last.normal.dissipated;
        prop_assert!((lost - last.normal.stored.stored()).abs() < 1e-12 * lost.abs());
        // The far end goes on through the jump.
        let (from, to) = (last.spring.unwrap().0, after.spring.unwrap().0);
        prop_assert!((from - to).abs() < 1e-11 * (from.abs() + force.abs() / stiffness));
    }

    /// A cut, a rest or a table of the same motion change nothing.
    #[test]
    fn a_cut_changes_nothing(shape in 0usize..5, decade in 0i32..4, part in 1i32..100, soft in 1i32..20) {
        let (of, stiffness) = (SHAPES[shape], 10f64.powi(decade));
        // Far enough for each stiffness to join, press and part.
        let way = 1e-5 + 4e-4 * f64::from(soft) / stiffness / 4.0;
        let at = f64::from(part) / 100.0;
        let machine = spring(stiffness);
        let whole = outcome(of, (&machine, 1), &format!("Indent(to: {way:e}, over: 1), Indent(to: {:e}, over: 2)", -2.0 * way));
        let (one, two) = (at * way, way - 3.0 * at * way);
        let cut = outcome(
            of,
            (&machine, 1),
            &format!(
                "Indent(to: {one:e}, over: {at:e}), Hold(over: 1), Indent(to: {way:e}, over: {:e}), Indent(to: {two:e}, over: {:e}), Indent(to: {:e}, over: {:e})",
                1.0 - at, 2.0 * at, -2.0 * way, 2.0 - 2.0 * at
            ),
        );
        let tables = InMemory::default().with(
            "rows.csv",
            &[("time_s", &[0.0, at, 1.0, 1.0 + 2.0 * at, 3.0]), ("indentation_m", &[0.0, one, way, two, -2.0 * way])],
        );
        let (shape, adhesion) = of;
        let rows = run_with(
            &format!("(shape: {shape}, bodies: (Elastic(young: 2e6, poisson: 0.5), Rigid), {adhesion} {machine} history: [Table(\"rows.csv\")])"),
            &tables,
        );
        let last = |outcome: &Outcome| outcome.records.last().unwrap().normal;
        let scale = whole.records.iter().map(|record| record.normal.force.abs()).fold(0.0, f64::max);
        let energy = last(&whole).dissipated.abs().max(last(&whole).stored.stored().abs());
        for other in [&cut, &rows] {
            let (one, other) = (last(&whole), last(other));
            prop_assert!((one.force - other.force).abs() < 1e-9 * scale, "{one:?} {other:?}");
            prop_assert!((one.dissipated - other.dissipated).abs() < 1e-7 * energy, "{one:?} {other:?}");
        }
    }

    /// ∫F dz is what is stored, the spring's share included, and what is lost in jumps, which grows.
    #[test]
    fn the_far_end_pays_for_all(shape in 0usize..5, decade in 0i32..4) {
        let (stiffness, steps) = (10f64.powi(decade), 2000);
        let way = 2e-5 + 3e-3 / stiffness;
        let run = outcome(
            SHAPES[shape],
            (&spring(stiffness), steps),
            &format!("Indent(to: {way:e}, over: 1), Indent(to: {:e}, over: 2)", -2.0 * way),
        );
        let (mut paid, mut worst, mut scale) = (0.0, 0.0f64, f64::MIN_POSITIVE);
        for pair in run.records.windows(2) {
            let [from, to] = [&pair[0], &pair[1]].map(|record| record.spring.unwrap().0);
            paid += 0.5 * (pair[0].normal.force + pair[1].normal.force) * (to - from);
            let kept = |record: &Record| record.normal.stored.stored() + record.normal.dissipated;
            worst = worst.max((paid - kept(&pair[1]) + kept(&run.records[0])).abs());
            scale = scale.max(kept(&pair[1]).abs());
            prop_assert!(pair[1].normal.dissipated >= pair[0].normal.dissipated);
        }
        // Trapezia over 2000 records a way, with a root where a branch ends.
        prop_assert!(worst < 2e-3 * scale, "{worst:e} of {scale:e}");
        prop_assert!(run.records.last().unwrap().normal.dissipated > 0.0);
    }
}

/// Over layers too an entry goes on from where the far end of the spring is, not from where the indenter is.
#[test]
fn over_layers_a_cut_changes_nothing() {
    let run = |history: &str| {
        let layer = "(body: Elastic(young: 1e3, poisson: 0.45), thickness: 5e-6)";
        run_with(
            &format!(
                "(shape: Paraboloid(radius: 5e-6), bodies: (Layered(layers: [{layer}], base: Rigid, bond: Bonded), Rigid), \
                 machine: (stiffness: 2e-3), steps: 2, history: [{history}])"
            ),
            &InMemory::default(),
        )
    };
    let last = |outcome: &Outcome| outcome.records.last().unwrap().normal;
    let (whole, cut) = (run("Indent(to: 4e-6, over: 2)"), run("Indent(to: 2e-6, over: 1), Indent(to: 4e-6, over: 1)"));
    let (one, other) = (last(&whole), last(&cut));
    let (depth, told) = (one.indentation.unwrap(), other.indentation.unwrap());
    assert!(depth < 3.9e-6, "the spring gives: {one:?}");
    assert!(
        (depth - told).abs() < 1e-12 * depth && (one.force - other.force).abs() < 1e-12 * one.force,
        "{one:?} {other:?}"
    );
    let (spring, also) = (whole.records[1].spring.unwrap().0, cut.records[2].spring.unwrap().0);
    assert!((spring - also).abs() < 1e-12 * also, "{spring:e} {also:e}");
}

/// A stiff spring is a prescribed depth, a soft one a prescribed force.
#[test]
fn limits_are_a_prescribed_depth_and_a_prescribed_force() {
    for of in SHAPES {
        let history = "Press(to: 1e-3, over: 1), Retract(speed: 1e-6)";
        let torn = |machine: &str| parting(&outcome(of, (machine, 3), history)).0.normal.force;
        let (depth, stiff) = (torn(""), torn(&spring(1e12)));
        assert!((stiff / depth - 1.0).abs() < 1e-6, "{of:?}: {stiff:e} {depth:e}");
        let pulled = outcome(of, ("", 3), "Press(to: 1e-3, over: 1), Press(to: -1, over: 1)");
        let (force, soft) = (parting(&pulled).0.normal.force, torn(&spring(1e-6)));
        assert!((soft / force - 1.0).abs() < 1e-6, "{of:?}: {soft:e} {force:e}");
    }
}

/// Without adhesion there is nothing to lose, and a flat punch is a spring behind a spring.
#[test]
fn without_adhesion_springs_stand_in_a_row() {
    let run = outcome(
        ("FlatPunch(radius: 1e-3)", ""),
        (&spring(500.0), 7),
        "Indent(to: 1e-5, over: 1), Retract(speed: 1e-6)",
    );
    let stiff = 2.0 * MODULUS * 1e-3;
    for record in &run.records {
        let (far, force) = (record.spring.unwrap().0, record.normal.force);
        assert!((force - far / (500f64.recip() + stiff.recip())).abs() < 1e-15 * stiff, "{record:?}");
        assert!(record.normal.dissipated.abs() <= 0.0);
    }
}

/// A hard ball (DMT) parts at −2πwR behind any spring, which loses what it holds; it snaps in at the far end's zero.
#[test]
fn a_hard_ball_loses_the_energy_of_the_spring() {
    let pull = 2.0 * PI * WORK * RADIUS;
    for stiffness in [1e-2, 1.0, 1e4] {
        let way = 3.0 * pull / stiffness;
        let history =
            format!("Indent(to: {:e}, over: 1), Indent(to: {way:e}, over: 1), Indent(to: {:e}, over: 1)", -way, -way);
        let run =
            outcome(("Paraboloid(radius: 1e-2)", "adhesion: Dmt(work: 0.05),"), (&spring(stiffness), 9), &history);
        let (last, after) = parting(&run);
        assert!((last.normal.force / -pull - 1.0).abs() < 1e-14);
        let lost = after.normal.dissipated - last.normal.dissipated;
        assert!((lost / (0.5 * pull * pull / stiffness) - 1.0).abs() < 1e-13, "{lost:e}");
        assert!((last.spring.unwrap().0 * stiffness / pull + 1.0).abs() < 1e-14);
        for record in run.records.iter().filter(|record| record.normal.contact_radius > Some(0.0)) {
            let (d, force) = (record.normal.indentation.unwrap(), record.normal.force);
            let right = 4.0 / 3.0 * MODULUS * RADIUS.sqrt() * d.powf(1.5) - pull;
            assert!((force - right).abs() < 1e-12 * (right.abs() + pull), "{force:e} {right:e}");
        }
    }
}
