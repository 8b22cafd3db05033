//! `springbed compare` as a person or a script meets it.

use serde_json::Value;
use std::process::{Command, Output, Stdio};
use tempfile::TempDir;

fn compare(scene: &str, arguments: &[&str]) -> (TempDir, Output) {
    let folder = TempDir::new().unwrap();
    let path = folder.path().join("scene.ron");
    std::fs::write(&path, scene).unwrap();
    let mut command = Command::new(env!("CARGO_BIN_EXE_springbed"));
    command.stdin(Stdio::null()).arg("compare").arg(&path).args(arguments).arg("--out").arg(folder.path().join("out"));
    let output = command.output().unwrap();
    (folder, output)
}

fn scene(shape: &str, rest: &str) -> String {
    format!(
        "(shape: {shape}, bodies: (Elastic(young: \"2 GPa\", poisson: 0.3), Rigid), {rest} history: [Indent(to: \"1 um\", over: 1)])"
    )
}

fn rows(scene: &str) -> (Value, Vec<Value>) {
    let (_folder, output) = compare(scene, &["--json", "--format", "csv"]);
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    let value: Value = serde_json::from_slice(&output.stdout).unwrap();
    let rows = value["rows"].as_array().unwrap().clone();
    (value, rows)
}

fn error(rows: &[Value], method: &str, fineness: (&str, u64), of: &str) -> f64 {
    let row = rows.iter().find(|row| row["method"] == method && row[fineness.0].as_u64().unwrap_or(0) == fineness.1);
    row.unwrap()[of].as_f64().unwrap()
}

/// Second order of both methods, by their own bounds: the bed's envelope −1/4 ≤ ε(a/h)² ≤ 1/8, and 1/8 (pixel/a)² of the half-space.
#[test]
fn hertz_by_three_methods() {
    let (value, rows) = rows(&scene("Paraboloid(radius: \"10 mm\")", ""));
    assert_eq!(value["reference"], "closed form");
    for of in ["force_error", "radius_error", "pressure_error"] {
        assert!(error(&rows, "direct", ("springs", 0), of).abs() < 1e-14, "{of}");
    }
    for springs in [32_u32, 512, 2048] {
        let width = 17.0 / 16.0 / f64::from(springs);
        let found = error(&rows, "springs", ("springs", springs.into()), "force_error") / (width * width);
        assert!((-0.25..0.125 + 1e-3).contains(&found), "{springs}: {found}");
    }
    if cfg!(feature = "half-space") {
        for grid in [64_u32, 256, 1024] {
            let square = (3.0 / f64::from(grid)).powi(2);
            assert!(error(&rows, "half-space", ("grid", grid.into()), "force_error").abs() < 0.125 * square, "{grid}");
            assert!(
                error(&rows, "half-space", ("grid", grid.into()), "pressure_error").abs() < 0.375 * square,
                "{grid}"
            );
        }
        // What every solver of constant pixels reaches.
        assert!(error(&rows, "half-space", ("grid", 1024), "force_error").abs() < 6e-7);
    }
}

/// An ellipsoid keeps its two radii on the half-space; the beds' effective radius shows its price, −1 % in force at R₁/R₂ = 2.
#[cfg(feature = "half-space")]
#[test]
fn an_ellipsoid_is_itself_on_the_half_space() {
    let (value, rows) = rows(&scene("Ellipsoid(radius_x: \"10 mm\", radius_y: \"20 mm\")", ""));
    assert_eq!(value["reference"], "closed form (elliptic Hertz contact)");
    let direct = error(&rows, "direct", ("springs", 0), "force_error");
    assert!((-0.011..-0.009).contains(&direct), "{direct}");
    assert!(error(&rows, "half-space", ("grid", 512), "force_error").abs() < 0.125 * (3.0_f64 / 512.0).powi(2));
}

/// The half-space goes through an adhesive history too, over a ring of few pixels; the closed form stays the judge.
#[cfg(feature = "half-space")]
#[test]
fn an_adhesive_history_is_followed_on_pixels() {
    let more = "adhesion: Jkr(work: \"50 mJ/m^2\"), steps: 2, plots: [Force, Radius],";
    let (value, rows) = rows(&scene("Paraboloid(radius: \"10 mm\")", more));
    assert!(value["reference"].as_str().unwrap().starts_with("closed form (Johnson, Kendall & Roberts)"));
    assert!(error(&rows, "half-space", ("grid", 128), "force_error").abs() < 0.1);
}

/// What the half-space cannot do is left out by name; the rest is compared.
#[test]
fn what_pixels_do_not_have_leaves_the_half_space_out() {
    let gel = scene("Paraboloid(radius: \"10 mm\")", "adhesion: Jkr(work: \"50 mJ/m^2\", closing: \"10 mJ/m^2\"),");
    let (folder, output) = compare(&gel, &[]);
    let said = String::from_utf8(output.stdout).unwrap();
    assert!(said.contains("note: half-space: ") && said.contains("have no edge of their own"), "{said}");
    assert!(!said.contains("half-space   "), "{said}");
    let written = folder.path().join("out");
    assert!(written.join("scene.compare.csv").exists() && written.join("scene.compare.json").exists());
    assert_eq!(cfg!(feature = "plot"), written.join("scene.compare.svg").exists());
}

