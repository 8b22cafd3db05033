//! The order of the folders in `src/lib.rs` is a law: each one uses only those above it, and below
//! `check` nothing knows of files, clocks or formats. Direction holds only where something holds it.

use std::path::{Path, PathBuf};

pub(super) fn sources(folder: &Path) -> Vec<PathBuf> {
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

pub(super) fn src() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("src")
}

/// The code of a file without its comments and without the tests at its end.
pub(super) fn code(path: &Path) -> String {
    let text = std::fs::read_to_string(path).unwrap();
    let tested = ["\n#[cfg(test)]\nmod ", "\n#[cfg(test)]\npub mod ", "\n#[cfg(test)]\npub(crate) mod "];
    let tested = tested.iter().filter_map(|mark| text.find(mark)).min();
    let body = &text[..tested.unwrap_or(text.len())];
    body.lines().map(|line| line.split("//").next().unwrap_or("")).collect::<Vec<_>>().join("\n")
}

/// Files that hold nothing but tests, such as `laws.rs` behind `#[cfg(test)] mod laws;`.
pub(super) fn only_tests(path: &Path) -> bool {
    let name = path.file_stem().unwrap().to_string_lossy();
    let inside = path.strip_prefix(src()).unwrap().components().any(|part| part.as_os_str() == "tests");
    let declared = |file: PathBuf| {
        std::fs::read_to_string(file).is_ok_and(|text| {
            ["mod", "pub mod", "pub(crate) mod"]
                .iter()
                .any(|word| text.contains(&format!("#[cfg(test)]\n{word} {name};")))
        })
    };
    let folder = path.parent().unwrap();
    let beside = folder.with_extension("rs");
    inside || name == "tests" || declared(folder.join("mod.rs")) || declared(beside)
}

/// The folders of `src` in the order of `src/lib.rs`.
fn order() -> Vec<String> {
    let text = std::fs::read_to_string(src().join("lib.rs")).unwrap();
    let modules: Vec<String> = text
        .lines()
        .filter_map(|line| line.strip_prefix("pub mod "))
        .map(|rest| rest.trim_end_matches(';').to_owned())
        .collect();
    assert!(modules.len() > 8);
    modules
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

/// The folders a file uses; `depth` of `super` leads to the root.
fn used(code: &str, depth: usize, folders: &[String]) -> Vec<String> {
    let mut found = Vec::new();
    for prefix in ["crate::".to_owned(), "super::".repeat(depth)] {
        let places = code.match_indices(&prefix).map(|(at, _)| (&code[..at], &code[at + prefix.len()..]));
        for (_, rest) in places.filter(|(before, rest)| !before.ends_with("super::") && !rest.starts_with("super::")) {
            found.extend(named(rest).split(|c: char| !word(c)).map(str::to_owned));
        }
    }
    found.retain(|word| folders.contains(word));
    found
}

#[test]
fn folders_use_only_those_above_them() {
    let folders = order();
    for path in sources(&src()).into_iter().filter(|path| !only_tests(path)) {
        let relative = path.strip_prefix(src()).unwrap();
        let own =
            relative.components().next().unwrap().as_os_str().to_string_lossy().trim_end_matches(".rs").to_owned();
        let Some(place) = folders.iter().position(|folder| *folder == own) else { continue };
        // src/a/mod.rs reaches the root by one `super`, src/a/b.rs by two.
        let parts = relative.components().count();
        let depth = if relative.ends_with("mod.rs") { parts - 1 } else { parts };
        for folder in used(&code(&path), depth, &folders) {
            let at = folders.iter().position(|other| *other == folder).unwrap();
            assert!(at <= place, "{} uses {folder}, which stands below {own} in src/lib.rs", path.display());
        }
    }
}

#[test]
fn below_the_check_no_file_is_opened_no_clock_read_and_nothing_printed() {
    let folders = order();
    let below = folders.iter().position(|folder| folder == "check").unwrap();
    let of = |folder: &String| match src().join(folder) {
        folder if folder.is_dir() => sources(&folder),
        file => vec![file.with_extension("rs")],
    };
    for path in folders[..below].iter().flat_map(of) {
        if only_tests(&path) {
            continue;
        }
        let code = code(&path);
        let notation = path.starts_with(src().join("text"));
        let formats = if notation { &[][..] } else { &["ron::", "serde_json"] };
        for &word in formats.iter().chain(&[
            "std::fs",
            "std::io",
            "std::time",
            "std::env",
            "println!",
            "eprintln!",
            "print!(",
            "dbg!",
            "csv::",
            "plotters",
            "clap",
            "indicatif",
        ]) {
            assert!(!code.contains(word), "{} holds {word}", path.display());
        }
    }
}

/// A test nobody names is never run.
#[test]
fn every_file_of_tests_is_run() {
    let tests = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests");
    let main = std::fs::read_to_string(tests.join("all/main.rs")).unwrap();
    for path in sources(&tests).into_iter().filter(|path| !path.ends_with("all/main.rs")) {
        let name = path.file_stem().unwrap().to_string_lossy().into_owned();
        let named = path == tests.join("all").join(format!("{name}.rs")) && main.contains(&format!("\nmod {name};"));
        assert!(named, "{} is not a module of tests/all/main.rs", path.display());
    }
}
