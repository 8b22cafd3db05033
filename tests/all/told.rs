//! What a scene is told beside its records: named results, warnings, refusals on the way.

use springbed::check::matrix::{Variation, cells};
use springbed::contact::elliptic::EllipticHertz;
use springbed::input::table::InMemory;
use springbed::run::record::{Outcome, Record};
use springbed::run::{self, SimulationError, Wanted};
use springbed::scene::Scene;
use std::f64::consts::PI;

fn tried(text: &str) -> Result<Outcome, SimulationError> {
    let plan = Scene::from_ron(text).unwrap().resolve(&InMemory::default()).unwrap();
    run::run(&plan, Wanted { fields: true, ..Wanted::NOTHING })
}

/// A paraboloid of 5 mm on rubber of E* = 8/3 MPa, with `parts` and the history `entries`.
fn on_rubber(parts: &str, entries: &str) -> Outcome {
    let text = format!(
        "(shape: Paraboloid(radius: \"5 mm\"), bodies: (Elastic(young: \"2 MPa\", poisson: 0.5), Rigid), {parts} \
         history: [{entries}])"
    );
    tried(&text).unwrap()
}

const JKR: &str = "adhesion: Jkr(work: 0.05),";

/// JKR: the edge jumps in under −(4/3)πwR at d = 0 and is pulled off under −(3/2)πwR, if it is.
#[test]
fn a_pull_off_is_told_only_where_something_is_pulled_off() {
    let scale = -PI * 0.05 * 5e-3;
    let near = |found: Option<f64>, right: f64| found.is_some_and(|found| (found / right - 1.0).abs() < 1e-4);
    let pressed = on_rubber(JKR, "Indent(to: 1e-5, over: 1)");
    assert!(near(pressed.number("jump_in_force_n"), 4.0 / 3.0 * scale), "{:?}", pressed.results);
    assert_eq!(pressed.number("pull_off_force_n"), None);
    let eased = on_rubber(JKR, "Indent(to: 1e-5, over: 1), Indent(to: 2e-6, over: 1)");
    assert_eq!(eased.number("pull_off_force_n"), None, "a pull that is still growing is no pull-off");
    for way_out in ["Retract(speed: 1e-6)", "Indent(to: -1e-5, over: 1)", "Press(to: -1, over: 1)"] {
        let parted = on_rubber(JKR, &format!("Indent(to: 1e-5, over: 1), {way_out}"));
        let found = parted.number("pull_off_force_n");
        assert!(near(found, 1.5 * scale), "{way_out}: {found:?}, not {}", 1.5 * scale);
    }
}

/// Patches of a rough line that join one after the other pull as they do; that is no pull-off until some let go.
#[test]
fn patches_that_join_pull_nothing_off() {
    let told = |entries: &str| {
        let text = format!(
            "(shape: RoughLine(spectrum: SelfAffine(hurst: 0.8, rms: 3.2e-8, long: 3.2e-6, short: 6.4e-8), length: 3.2e-6,              points: 512), bodies: (Elastic(young: 1e11, poisson: 0.5), Rigid), adhesion: Jkr(work: 11), steps: 4,              history: [{entries}])"
        );
        tried(&text).unwrap().number("pull_off_force_n")
    };
    let inwards = "Indent(to: 5e-9, over: 1), Indent(to: 1.2e-8, over: 1)";
    assert_eq!(told(inwards), None);
    assert!(told(&format!("{inwards}, Indent(to: -2e-8, over: 1)")).is_some_and(|force| force < -1e-5));
}

/// A liquid drawn out at a speed pulls as hard all the way, to rounding, whatever its records: nothing is pulled off.
#[test]
fn a_pull_that_stays_is_no_pull_off() {
    let liquid = "Viscoelastic(poisson: 0.5, shear: (equilibrium: 0, terms: [(modulus: 1e10, time: 6e-5)]))";
    for steps in 3..20 {
        let text = format!(
            "(shape: PlaneWave(amplitude: 3e-8, wavelength: 3e-7), bodies: ({liquid}, Rigid), adhesion: Jkr(work: 0.06, \
             edge: Instantaneous), steps: {steps}, history: [Indent(to: 1e-9, over: 3e-3), Hold(over: 0.03), \
             Indent(to: 7e-10, over: 0.02)])"
        );
        let outcome = tried(&text).unwrap();
        assert!(outcome.number("final_force_n").unwrap() < -1e-2, "{steps}: {:?}", outcome.results);
        assert_eq!(outcome.number("pull_off_force_n"), None, "{steps}");
    }
}

