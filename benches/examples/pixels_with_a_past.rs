//! What histories on pixels cost: a Maxwell body under a dead load, adhesive balls, a ball that yields, one in partial slip; each as a scene,
//! from its text to its last record. `cargo run --release -p benches --example pixels_with_a_past -- 128`.

use springbed::prelude::*;
use std::time::Instant;

const SCENES: [(&str, &str, usize); 5] = [
    (
        "Maxwell creep, 100 records",
        "bodies: (Viscoelastic(poisson: 0.5, shear: (terms: [(modulus: 1, time: 1)])), Rigid), accuracy: 1e-4, \
         history: [Press(to: 1e-3, over: 1e-3), HoldForce(over: 1)], steps: 50,",
        100,
    ),
    (
        "Maugis, in and out, 40 records",
        "bodies: (Elastic(young: 0.75, poisson: 0.5), Rigid), adhesion: Maugis(work: 1e-4, stress: 0.03), \
         history: [Indent(to: 0.01, over: 1), Indent(to: 0, over: 1)], steps: 20,",
        40,
    ),
    (
        "JKR with the work 1e-5, in and out, 40 records",
        "bodies: (Elastic(young: 0.75, poisson: 0.5), Rigid), adhesion: Jkr(work: 1e-5), \
         history: [Indent(to: 0.5e-3, over: 1), Indent(to: -1.2e-3, over: 1)], steps: 20,",
        40,
    ),
    (
        "a ball that yields and is let go, 20 records",
        "bodies: (Plastic(young: 0.75, poisson: 0.5, hardness: 0.03), Rigid), \
         history: [Indent(to: 0.01, over: 1), Indent(to: 0, over: 1)], steps: 10,",
        20,
    ),
    (
        "a ball slid to and fro, 60 records of partial slip",
        "bodies: (Elastic(young: 0.75, poisson: 0.5), Rigid), friction: Coulomb(coefficient: 0.5), \
         history: [Indent(to: 0.01, over: 1), Slide(to: 0.004, over: 1), Slide(to: -0.004, over: 1), Slide(to: 0.004, over: 1)], steps: 20,",
        60,
    ),
];

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let grid: usize = std::env::args().nth(1).map_or(Ok(128), |text| text.parse())?;
    for (name, parts, records) in SCENES {
        let text = format!("(shape: Paraboloid(radius: 1), {parts} solver: HalfSpace(grid: {grid}))");
        let mut times = Vec::new();
        let mut stated = 0.0;
        for _ in 0..5 {
            let begun = Instant::now();
            let plan = Notation::Ron.plan(&text, &InMemory::default()).map_err(|errors| errors[0].to_string())?;
            let outcome = run(&plan, Wanted::NOTHING)?;
            times.push(begun.elapsed().as_secs_f64());
            stated = outcome.error_estimate.relative;
        }
        times.sort_by(f64::total_cmp);
        println!(
            "{name}, {grid} x {grid}: {:.3} s, {:.1} ms a record; stated error {stated:.0e}",
            times[2],
            1e3 * times[2] / records as f64
        );
    }
    Ok(())
}
