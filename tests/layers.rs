//! Three boxes, one arrow: app → check → physics, and inside physics each module uses only those
//! listed above it. Direction holds only where something holds it.

#![allow(clippy::unwrap_used, clippy::panic, reason = "a test fails by panicking")]

use std::path::{Path, PathBuf};

fn sources(folder: &Path) -> Vec<PathBuf> {
    let mut files = Vec::new();
    for entry in std::fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        if path.is_dir() {
            files.extend(sources(&path));
        } else if path.extension().is_some_and(|extension| extension == "rs") {
            files.push(path);
        }
    }
    files
}

fn src() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("src")
}

/// The code of a file without its comments and without the tests at its end.
fn code(path: &Path) -> String {
    let text = std::fs::read_to_string(path).unwrap();
    let tested = ["\n#[cfg(test)]\nmod ", "\n#[cfg(test)]\npub mod "].iter().filter_map(|mark| text.find(mark)).min();
    let body = &text[..tested.unwrap_or(text.len())];
    body.lines().map(|line| line.split("//").next().unwrap_or("")).collect::<Vec<_>>().join("\n")
}

/// Files that hold nothing but tests, such as `laws.rs` behind `#[cfg(test)] mod laws;`.
fn only_tests(path: &Path) -> bool {
    let name = path.file_stem().unwrap().to_string_lossy();
    let inside = path.components().any(|part| part.as_os_str() == "tests");
    let declared = |file: PathBuf| {
        std::fs::read_to_string(file).is_ok_and(|text| text.contains(&format!("#[cfg(test)]\nmod {name};")))
    };
    let folder = path.parent().unwrap();
    let beside = folder.with_extension("rs");
    inside || name == "tests" || declared(folder.join("mod.rs")) || declared(beside)
}

#[test]
fn the_arrow_points_from_app_over_check_to_physics() {
    for (layer, forbidden) in [("physics", &["crate::check", "crate::app"][..]), ("check", &["crate::app"][..])] {
        for path in sources(&src().join(layer)).into_iter().filter(|path| !only_tests(path)) {
            let code = code(&path);
            for word in forbidden {
                assert!(!code.contains(word), "{} uses {word}", path.display());
            }
        }
    }
}

#[test]
fn physics_opens_no_file_reads_no_clock_and_prints_nothing() {
    for path in sources(&src().join("physics")).into_iter().filter(|path| !only_tests(path)) {
        let code = code(&path);
        for word in [
            "std::fs",
            "std::io",
            "std::time",
            "std::env",
            "println!",
            "eprintln!",
            "print!(",
            "dbg!",
            "ron::",
            "csv::",
            "serde_json",
            "plotters",
            "clap",
            "indicatif",
        ] {
            assert!(!code.contains(word), "{} holds {word}", path.display());
        }
    }
}

/// Modules of physics in the order of `src/physics/mod.rs`.
fn order() -> Vec<String> {
    let text = std::fs::read_to_string(src().join("physics/mod.rs")).unwrap();
    let modules: Vec<String> = text
        .lines()
        .filter_map(|line| line.strip_prefix("pub mod ").or_else(|| line.strip_prefix("mod ")))
        .map(|rest| rest.trim_end_matches(';').to_owned())
        .collect();
    assert!(modules.len() > 10);
    modules
}

/// The modules of physics that a file inside the module `own` uses; `depth` of `super` leads to physics.
fn used(code: &str, own: &str, depth: usize, modules: &[String]) -> Vec<String> {
    let mut found = Vec::new();
    for prefix in ["crate::physics::".to_owned(), "super::".repeat(depth)] {
        let places = code.match_indices(&prefix).map(|(at, _)| (&code[..at], &code[at + prefix.len()..]));
        for (_, rest) in places.filter(|(before, rest)| !before.ends_with("super::") && !rest.starts_with("super::")) {
            let words = named(rest).split(|c: char| !word(c));
            found.extend(words.filter(|word| *word != own).map(str::to_owned));
        }
    }
    found.retain(|word| modules.contains(word));
    found
}

fn word(c: char) -> bool {
    c.is_alphanumeric() || c == '_'
}

/// What follows a path: the next name, or a list of names in brackets.
fn named(rest: &str) -> &str {
    match rest.strip_prefix('{') {
        Some(list) => &list[..list.find(';').unwrap_or(list.len())],
        None => &rest[..rest.find(|c| !word(c)).unwrap_or(rest.len())],
    }
}

#[test]
fn inside_physics_modules_use_only_those_above_them() {
    let modules = order();
    let folder = src().join("physics");
    for path in sources(&folder).into_iter().filter(|path| !only_tests(path)) {
        let relative = path.strip_prefix(&folder).unwrap();
        let first = relative.components().next().unwrap().as_os_str().to_string_lossy();
        let own = first.trim_end_matches(".rs").to_owned();
        if own == "mod" {
            continue;
        }
        // physics/a.rs and physics/a/mod.rs reach physics by one `super`, physics/a/b.rs by two.
        let parts = relative.components().count();
        let depth = if relative.ends_with("mod.rs") { parts - 1 } else { parts };
        let place = modules.iter().position(|module| *module == own);
        let place = place.unwrap_or_else(|| panic!("{own} is not in src/physics/mod.rs"));
        for module in used(&code(&path), &own, depth, &modules) {
            let at = modules.iter().position(|other| *other == module).unwrap();
            assert!(at < place, "{} uses {module}, which stands below {own} in src/physics/mod.rs", path.display());
        }
    }
}