/// The pull of JKR is told however small it is beside what pressed the bodies, and however few records there are: on the way
/// out, from a table, and of impacts on elastic bodies and on those of which next to nothing relaxes. Bound: the
/// accuracy.
#[test]
fn a_small_pull_is_told_by_few_records() {
    let body = "Viscoelastic(poisson: 0.5, shear: (equilibrium: 1e6, terms: [(modulus: 1e-4, time: 1e-3)]))";
    let scene = |body: &str, adhesion: &str, entries: &str| {
        let text = format!(
            "(shape: Paraboloid(radius: 5e-3), bodies: ({body}, Rigid), adhesion: Jkr(work: 1e-5{adhesion}), steps: 2, \
             accuracy: 1e-6, history: [{entries}])"
        );
        let rows: [(&str, &[f64]); 2] = [("time_s", &[0.0, 1.0, 9.0]), ("indentation_m", &[0.0, 1e-4, -3e-5])];
        let plan = Scene::from_ron(&text).unwrap().resolve(&InMemory::default().with("way.csv", &rows)).unwrap();
        run::run(&plan, Wanted::NOTHING).unwrap().number("pull_off_force_n").unwrap()
    };
    let (relaxed, elastic) = (", edge: Relaxed", "Elastic(young: 3e6, poisson: 0.5)");
    let found = [
        scene(body, relaxed, "Indent(to: 1e-4, over: 1), Indent(to: -3e-5, over: 8)"),
        scene(body, relaxed, "Table(\"way.csv\")"),
        scene(body, relaxed, "Impact(mass: 1e-3, speed: 0.01)"),
        scene(elastic, "", "Impact(mass: 1e-3, speed: 0.01)"),
    ];
    for pull in found {
        assert!((pull / (-1.5 * PI * 1e-5 * 5e-3) - 1.0).abs() < 1e-6, "{found:?}");
    }
}

/// What lying bodies that relax still store as a mass leaves them is the same in other units, by whose rounding the last of their
/// springs are pressed or let go there: two scenes of the matrix that told up to a sixth of it twice.
#[test]
fn what_is_stored_as_a_mass_leaves_has_no_units() {
    let found = [("plane wave", "viscoelastic", 1_522_618), ("lying cylinder", "two viscoelastic", 1_516_255)];
    let cells = cells();
    for (shape, bodies, number) in found {
        let cell = cells.iter().find(|cell| cell.names() == [shape, bodies, "none", "none", "impact"]).unwrap();
        let (variation, part) = Variation::numbered(number);
        let kept = cell.laws(&variation, part);
        assert!(kept.len() == 4 && kept.iter().all(|kept| kept.failure.is_none()), "{kept:?}");
    }
}

/// Where bodies with a pinned edge part the record before tells the last pull, and not once more that there is none.
#[test]
fn the_record_before_a_parting_still_touches() {
    for accuracy in ["1e-3", "1e-4", "1e-5"] {
        let parted = tried(&format!(
            "(shape: Cylinder(radius: 1.5811388300841897e-3, datum: 3.1622776601683794e-3, width: 3.1622776601683794e-3), \
             bodies: (Elastic(young: 1.1246826503806982e11, poisson: 0.5), Rigid), \
             adhesion: Jkr(work: 1.1246826503806984, closing: 0.5623413251903492), steps: 4, accuracy: {accuracy}, history: \
             [Press(to: 316.22776601683796, over: 1.778279410038923e-4), \
             Indent(to: -3.556558820077846e-7, over: 1.778279410038923e-4)])"
        ))
        .unwrap();
        let touches = |record: &Record| record.normal.contact_radius.is_some_and(|radius| radius > 0.0);
        let pairs = || parted.records.windows(2).filter(|pair| pair[1].time - pair[0].time <= 1e-12 * pair[1].time);
        assert!(pairs().count() == 1 && pairs().all(|pair| touches(&pair[0]) && !touches(&pair[1])), "{accuracy}");
    }
}

