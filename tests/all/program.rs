//! The program as a person or a script meets it.

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

/// The area of a sheared contact is drawn over the sliding speed where there are several, and over the way where there is one.
#[cfg(feature = "plot")]
#[test]
fn a_sheared_area_is_drawn_over_what_changes() {
    let folder = tempfile::tempdir().unwrap();
    let scenes = ["configs/stuck_lens.ron", "configs/sheared_lens.ron"];
    let output = springbed().arg("run").args(scenes).arg("--out").arg(folder.path()).output().unwrap();
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    for (name, over_speed) in [("stuck_lens.svg", false), ("sheared_lens.svg", true)] {
        let figure = std::fs::read_to_string(folder.path().join(name)).unwrap();
        let ways = figure.matches("tangential displacement").count();
        assert!(figure.contains("A/A₀") && figure.contains("sliding speed") == over_speed, "{name}");
        assert_eq!(ways, if over_speed { 1 } else { 2 }, "{name}");
    }
}

/// A flag is not swallowed by a command it says nothing to.
#[test]
fn a_flag_that_means_nothing_is_refused() {
    let said = |arguments: &[&str]| {
        let output = springbed().args(arguments).output().unwrap();
        (output.status.code(), String::from_utf8(output.stderr).unwrap())
    };
    for [flag, value] in [["--format", "png"], ["--out", "x"], ["--style", "paper"], ["--dpi", "300"]] {
        for at in [["check", flag, value, "configs/hertz.ron"], [flag, value, "check", "configs/hertz.ron"]] {
            let (code, said) = said(&at);
            assert_eq!(code, Some(2), "{said}");
            assert!(
                said.contains(&format!("{flag} means nothing to `springbed check`")) && said.contains("run"),
                "{said}"
            );
        }
    }
    assert_eq!(said(&["check", "--json", "configs/hertz.ron"]).0, Some(0));
    assert_eq!(said(&["new", "-q", "--color", "never"]).0, Some(0));
}

#[test]
fn the_same_scene_gives_the_same_bytes_on_any_number_of_threads() {
    let (first, _) = hertz_with(&["--threads", "1"]);
    for threads in ["1", "2", "5"] {
        assert!(hertz_with(&["--threads", threads]).0 == first, "{threads} threads");
    }
}

/// Elastic and adhesive scenes at once, on one thread and on several, twice.
#[test]
fn many_scenes_give_the_same_bytes_on_any_number_of_threads() {
    let run = |threads: &str| {
        let folder = tempfile::tempdir().unwrap();
        let names = ["hertz", "rail_wheel", "indentation_cone", "flat_punch", "pdms_lens", "wavy_lens", "measured_tip"];
        let mut command = springbed();
        command.args(["run", "--threads", threads, "--out"]).arg(folder.path());
        let output = command.args(names.map(|name| format!("configs/{name}.ron"))).output().unwrap();
        assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
        (files(folder.path()), output.stdout)
    };
    let first = run("1");
    assert!(first.0.len() >= 21, "{:?}", first.0.keys());
    for threads in ["1", "2", "7"] {
        assert!(run(threads) == first, "{threads} threads");
    }
}

/// Folders one may not write to, and names with spaces and accents.
#[test]
fn names_with_spaces_are_names() {
    let folder = tempfile::tempdir().unwrap();
    let scene = folder.path().join("my lens (é).ron");
    std::fs::copy(Path::new(env!("CARGO_MANIFEST_DIR")).join("configs/hertz.ron"), &scene).unwrap();
    let output =
        springbed().arg("run").arg(&scene).arg("--out").arg(folder.path().join("new folder")).output().unwrap();
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    assert!(folder.path().join("new folder/my lens (é).csv").exists());
}

/// Work of adhesion zero is no adhesion, and the order of the bodies does not matter: to the bit.
#[test]
fn what_should_not_matter_does_not() {
    let run = |text: &str| {
        let folder = tempfile::tempdir().unwrap();
        std::fs::write(folder.path().join("scene.ron"), text).unwrap();
        let mut command = springbed();
        command.args(["run", "--format", "csv", "--out"]).arg(folder.path()).arg(folder.path().join("scene.ron"));
        let output = command.output().unwrap();
        assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
        let mut made = files(folder.path());
        made.remove("scene.ron");
        made
    };
    let (steel, glass) = ("Elastic(young: \"210 GPa\", poisson: 0.3)", "Elastic(young: \"70 GPa\", poisson: 0.22)");
    let scene = |one: &str, other: &str, adhesion: &str| {
        format!(
            "(shape: Sphere(radius: \"3 mm\"), bodies: ({one}, {other}), {adhesion} \
             history: [Press(to: \"20 N\", over: 1), Indent(to: \"1 um\", over: 1), Indent(to: 0, over: 1)])"
        )
    };
    let plain = run(&scene(steel, glass, ""));
    assert!(plain == run(&scene(glass, steel, "")));
    assert!(plain == run(&scene(steel, glass, "adhesion: Jkr(work: 0),")));
    assert!(plain != run(&scene(steel, glass, "adhesion: Jkr(work: 1e-3),")));
}

