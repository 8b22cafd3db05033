//! Height maps: a plain matrix of numbers, or a NumPy file.

use ndarray::Array2;
use std::path::Path;

use super::read::{number, read_bytes};
use crate::input::table::TableError;

/// Largest map: 16 million heights as text.
const LARGEST: u64 = 512 << 20;

/// The matrix in the file at `file`; errors name it `path`, as the scene does.
///
/// # Errors
/// The file cannot be read; the matrix is empty or ragged or holds something that is not a finite number.
pub fn read(file: &Path, path: &Path) -> Result<Array2<f64>, TableError> {
    let bytes = opened(file, path)?;
    if bytes.starts_with(NPY) { numpy(&bytes, path) } else { plain(&bytes, path) }
}

/// The bytes of the file at `file`; errors name it `path`.
///
/// # Errors
/// The file cannot be read.
pub(super) fn opened(file: &Path, path: &Path) -> Result<Vec<u8>, TableError> {
    read_bytes(file, LARGEST).map_err(|fault| {
        let message = if file.exists() { fault.message } else { format!("{} ({})", fault.message, file.display()) };
        TableError::whole(path, message)
    })
}

/// Rows of numbers, separated by commas, semicolons, tabs or blanks; lines of comment begin with #.
fn plain(bytes: &[u8], path: &Path) -> Result<Array2<f64>, TableError> {
    let text = std::str::from_utf8(bytes);
    let text = text.map_err(|error| {
        TableError::whole(
            path,
            format!("the byte at {} is not UTF-8: expected a matrix as text or `.npy`", error.valid_up_to()),
        )
    })?;
    let (mut heights, mut columns, mut rows) = (Vec::new(), 0, 0);
    for (index, line) in text.trim_start_matches('\u{feff}').lines().enumerate() {
        let line = line.split('#').next().unwrap_or("").trim();
        if line.is_empty() {
            continue;
        }
        let count = row(line, &mut heights).map_err(|message| TableError::at(path, index + 1, message))?;
        if rows > 0 && count != columns {
            let message = format!("has {count} values: expected {columns}, as many as the rows above it");
            return Err(TableError::at(path, index + 1, message));
        }
        (columns, rows) = (count, rows + 1);
    }
    shaped((rows, columns), heights, path)
}

/// Reads the numbers of a row; gives their count.
fn row(line: &str, heights: &mut Vec<f64>) -> Result<usize, String> {
    let separator = [',', ';', '\t'].into_iter().find(|&separator| line.contains(separator));
    let cells: Vec<&str> = match separator {
        Some(separator) => line.strip_suffix(separator).unwrap_or(line).split(separator).map(str::trim).collect(),
        None => line.split_whitespace().collect(),
    };
    for (column, cell) in cells.iter().enumerate() {
        heights.push(number(cell, "a height in metres").map_err(|what| format!("column {}: {what}", column + 1))?);
    }
    Ok(cells.len())
}

fn shaped(size: (usize, usize), heights: Vec<f64>, path: &Path) -> Result<Array2<f64>, TableError> {
    if heights.is_empty() {
        return Err(TableError::whole(path, "is empty: expected rows of heights in metres"));
    }
    Array2::from_shape_vec(size, heights).map_err(|error| TableError::whole(path, error.to_string()))
}

/// First bytes of a NumPy file.
pub(super) const NPY: &[u8] = b"\x93NUMPY";

/// A NumPy array all of whose numbers are heights.
fn numpy(bytes: &[u8], path: &Path) -> Result<Array2<f64>, TableError> {
    let heights = unchecked(bytes, path)?;
    if let Some(((i, j), value)) = heights.indexed_iter().find(|(_, height)| !height.is_finite()) {
        let message = format!("column {}: {value} is not finite: expected a height in metres", j + 1);
        return Err(TableError::at(path, i + 1, message));
    }
    Ok(heights)
}

