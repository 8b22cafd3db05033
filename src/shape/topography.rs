//! Measured heights with all that is known of them, and what is done to them before they are pressed.

use super::rough::{filled, levelled, without_outliers};
use super::{Family, MapSource, Shape};
use crate::input::quantity::{Length, Positive};
use crate::input::table::{RawMap, TableError, Tables};
use ndarray::Array2;
use serde::{Deserialize, Serialize};
use std::path::PathBuf;

/// A measured surface in a file: a matrix, a text export of Gwyddion, a list of x, y and z, or `.npy`; peaks upwards.
///
/// The order is fixed: outliers are taken away, missing points filled, the tilt taken off, the other surface added.
#[derive(Debug, Clone, PartialEq, Deserialize, Serialize)]
#[serde(deny_unknown_fields)]
pub struct Topography {
    /// The file.
    pub file: PathBuf,
    /// Side of a pixel [m]; that of the file if absent.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub pixel: Option<Length>,
    /// What the number 1 in the file stands for, such as "1 nm"; the unit of the file if absent, or else a metre.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub unit: Option<Length>,
    /// Standard deviations beyond which a point sticks out of its neighbours and is taken for missing; none is if absent.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub outliers: Option<Positive>,
    /// What becomes of missing points; refused if absent.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub missing: Option<Missing>,
    /// What becomes of the tilt; it is kept if absent.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub tilt: Option<Tilt>,
    /// The surface of the other body, `HeightMap` or `Topography`, pixel on pixel as seen from one side, its peaks towards
    /// the first; it is smooth if absent.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub against: Option<Box<Shape>>,
}

/// What becomes of points without a height.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Deserialize, Serialize)]
pub enum Missing {
    /// The map is refused, with the place of the first.
    Refused,
    /// They are filled as a membrane does.
    Filled,
}

/// What becomes of the tilt of a map.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Deserialize, Serialize)]
pub enum Tilt {
    /// It stays.
    Kept,
    /// The plane of least squares is taken off.
    Removed,
}

/// Heights [m] with the sides of a pixel (Δx, Δy) [m].
#[derive(Debug, Clone, PartialEq)]
pub struct Treated {
    /// Heights [m], rows along y.
    pub heights: Array2<f64>,
    /// Sides of a pixel (Δx, Δy) [m].
    pub pixel: (f64, f64),
}

impl Topography {
    /// The heights as they are pressed.
    ///
    /// # Errors
    /// A file cannot be read; a point is missing; nothing says how large a pixel is; two maps that do not cover each
    /// other.
    pub fn treated(&self, tables: &dyn Tables) -> Result<Treated, TableError> {
        let raw = tables.topography(&self.file)?;
        let pixel = self.pixel_of(&raw)?;
        let mut heights = raw.heights;
        let unit = self.unit.map(Length::si).or(raw.unit).unwrap_or(1.0);
        heights.mapv_inplace(|height| height * unit);
        if let Some(limit) = self.outliers {
            without_outliers(&mut heights, limit.si());
        }
        self.complete(&mut heights)?;
        if self.tilt == Some(Tilt::Removed) {
            levelled(&mut heights);
        }
        let treated = Treated { heights, pixel };
        match &self.against {
            None => Ok(treated),
            Some(other) => self.joined(treated, &self.opposite(other, tables)?),
        }
    }

    /// The heights of the other body.
    fn opposite(&self, shape: &Shape, tables: &dyn Tables) -> Result<Treated, TableError> {
        match shape.family() {
            Family::Map(MapSource::Treated(topography)) => topography.treated(tables),
            Family::Map(MapSource::Plain(path, pixel)) => {
                Ok(Treated { heights: tables.heights(path)?, pixel: (pixel.si(), pixel.si()) })
            }
            Family::Round | Family::Line(_) | Family::Tips(_) | Family::Wavy(_) | Family::Pad(_) => {
                Err(TableError::whole(
                    &self.file,
                    format!("stands against a {}: expected HeightMap(…) or Topography(…)", shape.name()),
                ))
            }
        }
    }

    fn pixel_of(&self, raw: &RawMap) -> Result<(f64, f64), TableError> {
        let (rows, columns) = raw.heights.dim();
        match (self.pixel, raw.sides) {
            (Some(pixel), _) => Ok((pixel.si(), pixel.si())),
            (None, Some([x, y])) => Ok((x / columns as f64, y / rows as f64)),
            (None, None) => Err(TableError::whole(
                &self.file,
                "does not say how large a pixel is: expected pixel: …, the distance of two heights",
            )),
        }
    }

    /// Fills what is missing, or tells where it is.
    fn complete(&self, heights: &mut Array2<f64>) -> Result<(), TableError> {
        let missing = heights.iter().filter(|height| !height.is_finite()).count();
        let first = heights.indexed_iter().find(|(_, height)| !height.is_finite()).map(|(place, _)| place);
        let (Some((row, column)), of) = (first, heights.len()) else { return Ok(()) };
        let whole = |what: String| Err(TableError::whole(&self.file, what));
        match self.missing {
            Some(Missing::Filled) if missing < of => {
                filled(heights);
                Ok(())
            }
            Some(Missing::Filled) => whole("has no height at all: expected some that are numbers".to_owned()),
            Some(Missing::Refused) | None => whole(format!(
                "the height in row {}, column {} is missing, and {missing} of {of} are: expected missing: Filled, or a map without holes",
                row + 1,
                column + 1
            )),
        }
    }

    /// Both surfaces in one: peaks of both reach towards each other.
    fn joined(&self, one: Treated, other: &Treated) -> Result<Treated, TableError> {
        let far = |a: f64, b: f64| (a / b - 1.0).abs() > 1e-6;
        let ((rows, columns), (others, across)) = (one.heights.dim(), other.heights.dim());
        if (rows, columns) != (others, across) || far(one.pixel.0, other.pixel.0) || far(one.pixel.1, other.pixel.1) {
            return Err(TableError::whole(
                &self.file,
                format!(
                    "has {rows} × {columns} pixels of {:e} m, the surface against it {others} × {across} of {:e} m: expected maps that cover each other pixel by pixel",
                    one.pixel.0, other.pixel.0
                ),
            ));
        }
        Ok(Treated { heights: one.heights + &other.heights, ..one })
    }
}
