//! Random scenes over the whole matrix, held against the laws that speak of them.
//!
//! `cargo run --release -p benches --example random_scenes -- [scenes [from [part …]]]`, of the combinations whose parts
//! bear these names, such as `lying cylinder`. Scenes that take long are named as they end, those that have no end in
//! sight before, and laws that are not kept; a scene alone is written out before it is run.

use rayon::prelude::*;
use springbed::check::matrix::{Cell, Kept, Law, Variation, Verdict, cells};
use std::collections::BTreeMap;
use std::sync::Mutex;
use std::time::{Duration, Instant};

/// A scene with its variations that takes longer is named.
const LONG: Duration = Duration::from_secs(10);

/// One that takes still longer is named while it runs.
const ENDLESS: Duration = Duration::from_secs(60);

/// The scenes that run now, since when, and which of them are named.
static RUNNING: Mutex<BTreeMap<u64, (Instant, bool)>> = Mutex::new(BTreeMap::new());

/// Names the scenes that run for too long, once each, as long as the program runs.
fn watch() {
    std::thread::spawn(|| {
        loop {
            std::thread::sleep(LONG);
            let Ok(mut running) = RUNNING.lock() else { return };
            for (number, (since, named)) in running.iter_mut().filter(|(_, (_, named))| !named) {
                *named = since.elapsed() > ENDLESS;
                if *named {
                    println!("{number}: runs since {} s", since.elapsed().as_secs());
                }
            }
        }
    });
}

/// A combination that is computed, and the laws its scene was held against.
type Tried<'c> = (&'c Cell, Vec<Kept>);

/// The combination of the scene with the number `number`.
fn combination(cells: &[Cell], number: u64) -> &Cell {
    &cells[usize::try_from(number).unwrap_or(0) % cells.len()]
}

/// The scene with the number `number`: a combination, and other numbers.
fn scene(cells: &[Cell], number: u64) -> Tried<'_> {
    let (variation, part) = Variation::numbered(number);
    let cell = combination(cells, number);
    (cell, cell.laws(&variation, part))
}

/// A scene, and what is to be said of it at once.
fn told(cells: &[Cell], number: u64) -> Tried<'_> {
    let start = Instant::now();
    if let Ok(mut running) = RUNNING.lock() {
        running.insert(number, (start, false));
    }
    let (cell, kept) = scene(cells, number);
    if let Ok(mut running) = RUNNING.lock() {
        running.remove(&number);
    }
    if start.elapsed() > LONG {
        println!("{number}: {:?} took {} s", cell.names(), start.elapsed().as_secs());
    }
    for Kept { law, failure } in &kept {
        if let Some(why) = failure {
            println!("{number}: {:?} {law:?}: {why}", cell.names());
        }
    }
    (cell, kept)
}

/// How many scenes ran, how many laws they kept and how many not, by a name.
fn counted<K: Ord>(tried: &[Tried<'_>], of: impl Fn(&Cell, &Kept) -> K) -> BTreeMap<K, [usize; 2]> {
    let mut counts = BTreeMap::new();
    for (cell, law) in tried.iter().flat_map(|(cell, kept)| kept.iter().map(move |law| (cell, law))) {
        let count: &mut [usize; 2] = counts.entry(of(cell, law)).or_default();
        count[usize::from(law.failure.is_some())] += 1;
    }
    counts
}

/// How many scenes ran of the combinations, from the least to the most.
fn spread(tried: &[Tried<'_>]) -> (usize, usize, usize) {
    let mut ran: BTreeMap<[&str; 5], usize> = BTreeMap::new();
    for (cell, _) in tried.iter().filter(|(_, kept)| !kept.is_empty()) {
        *ran.entry(cell.names()).or_default() += 1;
    }
    let least = ran.values().min().copied().unwrap_or_default();
    (ran.len(), least, ran.values().max().copied().unwrap_or_default())
}

fn main() {
    let mut numbers = std::env::args().skip(1).map_while(|text| text.parse().ok());
    let scenes: u64 = numbers.next().unwrap_or(1000);
    let from: u64 = numbers.next().unwrap_or(0);
    let parts: Vec<String> = std::env::args().skip(3).collect();
    let wanted = |cell: &Cell| parts.iter().all(|part| cell.names().contains(&part.as_str()));
    let is_computed = |cell: &Cell| matches!(cell.verdict, Verdict::Computed { .. });
    let computed: Vec<Cell> = cells().into_iter().filter(|cell| is_computed(cell) && wanted(cell)).collect();
    if computed.is_empty() {
        println!("no combination is computed that has such parts");
        return;
    }
    if scenes == 1 {
        let cell = combination(&computed, from);
        println!("{}", cell.text(&Variation::numbered(from).0).unwrap_or_default());
    }
    watch();
    let tried: Vec<Tried<'_>> = (from..from + scenes).into_par_iter().map(|number| told(&computed, number)).collect();
    let (ran, least, most) = spread(&tried);
    let refused = tried.iter().filter(|(_, kept)| kept.is_empty()).count();
    println!(
        "{scenes} scenes of {} combinations; {ran} ran, each {least} to {most} times; {refused} scenes were refused",
        computed.len()
    );
    for (at, what) in ["shape", "bodies", "adhesion", "friction", "drive"].iter().enumerate() {
        for (name, [kept, broken]) in counted(&tried, |cell, _| cell.names()[at]) {
            println!("{what} {name}: laws kept {kept}, broken {broken}");
        }
    }
    let by_law = counted(&tried, |_, kept| kept.law);
    for law in Law::ALL {
        let [kept, broken] = by_law.get(&law).copied().unwrap_or_default();
        println!("{law:?}: kept {kept}, broken {broken}");
    }
}
