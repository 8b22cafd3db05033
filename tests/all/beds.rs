//! Pictures of the bed and of both surfaces: their tables hold what the method says, and the figures show them.

use springbed::input::table::InMemory;
use springbed::run::bed::ROWS_PER_SPRING;
use springbed::run::record::Outcome;
use springbed::run::table::{Content, Table};
use springbed::run::{Wanted, run};
use springbed::text::Notation;
use std::f64::consts::{FRAC_1_PI, PI, TAU};

const PICTURES: Wanted = Wanted { bed: true, surface: true, ..Wanted::NOTHING };

fn outcome(text: &str) -> Outcome {
    let plan = Notation::Ron.plan(text, &InMemory::default()).unwrap_or_else(|errors| panic!("{errors:?}"));
    run(&plan, PICTURES).unwrap()
}

fn column(table: &Table, quantity: &str) -> Vec<Option<f64>> {
    table.column(quantity).unwrap().numbers().to_vec()
}

/// A row of the bed: place, profile, displacement, force per length.
type Row = (f64, f64, f64, f64);

/// The rows of the bed at an instant.
fn bed(outcome: &Outcome, instant: &str) -> Vec<Row> {
    let table = outcome.table("bed").unwrap();
    let Content::Words(instants) = &table.column("instant").unwrap().cells else { panic!() };
    let [places, profiles, displacements, loads] =
        ["place", "profile", "displacement", "force_per_length"].map(|name| column(table, name));
    let row = |k: usize| (places[k].unwrap(), profiles[k].unwrap(), displacements[k].unwrap(), loads[k].unwrap());
    (0..instants.len()).filter(|&k| instants[k] == instant).map(row).collect()
}

fn names(outcome: &Outcome) -> Vec<String> {
    let Content::Words(instants) = &outcome.table("bed").unwrap().column("instant").unwrap().cells else { panic!() };
    let mut instants = instants.clone();
    instants.dedup();
    instants
}

/// 2∫₀^a q dx by Simpson's rule, exact for parabolas; the edge at `a` is one of the places.
fn carried(rows: &[Row], a: f64) -> f64 {
    let inside = rows.iter().position(|row| (row.0 - a).abs() <= 0.0).unwrap();
    assert!(inside > 0 && inside.is_multiple_of(2 * (ROWS_PER_SPRING / 2)));
    let weight = |k: usize| if k == 0 || k == inside { 1.0 } else { 2.0 + 2.0 * (k % 2) as f64 };
    let sum: f64 = (0..=inside).map(|k| weight(k) * rows[k].3).sum();
    2.0 * sum * (rows[1].0 - rows[0].0) / 3.0
}

/// A ball of 10 mm on a half-space with E* = 4/3 MPa, with more to it.
fn on_gel(more: &str, history: &str) -> Outcome {
    outcome(&format!(
        "(shape: Paraboloid(radius: 0.01), bodies: (Rigid, Elastic(young: 1e6, poisson: 0.5)), {more} history: [{history}])"
    ))
}

const GEL: f64 = 4e6 / 3.0;

/// Hertz: u = d − x²/R and q = E*u up to √(Rd), nothing beyond; the sum of the springs is the force.
#[test]
fn the_springs_of_hertz_carry_his_force() {
    let outcome = on_gel("", "Indent(to: 1e-5, over: 1), Indent(to: 0, over: 1)");
    assert_eq!(names(&outcome), ["largest force"]);
    let (rows, a) = (bed(&outcome, "largest force"), outcome.number("largest_contact_radius_m").unwrap());
    assert!((a / 1e-3f64.mul_add(0.316_227_766_016_837_94, 0.0) - 1.0).abs() < 1e-14, "{a}");
    for &(x, profile, u, q) in &rows {
        let right = (1e-5 - x * x / 0.01).max(0.0);
        assert!((u - right).abs() < 1e-19 && (q - GEL * right).abs() < 1e-13, "{x}: {u} {q}");
        assert!((profile - (x * x / 0.01 - 1e-5)).abs() < 1e-19);
    }
    let force = outcome.number("largest_force_n").unwrap();
    assert!((carried(&rows, a) / force - 1.0).abs() < 1e-13 && rows.last().unwrap().0 >= 1.4 * a);
}

