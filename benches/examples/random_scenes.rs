//! Random scenes over the whole matrix, held against the laws that speak of them.
//!
//! `cargo run --release -p benches --example random_scenes -- [scenes [from [part]]]`, of the combinations of which one
//! part bears that name, such as `lying cylinder`. Scenes that take long are named as they end.

use rayon::prelude::*;
use springbed::check::matrix::{Cell, Kept, Law, Variation, Verdict, cells};
use std::collections::BTreeMap;
use std::time::{Duration, Instant};

/// A scene with its variations that takes longer is named.
const LONG: Duration = Duration::from_secs(10);

/// The scene with the number `number`: a combination that is computed, and other numbers.
fn scene(cells: &[Cell], number: u64) -> (&Cell, Vec<Kept>) {
    let (variation, part) = Variation::numbered(number);
    let cell = &cells[usize::try_from(number).unwrap_or(0) % cells.len()];
    (cell, cell.laws(&variation, part))
}

fn main() {
    let mut numbers = std::env::args().skip(1).filter_map(|text| text.parse().ok());
    let scenes: u64 = numbers.next().unwrap_or(1000);
    let from: u64 = numbers.next().unwrap_or(0);
    let part = std::env::args().nth(3);
    let wanted = |cell: &Cell| part.as_deref().is_none_or(|part| cell.names().contains(&part));
    let is_computed = |cell: &Cell| matches!(cell.verdict, Verdict::Computed { .. });
    let computed: Vec<Cell> = cells().into_iter().filter(|cell| is_computed(cell) && wanted(cell)).collect();
    if computed.is_empty() {
        println!("no combination is computed that has such a part");
        return;
    }
    let found: Vec<(u64, &Cell, Vec<Kept>)> = (from..from + scenes)
        .into_par_iter()
        .map(|number| {
            let start = Instant::now();
            let (cell, kept) = scene(&computed, number);
            if start.elapsed() > LONG {
                eprintln!("{number}: {:?} took {} s", cell.names(), start.elapsed().as_secs());
            }
            (number, cell, kept)
        })
        .collect();
    let mut counts: BTreeMap<String, [usize; 2]> = BTreeMap::new();
    for (number, cell, kept) in &found {
        for Kept { law, failure } in kept {
            let count = counts.entry(format!("{law:?}")).or_default();
            count[usize::from(failure.is_some())] += 1;
            if let Some(why) = failure {
                println!("{number}: {:?} {law:?}: {why}", cell.names());
            }
        }
    }
    println!("{scenes} scenes of {} combinations", computed.len());
    for law in [Law::Cut, Law::Table, Law::Swap, Law::Elastic, Law::Ledger] {
        let [kept, broken] = counts.get(&format!("{law:?}")).copied().unwrap_or_default();
        println!("{law:?}: kept {kept}, broken {broken}");
    }
}
