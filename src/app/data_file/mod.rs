//! Measured data as they come: any separator, decimal commas, lines above the table, any names and units.
//!
//! # Examples
//! ```
//! use springbed::app::data_file::{Data, Wanted};
//!
//! let text = "Instrument 7\nt;z;F\ns;nm;nN\n0;0,0;0,1\n0,1;10,0;0,3\n";
//! let data = Data::parse("probe.csv".as_ref(), text, &Wanted::default()).map_err(|fault| fault.message)?;
//! let curve = data.curve().map_err(|fault| fault.message)?;
//! assert_eq!(curve.readings.both().map(|column| column[1]), [1e-8, 0.3e-9]);
//! assert_eq!(curve.rows, [4, 5]);
//! # Ok::<(), String>(())
//! ```

mod columns;
mod grid;
mod quantity;
mod spelt;

pub use columns::Wanted;
pub use quantity::Quantity;
pub use spelt::Spelt;

use super::fault::Fault;
use super::read::read_bytes;
use crate::fit::prony::Moduli;
use crate::fit::{Curve, Readings, Sweeps};
use crate::scene::fit::Drive;
use columns::{Found, found};
use grid::Grid;
use std::path::{Path, PathBuf};

/// Largest data file: some million rows.
const LARGEST: u64 = 256 << 20;

/// Columns of a data file in SI units.
#[derive(Debug, Clone, PartialEq)]
pub struct Data {
    path: PathBuf,
    columns: Vec<(Quantity, Vec<f64>)>,
    /// Row of the file in which each line of values stands.
    pub rows: Vec<usize>,
    /// What was taken for granted.
    pub notes: Vec<String>,
    spring: Option<f64>,
    led: Drive,
}

impl Data {
    /// The data in the file at `path`.
    ///
    /// # Errors
    /// It cannot be read, has no table of numbers, or a wanted column is missing or not all numbers.
    pub fn load(path: &Path, wanted: &Wanted) -> Result<Self, Fault> {
        let bytes = read_bytes(path, LARGEST)?;
        Self::parse(path, &decoded(path, bytes)?, wanted)
    }

    /// The data in `text`, which came from the file at `path`.
    ///
    /// # Errors
    /// As of [`load`](Self::load).
    pub fn parse(path: &Path, text: &str, wanted: &Wanted) -> Result<Self, Fault> {
        let whole = |message: String| Fault::whole(path, message);
        let grid = Grid::of(text.trim_start_matches('\u{feff}')).map_err(whole)?;
        let (found, notes) = found(&grid, wanted).map_err(whole)?;
        let mut columns = Vec::new();
        for Found { quantity, at, size, zero, name } in found {
            let value = |line: usize| grid.number(line, at).map(|value| value * size.0 / size.1 + zero);
            let column = (0..grid.len())
                .map(|line| value(line).map_err(|what| whole(format!("row {}: {name}: {what}", grid.row(line)))));
            columns.push((quantity, column.collect::<Result<Vec<f64>, Fault>>()?));
        }
        let rows = (0..grid.len()).map(|line| grid.row(line)).collect();
        Ok(Self {
            path: path.to_owned(),
            columns,
            rows,
            notes,
            spring: wanted.spring,
            led: wanted.led.unwrap_or(Drive::Depth),
        })
    }

    /// The column of a quantity, if it is there.
    #[must_use]
    pub fn column(&self, quantity: Quantity) -> Option<&[f64]> {
        self.columns.iter().find(|(known, _)| *known == quantity).map(|(_, values)| &values[..])
    }

    /// What drives and what answers, and time if it is there; depth and force from the way of a piezo and the deflection of a
    /// spring if need be.
    ///
    /// # Errors
    /// A column is missing or cannot be what it is called, or the times do not rise.
    pub fn curve(&self) -> Result<Curve, Fault> {
        self.curve_of(self.spring)
    }

    /// The same with a cantilever of another stiffness [N/m].
    ///
    /// # Errors
    /// As of [`curve`](Self::curve).
    pub fn curve_of(&self, spring: Option<f64>) -> Result<Curve, Fault> {
        let columns = match self.led {
            Drive::Depth | Drive::Force => self.indentation(spring)?,
            Drive::Speed => self.impacts()?,
            Drive::Slide => {
                let right = "slide=x [um], tangential=Fx [mN]";
                let of = |quantity, what| {
                    self.column(quantity).map(<[f64]>::to_vec).ok_or_else(|| self.missing(what, right))
                };
                [of(Quantity::Slide, "slides")?, of(Quantity::Tangential, "tangential forces")?]
            }
        };
        let time = self.column(Quantity::Time).map(<[f64]>::to_vec);
        if let Some(time) = &time {
            self.rising(time)?;
        }
        Ok(Curve { time, readings: Readings::of(self.led, columns), rows: self.rows.clone() })
    }

