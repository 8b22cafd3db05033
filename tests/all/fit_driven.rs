//! Fits of restitution over speed and of friction loops: recovery of what made the data, wrong models noticed, bad data
//! refused with their row.

use super::fit::{Noise, scene};
use springbed::app::data_file::{Data, Wanted};
use springbed::fit::{Curve, Fit, FitError, Options, Question, Readings};
use springbed::prelude::*;
use springbed::run::Wanted as Recorded;
use springbed::scene::fit::{Baseline, Drive};
use std::path::Path;

fn fit(text: &str, free: &[&str], curve: &Curve) -> Result<Fit, FitError> {
    Question::new(&scene(text), free, Options::default())?.fit(curve, &InMemory::default())
}

fn near(fit: &Fit, path: &str, truth: f64, bound: f64) {
    let value = fit.parameter(path).unwrap().value;
    assert!((value / truth - 1.0).abs() < bound, "{path} {value} {truth} {:?}", fit.notes);
}

fn impacts(speed: Vec<f64>, restitution: Vec<f64>) -> Curve {
    Curve { rows: (2..speed.len() + 2).collect(), time: None, readings: Readings::Impacts { speed, restitution } }
}

fn speeds(low: f64, high: f64, count: u32) -> Vec<f64> {
    (0..count).map(|k| low * (high / low).powf(f64::from(k) / f64::from(count - 1))).collect()
}

/// The restitutions of a scene at its own speeds, through its own run.
fn bounced(text: &str, speed: &[f64]) -> Curve {
    let listed = text.replace("SPEEDS", &format!("{speed:?}"));
    let plan = Notation::Ron.plan(&listed, &InMemory::default()).unwrap();
    let outcome = run(&plan, Recorded::NOTHING).unwrap();
    let column = outcome.table("impacts").unwrap().column("restitution").unwrap().numbers().to_vec();
    impacts(speed.to_vec(), column.into_iter().flatten().collect())
}

const STEEL: &str = r#"(shape: Paraboloid(radius: 5e-3), bodies: (Plastic(young: 210e9, poisson: 0.3, yield_stress: 0.7e9),
    Elastic(young: 650e9, poisson: 0.22)), history: [Impact(mass: 4.084e-3, speed: 1)])"#;

/// Thornton (1997), written out: e over s = v_y/v, v_y in proportion to Y^{5/2}.
fn thornton(speed: &[f64], yield_stress: f64) -> Vec<f64> {
    let (radius, mass) = (5e-3f64, 4.084e-3f64);
    let modulus = ((1.0 - 0.09) / 210e9 + (1.0 - 0.0484) / 650e9f64).recip();
    let first = (std::f64::consts::PI / (2.0 * modulus)).powi(2)
        * (8.0 * std::f64::consts::PI * radius.powi(3) / (15.0 * mass)).sqrt()
        * (1.6 * yield_stress).powf(2.5);
    let one = |v: &f64| {
        let s = (first / v).min(1.0);
        let slope = s / (s + 2.0 * (1.2 - 0.2 * s * s).sqrt());
        (1.2 * 3f64.sqrt() * (1.0 - s * s / 6.0)).sqrt() * slope.powf(0.25)
    };
    speed.iter().map(|v| if *v <= first { 1.0 } else { one(v) }).collect()
}

#[test]
fn a_yield_stress_is_recovered_from_restitution() {
    let speed = speeds(0.05, 8.0, 20);
    let data = impacts(speed.clone(), thornton(&speed, 1.1e9));
    let found = fit(STEEL, &["bodies.0.yield_stress=0.1 GPa..5 GPa"], &data).unwrap();
    near(&found, "bodies.0.yield_stress", 1.1e9, 1e-6);
    assert!(!found.rejected && found.led == Drive::Speed, "{:?}", found.notes);
    assert_eq!(found.parameters.len(), 1);
}

