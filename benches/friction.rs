//! Coulomb contact: the memory of turning points, its bed of springs, oblique impact.

#![expect(clippy::unwrap_used, reason = "a benchmark of known good inputs")]

use criterion::{Criterion, criterion_group, criterion_main};
use springbed::friction::oblique::{Ball, BallMotion, SOLID};
use springbed::friction::{CoulombBed, Grip, Pose, TangentialMemory};
use springbed::input::quantity::Length;
use springbed::shape::{Paraboloid, Profile};
use std::hint::black_box;
use std::sync::Arc;

const GRIP: Grip = Grip { normal_modulus: 1.0, tangential_modulus: 0.8, coefficient: 0.3 };

fn loops(records: u32) -> Vec<Pose> {
    let wave = |k: u32| (f64::from(k) * 0.02).sin();
    (0..records).map(|k| Pose { indentation: 1.0 + 0.2 * wave(3 * k), slide: 0.25 * wave(k) }).collect()
}

fn friction(criterion: &mut Criterion) {
    let shape = Paraboloid { radius: Length::new(1.0).unwrap() };
    let path = loops(1000);
    let level: Vec<Pose> = path.iter().map(|at| Pose { indentation: 1.0, ..*at }).collect();
    for (name, path) in [("1000 records, fretting", &level), ("1000 records, load varied while sheared", &path)] {
        criterion.bench_function(name, |bencher| {
            bencher.iter(|| {
                let mut memory = TangentialMemory::new(Arc::new(shape.clone()), GRIP);
                path.iter()
                    .map(|&to| memory.advance(to).map(|()| memory.state().tangential_force).unwrap())
                    .sum::<f64>()
            });
        });
    }
    let mut group = criterion.benchmark_group("bed");
    group.sample_size(10);
    let bed = CoulombBed::new(&shape, GRIP, 100_000.try_into().unwrap(), shape.edge(1.2).unwrap()).unwrap();
    group.bench_function("100000 springs, 1000 steps", |bencher| {
        bencher.iter(|| bed.clone().advance(black_box(&path)));
    });
    let grip = Grip { normal_modulus: 115e9, tangential_modulus: 95e9, coefficient: 0.1 };
    let ball = Ball { grip, radius: 5e-3, mass: 4e-3, gyration: SOLID };
    let angles: Vec<BallMotion> = (0..100)
        .map(|k| {
            let (sine, cosine) = (0.89 * f64::from(k)).to_radians().sin_cos();
            BallMotion { normal_speed: cosine, tangential_speed: sine, spin: 0.0 }
        })
        .collect();
    group.bench_function("100 oblique impacts", |bencher| {
        bencher.iter(|| ball.hits(black_box(&angles), 1e-6).unwrap().len());
    });
}

criterion_group!(benches, friction);
criterion_main!(benches);
