//! The program as a person or a script meets it.

#![cfg(feature = "cli")]
#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

use std::collections::BTreeMap;
use std::path::Path;
use std::process::{Command, Stdio};

fn springbed() -> Command {
    let mut command = Command::new(env!("CARGO_BIN_EXE_springbed"));
    command.stdin(Stdio::null()).current_dir(env!("CARGO_MANIFEST_DIR"));
    command
}

/// Names and bytes of the files in a folder.
fn files(folder: &Path) -> BTreeMap<String, Vec<u8>> {
    let entries = std::fs::read_dir(folder).unwrap().map(Result::unwrap);
    entries
        .map(|entry| (entry.file_name().to_string_lossy().into_owned(), std::fs::read(entry.path()).unwrap()))
        .collect()
}

fn hertz_with(arguments: &[&str]) -> (BTreeMap<String, Vec<u8>>, String) {
    let folder = tempfile::tempdir().unwrap();
    let mut command = springbed();
    command.args(["run", "configs/hertz.ron", "--out"]).arg(folder.path()).args(arguments);
    let output = command.output().unwrap();
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    (files(folder.path()), String::from_utf8(output.stdout).unwrap())
}

#[test]
fn the_first_command_of_the_readme_gives_table_summary_and_figure() {
    let (files, said) = hertz_with(&[]);
    assert!(said.contains("30.7692 N") && said.contains("1.46912 GPa"), "{said}");
    let names: Vec<&str> = files.keys().map(String::as_str).collect();
    assert!(["hertz.csv", "hertz.json", "hertz.pressure.csv"].iter().all(|name| names.contains(name)), "{names:?}");
    assert_eq!(cfg!(feature = "plot"), names.contains(&"hertz.svg"));
}

#[test]
fn the_same_scene_gives_the_same_bytes_on_any_number_of_threads() {
    let (first, _) = hertz_with(&["--threads", "1"]);
    for threads in ["1", "2", "5"] {
        assert!(hertz_with(&["--threads", threads]).0 == first, "{threads} threads");
    }
}

#[test]
fn formats_quiet_and_json_do_what_they_say() {
    let (files, said) = hertz_with(&["--format", "csv", "--quiet"]);
    assert!(said.is_empty() && files.keys().all(|name| name.ends_with(".csv")), "{said}");
    let (_, said) = hertz_with(&["--format", "csv", "--json"]);
    let value: serde_json::Value = serde_json::from_str(&said).unwrap();
    assert!(value["results"]["largest_force_n"].as_f64().unwrap() > 30.7);
}

#[test]
fn a_reader_that_goes_away_is_no_failure() {
    for command in ["new", "explain"] {
        let mut springbed = springbed();
        springbed.arg(command).arg(if command == "new" { "hertz" } else { "configs/hertz.ron" });
        let (reader, writer) = std::io::pipe().unwrap();
        drop(reader);
        let output = springbed.stdout(writer).output().unwrap();
        let said = String::from_utf8_lossy(&output.stderr);
        assert!(output.status.success() && said.is_empty(), "{command}: {said}");
    }
}

/// A full disk, as far as a test can make one.
#[cfg(target_os = "linux")]
#[test]
fn a_full_disk_is_a_failed_run() {
    let full = std::fs::File::options().write(true).open("/dev/full").unwrap();
    let output = springbed().args(["new", "hertz"]).stdout(full).output().unwrap();
    assert_eq!(output.status.code(), Some(1));
    assert!(String::from_utf8_lossy(&output.stderr).contains("standard output cannot be written"));
}

#[test]
fn a_folder_that_cannot_be_made_is_a_failed_run() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("file");
    std::fs::write(&file, "").unwrap();
    let output = springbed().args(["run", "configs/hertz.ron", "--out"]).arg(file.join("below")).output().unwrap();
    assert_eq!(output.status.code(), Some(1));
    assert!(String::from_utf8_lossy(&output.stderr).contains("cannot be written"));
}

/// Stopped at any moment, a run leaves whole files or none.
#[cfg(unix)]
#[test]
fn a_run_that_is_stopped_leaves_no_part_of_a_file() {
    let (whole, _) = hertz_with(&[]);
    for wait in [0, 1, 2, 3, 5, 8, 12, 20] {
        let folder = tempfile::tempdir().unwrap();
        let mut command = springbed();
        let mut run =
            command.args(["run", "configs/hertz.ron", "--quiet", "--out"]).arg(folder.path()).spawn().unwrap();
        std::thread::sleep(std::time::Duration::from_millis(wait));
        let stopped = Command::new("kill").args(["-INT", &run.id().to_string()]).stderr(Stdio::null()).status();
        run.wait().unwrap();
        if stopped.is_ok() {
            for (name, bytes) in files(folder.path()) {
                assert!(whole.get(&name) == Some(&bytes), "after {wait} ms: {name}");
            }
        }
    }
}
