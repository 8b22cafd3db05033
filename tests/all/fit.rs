//! Fits: recovery of what made the data, honest intervals, wrong models noticed, bad data refused with their row.

use proptest::prelude::*;
use springbed::app::data_file::{Data, Wanted};
use springbed::check::power_law::PowerTriangle;
use springbed::fit::{Candidate, Curve, Fit, FitError, Options, Question, Readings, compared};
use springbed::prelude::*;
use springbed::run::record::{FORCE, INDENTATION, Record};
use springbed::scene::Scene;
use springbed::scene::fit::{Baseline, Drive};
use std::path::Path;

pub fn scene(text: &str) -> Scene {
    Scene::from_ron(text).unwrap()
}

fn fit(scene: &Scene, free: &[&str], curve: &Curve, options: Options) -> Result<Fit, FitError> {
    Question::new(scene, free, options)?.fit(curve, &InMemory::default())
}

pub fn curve(time: Option<Vec<f64>>, depth: Vec<f64>, force: Vec<f64>) -> Curve {
    Curve { rows: (2..depth.len() + 2).collect(), time, readings: Readings::Indentation { depth, force } }
}

/// The same with other forces, made of each depth and force.
fn with_forces(data: &Curve, mut of: impl FnMut(f64, f64) -> f64) -> Curve {
    let [depth, force] = data.readings.both();
    data.answering(Drive::Depth, depth.iter().zip(force).map(|(&depth, &force)| of(depth, force)).collect())
}

/// Normal noise whose neighbours have the correlation ρ, by Box & Muller from SplitMix64 (Steele, Lea & Flood 2014): of a linear
/// congruential generator the draws of one seed after the other were alike enough to show a bias that was none.
pub struct Noise {
    seed: u64,
    rho: f64,
    last: f64,
}

impl Noise {
    pub fn new(seed: u64, rho: f64) -> Self {
        let mut noise = Self { seed: seed.wrapping_mul(0xD134_2543_DE82_EF95), rho, last: 0.0 };
        // What it starts from is forgotten: ten lengths of the longest correlation tried.
        (0..1000).for_each(|_| {
            noise.next();
        });
        noise
    }