/// The pull on a body that relaxes within a row of a table turns right behind the beginning of the row or before its end, and
/// is told as of rows a hundred times shorter. Bound: the accuracy.
#[test]
fn a_pull_that_turns_within_a_row_is_told() {
    let body = "Viscoelastic(poisson: 0.5, shear: (equilibrium: 1e4, terms: [(modulus: 3e3, time: 3e-8), (modulus: 6e3, \
                time: 3e-4)]))";
    let pulled = |edge: &str, over: f64, parts: u32| {
        let text = format!(
            "(shape: Paraboloid(radius: 5e-3), bodies: ({body}, Rigid), adhesion: Jkr(work: 1e-6, edge: {edge}), \
             steps: 2, accuracy: 1e-4, history: [Table(\"way.csv\")])"
        );
        let (mut times, mut depths) = (vec![0.0, 1e-5], vec![0.0, 9e-7]);
        for part in (1..=parts).map(|part| f64::from(part) / f64::from(parts)) {
            times.push(1e-5 + over * part);
            depths.push(9e-7 - 1.2e-6 * part);
        }
        let rows: [(&str, &[f64]); 2] = [("time_s", &times), ("indentation_m", &depths)];
        let plan = Scene::from_ron(&text).unwrap().resolve(&InMemory::default().with("way.csv", &rows)).unwrap();
        run::run(&plan, Wanted::NOTHING).unwrap().number("pull_off_force_n").unwrap()
    };
    for (edge, over) in [("Instantaneous", 1e-7), ("Relaxed", 3e-8), ("Relaxed", 1e-4)] {
        let [one, many] = [1, 100].map(|parts| pulled(edge, over, parts));
        assert!(one < 0.0 && (one / many - 1.0).abs() < 1e-4, "{edge} {over:e}: {one:e} {many:e}");
    }
}

/// The pull that a mass passes just before or after a step of its motion ends is told as that of the same impact on an
/// elastic body, to what the speeds of the steps leave of it.
#[test]
fn a_pull_that_turns_between_steps_of_an_impact_is_told() {
    let pulled = |body: &str, edge: &str, speed: f64| {
        let text = format!(
            "(shape: PlaneWave(amplitude: 1e-5, wavelength: 1e-4), bodies: ({body}, Rigid), adhesion: Jkr(work: 2{edge}), \
             steps: 4, accuracy: 1e-3, history: [Impact(mass: 5.6e-6, speed: {speed})])"
        );
        tried(&text).unwrap().number("pull_off_force_n").unwrap()
    };
    let relaxing = "Viscoelastic(poisson: 0.5, shear: (equilibrium: 2.8e9, terms: [(modulus: 0.28, time: 1e-3)]))";
    for percent in 100..140 {
        let speed = 0.08 * f64::from(percent);
        let elastic = pulled("Elastic(young: 8.4e9, poisson: 0.5)", "", speed);
        let found = pulled(relaxing, ", edge: Instantaneous", speed);
        assert!((found / elastic - 1.0).abs() < 1e-6, "{speed}: {found:e}, not {elastic:e}");
    }
}

/// A pull that turns soon after a long way out begins is told as on a shorter one. Bound: the accuracy.
#[test]
fn a_pull_that_turns_early_is_told() {
    let body = "Viscoelastic(poisson: 0.5, shear: (equilibrium: 2.8e5, terms: [(modulus: 1e5, time: 1e5)]))";
    let pulled = |parts: u32| {
        let text = format!(
            "(shape: Paraboloid(radius: 2), bodies: ({body}, Rigid), adhesion: Jkr(work: 6e-7, edge: Relaxed), steps: 2, \
             accuracy: 1e-4, history: [Indent(to: 0, over: 1e6), Indent(to: -{}e-8, over: {parts}e4)])",
            3 * parts
        );
        tried(&text).unwrap().number("pull_off_force_n").unwrap()
    };
    let least = pulled(1);
    for parts in 2..300 {
        let found = pulled(parts);
        assert!(least < 0.0 && (found / least - 1.0).abs() < 1e-4, "{parts}: {found:e} {least:e}");
    }
}

