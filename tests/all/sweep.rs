//! Sweeps as a person, a script and a cluster meet them.

use std::collections::BTreeMap;
use std::io::Write;
use std::path::Path;
use std::process::{Command, Output, Stdio};

const SCENE: &str = r#"(title: "ball", shape: Paraboloid(radius: "10 mm"),
    bodies: (Elastic(young: "1 MPa", poisson: 0.5), Rigid), adhesion: Jkr(work: "50 mJ/m^2"),
    history: [Press(to: "1 mN", over: 1), Retract(speed: "1 um/s")])"#;

struct Bench(tempfile::TempDir);

impl Bench {
    fn new(scene: &str) -> Self {
        let folder = tempfile::tempdir().unwrap();
        std::fs::write(folder.path().join("s.ron"), scene).unwrap();
        Self(folder)
    }

    fn springbed(&self, arguments: &[&str]) -> Output {
        self.command(arguments).output().unwrap()
    }

    fn command(&self, arguments: &[&str]) -> Command {
        let mut command = Command::new(env!("CARGO_BIN_EXE_springbed"));
        command.stdin(Stdio::null()).current_dir(self.0.path()).args(arguments);
        command
    }

    fn done(&self, arguments: &[&str]) -> String {
        let output = self.springbed(arguments);
        assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
        String::from_utf8(output.stdout).unwrap()
    }

    fn refused(&self, arguments: &[&str], code: i32) -> String {
        let output = self.springbed(arguments);
        assert_eq!(output.status.code(), Some(code), "{}", String::from_utf8_lossy(&output.stdout));
        String::from_utf8(output.stderr).unwrap()
    }

    fn read(&self, name: &str) -> String {
        std::fs::read_to_string(self.0.path().join(name)).unwrap()
    }

    /// Names and bytes of the files in a folder.
    fn files(&self, folder: &str) -> BTreeMap<String, Vec<u8>> {
        let entries = std::fs::read_dir(self.0.path().join(folder)).unwrap().map(Result::unwrap);
        entries
            .map(|entry| (entry.file_name().to_string_lossy().into_owned(), std::fs::read(entry.path()).unwrap()))
            .collect()
    }
}

/// The numbers of a named column.
fn column(table: &str, name: &str) -> Vec<f64> {
    let mut lines = table.lines();
    let at = lines.next().unwrap().split(',').position(|column| column == name).unwrap();
    lines.map(|line| line.split(',').nth(at).unwrap().parse().unwrap()).collect()
}

const YOUNG: &str = "bodies.0.young=1kPa..1MPa:7log";
const WORK: &str = "adhesion.work=[10 mJ/m^2, 0.05, 0.1]";

/// JKR: the pull-off force −3/2·π·w·R is that of the work alone, row by row, and the grid is complete.
#[test]
fn a_grid_gives_a_tidy_table_a_summary_and_a_figure() {
    let bench = Bench::new(SCENE);
    let said = bench.done(&["run", "s.ron", "--set", YOUNG, "--set", WORK, "--out", "out"]);
    assert!(said.contains("21: 7 of bodies.0.young × 3 of adhesion.work"), "{said}");
    let table = bench.read("out/s.sweep.csv");
    assert_eq!(table.lines().count(), 22);
    let (young, work) = (column(&table, "bodies.0.young"), column(&table, "adhesion.work"));
    for (row, pull_off) in column(&table, "pull_off_force_n").into_iter().enumerate() {
        assert!((young[row] / 10f64.powf(3.0 + 0.5 * (row / 3) as f64) - 1.0).abs() < 1e-12);
        assert!((work[row] - [0.01, 0.05, 0.1][row % 3]).abs() <= 0.0);
        let jkr = -1.5 * std::f64::consts::PI * work[row] * 0.01;
        assert!((pull_off / jkr - 1.0).abs() < 1e-9, "{pull_off} {jkr}");
    }
    let json: serde_json::Value = serde_json::from_str(&bench.read("out/s.sweep.json")).unwrap();
    assert_eq!(json["rows"].as_array().unwrap().len(), 21);
    assert_eq!(json["parameters"][1]["unit"], "J/m^2");
    let mut names: Vec<String> = bench.files("out").into_keys().collect();
    names.retain(|name| !name.ends_with(".svg"));
    assert_eq!(names, ["s.sweep.csv", "s.sweep.json"], "no journal is left");
    if cfg!(feature = "plot") {
        assert!(bench.read("out/s.sweep.svg").contains("pull off force"));
    }
}