    fn even(&mut self) -> f64 {
        self.seed = self.seed.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let mut z = self.seed;
        z = (z ^ (z >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
        z ^= z >> 31;
        ((z >> 11) as f64 + 0.5) / (1u64 << 53) as f64
    }

    /// Of deviation one.
    pub fn next(&mut self) -> f64 {
        let (size, angle) = ((-2.0 * self.even().ln()).sqrt(), std::f64::consts::TAU * self.even());
        self.last = self.rho * self.last + (1.0 - self.rho * self.rho).sqrt() * size * angle.cos();
        self.last
    }
}

pub const BALL: &str = r#"(shape: Paraboloid(radius: "5 um"), bodies: (Elastic(young: "1 kPa", poisson: 0.5), Rigid),
    history: [Indent(to: "1 um", over: 1)])"#;

/// Hertz: E = 2.4 kPa touched at 1.3 µm over a baseline of 0.2 nN, with noise of `deviation` [N].
pub fn hertz(count: usize, deviation: f64, mut noise: Noise) -> Curve {
    let depth: Vec<f64> = (0..count).map(|k| 3e-6 * k as f64 / (count - 1) as f64).collect();
    let force = |d: f64| 4.0 / 3.0 * 3.2e3 * (5e-6 * d.max(0.0).powi(3)).sqrt() + 0.2e-9;
    let force = depth.iter().map(|z| force(z - 1.3e-6) + deviation * noise.next()).collect();
    curve(None, depth, force)
}

fn near(fit: &Fit, path: &str, truth: f64, bound: f64) {
    let value = fit.parameter(path).unwrap().value;
    assert!((value / truth - 1.0).abs() < bound, "{path} {value} {truth}");
}

#[test]
fn hertz_is_recovered() {
    let found =
        fit(&scene(BALL), &["bodies.0.young=10 Pa..1 MPa"], &hertz(500, 0.0, Noise::new(1, 0.0)), Options::default());
    let found = found.unwrap();
    near(&found, "bodies.0.young", 2.4e3, 1e-6);
    near(&found, "contact_point", 1.3e-6, 1e-6);
    near(&found, "baseline", 0.2e-9, 1e-6);
    assert!(!found.rejected, "{:?}", found.notes);
}

#[test]
fn a_tilt_is_noticed_and_recovered() {
    let mut data = hertz(600, 5e-12, Noise::new(2, 0.0));
    data = with_forces(&data, |z, force| force + 3e-4 * z);
    let free = ["bodies.0.young"];
    let flat = fit(&scene(BALL), &free, &data, Options::default()).unwrap();
    assert!(flat.notes.iter().any(|note| note.contains("tilted")), "{:?}", flat.notes);
    let tilted = fit(&scene(BALL), &free, &data, Options { baseline: Baseline::Linear, ..Options::default() }).unwrap();
    near(&tilted, "tilt", 3e-4, 0.1);
    near(&tilted, "bodies.0.young", 2.4e3, 0.01);
    assert!(!tilted.rejected, "{:?}", tilted.notes);
}

/// k = 0.5 N/m; a hundredth of the way of the piezo is on the detector though nothing bends: E is found, and by how much.
#[test]
fn a_virtual_deflection_is_recovered() {
    let (spring, part) = (0.5, 0.01);
    let clean = hertz(400, 0.0, Noise::new(3, 0.0));
    // z = d + F/k with the true depth and force; F_m = F + ksz and the noise of the detector, d_m = z − F_m/k.
    let [depths, forces] = clean.readings.both();
    let bent = |noise: &mut dyn FnMut() -> f64| {
        let piezo: Vec<f64> = depths.iter().zip(forces).map(|(d, force)| d + force / spring).collect();
        let force: Vec<f64> = forces.iter().zip(&piezo).map(|(force, z)| force + spring * part * z + noise()).collect();
        let depth = piezo.iter().zip(&force).map(|(z, force)| z - force / spring).collect();
        curve(None, depth, force)
    };
    let options = Options { baseline: Baseline::Virtual, spring: Some(spring), ..Options::default() };
    let free = ["bodies.0.young=10 Pa..1 MPa"];
    let exact = fit(&scene(BALL), &free, &bent(&mut || 0.0), options).unwrap();
    near(&exact, "bodies.0.young", 2.4e3, 1e-6);
    near(&exact, "virtual_deflection", part, 1e-6);
    near(&exact, "contact_point", 1.3e-6, 1e-6);
    // A tilt of the force alone leaves the depths wrong.
    let tilted =
        fit(&scene(BALL), &free, &bent(&mut || 0.0), Options { baseline: Baseline::Linear, ..Options::default() })
            .unwrap();
    assert!((tilted.parameter("bodies.0.young").unwrap().value / 2.4e3 - 1.0).abs() > 5e-3);
    let mut draw = Noise::new(9, 0.0);
    let noisy = fit(&scene(BALL), &free, &bent(&mut || 20e-12 * draw.next()), options).unwrap();
    for (path, truth) in [("bodies.0.young", 2.4e3), ("virtual_deflection", part)] {
        let one = noisy.parameter(path).unwrap();
        let (off, error) = ((one.value - truth).abs(), one.standard_error.unwrap());
        assert!(off < 4.0 * error && error < 0.2 * truth, "{path} {one:?}");
    }
    assert!(noisy.chi2.is_some_and(|chi2| (chi2 - 1.0).abs() < 0.5) && !noisy.rejected, "{:?}", noisy.notes);
    let alone = fit(&scene(BALL), &free, &clean, Options { spring: None, ..options }).unwrap_err();
    assert!(alone.to_string().contains("--spring"), "{alone}");
}

/// A cantilever 27 times as stiff as the contact at its deepest, and one 2.7 times: the depths have the noise of the force in
/// them, n/k, so that in contact it counts 1.04 and 1.37 times. Good fits stand, with their intervals; a cone is told from a
/// ball. Of 60 draws 95 % hold the truth 57 times; four standard deviations of the binomial law are 7.
#[test]
fn depths_made_of_a_deflection_are_judged_by_their_own_noise() {
    let clean = hertz(400, 0.0, Noise::new(3, 0.0));
    let [depths, forces] = clean.readings.both();
    let drawn = |(spring, part): (f64, f64), noise: &mut Noise| {
        let piezo: Vec<f64> = depths.iter().zip(forces).map(|(d, force)| d + force / spring).collect();
        let measured = |(force, z): (&f64, &f64)| force + spring * part * z + 20e-12 * noise.next();
        let force: Vec<f64> = forces.iter().zip(&piezo).map(measured).collect();
        let depth = piezo.iter().zip(&force).map(|(z, force)| z - force / spring).collect();
        curve(None, depth, force)
    };
    let free = ["bodies.0.young=10 Pa..1 MPa"];
    for (spring, baseline, rho) in [
        (0.5, Baseline::Virtual, 0.0),
        (0.05, Baseline::Virtual, 0.0),
        (0.05, Baseline::Virtual, 0.8),
        (0.05, Baseline::Constant, 0.0),
    ] {
        let part = if baseline == Baseline::Virtual { 0.01 } else { 0.0 };
        let options = Options { baseline, spring: Some(spring), ..Options::default() };
        let (mut held, mut rejected, mut noise) = (0, 0, Noise::new(31, rho));
        for _ in 0..60 {
            let found = fit(&scene(BALL), &free, &drawn((spring, part), &mut noise), options).unwrap();
            let one = found.parameter(PATH).unwrap();
            held += u32::from(one.low.is_some_and(|low| low <= 2.4e3) && one.high.is_some_and(|high| 2.4e3 <= high));
            rejected += u32::from(found.rejected);
        }
        assert!(rejected == 0 && (50..=60).contains(&held), "{spring} {rho}: {held} held, {rejected} rejected");
        let cone = BALL.replace(r#"Paraboloid(radius: "5 um")"#, "Cone(slope: 0.5)");
        let wrong = fit(&scene(&cone), &free, &drawn((spring, part), &mut noise), options).unwrap();
        assert!(wrong.rejected, "{spring} {rho}: {:?}", wrong.notes);
    }
}

const PATH: &str = "bodies.0.young";

/// What the scene `text` answers at the rows of a table, through a whole run.
pub fn answered(text: &str, names: [&str; 2], time: &[f64], drive: &[f64]) -> Vec<f64> {
    let tables = InMemory::default().with("drive.csv", &[(names[0], time), (names[1], drive)]);
    let plan = Notation::Ron.plan(text, &tables).unwrap();
    let outcome = run(&plan, ROWS_ONLY).unwrap();
    let column = if names[1] == "force_n" { INDENTATION } else { FORCE };
    let answers: Vec<f64> = outcome.records.iter().map(|record| (column.of)(record).unwrap_or(0.0)).collect();
    answers[answers.len() - drive.len()..].to_vec()
}

const ROWS_ONLY: springbed::run::Wanted = springbed::run::Wanted { instants: false, ..springbed::run::Wanted::NOTHING };

/// Up to `deepest` from `start` and back to `end`.
pub fn triangle(start: f64, deepest: f64, end: f64, half: usize) -> Vec<f64> {
    let leg = |from: f64, to: f64| (0..half).map(move |k| from + (to - from) * k as f64 / half as f64);
    leg(start, deepest).chain(leg(deepest, end)).chain([end]).collect()
}

#[test]
fn both_ways_of_an_adhesive_lens_are_recovered() {
    let text = |young: &str, work: &str| {
        format!(
            r#"(shape: Paraboloid(radius: "2.5 mm"), bodies: (Elastic(young: "{young}", poisson: 0.5), Rigid),
            adhesion: Jkr(work: "{work}"), history: [Table("drive.csv")])"#
        )
    };
    let depth = triangle(-3e-6, 20e-6, -9e-6, 200);
    let time: Vec<f64> = (0..depth.len()).map(|k| k as f64).collect();
    let force = answered(&text("4.8 MPa", "42 mJ/m^2"), ["time_s", "indentation_m"], &time, &depth);
    let moved: Vec<f64> = depth.iter().map(|d| d + 5e-6).collect();
    let start = text("2 MPa", "100 mJ/m^2").replace("Table(\"drive.csv\")", "Indent(to: \"1 um\", over: 1)");
    let free = ["bodies.0.young=100 kPa..100 MPa", "adhesion.work=1 mJ/m^2..1 J/m^2"];
    let found = fit(&scene(&start), &free, &curve(None, moved, force), Options::default()).unwrap();
    near(&found, "bodies.0.young", 4.8e6, 1e-6);
    near(&found, "adhesion.work", 0.042, 1e-6);
    near(&found, "contact_point", 5e-6, 1e-6);
}

/// A lens whose attraction has a range, pressed and torn off: data of a run, found again without one.
#[test]
fn the_range_of_an_attraction_is_recovered() {
    // λ = 1 and 4.
    for stress in ["78 kPa", "310 kPa"] {
        let text = |young: &str, work: &str, stress: &str| {
            format!(
                r#"(shape: Paraboloid(radius: "2.5 mm"), bodies: (Elastic(young: "{young}", poisson: 0.5), Rigid),
                adhesion: Maugis(work: "{work}", stress: "{stress}"), history: [Table("drive.csv")])"#
            )
        };
        let depth = triangle(-3e-6, 12e-6, -9e-6, 100);
        let time: Vec<f64> = (0..depth.len()).map(|k| k as f64).collect();
        let force = answered(&text("4.8 MPa", "42 mJ/m^2", stress), ["time_s", "indentation_m"], &time, &depth);
        let moved: Vec<f64> = depth.iter().map(|d| d + 5e-6).collect();
        let start =
            text("2 MPa", "100 mJ/m^2", "150 kPa").replace("Table(\"drive.csv\")", "Indent(to: \"1 um\", over: 1)");
        let free =
            ["bodies.0.young=100 kPa..100 MPa", "adhesion.work=1 mJ/m^2..1 J/m^2", "adhesion.stress=1 kPa..100 MPa"];
        let found = fit(&scene(&start), &free, &curve(None, moved, force), Options::default()).unwrap();
        near(&found, "bodies.0.young", 4.8e6, 1e-6);
        near(&found, "adhesion.work", 0.042, 1e-6);
        near(&found, "adhesion.stress", stress.trim_end_matches(" kPa").parse::<f64>().unwrap() * 1e3, 1e-6);
        near(&found, "contact_point", 5e-6, 1e-6);
    }
}