/// A pull at an edge with a rate that turns before a row ends, and not in the next, is told. Bound: the accuracy.
#[test]
fn a_pull_that_turns_late_in_a_row_is_told() {
    let body = "Viscoelastic(poisson: 0.5, shear: (equilibrium: 5.6e8, terms: [(modulus: 3.2e7, time: 5600), (modulus: 1e9, \
                time: 56)]))";
    let other = "Elastic(young: 1.1e9, poisson: 0.5)";
    let pulled = |end: f64| {
        let text = format!(
            "(shape: WavyParaboloid(radius: 2e-4, amplitude: 1e-10, wavelength: 1e-6), bodies: ({body}, {other}), \
             adhesion: Jkr(work: 1.1e-2, edge: Rate(speed: 1e-9, exponent: 0.5)), steps: 2, accuracy: 1e-3, history: [Table(\"way.csv\")])"
        );
        let out = -end * 1.7e-8;
        let rows: [(&str, &[f64]); 2] =
            [("time_s", &[0.0, 1.8e5, 1.8e5 + end * 1.8e4, 1.98e5]), ("indentation_m", &[0.0, 0.0, out, -1.7e-8])];
        let plan = Scene::from_ron(&text).unwrap().resolve(&InMemory::default().with("way.csv", &rows)).unwrap();
        run::run(&plan, Wanted::NOTHING).unwrap().number("pull_off_force_n").unwrap()
    };
    let least = pulled(0.9);
    for percent in 20..50 {
        let found = pulled(0.01 * f64::from(percent));
        assert!(least < 0.0 && (found / least - 1.0).abs() < 1e-3, "{percent}: {found:e} {least:e}");
    }
}

/// Turned round, a dashpot has the force turn twice before the pull of an edge with a rate does, all in one row: the pull is told.
/// Bound: the accuracy.
#[test]
fn a_pull_behind_other_turns_is_told() {
    let scene = |history: &str| {
        format!(
            "(shape: Paraboloid(radius: 1.1e-3), bodies: (Viscoelastic(poisson: 0.5, shear: (equilibrium: 3e6, viscosity: 6e7)), \
             Rigid), adhesion: Jkr(work: 1.1e-6, edge: Rate(speed: 5.6e-8, exponent: 0.5)), steps: 40, accuracy: 1e-3, \
             history: [{history}])"
        )
    };
    let rows: [(&str, &[f64]); 2] =
        [("time_s", &[0.0, 56.0, 66.0, 122.0]), ("indentation_m", &[0.0, 1e-8, 1e-8, -5.3e-9])];
    let pulled = |history: &str| {
        let tables = InMemory::default().with("way.csv", &rows);
        let plan = Scene::from_ron(&scene(history)).unwrap().resolve(&tables).unwrap();
        let outcome = run::run(&plan, Wanted::NOTHING).unwrap();
        (outcome.number("pull_off_force_n").unwrap(), outcome.number("largest_force_n").unwrap())
    };
    let (told, largest) = pulled("Table(\"way.csv\")");
    let (exact, _) = pulled("Indent(to: 1e-8, over: 56), Hold(over: 10), Indent(to: -5.3e-9, over: 56)");
    assert!(exact < -1e-3 * largest, "{exact:e} {largest:e}");
    assert!((told - exact).abs() < 1e-3 * exact.abs(), "{told:e} {exact:e}");
}

/// An edge with a rate is as good as the accuracy asked for up to where it gives way, and says what it misses.
#[test]
fn an_edge_with_a_rate_keeps_its_accuracy() {
    let followed = |accuracy: f64| {
        let text = format!(
            "(shape: Paraboloid(radius: 5e-3), bodies: (Viscoelastic(poisson: 0.5, shear: (equilibrium: 3e5, \
             terms: [(modulus: 5e5, time: 0.1), (modulus: 2e5, time: 3)])), Rigid), \
             adhesion: Jkr(work: 0.05, edge: Rate(speed: 1e-5, exponent: 0.5)), steps: 20, accuracy: {accuracy:e}, \
             history: [Indent(to: 1e-5, over: 1), Hold(over: 3), Indent(to: -4e-6, over: 0.2), Indent(to: 5e-6, over: 0.5), \
             Indent(to: -4e-6, over: 1)])"
        );
        tried(&text).unwrap()
    };
    let fine = followed(1e-7);
    let largest = fine.records.iter().map(|record| record.normal.force.abs()).fold(0.0, f64::max);
    for accuracy in [1e-2, 1e-3, 1e-4] {
        let usual = followed(accuracy);
        let at = |time: f64| fine.records.iter().find(|record| (record.time - time).abs() <= 1e-12);
        let pairs: Vec<_> = usual.records.iter().filter_map(|one| at(one.time).map(|two| (one, two))).collect();
        assert!(pairs.len() > 100, "{}", pairs.len());
        let offs = pairs.iter().map(|(one, two)| (one.normal.force - two.normal.force).abs());
        let off = offs.fold(0.0, f64::max) / largest;
        assert!(
            off < accuracy && off < usual.error_estimate.relative,
            "{accuracy:e}: {off:e} {:?}",
            usual.error_estimate
        );
    }
}