/// A row of a sweep has the results of the scene written by hand, digit by digit.
#[test]
fn a_row_is_what_the_scene_alone_gives() {
    let bench = Bench::new(SCENE);
    bench.done(&["run", "s.ron", "--set", "bodies.0.young=[2 MPa,3 MPa]", "--set", "history.0.to=2mN", "--out", "out"]);
    std::fs::write(bench.0.path().join("t.ron"), SCENE.replace("1 MPa", "3 MPa").replace("1 mN", "2 mN")).unwrap();
    let alone: serde_json::Value = serde_json::from_str(&bench.done(&["run", "t.ron", "--json"])).unwrap();
    let swept: serde_json::Value = serde_json::from_str(&bench.read("out/s.sweep.json")).unwrap();
    assert_eq!(swept["rows"][1]["results"], alone["scenes"][0]["results"]);
    assert_eq!(swept["rows"][1]["error_estimate"], alone["scenes"][0]["error_estimate"]["relative"]);
}

#[test]
fn the_same_sweep_gives_the_same_bytes_on_any_number_of_threads() {
    let bench = Bench::new(SCENE);
    for threads in ["1", "2", "5"] {
        bench.done(&["run", "s.ron", "--set", YOUNG, "--set", WORK, "--threads", threads, "--out", threads]);
    }
    assert!(bench.files("1") == bench.files("2") && bench.files("1") == bench.files("5"));
}

/// A scene may say its sweep itself; what the command line says goes before it.
#[test]
fn a_scene_may_write_its_sweep() {
    let sweep = "sweep: (set: [(path: \"shape.radius\", values: \"[1 mm,2 mm]\"), (path: \"adhesion.work\", values: \"[0.1,0.2]\")], zip: true))";
    let written = SCENE.trim_end_matches(')').to_owned() + ", " + sweep;
    let bench = Bench::new(&written);
    bench.done(&["run", "s.ron", "--out", "out"]);
    assert_eq!(column(&bench.read("out/s.sweep.csv"), "adhesion.work"), [0.1, 0.2]);
    bench.done(&["run", "s.ron", "--set", YOUNG, "--out", "other"]);
    assert_eq!(bench.read("other/s.sweep.csv").lines().count(), 8);
    std::fs::write(bench.0.path().join("s.ron"), written.replace("[0.1,0.2]", "[0.1]")).unwrap();
    let said = bench.refused(&["check", "s.ron"], 2);
    assert!(said.contains("s.ron:3:") && said.contains("adhesion.work: has 1 values and shape.radius has 2"), "{said}");
    std::fs::write(bench.0.path().join("s.ron"), written.replace("[0.1,0.2]", "0.1..0.2")).unwrap();
    assert!(bench.refused(&["check", "s.ron"], 2).contains("sweep.set[1].values: \"0.1..0.2\" does not say how many"));
}

#[test]
fn values_side_by_side_make_one_row_each() {
    let bench = Bench::new(SCENE);
    bench.done(&[
        "run",
        "s.ron",
        "--zip",
        "--set",
        "shape.radius=[1 mm,2 mm]",
        "--set",
        "adhesion.work=[0.1,0.2]",
        "--out",
        "out",
    ]);
    let table = bench.read("out/s.sweep.csv");
    assert_eq!(column(&table, "shape.radius"), [0.001, 0.002]);
    assert_eq!(column(&table, "adhesion.work"), [0.1, 0.2]);
}

