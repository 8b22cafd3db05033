//! Friction on the pixels of a half-space: against the bed, closed forms of ellipses, and under the laws that hold whatever
//! the surface is.

use super::half_space_past::apart;
use proptest::prelude::*;
use springbed::prelude::*;
use springbed::run::record::{Outcome, Record};
use std::f64::consts::PI;

const FIELDS: Wanted = Wanted { fields: true, ..Wanted::NOTHING };
/// G*/E* = 2(1 − ν)/(2 − ν) of two equal bodies.
const SIMILAR: f64 = 1.4 / 1.7;
/// Two of them have E* = 549.5 kPa.
const RUBBER: &str = "Elastic(young: 1e6, poisson: 0.3)";
const BALL: &str = "Paraboloid(radius: 5e-3)";
const ROUGH: &str =
    "RoughLine(spectrum: SelfAffine(hurst: 0.8, rms: 1e-6, long: 1e-4, short: 2.5e-5), length: 1e-4, points: 128)";
const COULOMB: &str = "friction: Coulomb(coefficient: 0.4)";
/// Side of a pixel [m].
const PIXEL: f64 = 7.2e-4 / 48.0;
/// From the tip to the edge at 1e-5 m, of a window of 7.2e-4 m, there are 15 pixels.
const PIXELS: &str = "solver: HalfSpace(grid: 48, window: 7.2e-4)";
/// (Δ/a)²/8: what pixels of constant pressure miss of the force of a ball at most.
const SQUARE: f64 = 0.125 / 222.0;

fn outcome(shape: &str, history: &str, rest: &str) -> Outcome {
    let motion: [(&str, &[f64]); 3] = [
        ("time_s", &[0.0, 1.0, 2.0, 3.0]),
        ("indentation_m", &[0.0, 1e-5, 8e-6, 8e-6]),
        ("slide_m", &[0.0, 2e-6, -1e-6, 1e-6]),
    ];
    let tables = InMemory::default().with("motion.csv", &motion);
    let text = format!("(shape: {shape}, bodies: ({RUBBER}, {RUBBER}), history: [{history}], {rest})");
    let plan = Notation::Ron.plan(&text, &tables).unwrap_or_else(|errors| panic!("{text}: {}", errors[0]));
    run(&plan, FIELDS).unwrap_or_else(|error| panic!("{text}: {error}"))
}

fn tangential(record: &Record) -> f64 {
    record.tangential.unwrap().force
}

fn dissipated(record: &Record) -> f64 {
    record.tangential.unwrap().dissipated.unwrap()
}

fn last(outcome: &Outcome) -> &Record {
    outcome.records.last().unwrap()
}

/// Depths in tenths of 1e-5 m and slides in tenths of what slips all at 1e-5 m, as entries and as they are led to.
fn led(steps: &[(u32, i32)]) -> String {
    let reach = 0.4 / SIMILAR * 1e-5;
    let entries = steps.iter().map(|(depth, slide)| {
        format!(
            "Indent(to: {:e}, over: 1), Slide(to: {:e}, over: 1)",
            1e-6 * f64::from(*depth),
            0.1 * reach * f64::from(*slide)
        )
    });
    entries.collect::<Vec<_>>().join(", ")
}