/// A mass that lies on a liquid which relaxes before the next spring is met tells what its force is off by: that of a part of
/// a spring, which no shorter step would show.
#[test]
fn a_fall_on_a_liquid_tells_its_springs() {
    let fallen = |accuracy: &str| {
        let body = "Viscoelastic(poisson: 0.5, shear: (equilibrium: 0, terms: [(modulus: 2e7, time: 1e-5), \
                    (modulus: 6e8, time: 3e-7)]))";
        let text = format!(
            "(shape: Paraboloid(radius: 1.6e-4), bodies: ({body}, Elastic(young: 1e8, poisson: 0.5)), \
             machine: (mass: 3e-6), steps: 4, accuracy: {accuracy}, history: [Fall(height: 1e-5, over: 2e-2)])"
        );
        tried(&text).unwrap()
    };
    let (usual, fine) = (fallen("1e-3"), fallen("1e-5"));
    let pairs = usual.records.iter().zip(&fine.records);
    let off = pairs.map(|(one, two)| (one.normal.force - two.normal.force).abs()).fold(0.0, f64::max);
    let weight = 3e-6 * 9.806_65;
    assert!(
        off > 1.1e-3 * weight && off < usual.error_estimate.relative * weight,
        "{off:e} {:?}",
        usual.error_estimate
    );
}

/// Under a force the bodies part where it passes −(3/2)πwR, not at the record after.
#[test]
fn the_warning_of_a_pull_off_tells_its_instant() {
    let parted = on_rubber(JKR, "Press(to: 5e-3, over: 1), Press(to: -7e-3, over: 1)");
    let instant = 1.0 + (5e-3 + 1.5 * PI * 0.05 * 5e-3) / 12e-3;
    let warning = parted.warnings.iter().find(|warning| warning.contains("passes pull-off at t = ")).unwrap();
    let told = warning.split("t = ").nth(1).and_then(|rest| rest.split(' ').next()).unwrap();
    assert!((told.parse::<f64>().unwrap() / instant - 1.0).abs() < 1e-9, "{warning}: {instant}");
}

/// A pull quicker than the relaxation tears an edge that holds by E∞ off with less than the work of adhesion; one that holds by
/// E(0), or a slow pull, pays all of it.
#[test]
fn heat_that_is_taken_back_is_told() {
    let pulled = |edge: &str, speed: f64| {
        let body = "Viscoelastic(poisson: 0.5, shear: (equilibrium: 3e5, terms: [(modulus: 1.5e6, time: 0.1)]))";
        tried(&format!(
            "(shape: Paraboloid(radius: 5e-3), bodies: ({body}, Rigid), adhesion: Jkr(work: 0.05, edge: {edge}), \
             history: [Indent(to: 1e-5, over: 10), Retract(speed: {speed:e})])"
        ))
        .unwrap()
    };
    let is_told = |outcome: &Outcome| outcome.warnings.iter().any(|warning| warning.starts_with("heat of "));
    let quick = "Rate(speed: 1e-3, exponent: 0.5)";
    for (edge, speed, expected) in [
        ("Relaxed", 1e-2, true),
        (quick, 1e-2, true),
        ("Instantaneous", 1e-2, false),
        ("Relaxed", 1e-7, false),
        (quick, 1e-7, false),
    ] {
        let outcome = pulled(edge, speed);
        assert_eq!(is_told(&outcome), expected, "{edge} at {speed:e}: {:?}", outcome.warnings);
        let last = outcome.records.last().unwrap().normal;
        assert_eq!(last.dissipated < 0.0, expected, "{edge} at {speed:e}: {last:?}");
    }
}