#[test]
fn formats_quiet_and_json_do_what_they_say() {
    let (files, said) = hertz_with(&["--format", "csv", "--quiet"]);
    assert!(said.is_empty() && files.keys().all(|name| name.ends_with(".csv")), "{said}");
    let (_, said) = hertz_with(&["--format", "csv", "--json"]);
    let value: serde_json::Value = serde_json::from_str(&said).unwrap();
    assert!(value["scenes"][0]["results"]["largest_force_n"].as_f64().unwrap() > 30.7);
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

#[test]
fn a_file_is_no_folder_to_write_into() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("file");
    std::fs::write(&file, "").unwrap();
    let output = springbed().args(["run", "configs/hertz.ron", "--out"]).arg(&file).output().unwrap();
    assert_eq!(output.status.code(), Some(1));
    assert!(String::from_utf8_lossy(&output.stderr).contains("it is a file, expected a folder"));
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

/// The program on `scenes` in `folder`, with outputs into `out`: exit code and what it said.
fn run_in(folder: &Path, scenes: &[&str], out: &str) -> (Option<i32>, String) {
    let mut command = Command::new(env!("CARGO_BIN_EXE_springbed"));
    command.stdin(Stdio::null()).current_dir(folder);
    let output = command.arg("run").args(scenes).args(["--out", out]).output().unwrap();
    (output.status.code(), String::from_utf8_lossy(&output.stderr).into_owned())
}

const MEASURED: &str = "time_s,indentation_m\n0,0\n1,1e-6\n";

fn history_scene(folder: &Path, name: &str, shape: &str, table: &str) {
    let scene = format!(
        "(shape: {shape}, bodies: (Elastic(young: \"1 MPa\", poisson: 0.5), Rigid), history: [Table(\"{table}\")])"
    );
    std::fs::write(folder.join(name), scene).unwrap();
}

/// However the file is called: by `.`, through a folder that is not there yet, or by the folder itself.
#[test]
fn a_run_never_writes_over_what_it_reads() {
    let folder = tempfile::tempdir().unwrap();
    let at = folder.path();
    std::fs::create_dir(at.join("data")).unwrap();
    std::fs::write(at.join("history.csv"), MEASURED).unwrap();
    std::fs::write(at.join("data/profile.pressure.csv"), "radius_m,height_m\n0,0\n1,1\n2,4\n").unwrap();
    history_scene(at, "history.ron", "Cone(slope: 0.1)", "./history.csv");
    history_scene(at, "profile.ron", "Table(\"data/../data/profile.pressure.csv\")", "history.csv");
    let before = files(&at.join("data"));
    for out in [".", "./data/..", "new/.."] {
        let (code, said) = run_in(at, &["history.ron"], out);
        assert_eq!(code, Some(2), "{said}");
        assert!(said.contains("history.ron would write over") && said.contains("history.csv, which history.ron reads"));
    }
    let (code, said) = run_in(at, &["profile.ron", "history.ron"], "data");
    assert_eq!(code, Some(2), "{said}");
    assert!(said.contains("profile.ron would write over data/profile.pressure.csv, which profile.ron reads"), "{said}");
    assert_eq!(std::fs::read_to_string(at.join("history.csv")).unwrap(), MEASURED);
    assert!(files(&at.join("data")) == before && !at.join("new").exists(), "nothing is written");
    assert_eq!(run_in(at, &["history.ron", "profile.ron"], "out").0, Some(0));
}

/// The target of a link, and the link itself.
#[cfg(unix)]
#[test]
fn a_run_never_writes_over_what_a_link_leads_to() {
    let folder = tempfile::tempdir().unwrap();
    let at = folder.path();
    std::fs::create_dir(at.join("data")).unwrap();
    std::fs::write(at.join("data/scene.csv"), MEASURED).unwrap();
    std::os::unix::fs::symlink("data", at.join("link")).unwrap();
    std::os::unix::fs::symlink("data/scene.csv", at.join("linked.csv")).unwrap();
    history_scene(at, "scene.ron", "Cone(slope: 0.1)", "linked.csv");
    history_scene(at, "linked.ron", "Cone(slope: 0.1)", "linked.csv");
    for (scene, out) in [("scene.ron", "data"), ("scene.ron", "link"), ("linked.ron", ".")] {
        let (code, said) = run_in(at, &[scene], out);
        assert!(code == Some(2) && said.contains("which"), "{scene} into {out}: {said}");
    }
    assert_eq!(std::fs::read_to_string(at.join("linked.csv")).unwrap(), MEASURED);
}

#[test]
fn two_scenes_never_write_the_same_file() {
    let folder = tempfile::tempdir().unwrap();
    let at = folder.path();
    std::fs::write(at.join("history.csv"), MEASURED).unwrap();
    for name in ["y.ron", "y.pressure.ron"] {
        history_scene(at, name, "Cone(slope: 0.1)", "history.csv");
    }
    let (code, said) = run_in(at, &["y.ron", "y.pressure.ron"], "out");
    assert_eq!(code, Some(2), "{said}");
    let right = "y.ron and y.pressure.ron would both write y.pressure.csv: expected scenes of different names";
    assert!(said.contains(right) && !at.join("out").exists(), "{said}");
}
