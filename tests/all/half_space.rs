//! Scenes on the pixels of a half-space: against closed forms, against the solver called by hand, under the laws
//! that elastic bodies obey, and what is said where the answer leaves its meaning.

use ndarray::Array2;
use springbed::check::theory::{NominallyFlat, area_fraction};
use springbed::halfspace::{Boundary, Prescribed, PressedMap, Settings, Start, solve};
use springbed::prelude::*;
use springbed::run::named::Finding;
use springbed::run::record::{AREA, Outcome, Record};
use std::f64::consts::{PI, TAU};

const FIELDS: Wanted = Wanted { fields: true, ..Wanted::NOTHING };

fn planned(text: &str, tables: &InMemory) -> Result<Outcome, String> {
    let plan = Notation::Ron.plan(text, tables).map_err(|errors| errors[0].to_string())?;
    run(&plan, FIELDS).map_err(|error| error.to_string())
}

fn on_pixels(text: &str) -> Outcome {
    planned(text, &InMemory::default()).unwrap_or_else(|error| panic!("{error}"))
}

/// A shape on E* = 1 with a history and what else the scene has.
fn pressed(shape: &str, history: &str, more: &str) -> String {
    format!("(shape: {shape}, bodies: (Elastic(young: 1, poisson: 0), Rigid), history: [{history}], {more})")
}

fn last(outcome: &Outcome) -> Record {
    *outcome.records.last().unwrap()
}

/// Waves with a phase of their own each, on 32 × 32 pixels.
fn waves() -> Array2<f64> {
    Array2::from_shape_fn((32, 32), |(i, j)| {
        let (y, x) = (TAU * i as f64 / 32.0, TAU * j as f64 / 32.0);
        1e-3 * ((2.0 * x).cos()
            + (3.0 * y + 1.0).cos()
            + 0.5 * (4.0 * x - 3.0 * y).sin()
            + 0.2 * (7.0 * x + 5.0 * y).cos())
    })
}

fn map_pressed(history: &str, more: &str) -> Result<Outcome, String> {
    let tables = InMemory::default().with_heights("map.csv", waves());
    planned(&pressed("HeightMap(\"map.csv\", 0.03125)", history, more), &tables)
}

/// R = E* = 1, d = 0.01, a = 0.1: every error is within its envelope of second order, whatever the grid.
#[test]
fn hertz_within_the_envelope_of_second_order() {
    for grid in [32, 64, 128] {
        let more = format!("solver: HalfSpace(grid: {grid}, window: 0.3), steps: 1");
        let outcome = on_pixels(&pressed("Paraboloid(radius: 1)", "Indent(to: 0.01, over: 1)", &more));
        let state = last(&outcome);
        let part = |found: f64, right: f64| (found / right - 1.0) * (grid as f64 / 3.0).powi(2);
        assert!(part(state.normal.force, 4e-3 / 3.0).abs() < 0.125, "{grid}");
        assert!(part(state.normal.stored.stored(), 0.4 * 4e-5 / 3.0).abs() < 0.25, "{grid}");
        assert!(part(outcome.number("peak_pressure_pa").unwrap(), 0.2 / PI).abs() < 0.375, "{grid}");
        assert!(part(state.normal.contact_radius.unwrap(), 0.1).abs() < 0.25, "{grid}");
        // The stiffness is that of a punch whose ragged edge is within half a pixel.
        assert!((state.normal.stiffness / 0.2 - 1.0).abs() < 1.5 / grid as f64, "{grid}");
        let area = outcome.number("area_m2").unwrap();
        assert!((area / (0.01 * PI) - 1.0).abs() < 3.0 / grid as f64, "{grid}: {area}");
    }
}

