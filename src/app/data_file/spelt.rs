//! Tables of scenes as instruments write them: the columns a scene asks for under other names and in other units.

use super::columns::{Headed, headed, plain};
use super::grid::Grid;
use crate::input::quantity::{Metre, MetrePerSecond, Newton, Pascal, Second, size_of};
use crate::input::table::{Columns, TableError};
use std::path::Path;

/// A column that scenes ask for.
struct Spelling {
    /// Its name in a scene's own tables, with its SI unit.
    name: &'static str,
    /// Names it goes by, small letters without blanks.
    others: &'static [&'static str],
    /// Numerator and denominator of the size of a unit it may have.
    size: fn(&str) -> Option<(f64, f64)>,
}

/// What tables of scenes may hold; a name stands for the first of those asked for.
const SPELLINGS: [Spelling; 9] = [
    Spelling {
        name: "time_s",
        others: &["time", "t", "seconds", "timestamp", "zeit", "tau", "τ"],
        size: size_of::<Second>,
    },
    Spelling {
        name: "indentation_m",
        others: &[
            "indentation",
            "depth",
            "d",
            "displacement",
            "penetration",
            "delta",
            "δ",
            "h",
            "z",
            "eindringtiefe",
            "weg",
        ],
        size: size_of::<Metre>,
    },
    Spelling {
        name: "force_n",
        others: &["force", "f", "load", "p", "normalforce", "normalload", "kraft", "last"],
        size: size_of::<Newton>,
    },
    Spelling { name: "slide_m", others: &["slide", "x", "tangentialdisplacement", "lateral"], size: size_of::<Metre> },
    Spelling { name: "radius_m", others: &["radius", "r", "x", "distance", "lateral"], size: size_of::<Metre> },
    Spelling { name: "height_m", others: &["height", "h", "z", "y", "profile", "höhe"], size: size_of::<Metre> },
    Spelling { name: "modulus_pa", others: &["modulus", "g", "e"], size: size_of::<Pascal> },
    Spelling { name: "speed_m_per_s", others: &["speed", "velocity", "v"], size: size_of::<MetrePerSecond> },
    Spelling { name: "shear_pa", others: &["shear", "shearstress", "strength", "tau", "τ"], size: size_of::<Pascal> },
];

/// A table under names of its own.
pub struct Spelt {
    grid: Grid,
    heads: Vec<Headed>,
}

impl Spelt {
    /// The table in `text`; `None` if it has no names, or some of a scene's own tables, which are read to the letter.
    #[must_use]
    pub fn of(text: &str) -> Option<Self> {
        let grid = Grid::of(text.trim_start_matches('\u{feff}')).ok()?;
        let heads: Vec<Headed> = (0..grid.width).map(|at| headed(&grid, at)).collect();
        Some(Self { grid, heads })
    }

    /// The columns of scenes that it has, each under the first name it may have.
    #[must_use]
    pub fn names(&self) -> Vec<String> {
        let name = |head: &Headed| SPELLINGS.iter().find(|spelling| spelling.fits(head));
        self.heads.iter().filter_map(name).map(|spelling| spelling.name.to_owned()).collect()
    }

    /// The columns `names` in SI units; `None` if one is not there, or there twice.
    ///
    /// # Errors
    /// A cell holds no number.
    pub fn columns(&self, path: &Path, names: &[&str]) -> Option<Result<Columns, TableError>> {
        let places: Vec<(usize, (f64, f64))> = names.iter().map(|name| self.place(name)).collect::<Option<_>>()?;
        let value = |line: usize, (at, size): (usize, (f64, f64)), name: &str| {
            let number = self.grid.number(line, at).map(|value| value * size.0 / size.1);
            number.map_err(|what| TableError::at(path, self.grid.row(line), format!("{name}: {what}")))
        };
        let column = |(&place, &name): (&(usize, (f64, f64)), &&str)| {
            (0..self.grid.len()).map(|line| value(line, place, name)).collect::<Result<Vec<f64>, TableError>>()
        };
        let values = places.iter().zip(names).map(column).collect::<Result<Vec<_>, _>>();
        let rows = (0..self.grid.len()).map(|line| self.grid.row(line)).collect();
        Some(values.map(|values| Columns { values, rows }))
    }

    /// The one column of a name, and the size of its unit.
    fn place(&self, name: &str) -> Option<(usize, (f64, f64))> {
        let spelling = SPELLINGS.iter().find(|spelling| spelling.name == name)?;
        let mut places = (0..self.heads.len()).filter(|&at| spelling.fits(&self.heads[at]));
        let (Some(at), None) = (places.next(), places.next()) else { return None };
        Some((at, (spelling.size)(self.heads[at].unit.as_deref()?)?))
    }
}

impl Spelling {
    /// Whether a column is called so and has a unit of its kind.
    fn fits(&self, head: &Headed) -> bool {
        let sized = head.unit.as_deref().is_some_and(|unit| (self.size)(unit).is_some());
        sized && self.others.contains(&plain(&head.name).as_str())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn read(text: &str, names: &[&str]) -> Option<Result<Columns, String>> {
        let read = Spelt::of(text)?.columns(Path::new("t.txt"), names)?;
        Some(read.map_err(|error| error.to_string()))
    }

    #[test]
    fn columns_are_found_by_name_and_unit() {
        let text = "Profile of tip 7\nr [µm]\tz (nm)\tpixel\n0,0\t0,0\t1\n1,5\t2,0\t2\n";
        let columns = read(text, &["radius_m", "height_m"]).unwrap().unwrap();
        assert_eq!(columns.values, [[0.0, 1.5e-6], [0.0, 2e-9]]);
        assert_eq!(columns.rows, [3, 4]);
        assert_eq!(Spelt::of("t;F\nms;mN\n0;1\n5;2\n").unwrap().names(), ["time_s", "force_n"]);
    }

    /// Without a unit nothing is taken for granted, and a cell without a number is told with its row.
    #[test]
    fn what_is_not_clear_is_not_guessed() {
        assert!(read("r,z\n0,0\n1,2\n", &["radius_m", "height_m"]).is_none());
        assert!(read("z [nm],h [nm]\n0,0\n1,2\n", &["height_m"]).is_none());
        let error = read("t [s],F [N]\n0,0\n1,abc\n2,3\n", &["time_s", "force_n"]).unwrap().unwrap_err();
        assert!(error.starts_with("t.txt, row 3: force_n: \"abc\" is not a number"), "{error}");
    }
}
