//! Indenter shapes: the profile f(r) and its one-dimensional equivalent g(x).
//!
//! g(x) = |x| ∫₀^|x| f′(r) dr/√(x²−r²) = |x| ∫₀^{π/2} f′(|x| sin θ) dθ and
//! f(r) = (2/π) ∫₀^r g(x) dx/√(r²−x²) (Popov & Heß 2015, eqs. 3.27 and 3.28).
//!
//! # Examples
//! ```
//! use springbed::input::quantity::Length;
//! use springbed::shape::{Paraboloid, Profile};
//!
//! // f = r²/2R becomes g = x²/R: the edge stands where g(a) = d, a = √(Rd).
//! let ball = Paraboloid { radius: Length::new(0.01)? };
//! assert!((ball.reduced(1e-4) / 1e-6 - 1.0).abs() < 1e-15);
//! assert!((ball.edge(1e-6).unwrap() / 1e-4 - 1.0).abs() < 1e-15);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod boundary;
mod ellipsoid;
mod flank;
mod kernel;
mod lying;
mod measured;
mod pad;
mod paraboloid;
mod plane;
mod power;
mod profile;
mod punch;
pub mod rough;
mod rough_line;
mod rounded;
mod sphere;
mod spheres;
mod tips;
mod topography;
mod truncated;
mod wavy;

pub use boundary::Boundary;
pub use ellipsoid::Ellipsoid;
pub use lying::Lying;
pub use measured::Measured;
pub use pad::{Pad, Summits};
pub use paraboloid::Paraboloid;
pub use plane::{Cylinder, PlaneRipple, PlaneWave, PlaneWavy};
pub use power::{Cone, Power};
pub use profile::{Moved, Profile, Rim, edge_by_search, height_by_integral, reduced_by_integral};
pub use punch::FlatPunch;
pub use rough_line::{RoughShape, Seeds};
pub use rounded::{RoundedCone, RoundedPunch};
pub use sphere::Sphere;
pub use spheres::Spheres;
pub use tips::{PlacedTip, Tip};
pub use topography::{Missing, Tilt, Topography, Treated};
pub use truncated::{TruncatedCone, TruncatedParaboloid};
pub use wavy::WavyParaboloid;

use crate::input::quantity::{Length, QuantityError};
use crate::input::table::{TableError, Tables};
use serde::{Deserialize, Serialize};
use std::path::{Path, PathBuf};
use std::sync::Arc;

/// The shape of the indenter, as a scene names it.
#[derive(Debug, Clone, PartialEq, Deserialize, Serialize)]
pub enum Shape {
    /// Paraboloid of revolution.
    Paraboloid(Paraboloid),
    /// Exact sphere.
    Sphere(Sphere),
    /// Two spheres, one of which may be hollow, by the effective radius.
    Spheres(Spheres),
    /// Cone.
    Cone(Cone),
    /// Power-law profile.
    Power(Power),
    /// Flat-ended cylindrical punch.
    FlatPunch(FlatPunch),
    /// Cone with a flat tip.
    TruncatedCone(TruncatedCone),
    /// Paraboloid with a flat tip.
    TruncatedParaboloid(TruncatedParaboloid),
    /// Cone with a rounded tip.
    RoundedCone(RoundedCone),
    /// Flat punch with a rounded edge.
    RoundedPunch(RoundedPunch),
    /// Paraboloid with concentric waves.
    WavyParaboloid(WavyParaboloid),
    /// Two different principal radii, by the effective radius.
    Ellipsoid(Ellipsoid),
    /// Measured profile: a table with the columns `radius_m` and `height_m`.
    Table(PathBuf),
    /// The same with noise: made to rise so that the contact stays a circle, and how far heights were moved is told.
    SmoothTable(PathBuf),
    /// Rough line, alone or on a smooth shape.
    RoughLine(RoughShape),
    /// Heights of a measured or generated surface, a plain matrix or `.npy` [m], and the size of a pixel.
    HeightMap(PathBuf, Length),
    /// A measured surface with its unit and size, holes and tilt, and the one of the other body.
    Topography(Topography),
    /// Several tips side by side, on the half-space only.
    Tips(Vec<Tip>),
    /// Cylinder lying on its side.
    Cylinder(Cylinder),
    /// Sinusoidal section, long across: one period.
    PlaneWave(PlaneWave),
    /// Wavy parabolic section, long across.
    PlaneWavy(PlaneWavy),
    /// Springs or summits of scattered heights.
    Pad(Pad),
}