/// JKR: the last spring that holds is stretched by √(2πaw/E*), under the greatest force and under a pull at the end.
#[test]
fn the_last_spring_of_jkr_is_stretched_by_its_rule() {
    let outcome = on_gel("adhesion: Jkr(work: 0.05),", "Indent(to: 1e-5, over: 1), Indent(to: -2e-6, over: 1)");
    assert_eq!(names(&outcome), ["largest force", "end"]);
    let number = |name: &str| outcome.number(name).unwrap();
    for (instant, force, d) in [("largest force", "largest_force_n", 1e-5), ("end", "final_force_n", -2e-6)] {
        let rows = bed(&outcome, instant);
        let &(a, profile, u, q) = rows.iter().rfind(|row| row.3.abs() > 0.0).unwrap();
        let stretch = (TAU * a * 0.05 / GEL).sqrt();
        assert!((u / -stretch - 1.0).abs() < 1e-12, "{instant}: {u} {stretch}");
        assert!(
            (q / (GEL * u) - 1.0).abs() < 1e-12 && (profile + u).abs() < 1e-19 && (d - a * a / 0.01 - u).abs() < 1e-18
        );
        assert!((carried(&rows, a) / number(force) - 1.0).abs() < 1e-11, "{instant}: {}", carried(&rows, a));
        assert!(rows.iter().filter(|row| row.0 > a).all(|row| row.2.abs() <= 0.0 && row.3.abs() <= 0.0));
    }
}

/// A bed of ten thousand springs is drawn as one without springs: of second order in their width, −1/4 ≤ error·(a/Δx)² ≤ 1/8.
#[test]
fn a_bed_of_many_springs_is_drawn_with_a_few() {
    let exact = on_gel("", "Indent(to: 1e-5, over: 1)");
    let springs = on_gel("springs: 10000,", "Indent(to: 1e-5, over: 1)");
    let (one, other) = (bed(&exact, "largest force"), bed(&springs, "largest force"));
    assert!(one.len() == other.len() && one.len() < 60 * ROWS_PER_SPRING);
    let largest = 1e-5 * GEL;
    for (one, other) in one.iter().zip(&other) {
        // Δx = a (17/16)/10⁴; q is a parabola, whose chords lie E*Δx²/4R above it at most, and its slope at the edge is 2E*d/a.
        assert!((one.3 - other.3).abs() < 2e-4 * largest && (one.2 - other.2).abs() < 2e-4 * 1e-5, "{one:?} {other:?}");
    }
}

/// E*(t) = 4(0.1 + 0.9 e^(−t/0.2 s)) Pa under a ball of 1 m, let go within half a second and then left alone for `rest` s.
fn let_go(springs: &str, rest: f64) -> Outcome {
    outcome(&format!(
        "(shape: Paraboloid(radius: 1), bodies: (Viscoelastic(poisson: 0.5, shear: (equilibrium: 0.1, terms: [(modulus: 0.9, time: 0.2)])), Rigid), \
         {springs} history: [Indent(to: 0.01, over: 1), Indent(to: 0, over: 0.5), Hold(over: {rest})])"
    ))
}

