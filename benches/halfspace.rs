//! Half-space solver: Hertz on a window of three contact radii, and one product with the influence matrix's cost.
use criterion::{BenchmarkId, Criterion, criterion_group, criterion_main};
use ndarray::Array2;
use springbed::halfspace::{Boundary, Prescribed, PressedMap, Settings, Start, solve};

/// Paraboloid of radius 1 on n×n pixels over 0.3, contact radius 0.1.
fn paraboloid(n: usize) -> (Array2<f64>, f64) {
    let pixel = 0.3 / n as f64;
    let place = |index: usize| (index as f64 - (n / 2) as f64) * pixel;
    (Array2::from_shape_fn((n, n), |(row, column)| (place(row).powi(2) + place(column).powi(2)) / 2.0), pixel)
}

fn hertz(criterion: &mut Criterion) {
    let mut group = criterion.benchmark_group("half-space Hertz");
    group.sample_size(10);
    for n in [64, 128, 256, 512] {
        let (heights, pixel) = paraboloid(n);
        for (name, start) in [("coarser", Start::Coarser), ("nothing", Start::Nothing)] {
            let problem = PressedMap {
                heights: heights.view(),
                pixel: [pixel; 2],
                modulus: 1.0,
                boundary: Boundary::Free,
                control: Prescribed::Indentation(0.01),
            };
            group.bench_with_input(BenchmarkId::new(name, n), &problem, |bencher, problem| {
                bencher.iter(|| solve(problem, start, &Settings::default()));
            });
        }
    }
    group.finish();
}

criterion_group!(benches, hertz);
criterion_main!(benches);