/// A NumPy array of two dimensions: versions 1 to 3, numbers of 2, 4 or 8 bytes, in either order of bytes and of axes.
///
/// # Errors
/// It is none.
pub(super) fn unchecked(bytes: &[u8], path: &Path) -> Result<Array2<f64>, TableError> {
    let whole = |message: &str| TableError::whole(path, message);
    let broken = || whole("the header of the NumPy file is broken: expected what `numpy.save` writes");
    let wide = *bytes.get(6).ok_or_else(broken)? > 1;
    let start = if wide { 12 } else { 10 };
    let length = bytes.get(8..start).ok_or_else(broken)?;
    let length = length.iter().rev().fold(0_usize, |sum, byte| (sum << 8) + usize::from(*byte));
    let header = bytes.get(start..start.saturating_add(length)).ok_or_else(broken)?;
    let header = Header::of(&String::from_utf8_lossy(header)).map_err(|message| whole(&message))?;
    let heights = header.numbers(&bytes[start + length..]).map_err(|message| whole(&message))?;
    let heights = header.arranged(heights);
    if heights.is_empty() { Err(whole("is empty: expected rows of heights in metres")) } else { Ok(heights) }
}

/// What the header of a NumPy file says.
#[derive(Debug, PartialEq)]
struct Header {
    /// Kind of number, such as `f8`.
    kind: String,
    big_endian: bool,
    by_columns: bool,
    rows: usize,
    columns: usize,
}

impl Header {
    fn of(text: &str) -> Result<Self, String> {
        let value = |key: &str| {
            let at = text.find(&format!("'{key}':"))?;
            Some(text[at + key.len() + 3..].trim_start())
        };
        let broken = || "the header of the NumPy file is broken: expected what `numpy.save` writes".to_owned();
        let kind: String = value("descr").ok_or_else(broken)?.chars().skip(1).take_while(|&c| c != '\'').collect();
        let shape = value("shape").and_then(|rest| rest.strip_prefix('(')?.split(')').next()).ok_or_else(broken)?;
        let sides: Vec<usize> = shape.split(',').filter_map(|side| side.trim().parse().ok()).collect();
        let [rows, columns] = sides[..] else {
            return Err(format!("the array has the shape ({shape}): expected two dimensions"));
        };
        Ok(Self {
            big_endian: kind.starts_with('>'),
            kind: kind.trim_start_matches(['<', '>', '=', '|']).to_owned(),
            by_columns: value("fortran_order").is_some_and(|rest| rest.starts_with("True")),
            rows,
            columns,
        })
    }

    fn numbers(&self, bytes: &[u8]) -> Result<Vec<f64>, String> {
        let count = self.rows.saturating_mul(self.columns);
        let width = match self.kind.as_str() {
            "f8" | "i8" => 8,
            "f4" | "i4" => 4,
            "i2" | "u2" => 2,
            kind => return Err(format!("the array holds `{kind}`: expected f8, f4, i8, i4, i2 or u2")),
        };
        if bytes.len() / width < count {
            let there = bytes.len() / width;
            return Err(format!("the array has {} × {} numbers but only {there} are there", self.rows, self.columns));
        }
        Ok(bytes.chunks_exact(width).take(count).map(|chunk| self.number(chunk)).collect())
    }

    #[expect(clippy::cast_precision_loss, reason = "counts of a measuring device are far below 2^53")]
    fn number(&self, chunk: &[u8]) -> f64 {
        let mut word = [0; 8];
        for (to, from) in word.iter_mut().zip(chunk) {
            *to = *from;
        }
        if self.big_endian {
            word[..chunk.len()].reverse();
        }
        let [a, b, c, d, ..] = word;
        match self.kind.as_str() {
            "f8" => f64::from_le_bytes(word),
            "i8" => i64::from_le_bytes(word) as f64,
            "f4" => f64::from(f32::from_le_bytes([a, b, c, d])),
            "i4" => f64::from(i32::from_le_bytes([a, b, c, d])),
            "i2" => f64::from(i16::from_le_bytes([a, b])),
            _ => f64::from(u16::from_le_bytes([a, b])),
        }
    }

    fn arranged(&self, numbers: Vec<f64>) -> Array2<f64> {
        let at = |(i, j): (usize, usize)| if self.by_columns { j * self.rows + i } else { i * self.columns + j };
        Array2::from_shape_fn((self.rows, self.columns), |place| numbers[at(place)])
    }
}
