//! How long a fit takes: `cargo run --release -p benches --example fit_times`.
//!
//! Data by closed forms and by whole runs, with noise; the median of repeats, one thread. With words behind it, those rows
//! alone whose names have one of them: `-- Ting power`.

use rayon::prelude::*;
use springbed::check::power_law::PowerTriangle;
use springbed::fit::prony::Moduli;
use springbed::fit::{Curve, Options, Question, Readings};
use springbed::prelude::*;
use springbed::run::record::FORCE;
use springbed::scene::Scene;
use std::error::Error;
use std::hint::black_box;
use std::time::Instant;

type Outcome<T> = Result<T, Box<dyn Error>>;

/// Numbers in (−1/2, 1/2) of a linear congruential generator.
fn noise(count: usize) -> Vec<f64> {
    let mut seed = 11u64;
    let mut draw = || {
        seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (seed >> 11) as f64 / (1u64 << 53) as f64 - 0.5
    };
    (0..count).map(|_| draw()).collect()
}

fn curve(time: Option<Vec<f64>>, depth: Vec<f64>, force: &[f64]) -> Curve {
    let largest = force.iter().fold(0.0, |largest: f64, force| largest.max(force.abs()));
    let force = force.iter().zip(noise(depth.len())).map(|(force, noise)| force + 0.01 * largest * noise).collect();
    Curve { rows: (2..depth.len() + 2).collect(), time, readings: Readings::Indentation { depth, force } }
}

fn triangle(start: f64, deepest: f64, end: f64, half: usize) -> Vec<f64> {
    let leg = |from: f64, to: f64| (0..half).map(move |k| from + (to - from) * k as f64 / half as f64);
    leg(start, deepest).chain(leg(deepest, end)).collect()
}

/// The forces of a run under the depths of a table.
fn forces(text: &str, time: &[f64], depth: &[f64]) -> Outcome<Vec<f64>> {
    let tables = InMemory::default().with("drive.csv", &[("time_s", time), ("indentation_m", depth)]);
    let plan = Notation::Ron.plan(text, &tables).map_err(|errors| errors[0].clone())?;
    let outcome = run(&plan, Wanted { instants: false, ..Wanted::NOTHING })?;
    let forces: Vec<f64> = outcome.records.iter().filter_map(|record| (FORCE.of)(record)).collect();
    Ok(forces[forces.len() - depth.len()..].to_vec())
}

/// Whether a row is asked for.
fn wanted(name: &str) -> bool {
    let words: Vec<String> = std::env::args().skip(1).collect();
    words.is_empty() || words.iter().any(|word| name.contains(word.as_str()))
}

fn told(name: &str, mut work: impl FnMut() -> Outcome<()>) -> Outcome<()> {
    if !wanted(name) {
        return Ok(());
    }
    work()?;
    let mut times = Vec::new();
    for _ in 0..15 {
        let began = Instant::now();
        work()?;
        times.push(began.elapsed().as_secs_f64());
    }
    times.sort_by(f64::total_cmp);
    println!("{name:60} {:8.2} ms", 1e3 * times[times.len() / 2]);
    Ok(())
}

fn fitted(name: &str, scene: &str, free: &[&str], curve: &Curve) -> Outcome<()> {
    let question = Question::new(&Scene::from_ron(scene)?, free, Options::default())?;
    told(name, || {
        black_box(question.fit(curve, &InMemory::default())?);
        Ok(())
    })
}

/// A thin gel on glass: modulus, thickness and first touch, 1000 points. No two gels are alike, for what is known of the layers
/// of one fit serves the next.
fn layered() -> Outcome<()> {
    let gel = |young: &str, poisson: f64, thickness: &str| {
        format!(
            r#"(shape: Paraboloid(radius: "10 um"), bodies: (Layered(layers: [(body: Elastic(young: "{young}",
            poisson: {poisson:?}), thickness: "{thickness}")], base: Rigid, bond: Bonded), Rigid), "#
        )
    };
    let depth: Vec<f64> = (0..1000).map(|k| 2e-9 * f64::from(k) - 0.5e-6).collect();
    let time: Vec<f64> = (0..depth.len()).map(|k| k as f64).collect();
    let made = format!("{}{}", gel("2 kPa", 0.49, "5 um"), r#"history: [Table("drive.csv")])"#);
    let data = curve(None, depth.clone(), &forces(&made, &time, &depth)?);
    let inside = "bodies.0.layers.0";
    let free = [format!("{inside}.body.young=10 Pa..100 kPa"), format!("{inside}.thickness=1 um..100 um")];
    let mut poisson = 0.49;
    told("layer on glass, 1000 points, first touch and baseline", || {
        poisson -= 1e-9;
        let start = format!("{}{}", gel("1 kPa", poisson, "8 um"), r#"history: [Indent(to: "1 um", over: 1)])"#);
        let question = Question::new(&Scene::from_ron(&start)?, &free, Options::default())?;
        black_box(question.fit(&data, &InMemory::default())?);
        Ok(())
    })
}

/// 64 × 64 curves of 1000 points on all threads, each made, fitted and forgotten.
fn force_map() -> Outcome<()> {
    const CURVES: usize = 64 * 64;
    let name = "force map, 64 x 64 curves of 1000 points";
    if !wanted(name) {
        return Ok(());
    }
    let scene = r#"(shape: Paraboloid(radius: "5 um"), bodies: (Elastic(young: "1 kPa", poisson: 0.5), Rigid),
        history: [Indent(to: "1 um", over: 1)])"#;
    let question = Question::new(&Scene::from_ron(scene)?, &["bodies.0.young"], Options::default())?;
    let one = |number: usize| {
        let stiffness = 1e3 + number as f64;
        let depth: Vec<f64> = (0..1000).map(|k| f64::from(k) * 3e-9).collect();
        let force: Vec<f64> =
            depth.iter().map(|z| 4.0 / 3.0 * stiffness * (5e-6 * (z - 1.3e-6).max(0.0).powi(3)).sqrt()).collect();
        question.fit(&curve(None, depth, &force), &InMemory::default()).map(|fit| fit.values[0])
    };
    let began = Instant::now();
    let all: Result<Vec<f64>, _> = (0..CURVES).into_par_iter().map(one).collect();
    black_box(all?);
    println!("{name:60} {:8.2} s on {} threads", began.elapsed().as_secs_f64(), rayon::current_num_threads());
    Ok(())
}

