//! Whatever the bytes, the readers answer: a scene, a table, or a fault. They never panic.
//!
//! `FUZZ_INPUTS=1000000 cargo test --release --test all fuzz` tries a million inputs of each kind.

use proptest::prelude::*;
use proptest::test_runner::{Config, TestRunner};
use springbed::app::fault::Paint;
use springbed::app::scene_file::plan;
use springbed::app::table_file::TableFiles;
use springbed::input::table::Tables;
use std::path::Path;

/// Inputs of each kind; few by default.
fn inputs() -> u32 {
    std::env::var("FUZZ_INPUTS").ok().and_then(|count| count.parse().ok()).unwrap_or(1000)
}

fn run<S: Strategy>(strategy: S, check: impl Fn(S::Value)) {
    let config = Config { cases: inputs(), failure_persistence: None, ..Config::default() };
    let tried = TestRunner::new(config).run(&strategy, |value| {
        check(value);
        Ok(())
    });
    assert!(tried.is_ok(), "{tried:?}");
    println!("{} inputs tried", inputs());
}

/// Reads a scene; a fault must be printable and point into the text.
fn read_scene(text: &str) {
    if let Err(faults) = plan(Path::new("configs/scene.ron"), text) {
        assert!(!faults.is_empty());
        for fault in faults {
            assert!(!fault.rendered(Paint::Plain).is_empty());
            if let Some(position) = fault.position {
                assert!(position.line <= 1 + text.matches('\n').count(), "{position:?} in {text:?}");
            }
        }
    }
}

/// Pieces of which scenes are made, right and wrong.
const PIECES: &[&str] = &[
    "(",
    ")",
    "[",
    "]",
    "{",
    "}",
    ",",
    ":",
    "\"",
    "//",
    "/*",
    "*/",
    "\n",
    " ",
    "-",
    "1",
    "0",
    "1e400",
    "NaN",
    "inf",
    "1/3",
    "10 mm",
    "\"10 mm\"",
    "\"1 MPa\"",
    "\"µm\"",
    "µ",
    "\u{feff}",
    "#",
    "\\",
    "'",
    "r#\"",
    "0x1F",
    "1_0",
    "None",
    "Some(",
    "shape",
    "Paraboloid",
    "Sphere",
    "WavyParaboloid",
    "RoughLine",
    "radius",
    "bodies",
    "Elastic",
    "Rigid",
    "Viscoelastic",
    "shear",
    "terms",
    "history",
    "Indent",
    "Table",
    "Impact",
    "Oscillate",
    "to",
    "over",
    "speed",
    "springs",
    "solver",
    "HalfSpace",
    "grid",
    "steps",
    "99999999999999999999",
    "plots",
    "adhesion",
    "Jkr",
    "edge",
    "true",
    "()",
    "#![enable(",
];

const SCENES: &[&str] = &[
    "(shape: Paraboloid(radius: \"10 mm\"), bodies: (Elastic(young: \"210 GPa\", poisson: 0.3), Rigid), history: [Indent(to: \"1 um\", over: \"1 s\")])",
    "(title: \"x\", shape: Sphere(radius: 1), bodies: (Rigid, Viscoelastic(poisson: 0.5, shear: (equilibrium: 1, terms: [(modulus: 1, time: 1)]))), adhesion: Jkr(work: 0.1, edge: Relaxed), history: [Press(to: 1, over: 1), Retract(speed: 1)], accuracy: 1e-6, plots: [Force])",
    "(shape: WavyParaboloid(radius: 1, amplitude: 0.01, wavelength: 0.25), bodies: (Elastic(young: 1, poisson: 0), Rigid), friction: Coulomb(coefficient: 0.3), history: [Indent(to: 0.01, over: 1), Shake(amplitude: 1e-3, frequency: 1, cycles: 2), Table(\"h.csv\")], springs: 10, steps: 3)",
    "(shape: Cone(slope: 0.1), bodies: (Elastic(young: 1, poisson: 0), Rigid), history: [Impact(mass: 1, speed: [1, 2], angle: \"30 deg\")])",
];

#[test]
fn arbitrary_text_as_a_scene() {
    run(prop::collection::vec(any::<char>(), 0..200), |text| read_scene(&text.into_iter().collect::<String>()));
}

#[test]
fn pieces_of_scenes_in_any_order() {
    run(prop::collection::vec(0..PIECES.len(), 0..60), |pieces| {
        read_scene(&pieces.into_iter().map(|piece| PIECES[piece]).collect::<String>());
    });
}

#[test]
fn scenes_with_pieces_changed() {
    let change = (0usize..1000, 0usize..20, 0..PIECES.len());
    run((0..SCENES.len(), prop::collection::vec(change, 1..4)), |(scene, changes)| {
        let mut text: Vec<char> = SCENES[scene].chars().collect();
        for (at, removed, piece) in changes {
            let start = at % (text.len() + 1);
            let end = (start + removed).min(text.len());
            text.splice(start..end, PIECES[piece].chars());
        }
        read_scene(&text.into_iter().collect::<String>());
    });
}

/// Reads the bytes as the file of a table and of a scene.
fn read_files(folder: &Path, bytes: &[u8]) {
    std::fs::write(folder.join("t.csv"), bytes).unwrap();
    let tables = TableFiles::beside(&folder.join("scene.ron"));
    let names = tables.names(Path::new("t.csv"));
    for wanted in [&["radius_m", "height_m"][..], &["time_s"]] {
        match tables.columns(Path::new("t.csv"), wanted) {
            Ok(columns) => {
                assert!(names.is_ok());
                assert!(columns.values.iter().all(|column| column.len() == columns.rows.len()));
                assert!(columns.values.iter().flatten().all(|value| value.is_finite()));
            }
            Err(error) => assert!(error.to_string().contains("t.csv")),
        }
    }
    let text = "(shape: Table(\"t.csv\"), bodies: (Elastic(young: 1, poisson: 0), Rigid), history: [Table(\"t.csv\")])";
    assert!(plan(&folder.join("scene.ron"), text).is_err(), "no table is a shape and a history at once");
}

#[test]
fn arbitrary_bytes_as_a_table() {
    let folder = tempfile::tempdir().unwrap();
    run(prop::collection::vec(any::<u8>(), 0..300), |bytes| read_files(folder.path(), &bytes));
}

#[test]
fn pieces_of_tables_in_any_order() {
    const CELLS: &[&str] = &[
        "radius_m",
        "height_m",
        "time_s",
        "indentation_m",
        "force_n",
        ",",
        ",",
        "\n",
        "\n",
        "\r\n",
        "\"",
        "#",
        " ",
        ";",
        "0",
        "1",
        "2",
        "1e-6",
        "-1",
        "NaN",
        "inf",
        "1e999",
        "abc",
        "",
        "\u{feff}",
        "radius_m,height_m\n",
        "time_s,force_n\n0,0\n",
    ];
    let folder = tempfile::tempdir().unwrap();
    run(prop::collection::vec(0..CELLS.len(), 0..40), |cells| {
        read_files(folder.path(), cells.into_iter().map(|cell| CELLS[cell]).collect::<String>().as_bytes());
    });
}