/// e² = 1 − (v_s/v)², ½mv_s² = 7.09 (w⁵R⁴/E*²)^{1/3} (Johnson & Pollock 1994): the loss tells w⁵/E*² and no more.
#[test]
fn a_work_of_adhesion_is_recovered_from_restitution() {
    let text = r#"(shape: Paraboloid(radius: 10e-6), bodies: (Elastic(young: 70e9, poisson: 0.17), Rigid),
        adhesion: Jkr(work: WORK), history: [Impact(mass: 9e-12, speed: SPEEDS)])"#;
    let (start, free) = (text.replace("WORK", "0.03").replace("SPEEDS", "1"), ["adhesion.work=1e-3..10"]);
    let data = bounced(&text.replace("WORK", "0.1"), &speeds(3e-3, 0.1, 12));
    near(&fit(&start, &free, &data).unwrap(), "adhesion.work", 0.1, 1e-6);
    let modulus = 70e9 / (1.0 - 0.17f64.powi(2));
    let lost = 7.09 * (0.1f64.powi(5) * 10e-6f64.powi(4) / modulus.powi(2)).cbrt();
    let least = (2.0 * lost / 9e-12).sqrt();
    let speed = speeds(1.2 * least, 10.0 * least, 12);
    let published = speed.iter().map(|v| (1.0 - (least / v).powi(2)).sqrt()).collect();
    near(&fit(&start, &free, &impacts(speed, published)).unwrap(), "adhesion.work", 0.1, 1e-3);
    let both = fit(&start, &["adhesion.work=1e-3..10", "bodies.0.young=1e9..1e12"], &data).unwrap();
    assert!(
        both.notes.iter().any(|note| note.contains("cannot tell") || note.contains("hardly told apart")),
        "{:?}",
        both.notes
    );
}

const RUBBER: &str = r#"(shape: Paraboloid(radius: 10e-3), bodies: (Viscoelastic(poisson: 0.5, shear: (equilibrium: 1e6,
    terms: [(modulus: MODULUS, time: TIME)])), Rigid), history: [Impact(mass: 4.6e-3, speed: SPEEDS)])"#;

#[test]
fn a_relaxation_is_recovered_from_restitution() {
    let data = bounced(&RUBBER.replace("MODULUS", "3e6").replace("TIME", "0.4e-3"), &speeds(1e-3, 0.5, 10));
    let start = RUBBER.replace("MODULUS", "1e6").replace("TIME", "1e-3").replace("SPEEDS", "1");
    let term = "bodies.0.shear.terms.0";
    let free = [format!("{term}.modulus=1e5..1e8"), format!("{term}.time=1e-5..1e-1")];
    let found = fit(&start, &[&free[0], &free[1]], &data).unwrap();
    near(&found, &format!("{term}.modulus"), 3e6, 1e-6);
    near(&found, &format!("{term}.time"), 0.4e-3, 1e-6);
}

/// What rubber leaves of speed is not what steel leaves; what scatters without a shape is.
#[test]
fn a_wrong_model_of_restitution_is_noticed() {
    let bounced = bounced(&RUBBER.replace("MODULUS", "3e6").replace("TIME", "0.4e-3"), &speeds(1e-3, 0.5, 40));
    let free = ["bodies.0.yield_stress=1e3..5 GPa"];
    let mut noise = Noise::new(4, 0.0);
    let mut noisy = |data: &Curve| {
        let answers = data.answered(Drive::Speed).iter().map(|e| e + 0.01 * noise.next()).collect();
        data.answering(Drive::Speed, answers)
    };
    let wrong = fit(STEEL, &free, &noisy(&bounced)).unwrap();
    assert!(wrong.rejected && wrong.notes.iter().any(|note| note.contains("speak against")), "{:?}", wrong.notes);
    let speed = speeds(0.05, 8.0, 40);
    let clean = impacts(speed.clone(), thornton(&speed, 1.1e9));
    for _ in 0..40 {
        let right = fit(STEEL, &free, &noisy(&clean)).unwrap();
        assert!(!right.rejected, "{:?}", right.notes);
    }
}

const LENS: &str = r#"(shape: Paraboloid(radius: 5e-3), bodies: (Elastic(young: 1e6, poisson: 0.5), Rigid),
    friction: Coulomb(coefficient: 0.5), history: [PRESSED, Shake(amplitude: 26e-6, frequency: 0.1, cycles: 1.25)])"#;
const LENS_FREE: [&str; 2] = ["friction.coefficient=0.05..3", "bodies.0.young=1e5..2e7"];