/// Killed at any moment, without a chance to tidy up, it goes on; the end is the same to the byte.
#[cfg(unix)]
#[test]
fn a_sweep_that_is_killed_goes_on_with_what_is_missing() {
    let bench = Bench::new(SCENE);
    let sweep = ["run", "s.ron", "--set", "bodies.0.young=1kPa..1MPa:1000log", "--set", "adhesion.work=[0.05,0.1]"];
    let run = |out: &str| {
        bench
            .command(&[&sweep[..], &["--out", out]].concat())
            .stdout(Stdio::null())
            .stderr(Stdio::piped())
            .spawn()
            .unwrap()
    };
    assert!(run("whole").wait().unwrap().success());
    let journal = bench.0.path().join("killed/s.sweep.unfinished.jsonl");
    let length = || std::fs::metadata(&journal).map_or(0, |metadata| metadata.len());
    for _ in 0..3 {
        let (mut killed, before) = (run("killed"), length());
        // Some rows more than there were.
        while length() < before + 5000 && killed.try_wait().unwrap().is_none() {
            std::thread::sleep(std::time::Duration::from_millis(1));
        }
        killed.kill().unwrap();
        killed.wait().unwrap();
        assert!(length() > before, "it was killed on the way");
    }
    assert!(bench.files("killed").keys().all(|name| name.ends_with(".jsonl")));
    let output = run("killed").wait_with_output().unwrap();
    let said = String::from_utf8_lossy(&output.stderr);
    assert!(output.status.success() && said.contains("goes on: "), "{said}");
    assert!(bench.files("killed") == bench.files("whole"));
}

#[test]
fn parts_put_together_are_the_whole() {
    let bench = Bench::new(SCENE);
    let set = ["--set", YOUNG, "--set", WORK];
    bench.done(&[&["run", "s.ron", "--out", "whole"], &set[..]].concat());
    let part = |part: &str| bench.done(&[&["run", "s.ron", "--out", "parts", "--part", part], &set[..]].concat());
    for number in [4, 1, 2] {
        part(&format!("{number}/4"));
    }
    let said = bench.refused(&["gather", "parts", "--out", "gathered"], 1);
    assert!(said.contains("s.ron: 5 of 21 rows are missing, from 11 to 15"), "{said}");
    assert!(!bench.0.path().join("gathered").exists());
    part("3/4");
    bench.done(&["gather", "parts", "--out", "gathered"]);
    assert!(bench.files("gathered") == bench.files("whole"));
    // A part of another sweep under the same name.
    bench.done(&["run", "s.ron", "--out", "parts", "--part", "1/5", "--set", WORK]);
    assert!(bench.refused(&["gather", "parts"], 1).contains("are of different sweeps"));
    assert!(bench.refused(&["gather", "."], 2).contains("holds no parts of a sweep"));
}

#[test]
fn a_wrong_sweep_is_refused_with_its_place_and_nothing_is_written() {
    let bench = Bench::new(SCENE);
    for (set, right) in [
        ("bodies.0.yung=1..2:3", "s.ron: bodies.0.yung: there is no `yung`: did you mean `young`?"),
        ("friction.coefficient=0.3", "the scene has no `friction`: expected one of adhesion, bodies, history"),
        ("bodies.0.young=[1 MPa,2 mm]", "bodies.0.young: \"2 mm\" has the unit \"mm\": expected a pressure in one of"),
        ("history.7.to=1", "history has no entry `7`: expected one of 0 to 1"),
        ("bodies.0.young=1..2", "does not say how many values: expected LO..HI:N or LO..HI:Nlog"),
        ("bodies.0.young", "expected PATH=VALUES"),
        ("adhesion.work=[1,2", "no closing bracket"),
    ] {
        let said = bench.refused(&["run", "s.ron", "--out", "out", "--set", set], 2);
        assert!(said.contains(right), "{said}");
    }
    assert!(bench.refused(&["run", "s.ron", "--set", YOUNG, "--part", "5/4"], 2).contains("expected K/N"));
    assert!(bench.refused(&["run", "s.ron", "--part", "1/4"], 2).contains("--set"));
    assert!(!bench.0.path().join("out").exists());
}