#[test]
fn bodies_that_never_press_cannot_be_compared() {
    let apart = scene("Cone(slope: 0.1)", "").replace("1 um", "-1 um");
    let (_folder, output) = compare(&apart, &[]);
    assert_eq!(output.status.code(), Some(1));
    assert!(String::from_utf8_lossy(&output.stderr).contains("the bodies never press on each other"));
}

const ROUGH: &str = "spectrum: SelfAffine(hurst: 0.8, rms: \"1 um\", long: \"100 um\", short: \"4 um\"), length: \"100 um\", points: 4096";

fn pressed(shape: &str) -> String {
    scene(shape, "").replace("Indent(to: \"1 um\"", "Press(to: \"0.3 N\"")
}

/// Rough shapes are compared under the force of the scene: stiffness agrees to tens of per cent, the share in contact is the half-space's.
#[cfg(feature = "half-space")]
#[test]
fn a_rough_surface_by_its_line_and_by_itself() {
    let (value, rows) = rows(&pressed(&format!("RoughLine({ROUGH}, seeds: 3)")));
    assert_eq!(value["reference"], "half-space on 512² pixels, the finest grid");
    // Measured over H and seeds: prefactors within 15 %, single surfaces scatter by as much.
    for points in [1024, 65536] {
        assert!(error(&rows, "springs", ("springs", points), "stiffness_error").abs() < 0.3);
    }
    // The same surface on the next coarser grid.
    assert!(error(&rows, "half-space", ("grid", 256), "stiffness_error").abs() < 0.02);
    let share = value["state"]["area_fraction"].as_f64().unwrap();
    assert!(share > 0.0 && share < 0.2, "{share}");
}

/// A surface too fine for the half-space is not tried, and the note says what it would take.
#[cfg(feature = "half-space")]
#[test]
fn a_surface_too_large_is_refused_before_it_is_tried() {
    for (short, points, words) in [("0.1 um", 4096, "needs 2000² pixels"), ("0.5 nm", 1_000_000, "bytes")] {
        let fine = ROUGH.replace("4 um", short).replace("4096", &points.to_string());
        let (_, output) = compare(&pressed(&format!("RoughLine({fine})")), &[]);
        let said = String::from_utf8(output.stdout).unwrap();
        assert!(output.status.success() && said.contains("note: half-space: ") && said.contains(words), "{said}");
    }
}

/// `explain` tells where the contact stays in one piece: everywhere under a ball; under a wavy ball up to 3.127e-2 m (R = 1, h = 0.01,
/// λ = 0.25), the number found from the gap of the solution.
#[test]
fn explain_tells_where_the_contact_is_in_one_piece() {
    let explained = |shape: &str, depth: &str| {
        let folder = TempDir::new().unwrap();
        let path = folder.path().join("scene.ron");
        std::fs::write(&path, scene(shape, "").replace("1 um", depth)).unwrap();
        let output = Command::new(env!("CARGO_BIN_EXE_springbed")).arg("explain").arg(&path).output().unwrap();
        String::from_utf8(output.stdout).unwrap()
    };
    let ball = explained("Paraboloid(radius: 1)", "1 um");
    assert!(ball.contains("connectivity    g(x) grows everywhere: one round contact"), "{ball}");
    let wavy = explained("WavyParaboloid(radius: 1, amplitude: 0.01, wavelength: 0.25)", "20 mm");
    assert!(
        wavy.contains("exact mapping, up to d = 3.127")
            && wavy.contains("as a cylinder on a half-plane (R = 1.000e0 m)"),
        "{wavy}"
    );
}

/// A wave by its closed form and by strips: the half width to a strip, the indentation to their square; a leaking seal is solved by strips alone.
#[cfg(feature = "half-space")]
#[test]
fn plane_scenes_by_the_half_plane() {
    let wave =
        scene("PlaneWave(amplitude: \"1 um\", wavelength: \"100 um\")", "").replace("1 um\", over", "0.5 um\", over");
    let (value, rows) = rows(&wave);
    assert_eq!(value["reference"], "closed form or series of the half-plane");
    let radius = value["state"]["contact_radius_m"].as_f64().unwrap();
    for strips in [128_u32, 2048, 32768] {
        let found = error(&rows, "half-plane", ("grid", strips.into()), "radius_error");
        assert!(found.abs() <= 1e-4 / f64::from(strips) / radius, "{strips}: {found}");
        let found = error(&rows, "half-plane", ("grid", strips.into()), "indentation_error");
        assert!(found.abs() < 2.0 * (3.2 / f64::from(strips)).powi(2) + 1e-7, "{strips}: {found}");
    }
    let seal =
        "PlaneWavy(radius: \"5 mm\", waves: [(amplitude: \"0.2 um\", wavelength: \"13.468 um\")], datum: \"10 mm\")";
    let (_, output) =
        compare(&scene(seal, "").replace("2 GPa", "9 MPa").replace("Indent(to: \"1 um\"", "Press(to: 500"), &[]);
    let said = String::from_utf8(output.stdout).unwrap();
    assert!(
        said.contains("note: the contact is not in one piece") && said.contains("half-plane on 131072 strips"),
        "{said}"
    );
}