fn main() -> Outcome<()> {
    let history = r#"history: [Indent(to: "1 um", over: 1)])"#;
    let ball = r#"(shape: Paraboloid(radius: "5 um"), bodies: (Elastic(young: "1 kPa", poisson: 0.5), Rigid), "#;
    let depth: Vec<f64> = (0..5000).map(|k| f64::from(k) * 6e-10).collect();
    let force: Vec<f64> =
        depth.iter().map(|z| 4.0 / 3.0 * 3.2e3 * (5e-6 * (z - 1.3e-6).max(0.0).powi(3)).sqrt()).collect();
    let data = curve(None, depth, &force);
    fitted("elastic, 5000 points, first touch and baseline", &format!("{ball}{history}"), &["bodies.0.young"], &data)?;

    let lens = r#"(shape: Paraboloid(radius: "2.5 mm"), bodies: (Elastic(young: "4.8 MPa", poisson: 0.5), Rigid),
        adhesion: Jkr(work: "42 mJ/m^2"), "#;
    let depth = triangle(-3e-6, 20e-6, -9e-6, 1000);
    let time: Vec<f64> = (0..depth.len()).map(|k| k as f64).collect();
    let table = r#"history: [Table("drive.csv")])"#;
    let data = curve(None, depth.clone(), &forces(&format!("{lens}{table}"), &time, &depth)?);
    let start = format!("{lens}{history}").replace("4.8 MPa", "2 MPa").replace("42 mJ", "100 mJ");
    let free = ["bodies.0.young=100 kPa..100 MPa", "adhesion.work=1 mJ/m^2..1 J/m^2"];
    fitted("JKR, both ways, 2000 points, first touch and baseline", &start, &free, &data)?;

    let cell = r#"(shape: Paraboloid(radius: "10 um"), bodies: (Viscoelastic(poisson: 0.5, shear: (equilibrium: 300,
        terms: [(modulus: 600, time: 0.05), (modulus: 300, time: 0.5)])), Rigid), "#;
    let depth = triangle(-0.3e-6, 1.7e-6, -0.3e-6, 500);
    let time: Vec<f64> = (0..depth.len()).map(|k| 2e-3 * k as f64).collect();
    let data = curve(Some(time.clone()), depth.clone(), &forces(&format!("{cell}{table}"), &time, &depth)?);
    let start = format!("{cell}{history}").replace("600", "400").replace("time: 0.5", "time: 0.8");
    let free: Vec<String> = ["equilibrium", "terms.0.modulus", "terms.0.time", "terms.1.modulus", "terms.1.time"]
        .iter()
        .map(|place| format!("bodies.0.shear.{place}"))
        .collect();
    let free: Vec<&str> = free.iter().map(String::as_str).collect();
    fitted("Ting's triangle, two terms, 1000 points, first touch", &start, &free, &data)?;

    let soft = r#"(shape: Paraboloid(radius: "5 um"), bodies: (Viscoelastic(poisson: 0.5,
        shear: PowerLaw(modulus: "500 Pa", exponent: 0.3, time: "1 s")), Rigid), "#;
    // In contact for 2 × 0.35 s at 2 µm/s, first touch at 0.3 µm, 2 ms a row.
    let triangle =
        PowerTriangle { scale: 4.0 / 3.0 * 5e-6f64.sqrt(), power: 1.5, exponent: 0.2, speed: 2e-6, turn: 0.35 };
    let time: Vec<f64> = (0..1001).map(|k| 1e-3 * f64::from(k)).collect();
    let depth: Vec<f64> = time.iter().map(|t| 2e-6 * (0.5 - (t - 0.5f64).abs())).collect();
    let force: Vec<f64> = time.iter().map(|t| 4.0 * 800.0 * triangle.force((t - 0.15).max(0.0))).collect();
    let data = curve(Some(time), depth, &force);
    let free = ["bodies.0.shear.modulus=10 Pa..100 kPa", "bodies.0.shear.exponent=0.02..0.8"];
    fitted("power law, 1000 points, first touch and baseline", &format!("{soft}{history}"), &free, &data)?;

    layered()?;
    force_map()?;

    let frequency: Vec<f64> = (0..60).map(|k| 0.01 * 10f64.powf(0.1 * f64::from(k))).collect();
    let sums = |f: f64| {
        (0..10).fold((1e5, 0.0), |sum: (f64, f64), k| {
            let x = std::f64::consts::TAU * f * 10f64.powf(-4.0 + 0.6 * f64::from(k));
            (sum.0 + 1e6 * x * x / (1.0 + x * x), sum.1 + 1e6 * x / (1.0 + x * x))
        })
    };
    let (storage, loss) = frequency.iter().map(|&f| sums(f)).unzip();
    let moduli = Moduli { frequency, storage, loss };
    let spectrum = moduli.spectrum()?;
    println!("spectrum of ten terms: relative residual {:.1e}", spectrum.deviation);
    told("Prony spectrum of ten terms from moduli", || {
        black_box(moduli.spectrum()?);
        Ok(())
    })
}