/// What a shape is pressed as.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Family<'s> {
    /// A profile over a radius, or over the places of the bed of a [`Lying`] section.
    Round,
    /// A rough line.
    Line(&'s RoughShape),
    /// Heights of a surface.
    Map(MapSource<'s>),
    /// Several tips side by side.
    Tips(&'s [Tip]),
    /// A wavy section, long across, whose contact may fall into pieces.
    Wavy(&'s PlaneWavy),
    /// Springs or summits of scattered heights.
    Pad(&'s Pad),
}

/// Where the heights of a surface come from.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum MapSource<'s> {
    /// A matrix in metres and the size of a pixel.
    Plain(&'s Path, Length),
    /// A measured surface that is treated before.
    Treated(&'s Topography),
}

/// Why a shape cannot be used.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum ShapeError {
    /// The table of a measured profile.
    #[error(transparent)]
    Table(#[from] TableError),
    /// A quantity derived from the shape's own is out of range.
    #[error("effective radius of the ellipsoid: {0}")]
    Quantity(#[from] QuantityError),
    /// Two spheres whose surfaces do not part from each other.
    #[error(
        "the sum 1/R of the curvatures of the two spheres is not above zero: expected radii that are not zero, and a hollow sphere, of negative radius, wider than the other"
    )]
    NoGap,
    /// The shape is no profile over a radius.
    #[error("a {0} has no profile over a radius")]
    NoProfile(&'static str),
}

impl Shape {
    /// The name a scene gives it.
    #[must_use]
    pub fn name(&self) -> &'static str {
        match self {
            Self::Paraboloid(_) => "Paraboloid",
            Self::Sphere(_) => "Sphere",
            Self::Spheres(_) => "Spheres",
            Self::Cone(_) => "Cone",
            Self::Power(_) => "Power",
            Self::FlatPunch(_) => "FlatPunch",
            Self::TruncatedCone(_) => "TruncatedCone",
            Self::TruncatedParaboloid(_) => "TruncatedParaboloid",
            Self::RoundedCone(_) => "RoundedCone",
            Self::RoundedPunch(_) => "RoundedPunch",
            Self::WavyParaboloid(_) => "WavyParaboloid",
            Self::Ellipsoid(_) => "Ellipsoid",
            Self::Table(_) => "Table",
            Self::SmoothTable(_) => "SmoothTable",
            Self::RoughLine(_) => "RoughLine",
            Self::Cylinder(_) => "Cylinder",
            Self::PlaneWave(_) => "PlaneWave",
            Self::PlaneWavy(_) => "PlaneWavy",
            Self::Pad(_) => "Pad",
            Self::HeightMap(..) => "HeightMap",
            Self::Topography(_) => "Topography",
            Self::Tips(_) => "Tips",
        }
    }

    /// Radius of curvature [m] at the apex, for criteria made for balls; `None` for tips without one.
    #[must_use]
    pub fn tip_radius(&self) -> Option<f64> {
        match self {
            Self::Paraboloid(shape) => Some(shape.radius.si()),
            Self::Sphere(shape) => Some(shape.radius.si()),
            Self::RoundedCone(shape) => Some(shape.radius.si()),
            Self::WavyParaboloid(shape) => Some(shape.radius.si()),
            Self::Ellipsoid(shape) => Some(shape.effective_radius()),
            Self::Spheres(shape) => Some(shape.effective_radius()),
            Self::Cone(_)
            | Self::Power(_)
            | Self::FlatPunch(_)
            | Self::TruncatedCone(_)
            | Self::TruncatedParaboloid(_)
            | Self::RoundedPunch(_)
            | Self::Table(_)
            | Self::SmoothTable(_)
            | Self::RoughLine(_)
            | Self::HeightMap(..)
            | Self::Topography(_)
            | Self::Tips(_)
            | Self::Cylinder(_)
            | Self::PlaneWave(_)
            | Self::PlaneWavy(_)
            | Self::Pad(_) => None,
        }
    }

    /// What a shape is pressed as.
    #[must_use]
    pub fn family(&self) -> Family<'_> {
        match self {
            Self::Paraboloid(_)
            | Self::Sphere(_)
            | Self::Spheres(_)
            | Self::Cone(_)
            | Self::Power(_)
            | Self::FlatPunch(_)
            | Self::TruncatedCone(_)
            | Self::TruncatedParaboloid(_)
            | Self::RoundedCone(_)
            | Self::RoundedPunch(_)
            | Self::WavyParaboloid(_)
            | Self::Ellipsoid(_)
            | Self::Cylinder(_)
            | Self::PlaneWave(_)
            | Self::Table(_)
            | Self::SmoothTable(_) => Family::Round,
            Self::RoughLine(line) => Family::Line(line),
            Self::HeightMap(path, pixel) => Family::Map(MapSource::Plain(path, *pixel)),
            Self::Topography(topography) => Family::Map(MapSource::Treated(topography)),
            Self::Tips(tips) => Family::Tips(tips),
            Self::PlaneWavy(wavy) => Family::Wavy(wavy),
            Self::Pad(pad) => Family::Pad(pad),
        }
    }

    /// Whether the shape is rough: only approximately axisymmetric, if at all.
    #[must_use]
    pub fn is_rough(&self) -> bool {
        matches!(self.family(), Family::Line(_) | Family::Map(..))
    }

    /// Whether the shape is long across its section.
    #[must_use]
    pub fn is_plane(&self) -> bool {
        matches!(self, Self::Cylinder(_) | Self::PlaneWave(_) | Self::PlaneWavy(_))
    }

    /// The profile, ready for evaluation, that of the smooth shape under a roughness; tables are read now.
    ///
    /// # Errors
    /// A table cannot be read or is not a profile; the error names its row.
    pub fn profile(&self, tables: &dyn Tables) -> Result<Arc<dyn Profile>, ShapeError> {
        Ok(match self {
            Self::Paraboloid(shape) => Arc::new(shape.clone()),
            Self::Sphere(shape) => Arc::new(shape.clone()),
            Self::Spheres(shape) => Arc::new(shape.effective().ok_or(ShapeError::NoGap)?),
            Self::Cone(shape) => Arc::new(shape.clone()),
            Self::Power(shape) => Arc::new(shape.clone()),
            Self::FlatPunch(shape) => Arc::new(shape.clone()),
            Self::TruncatedCone(shape) => Arc::new(shape.clone()),
            Self::TruncatedParaboloid(shape) => Arc::new(shape.clone()),
            Self::RoundedCone(shape) => Arc::new(shape.clone()),
            Self::RoundedPunch(shape) => Arc::new(shape.clone()),
            Self::WavyParaboloid(shape) => Arc::new(shape.clone()),
            Self::Ellipsoid(shape) => Arc::new(shape.effective()?),
            Self::Cylinder(shape) => Arc::new(Lying::from(shape)),
            Self::PlaneWave(shape) => Arc::new(Lying::from(shape)),
            Self::Table(path) => Arc::new(Measured::read(path, tables)?),
            Self::SmoothTable(path) => Arc::new(Measured::smooth(path, tables)?),
            Self::RoughLine(line) => match &line.base {
                Some(base) => base.profile(tables)?,
                None => return Err(ShapeError::NoProfile(self.name())),
            },
            Self::PlaneWavy(_) | Self::HeightMap(..) | Self::Topography(_) | Self::Tips(_) | Self::Pad(_) => {
                return Err(ShapeError::NoProfile(self.name()));
            }
        })
    }
}

#[cfg(test)]
mod tests;
