//! `springbed compare` as a person or a script meets it.

#![cfg(feature = "cli")]
#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

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

/// What the half-space cannot do is left out by name; the rest is compared.
#[test]
fn adhesion_leaves_the_half_space_out() {
    let (folder, output) = compare(&scene("Paraboloid(radius: \"10 mm\")", "adhesion: Jkr(work: \"50 mJ/m^2\"),"), &[]);
    let said = String::from_utf8(output.stdout).unwrap();
    assert!(
        said.contains("note: adhesion: the half-space solver computes the frictionless elastic contact only"),
        "{said}"
    );
    assert!(said.contains("closed form (Johnson, Kendall & Roberts)") && !said.contains("half-space   "), "{said}");
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
