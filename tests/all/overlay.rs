//! Curves laid over each other, and what shells and editors ask of the program.

use std::path::Path;
use std::process::{Command, Output, Stdio};

fn springbed(folder: &Path, arguments: &[&str]) -> Output {
    let mut command = Command::new(env!("CARGO_BIN_EXE_springbed"));
    command.stdin(Stdio::null()).current_dir(folder).args(arguments).output().unwrap()
}

fn scene(title: &str, young: &str) -> String {
    format!(
        "(title: \"{title}\", shape: Paraboloid(radius: \"10 mm\"), bodies: (Elastic(young: \"{young}\", poisson: 0.5), Rigid), \
         history: [Indent(to: \"1 um\", over: 1)])"
    )
}

const MEASURED: &str = "# our gel\nindentation_m,force_n\n0,0\n5e-7,1e-6\n1e-6,3e-6\n";

#[test]
fn scenes_and_measured_points_stand_in_one_figure_and_one_table() {
    let folder = tempfile::tempdir().unwrap();
    let at = folder.path();
    std::fs::write(at.join("a.ron"), scene("soft", "1 MPa")).unwrap();
    std::fs::write(at.join("b.ron"), scene("", "2 MPa")).unwrap();
    std::fs::write(at.join("gel.csv"), MEASURED).unwrap();
    let output = springbed(at, &["overlay", "a.ron", "b.ron", "gel.csv", "--out", "out"]);
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    let table = std::fs::read_to_string(at.join("out/overlay.csv")).unwrap();
    assert!(table.starts_with("curve,time_s,indentation_m,force_n,contact_radius_m\n"), "{table}");
    let of = |label: &str| table.lines().filter(|line| line.starts_with(label)).count();
    assert!(of("soft,") > 10 && of("b,") == of("soft,") && of("gel,") == 3);
    assert!(table.contains("\ngel,,5e-7,1e-6,\n"));
    if cfg!(feature = "plot") {
        let figure = std::fs::read_to_string(at.join("out/overlay.svg")).unwrap();
        assert!(["soft", "gel", "force F"].iter().all(|word| figure.contains(word)));
    }
    let json: serde_json::Value =
        serde_json::from_str(&std::fs::read_to_string(at.join("out/overlay.json")).unwrap()).unwrap();
    assert_eq!(json["curves"][2]["ranges"]["force_n"], serde_json::json!([0.0, 3e-6]));
}

#[test]
fn a_wrong_overlay_is_refused() {
    let folder = tempfile::tempdir().unwrap();
    let at = folder.path();
    std::fs::write(at.join("a.ron"), scene("soft", "1 kg")).unwrap();
    std::fs::write(at.join("x.csv"), "x,y\n1,2\n").unwrap();
    std::fs::write(at.join("overlay.csv"), MEASURED).unwrap();
    let refused = |arguments: &[&str]| {
        let output = springbed(at, &[&["overlay"], arguments].concat());
        assert_eq!(output.status.code(), Some(2));
        String::from_utf8(output.stderr).unwrap()
    };
    let said = refused(&["a.ron", "x.csv"]);
    assert!(said.contains("a.ron:1:") && said.contains("x.csv: has no two columns of time_s, indentation_m"), "{said}");
    assert!(refused(&["overlay.csv", "--out", "."]).contains("would write over overlay.csv"));
    assert_eq!(std::fs::read_to_string(at.join("overlay.csv")).unwrap(), MEASURED);
}

#[test]
fn shells_and_editors_get_what_they_ask_for() {
    let said = |arguments: &[&str]| {
        let output = springbed(Path::new("."), arguments);
        assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
        String::from_utf8(output.stdout).unwrap()
    };
    for shell in ["bash", "zsh", "fish", "powershell", "elvish"] {
        assert!(said(&["completions", shell]).contains("overlay"), "{shell}");
    }
    assert!(said(&["man"]).contains(".TH springbed") && said(&["man", "run"]).contains("PATH=VALUES"));
    let output = springbed(Path::new("."), &["man", "rnu"]);
    assert!(String::from_utf8_lossy(&output.stderr).contains("did you mean `run`?"));
    let schema: serde_json::Value = serde_json::from_str(&said(&["schema"])).unwrap();
    assert!(schema["$defs"]["Scene"]["properties"]["sweep"].is_object());
}

/// One page with everything in it: nothing is loaded, and what a scene says is text, not markup.
#[cfg(feature = "plot")]
#[test]
fn a_gallery_is_one_page_that_needs_nothing_else() {
    let folder = tempfile::tempdir().unwrap();
    let at = folder.path();
    std::fs::write(
        at.join("a.ron"),
        "// Hertz 1882, doi:10.1515/crll.1882.92.156.\n".to_owned() + &scene("<b>soft</b>", "1 MPa"),
    )
    .unwrap();
    std::fs::write(at.join("b.ron"), scene("", "2 MPa")).unwrap();
    let output = springbed(at, &["gallery", "a.ron", "b.ron", "--out", "site"]);
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    let page = std::fs::read_to_string(at.join("site/index.html")).unwrap();
    assert!(page.matches("<svg").count() == 2 && page.contains("id=\"b\"") && page.contains("bodies.0.young"));
    assert!(page.contains("&lt;b&gt;soft&lt;/b&gt;") && !page.contains("<b>soft"));
    assert!(page.contains("href=\"https://doi.org/10.1515/crll.1882.92.156\""));
    for loaded in ["<script src", "<link", "<img", "@import", "url("] {
        assert!(!page.contains(loaded), "{loaded}");
    }
    std::fs::write(at.join("index.html.ron"), scene("x", "1 kg")).unwrap();
    assert_eq!(springbed(at, &["gallery", "index.html.ron", "--out", "site"]).status.code(), Some(2));
}