/// An adhesive contact pressed and torn off, every record of the run: first touch and both sides of pull-off among them.
pub fn torn_off(text: &str) -> Curve {
    let outcome =
        run(&Notation::Ron.plan(text, &InMemory::default()).unwrap(), springbed::run::Wanted::NOTHING).unwrap();
    let column = |column: springbed::run::table::Column<Record>| -> Vec<f64> {
        outcome.records.iter().map(|record| (column.of)(record).unwrap_or(0.0)).collect()
    };
    curve(None, column(INDENTATION), column(FORCE))
}

pub const GEL: &str = r#"(shape: Paraboloid(radius: "1 mm"), bodies: (Elastic(young: "40 kPa", poisson: 0.5), Rigid),
    adhesion: Jkr(work: "20 mJ/m^2"), history: [Press(to: "1 mN", over: 1), Retract(speed: "10 um/s")])"#;

pub const GEL_FREE: [&str; 2] = ["bodies.0.young=1 kPa..1 MPa", "adhesion.work=1 mJ/m^2..1 J/m^2"];

pub fn in_place() -> Options {
    use springbed::scene::fit::{Drive, FirstTouch};
    let (drive, contact) = (Some(Drive::Depth), FirstTouch::Zero);
    Options { drive, contact, baseline: Baseline::Absent, ..Options::default() }
}

/// An edge that closes with less than it opens with: both works from one curve, in and out.
#[test]
fn works_of_both_ways_are_told_apart() {
    let two = GEL
        .replace("work: \"20 mJ/m^2\"", "work: \"20 mJ/m^2\", closing: \"5 mJ/m^2\"")
        .replace("history:", "steps: 60, history:");
    let start = scene(&two.replace("40 kPa", "60 kPa").replace("20 mJ", "30 mJ").replace("\"5 mJ", "\"8 mJ"));
    let free = [GEL_FREE[0], GEL_FREE[1], "adhesion.closing=1 mJ/m^2..1 J/m^2"];
    let found = fit(&start, &free, &torn_off(&two), in_place()).unwrap();
    near(&found, "bodies.0.young", 40e3, 1e-6);
    near(&found, "adhesion.work", 0.02, 1e-6);
    near(&found, "adhesion.closing", 0.005, 1e-6);
}

#[test]
fn rows_on_jumps_are_left_out_and_told() {
    let data = torn_off(GEL);
    let start = scene(&GEL.replace("40 kPa", "15 kPa").replace("20 mJ", "70 mJ"));
    for options in [in_place(), Options { drive: in_place().drive, ..Options::default() }] {
        let found = fit(&start, &GEL_FREE, &data, options).unwrap();
        near(&found, "bodies.0.young", 40e3, 1e-6);
        near(&found, "adhesion.work", 0.02, 1e-6);
        let last = data.len() - 1;
        assert!([0, last - 1, last].iter().all(|row| found.on_jumps.contains(row)), "{:?}", found.on_jumps);
        assert!(found.on_jumps.len() < 12, "{:?}", found.on_jumps);
        assert!(found.notes.iter().any(|note| note.contains("the model jumps there")), "{:?}", found.notes);
    }
}

/// 200 curves hold the truth 190 times; 4 standard deviations of the binomial law are 12.
#[test]
fn intervals_beside_jumps_hold_the_truth() {
    let (clean, start) = (torn_off(GEL), scene(&GEL.replace("40 kPa", "30 kPa")));
    for (options, rho) in
        [(in_place(), 0.0), (in_place(), 0.8), (Options { drive: in_place().drive, ..Options::default() }, 0.0)]
    {
        let mut held = [0, 0];
        for seed in 1..=200 {
            let mut noise = Noise::new(seed, rho);
            let data = with_forces(&clean, |_, force| force + 2e-6 * noise.next());
            let found = fit(&start, &GEL_FREE, &data, options).unwrap();
            for (held, (path, truth)) in held.iter_mut().zip([("bodies.0.young", 40e3), ("adhesion.work", 0.02)]) {
                let one = found.parameter(path).unwrap();
                *held +=
                    usize::from(one.low.is_some_and(|low| low <= truth) && one.high.is_some_and(|high| truth <= high));
            }
        }
        println!("{options:?} {rho} {held:?}");
        assert!(held.iter().all(|held| (178..=200).contains(held)), "{rho} {held:?}");
    }
}

const CELL: &str = r#"(shape: Paraboloid(radius: "10 um"), bodies: (Viscoelastic(poisson: 0.5,
    shear: (equilibrium: EQUILIBRIUM, terms: [(modulus: MODULUS, time: TIME)])), Rigid), history: [HISTORY])"#;

pub fn cell(equilibrium: &str, modulus: &str, time: &str, history: &str) -> String {
    let text = CELL.replace("EQUILIBRIUM", equilibrium).replace("MODULUS", modulus);
    text.replace("TIME", time).replace("HISTORY", history)
}

pub const SPECTRUM: [&str; 3] = [
    "bodies.0.shear.equilibrium=10 Pa..10 kPa",
    "bodies.0.shear.terms.0.modulus=10 Pa..10 kPa",
    "bodies.0.shear.terms.0.time=10 ms..10 s",
];