/// What carries nothing comes back by e^(−t/λ), λ = τ(E∞ + E₁)/E∞ = 2 s, every spring by the same law.
#[test]
fn springs_let_go_recover() {
    for springs in ["", "springs: 400,"] {
        let (early, late) = (let_go(springs, 0.1), let_go(springs, 1.1));
        assert_eq!(names(&early), ["largest force", "end"]);
        let (one, other) = (bed(&early, "end"), bed(&late, "end"));
        let decay = (-0.5f64).exp();
        let mut free = 0;
        for (&(x, profile, u, q), &(_, _, later, _)) in one.iter().zip(&other) {
            // At the edge u is zero, to the 2e-14 of the greatest that a panel's polynomial has.
            assert!(q.abs() <= 0.0 && later <= u + 2e-16 && -u <= profile, "{x}: {q:e} {later:e} {u:e} {profile:e}");
            assert!((later - decay * u).abs() < 1e-12 * 0.01, "{x}: {later} {u}");
            free += usize::from(u > 1e-4);
        }
        assert!(free > 40, "{free}");
        // While it is pressed q is smooth up to the edge: Simpson's rule of 96 panels.
        if springs.is_empty() {
            let rows = bed(&early, "largest force");
            let force = early.number("largest_force_n").unwrap();
            assert!((carried(&rows, 0.1) / force - 1.0).abs() < 1e-7, "{}", carried(&rows, 0.1) / force - 1.0);
            assert!((force / 1.806718005260e-3 - 1.0).abs() < 1e-11);
        }
    }
}

/// On the way out, still in contact: inside the edge springs end at the profile, outside they are below it.
#[test]
fn springs_leave_the_profile_from_the_edge_inwards() {
    let outcome = outcome(
        "(shape: Paraboloid(radius: 1), bodies: (Viscoelastic(poisson: 0.5, shear: (equilibrium: 0.1, terms: [(modulus: 0.9, time: 0.2)])), Rigid), \
         history: [Indent(to: 0.01, over: 1), Indent(to: 0.008, over: 0.2)])",
    );
    let a = outcome.number("final_contact_radius_m").unwrap();
    assert!(a > 0.02 && a < 0.09, "{a}");
    let rows = bed(&outcome, "end");
    for &(x, profile, u, q) in &rows {
        if x <= a {
            assert!((profile + u).abs() < 1e-15 && q > -1e-9, "{x}");
        } else {
            assert!(q.abs() <= 0.0 && u >= 0.0 && -u < profile, "{x}");
        }
    }
    assert!(rows.iter().any(|row| row.0 > a && row.0 < 0.1 && row.2 > 1e-3));
    let force = outcome.number("final_force_n").unwrap();
    assert!((carried(&rows, a) / force - 1.0).abs() < 1e-6, "{}", carried(&rows, a) / force - 1.0);
}

/// Hertz: both surfaces meet in the contact and lie apart beyond; each takes its part of
/// u_z = (d/π)[(2 − r²/a²) asin(a/r) + √(r²/a² − 1)] (Johnson 1985, eq. 3.42a).
#[test]
fn both_bodies_share_the_displacement_as_their_compliances() {
    let outcome = outcome(
        "(shape: Paraboloid(radius: 0.01), bodies: (Elastic(young: 3e6, poisson: 0.3), Elastic(young: 1e6, poisson: 0.3)), history: [Indent(to: 1e-5, over: 1), Indent(to: 0, over: 1)])",
    );
    let (a, d) = ((0.01f64 * 1e-5).sqrt(), 1e-5);
    let table = outcome.table("surface").unwrap();
    let [radii, shapes, uppers, lowers] = ["radius", "shape", "upper", "lower"].map(|name| column(table, name));
    for k in 0..radii.len() {
        let (r, shape, upper, lower) = (radii[k].unwrap(), shapes[k].unwrap(), uppers[k].unwrap(), lowers[k].unwrap());
        assert!((shape - (r * r / 0.02 - d)).abs() < 1e-18);
        let part = r / a;
        let outside = || d * FRAC_1_PI * ((2.0 - part * part) * (1.0 / part).asin() + (part * part - 1.0).sqrt());
        let u = if r <= a { d - r * r / 0.02 } else { outside() };
        // The softer body below takes 3/4, the stiffer one above 1/4.
        assert!(
            (lower + 0.75 * u).abs() < 1e-13 * d.max(r) && (upper - shape - 0.25 * u).abs() < 1e-13 * d.max(r),
            "{r}"
        );
        if r <= a { assert!((upper - lower).abs() < 1e-18) } else { assert!(upper > lower) }
    }
}

