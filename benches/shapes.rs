//! Time of one evaluation of each shape: `cargo bench -p benches --bench shapes`.
#![expect(clippy::unwrap_used, reason = "a benchmark of known good inputs")]

use criterion::{Criterion, criterion_group, criterion_main};
use springbed::input::quantity::{Amplitude, Length, Positive};
use springbed::input::table::InMemory;
use springbed::shape::{
    Cone, Measured, Paraboloid, Power, Profile, RoundedCone, RoundedPunch, Sphere, TruncatedCone, TruncatedParaboloid,
    WavyParaboloid,
};
use std::hint::black_box;
use std::path::Path;

fn metres(si: f64) -> Length {
    Length::new(si).unwrap()
}

fn table(rows: u32) -> Measured {
    let radii: Vec<f64> = (0..rows).map(|k| f64::from(k) / f64::from(rows - 1)).collect();
    let heights: Vec<f64> = radii.iter().map(|r| 0.5 * r * r).collect();
    let tables = InMemory::default().with("tip.csv", &[("radius_m", &radii), ("height_m", &heights)]);
    Measured::read(Path::new("tip.csv"), &tables).unwrap()
}

fn shapes() -> Vec<(&'static str, Box<dyn Profile>)> {
    let (flat_radius, radius) = (metres(0.1), metres(1.0));
    let slope = Positive::new(0.1).unwrap();
    let amplitude = Amplitude::new(1e-4).unwrap();
    vec![
        ("paraboloid", Box::new(Paraboloid { radius })),
        ("sphere", Box::new(Sphere { radius })),
        ("cone", Box::new(Cone { slope })),
        ("power", Box::new(Power { coefficient: slope, exponent: Positive::new(2.5).unwrap() })),
        ("truncated cone", Box::new(TruncatedCone { flat_radius, slope })),
        ("truncated paraboloid", Box::new(TruncatedParaboloid { flat_radius, radius })),
        ("rounded cone", Box::new(RoundedCone { radius, slope })),
        ("rounded punch", Box::new(RoundedPunch { flat_radius, edge_radius: radius })),
        ("wavy paraboloid", Box::new(WavyParaboloid { radius, amplitude, wavelength: flat_radius })),
        ("table of 100 rows", Box::new(table(100))),
        ("table of 100 000 rows", Box::new(table(100_000))),
    ]
}

fn evaluations(criterion: &mut Criterion) {
    for (name, shape) in shapes() {
        let (a, d) = (0.3, shape.reduced(0.3));
        let mut group = criterion.benchmark_group(name);
        group.bench_function("g", |bench| bench.iter(|| shape.reduced(black_box(a))));
        group.bench_function("load", |bench| bench.iter(|| shape.load_integral(black_box(a))));
        group.bench_function("energy", |bench| bench.iter(|| shape.energy_integral(black_box(a))));
        group.bench_function("edge", |bench| bench.iter(|| shape.edge(black_box(d))));
        group.bench_function("pressure", |bench| bench.iter(|| shape.pressure_integral(black_box(0.2), a)));
        group.finish();
    }
}

criterion_group!(benches, evaluations);
criterion_main!(benches);
