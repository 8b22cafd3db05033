//! What a person reads who gives the program something wrong: each file in `tests/bad` holds the
//! messages it must bring, as `// expect: line:column: text`.

use std::path::{Path, PathBuf};
use std::process::{Command, Output, Stdio};
use tempfile::TempDir;

fn springbed(arguments: &[&Path]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_springbed"))
        .args(arguments)
        .stdin(Stdio::null())
        .current_dir(env!("CARGO_MANIFEST_DIR"))
        .output()
        .unwrap()
}

/// Runs a scene that must be refused; gives back what was said.
fn refused(scene: &Path) -> String {
    let folder = TempDir::new().unwrap();
    let out = folder.path().join("out");
    let output = springbed(&[Path::new("run"), scene, Path::new("--out"), &out]);
    let said = String::from_utf8_lossy(&output.stderr).into_owned();
    assert_eq!(output.status.code(), Some(2), "{}: {said}", scene.display());
    assert!(!out.exists(), "{}: wrote something", scene.display());
    assert!(output.stdout.is_empty(), "{}: printed a result", scene.display());
    assert!(!said.contains("panicked"), "{}: {said}", scene.display());
    said
}

fn bad_scenes() -> Vec<PathBuf> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/bad");
    let mut scenes: Vec<PathBuf> = std::fs::read_dir(folder)
        .unwrap()
        .map(|entry| Path::new("tests/bad").join(entry.unwrap().file_name()))
        .filter(|path| path.extension().is_some_and(|extension| extension == "ron"))
        .collect();
    scenes.sort();
    scenes
}

#[test]
fn every_bad_scene_brings_its_messages_and_no_others() {
    let scenes = bad_scenes();
    assert!(scenes.len() >= 100, "only {} scenes found", scenes.len());
    for scene in scenes {
        let bytes = std::fs::read(Path::new(env!("CARGO_MANIFEST_DIR")).join(&scene)).unwrap();
        let text = String::from_utf8_lossy(&bytes);
        let expected: Vec<&str> = text.lines().filter_map(|line| line.strip_prefix("// expect: ")).collect();
        assert!(!expected.is_empty(), "{}: expects nothing", scene.display());
        let said = refused(&scene);
        let prefix = format!("{}:", scene.display());
        let faults: Vec<&str> = said.lines().filter_map(|line| line.strip_prefix(&prefix)).collect();
        assert_eq!(faults.len(), expected.len(), "{said}");
        for (fault, right) in faults.iter().zip(expected) {
            assert!(fault.starts_with(right), "expected {prefix}{right}\nfound    {prefix}{fault}");
        }
    }
}

/// A scene of the given bytes in a folder of its own.
fn written(bytes: &[u8]) -> (TempDir, PathBuf) {
    let folder = TempDir::new().unwrap();
    let path = folder.path().join("scene.ron");
    std::fs::write(&path, bytes).unwrap();
    (folder, path)
}

fn refused_bytes(bytes: &[u8]) -> String {
    let (_folder, path) = written(bytes);
    refused(&path).replace(&path.display().to_string(), "scene.ron")
}

const RIGHT: &str = "(shape: Cone(slope: 1), bodies: (Rigid, Elastic(young: 1, poisson: 0)), history: [Hold(over: 1)])";

#[test]
fn bytes_that_are_not_text() {
    let said = refused_bytes(b"(\n    title: \"\xb5m\",\n)");
    assert!(said.starts_with("scene.ron:2:13: the byte 0xb5 is not UTF-8: save the file as UTF-8"), "{said}");
    let said = refused_bytes(b"\xff\xfe(\0\n\0)\0");
    assert!(said.starts_with("scene.ron:1:1: the byte 0xff is not UTF-8: the file looks like UTF-16"), "{said}");
    let said = refused_bytes(&[0; 1000]);
    assert!(said.starts_with("scene.ron:1:1: found"), "{said}");
}

#[test]
fn an_empty_file() {
    assert!(refused_bytes(b"").starts_with("scene.ron:1:1: there is no scene in the file"));
    assert!(refused_bytes(b"\xef\xbb\xbf").starts_with("scene.ron:1:1: there is no scene in the file"));
}

#[test]
fn a_byte_order_mark_is_no_fault_and_does_not_shift_columns() {
    let (_folder, path) = written(format!("\u{feff}{RIGHT}").as_bytes());
    assert_eq!(springbed(&[Path::new("check"), &path]).status.code(), Some(0));
    let said = refused_bytes(format!("\u{feff}{}", RIGHT.replace("Cone", "Con")).as_bytes());
    assert!(said.starts_with("scene.ron:1:9: unknown shape `Con`"), "{said}");
}