/// Coulomb friction slips everywhere from μdE*/G* on, a uniform shear stress from 2τa/G*; a slide the other way takes
/// twice as much.
#[test]
fn a_slide_too_short_for_gross_sliding_is_told() {
    let short = |friction: &str, slides: &str| {
        let entries = format!("Indent(to: 1e-5, over: 1), {slides}");
        on_rubber(&format!("friction: {friction},"), &entries)
            .warnings
            .iter()
            .filter(|warning| warning.contains("too short"))
            .count()
    };
    let slide = |to: f64| format!("Slide(to: {to:e}, over: 1)");
    // G*/E* = 2(1 − ν)/(2 − ν) = 2/3.
    let capped = "CoulombOrowan(coefficient: 0.3, shear_limit: \"1 GPa\")";
    let (full, a) = (0.3 * 1e-5 * 1.5, (5e-3_f64 * 1e-5).sqrt());
    assert_eq!((short(capped, &slide(0.999 * full)), short(capped, &slide(1.001 * full))), (1, 0));
    let uniform = "Pressure(shear: \"0.1 MPa\", slope: 0)";
    let full = 2.0 * 1e5 * a / (8e6 / 3.0 * 2.0 / 3.0);
    assert_eq!((short(uniform, &slide(0.999 * full)), short(uniform, &slide(1.001 * full))), (1, 0));
    let to_and_fro = |back: f64| short(uniform, &format!("{}, {}", slide(1.1 * full), slide((1.1 - back) * full)));
    assert_eq!((to_and_fro(1.999), to_and_fro(2.001)), (1, 0));
}

/// G and E = 2G(1 + ν) are one body, in a scene and in the scene it is resolved to.
#[test]
fn a_body_may_be_given_by_its_shear_modulus() {
    let body = |moduli: &str| {
        let text = format!(
            "(shape: Cone(slope: 0.1), bodies: (Elastic({moduli}, poisson: 0.25), Rigid), history: [Indent(to: 1, over: 1)])"
        );
        Scene::from_ron(&text).unwrap()
    };
    let (shear, young) = (body("shear: \"80 GPa\""), body("young: \"200 GPa\""));
    assert_eq!(shear, young);
    assert_eq!(Scene::from_json(&shear.to_json().unwrap()).unwrap(), young);
}

/// w = γ₁ + γ₂ − γ₁₂, in RON and in JSON; the energy of the interface may be left out.
#[test]
fn a_work_of_adhesion_may_be_given_by_its_surfaces() {
    let scene = |work: &str| {
        let text = format!(
            "(shape: Cone(slope: 0.1), bodies: (Elastic(young: 1, poisson: 0.25), Rigid), adhesion: Jkr(work: {work}), \
             history: [Indent(to: 1, over: 1)])"
        );
        Scene::from_ron(&text)
    };
    let right = scene("0.0390625").unwrap();
    assert_eq!(scene("(surface_1: \"31.25 mJ/m^2\", surface_2: 0.015625, interface: 0.0078125)").unwrap(), right);
    assert_eq!(scene("(surface_2: 0.01953125, surface_1: \"19.53125 mJ/m^2\")").unwrap(), right);
    let json = right
        .to_json()
        .unwrap()
        .replace("\"work\": 0.0390625", "\"work\": {\"surface_1\": 0.01953125, \"surface_2\": 0.01953125}");
    assert_eq!(Scene::from_json(&json).unwrap(), right);
    let wrong = |work: &str| scene(work).unwrap_err().message;
    assert!(wrong("(surface_1: 0.02, surface_2: 0.02, interface: 0.05)").contains("out of range: expected a work of"));
    assert!(wrong("(surface_1: 0.02)").contains("lacks the field `surface_2`"));
    assert!(wrong("(surface_1: 0.02, surface_2: -1)").contains("-1.0 J/m^2 is out of range"));
    assert!(wrong("(surface_1: 0.02, surface: 1)").contains("there is no part `surface`: expected surface_1"));
}

