//! Tables next to the scene: CSV files with a header that names columns and SI units, read to the letter, or what
//! instruments write, with the columns found by names and units.
//!
//! # Examples
//! ```
//! use springbed::app::table_file::TableFiles;
//! use springbed::input::table::Tables;
//!
//! // Tables are looked for beside the scene.
//! let tables = TableFiles::beside("configs/measured_tip.ron".as_ref());
//! assert_eq!(tables.names("measured_tip.csv".as_ref())?, ["radius_m", "height_m"]);
//! # Ok::<(), springbed::input::table::TableError>(())
//! ```

use super::data_file::Spelt;
use super::read::{number, read_text};
use super::{matrix_file, topography_file};
use crate::input::table::{Columns, RawMap, TableError, Tables};
use csv::{ErrorKind, Reader, ReaderBuilder, StringRecord};
use ndarray::Array2;
use std::collections::BTreeSet;
use std::path::{Path, PathBuf};
use std::sync::{Mutex, PoisonError};

/// Largest table: a few million rows.
const LARGEST: u64 = 256 << 20;

/// The tables beside a scene file, and which of them have been asked for.
#[derive(Debug)]
pub struct TableFiles {
    folder: PathBuf,
    read: Mutex<BTreeSet<PathBuf>>,
}

impl TableFiles {
    /// Tables whose paths are relative to the folder of the file `scene`.
    #[must_use]
    pub fn beside(scene: &Path) -> Self {
        Self { folder: scene.parent().unwrap_or_else(|| Path::new("")).to_owned(), read: Mutex::default() }
    }

    /// The files that have been asked for so far.
    #[must_use]
    pub fn read(&self) -> Vec<PathBuf> {
        self.read.lock().unwrap_or_else(PoisonError::into_inner).iter().cloned().collect()
    }

    /// The file of the table a scene calls `path`.
    fn file(&self, path: &Path) -> PathBuf {
        let file = self.folder.join(path);
        self.read.lock().unwrap_or_else(PoisonError::into_inner).insert(file.clone());
        file
    }

    /// Opens a table; errors name it as the scene does.
    fn open(&self, path: &Path) -> Result<NamedColumns, TableError> {
        let file = self.file(path);
        let text = read_text(&file, LARGEST).map_err(|fault| TableError {
            path: path.to_owned(),
            row: fault.position.map(|position| position.line),
            message: if file.exists() { fault.message } else { format!("{} ({})", fault.message, file.display()) },
        })?;
        let header =
            header(&text).map_err(|error| TableError::whole(path, format!("cannot be read as CSV: {error}")))?;
        Ok(NamedColumns { path: path.to_owned(), text, header })
    }
}

impl Tables for TableFiles {
    fn names(&self, path: &Path) -> Result<Vec<String>, TableError> {
        let table = self.open(path)?;
        Ok(match table.spelt() {
            Some(spelt) => spelt.names(),
            None => table.header,
        })
    }

    fn columns(&self, path: &Path, names: &[&str]) -> Result<Columns, TableError> {
        let table = self.open(path)?;
        if let Some(columns) = table.spelt().and_then(|spelt| spelt.columns(path, names)) {
            return columns;
        }
        let order = table.order(names)?;
        table.values(names, &order)
    }

    fn heights(&self, path: &Path) -> Result<Array2<f64>, TableError> {
        matrix_file::read(&self.file(path), path)
    }

    fn topography(&self, path: &Path) -> Result<RawMap, TableError> {
        topography_file::read(&self.file(path), path)
    }
}

struct NamedColumns {
    path: PathBuf,
    text: String,
    header: Vec<String>,
}

fn reader(text: &str) -> Reader<&[u8]> {
    ReaderBuilder::new().comment(Some(b'#')).from_reader(text.as_bytes())
}

fn header(text: &str) -> Result<Vec<String>, csv::Error> {
    Ok(reader(text).headers()?.iter().map(|name| name.trim().to_owned()).collect())
}

/// Endings of the names in a scene's own tables.
const SI: [&str; 10] = ["_s", "_m", "_n", "_pa", "_m_per_s", "_m4", "_rad_per_m", "_hz", "_k", "_degc"];

impl NamedColumns {
    /// The table under names of its own; `None` if a name is one of a scene's own tables, or there is none to be found.
    fn spelt(&self) -> Option<Spelt> {
        let own = |name: &String| SI.iter().any(|unit| name.ends_with(unit)) && *name == name.to_lowercase();
        if self.header.iter().any(own) {
            return None;
        }
        Spelt::of(&self.text).filter(|spelt| !spelt.names().is_empty())
    }

    /// For each name the number of its column.
    fn order(&self, names: &[&str]) -> Result<Vec<usize>, TableError> {
        let right = names.join(",");
        let fault = |message: String| Err(TableError::whole(&self.path, message));
        if self.header.is_empty() {
            return fault(format!("is empty: expected the columns {right}"));
        }
        if self.header.iter().all(|name| name.parse::<f64>().is_ok()) {
            return fault(format!("has no header: expected the columns {right} named in its first row"));
        }
        if let [only] = &self.header[..]
            && only.contains([';', '\t', ' '])
            && names.len() > 1
        {
            return fault(format!("has the one column \"{only}\": expected {right}, separated by commas"));
        }
        if let Some(extra) = self.header.iter().find(|name| !names.contains(&name.as_str())) {
            return fault(format!("the column \"{extra}\" is not known: expected {right}"));
        }
        names.iter().map(|name| self.position(name, &right)).collect()
    }