/// A picture changes nothing else.
#[test]
fn a_picture_costs_no_result() {
    for more in ["", "adhesion: Jkr(work: 0.05),", "friction: Coulomb(coefficient: 0.3), springs: 100,"] {
        let text = format!(
            "(shape: Paraboloid(radius: 0.01), bodies: (Rigid, Elastic(young: 1e6, poisson: 0.5)), {more} history: [Indent(to: 1e-5, over: 1), Indent(to: 2e-6, over: 1)])"
        );
        let plan = Notation::Ron.plan(&text, &InMemory::default()).unwrap();
        for fields in [false, true] {
            let [without, with] = [false, true]
                .map(|drawn| run(&plan, Wanted { fields, bed: drawn, surface: drawn, ..Wanted::NOTHING }).unwrap());
            assert!(without.records == with.records && without.results == with.results);
            assert!(without.fields == with.fields && without.table("bed").is_none() && with.table("bed").is_some());
        }
    }
}

/// Where there is no bed, or no surface that is known, it is said why.
#[test]
fn what_cannot_be_drawn_is_refused_by_its_name() {
    const BALL: &str = "shape: Paraboloid(radius: 0.01),";
    const GEL: &str = "bodies: (Rigid, Elastic(young: 1e6, poisson: 0.5)),";
    const RUBBER: &str = "Viscoelastic(poisson: 0.5, shear: (equilibrium: 1, terms: [(modulus: 1, time: 1)]))";
    const ROUGH: &str = "shape: RoughLine(spectrum: SelfAffine(hurst: 0.6, rms: \"1 um\", long: \"1 mm\", short: \"10 um\"), length: \"1 mm\", points: 256, seed: 1),";
    const IN: &str = "history: [Indent(to: 1e-5, over: 1)],";
    let film =
        "bodies: (Rigid, Layered(layers: [(body: Elastic(young: 1e6, poisson: 0.4), thickness: 0.01)], base: Rigid)),";
    let cases = [
        (format!("shape: Ellipsoid(radius_x: 0.01, radius_y: 0.02), {GEL} {IN}"), None, Some("about an ellipse")),
        (format!("{BALL} {GEL} adhesion: Maugis(work: 0.05, stress: 1e5), {IN}"), Some("acts in a ring outside"), None),
        (format!("{BALL} {film} {IN}"), Some("not at their radii"), Some("in one ratio at all radii")),
        (
            format!("{BALL} bodies: (Elastic(young: 1, poisson: 0), {RUBBER}), {IN}"),
            None,
            Some("a ratio that changes in time"),
        ),
        (
            format!("{BALL} bodies: (Rigid, Plastic(young: 1e6, poisson: 0.3, yield_stress: 1e4)), {IN}"),
            Some("without springs"),
            Some("beside a body that yields"),
        ),
        (
            format!("{BALL} {GEL} history: [Impact(mass: 1, speed: 1e-3)],"),
            Some("not an impact"),
            Some("not an impact"),
        ),
        (
            format!(
                "{BALL} {GEL} friction: Coulomb(coefficient: 0.3), wear: Archard(coefficient: 1e-15), history: [Indent(to: 1e-5, over: 1), Slide(to: 1e-3, over: 1)],"
            ),
            Some("a profile that wears"),
            Some("a profile that wears"),
        ),
        (
            format!(
                "{BALL} {GEL} machine: (mass: 1, stiffness: 10), history: [Indent(to: 1e-5, over: 1), Ring(amplitude: 1e-7, over: 1)],"
            ),
            Some("a contact in a machine"),
            Some("a contact in a machine"),
        ),
        (
            format!(
                "{BALL} bodies: (Rigid, {RUBBER}), history: [Indent(to: 1e-5, over: 1), Glide(speed: 1e-3, over: 1)],"
            ),
            Some("is not round"),
            Some("is not round"),
        ),
        (
            format!("shape: Cylinder(radius: 0.01, datum: 0.02), {GEL} {IN}"),
            Some("not where the body is"),
            Some("sinks without bound"),
        ),
        (
            format!("shape: PlaneWavy(radius: 0.005, waves: [], datum: 0.01), {GEL} history: [Press(to: 1, over: 1)],"),
            Some("has no bed of springs"),
            Some("sinks without bound"),
        ),
        (format!("{BALL} {GEL} solver: HalfSpace(), {IN}"), Some("drawn as a map"), Some("drawn as a map")),
        (
            format!("{ROUGH} {GEL} history: [Press(to: 1, over: 1)],"),
            Some("hundreds of places"),
            Some("not for its heights"),
        ),
    ];
    for (scene, bed, surface) in cases {
        for (plot, why) in [("Bed", bed), ("Surface", surface)] {
            let text = format!("({scene} plots: [Force, {plot}])");
            let found = Notation::Ron.plan(&text, &InMemory::default()).err().unwrap_or_default();
            let told: Vec<String> = found.iter().map(|problem| format!("{problem:?}")).collect();
            let named = |why: &&str| {
                told.len() == 1 && told[0].contains(&format!("{plot} cannot be drawn")) && told[0].contains(*why)
            };
            match why {
                Some(why) => assert!(named(&why), "{text}: {told:?}"),
                None => assert!(told.is_empty(), "{text}: {told:?}"),
            }
        }
    }
}