/// The window is found from the contact, of whatever scale, under a depth and under a force.
#[test]
fn the_window_is_three_times_the_contact() {
    for scale in [1e-9, 1.0, 1e6] {
        let shape = format!("Paraboloid(radius: {scale:e})");
        let depth = format!("Indent(to: {:e}, over: 1)", 0.01 * scale);
        let force = format!("Press(to: {:e}, over: 1)", 4e-3 / 3.0 * scale * scale);
        for history in [depth, force] {
            let outcome = on_pixels(&pressed(&shape, &history, "solver: HalfSpace(grid: 64), steps: 1"));
            let (map, state) = (outcome.map.clone().unwrap(), last(&outcome));
            let window = 64.0 * map.pixel[0] / scale;
            assert!((0.29..0.33).contains(&window), "{scale:e}, {history}: {window}");
            assert!((state.normal.force / (4e-3 / 3.0 * scale * scale) - 1.0).abs() < 3e-4, "{scale:e}, {history}");
            assert!((state.normal.indentation.unwrap() / (0.01 * scale) - 1.0).abs() < 3e-4, "{scale:e}, {history}");
            let area = (AREA.of)(&state).unwrap() / (0.01 * PI * scale * scale);
            assert!((area - 1.0).abs() < 0.05, "{scale:e}, {history}: {area}");
            // What is said is of the ball, which is steep for a compressible body, not of the window.
            assert!(outcome.warnings.iter().all(|warning| warning.contains("slope")), "{:?}", outcome.warnings);
        }
    }
}

/// The elliptic contact is exact on pixels: Johnson's example of crossed cylinders with R₁/R₂ = 10.
#[test]
fn an_ellipsoid_has_its_own_ellipse() {
    use springbed::contact::elliptic::EllipticHertz;
    let right = EllipticHertz::at_indentation([1.0, 0.1], 1.0, 1e-3).unwrap();
    let shape = "Ellipsoid(radius_x: 1, radius_y: 0.1)";
    let outcome = on_pixels(&pressed(shape, "Indent(to: 1e-3, over: 1)", "solver: HalfSpace(grid: 96), steps: 1"));
    let (state, map) = (last(&outcome), outcome.map.clone().unwrap());
    let second = (3.0_f64 / 96.0).powi(2);
    assert!((state.normal.force / right.force - 1.0).abs() < 0.25 * second);
    assert!((outcome.number("peak_pressure_pa").unwrap() / right.peak_pressure - 1.0).abs() < 0.375 * second);
    let [a, b] = right.semi_axes;
    assert!((state.normal.contact_radius.unwrap() / (a * b).sqrt() - 1.0).abs() < 0.5 * second);
    assert!((96.0 * map.pixel[0] / a - 3.0).abs() < 0.4 && (96.0 * map.pixel[1] / b - 3.0).abs() < 0.4);
}

/// A ball is the same from all sides.
#[test]
fn the_pressure_of_a_ball_is_symmetric() {
    let outcome =
        on_pixels(&pressed("Sphere(radius: 1)", "Press(to: 1e-3, over: 1)", "solver: HalfSpace(grid: 64), steps: 1"));
    let pressure = outcome.map.unwrap().pressure;
    let peak = pressure.iter().copied().fold(0.0, f64::max);
    for ((row, column), here) in pressure.indexed_iter().filter(|((row, column), _)| row.min(column) > &0) {
        for there in [(column, row), (64 - row, column), (row, 64 - column)] {
            assert!((here - pressure[there]).abs() < 1e-6 * peak, "{row} {column}");
        }
    }
}

/// dU = F dd along a rough history, to the fourth order of the trapezoid with its ends corrected by the stiffness: one
/// law for force, depth, energy and stiffness together.
#[test]
fn energy_is_the_work_and_stiffness_its_second_derivative() {
    for boundary in ["Free", "Periodic"] {
        let more = format!("solver: HalfSpace(boundary: {boundary}), steps: 40");
        let outcome = map_pressed("Press(to: 2e-3, over: 1)", &more).unwrap();
        let mut sum = 0.0;
        for pair in outcome.records.windows(2).skip(10) {
            let [one, two] = [&pair[0].normal, &pair[1].normal];
            let step = two.indentation.unwrap() - one.indentation.unwrap();
            let work = 0.5 * step * (one.force + two.force) + step * step / 12.0 * (one.stiffness - two.stiffness);
            let gained = two.stored.stored() - one.stored.stored();
            assert!((gained / work - 1.0).abs() < 2e-3, "{boundary}: {gained:e} {work:e}");
            sum += gained - work;
        }
        assert!(sum.abs() < 2e-4 * last(&outcome).normal.stored.stored(), "{boundary}: {sum:e}");
    }
}

