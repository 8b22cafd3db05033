//! Laws across parts on bodies that are not alike at all depths: cuts, tables, swaps, ways by depth and by force, springs.

use springbed::prelude::*;
use springbed::run::record::Record;

const RUBBER: &str = "Viscoelastic(poisson: 0.5, shear: (equilibrium: 3e5, terms: [(modulus: 5e5, time: 0.1), (modulus: 2e5, time: 3)]))";
const LAW: &str = "Jkr(work: 0.02)";

/// Bodies, and the adhesion that goes with them.
fn bodies() -> Vec<(String, Option<&'static str>)> {
    let soft = "Elastic(young: 2e6, poisson: 0.5)";
    let layer = |body: &str, thickness: &str, base: &str| {
        format!("Layered(layers: [(body: {body}, thickness: {thickness})], base: {base})")
    };
    vec![
        (layer(soft, "5e-4", "Elastic(young: 1e7, poisson: 0.3)"), Some(LAW)),
        (layer(soft, "2e-4", "Rigid"), Some(LAW)),
        (layer(RUBBER, "3e-4", "Rigid"), Some("Jkr(work: 0.02, edge: Relaxed)")),
        ("Graded(young: 2e6, depth: 1e-3, exponent: 0.3, poisson: 0.4)".to_owned(), Some(LAW)),
        ("Winkler(modulus: 2e6, thickness: 1e-3)".to_owned(), None),
    ]
}

fn last(bodies: &str, rest: &str) -> Record {
    let text = format!("(shape: Paraboloid(radius: 5e-3), bodies: {bodies}, {rest})");
    let rows: [(&str, &[f64]); 2] = [("time_s", &[0.0, 1.0, 1.5]), ("indentation_m", &[0.0, 1e-5, 4e-6])];
    let tables = InMemory::default().with("way.csv", &rows);
    let plan = Notation::Ron.plan(&text, &tables).unwrap_or_else(|errors| panic!("{text}: {}", errors[0]));
    let outcome = run(&plan, Wanted::NOTHING).unwrap_or_else(|error| panic!("{text}: {error}"));
    *outcome.records.last().unwrap()
}

/// Force, radius, what is stored and what is lost.
fn state(record: &Record) -> [f64; 4] {
    let normal = &record.normal;
    [normal.force, normal.contact_radius.unwrap(), normal.stored.elastic + normal.stored.surface, normal.dissipated]
}

fn near(one: &Record, other: &Record, bound: f64) -> bool {
    let energy = state(other)[2].abs() + state(other)[3].abs();
    let [force, radius, stored, lost] = state(other);
    let scales = [force, radius, energy, energy];
    let right = [force, radius, stored, lost];
    state(one).iter().zip(right).zip(scales).all(|((one, right), scale)| (one - right).abs() <= bound * scale.abs())
}

/// Cutting an entry, a table of the same motion, the bodies the other way round: bound, the roundings of the ways.
#[test]
fn the_way_a_motion_is_written_does_not_matter() {
    for (body, adhesion) in bodies() {
        for adhesion in [None, adhesion] {
            let attraction = adhesion.map_or_else(String::new, |law| format!("adhesion: {law}, "));
            let of = |bodies: &str, history: &str| last(bodies, &format!("{attraction}history: [{history}]"));
            let pair = format!("({body}, Rigid)");
            let whole = of(&pair, "Indent(to: 1e-5, over: 1), Indent(to: 4e-6, over: 0.5)");
            let cut = of(
                &pair,
                "Indent(to: 3e-6, over: 0.3), Indent(to: 1e-5, over: 0.7), Indent(to: 8e-6, over: 0.16666666666666666), Indent(to: 4e-6, over: 0.3333333333333333)",
            );
            let table = of(&pair, "Table(\"way.csv\")");
            let swapped = of(&format!("(Rigid, {body})"), "Indent(to: 1e-5, over: 1), Indent(to: 4e-6, over: 0.5)");
            assert!(near(&cut, &whole, 1e-12) && near(&table, &whole, 1e-12), "{body} {attraction}");
            assert_eq!(state(&swapped).map(f64::to_bits), state(&whole).map(f64::to_bits), "{body}");
        }
    }
}

/// The force that belongs to a depth leads back to it; springs agree to the order of their width.
#[test]
fn depth_force_and_springs_agree() {
    for (body, _) in bodies().into_iter().filter(|(body, _)| !body.contains(RUBBER)) {
        let pair = format!("({body}, Rigid)");
        let by_depth = last(&pair, "history: [Indent(to: 1e-5, over: 1)]");
        let by_force = last(&pair, &format!("history: [Press(to: {:?}, over: 1)]", by_depth.normal.force));
        assert!((by_force.normal.indentation.unwrap() / 1e-5 - 1.0).abs() < 1e-13, "{body}");
        let springs = last(&pair, "springs: 2000, history: [Indent(to: 1e-5, over: 1)]");
        // Second order in the width of 2000 springs, with a constant of a few.
        assert!(near(&springs, &by_depth, 4.0 / 2000f64.powi(2)), "{body}: {springs:?} {by_depth:?}");
    }
}

/// Terms of no weight, and a layer of the same body as its base, are as if they were not there.
#[test]
fn what_has_no_weight_does_nothing() {
    let history = "history: [Indent(to: 1e-5, over: 1)]";
    let on_rigid = |body: &str| format!("(Layered(layers: [(body: {body}, thickness: 2e-4)], base: Rigid), Rigid)");
    let elastic = last(&on_rigid("Elastic(young: 3e6, poisson: 0.5)"), history);
    let weak = "Viscoelastic(poisson: 0.5, shear: (equilibrium: 1e6, terms: [(modulus: 1e-8, time: 1)]))";
    assert!(near(&last(&on_rigid(weak), history), &elastic, 1e-11));
    let body = "Elastic(young: 2e6, poisson: 0.3)";
    let layered = format!("(Layered(layers: [(body: {body}, thickness: 1e-4)], base: {body}), Rigid)");
    assert!(near(&last(&layered, history), &last(&format!("({body}, Rigid)"), history), 1e-12));
    let flat = "(Graded(young: 2e6, depth: 1e-3, exponent: 0, poisson: 0.3), Rigid)";
    assert!(near(&last(flat, history), &last(&format!("({body}, Rigid)"), history), 1e-12));
}
