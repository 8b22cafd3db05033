//! Measured surfaces: what a file says of its heights beside the numbers.

use ndarray::Array2;
use std::path::Path;

use super::matrix_file::{NPY, opened, unchecked};
use crate::input::quantity::{Metre, size_of};
use crate::input::table::{RawMap, TableError};

/// Part of a step by which the places of a list may be off.
const OFF: f64 = 0.02;

/// The surface in the file at `file`; errors name it `path`, as the scene does.
///
/// A matrix of numbers or `.npy`; the text export of Gwyddion, whose head names sides and unit; three columns x, y, z
/// on a grid. What is no number, such as `nan` or an empty cell, is missing.
///
/// # Errors
/// The file cannot be read; a row of another length; words; places that make no grid.
pub fn read(file: &Path, path: &Path) -> Result<RawMap, TableError> {
    let bytes = opened(file, path)?;
    if bytes.starts_with(NPY) {
        return Ok(RawMap { heights: unchecked(&bytes, path)?, unit: None, sides: None });
    }
    // Instruments write µ in Latin-1 too.
    let text = String::from_utf8(bytes)
        .unwrap_or_else(|error| error.as_bytes().iter().map(|&byte| char::from(byte)).collect());
    of_text(text.trim_start_matches('\u{feff}'), path)
}

fn of_text(text: &str, path: &Path) -> Result<RawMap, TableError> {
    let head = Head::of(text, path)?;
    let rows = rows(text, path)?;
    let Some((_, first)) = rows.first() else {
        return Err(TableError::whole(path, "is empty: expected rows of heights"));
    };
    let columns = first.len();
    if let Some((line, row)) = rows.iter().find(|(_, row)| row.len() != columns) {
        let message = format!("has {} values: expected {columns}, as many as the rows above it", row.len());
        return Err(TableError::at(path, *line, message));
    }
    if columns == 3 && rows.len() > 3 {
        return of_places(&rows, &head, path);
    }
    let heights = Array2::from_shape_fn((rows.len(), columns), |(row, column)| rows[row].1[column]);
    let sides = head.width.zip(head.height).map(|(width, height)| [width, height]);
    Ok(RawMap { heights, unit: head.unit, sides })
}

/// What the lines of comment say: `# Width: 10 µm`, `# Height: 10 µm`, `# Value units: nm`.
#[derive(Debug, Default, PartialEq)]
struct Head {
    width: Option<f64>,
    height: Option<f64>,
    unit: Option<f64>,
}

impl Head {
    fn of(text: &str, path: &Path) -> Result<Self, TableError> {
        let mut head = Self::default();
        for (index, line) in text.lines().enumerate() {
            let Some((name, value)) = line.trim().strip_prefix('#').and_then(|line| line.split_once(':')) else {
                continue;
            };
            let wrong = |what: String| TableError::at(path, index + 1, what);
            match name.trim().to_lowercase().as_str() {
                "width" => head.width = Some(length(value.trim()).map_err(wrong)?),
                "height" => head.height = Some(length(value.trim()).map_err(wrong)?),
                "value units" => head.unit = Some(unit(value.trim()).map_err(wrong)?),
                _ => {}
            }
        }
        Ok(head)
    }
}

/// A length with its unit [m].
fn length(text: &str) -> Result<f64, String> {
    let right = || format!("\"{text}\" is not a length: expected one such as 10 µm");
    let (number, name) = text.split_once(|c: char| c.is_whitespace()).ok_or_else(right)?;
    let number: f64 =
        number.parse().ok().filter(|&number: &f64| number.is_finite() && number > 0.0).ok_or_else(right)?;
    let (up, down) = size_of::<Metre>(name.trim()).ok_or_else(right)?;
    Ok(number * up / down)
}

/// The size of a unit [m].
fn unit(text: &str) -> Result<f64, String> {
    let size = size_of::<Metre>(text).map(|(up, down)| up / down);
    size.ok_or_else(|| format!("the unit \"{text}\" is not one of lengths: expected m, mm, µm, nm, pm or Å"))
}

/// Rows of numbers with their lines; lines of comment begin with #.
fn rows(text: &str, path: &Path) -> Result<Vec<(usize, Vec<f64>)>, TableError> {
    let mut rows = Vec::new();
    for (index, line) in text.lines().enumerate() {
        let line = line.split('#').next().unwrap_or("").trim_end_matches(['\r', ' ']);
        if !line.trim().is_empty() {
            rows.push((index + 1, row(line).map_err(|message| TableError::at(path, index + 1, message))?));
        }
    }
    Ok(rows)
}

fn row(line: &str) -> Result<Vec<f64>, String> {
    let separator = [',', ';', '\t'].into_iter().find(|&separator| line.contains(separator));
    let cells: Vec<&str> = match separator {
        Some(separator) => line.strip_suffix(separator).unwrap_or(line).split(separator).map(str::trim).collect(),
        None => line.split_whitespace().collect(),
    };
    let number = |(column, cell): (usize, &&str)| height(cell).map_err(|what| format!("column {}: {what}", column + 1));
    cells.iter().enumerate().map(number).collect()
}

/// What instruments write where there is no height.
const ABSENT: [&str; 7] = ["", "nan", "na", "n/a", "null", "-", "bad"];

