//! What a command has found, said and written.

use super::Common;
use crate::app::console::{Console, Failure};
#[cfg(feature = "plot")]
use crate::app::figure::Figure;
#[cfg(feature = "plot")]
use crate::app::picture::unwritable;
use crate::app::run::Format;
use crate::app::write::write_all;

/// What a person reads, what a program reads, and the files with their names.
pub struct Findings {
    /// As lines.
    pub table: String,
    /// As JSON.
    pub json: String,
    /// Names and contents of the tables and summaries.
    pub files: Vec<(String, String)>,
    /// Figures with their names, without what follows the last dot.
    #[cfg(feature = "plot")]
    pub figures: Vec<(String, Figure)>,
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
    /// Standard output is closed; a figure cannot be drawn, a file not be written.
    pub fn deliver(&self, common: &Common, console: &Console) -> Result<(), Failure> {
        if common.json {
            console.result(&self.json)?;
        } else {
            console.say(&self.table)?;
        }
        let wanted = |name: &str| {
            let of = |format: Format, ending: &str| common.format.contains(&format) && name.ends_with(ending);
            of(Format::Csv, ".csv") || of(Format::Json, ".json")
        };
        let texts = self.files.iter().filter(|file| wanted(&file.0));
        let texts = texts.map(|(name, text)| (name.clone(), text.clone().into_bytes()));
        let files: Vec<(String, Vec<u8>)> = texts.chain(self.pictures(common, console)?).collect();
        let files: Vec<(String, &[u8])> = files.iter().map(|(name, bytes)| (name.clone(), &bytes[..])).collect();
        let written = write_all(&common.out, &files).map_err(Failure::failed)?;
        let written: Vec<String> = written.iter().map(|path| path.display().to_string()).collect();
        if !written.is_empty() {
            console.message(&format!("  wrote {}", written.join(", ")));
        }
        Ok(())
    }

    /// The figures in the formats asked for.
    #[cfg(feature = "plot")]
    fn pictures(&self, common: &Common, console: &Console) -> Result<Vec<(String, Vec<u8>)>, Failure> {
        let mut files = Vec::new();
        for (name, figure) in &self.figures {
            if let Some(warning) = unwritable(&figure.svg(), &common.format) {
                console.warning(&format!("{name}: {warning}"));
            }
            for &format in &common.format {
                let bytes = common.drawing().bytes(figure, format).map_err(Failure::failed)?;
                files.extend(bytes.map(|bytes| (format!("{name}.{}", format.ending()), bytes)));
            }
        }
        Ok(files)
    }

    #[cfg(not(feature = "plot"))]
    fn pictures(&self, _: &Common, _: &Console) -> Result<Vec<(String, Vec<u8>)>, Failure> {
        Ok(Vec::new())
    }
}