proptest! {
    #![proptest_config(crate::laws::cases(6))]

    /// Stick, slip and what is lost are those of the bed, which is exact; each turning point is two depths of which each
    /// pixel force misses (Δ/a)²/8.
    #[test]
    fn a_ball_slips_as_its_bed(steps in prop::collection::vec((2u32..=10, -12i32..=12), 1..4)) {
        let history = format!("Indent(to: 1e-5, over: 1), Slide(to: 1e-6, over: 1), {}", led(&steps));
        let bed = outcome(BALL, &history, &format!("steps: 3, {COULOMB}"));
        let pixels = outcome(BALL, &history, &format!("steps: 3, {COULOMB}, {PIXELS}"));
        let bound = 2.0 * SQUARE * (2.0 + 2.0 * steps.len() as f64);
        let largest = bed.records.iter().map(|record| record.normal.force).fold(0.0, f64::max) * 0.4;
        let (mut way, mut slide) = (0.0, 0.0);
        for (one, other) in bed.records.iter().zip(&pixels.records) {
            prop_assert!((one.time - other.time).abs() < 1e-12);
            prop_assert!((tangential(one) - tangential(other)).abs() < bound * largest, "{history}: {one:?} {other:?}");
            // What is lost is force times way; of small slides it is itself a small part of that.
            let now = one.tangential.unwrap().slide;
            (way, slide) = (way + f64::abs(now - slide), now);
            let off = (dissipated(one) - dissipated(other)).abs();
            prop_assert!(off <= bound * largest * way, "{history}: {off:e} of {:e}", largest * way);
        }
        for (one, other) in bed.records.iter().zip(&pixels.records) {
            let [one, other] = [one, other].map(|record| record.tangential.unwrap().stick_radius);
            // An edge of whole pixels, of which second moments leave a tenth; what sticks within one pixel is that one or none.
            let bound = if one.min(other) < PIXEL { PIXEL } else { 0.3 * PIXEL };
            prop_assert!((one - other).abs() < bound, "{history}: {one} {other}");
        }
        prop_assert!(pixels.error_estimate.relative * 8.0 > apart(&bed, &pixels, tangential), "{:?}", pixels.error_estimate);
    }

    /// What slides the other way round is held back by the opposite force, and loses the same.
    #[test]
    fn mirrored_slides_mirror(steps in prop::collection::vec((2u32..=10, -12i32..=12), 1..4)) {
        let mirrored: Vec<(u32, i32)> = steps.iter().map(|(depth, slide)| (*depth, -slide)).collect();
        let rest = format!("steps: 2, {COULOMB}, solver: HalfSpace(grid: 32)");
        let [one, other] = [&steps, &mirrored].map(|steps| outcome(ROUGH, &led_rough(steps), &rest));
        for (one, other) in one.records.iter().zip(&other.records) {
            prop_assert!((tangential(one) + tangential(other)).abs() <= 0.0);
            prop_assert!((dissipated(one) - dissipated(other)).abs() <= 0.0);
        }
    }

    /// Work goes into the bodies, or is lost: ∫F dd + ∫F_x du_x by the trapezoid over fine records; nothing is won.
    #[test]
    fn the_work_is_stored_or_lost(steps in prop::collection::vec((2u32..=10, -12i32..=12), 1..3)) {
        let rest = format!("steps: 24, {COULOMB}, solver: HalfSpace(grid: 32)");
        let outcome = outcome(ROUGH, &led_rough(&steps), &rest);
        let (mut work, mut open, mut most) = (0.0, 0.0_f64, 0.0_f64);
        for pair in outcome.records.windows(2) {
            let [before, after] = [&pair[0], &pair[1]];
            let depth = after.normal.indentation.unwrap() - before.normal.indentation.unwrap();
            let slide = after.tangential.unwrap().slide - before.tangential.unwrap().slide;
            work += 0.5 * (before.normal.force + after.normal.force) * depth + 0.5 * (tangential(before) + tangential(after)) * slide;
            let kept = after.normal.stored.stored() + after.tangential.unwrap().stored.unwrap() + dissipated(after);
            (open, most) = (open.max((work - kept).abs()), most.max(kept));
            // What is lost is a difference of energies, each known to the residual of its contact, 1e-8.
            let known = 1e-7 * dissipated(before) + 2e-8 * most;
            prop_assert!(dissipated(after) >= dissipated(before) - known, "{before:?} {after:?}");
            prop_assert!(after.tangential.unwrap().stored.unwrap() >= -1e-7 * most);
        }
        // Trapezoids in 24 steps of a force that grows as d², and pixels that join in steps.
        prop_assert!(open < 5e-3 * most, "{open:e} of {most:e}");
    }
}

