//! What a command has found, said and written.

use super::Common;
use crate::app::console::{Console, Failure};
#[cfg(feature = "plot")]
use crate::app::figure::Figure;
#[cfg(feature = "plot")]
use crate::app::picture::unwritable;
use crate::app::run::Format;
use crate::app::write::write_all;
use std::path::PathBuf;

/// What a person reads, what a program reads, and the files.
pub struct Findings {
    /// As lines.
    pub table: String,
    /// As JSON.
    pub json: String,
    /// The files.
    pub files: Files,
}

/// Files with their names.
pub struct Files {
    /// Names and contents of the tables and summaries.
    pub texts: Vec<(String, String)>,
    /// Figures with their names, without what follows the last dot.
    #[cfg(feature = "plot")]
    pub figures: Vec<(String, Figure)>,
}

impl Findings {
    /// The JSON among the files, under its name.
    #[must_use]
    pub fn named(mut self, name: &str) -> Self {
        self.files.texts.push((format!("{name}.json"), self.json.clone()));
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
        self.files.write(common)?.tell(console);
        Ok(())
    }
}

impl Files {
    /// Writes the files of the formats asked for, all or none.
    ///
    /// # Errors
    /// A figure cannot be drawn, a file not be written.
    pub fn write(&self, common: &Common) -> Result<Written, Failure> {
        let wanted = |name: &str| {
            let of = |format: Format, ending: &str| common.format.contains(&format) && name.ends_with(ending);
            of(Format::Csv, ".csv") || of(Format::Json, ".json")
        };
        let (pictures, warnings) = self.pictures(common)?;
        let texts =
            self.texts.iter().filter(|file| wanted(&file.0)).map(|(name, text)| (name.clone(), text.as_bytes()));
        let pictures = pictures.iter().map(|(name, bytes)| (name.clone(), &bytes[..]));
        let files: Vec<(String, &[u8])> = texts.chain(pictures).collect();
        let paths = write_all(&common.out, &files).map_err(Failure::failed)?;
        Ok(Written { paths, warnings })
    }

    /// The figures in the formats asked for, and what is to be said of them.
    #[cfg(feature = "plot")]
    fn pictures(&self, common: &Common) -> Result<(Vec<Picture>, Vec<String>), Failure> {
        let (mut files, mut warnings) = (Vec::new(), Vec::new());
        for (name, figure) in &self.figures {
            let warning = unwritable(&figure.svg(), &common.format);
            warnings.extend(warning.map(|warning| format!("{name}: {warning}")));
            for &format in &common.format {
                let bytes = common.drawing().bytes(figure, format).map_err(Failure::failed)?;
                files.extend(bytes.map(|bytes| (format!("{name}.{}", format.ending()), bytes)));
            }
        }
        Ok((files, warnings))
    }

    #[cfg(not(feature = "plot"))]
    fn pictures(&self, _: &Common) -> Result<(Vec<Picture>, Vec<String>), Failure> {
        Ok((Vec::new(), Vec::new()))
    }
}

/// Name and bytes of a picture.
type Picture = (String, Vec<u8>);

/// Files that have been written, and what is to be said of them.
#[derive(Debug)]
pub struct Written {
    paths: Vec<PathBuf>,
    warnings: Vec<String>,
}

impl Written {
    /// Says so.
    pub fn tell(&self, console: &Console) {
        for warning in &self.warnings {
            console.warning(warning);
        }
        let paths: Vec<String> = self.paths.iter().map(|path| path.display().to_string()).collect();
        if !paths.is_empty() {
            console.message(&format!("  wrote {}", paths.join(", ")));
        }
    }
}
