//! One state, one curve, many scenes: `cargo bench -p benches --bench states`.
#![expect(clippy::unwrap_used, reason = "a benchmark of known good inputs")]

use criterion::{BenchmarkId, Criterion, Throughput, criterion_group, criterion_main};
use rayon::prelude::*;
use springbed::app::scene_file::plan;
use springbed::contact::adhesion::line::EdgeLine;
use springbed::contact::direct::QuasiStatic;
use springbed::contact::foundation::Foundation;
use springbed::input::quantity::Length;
use springbed::library::Contact;
use springbed::run::{Wanted, run};
use springbed::scene::plan::Plan;
use springbed::shape::Paraboloid;
use std::hint::black_box;
use std::path::Path;
use std::sync::Arc;

const MODULUS: f64 = 6.4e6;
const WORK: f64 = 0.042;

fn lens() -> Paraboloid {
    Paraboloid { radius: Length::new(2.5e-3).unwrap() }
}

fn contact(ground: &Foundation, work: f64) -> QuasiStatic {
    QuasiStatic::new(EdgeLine::new(ground.clone(), work))
}

/// Depth given, force and radius wanted, from bodies that just touch.
fn one_state(c: &mut Criterion) {
    let mut group = c.benchmark_group("state");
    let ground = Foundation::new(Arc::new(lens()), MODULUS);
    for (name, work) in [("hertz", 0.0), ("jkr", WORK)] {
        group.bench_function(BenchmarkId::from_parameter(name), |b| {
            b.iter(|| {
                let mut contact = contact(&ground, work);
                contact.indent(black_box(1e-5)).unwrap();
                contact.present().balance
            });
        });
        let mut present = contact(&ground, work);
        let mut d = 1e-5;
        group.bench_function(BenchmarkId::new("next depth", name), |b| {
            b.iter(|| {
                d = 3e-5 - d;
                present.indent(black_box(d)).unwrap();
                present.present().balance
            });
        });
    }
}

/// A scene of the library: 500 records in, 500 out.
fn scene(radius: usize, steps: usize) -> Plan {
    let text = format!(
        "(shape: Paraboloid(radius: {:e}), bodies: (Elastic(young: 4.8e6, poisson: 0.5), Rigid), \
         adhesion: Jkr(work: 0.042), steps: {steps}, \
         history: [Indent(to: 2e-5, over: 10), Retract(speed: 1e-6)])",
        2.5e-3 * (1.0 + 1e-6 * radius as f64)
    );
    plan(Path::new("lens.ron"), &text).unwrap()
}

fn one_curve(c: &mut Criterion) {
    let plan = scene(0, 500);
    c.bench_function("jkr curve of 1000 records", |b| b.iter(|| run(black_box(&plan), Wanted::NOTHING).unwrap()));
}

/// 10 000 curves of 100 records on one and on two threads.
fn many_scenes(c: &mut Criterion) {
    let scenes: Vec<Plan> = (0..10_000).map(|radius| scene(radius, 50)).collect();
    let mut group = c.benchmark_group("scenes");
    group.sample_size(10).throughput(Throughput::Elements(10_000));
    for threads in [1, 2] {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
        group.bench_function(BenchmarkId::new("threads", threads), |b| {
            b.iter(|| pool.install(|| scenes.par_iter().map(pull_off).sum::<f64>()));
        });
    }
}

fn pull_off(plan: &Plan) -> f64 {
    let outcome = run(plan, Wanted::NOTHING).unwrap();
    outcome.records.iter().map(|record| record.normal.force).fold(0.0, f64::min)
}

/// A step of a contact that a program of the user owns, its force wanted: a ball on its way to and fro, sticking and
/// slipping, and a lens in adhesion.
fn one_step(c: &mut Criterion) {
    let mut group = c.benchmark_group("step of an owned contact");
    let ball = Contact::paraboloid(5e-3).unwrap().elastic(115e9).unwrap();
    let mut ball = ball.coulomb(98e9, 0.3).unwrap();
    let lens = Contact::paraboloid(2.5e-3).unwrap().elastic(MODULUS).unwrap();
    let mut lens = lens.jkr(WORK).unwrap();
    let mut at = 0u32;
    group.bench_function("hertz with coulomb", |b| {
        b.iter(|| {
            at = (at + 1) % 400;
            let part = f64::from(at.abs_diff(200)) / 200.0;
            ball.advance(black_box(1e-6 * (1.0 + 0.1 * part)), 3e-7 * part).unwrap();
            ball.force() + ball.tangential_force()
        });
    });
    group.bench_function("jkr", |b| {
        b.iter(|| {
            at = (at + 1) % 400;
            lens.advance(black_box(1e-5 * (1.0 + f64::from(at.abs_diff(200)) / 200.0)), 0.0).unwrap();
            lens.force()
        });
    });
}

criterion_group!(benches, one_state, one_step, one_curve, many_scenes);
criterion_main!(benches);