/// The same of a rough surface, whose depths are 1 to 10 tenths of a micrometre.
fn led_rough(steps: &[(u32, i32)]) -> String {
    let entries = steps.iter().map(|(depth, slide)| {
        format!(
            "Indent(to: {:e}, over: 1), Slide(to: {:e}, over: 1)",
            1.5e-7 * f64::from(*depth),
            5e-8 * f64::from(*slide)
        )
    });
    entries.collect::<Vec<_>>().join(", ")
}

/// Hertz' ellipse under shear along one of its axes: T/μF = 1 − (1 − u/u_s)^{3/2}, u_s = μ(E*/G_x)d, with Mindlin's
/// compliance: 1/G_x = 1/G* + (1/G* − 1/E*)(1 − 2⟨cos²φ⟩), the mean over the waves of the ellipse.
#[test]
fn an_ellipse_slips_by_its_compliance_along_the_way() {
    for [x, y] in [[10e-3, 2.5e-3], [2.5e-3, 10e-3]] {
        let shape = format!("Ellipsoid(radius_x: {x}, radius_y: {y})");
        let pressed = outcome(&shape, "Press(to: 5e-3, over: 1)", "steps: 1, solver: HalfSpace(grid: 128)");
        let slid = outcome(
            &shape,
            "Press(to: 5e-3, over: 1), Slide(to: 2e-6, over: 1)",
            &format!("steps: 4, {COULOMB}, solver: HalfSpace(grid: 128)"),
        );
        let depth = last(&pressed).normal.indentation.unwrap();
        let cosine = of_ellipse(axes([x, y]));
        let along = SIMILAR;
        let compliance = (1.0 + (1.0 - along) * (1.0 - 2.0 * cosine)) / along;
        let all = 0.4 * compliance * depth;
        for record in slid.records.iter().filter(|record| record.time > 1.0) {
            let part = 1.0 - (1.0 - record.tangential.unwrap().slide / all).max(0.0).powf(1.5);
            let right = 0.4 * 5e-3 * part;
            // ⟨cos²φ⟩ is known to 2e-3, the pixels to 1e-3 of μF.
            assert!((tangential(record) - right).abs() < 2e-3 * 0.4 * 5e-3, "{x}: {} {right}", tangential(record));
        }
        // A round contact would be off by more.
        assert!((1.0 - along) * (1.0 - 2.0 * cosine).abs() > 0.03, "{cosine}");
    }
}

/// Ratio of the semi-axes along x and y of Hertz' ellipse, by its two conditions: what a ratio of curvatures makes of it.
fn axes([x, y]: [f64; 2]) -> f64 {
    // R_x/R_y = −(dI/da)/(dI/db)·… of I(a, b) = ∫dφ/√(a²cos² + b²sin²), both by the midpoint rule, exact for periods.
    let ratio = |k: f64| {
        let mean = |of: &dyn Fn(f64, f64) -> f64| {
            (0..400).map(|n| (n as f64 + 0.5) * PI / 400.0).map(|phi| of(phi.cos(), phi.sin())).sum::<f64>()
        };
        let weight = |c: f64, s: f64| ((k * c).powi(2) + s * s).powf(-1.5);
        mean(&|c, s| s * s * weight(c, s)) / mean(&|c, s| c * c * weight(c, s))
    };
    let (mut low, mut high) = (1e-3_f64, 1e3_f64);
    for _ in 0..200 {
        let middle = (low * high).sqrt();
        if ratio(middle) < x / y { low = middle } else { high = middle }
    }
    low
}

/// ⟨cos²φ⟩ of an ellipse whose semi-axis along x is `k` times the other.
fn of_ellipse(k: f64) -> f64 {
    let mean = |of: &dyn Fn(f64) -> f64| {
        (0..4000)
            .map(|n| (n as f64 + 0.5) * PI / 4000.0)
            .map(|phi| of(phi) / (k * phi.cos()).hypot(phi.sin()))
            .sum::<f64>()
    };
    mean(&|phi| phi.cos().powi(2)) / mean(&|_| 1.0)
}