    /// Depths and forces.
    fn indentation(&self, spring: Option<f64>) -> Result<[Vec<f64>; 2], Fault> {
        let missing = |what| self.missing(what, "depth=z [nm], force=F [nN]");
        let bent = self.column(Quantity::Deflection).zip(spring);
        let force = match (self.column(Quantity::Force), bent) {
            (Some(force), _) => force.to_vec(),
            (None, Some((deflection, stiffness))) => deflection.iter().map(|x| stiffness * x).collect(),
            (None, None) => return Err(missing("forces")),
        };
        let depth = match (self.column(Quantity::Depth), self.column(Quantity::Piezo)) {
            (Some(depth), _) => depth.to_vec(),
            (None, Some(piezo)) => {
                let stiffness = spring.ok_or_else(|| {
                    Fault::whole(
                        &self.path,
                        "the way of a piezo needs the stiffness of the cantilever: expected --spring \"0.05 N/m\"",
                    )
                })?;
                piezo.iter().zip(&force).map(|(z, force)| z - force / stiffness).collect()
            }
            (None, None) => return Err(missing("depths")),
        };
        Ok([depth, force])
    }

    /// Speeds above zero and restitutions that may be some.
    fn impacts(&self) -> Result<[Vec<f64>; 2], Fault> {
        let right = "speed=v [m/s], restitution=e";
        let of = |quantity, what| self.column(quantity).map(<[f64]>::to_vec).ok_or_else(|| self.missing(what, right));
        let (speed, restitution) = (of(Quantity::Speed, "speeds")?, of(Quantity::Restitution, "restitutions")?);
        let wrong = |at: usize, what: String| Fault::whole(&self.path, format!("row {}: {what}", self.rows[at]));
        if let Some(at) = speed.iter().position(|speed| *speed <= 0.0) {
            return Err(wrong(at, format!("the speed is {:?} m/s: expected one above zero", speed[at])));
        }
        if let Some(at) = restitution.iter().position(|one| !(-0.5..=1.5).contains(one)) {
            let right = "expected one from 0 to 1, or per cent by --columns \"restitution=e [%]\"";
            return Err(wrong(at, format!("the restitution is {:?}: {right}", restitution[at])));
        }
        Ok([speed, restitution])
    }

    /// That a column of `what` is missing, where `right` names one.
    fn missing(&self, what: &str, right: &str) -> Fault {
        let names: Vec<&str> = self.columns.iter().map(|(quantity, _)| quantity.name()).collect();
        let found = if names.is_empty() { "none".to_owned() } else { names.join(", ") };
        let right = format!("name it, as in --columns \"{right}\"");
        Fault::whole(&self.path, format!("has no column of {what} (found: {found}): {right}"))
    }

    /// Moduli over frequency.
    ///
    /// # Errors
    /// A column is missing.
    pub fn moduli(&self) -> Result<Moduli, Fault> {
        let of = |quantity: Quantity| {
            let column = self.column(quantity).map(<[f64]>::to_vec);
            column.ok_or_else(|| {
                let name = quantity.name();
                let right = "--columns \"frequency=f [Hz], storage=G1 [MPa], loss=G2 [MPa]\"";
                Fault::whole(&self.path, format!("has no column of {name}: name it, as in {right}"))
            })
        };
        Ok(Moduli { frequency: of(Quantity::Frequency)?, storage: of(Quantity::Storage)?, loss: of(Quantity::Loss)? })
    }

    /// Moduli over frequency at several temperatures; `None` if there is no column of them, or one temperature only.
    ///
    /// # Errors
    /// A column is missing.
    pub fn sweeps(&self) -> Result<Option<Sweeps>, Fault> {
        let moduli = self.moduli()?;
        let sweeps =
            self.column(Quantity::Temperature).map(|all| Sweeps { moduli, temperature: all.to_vec(), entropic: false });
        Ok(sweeps.filter(Sweeps::differ))
    }

    /// Whether the times rise from row to row.
    fn rising(&self, time: &[f64]) -> Result<(), Fault> {
        let Some(at) = time.windows(2).position(|pair| pair[1] <= pair[0]) else { return Ok(()) };
        let what = format!(
            "row {}: the time goes from {:?} s to {:?} s: expected times that rise",
            self.rows[at + 1],
            time[at],
            time[at + 1]
        );
        Err(Fault::whole(&self.path, what))
    }
}

/// Text of UTF-8, or else of Latin-1, in which instruments write µ and °.
fn decoded(path: &Path, bytes: Vec<u8>) -> Result<String, Fault> {
    if matches!(bytes[..], [0xff, 0xfe, ..] | [0xfe, 0xff, ..]) {
        return Err(Fault::whole(path, "the file looks like UTF-16: save it as UTF-8"));
    }
    if bytes.contains(&0) {
        return Err(Fault::whole(path, "the file is no text: expected a table such as CSV"));
    }
    Ok(String::from_utf8(bytes).unwrap_or_else(|error| error.as_bytes().iter().map(|&byte| char::from(byte)).collect()))
}