/// A bridge of liquid is the attraction γ/r_K up to the gap 2r_K cos θ; a hard ball is torn off by 4πγR cos θ.
#[test]
fn a_bridge_of_liquid_is_an_attraction_of_finite_range() {
    let entries = "Indent(to: \"2 nm\", over: 1), Indent(to: \"-20 nm\", over: 1), Press(to: \"1 mN\", over: 1)";
    let held = |adhesion: &str| on_rubber(&format!("adhesion: {adhesion},"), entries);
    let bridge = held("Capillary(tension: \"72 mN/m\", angle: \"60 deg\", kelvin_radius: \"2 nm\")");
    let stress = held("Maugis(work: \"72 mJ/m^2\", stress: \"36 MPa\")");
    for (one, other) in bridge.records.iter().zip(&stress.records) {
        let scale = stress.records.iter().map(|record| record.normal.force.abs()).fold(0.0, f64::max);
        assert!((one.normal.force - other.normal.force).abs() < 1e-12 * scale, "{one:?} {other:?}");
    }
    let hard = |angle: f64| {
        let text = format!(
            "(shape: Paraboloid(radius: 1e-7), bodies: (Elastic(young: 1e15, poisson: 0), Rigid),
            adhesion: Capillary(tension: 0.072, angle: {angle}, kelvin_radius: 1e-9), history: [Indent(to: 1e-12, over: 1), Indent(to: -4e-9, over: 1)])"
        );
        let outcome = tried(&text).unwrap();
        outcome.records.iter().map(|record| record.normal.force).fold(0.0, f64::min)
    };
    for angle in [0.0, 0.5, 1.4] {
        let limit = -4.0 * PI * 0.072 * 1e-7 * f64::cos(angle);
        assert!((hard(angle) / limit - 1.0).abs() < 1e-3, "{angle} {:e} {limit:e}", hard(angle));
    }
}

/// Two spheres are a ball of 1/R = 1/R₁ + 1/R₂ on a flat; a ball in a cup is a wider one.
#[test]
fn two_spheres_are_one_on_a_flat() {
    let force = |shape: &str| {
        let text = format!(
            "(shape: {shape}, bodies: (Elastic(young: \"2 MPa\", poisson: 0.5), Rigid), history: [Indent(to: 1e-6, over: 1)])"
        );
        tried(&text).unwrap().number("largest_force_n").unwrap()
    };
    let ball = force("Paraboloid(radius: \"20 mm\")");
    for spheres in
        ["\"40 mm\", radius_2: \"40 mm\"", "\"10 mm\", radius_2: \"-20 mm\"", "\"-60 mm\", radius_2: \"15 mm\""]
    {
        let found = force(&format!("Spheres(radius_1: {spheres})"));
        assert!((found / ball - 1.0).abs() < 4.0 * f64::EPSILON, "{spheres}: {found} {ball}");
    }
    let small = on_shape("Spheres(radius_1: \"1 mm\", radius_2: \"1 m\")", "Indent(to: 1e-4, over: 1)");
    assert!(small.warnings.iter().any(|warning| warning.contains("of the smaller sphere")), "{:?}", small.warnings);
}

fn on_shape(shape: &str, entries: &str) -> Outcome {
    let text =
        format!("(shape: {shape}, bodies: (Elastic(young: \"2 MPa\", poisson: 0.5), Rigid), history: [{entries}])");
    tried(&text).unwrap()
}

/// The peak pressure of an ellipsoid is that of the elliptic contact under the same force, 1.5 F/πab; a and b with
/// another library's elliptic integrals (Johnson, eqs. 4.25 to 4.28).
#[test]
fn an_ellipsoid_has_the_peak_pressure_of_its_ellipse() {
    for ratio in [1.0, 10.0, 100.0] {
        let shape = format!("Ellipsoid(radius_x: {}, radius_y: 1e-3)", 1e-3 * ratio);
        let outcome = on_shape(&shape, "Press(to: 1e-4, over: 1)");
        let exact = EllipticHertz::at_force([1e-3 * ratio, 1e-3], 8e6 / 3.0, 1e-4).unwrap();
        let found = outcome.number("peak_pressure_pa").unwrap();
        assert!((found / exact.peak_pressure - 1.0).abs() < 1e-12, "{ratio}: {found:e}");
    }
    let adhesive = on_shape("Ellipsoid(radius_x: 1e-2, radius_y: 1e-3)", "Press(to: 1e-4, over: 1)");
    assert!(adhesive.error_estimate.relative > 0.09, "the force at a given depth is 10 % too small");
}