/// F_x = μ(F(d) − F(d − uG*/μE*)): the force of a shallower contact is taken off (Ciavarella 1998; Jäger 1998).
#[test]
fn the_first_slide_of_a_rough_surface_takes_off_a_shallower_contact() {
    let pixels = "solver: HalfSpace(grid: 48)";
    let slid = outcome(
        ROUGH,
        "Indent(to: 1.5e-6, over: 1), Slide(to: 2e-7, over: 1)",
        &format!("steps: 2, {COULOMB}, {pixels}"),
    );
    let (end, half) = (last(&slid), &slid.records[slid.records.len() - 2]);
    let stiffness = slid.number("largest_stiffness_n_per_m").unwrap();
    assert!(stiffness > 0.0);
    // The first stiffness tells the reach of this surface, G_x/E* for its own waves.
    let stuck = outcome(
        ROUGH,
        "Indent(to: 1.5e-6, over: 1), Slide(to: 1e-13, over: 1)",
        &format!("steps: 1, {COULOMB}, {pixels}"),
    );
    let ratio = tangential(last(&stuck)) / 1e-13 / last(&stuck).normal.stiffness;
    assert!((ratio - 0.8235).abs() < 0.03, "{ratio}");
    for record in [half, end] {
        let shallower = 1.5e-6 - record.tangential.unwrap().slide * ratio / 0.4;
        let rest = outcome(ROUGH, &format!("Indent(to: {shallower:e}, over: 1)"), &format!("steps: 1, {pixels}"));
        let right = 0.4 * (record.normal.force - last(&rest).normal.force);
        // Solutions are known to 1e-8; the first stiffness, of pixels that stick, to 1e-6.
        assert!((tangential(record) / right - 1.0).abs() < 1e-5, "{} {right}", tangential(record));
        assert!((record.stick_area().unwrap() / last(&rest).pixels.unwrap().area - 1.0).abs() < 1e-3);
    }
}

/// A long slide slips all: F_x = μF to rounding, nothing sticks, and the shear is μ times the pressure.
#[test]
fn a_long_slide_slips_as_a_whole() {
    for shape in [BALL, ROUGH, "FlatPunch(radius: 2e-4)", "Ellipsoid(radius_x: 5e-3, radius_y: 1e-3)"] {
        let outcome = outcome(
            shape,
            "Press(to: 1e-4, over: 1), Slide(to: -1e-3, over: 1)",
            &format!("steps: 2, {COULOMB}, solver: HalfSpace(grid: 32)"),
        );
        let end = last(&outcome);
        assert!((tangential(end) / -0.4e-4 - 1.0).abs() < 1e-7, "{shape}: {}", tangential(end));
        assert_eq!((end.stick_area(), end.tangential.unwrap().stiffness), (Some(0.0), 0.0), "{shape}");
        let map = outcome.map.as_ref().unwrap();
        let shear = map.shear.as_ref().unwrap();
        let largest = map.pressure.iter().copied().fold(0.0, f64::max);
        let apart =
            shear.iter().zip(&map.pressure).map(|(shear, pressure)| (shear + 0.4 * pressure).abs()).fold(0.0, f64::max);
        assert!(apart < 1e-9 * largest, "{shape}: {apart:e}");
    }
}

/// In partial slip no pixel bears more than μp, and together they bear F_x.
#[test]
fn shear_stays_below_the_limit_and_adds_up() {
    let outcome = outcome(
        ROUGH,
        "Press(to: 1e-4, over: 1), Slide(to: 1e-7, over: 1), Slide(to: -5e-8, over: 1), Press(to: 5e-5, over: 1), Slide(to: 1e-7, over: 1)",
        &format!("steps: 2, {COULOMB}, solver: HalfSpace(grid: 48)"),
    );
    let map = outcome.map.as_ref().unwrap();
    let shear = map.shear.as_ref().unwrap();
    let pixel = map.pixel[0] * map.pixel[1];
    let most = outcome.records.iter().map(tangential).map(f64::abs).fold(0.0, f64::max);
    assert!(((shear.sum() * pixel).abs() / most - 1.0).abs() < 1e-6, "{} {most}", shear.sum() * pixel);
    let peak = map.pressure.iter().copied().fold(0.0, f64::max);
    assert!(shear.iter().zip(&map.pressure).all(|(shear, pressure)| shear.abs() <= 0.4 * pressure + 1e-6 * peak));
    assert!(shear.iter().zip(&map.pressure).any(|(shear, pressure)| shear.abs() < 0.2 * pressure));
}