/// Cattaneo and Mindlin: there, back and there again between ±0.7 of the slide at which all slips.
fn mindlin(points: u32, (coefficient, young): (f64, f64), depth: f64) -> (Vec<f64>, Vec<f64>) {
    let load = 4.0 / 3.0 * young / 0.75 * (5e-3 * depth.powi(3)).sqrt();
    let all = coefficient * 1.5 * depth;
    let branch =
        |way: f64, scale: f64| scale * coefficient * load * (1.0 - (1.0 - way / (scale * all)).max(0.0).powf(1.5));
    let (top, part) = (0.7 * all, |k: u32| f64::from(k) / f64::from(points));
    let turn = branch(top, 1.0);
    let first = (0..points).map(|k| (top * part(k), branch(top * part(k), 1.0)));
    let back = (0..points).map(|k| (top - 2.0 * top * part(k), turn - branch(2.0 * top * part(k), 2.0)));
    let again = (0..=points).map(|k| (2.0 * top * part(k) - top, branch(2.0 * top * part(k), 2.0) - turn));
    first.chain(back).chain(again).unzip()
}

fn slides(slide: Vec<f64>, force: Vec<f64>) -> Curve {
    Curve { rows: (2..slide.len() + 2).collect(), time: None, readings: Readings::Slides { slide, force } }
}

/// Under a force and at a depth; the zero of the slides and that of the forces are the instrument's own.
#[test]
fn a_friction_loop_is_recovered() {
    let (truth, depth) = ((0.8, 2.2e6), 30e-6f64);
    let load = 4.0 / 3.0 * truth.1 / 0.75 * (5e-3 * depth.powi(3)).sqrt();
    let (slide, force) = mindlin(80, truth, depth);
    let moved = slide.iter().map(|slide| slide + 0.1).collect();
    let data = slides(moved, force.iter().map(|force| force + 1e-3).collect());
    for pressed in [format!("Press(to: {load:?}, over: 1)"), format!("Indent(to: {depth:?}, over: 1)")] {
        let found = fit(&LENS.replace("PRESSED", &pressed), &LENS_FREE, &data).unwrap();
        near(&found, "friction.coefficient", truth.0, 1e-6);
        near(&found, "bodies.0.young", truth.1, 1e-6);
        near(&found, "baseline", 1e-3, 1e-6);
        assert!(found.led == Drive::Slide && found.notes.is_empty(), "{:?}", found.notes);
    }
}

/// A spring with a slider in series, of one stiffness until all slips at once, is no ball.
#[test]
fn a_wrong_friction_loop_is_noticed() {
    let (slide, _) = mindlin(80, (0.8, 2.2e6), 30e-6);
    let mut held = 0.0f64;
    let mut before = 0.0;
    let mut noise = Noise::new(6, 0.0);
    let slider = |slide: &f64| {
        held = (held + 2e3 * (slide - before)).clamp(-0.04, 0.04);
        before = *slide;
        held + 2e-4 * noise.next()
    };
    let data = slides(slide.clone(), slide.iter().map(slider).collect());
    let found = fit(&LENS.replace("PRESSED", "Press(to: 50e-3, over: 1)"), &LENS_FREE, &data).unwrap();
    assert!(found.notes.iter().any(|note| note.contains("neighbouring residuals are alike")), "{:?}", found.notes);
}