/// Single stresses are drawn where the stress of von Mises is, and nowhere else.
#[test]
fn single_stresses_are_drawn_where_their_map_is() {
    let scenes = [
        "shape: Paraboloid(radius: 0.01), bodies: (Rigid, Elastic(young: 1e6, poisson: 0.5)), history: [Indent(to: 1e-5, over: 1)],",
        "shape: Paraboloid(radius: 0.01), bodies: (Rigid, Graded(young: 1e6, depth: 1e-3, exponent: 0.2, poisson: 0.3)), history: [Indent(to: 1e-5, over: 1)],",
        "shape: Cylinder(radius: 0.01, datum: 0.02), bodies: (Rigid, Elastic(young: 1e6, poisson: 0.5)), history: [Indent(to: 1e-5, over: 1)],",
        "shape: Paraboloid(radius: 0.01), bodies: (Rigid, Plastic(young: 1e6, poisson: 0.3, yield_stress: 1e4)), history: [Indent(to: 1e-5, over: 1)],",
        "shape: Paraboloid(radius: 0.01), bodies: (Rigid, Elastic(young: 1e6, poisson: 0.5)), solver: HalfSpace(), history: [Indent(to: 1e-5, over: 1)],",
    ];
    for (number, scene) in scenes.into_iter().enumerate() {
        let refused =
            |plot: &str| Notation::Ron.plan(&format!("({scene} plots: [{plot}])"), &InMemory::default()).is_err();
        assert_eq!([refused("Stress"), refused("Field")], [number > 0; 2], "{scene}");
    }
}

#[cfg(feature = "plot")]
mod drawn {
    use super::*;
    use springbed::app::figure::{Figure, Panel};
    use springbed::app::{export, run as program, scene_file};

    fn figure(more: &str, history: &str, plots: &str) -> Figure {
        let text = format!(
            "(shape: Paraboloid(radius: 0.01), bodies: (Rigid, Elastic(young: 1e6, poisson: 0.5)), {more} history: [{history}], plots: [{plots}])"
        );
        let plan = scene_file::plan("a.ron".as_ref(), &text).unwrap_or_else(|faults| panic!("{faults:?}"));
        let outcome = program::compute(&plan, &[program::Format::Svg]).unwrap();
        export::figures(&plan, &outcome)
    }