/// A slide in pieces, and a table of depth and slide, are what one entry, and the entries, are.
#[test]
fn a_slide_may_be_cut_and_told_by_a_table() {
    let rest = format!("steps: 4, {COULOMB}, solver: HalfSpace(grid: 32, window: 7.2e-4)");
    let whole = outcome(BALL, "Press(to: 2e-3, over: 1), Slide(to: 2e-6, over: 1), Slide(to: -1e-6, over: 1)", &rest);
    let cut = outcome(
        BALL,
        "Press(to: 2e-3, over: 1), Slide(to: 5e-7, over: 0.25), Slide(to: 2e-6, over: 0.75), Slide(to: 0, over: 0.5), Slide(to: -1e-6, over: 0.5)",
        &rest,
    );
    let (one, other) = (last(&whole), last(&cut));
    assert!(
        (tangential(one) / tangential(other) - 1.0).abs() < 1e-6
            && (dissipated(one) / dissipated(other) - 1.0).abs() < 1e-5
    );
    let table = outcome(BALL, "Table(\"motion.csv\")", &rest);
    let bed = outcome(BALL, "Table(\"motion.csv\")", &format!("steps: 4, {COULOMB}"));
    assert!(apart(&bed, &table, tangential) < 8.0 * SQUARE * 2.25, "{}", apart(&bed, &table, tangential));
}

/// Under a force that grows while the contact slides the depth is a curve: pixels and bed follow it alike.
#[test]
fn a_force_may_grow_under_a_slide() {
    let history = "Press(to: 1e-3, over: 1), Table(\"rising.csv\")";
    let rising: [(&str, &[f64]); 3] = [("time_s", &[0.0, 1.0]), ("force_n", &[1e-3, 4e-3]), ("slide_m", &[0.0, 2e-6])];
    let tables = InMemory::default().with("rising.csv", &rising);
    let [bed, pixels] = ["", PIXELS].map(|solver| {
        let text = format!(
            "(shape: {BALL}, bodies: ({RUBBER}, {RUBBER}), history: [{history}], steps: 2, {COULOMB}, {solver})"
        );
        let plan = Notation::Ron.plan(&text, &tables).unwrap_or_else(|errors| panic!("{}", errors[0]));
        run(&plan, FIELDS).unwrap()
    });
    let (one, other) = (tangential(last(&bed)), tangential(last(&pixels)));
    // Chords within 1e-4 of the depth.
    assert!((one / other - 1.0).abs() < 4.0 * SQUARE + 1e-4, "{one} {other}");
}