#[test]
fn brackets_nested_without_end() {
    for open in ["(", "[", "{", "Some(", "(shape: ", "/*", "(title: (", "[[", "(bodies: (("] {
        let said = refused_bytes(open.repeat(100_000).as_bytes());
        assert!(said.starts_with("scene.ron:1:"), "{open}: {said}");
    }
    let said = refused_bytes(RIGHT.replace("slope: 1", &format!("slope: {}", "[".repeat(100_000))).as_bytes());
    assert!(said.starts_with("scene.ron:1:21: shape.slope: `[` cannot stand here"), "{said}");
}

#[test]
fn files_that_are_not_there_or_no_files() {
    let folder = TempDir::new().unwrap();
    let missing = folder.path().join("missing.ron");
    assert!(refused(&missing).contains("missing.ron: there is no such file"));
    assert!(refused(folder.path()).contains(": is a directory: expected a file"));
}

#[test]
fn a_file_of_a_gigabyte_is_not_read() {
    let folder = TempDir::new().unwrap();
    let path = folder.path().join("huge.ron");
    std::fs::File::create(&path).unwrap().set_len(1 << 30).unwrap();
    assert!(refused(&path).contains("huge.ron: is too large: expected at most 64 MiB"));
    let table = folder.path().join("huge.csv");
    std::fs::rename(&path, &table).unwrap();
    let scene = folder.path().join("scene.ron");
    std::fs::write(&scene, RIGHT.replace("Hold(over: 1)", "Table(\"huge.csv\")")).unwrap();
    assert!(refused(&scene).contains("huge.csv: is too large: expected at most 256 MiB"));
}

#[cfg(unix)]
#[test]
fn a_file_without_end_is_not_read_to_its_end() {
    assert!(refused(Path::new("/dev/zero")).contains("/dev/zero: is too large"));
}

#[test]
fn a_long_line_is_shown_around_its_fault() {
    let said = refused_bytes(RIGHT.replace("slope: 1", &format!("slope: {}x", " ".repeat(1_000_000))).as_bytes());
    assert!(said.len() < 1000, "{} bytes", said.len());
}

#[test]
fn wrong_usage() {
    let code = |arguments: &[&str]| {
        let paths: Vec<&Path> = arguments.iter().map(Path::new).collect();
        let output = springbed(&paths);
        let said = String::from_utf8_lossy(&output.stderr).into_owned();
        assert_eq!(output.status.code(), Some(2), "{arguments:?}: {said}");
        said
    };
    assert!(code(&["new", "hetz"]).contains("unknown kind `hetz`: did you mean `hertz`? Known: hertz, "));
    assert!(code(&["rum", "x.ron"]).contains("unrecognized subcommand 'rum'"));
    assert!(code(&["run"]).contains("SCENE.ron"));
    assert!(code(&["run", "x.ron", "--format", "doc"]).contains("invalid value 'doc'"));
    assert!(code(&["run", "x.ron", "--threads", "0"]).contains("invalid value '0'"));
    assert!(code(&["run", "x.ron", "--threads", "100000"]).contains("expected at most 4096"));
    let twice = code(&["run", "configs/hertz.ron", "./configs/hertz.ron"]);
    assert!(twice.contains("would both write hertz.csv: expected scenes of different names"), "{twice}");
}

#[test]
fn all_files_are_checked_before_any_is_run() {
    let folder = TempDir::new().unwrap();
    let out = folder.path().join("out");
    let scenes = ["configs/hertz.ron", "tests/bad/not_a_number.ron", "tests/bad/two_rigid_bodies.ron"].map(Path::new);
    let output = springbed(&[Path::new("run"), scenes[0], scenes[1], scenes[2], Path::new("--out"), &out]);
    let said = String::from_utf8_lossy(&output.stderr).into_owned();
    assert_eq!(output.status.code(), Some(2));
    assert!(
        said.contains("not_a_number.ron:4:31:") && said.contains("two_rigid_bodies.ron:5:13:") && !out.exists(),
        "{said}"
    );
}

#[test]
fn check_lists_problems_as_json() {
    let output = springbed(&[Path::new("check"), Path::new("tests/bad/many_problems.ron"), Path::new("--json")]);
    assert_eq!(output.status.code(), Some(2));
    let value: serde_json::Value = serde_json::from_slice(&output.stdout).unwrap();
    let rows = value["problems"].as_array().unwrap();
    assert_eq!(rows.len(), 7);
    assert_eq!(rows[0]["line"], 11);
}

#[test]
fn colour_is_asked_for() {
    let said = |when: &str| {
        let arguments = ["check", "tests/bad/unknown_shape.ron", "--color", when];
        let paths: Vec<&Path> = arguments.iter().map(Path::new).collect();
        String::from_utf8_lossy(&springbed(&paths).stderr).into_owned()
    };
    assert!(said("always").contains("\x1b[1m") && !said("never").contains('\x1b') && !said("auto").contains('\x1b'));
}
