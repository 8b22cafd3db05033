//! A map of the stresses below a contact: `cargo bench -p benches --bench stress`.
#![expect(clippy::unwrap_used, reason = "a benchmark of known good inputs")]

use criterion::{BenchmarkId, Criterion, Throughput, criterion_group, criterion_main};
use springbed::contact::foundation::Foundation;
use springbed::contact::loaded::Loaded;
use springbed::input::quantity::{Length, Positive};
use springbed::shape::{Cone, Paraboloid, Profile, RoundedPunch, Sphere};
use std::hint::black_box;
use std::sync::Arc;

/// Points on each side of the map.
const SIDE: u32 = 200;

fn metres(si: f64) -> Length {
    Length::new(si).unwrap()
}

fn shapes() -> Vec<(&'static str, Arc<dyn Profile>)> {
    vec![
        ("paraboloid", Arc::new(Paraboloid { radius: metres(1.0) })),
        ("sphere", Arc::new(Sphere { radius: metres(1.0) })),
        ("cone", Arc::new(Cone { slope: Positive::new(0.1).unwrap() })),
        ("rounded punch", Arc::new(RoundedPunch { flat_radius: metres(0.08), edge_radius: metres(0.1) })),
    ]
}

/// The sum of the stresses of von Mises over the map, on one thread.
fn map(loaded: &Loaded, drag: f64) -> f64 {
    let field = loaded.field(0.3).dragged(drag);
    let place = |k: u32| 2.0 * 0.1 * (f64::from(k) + 0.5) / f64::from(SIDE);
    (0..SIDE).map(|row| (0..SIDE).map(|column| field.at(place(column), place(row)).von_mises()).sum::<f64>()).sum()
}

fn maps(criterion: &mut Criterion) {
    let mut group = criterion.benchmark_group("stress map of 200 x 200 points");
    group.sample_size(10).throughput(Throughput::Elements(u64::from(SIDE * SIDE)));
    for (name, profile) in shapes() {
        let loaded = Loaded::elastic(Foundation::new(profile, 1.0), 0.1, 0.0);
        group.bench_function(BenchmarkId::from_parameter(name), |bench| bench.iter(|| map(black_box(&loaded), 0.0)));
        group.bench_function(BenchmarkId::new("hardest place", name), |bench| {
            bench.iter(|| black_box(&loaded).field(0.3).hardest());
        });
    }
    let ball = Loaded::elastic(Foundation::new(shapes()[0].1.clone(), 1.0), 0.1, 0.0);
    group.bench_function("sliding paraboloid", |bench| bench.iter(|| map(black_box(&ball), 0.3)));
    group.finish();
}

criterion_group!(benches, maps);
criterion_main!(benches);