/// Gross sliding acts on the pressure of each pixel: τ = τ₀ + αp is τ₀A + αF, whatever the surface and what lies beneath.
#[test]
fn a_law_of_the_pressure_acts_on_each_pixel() {
    let law = "friction: Pressure(shear: 2e3, slope: 0.1)";
    let history = "Press(to: 1e-4, over: 1), Slide(to: 1e-6, over: 1), Press(to: 5e-5, over: 1)";
    for shape in [BALL, ROUGH, "FlatPunch(radius: 2e-4)"] {
        let outcome = outcome(shape, history, &format!("steps: 2, {law}, solver: HalfSpace(grid: 64)"));
        let slid = outcome.records.iter().rfind(|record| record.time <= 2.0).unwrap();
        let right = 2e3 * slid.pixels.unwrap().area + 0.1 * slid.normal.force;
        assert!((tangential(slid) / right - 1.0).abs() < 1e-9, "{shape}: {} {right}", tangential(slid));
        assert!((outcome.number("friction_dissipated_j").unwrap() / (right * 1e-6) - 1.0).abs() < 1e-9);
        // Let go to half of the load it keeps what that can hold.
        let (end, half) = (last(&outcome), 2e3 * last(&outcome).pixels.unwrap().area + 0.1 * 5e-5);
        assert!((tangential(end) / half - 1.0).abs() < 1e-9, "{shape}");
        let whole = end.normal.contact_radius.map_or(end.pixels.unwrap().area, |radius| PI * radius.powi(2));
        assert!((end.stick_area().unwrap() / whole - 1.0).abs() < 1e-12, "{shape}");
    }
    // Where the pressure bears more than the strength the strength is what holds.
    let capped = outcome(
        BALL,
        "Press(to: 5e-3, over: 1), Slide(to: 1e-6, over: 1)",
        "steps: 1, friction: CoulombOrowan(coefficient: 0.4, shear_limit: 5e3), solver: HalfSpace(grid: 96)",
    );
    let bed = outcome(
        BALL,
        "Press(to: 5e-3, over: 1), Slide(to: 1e-6, over: 1)",
        "steps: 1, friction: CoulombOrowan(coefficient: 0.4, shear_limit: 5e3)",
    );
    let (one, other) = (tangential(last(&bed)), tangential(last(&capped)));
    assert!(one < 0.9 * 0.4 * 5e-3 && (one / other - 1.0).abs() < 2e-3, "{one} {other}");
}

/// What friction on pixels is not, is said by name.
#[test]
fn what_pixels_cannot_slide_is_refused() {
    let gel = "Viscoelastic(poisson: 0.5, shear: (equilibrium: 1e5, terms: [(modulus: 1e5, time: 1)]))";
    for (body, rest, words) in [
        (gel, "friction: Coulomb(coefficient: 0.3)", "crept"),
        (RUBBER, "friction: Pressure(shear: 1e3, slope: 0), adhesion: Jkr(work: 0.01)", "how shear weakens"),
        (
            RUBBER,
            "friction: Coulomb(coefficient: 0.3), wear: Archard(coefficient: \"1e-15 m^2/N\")",
            "rings of a round contact",
        ),
    ] {
        let text = format!(
            "(shape: {BALL}, bodies: ({body}, Rigid), history: [Press(to: 1e-3, over: 1), Slide(to: 1e-6, over: 1)], {rest}, solver: HalfSpace(grid: 32))"
        );
        let problems = Notation::Ron.plan(&text, &InMemory::default()).err().unwrap_or_default();
        assert!(problems.iter().any(|problem| problem.to_string().contains(words)), "{words}: {problems:?}");
    }
    // A wave pressed flat sticks whatever it is slid.
    let text = format!(
        "(shape: {ROUGH}, bodies: ({RUBBER}, Rigid), history: [Press(to: 1, over: 1), Slide(to: 1e-6, over: 1)], {COULOMB}, steps: 1, solver: HalfSpace(grid: 32))"
    );
    let plan = Notation::Ron.plan(&text, &InMemory::default()).unwrap();
    let error = run(&plan, Wanted::NOTHING).unwrap_err().to_string();
    assert!(error.contains("full contact of a surface that repeats"), "{error}");
    // Pressed flat and let go without a slide it carries nothing, and slides then as one never pressed flat.
    let rest = format!("steps: 2, {COULOMB}, solver: HalfSpace(grid: 32)");
    let [flat, never] =
        ["Press(to: 1, over: 1), Press(to: 1e-4, over: 1)", "Press(to: 1e-4, over: 2)"].map(|history| {
            let outcome = outcome(ROUGH, &format!("{history}, Slide(to: 5e-8, over: 1)"), &rest);
            assert!(outcome.records.iter().all(|record| record.time > 2.0 || tangential(record).abs() <= 0.0));
            tangential(last(&outcome))
        });
    // Each takes the stiffness along the way from the waves of its own greatest load: 1 − G*/E* = 0.18 of what their mean
    // direction differs by, of which a surface of four waves along a side has some tenths.
    assert!((flat / never - 1.0).abs() < 0.03, "{flat} {never}");
}