/// What was solved by hand: the same area, pressure and depth.
#[test]
fn a_map_is_that_of_the_solver() {
    for boundary in [Boundary::Free, Boundary::Periodic] {
        let more = format!("solver: HalfSpace(boundary: {boundary:?}), steps: 1");
        let outcome = map_pressed("Press(to: 1e-3, over: 1)", &more).unwrap();
        let heights = waves().mapv(|height| -height);
        let control = Prescribed::Force(1e-3);
        let map = PressedMap { heights: heights.view(), pixel: [1.0 / 32.0; 2], modulus: 1.0, boundary, control };
        let right = solve(&map, Start::Coarser, &Settings::default()).unwrap();
        let found = outcome.map.as_ref().unwrap();
        assert_eq!(found.pressure, right.pressure);
        let lowest = heights.iter().copied().fold(f64::INFINITY, f64::min);
        let depth = last(&outcome).normal.indentation.unwrap();
        assert!((depth - (right.indentation - lowest)).abs() < 1e-15);
        assert_eq!(outcome.number("area_m2"), Some(right.corrected_area()));
        assert_eq!(outcome.named("contact_pixels"), Some(Finding::Count(right.contact_pixels())));
        // Where there is pressure there is no gap, and the rest of the gap is the mean.
        assert!(found.gap.iter().zip(&found.pressure).all(|(gap, pressure)| *gap >= 0.0 && gap * pressure == 0.0));
        assert!((found.gap.mean().unwrap() / outcome.number("mean_gap_m").unwrap() - 1.0).abs() < 1e-12);
    }
}

/// The way back is the way in, and a force leads to the state of its depth.
#[test]
fn states_have_no_past() {
    let more = "solver: HalfSpace(), steps: 5";
    let there = map_pressed("Indent(to: 1.5e-3, over: 1), Indent(to: 0, over: 1)", more).unwrap();
    let records = &there.records;
    assert_eq!(records.len(), 11);
    for (into, out) in records.iter().zip(records.iter().rev()) {
        let apart = (into.normal.force - out.normal.force).abs();
        assert!(apart <= 1e-12 * records[5].normal.force && into.pixels == out.pixels);
    }
    let force = format!("Press(to: {:?}, over: 1), Hold(over: 1), HoldForce(over: 1)", records[5].normal.force);
    let same = map_pressed(&force, more).unwrap();
    let state = last(&same);
    assert!((state.normal.indentation.unwrap() / 1.5e-3 - 1.0).abs() < 1e-6);
    assert!((state.pixels.unwrap().area / records[5].pixels.unwrap().area - 1.0).abs() < 1e-12);
    let wave = map_pressed(
        "Indent(to: 1e-3, over: 1), Oscillate(amplitude: 2e-3, frequency: 1, cycles: 1), Retract(speed: 1)",
        more,
    );
    let wave = wave.unwrap();
    assert!(
        wave.records.iter().any(|record| record.normal.indentation.unwrap() < -0.9e-3 && record.normal.force == 0.0)
    );
    let parted = last(&wave);
    assert!(
        parted.normal.force == 0.0 && parted.normal.indentation == Some(0.0) && (parted.time - 2.001).abs() < 1e-12
    );
}

#[test]
fn any_number_of_threads_gives_the_same_bits() {
    let with = |threads| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
        pool.install(|| map_pressed("Press(to: 1e-3, over: 1)", "solver: HalfSpace(grid: 128), steps: 3").unwrap())
    };
    assert_eq!(with(1), with(3));
}

/// Concentric waves whose second ring touches before the first is full: no bed follows, the pixels do.
#[test]
fn rings_that_the_bed_refuses() {
    let shape = "WavyParaboloid(radius: 1, amplitude: 0.01, wavelength: 0.25)";
    let history = "Indent(to: 0.05, over: 1)";
    let refused = planned(&pressed(shape, history, ""), &InMemory::default()).unwrap_err();
    assert!(refused.contains("deeper than"), "{refused}");
    let outcome = on_pixels(&pressed(shape, history, "solver: HalfSpace(grid: 192), steps: 4"));
    let patches: Vec<usize> = outcome.records.iter().map(|record| record.pixels.unwrap().patches).collect();
    assert!(patches[1] == 1 && *patches.last().unwrap() > 1, "{patches:?}");
    assert!(last(&outcome).normal.contact_radius.is_none());
    // Deeper than a sphere is not computed by either.
    let sphere =
        planned(&pressed("Sphere(radius: 1)", "Indent(to: 2, over: 1)", "solver: HalfSpace()"), &InMemory::default());
    assert!(sphere.unwrap_err().contains("deeper than"));
}