fn height(cell: &str) -> Result<f64, String> {
    if ABSENT.contains(&cell.to_lowercase().as_str()) {
        return Ok(f64::NAN);
    }
    let cell: String = cell.chars().take(40).collect();
    match cell.parse::<f64>() {
        Ok(value) if value.is_infinite() => Err(format!("\"{cell}\" is not finite: expected a height")),
        Ok(value) => Ok(value),
        Err(_) => {
            Err(format!("\"{cell}\" is not a number: expected a height such as 1.5e-6, or nan where there is none"))
        }
    }
}

/// Heights at places x, y of a grid, all in the unit of the file; places that are not in the list are missing.
fn of_places(rows: &[(usize, Vec<f64>)], head: &Head, path: &Path) -> Result<RawMap, TableError> {
    if let Some((line, _)) = rows.iter().find(|(_, row)| !row[0].is_finite() || !row[1].is_finite()) {
        return Err(TableError::at(path, *line, "has no place: expected x, y and z"));
    }
    let axis = |column: usize, name: &str| {
        Steps::of(rows.iter().map(|(_, row)| row[column]))
            .ok_or_else(|| TableError::whole(path, format!("its {name} are not on a grid: expected equal steps")))
    };
    let (x, y) = (axis(0, "x")?, axis(1, "y")?);
    if x.count.saturating_mul(y.count) > 64 * rows.len() {
        return Err(TableError::whole(path, "its places leave most of the grid empty: expected a whole map"));
    }
    let mut heights = Array2::from_elem((y.count, x.count), f64::NAN);
    for (line, row) in rows {
        let place = x.index(row[0]).zip(y.index(row[1])).map(|(column, row)| [row, column]);
        let place = place.ok_or_else(|| TableError::at(path, *line, "is not on the grid of the other places"))?;
        heights[place] = row[2];
    }
    let unit = head.unit.unwrap_or(1.0);
    Ok(RawMap { heights, unit: head.unit, sides: Some([x.side() * unit, y.side() * unit]) })
}

/// Equal steps along an axis.
struct Steps {
    first: f64,
    step: f64,
    count: usize,
}

impl Steps {
    #[expect(
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        reason = "a count of steps, positive and bounded"
    )]
    fn of(places: impl Iterator<Item = f64>) -> Option<Self> {
        let mut places: Vec<f64> = places.collect();
        places.sort_by(f64::total_cmp);
        let (first, last) = (*places.first()?, *places.last()?);
        let least = 1e-9 * (last - first);
        let mut gaps: Vec<f64> = places.windows(2).map(|pair| pair[1] - pair[0]).filter(|gap| *gap > least).collect();
        gaps.sort_by(f64::total_cmp);
        let typical = *gaps.get(gaps.len() / 2)?;
        let steps = ((last - first) / typical).round();
        let step = (last - first) / steps;
        let even = gaps.iter().all(|gap| (gap / step - (gap / step).round()).abs() < OFF && gap / step > 0.5);
        (even && steps < 1e5).then(|| Self { first, step, count: steps as usize + 1 })
    }

    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "between zero and the count")]
    fn index(&self, place: f64) -> Option<usize> {
        let steps = (place - self.first) / self.step;
        Some(steps.round().max(0.0) as usize).filter(|&index| index < self.count && (steps - steps.round()).abs() < OFF)
    }

    fn side(&self) -> f64 {
        self.step * self.count as f64
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn read(text: &str) -> Result<RawMap, String> {
        of_text(text, "map.txt".as_ref()).map_err(|error| error.to_string())
    }

    #[test]
    fn a_text_of_gwyddion_names_its_sides_and_its_unit() {
        let head = "# Channel: Topography\n# Width: 2.00 µm\n# Height: 1 µm\n# Value units: nm\n";
        let map = read(&format!("{head}1\t2\t3\t4\n5\tnan\t7\t8\n")).unwrap();
        assert_eq!((map.unit, map.heights.dim(), map.sides), (Some(1e-9), (2, 4), Some([2e-6, 1e-6])));
        assert!(map.heights[[1, 1]].is_nan() && (map.heights[[1, 2]] - 7.0).abs() < 1e-15);
        let strange = read("# Width: 2.00 V\n1 2 3 4\n").unwrap_err();
        assert_eq!(strange, "map.txt, row 1: \"2.00 V\" is not a length: expected one such as 10 µm");
        assert!(read("# Value units: V\n1 2 3 4\n").unwrap_err().contains("the unit \"V\" is not one of lengths"));
    }

    #[test]
    fn a_list_of_places_becomes_a_map_whatever_its_order() {
        let list = "0.5 0 1\n1.0 0 2\n0 0 0\n0 0.5 10\n1.0 0.5 12\n";
        let map = read(list).unwrap();
        assert_eq!((map.heights.dim(), map.sides), ((2, 3), Some([1.5, 1.0])));
        assert_eq!((map.heights[[0, 1]], map.heights[[1, 0]], map.heights[[1, 2]]), (1.0, 10.0, 12.0));
        assert!(map.heights[[1, 1]].is_nan());
        assert!(read("0 0 1\n1 0 1\n1.3 0 1\n3 0 1\n3.1 1 2\n").unwrap_err().contains("not on a grid"));
    }

    #[test]
    fn what_is_no_map_is_refused_with_its_row() {
        assert!(read("").unwrap_err().contains("is empty"));
        assert!(read("1 2 3 4\n1 2\n").unwrap_err().starts_with("map.txt, row 2: has 2 values: expected 4"));
        assert!(read("1 2 3 4\n1 2 high 4\n").unwrap_err().contains("row 2: column 3: \"high\" is not a number"));
        assert!(read("1 2 3 inf\n").unwrap_err().contains("\"inf\" is not finite"));
    }
}