    fn points<'p>(panel: &'p Panel, label: &str) -> impl Iterator<Item = (f64, f64)> + 'p {
        let label = label.to_owned();
        panel
            .series
            .iter()
            .filter(move |series| series.label == label)
            .flat_map(|series| series.points.iter().flatten().copied())
    }

    /// From 30 to 60 springs, each of its own length; the outermost that holds is stretched by the rule of Heß.
    #[test]
    fn the_figure_shows_the_springs_of_the_table() {
        let figure = figure("adhesion: Jkr(work: 0.05),", "Indent(to: 1e-5, over: 1)", "Bed");
        let [springs, loads] = &figure.panels[..] else { panic!("{}", figure.panels.len()) };
        let all = ["springs pressed", "springs pulled", "springs not touched"];
        let mut places: Vec<f64> = Vec::new();
        for label in all {
            let top = |x: f64| {
                points(springs, label)
                    .filter(move |point| (point.0 - x).abs() <= 0.0)
                    .map(|point| point.1)
                    .fold(f64::MIN, f64::max)
            };
            let ends: Vec<f64> =
                points(springs, label).filter(|point| point.1 < -1.9e-5).map(|point| point.0).collect();
            assert!(ends.iter().all(|&x| top(x) > -1.1e-5), "{label}");
            places.extend(ends);
        }
        places.sort_by(f64::total_cmp);
        places.dedup();
        assert!((30..=60).contains(&places.len()), "{}", places.len());
        let (a, stretch) = points(springs, "springs pulled")
            .fold((0.0, 0.0), |most: (f64, f64), point| if point.1 > most.1 { point } else { most });
        assert!((stretch / (TAU * a.abs() * 0.05 / GEL).sqrt() - 1.0).abs() < 1e-12, "{a} {stretch}");
        assert!(loads.notes.iter().any(|note| note.contains("∫q dx = F")));
        let least = points(loads, "").map(|point| point.1).fold(0.0, f64::min);
        assert!((least / (-GEL * stretch) - 1.0).abs() < 1e-12);
    }

    /// To scale both axes have one; exaggerated, heights are larger by what the heading says.
    #[test]
    fn surfaces_are_to_scale_and_exaggerated_by_what_is_said() {
        let figure = figure("", "Indent(to: 1e-5, over: 1)", "Surface");
        let [whole, tall] = &figure.panels[..] else { panic!("{}", figure.panels.len()) };
        let spans = |panel: &Panel| [panel.x.limits, panel.y.limits].map(|(low, high)| high.unwrap() - low.unwrap());
        let [across, up] = spans(whole);
        assert!((across / up / whole.ratio.unwrap() - 1.0).abs() < 1e-12 && whole.title.contains("to scale"));
        let [_, higher] = spans(tall);
        let factor = up / higher;
        assert!(tall.title.ends_with(&format!("heights × {factor:.0}")) && factor > 5.0, "{} {factor}", tall.title);
        assert!(whole.notes[0].contains("not rigid") && tall.ratio == whole.ratio);
    }

    /// Four maps about zero of a still contact; each has a value of its own at every point.
    #[test]
    fn single_stresses_are_four_maps() {
        let figure = figure("", "Indent(to: 1e-5, over: 1)", "Field");
        let headings: Vec<&str> = figure.panels.iter().map(|panel| panel.title.split(',').next().unwrap()).collect();
        assert_eq!(headings, ["axial σ_zz", "radial σ_rr", "hoop σ_θθ", "shear τ_rz"]);
        let axial = figure.panels[0].contours.as_ref().unwrap();
        let peak = 2.0 * GEL * (0.01f64 * 1e-5).sqrt() / (PI * 0.01);
        assert!((axial.values[0].unwrap() / -peak - 1.0).abs() < 1e-12);
        assert!(figure.panels.iter().all(|panel| panel.contours.as_ref().unwrap().values.iter().all(Option::is_some)));
    }
}