/// A random surface that repeats: pressed flat it is told, by depth no further than that.
#[test]
fn full_contact_of_what_repeats() {
    let shape = "RoughLine(spectrum: SelfAffine(hurst: 0.8, rms: 1e-3, long: 1, short: 0.25), length: 1, points: 64)";
    let flat = on_pixels(&pressed(shape, "Press(to: 1, over: 1)", "solver: HalfSpace(grid: 64), steps: 4"));
    assert_eq!(flat.number("area_fraction"), Some(1.0));
    assert_eq!((flat.number("mean_gap_m"), flat.named("gap_percolates")), (Some(0.0), Some(Finding::Answer(false))));
    assert!(flat.warnings.iter().any(|warning| warning.contains("full contact is reached")), "{:?}", flat.warnings);
    // What may lie between pixels moves no force that is given, however stiff the full contact is.
    let back = on_pixels(&pressed(
        shape,
        "Press(to: 1e3, over: 1), Indent(to: 1e-3, over: 1)",
        "solver: HalfSpace(grid: 64), steps: 4",
    ));
    assert!(back.error_estimate.relative < 0.1, "{:?}", back.error_estimate);
    let deep =
        planned(&pressed(shape, "Indent(to: 0.1, over: 1)", "solver: HalfSpace(grid: 64)"), &InMemory::default());
    let deep = deep.unwrap_err();
    assert!(deep.starts_with("history[0]: 5.0000e-3 m is deeper than 2.4580e-3 m"), "{deep}");
    // Two pixels on the shortest wave blunt its summits, fewer do not carry it.
    let coarse = on_pixels(&pressed(shape, "Press(to: 1e-5, over: 1)", "solver: HalfSpace(grid: 8), steps: 1"));
    assert!(coarse.warnings.iter().any(|warning| warning.contains("solver.grid")), "{:?}", coarse.warnings);
    let shape = shape.replace("0.25", "0.2");
    let missed = planned(&pressed(&shape, "Press(to: 1, over: 1)", "solver: HalfSpace(grid: 8)"), &InMemory::default());
    assert!(missed.unwrap_err().contains("spectrum finer than the grid"));
}

/// The stated error is not below the true one, of force and area.
#[test]
fn the_stated_error_holds() {
    for (shape, radius) in [("Paraboloid(radius: 1)", 0.1), ("Cone(slope: 0.1)", 0.2 / PI)] {
        for grid in [48, 96, 192] {
            let more = format!("solver: HalfSpace(grid: {grid}), steps: 1");
            let outcome = on_pixels(&pressed(shape, "Indent(to: 0.01, over: 1)", &more));
            let stated = outcome.error_estimate.relative;
            let right = if shape.starts_with("Cone") { 2e-4 / (0.1 * PI) } else { 4e-3 / 3.0 };
            let force = (last(&outcome).normal.force / right - 1.0).abs();
            assert!(force <= stated, "{shape} {grid}: {force:e} {stated:e}");
            assert!(stated < 2.0 / grid as f64, "{shape} {grid}: {stated:e}");
            let area = (outcome.number("area_m2").unwrap() / (PI * radius * radius) - 1.0).abs();
            assert!(area <= stated, "{shape} {grid}: {area:e} {stated:e}");
        }
    }
}

/// The shares of all pressures and gaps together are one, and the pressures carry the force.
#[test]
fn distributions_are_shares_of_the_area() {
    let outcome = map_pressed("Press(to: 1e-3, over: 1)", "solver: HalfSpace(boundary: Periodic), steps: 8").unwrap();
    let table = outcome.table("distribution").unwrap();
    let column = |name: &str| table.column(name).unwrap().numbers().iter().map(|x| x.unwrap()).collect::<Vec<f64>>();
    let [force, pressure, of_pressure, gap, of_gap] =
        ["force", "pressure", "pressure_density", "gap", "gap_density"].map(column);
    let classes = 48;
    assert_eq!(force.len() % classes, 0);
    for first in (0..force.len()).step_by(classes) {
        let range = first..first + classes;
        let sum = |density: &[f64], middle: &[f64]| density[range.clone()].iter().sum::<f64>() * 2.0 * middle[first];
        assert!((sum(&of_pressure, &pressure) + sum(&of_gap, &gap) - 1.0).abs() < 1e-12);
        let width = 2.0 * pressure[first];
        let carried: f64 = range.clone().map(|k| of_pressure[k] * pressure[k] * width).sum();
        assert!((carried / force[first] - 1.0).abs() < 0.05, "{carried} {}", force[first]);
    }
    assert!((force.last().unwrap() / 1e-3 - 1.0).abs() < 1e-12);
}