/// The error of a rate law sets one history beside another that is followed better, whatever the places of the bed mean: it is
/// that of its steps, which are as short as the accuracy of 1e-3 asks for.
#[test]
fn the_error_of_a_rate_law_compares_like_with_like() {
    let body = "Viscoelastic(poisson: 0.5, shear: (equilibrium: 3e5, terms: [(modulus: 5e5, time: 0.1)]))";
    for (shape, work, depth) in [
        ("Paraboloid(radius: 5e-3)", "0.05", 1e-5),
        ("Cylinder(radius: 5e-3, datum: 1e-2, width: 1e-3)", "0.05", 1e-5),
        ("PlaneWave(amplitude: 4e-6, wavelength: 1e-4)", "1e-3", 1e-6),
    ] {
        let told = tried(&format!(
            "(shape: {shape}, bodies: ({body}, Rigid), \
             adhesion: Jkr(work: {work}, edge: Rate(speed: 1e-5, exponent: 0.5)), accuracy: 1e-3, steps: 8, \
             history: [Indent(to: {depth:e}, over: 1), Indent(to: {:e}, over: 1)])",
            0.5 * depth
        ))
        .unwrap();
        assert!(told.error_estimate.relative < 2e-2, "{shape}: {:?}", told.error_estimate);
    }
}

/// An edge that opens by a rate law jumps over the waves of a ball that is pulled off: pieces of the depth as short as time can
/// be told are not halved for ever.
#[test]
fn a_pull_over_waves_ends() {
    let outcome = tried(
        "(shape: WavyParaboloid(radius: 1.1246826503806982e-3, amplitude: 5.623413251903491e-10, \
         wavelength: 5.623413251903491e-6), bodies: (Viscoelastic(poisson: 0.5, shear: \
         (equilibrium: 1.7782794100389228e9, terms: [], viscosity: 0)), Rigid), \
         adhesion: Jkr(work: 1.1246826503806984e-4, edge: Rate(speed: 1.0000000000000002e-6, exponent: 0.5)), steps: 4, \
         history: [Press(to: 1.778279410038923e-2, over: 3.1622776601683795), \
         Press(to: 7.113117640155692e-3, over: 5.623413251903492e-1), Press(to: -1.778279410038923e-3, over: 5.623413251903491)])",
    )
    .unwrap();
    assert!(outcome.records.last().unwrap().normal.indentation.is_none(), "the pull tears them apart");
}

/// A mass that tough bodies stop at once, and that their adhesion draws in until it carries nothing, turns nowhere: its
/// greatest depth is where it rests, that of JKR without a force, and the pressure there is shown. Bound: what is told.
#[test]
fn a_mass_that_creeps_to_rest_shows_where() {
    let text = "(shape: Paraboloid(radius: 1e-3), bodies: (Viscoelastic(poisson: 0.5, shear: (equilibrium: 2e6, terms: \
                [(modulus: 2e7, time: 300), (modulus: 2e7, time: 0.1)], viscosity: 5e8)), Rigid), \
                adhesion: Jkr(work: 0.05, edge: Relaxed), history: [Impact(mass: 1e-3, speed: 1e-2)])";
    let plan = Scene::from_ron(text).unwrap().resolve(&InMemory::default()).unwrap();
    let outcome = run::run(&plan, Wanted { fields: true, ..Wanted::NOTHING }).unwrap();
    let (modulus, work, curvature): (f64, f64, f64) = (8e6, 0.05, 1e3);
    let radius = (0.75 * (8.0 * PI * work / modulus).sqrt() / curvature).powf(2.0 / 3.0);
    let depth = radius * radius * curvature - (2.0 * PI * radius * work / modulus).sqrt();
    let off = outcome.number("largest_indentation_m").unwrap() / depth - 1.0;
    assert!(off.abs() < outcome.error_estimate.relative && outcome.error_estimate.relative < 1e-5, "{off:e}");
    assert!(outcome.number("pull_off_force_n").is_none(), "nothing was pulled off");
    assert!(outcome.number("peak_pressure_pa").is_some() && outcome.fields.iter().any(|field| !field.rows.is_empty()));
}