    fn position(&self, name: &str, right: &str) -> Result<usize, TableError> {
        let mut places = self.header.iter().enumerate().filter(|(_, known)| *known == name).map(|(at, _)| at);
        let fault = |what: &str| TableError::whole(&self.path, format!("the column {name} {what}: expected {right}"));
        match (places.next(), places.next()) {
            (Some(at), None) => Ok(at),
            (Some(_), Some(_)) => Err(fault("is there twice")),
            (None, _) => Err(fault("is missing")),
        }
    }

    fn values(&self, names: &[&str], order: &[usize]) -> Result<Columns, TableError> {
        let mut columns = Columns { values: vec![Vec::new(); names.len()], rows: Vec::new() };
        let mut reader = reader(&self.text);
        let mut record = StringRecord::new();
        while reader.read_record(&mut record).map_err(|error| self.refused(&reader, &error))? {
            let row = self.row(&reader);
            for ((column, &at), name) in columns.values.iter_mut().zip(order).zip(names) {
                let number = number(record.get(at).unwrap_or("").trim(), "a number")
                    .map_err(|message| format!("{name}: {message}"));
                column.push(number.map_err(|message| TableError::at(&self.path, row, message))?);
            }
            columns.rows.push(row);
        }
        Ok(columns)
    }
}

impl NamedColumns {
    /// Row of the record just read; the position of a record itself is before the comments above it.
    fn row(&self, reader: &Reader<&[u8]>) -> usize {
        let after = reader.position();
        let byte = usize::try_from(after.byte()).unwrap_or(usize::MAX).min(self.text.len());
        let ended = self.text.as_bytes()[..byte].last() == Some(&b'\n');
        usize::try_from(after.line()).unwrap_or(usize::MAX) - usize::from(ended)
    }

    fn refused(&self, reader: &Reader<&[u8]>, error: &csv::Error) -> TableError {
        let message = match error.kind() {
            ErrorKind::UnequalLengths { expected_len, len, .. } => {
                format!("has {len} values: expected {expected_len}, one per column")
            }
            _ => format!("cannot be read as CSV: {error}"),
        };
        TableError::at(&self.path, self.row(reader), message)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn read(bytes: &[u8]) -> Result<Columns, String> {
        let folder = tempfile::tempdir().unwrap();
        std::fs::write(folder.path().join("t.csv"), bytes).unwrap();
        let tables = TableFiles::beside(&folder.path().join("scene.ron"));
        let columns = tables.columns(Path::new("t.csv"), &["radius_m", "height_m"]);
        columns.map_err(|error| error.to_string())
    }

    #[test]
    fn comments_blanks_order_and_byte_order_mark() {
        let columns =
            read(b"\xef\xbb\xbf# tip 7\r\nheight_m , radius_m\r\n\r\n 0, 1e-3\r\n# end\r\n+2,.5\r\n").unwrap();
        assert_eq!(columns.values, [[1e-3, 0.5], [0.0, 2.0]]);
        assert_eq!(columns.rows, [4, 6]);
    }

    #[test]
    fn a_wrong_table_is_refused_with_row_and_column() {
        let message = |text: &str| read(text.as_bytes()).unwrap_err();
        let header = "radius_m,height_m\n";
        assert_eq!(message(""), "t.csv: is empty: expected the columns radius_m,height_m");
        assert!(message("0,1\n1,2\n").contains("has no header: expected the columns radius_m,height_m"));
        assert!(message("radius_m;height_m\n0;1\n").contains("separated by commas"));
        assert!(message("radius_m\n0\n").contains("the column height_m is missing"));
        assert!(message("radius_m,height_m,x\n").contains("the column \"x\" is not known"));
        assert!(message("radius_m,radius_m,height_m\n").contains("radius_m is there twice"));
        assert_eq!(message(&format!("{header}0,0\n1\n")), "t.csv, row 3: has 1 values: expected 2, one per column");
        assert!(message(&format!("{header}0,0\n1,abc\n")).contains("row 3: height_m: \"abc\" is not a number"));
        assert!(message(&format!("{header}0,\n")).contains("row 2: height_m: is empty"));
        assert!(message(&format!("{header}nan,0\n")).contains("row 2: radius_m: \"nan\" is not finite"));
        assert!(message(&format!("{header}0,1e400\n")).contains("\"1e400\" is not finite"));
        assert!(read(b"radius_m,height_m\n0,0\n\xff,1\n").unwrap_err().contains("row 3: the byte 0xff is not UTF-8"));
    }

    /// What an instrument writes is the same as a scene's own table of it.
    #[test]
    fn tables_of_instruments_are_read_too() {
        let own = read(b"radius_m,height_m\n0,0\n1e-6,2e-9\n").unwrap();
        for text in ["r [um];z [nm]\n0;0\n1;2\n", "Tip 7\nr [µm]\tz [nm]\tn\n0,0\t0,0\t1\n1,0\t2,0\t2\n"] {
            assert_eq!(read(text.as_bytes()).map(|columns| columns.values), Ok(own.values.clone()), "{text}");
        }
        let tables = |text: &str| {
            let folder = tempfile::tempdir().unwrap();
            std::fs::write(folder.path().join("h.txt"), text).unwrap();
            TableFiles::beside(&folder.path().join("scene.ron")).names(Path::new("h.txt")).unwrap()
        };
        assert_eq!(tables("t [ms],F [mN],T [degC]\n0,0,20\n1,1,20\n"), ["time_s", "force_n"]);
    }

    #[test]
    fn a_missing_table_is_named_as_it_was_looked_for() {
        let tables = TableFiles::beside(Path::new("some/folder/scene.ron"));
        let error = tables.names(Path::new("tip.csv")).unwrap_err();
        assert_eq!(error.to_string(), "tip.csv: there is no such file (some/folder/tip.csv)");
    }
}