/// What cannot be computed is a row that says why; the others are there, and the program says that it failed.
#[test]
fn a_row_that_fails_is_told_and_the_others_are_there() {
    let bench = Bench::new(
        "(shape: Table(\"tip.csv\"), bodies: (Elastic(young: 1e9, poisson: 0.3), Rigid), history: [Indent(to: 1e-9, over: 1)])",
    );
    std::fs::write(bench.0.path().join("tip.csv"), "radius_m,height_m\n0,0\n1e-8,1e-9\n2e-8,4e-9\n").unwrap();
    let said = bench.refused(&["run", "s.ron", "--set", "history.0.to=[1 nm,1 um]", "--out", "out"], 1);
    assert!(said.contains("1 of 2 rows could not be computed; row 1: "), "{said}");
    let table = bench.read("out/s.sweep.csv");
    assert!(table.lines().next().unwrap().ends_with(",failure") && table.lines().count() == 3);
}

fn said_of(bench: &Bench, arguments: &[&str], input: &str) -> Output {
    let mut child =
        bench.command(arguments).stdin(Stdio::piped()).stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().unwrap();
    child.stdin.take().unwrap().write_all(input.as_bytes()).unwrap();
    child.wait_with_output().unwrap()
}

/// From standard input in RON and in JSON, such as the `resolved` scene of a result: the same numbers.
#[test]
fn a_scene_may_come_from_standard_input() {
    let bench = Bench::new(SCENE);
    let of = |output: &Output| -> serde_json::Value {
        assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
        serde_json::from_slice(&output.stdout).unwrap()
    };
    let first = of(&said_of(&bench, &["run", "-", "--json", "--out", "out"], SCENE));
    assert!(bench.0.path().join("out/scene.csv").exists());
    let resolved = first["scenes"][0]["scene"]["resolved"].to_string();
    let again = of(&said_of(&bench, &["run", "-", "--json", "--out", "again"], &resolved));
    assert_eq!(first["scenes"][0]["results"], again["scenes"][0]["results"]);
    let named = bench.0.path().join("resolved.json");
    std::fs::write(&named, &resolved).unwrap();
    let both = of(&bench.springbed(&["run", "resolved.json", "s.ron", "--json", "--out", "both"]));
    assert_eq!(both["scenes"][0]["results"], both["scenes"][1]["results"]);
    let wrong = said_of(&bench, &["check", "-"], &SCENE.replace("10 mm", "10 kg"));
    assert_eq!(wrong.status.code(), Some(2));
    let said = String::from_utf8_lossy(&wrong.stderr).into_owned();
    assert!(said.starts_with("-:1:") && said.contains("shape.radius: \"10 kg\" has the unit"), "{said}");
}

/// A blunt cone: its slope is a warning, which one `--quiet` leaves and two do not.
#[test]
fn one_quiet_keeps_warnings() {
    let bench = Bench::new(
        "(shape: Cone(slope: 1), bodies: (Elastic(young: 1e9, poisson: 0.3), Rigid), history: [Indent(to: 1e-6, over: 1)])",
    );
    let said = |more: &[&str]| {
        let output = bench.springbed(&[&["run", "s.ron", "--out", "out"], more].concat());
        (output.stdout.is_empty(), String::from_utf8_lossy(&output.stderr).contains("warning: "))
    };
    assert_eq!(said(&[]), (false, true));
    assert_eq!(said(&["--quiet"]), (true, true));
    assert_eq!(said(&["-qq"]), (true, false));
}

/// What a sweep writes is no scene's input.
#[test]
fn a_sweep_never_writes_over_what_it_reads() {
    let bench = Bench::new(&SCENE.replace("Paraboloid(radius: \"10 mm\")", "Table(\"s.sweep.csv\")"));
    let profile = "radius_m,height_m\n0,0\n1e-3,1e-4\n2e-3,4e-4\n4e-3,2e-3\n";
    std::fs::write(bench.0.path().join("s.sweep.csv"), profile).unwrap();
    let said = bench.refused(&["run", "s.ron", "--set", "adhesion.work=[0.01,0.02]", "--out", "."], 2);
    assert!(said.contains("would write over") && bench.read("s.sweep.csv") == profile, "{said}");
    assert!(!Path::new("plots/s.sweep.csv").exists());
}