/// A window too small for the contact is told, and so is a map that ends.
#[test]
fn borders_are_told() {
    let narrow = on_pixels(&pressed(
        "Paraboloid(radius: 1)",
        "Indent(to: 0.01, over: 1)",
        "solver: HalfSpace(grid: 32, window: 0.1), steps: 1",
    ));
    assert!(narrow.warnings.iter().any(|warning| warning.contains("meets the border of the window")));
    let map = map_pressed("Press(to: 1e-3, over: 1)", "solver: HalfSpace(), steps: 1").unwrap();
    assert!(map.warnings.iter().any(|warning| warning.contains("the map ends at its border")));
}

/// Two measured surfaces against each other are the sum of both, tilt and unit, holes and spikes set right.
#[test]
fn maps_against_each_other() {
    let clean = waves();
    let more = "solver: HalfSpace(), steps: 2";
    let right = map_pressed("Press(to: 1e-3, over: 1)", more).unwrap();
    // Half of it each, the one in thousandths and tilted.
    let tilted =
        Array2::from_shape_fn((32, 32), |(i, j)| 500.0 * clean[[i, j]] + 0.3 * i as f64 - 0.2 * j as f64 + 7.0);
    let other = clean.mapv(|height| 0.5 * height);
    let tables = InMemory::default().with_heights("one", tilted.clone()).with_heights("two", other);
    let shape = |rest: &str| format!("Topography(file: \"one\", pixel: 0.03125, unit: 1e-3, tilt: Removed, {rest})");
    let against = "against: HeightMap(\"two\", 0.03125)";
    let history = "Press(to: 1e-3, over: 1)";
    let both = planned(&pressed(&shape(against), history, more), &tables).unwrap();
    // The waves have no plane in them but for their ends; where they end the plane of least squares sees it.
    let (one, two) = (right.number("area_m2").unwrap(), both.number("area_m2").unwrap());
    assert!((one / two - 1.0).abs() < 0.05, "{one} {two}");
    // A hole is refused with its place, and filled if one asks for it; a spike goes with it.
    let mut broken = tilted;
    broken[[3, 4]] = f64::NAN;
    broken[[20, 9]] = 900.0;
    let tables = InMemory::default().with_heights("one", broken).with_heights("two", clean.mapv(|height| 0.5 * height));
    let refused = planned(&pressed(&shape(against), history, more), &tables).unwrap_err();
    assert!(refused.contains("the height in row 4, column 5 is missing, and 1 of 1024 are"), "{refused}");
    let mended = format!("{against}, missing: Filled, outliers: 15");
    let mended = planned(&pressed(&shape(&mended), history, more), &tables).unwrap();
    assert!((mended.number("area_m2").unwrap() / two - 1.0).abs() < 0.05);
    assert!((mended.number("peak_to_valley_m").unwrap() / both.number("peak_to_valley_m").unwrap() - 1.0).abs() < 0.05);
    // The bed takes it too, and what does not fit is told.
    assert!(planned(&pressed(&shape("missing: Filled"), history, ""), &tables).is_ok());
    let small =
        InMemory::default().with_heights("one", Array2::zeros((8, 8))).with_heights("two", Array2::zeros((8, 9)));
    let refused = planned(&pressed(&shape(against), history, more), &small).unwrap_err();
    assert!(refused.contains("expected maps that cover each other"), "{refused}");
    let cone = planned(&pressed(&shape("against: Cone(slope: 1)"), history, more), &small).unwrap_err();
    assert!(cone.contains("stands against a Cone"), "{cone}");
    let unknown = planned(&pressed("Topography(file: \"one\")", history, more), &small).unwrap_err();
    assert!(unknown.contains("does not say how large a pixel is"), "{unknown}");
}

