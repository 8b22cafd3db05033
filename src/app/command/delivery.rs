//! What a command has found, said and written.

use super::Common;
use crate::app::console::{Console, Failure};
use crate::app::run::Format;
use crate::app::write::write_all;

/// What a person reads, what a program reads, and the files with their names.
pub struct Findings {
    /// As lines.
    pub table: String,
    /// As JSON.
    pub json: String,
    /// Names and contents of the files.
    pub files: Vec<(String, String)>,
}

impl Findings {
    /// The JSON among the files, under its name.
    #[must_use]
    pub fn named(mut self, name: &str) -> Self {
        self.files.push((format!("{name}.json"), self.json.clone()));
        self
    }

    /// Says them on standard output, as a table or as JSON, and writes the files of the formats asked for.
    ///
    /// # Errors
    /// Standard output is closed; a file cannot be written.
    pub fn deliver(&self, common: &Common, console: &Console) -> Result<(), Failure> {
        if common.json {
            console.result(&self.json)?;
        } else {
            console.say(&self.table)?;
        }
        let wanted = |name: &str| {
            let of = |format: Format, ending: &str| common.format.contains(&format) && name.ends_with(ending);
            of(Format::Csv, ".csv") || of(Format::Json, ".json") || of(Format::Svg, ".svg")
        };
        let files = self.files.iter().filter(|file| wanted(&file.0));
        let files: Vec<(String, &[u8])> = files.map(|(name, text)| (name.clone(), text.as_bytes())).collect();
        let written = write_all(&common.out, &files).map_err(Failure::failed)?;
        let written: Vec<String> = written.iter().map(|path| path.display().to_string()).collect();
        if !written.is_empty() {
            console.message(&format!("  wrote {}", written.join(", ")));
        }
        Ok(())
    }
}
