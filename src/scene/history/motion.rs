//! A history read from a table.

use crate::contact::adhesion::equilibrium::Control;
use crate::input::table::{Columns, TableError, Tables};
use crate::scene::stage::{self, Extent, Stage};
use std::path::Path;

/// Motion given by a table: time, what is controlled, and the tangential displacement if any.
///
/// Between two rows every column is linear in time; the first row is reached at once.
#[derive(Debug, Clone, PartialEq)]
pub struct MotionTable {
    /// Times [s], strictly increasing.
    pub time: Vec<f64>,
    /// What is controlled, one value per time.
    pub control: Driven,
    /// Tangential displacement [m], one value per time.
    pub slide: Option<Vec<f64>>,
    /// Row of the file in which each line of values stands.
    pub rows: Vec<usize>,
}

/// What a table drives.
#[derive(Debug, Clone, PartialEq)]
pub enum Driven {
    /// Indentation [m].
    Indentation(Vec<f64>),
    /// Normal force [N].
    Force(Vec<f64>),
}

const RIGHT: &str = "expected time_s, one of indentation_m and force_n, and slide_m if it slides";

impl MotionTable {
    /// The motion in the table at `path`: columns `time_s`, `indentation_m` or `force_n`, and
    /// perhaps `slide_m`; `control` says which where both are there.
    ///
    /// # Errors
    /// The table cannot be read, a column is missing or one too many, there are fewer than two
    /// rows, or the times do not increase.
    pub fn read((path, control): (&Path, Option<Control>), tables: &dyn Tables) -> Result<Self, TableError> {
        let names = tables.names(path)?;
        let wanted = wanted(&names, control).map_err(|message| TableError::whole(path, message))?;
        let Columns { mut values, rows } = tables.columns(path, &wanted)?;
        let slide = if wanted.len() > 2 { values.pop() } else { None };
        let (Some(control), Some(time)) = (values.pop(), values.pop()) else {
            return Err(TableError::whole(path, RIGHT));
        };
        increasing(path, &time, &rows)?;
        let control = if wanted[1] == "force_n" { Driven::Force(control) } else { Driven::Indentation(control) };
        Ok(Self { time, control, slide, rows })
    }

    /// One stage per row: the first row is reached at once, the others linearly.
    pub(super) fn stages(&self, entry: usize) -> Vec<Stage> {
        let (control, values) = match &self.control {
            Driven::Indentation(values) => (Control::Indentation, values),
            Driven::Force(values) => (Control::Force, values),
        };
        let stage = |row: usize| Stage {
            entry,
            control: Some(control),
            normal: stage::Path::To(values[row]),
            tangential: self.slide.as_ref().map_or(stage::Path::Stay, |slide| stage::Path::To(slide[row])),
            over: if row == 0 { self.time[0].max(0.0) } else { self.time[row] - self.time[row - 1] },
            records: 1,
            spacing: stage::Spaced::Evenly,
            extent: Extent::Row,
        };
        (0..values.len()).map(stage).collect()
    }
}

/// The columns to ask for, in the order time, control, slide.
fn wanted(names: &[String], control: Option<Control>) -> Result<Vec<&'static str>, String> {
    let has = |name: &str| names.iter().any(|known| known == name);
    let known = ["time_s", "indentation_m", "force_n", "slide_m"];
    if let Some(extra) = names.iter().find(|name| !known.contains(&name.as_str())) {
        return Err(format!("the column \"{extra}\" is not known: {RIGHT}"));
    }
    if !has("time_s") {
        return Err(format!("the column time_s is missing: {RIGHT}"));
    }
    let control = match (has("indentation_m"), has("force_n"), control) {
        (true, true, None) => {
            let right = "expected DepthTable(…) or ForceTable(…) to say which";
            return Err(format!("indentation_m and force_n cannot both be controlled: {right}, or {}", &RIGHT[9..]));
        }
        (true, _, Some(Control::Indentation)) | (true, false, None) => "indentation_m",
        (_, true, Some(Control::Force)) | (false, true, None) => "force_n",
        (_, _, Some(Control::Indentation)) => return Err(format!("the column indentation_m is missing: {RIGHT}")),
        (_, _, Some(Control::Force)) => return Err(format!("the column force_n is missing: {RIGHT}")),
        (false, false, None) => return Err(format!("neither indentation_m nor force_n is there: {RIGHT}")),
    };
    Ok([Some("time_s"), Some(control), has("slide_m").then_some("slide_m")].into_iter().flatten().collect())
}

fn increasing(path: &Path, time: &[f64], rows: &[usize]) -> Result<(), TableError> {
    if time.len() < 2 {
        return Err(TableError::whole(path, format!("has {} rows: expected at least two", time.len())));
    }
    let Some(at) = time.windows(2).position(|pair| pair[1] <= pair[0]) else { return Ok(()) };
    let message = format!("time_s goes from {} to {}: expected increasing times", time[at], time[at + 1]);
    Err(TableError::at(path, rows.get(at + 1).copied().unwrap_or(at + 1), message))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::input::table::InMemory;

    fn read(columns: &[(&str, &[f64])]) -> Result<MotionTable, String> {
        let tables = InMemory::default().with("h.csv", columns);
        MotionTable::read((Path::new("h.csv"), None), &tables).map_err(|error| error.to_string())
    }

    #[test]
    fn columns_may_stand_in_any_order() {
        let motion = read(&[("slide_m", &[0.0, 1.0]), ("force_n", &[2.0, 3.0]), ("time_s", &[0.0, 0.5])]).unwrap();
        assert_eq!(motion.time, [0.0, 0.5]);
        assert_eq!(motion.control, Driven::Force(vec![2.0, 3.0]));
        assert_eq!(motion.slide, Some(vec![0.0, 1.0]));
    }

    #[test]
    fn one_of_two_is_chosen() {
        let columns: [(&str, &[f64]); 3] =
            [("time_s", &[0.0, 1.0]), ("indentation_m", &[0.0, 2.0]), ("force_n", &[0.0, 3.0])];
        let tables = InMemory::default().with("h.csv", &columns);
        let driven = |control| MotionTable::read((Path::new("h.csv"), Some(control)), &tables).unwrap().control;
        assert_eq!(driven(Control::Indentation), Driven::Indentation(vec![0.0, 2.0]));
        assert_eq!(driven(Control::Force), Driven::Force(vec![0.0, 3.0]));
        let tables = InMemory::default().with("h.csv", &columns[..2]);
        let error = MotionTable::read((Path::new("h.csv"), Some(Control::Force)), &tables).unwrap_err().to_string();
        assert!(error.contains("force_n is missing"), "{error}");
    }

    #[test]
    fn a_wrong_table_is_refused_with_its_row() {
        let time: (&str, &[f64]) = ("time_s", &[0.0, 1.0, 1.0]);
        let depth: (&str, &[f64]) = ("indentation_m", &[0.0, 1.0, 2.0]);
        let error = |columns: &[(&str, &[f64])]| read(columns).unwrap_err();
        assert_eq!(error(&[time, depth]), "h.csv, row 4: time_s goes from 1 to 1: expected increasing times");
        assert!(error(&[depth]).contains("time_s is missing"));
        assert!(error(&[time]).contains("neither indentation_m nor force_n"));
        assert!(error(&[time, depth, ("force_n", &[0.0, 1.0, 2.0])]).contains("cannot both"));
        assert!(error(&[time, depth, ("depth", &[0.0, 1.0, 2.0])]).contains("\"depth\" is not known"));
        assert!(error(&[("time_s", &[0.0]), ("force_n", &[0.0])]).contains("has 1 rows"));
    }
}