#[test]
fn wrong_questions_of_impacts_and_slides_are_refused() {
    let refused = |text: &str, free: &str, curve: &Curve, options: Options| {
        let asked = Question::new(&scene(text), &[free], options);
        asked.and_then(|asked| asked.fit(curve, &InMemory::default())).unwrap_err().to_string()
    };
    let (plain, speed) = (Options::default(), speeds(0.1, 1.0, 10));
    let bounced = impacts(speed.clone(), vec![0.8; 10]);
    let depths = Curve::of_depths(vec![1e-6; 10], vec![1e-9; 10]);
    let yields = "bodies.0.yield_stress";
    assert!(refused(STEEL, yields, &depths, plain).contains("are depths and forces: expected speeds and restitutions"));
    let linear = Options { baseline: Baseline::Linear, ..plain };
    assert!(refused(STEEL, yields, &bounced, linear).contains("a restitution has no baseline"));
    let by_depth = Options { drive: Some(Drive::Depth), ..plain };
    assert!(refused(STEEL, yields, &bounced, by_depth).contains("expected drive: Speed"));
    let lens = LENS.replace("PRESSED", "Press(to: 50e-3, over: 1)");
    let by_speed = Options { drive: Some(Drive::Speed), ..plain };
    assert!(refused(&lens, LENS_FREE[0], &bounced, by_speed).contains("expected history: [Impact"));
    let standing = impacts([vec![0.0], speed[1..].to_vec()].concat(), vec![0.8; 10]);
    assert!(refused(STEEL, yields, &standing, plain).contains("not above zero"));
    let mixed = LENS.replace("PRESSED", "Press(to: 50e-3, over: 1), Hold(over: 1)");
    let (slide, force) = mindlin(10, (0.8, 2.2e6), 30e-6);
    assert!(refused(&mixed, LENS_FREE[0], &slides(slide, force), plain).contains("expected Indent or Press"));
}

fn read(text: &str, columns: &str, led: Drive) -> Result<Curve, String> {
    let wanted = Wanted::read(columns, None)?.led_by(led);
    let data = Data::parse(Path::new("x.csv"), text, &wanted).map_err(|fault| fault.message)?;
    data.curve().map_err(|fault| fault.message)
}

#[test]
fn tables_of_impacts_and_slides_are_read() {
    let second = |text: &str, columns: &str, led: Drive| {
        let curve = read(text, columns, led).unwrap();
        curve.readings.both().map(|column| column[1])
    };
    for (text, columns) in [
        ("speed [mm/s],restitution\n100,0.9\n200,0.8\n", ""),
        ("speed_m_per_s,restitution\n0.1,0.9\n0.2,0.8\n", ""),
        ("V (m/s);COR (%)\n0,1;90\n0,2;80\n", ""),
        ("a b\n0.1 90\n0.2 80\n", "speed=a [m/s], restitution=b [%]"),
    ] {
        let [speed, restitution] = second(text, columns, Drive::Speed);
        assert_eq!((speed, restitution), (0.2, 0.8), "{text}");
    }
    for (text, columns) in [
        ("x [um],Fx [mN]\n0,0\n2,3\n", ""),
        ("slide_m,tangential_force_n,force_n\n0,0,1\n2e-6,3e-3,1\n", ""),
        ("t [s];Weg (µm);Reibkraft (mN)\n0;0;0\n0,1;2,0;3,0\n", ""),
        ("0 0\n2 -3\n", "slide=1 [um], tangential=-2 [mN]"),
    ] {
        let [slide, force] = second(text, columns, Drive::Slide);
        assert!((slide / 2e-6 - 1.0).abs() < 1e-12 && (force / 3e-3 - 1.0).abs() < 1e-12, "{text}");
    }
}

#[test]
fn bad_tables_of_impacts_and_slides_are_refused_with_their_row() {
    let refused = |text: &str, led: Drive| read(text, "", led).unwrap_err();
    let speed = |text: &str| refused(text, Drive::Speed);
    assert!(speed("v [m/s],e\n1,0.8\n0,0.9\n").contains("row 3: the speed is 0.0 m/s: expected one above zero"));
    assert!(speed("v [m/s],e\n1,80\n2,70\n").contains("row 2: the restitution is 80.0: expected one from 0 to 1"));
    assert!(speed("v [m/s],F\n1,80\n2,70\n").contains("no column of restitutions (found: speed)"));
    assert!(speed("z [nm],F [nN]\n1,80\n2,70\n").contains("no column of speeds"));
    assert!(speed("v [m/s],e\n1,0.8\n2,0.75\n3,NaN\n4,0.7\n").contains("row 4: e: \"NaN\" is not finite"));
    let slide = |text: &str| refused(text, Drive::Slide);
    assert!(slide("x [um],F [mN]\n1,2\n2,3\n").contains("no column of tangential forces (found: slide)"));
    assert!(slide("t [s],x [um],Fx [mN]\n0,1,2\n0,2,3\n").contains("row 3: the time goes from 0.0 s to 0.0 s"));
}
