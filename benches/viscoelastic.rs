//! Viscoelastic beds: the continuous one, the lazy one by number of springs, the direct one against a copy.

#![expect(clippy::expect_used, reason = "a benchmark may stop")]

use criterion::{BenchmarkId, Criterion, Throughput, criterion_group, criterion_main};
use springbed::contact::viscoelastic::Spectrum;
use springbed::contact::viscoelastic::direct::Direct;
use springbed::contact::viscoelastic::layout::Layout;
use springbed::contact::viscoelastic::lazy::Lazy;
use springbed::contact::viscoelastic::memory::Memory;
use springbed::drive::impact::{Projectile, StruckHalfSpace};
use springbed::input::quantity::Length;
use springbed::material::Relaxation;
use springbed::shape::Paraboloid;
use std::hint::black_box;
use std::sync::Arc;

fn ball() -> Paraboloid {
    Paraboloid { radius: Length::new(1.0).expect("a length above zero") }
}

/// `count` terms, one per decade around a second.
fn spectrum(count: i32) -> Arc<Spectrum> {
    let terms = (0..count).map(|k| (1.0 + f64::from(k), 10f64.powi(k - count / 2))).collect();
    Arc::new(Spectrum::new(&Relaxation { equilibrium: 1.0, terms, viscosity: 0.0 }))
}

/// Up in a second, down in a second: 50 forces on the way up and 50 on the way down.
fn ting(spectrum: &Arc<Spectrum>) -> f64 {
    let mut bed = Memory::new(spectrum.clone(), Arc::new(ball()));
    let mut sum = 0.0;
    for speed in [0.01, -0.01] {
        sum += (1..=50).map(|k| bed.force_after(speed, f64::from(k) / 50.0).map_or(0.0, |seen| seen.0)).sum::<f64>();
        bed.advance(speed, 1.0).expect("a paraboloid has no end");
    }
    sum
}

fn triangles(c: &mut Criterion) {
    let mut group = c.benchmark_group("ting_triangle_100_forces");
    for count in [1, 3, 10] {
        let spectrum = spectrum(count);
        group.bench_function(BenchmarkId::from_parameter(count), |b| b.iter(|| ting(black_box(&spectrum))));
    }
}

/// A step in which nothing is touched or released: its cost must not depend on the number of springs.
fn lazy_steps(c: &mut Criterion) {
    let mut group = c.benchmark_group("lazy_step_10_terms");
    for count in [1_000, 1_000_000] {
        let mut bed = Lazy::new(spectrum(10), Layout::uniform(&ball(), 1.0, count));
        bed.advance(1e-4, 1.0);
        let mut sign = 1.0;
        group.bench_function(BenchmarkId::from_parameter(count), |b| {
            b.iter(|| {
                sign = -sign;
                bed.advance(black_box(1e-9) * sign, 1e-3);
                bed.force()
            });
        });
    }
}

/// Every spring and term updated, against a copy of the same arrays.
fn direct_steps(c: &mut Criterion) {
    let mut group = c.benchmark_group("direct_step_10_terms");
    for count in [1_000, 1_000_000] {
        group.throughput(Throughput::Elements(10 * count as u64));
        let mut bed = Direct::new(spectrum(10), Layout::uniform(&ball(), 0.1, count));
        bed.advance(0.011, 1.0);
        let mut speed = 1e-9;
        group.bench_function(BenchmarkId::new("advance", count), |b| {
            b.iter(|| {
                speed = -speed;
                bed.advance(black_box(speed), 1e-3);
            });
        });
        let (from, mut to) = (vec![1.0f64; 10 * count], vec![0.0f64; 10 * count]);
        group.bench_function(BenchmarkId::new("copy", count), |b| b.iter(|| to.copy_from_slice(black_box(&from))));
    }
}

/// A ball of Kelvin–Voigt material and one of ten terms: one point of a restitution curve.
fn impacts(c: &mut Criterion) {
    let mut group = c.benchmark_group("impact");
    let kelvin_voigt = Arc::new(Spectrum::new(&Relaxation { equilibrium: 1.0, terms: vec![], viscosity: 0.1 }));
    for (name, spectrum) in [("kelvin_voigt", kelvin_voigt), ("ten_terms", spectrum(10))] {
        let driven = StruckHalfSpace { spectrum, profile: Arc::new(ball()) };
        let impact = Projectile { mass: 1.0, speed: 1.0 };
        group.bench_function(name, |b| b.iter(|| driven.flight(black_box(&impact), 1e-6)));
    }
}

criterion_group!(benches, triangles, lazy_steps, direct_steps, impacts);
criterion_main!(benches);