/// The short cut of the fit against the continuous bed of the run, to rounding: what made the data is found again.
#[test]
fn a_triangle_of_ting_is_recovered() {
    let depth = triangle(-0.3e-6, 1.7e-6, -0.3e-6, 100);
    let time: Vec<f64> = (0..depth.len()).map(|k| 0.01 * k as f64).collect();
    let force =
        answered(&cell("300", "900", "0.2", r#"Table("drive.csv")"#), ["time_s", "indentation_m"], &time, &depth);
    let start = scene(&cell("500", "500", "0.5", r#"Indent(to: "1 um", over: 1)"#));
    let found = fit(&start, &SPECTRUM, &curve(Some(time), depth, force), Options::default()).unwrap();
    near(&found, "bodies.0.shear.equilibrium", 300.0, 1e-6);
    near(&found, "bodies.0.shear.terms.0.modulus", 900.0, 1e-6);
    near(&found, "bodies.0.shear.terms.0.time", 0.2, 1e-6);
    assert!(found.parameter("contact_point").unwrap().value.abs() < 1e-12);
}

pub const POWER: &str = r#"(shape: Paraboloid(radius: "10 um"), bodies: (Viscoelastic(poisson: 0.5,
    shear: PowerLaw(modulus: "500 Pa", exponent: 0.3, time: "1 s")), Rigid), history: [Indent(to: "1 um", over: 1)])"#;

pub const POWER_FREE: [&str; 2] = ["bodies.0.shear.modulus=10 Pa..100 kPa", "bodies.0.shear.exponent=0.02..0.8"];

/// Two terms of a noisy triangle, asked for from beside them: a draw that happens to lie nearer to the data leads to a dashpot
/// and one term, with three times the noise left.
#[test]
fn two_terms_of_a_triangle_are_found_from_beside_them() {
    let cell = |fast: f64, slow: f64, history: &str| {
        format!(
            r#"(shape: Paraboloid(radius: "10 um"), bodies: (Viscoelastic(poisson: 0.5, shear: (equilibrium: 300,
            terms: [(modulus: {fast:?}, time: 0.05), (modulus: 300, time: {slow:?})])), Rigid), history: [{history}])"#
        )
    };
    let depth = triangle(-0.3e-6, 1.7e-6, -0.3e-6, 500);
    let time: Vec<f64> = (0..depth.len()).map(|k| 2e-3 * k as f64).collect();
    let force = answered(&cell(600.0, 0.5, r#"Table("drive.csv")"#), ["time_s", "indentation_m"], &time, &depth);
    let largest = force.iter().fold(0.0f64, |largest, force| largest.max(*force));
    let truths = [("equilibrium", 300.0), ("terms.0.modulus", 600.0), ("terms.0.time", 0.05), ("terms.1.time", 0.5)];
    let free: Vec<String> = ["equilibrium", "terms.0.modulus", "terms.0.time", "terms.1.modulus", "terms.1.time"]
        .map(|place| format!("bodies.0.shear.{place}"))
        .to_vec();
    let free: Vec<&str> = free.iter().map(String::as_str).collect();
    for seed in 1..5 {
        let mut noise = Noise::new(seed, 0.0);
        let noisy = force.iter().map(|force| force + 0.003 * largest * noise.next()).collect();
        let data = curve(Some(time.clone()), depth.clone(), noisy);
        let found = fit(&scene(&cell(400.0, 0.8, r#"Indent(to: "1 um", over: 1)"#)), &free, &data, Options::default());
        let found = found.unwrap();
        assert!(found.deviation < 0.0033 * largest && !found.rejected, "{found:?}");
        for (place, truth) in truths {
            let path = format!("bodies.0.shear.{place}");
            let one = found.parameters.iter().find(|one| one.path == path).unwrap();
            let error = one.standard_error.unwrap();
            assert!((one.value - truth).abs() < 4.0 * error, "{path}: {} ± {error}", one.value);
        }
    }
}

/// Ting's triangle in closed form: G₀ = 800 Pa, β = 0.2, touched between two rows.
pub fn power_triangle(half: usize) -> Curve {
    let exact = PowerTriangle {
        scale: 4.0 * 800.0 * 4.0 / 3.0 * 10e-6f64.sqrt(),
        power: 1.5,
        exponent: 0.2,
        speed: 2e-6,
        turn: 1.0,
    };
    let depth = triangle(-0.3e-6, 2e-6, -0.3e-6, half);
    let step = 2.3e-6 / 2e-6 / half as f64;
    let time: Vec<f64> = (0..depth.len()).map(|k| step * k as f64).collect();
    let force = time.iter().map(|t| if *t > 0.15 { exact.force(t - 0.15) } else { 0.0 }).collect();
    curve(Some(time), depth, force)
}

#[test]
fn a_power_law_is_recovered_from_a_triangle() {
    let clock = std::time::Instant::now();
    let found = fit(&scene(POWER), &POWER_FREE, &power_triangle(250), Options::default()).unwrap();
    println!("{:?}", clock.elapsed());
    near(&found, "bodies.0.shear.modulus", 800.0, 1e-6);
    near(&found, "bodies.0.shear.exponent", 0.2, 1e-6);
    assert!(found.parameter("contact_point").unwrap().value.abs() < 1e-6 * 2e-6);
}

/// d^{3/2} = (3F(1 − ν)/8√R) J(t) with J = sin(πβ)/(πβ) t^β/G₀; at once nothing gives.
#[test]
fn a_power_law_is_recovered_from_creep() {
    use std::f64::consts::PI;
    let time: Vec<f64> = (0..200).map(|k| 0.02 * f64::from(k)).collect();
    let compliance = |t: f64| (0.2 * PI).sin() / (0.2 * PI) * t.powf(0.2) / 800.0;
    let depth = |t: &f64| (3.0 * 1e-9 * 0.5 * compliance(*t) / (8.0 * 10e-6f64.sqrt())).powf(2.0 / 3.0);
    let data = curve(Some(time.clone()), time.iter().map(depth).collect(), vec![1e-9; 200]);
    let start = scene(&POWER.replace(r#"Indent(to: "1 um", over: 1)"#, "HoldForce(over: 1)"));
    let found = fit(&start, &POWER_FREE, &data, Options { baseline: Baseline::Absent, ..Options::default() }).unwrap();
    near(&found, "bodies.0.shear.modulus", 800.0, 1e-6);
    near(&found, "bodies.0.shear.exponent", 0.2, 1e-6);
}

/// 60 curves hold the truth 57 times; 4 standard deviations of the binomial law are 6.8.
#[test]
fn intervals_of_a_power_law_hold_the_truth() {
    let clean = power_triangle(60);
    let mut held = [0, 0];
    for seed in 1..=60 {
        let mut noise = Noise::new(seed, 0.0);
        let data = with_forces(&clean, |_, force| force + 20e-12 * noise.next());
        let found = fit(&scene(POWER), &POWER_FREE, &data, Options::default()).unwrap();
        for (held, (path, truth)) in
            held.iter_mut().zip([("bodies.0.shear.modulus", 800.0), ("bodies.0.shear.exponent", 0.2)])
        {
            let one = found.parameter(path).unwrap();
            *held += usize::from(one.low.is_some_and(|low| low <= truth) && one.high.is_some_and(|high| truth <= high));
        }
    }
    assert!(held.iter().all(|held| (50..=60).contains(held)), "{held:?}");
}

/// Under a force: the depth creeps, d^{3/2} = 3F(1 − ν)J(t)/8√R.
#[test]
fn creep_is_recovered() {
    let time: Vec<f64> = (0..60).map(|k| 0.02 * f64::from(k)).collect();
    // G₀ = 1200 Pa, G∞ = 300 Pa, so that creep takes τG₀/G∞ = 0.8 s.
    let compliance = |t: f64| 1.0 / 1200.0 + (1.0 / 300.0 - 1.0 / 1200.0) * (1.0 - (-t / 0.8f64).exp());
    let depth = |t: &f64| (3.0 * 1e-9 * 0.5 * compliance(*t) / (8.0 * 10e-6f64.sqrt())).powf(2.0 / 3.0);
    let data = curve(Some(time.clone()), time.iter().map(depth).collect(), vec![1e-9; 60]);
    let start = scene(&cell("500", "500", "0.5", "HoldForce(over: 1)"));
    let found = fit(&start, &SPECTRUM, &data, Options { baseline: Baseline::Absent, ..Options::default() }).unwrap();
    near(&found, "bodies.0.shear.equilibrium", 300.0, 1e-6);
    near(&found, "bodies.0.shear.terms.0.modulus", 900.0, 1e-6);
    near(&found, "bodies.0.shear.terms.0.time", 0.2, 1e-6);
}

#[test]
fn a_wrong_shape_is_noticed() {
    let cone = scene(&BALL.replace(r#"Paraboloid(radius: "5 um")"#, "Cone(slope: 0.5)"));
    for rho in [0.0, 0.8] {
        let data = hertz(800, 20e-12, Noise::new(5, rho));
        let free = ["bodies.0.young=100 Pa..100 kPa"];
        let wrong = fit(&cone, &free, &data, Options::default()).unwrap();
        assert!(
            wrong.rejected && wrong.notes.iter().any(|note| note.contains("speak against")),
            "{rho} {:?}",
            wrong.notes
        );
        let right = fit(&scene(BALL), &free, &data, Options::default()).unwrap();
        assert!(!right.rejected, "{rho} {:?}", right.notes);
        assert!(right.aic < wrong.aic);
    }
}

/// What a wrong model leaves is smooth, like noise of a correlation next to one: it must not lead the search away.
#[test]
fn a_misfit_without_noise_stays_at_the_data() {
    let cone = scene(&BALL.replace(r#"Paraboloid(radius: "5 um")"#, "Cone(slope: 0.5)"));
    let data = hertz(400, 0.0, Noise::new(1, 0.0));
    let found = fit(&cone, &["bodies.0.young=10 Pa..1 MPa"], &data, Options::default()).unwrap();
    let largest = data.answered(Drive::Depth).iter().copied().fold(0.0, f64::max);
    // The best cone leaves 1 %.
    assert!(found.deviation < 0.04 * largest, "{} {:?}", found.deviation / largest, found.parameters);
}

#[test]
fn what_the_data_cannot_tell_is_said() {
    // F ∝ E√R: only the product.
    let data = hertz(400, 20e-12, Noise::new(3, 0.0));
    let free = ["bodies.0.young=100 Pa..100 kPa", "shape.radius=1 um..100 um"];
    let found = fit(&scene(BALL), &free, &data, Options::default()).unwrap();
    assert!(found.notes.iter().any(|note| note.contains("apart")), "{:?}", found.notes);
    let found = fit(&scene(BALL), &["bodies.0.young=3 kPa..100 kPa"], &data, Options::default()).unwrap();
    assert!(found.notes.iter().any(|note| note.contains("end of its range")), "{:?}", found.notes);
}

/// F ∝ E√R: with first touch and baseline kept a radius that is 2 % more takes 1 % off the modulus.
#[test]
fn a_radius_known_to_two_per_cent_moves_the_modulus_by_one() {
    let exact = Options { baseline: Baseline::Absent, ..Options::default() };
    let free = ["bodies.0.young=10 Pa..1 MPa"];
    let mut data = hertz(300, 1e-13, Noise::new(3, 0.0));
    data = with_forces(&data, |_, force| force - 0.2e-9);
    let plain = fit(&scene(BALL), &free, &data, exact).unwrap();
    for given in ["shape.radius=2 %", "shape.radius=0.1 um"] {
        let question = Question::new(&scene(BALL), &free, exact).unwrap().given(&[given]).unwrap();
        let found = question.fit(&data, &InMemory::default()).unwrap();
        let (with, without) = (found.parameter("bodies.0.young").unwrap(), plain.parameter("bodies.0.young").unwrap());
        assert!((with.value / without.value - 1.0).abs() < 1e-12);
        // Half of the way from E/√0.98 to E/√1.02 in logarithms, from their geometric mean.
        let shift = -found.carried[0].shifts[0] / with.value;
        let right = 0.25 * (1.02f64 / 0.98).ln() / (1.02f64 * 0.98).powf(0.25);
        assert!((shift / right - 1.0).abs() < 1e-6, "{shift} {right}");
        let widened = with.standard_error.unwrap() / with.value;
        assert!((widened / shift.hypot(without.standard_error.unwrap() / without.value) - 1.0).abs() < 1e-6);
        assert!(((with.high.unwrap() / with.value).ln() / (1.96 * shift) - 1.0).abs() < 1e-2, "{with:?}");
        assert!(found.notes.iter().any(|note| note.contains("more than the noise does")), "{:?}", found.notes);
        // First touch does not depend on the radius.
        assert!(found.carried[0].shifts[1].abs() < 1e-13, "{:?}", found.carried);
    }
}

/// A stiffness of the cantilever that is 10 % less takes 10 % off the forces, and moves the depths too.
#[test]
fn a_cantilever_known_roughly_moves_forces_and_depths() {
    let folder = tempfile::tempdir().unwrap();
    let data = hertz(300, 0.0, Noise::new(3, 0.0));
    let line = |(depth, force): (&f64, &f64)| format!("{:e},{:e}\n", depth + force / 0.05, force / 0.05);
    let lines: String = data.driven(Drive::Depth).iter().zip(data.answered(Drive::Depth)).map(line).collect();
    std::fs::write(folder.path().join("probe.csv"), format!("piezo [m],deflection [m]\n{lines}")).unwrap();
    std::fs::write(folder.path().join("gel.ron"), BALL).unwrap();
    let fitted = |spring: &str, given: &[&str]| {
        let at = |name: &str| folder.path().join(name).display().to_string();
        let (scene, data) = (at("gel.ron"), at("probe.csv"));
        let common = [&scene, &data, "--free", "bodies.0.young=10 Pa..1 MPa", "--json", "--format", "json"];
        let all: Vec<&str> = common.into_iter().chain(["--spring", spring]).chain(given.iter().copied()).collect();
        let output = program(&all, folder.path());
        assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
        let json: serde_json::Value = serde_json::from_slice(&output.stdout).unwrap();
        json["fits"][0].clone()
    };
    let young = |fit: &serde_json::Value| fit["parameters"][0]["value"].as_f64().unwrap();
    let given = fitted("0.05 N/m", &["--given", "spring=10 %"]);
    let (low, high) = (young(&fitted("0.045 N/m", &[])), young(&fitted("0.055 N/m", &[])));
    let shift = given["given"][0]["moves"][0].as_f64().unwrap();
    assert!((shift / (0.5 * (high / low).ln() * (high * low).sqrt()) - 1.0).abs() < 1e-5, "{shift} {low} {high}");
    let error = given["parameters"][0]["standard_error"].as_f64().unwrap();
    assert!((error / shift - 1.0).abs() < 1e-3, "{error} {shift}");
}

/// The thickness of a layer, which no factor of the force stands for.
#[test]
fn modulus_and_thickness_of_a_layer_are_recovered() {
    let text = r#"(shape: Paraboloid(radius: "5 um"), bodies: (Layered(layers: [(body: Elastic(young: "2 kPa", poisson: 0.5),
        thickness: "4 um")], base: Rigid, bond: Bonded), Rigid), history: [Table("drive.csv")])"#;
    let depth: Vec<f64> = (0..200).map(|k| 1e-8 * f64::from(k) - 5e-7).collect();
    let time: Vec<f64> = (0..200).map(f64::from).collect();
    let data = curve(None, depth.clone(), answered(text, ["time_s", "indentation_m"], &time, &depth));
    let start = scene(
        &text
            .replace("2 kPa", "1 kPa")
            .replace("4 um", "20 um")
            .replace(r#"Table("drive.csv")"#, r#"Indent(to: "1 um", over: 1)"#),
    );
    let layer = "bodies.0.layers.0";
    let free = [format!("{layer}.body.young=10 Pa..1 MPa"), format!("{layer}.thickness=0.5 um..500 um")];
    let free: Vec<&str> = free.iter().map(String::as_str).collect();
    let found = fit(&start, &free, &data, Options::default()).unwrap();
    near(&found, &format!("{layer}.body.young"), 2e3, 1e-6);
    near(&found, &format!("{layer}.thickness"), 4e-6, 1e-6);
    assert!(found.parameters.iter().all(|one| one.standard_error.is_some()), "{:?}", found.notes);
}

/// What made the data is found among the models, whichever it was.
#[test]
fn the_model_that_made_the_data_is_the_best() {
    let lens = r#"(shape: Paraboloid(radius: "2.5 mm"), bodies: (Elastic(young: "4.8 MPa", poisson: 0.5), Rigid),
        ADHESION history: [Table("drive.csv")])"#;
    let depth = triangle(-2e-6, 20e-6, -2e-6, 150);
    let time: Vec<f64> = (0..depth.len()).map(|k| k as f64).collect();
    let made = [("hertz", ""), ("jkr", r#"adhesion: Jkr(work: "42 mJ/m^2"),"#), ("layered", "")];
    for (name, adhesion) in made {
        let mut text = lens.replace("ADHESION", adhesion);
        if name == "layered" {
            let layer = r#"Layered(layers: [(body: Elastic(young: "4.8 MPa", poisson: 0.5), thickness: "0.5 mm")],
                base: Rigid, bond: Bonded)"#;
            text = text.replace(r#"Elastic(young: "4.8 MPa", poisson: 0.5)"#, layer);
        }
        let mut force = answered(&text, ["time_s", "indentation_m"], &time, &depth);
        let mut noise = Noise::new(17, 0.0);
        force.iter_mut().for_each(|force| *force += 2e-5 * noise.next());
        let data = curve(None, depth.clone(), force);
        let plain = Candidate {
            name: String::new(),
            scene: scene(
                &lens.replace("ADHESION", "").replace(r#"Table("drive.csv")"#, r#"Indent(to: "1 um", over: 1)"#),
            ),
            free: vec!["bodies.0.young=100 kPa..100 MPa".to_owned()],
            given: Vec::new(),
        };
        let asked = |name: &&str| {
            let Candidate { scene, free, .. } = plain.varied(name).unwrap().unwrap();
            Question::new(&scene, &free, in_place()).unwrap().fit(&data, &InMemory::default()).unwrap()
        };
        let names = ["hertz", "jkr", "layered"];
        let fits: Vec<Fit> = names.iter().map(asked).collect();
        let standings = compared(&data, &fits.iter().collect::<Vec<_>>());
        let best = standings.iter().position(|standing| standing.beyond_best <= 0.0).unwrap();
        let sum: f64 = standings.iter().map(|standing| standing.weight).sum();
        assert!((sum - 1.0).abs() < 1e-12);
        // A model with a parameter more is as near; it costs two.
        let as_near = standings[names.iter().position(|known| *known == name).unwrap()].beyond_best;
        assert!(names[best] == name || name == "hertz" && as_near < 2.1, "{name}: {standings:?}");
    }
}

/// The rise along the axes of a map is that of the intervals: at the end of a 95 % interval t² of its quantile.
#[test]
fn a_map_rises_as_the_intervals_say() {
    let free = ["bodies.0.young=10 Pa..1 MPa"];
    let question = Question::new(&scene(BALL), &free, Options::default()).unwrap();
    let question = question.map("bodies.0.young, contact_point").unwrap();
    let found = question.fit(&hertz(300, 20e-12, Noise::new(5, 0.0)), &InMemory::default()).unwrap();
    let map = found.map.as_ref().unwrap();
    let young = found.parameter("bodies.0.young").unwrap();
    let least = map.rise.iter().flatten().copied().fold(f64::MAX, f64::min);
    assert!(least < 1e-6 && map.rise.len() == map.x.len() * map.y.len(), "{least}");
    // Over all first touches the least rise at four standard errors is sixteen.
    let side = map.y.len();
    for column in [0, map.x.len() - 1] {
        let far = (map.x[column] / young.value).ln().abs() / (young.standard_error.unwrap() / young.value);
        assert!((far - 4.0).abs() < 1e-6, "{far}");
        let least = map.rise[column * side..(column + 1) * side].iter().flatten().copied().fold(f64::MAX, f64::min);
        assert!((least / 16.0 - 1.0).abs() < 0.05, "{least}");
    }
    // For many degrees of freedom the region of 95 % ends at a rise of 5.991.
    assert!((map.confidence(5.991) - 0.95).abs() < 2e-3, "{}", map.confidence(5.991));
    assert!(Question::new(&scene(BALL), &free, Options::default()).unwrap().map("bodies.0.young").is_err());
}

#[test]
fn wrong_questions_are_refused() {
    let refused = |free: &[&str]| {
        let asked = Question::new(&scene(BALL), free, Options::default());
        asked.map(|_| ()).unwrap_err().to_string()
    };
    assert!(refused(&[]).contains("nothing is free"));
    assert!(refused(&["bodies.0.yung"]).contains("did you mean `young`"));
    assert!(refused(&["bodies.0.young=1 kPa"]).contains("expected bodies.0.young=LO..HI"));
    assert!(refused(&["bodies.0.young=1 kPa..1 mm"]).contains("has the unit \"mm\""));
    assert!(refused(&["bodies.0.young=2 kPa..1 kPa"]).contains("smaller end first"));
    assert!(refused(&["bodies.0.young", "bodies.0.young"]).contains("twice"));
    let few = curve(None, vec![0.0, 1e-6], vec![0.0, 1e-9]);
    let error = fit(&scene(BALL), &["bodies.0.young"], &few, Options::default()).unwrap_err();
    assert!(error.to_string().contains("2 points count"), "{error}");
    let ragged = curve(None, vec![0.0; 20], vec![0.0; 19]);
    assert!(fit(&scene(BALL), &["bodies.0.young"], &ragged, Options::default()).is_err());
}

fn read(text: &str, columns: &str) -> Result<Curve, String> {
    let wanted = Wanted::read(columns, None)?;
    let data = Data::parse(Path::new("x.csv"), text, &wanted).map_err(|fault| fault.message)?;
    data.curve().map_err(|fault| fault.message)
}

#[test]
fn data_are_read_as_they_come() {
    let right = |text: &str, columns: &str| {
        let curve = read(text, columns).unwrap();
        let [depth, force] = curve.readings.both();
        assert_eq!((depth[1], force[1]), (1.5e-7, 2.5e-9), "{text}");
        curve
    };
    right("z [nm],F [nN]\n0,0\n150,2.5\n", "");
    right("# probe 7\n# force in nN\nForce (nN);Indentation (µm)\n0,0;0,0\n2,5;0,15\n", "");
    right("time_s\tindentation_m\tforce_n\n0\t0\t0\n1\t1.5e-7\t2.5e-9\n", "");
    right("a;b\nnm;nN\n0;0\n150;2,5\n", "depth=a, force=b");
    right("0 0\n150 2.5\n", "depth=1 [nm], force=2 [nN]");
    let flipped = right("height,deflection\n0,0\n150,-2.5\n", "depth=height [nm], force=-deflection [nN]");
    assert_eq!(flipped.rows, [2, 3]);
}

#[test]
fn bad_data_are_refused_with_their_row() {
    let refused = |text: &str| read(text, "").unwrap_err();
    let head = "t [s],z [nm],F [nN]\n0,0,0\n1,1,1\n";
    assert_eq!(refused(&format!("{head}2,NaN,1\n3,3,3\n")), "row 4: z: \"NaN\" is not finite: expected a number");
    assert_eq!(refused(&format!("{head}2,,1\n3,3,3\n")), "row 4: z: the cell is empty: expected a number");
    assert!(refused(&format!("{head}2,x,1\n3,3,3\n")).contains("row 4: z: \"x\" is not a number"));
    assert!(refused(&format!("{head}2,2\n3,3,3\n")).contains("row 4: F: the row has 2 cells: expected 3"));
    assert!(refused(&format!("{head}0.5,2,2\n")).contains("row 4: the time goes from 1.0 s to 0.5 s"));
    assert!(refused("hello\nworld\n").contains("no table of numbers"));
    assert!(refused("a,b\n1,2\n").contains("no column of forces"));
    assert!(refused("z,depth,F\n1,2,3\n").contains("may be in \"z\" or in \"depth\""));
    assert!(refused("z [nm],F [bananas]\n1,2\n").contains("no column of forces"));
    assert!(read("z,F\n1,2\n", "depht=z").unwrap_err().contains("did you mean `depth`"));
    assert!(read("z,F\n1,2\n", "depth=y").unwrap_err().contains("there is no column \"y\""));
}

proptest! {
    /// Bytes of all kinds, and tables with bytes put in, are read or refused.
    #[test]
    fn no_data_make_the_reader_panic(text in "[ -~\t\n;,µ\"]{0,200}", at in 0usize..60, odd in "\\PC{0,3}") {
        let _ = read(&text, "depth=1 [nm], force=2 [nN]");
        let mut table = "t [s];z [nm];F [nN]\n0;0,5;1\n1;1,5;2\n2;2,5;3\n3;4,5;4\n".to_owned();
        let at = (0..=at.min(table.len())).rev().find(|&at| table.is_char_boundary(at)).unwrap_or(0);
        table.insert_str(at, &odd);
        let _ = read(&table, "");
    }
}

fn program(arguments: &[&str], folder: &Path) -> std::process::Output {
    let mut command = std::process::Command::new(env!("CARGO_BIN_EXE_springbed"));
    command.current_dir(env!("CARGO_MANIFEST_DIR")).args(["fit", "--quiet", "--out"]).arg(folder).args(arguments);
    command.output().unwrap()
}

/// The truth stands in configs/fit/make_data.py; five standard errors.
#[test]
fn the_data_that_come_with_it_give_back_what_made_them() {
    let folder = tempfile::tempdir().unwrap();
    let truths: [(&str, &[(&str, f64)]); 9] = [
        ("gel_sphere", &[("bodies.0.young", 2.4e3), ("contact_point", 1.3e-6)]),
        ("jkr_lens", &[("bodies.0.young", 4.8e6), ("adhesion.work", 0.042)]),
        ("cell_ting", &[("bodies.0.shear.equilibrium", 300.0), ("bodies.0.shear.terms.0.time", 0.2)]),
        ("cell_power_law", &[("bodies.0.shear.modulus", 800.0), ("bodies.0.shear.exponent", 0.2)]),
        ("cell_on_glass", &[("bodies.1.layers.0.body.young", 1.5e3), ("contact_point", 0.5e-6)]),
        ("fused_silica", &[("bodies.1.young", 72e9), ("contact_point", 12e-9)]),
        ("pdms_creep", &[("bodies.0.shear.equilibrium", 0.4e6), ("bodies.0.shear.terms.0.time", 2.0)]),
        ("steel_restitution", &[("bodies.0.yield_stress", 1.1e9)]),
        ("friction_loop", &[("friction.coefficient", 0.8), ("bodies.0.young", 2.2e6)]),
    ];
    for (name, truth) in truths {
        let output = program(&[&format!("configs/fit/{name}.ron")], folder.path());
        assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
        let text = std::fs::read_to_string(folder.path().join(format!("{name}.fit.json"))).unwrap();
        let json: serde_json::Value = serde_json::from_str(&text).unwrap();
        for (path, value) in truth {
            let found = json["parameters"].as_array().unwrap().iter().find(|one| one["path"] == *path).unwrap();
            let (is, error) = (found["value"].as_f64().unwrap(), found["standard_error"].as_f64().unwrap());
            assert!((is - value).abs() < 5.0 * error && error < 0.02 * value, "{name} {path} {is} ± {error}");
        }
        assert_eq!(json["rejected"], false, "{name}");
    }
    let output = program(&["--moduli", "configs/fit/rubber_moduli.csv"], folder.path());
    assert!(output.status.success() && folder.path().join("rubber_moduli.moduli.json").exists());
}

/// Every truth of a cell on glass, of fused silica, of steel that yields and of a friction loop, the baseline too, is inside
/// its interval.
#[test]
fn truths_are_inside_their_intervals() {
    let folder = tempfile::tempdir().unwrap();
    let truths: [(&str, &[(&str, f64)]); 4] = [
        ("cell_on_glass", &[("bodies.1.layers.0.body.young", 1.5e3), ("contact_point", 0.5e-6), ("baseline", 0.0)]),
        ("fused_silica", &[("bodies.1.young", 72e9), ("contact_point", 12e-9), ("baseline", 3e-6)]),
        ("steel_restitution", &[("bodies.0.yield_stress", 1.1e9)]),
        ("friction_loop", &[("friction.coefficient", 0.8), ("bodies.0.young", 2.2e6), ("baseline", 1e-3)]),
    ];
    for (name, truth) in truths {
        let output = program(&[&format!("configs/fit/{name}.ron"), "--json"], folder.path());
        let json: serde_json::Value = serde_json::from_slice(&output.stdout).unwrap();
        for &(path, value) in truth {
            let parameters = json["fits"][0]["parameters"].as_array().unwrap();
            let found = parameters.iter().find(|one| one["path"] == path).unwrap();
            let [low, high] = ["low", "high"].map(|end| found[end].as_f64().unwrap());
            assert!(low <= value && value <= high, "{name} {path} {value:e}: {low:e} … {high:e}");
        }
    }
}

/// A thin cell is no half-space: Hertz is told to be wrong, and is five times as stiff.
#[test]
fn hertz_is_rejected_on_glass() {
    let folder = tempfile::tempdir().unwrap();
    let scene = folder.path().join("hertz.ron");
    let text = r#"(shape: Paraboloid(radius: "5 um"), bodies: (Rigid, Elastic(young: "1 kPa", poisson: 0.5)),
        history: [Indent(to: "1.1 um", over: "1 s")], fit: (free: ["bodies.1.young=100 Pa..100 kPa"]))"#;
    std::fs::write(&scene, text).unwrap();
    let output = program(&[scene.to_str().unwrap(), "configs/fit/cell_on_glass.csv", "--json"], folder.path());
    let json: serde_json::Value = serde_json::from_slice(&output.stdout).unwrap();
    assert_eq!(json["fits"][0]["rejected"], true, "{json}");
    assert!(json["fits"][0]["parameters"][0]["value"].as_f64().unwrap() > 4.0 * 1.5e3);
}

/// What `springbed fit --moduli` says of a file that comes with it.
fn spectrum_of(name: &str, more: &[&str]) -> serde_json::Value {
    let folder = tempfile::tempdir().unwrap();
    let data = format!("configs/fit/{name}.csv");
    let output = program(&[&["--moduli", &data, "--json"], more].concat(), folder.path());
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    serde_json::from_slice(&output.stdout).unwrap()
}

/// Five terms with a per cent of noise are found as five, a decade apart, to a few per cent.
#[test]
fn the_fewest_terms_of_moduli() {
    let found = spectrum_of("rubber_moduli", &["--terms", "fewest"]);
    let terms = found["terms"].as_array().unwrap();
    assert_eq!(terms.len(), 5, "{found}");
    for (term, (modulus, time)) in
        terms.iter().zip([(40e6, 1e-4), (20e6, 1e-3), (8e6, 1e-2), (2e6, 1e-1), (0.5e6, 1.0)])
    {
        let near = |name: &str, right: f64| (term[name].as_f64().unwrap() / right - 1.0).abs() < 0.05;
        assert!(near("modulus", modulus) && near("time", time), "{term}");
    }
    assert_eq!(spectrum_of("rubber_moduli", &["--terms", "3"])["terms"].as_array().unwrap().len(), 3);
    // Terms are of moduli, not of curves.
    let output = program(&["configs/fit/gel_sphere.ron", "--terms", "3"], tempfile::tempdir().unwrap().path());
    assert_eq!(output.status.code(), Some(2));
}

/// At 303.15 K the law of C₁ = 8.86, C₂ = 101.6 K at 300 K has C₂ = 104.75 K and C₁ = 8.86·101.6/104.75.
#[test]
fn moduli_of_several_temperatures_make_one_curve() {
    let found = spectrum_of("polymer_temperatures", &["--reference", "30 degC"]);
    let master = &found["master"];
    assert!((master["reference_k"].as_f64().unwrap() - 303.15).abs() < 1e-9);
    for shift in master["shifts"].as_array().unwrap() {
        let by = shift["temperature_k"].as_f64().unwrap() - 303.15;
        let law = -8.86 * 101.6 / 104.75 * by / (104.75 + by);
        assert!((shift["log10_shift"].as_f64().unwrap() - law).abs() < 0.03, "{shift} {law}");
    }
    let (c1, c2) = (master["wlf_c1"].as_f64().unwrap(), master["wlf_c2_k"].as_f64().unwrap());
    assert!((c1 / (8.86 * 101.6 / 104.75) - 1.0).abs() < 0.1 && (c2 / 104.75 - 1.0).abs() < 0.1, "{c1} {c2}");
}

#[test]
fn a_bad_curve_is_not_in_the_way_of_the_rest() {
    let folder = tempfile::tempdir().unwrap();
    let bad = folder.path().join("bad.csv");
    std::fs::write(&bad, "z [nm],F [nN]\n0,1\n1,NaN\n2,1\n").unwrap();
    let out = folder.path().join("out");
    let output = program(&["configs/fit/gel_sphere.ron", bad.to_str().unwrap(), "configs/fit/gel_sphere.csv"], &out);
    let said = String::from_utf8_lossy(&output.stderr).into_owned();
    assert_eq!(output.status.code(), Some(1), "{said}");
    assert!(said.contains("bad.csv: row 3: F: \"NaN\" is not finite"), "{said}");
    let table = std::fs::read_to_string(out.join("fits.csv")).unwrap();
    let lines: Vec<&str> = table.lines().collect();
    assert!(lines[0].starts_with("file,bodies.0.young,bodies.0.young.error,bodies.0.young.low,bodies.0.young.high"));
    assert!(lines.len() == 3 && lines[1].contains("not fitted") && lines[2].contains("gel_sphere.csv,2"), "{table}");
    assert!(out.join("gel_sphere.fit.json").exists() && !out.join("bad.fit.json").exists());
    // No data and no parameter is wrong usage.
    let output = program(&["configs/hertz.ron"], &out);
    assert_eq!(output.status.code(), Some(2));
}
