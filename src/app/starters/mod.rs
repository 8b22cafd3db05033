//! `springbed new`: commented scenes to start from.

use super::console::{Console, Failure};
use crate::text::advice;

/// Name and text of a scene.
struct Starter {
    name: &'static str,
    text: &'static str,
}

macro_rules! starters {
    ($($name:literal),+ $(,)?) => {
        const STARTERS: &[Starter] = &[$(Starter { name: $name, text: include_str!(concat!($name, ".ron")) }),+];
    };
}

starters!(
    "hertz",
    "sphere",
    "cone",
    "punch",
    "jkr",
    "dmt",
    "maugis",
    "capillary",
    "pad",
    "wavy",
    "viscoelastic",
    "layer",
    "winkler",
    "graded",
    "creep",
    "cell",
    "oscillation",
    "friction",
    "fretting",
    "wear",
    "plastic",
    "impact",
    "restitution",
    "oblique",
    "glide",
    "traction",
    "machine",
    "history",
    "rough",
    "ensemble",
    "height-map",
    "half-space",
    "coupled",
    "fading",
    "westergaard",
    "seal",
);

impl Starter {
    /// The comment in its first line.
    fn about(&self) -> &'static str {
        self.text.lines().next().unwrap_or("").trim_start_matches("// ")
    }
}

/// Prints the scene of a kind, or the kinds.
///
/// # Errors
/// There is no such kind.
pub fn run(kind: Option<&str>, console: &Console) -> Result<(), Failure> {
    let Some(kind) = kind else { return console.result(&kinds()) };
    match STARTERS.iter().find(|starter| starter.name == kind) {
        Some(starter) => console.result(starter.text),
        None => Err(Failure::Usage(format!("unknown kind `{kind}`: {}", advice(kind, &names())))),
    }
}

fn names() -> Vec<&'static str> {
    STARTERS.iter().map(|starter| starter.name).collect()
}

fn kinds() -> String {
    STARTERS.iter().map(|starter| format!("{:<14}{}\n", starter.name, starter.about())).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::app::scene_file::SceneFile;

    /// Writes the tables that a scene carries in its comments: a line `// name.csv:`, then its rows.
    fn write_tables(text: &str, folder: &std::path::Path) {
        let mut lines = text.lines().filter_map(|line| line.strip_prefix("//")).peekable();
        while let Some(line) = lines.next() {
            let Some(name) = line.trim().strip_suffix(".csv:") else { continue };
            let mut table = String::new();
            while let Some(row) = lines.next_if(|line| line.starts_with("   ")) {
                table.push_str(row.trim());
                table.push('\n');
            }
            std::fs::write(folder.join(format!("{name}.csv")), table).unwrap();
        }
    }

    #[test]
    fn every_starter_passes_the_check() {
        for starter in STARTERS {
            let folder = tempfile::tempdir().unwrap();
            write_tables(starter.text, folder.path());
            let path = folder.path().join("scene.ron");
            std::fs::write(&path, starter.text).unwrap();
            let loaded = SceneFile::load(&path);
            assert!(loaded.is_ok(), "{}: {:?}", starter.name, loaded.err());
        }
    }

    #[test]
    fn every_starter_says_what_it_is() {
        for starter in STARTERS {
            assert!(starter.text.starts_with("// ") && starter.text.ends_with(")\n"), "{}", starter.name);
        }
        assert!(kinds().contains("jkr           Johnson, Kendall & Roberts"));
    }
}