/// Two balls at a distance D lift each other off by F/(πE*D), the next term is (a/D)³; one that stands back takes less.
#[test]
fn tips_lift_each_other_off() {
    let (depth, apart) = (0.01, 0.8);
    let tips = |height: f64| {
        format!(
            "Tips([(shape: Paraboloid(radius: 1), x: 0.4), (shape: Paraboloid(radius: 1), x: -0.4, height: {height:?})])"
        )
    };
    let more = "solver: HalfSpace(grid: 384), steps: 1";
    let outcome = on_pixels(&pressed(&tips(0.0), "Indent(to: 0.01, over: 1)", more));
    let mut one = 0.0;
    for _ in 0..100 {
        one = 4.0 / 3.0 * (depth - one / (PI * apart)).powf(1.5);
    }
    let force = last(&outcome).normal.force;
    assert!((force / (2.0 * one) - 1.0).abs() < 2e-3, "{force} {one}");
    assert_eq!(outcome.named("contact_patches"), Some(Finding::Count(2)));
    assert!(last(&outcome).normal.contact_radius.is_none());
    let back = on_pixels(&pressed(&tips(0.02), "Indent(to: 0.01, over: 1)", more));
    assert_eq!(back.named("contact_patches"), Some(Finding::Count(1)));
    assert!((last(&back).normal.force / (4e-3 / 3.0) - 1.0).abs() < 2e-3);
    let bed = planned(&pressed(&tips(0.0), "Indent(to: 0.01, over: 1)", ""), &InMemory::default()).unwrap_err();
    assert!(bed.contains("each tip lifts the others off"), "{bed}");
    let none = planned(&pressed("Tips([])", "Indent(to: 0.01, over: 1)", more), &InMemory::default()).unwrap_err();
    assert!(none.contains("has no tip"), "{none}");
}

/// Persson's area beside that of the pixels, on a flat, elastic, without adhesion, and of nothing else; the pixels find a
/// quarter to a half more at small loads.
#[test]
fn theories_stand_beside_what_they_are_made_for() {
    let rough = "RoughLine(spectrum: SelfAffine(hurst: 0.8, rms: 1e-2, long: 1, short: 0.1), length: 1, points: 64)";
    let flat = |shape: &str, more: &str| {
        let text = pressed(shape, "Press(to: 5e-3, over: 1)", &format!("steps: 1, {more}"));
        let plan = Notation::Ron.plan(&text, &InMemory::default()).unwrap_or_else(|errors| panic!("{}", errors[0]));
        (NominallyFlat::of(&plan), plan)
    };
    let (theory, plan) = flat(rough, "solver: HalfSpace(grid: 64)");
    let theory = theory.unwrap();
    let found = last(&run(&plan, FIELDS).unwrap()).pixels.unwrap().area_fraction;
    let slope = plan.surface().unwrap().roughness().rms_slope;
    assert!((theory.persson(5e-3) / area_fraction(5e-3, 1.0, slope) - 1.0).abs() < 1e-14);
    assert!(found / theory.persson(5e-3) > 1.0 && found / theory.persson(5e-3) < 1.6, "{found} {theory:?}");
    let summits = theory.greenwood_williamson(5e-3).unwrap();
    assert!(summits > 0.0 && summits < found, "{summits}");
    let (bed, _) = flat(rough, "");
    assert_eq!(bed, Some(theory));
    for (shape, more) in [
        ("Paraboloid(radius: 1)", "solver: HalfSpace(grid: 64)"),
        (rough, "solver: HalfSpace(grid: 64), adhesion: Maugis(work: 1e-4, stress: 0.1)"),
    ] {
        assert_eq!(flat(shape, more).0, None, "{shape} {more}");
    }
}

/// However many records are asked for, the window is the same: of bodies that remember and attract each other.
#[test]
fn a_window_is_that_of_the_motion() {
    let pixel = |steps: u32| {
        let text = format!(
            r#"(shape: Paraboloid(radius: 2.8e-6), bodies: (Viscoelastic(poisson: 0.5, shear: (equilibrium: 5.6e3,
            terms: [(modulus: 3.2e4, time: 18), (modulus: 1e3, time: 1.8e3)])), Elastic(young: 3.6e4, poisson: 0.5)),
            adhesion: Maugis(work: 2e-7, stress: 4e3), solver: HalfSpace(grid: 32), steps: {steps},
            history: [Indent(to: 5.6e-10, over: 180)])"#
        );
        on_pixels(&text).map.unwrap().pixel.map(f64::to_bits)
    };
    let [one, four, forty] = [1, 4, 40].map(pixel);
    assert!(one == four && four == forty, "{one:?} {four:?} {forty:?}");
}
