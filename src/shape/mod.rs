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

mod ellipsoid;
mod kernel;
mod lying;
mod measured;
mod paraboloid;
mod plane;
mod power;
mod punch;
pub mod rough;
mod rough_line;
mod rounded;
mod sphere;
mod spheres;
mod truncated;
mod wavy;

pub use ellipsoid::Ellipsoid;
pub use lying::Lying;
pub use measured::Measured;
pub use paraboloid::Paraboloid;
pub use plane::{Cylinder, PlaneRipple, PlaneWave, PlaneWavy};
pub use power::{Cone, Power};
pub use punch::FlatPunch;
pub use rough_line::{RoughShape, Seeds};
pub use rounded::{RoundedCone, RoundedPunch};
pub use sphere::Sphere;
pub use spheres::Spheres;
pub use truncated::{TruncatedCone, TruncatedParaboloid};
pub use wavy::WavyParaboloid;

use crate::input::quantity::{Length, QuantityError};
use crate::input::table::{TableError, Tables};
use crate::numerics::quadrature;
use crate::numerics::root;
use serde::{Deserialize, Serialize};
use std::f64::consts::{FRAC_1_PI, FRAC_2_PI, FRAC_PI_2, PI, TAU};
use std::path::{Path, PathBuf};
use std::sync::Arc;

/// The end of a profile.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Rim {
    /// The profile goes on for ever.
    None,
    /// A vertical wall at this radius [m]: the contact cannot become larger (flat punch).
    Wall(f64),
    /// The profile is not defined beyond this radius [m] (equator of a sphere, end of a table).
    End(f64),
}

impl Rim {
    /// Radius [m] at which the profile ends; infinite if it goes on for ever.
    #[must_use]
    pub fn radius(self) -> f64 {
        match self {
            Self::None => f64::INFINITY,
            Self::Wall(end) | Self::End(end) => end,
        }
    }
}

/// An axisymmetric profile, ready for evaluation. Lengths in metres.
///
/// The contact of radius a with indentation d = g(a) carries F = 2E*∫₀^a (d − g) dx, which is
/// 2E*·[`load_integral`](Profile::load_integral): every quantity below is a sum of terms of one
/// sign for a profile with growing g, so none of them loses digits.
pub trait Profile: std::fmt::Debug + Send + Sync {
    /// Height f(r) [m] of the profile above its apex at the radius `r` [m].
    fn height(&self, r: f64) -> f64;

    /// One-dimensional profile g(x) [m] at `x` ≥ 0 [m].
    fn reduced(&self, x: f64) -> f64;

    /// Slope g′(x) of the one-dimensional profile at `x` ≥ 0 [m].
    fn reduced_slope(&self, x: f64) -> f64;

    /// N(a) = ∫₀^a x g′(x) dx = ∫₀^a (g(a) − g(x)) dx [m²]; the normal force is F = 2E*N.
    fn load_integral(&self, a: f64) -> f64 {
        quadrature::panels(|x| x * self.reduced_slope(x), (0.0, a), &self.breaks(a))
    }

    /// ∫₀^a (g(a) − g(x))² dx [m³]; the elastic energy is U = E* times it.
    fn energy_integral(&self, a: f64) -> f64 {
        quadrature::panels(|x| 2.0 * self.reduced_slope(x) * self.load_integral(x), (0.0, a), &self.breaks(a))
    }

    /// (1/π) ∫_r^a g′(x) dx/√(x²−r²) [1], the pressure of the regular part divided by E*, r < a.
    ///
    /// Infinite at the apex of a cone.
    fn pressure_integral(&self, r: f64, a: f64) -> f64 {
        // x = √(r² + s²) takes the root away: dx/√(x²−r²) = ds/x.
        let to_s = |x: f64| ((x - r) * (x + r)).sqrt();
        let breaks: Vec<f64> = self.breaks(a).into_iter().filter(|&x| x > r).map(to_s).collect();
        let at = |s: f64| {
            let x = r.hypot(s);
            self.reduced_slope(x) / x
        };
        FRAC_1_PI * quadrature::panels(at, (0.0, to_s(a)), &breaks)
    }

    /// (2/π) ∫₀^a (g(a) − g(x)) dx/√(r²−x²) [m], r ≥ a: the surface displacement outside the contact
    /// if the edge carries no load.
    fn displacement_integral(&self, r: f64, a: f64) -> f64 {
        // By parts ∫ g′(x) arcsin(x/r) dx, a sum of one sign; x = r sin θ takes the root at r away.
        let angle = |x: f64| x.atan2(((r - x).max(0.0) * (r + x)).sqrt());
        let breaks: Vec<f64> = self.breaks(a).into_iter().map(angle).collect();
        let at = |theta: f64| self.reduced_slope(r * theta.sin()) * theta * r * theta.cos();
        FRAC_2_PI * quadrature::panels(at, (0.0, angle(a)), &breaks)
    }

    /// The contact radius a [m] at the indentation `d` ≥ 0 [m] without adhesion: the largest a with
    /// g(a) = d; the flat radius at d = 0. `None` beyond the end of the profile.
    fn edge(&self, d: f64) -> Option<f64> {
        let limit = match self.rim() {
            Rim::None => f64::MAX,
            Rim::Wall(b) => {
                if self.reduced(b) <= d {
                    return Some(b);
                }
                b
            }
            Rim::End(end) => end,
        };
        let residual = |x: f64| self.reduced(x) - d;
        let flat = self.flat_radius();
        if d <= 0.0 {
            return Some(flat);
        }
        let start = self.scale().min(limit);
        let (low, high) = root::bracket_upwards(residual, flat, start.max(2.0 * flat), limit)?;
        root::brent(residual, low, high).ok()
    }

    /// Radius [m] up to which g = 0 (the flat of a truncated cone), else 0.
    fn flat_radius(&self) -> f64 {
        0.0
    }

    /// Where the profile ends.
    fn rim(&self) -> Rim {
        Rim::None
    }

    /// A radius [m] typical of the profile, from which searches start.
    fn scale(&self) -> f64;

    /// The shortest length [m] over which g′ may rise and fall again; `None` for a convex profile,
    /// whose g′ is monotone.
    fn feature(&self) -> Option<f64> {
        None
    }

    /// Radius [m] of an edge or of a change of law, about which g′ may rise and fall over any scale
    /// (truncated and rounded shapes); `None` where there is none.
    fn kink(&self) -> Option<f64> {
        None
    }

    /// Radius [m] at which g′ first becomes negative: a larger contact would not stay simply
    /// connected and the mapping would not be exact. `None` if that never happens.
    fn first_fall(&self) -> Option<f64> {
        None
    }

    /// Relative error of force and radius at the contact radius `a` [m] for what is not known of the shape; zero of a
    /// shape given by a formula.
    fn sampling_error(&self, _a: f64) -> f64 {
        0.0
    }

    /// Places in (0, a) where g′ or one of its derivatives jumps or where a quadrature panel should
    /// end, ascending [m].
    fn breaks(&self, a: f64) -> Vec<f64> {
        self.kink().map_or_else(Vec::new, |b| kernel::OutsideKink(b).breaks(a))
    }

    /// Whether the contact is that of a section long across, see [`Lying`]: its places x are then not its radii.
    fn is_plane(&self) -> bool {
        false
    }

    /// Radius, or half width of a section, [m] of a contact whose bed ends at the place `x` [m].
    fn contact_radius(&self, x: f64) -> f64 {
        x
    }

    /// Place x in the bed [m] that belongs to the radius, or half width, `radius` [m].
    fn place(&self, radius: f64) -> f64 {
        radius
    }

    /// Area A [m²] of a contact whose bed ends at the place `x` [m].
    fn contact_area(&self, x: f64) -> f64 {
        PI * x * x
    }

    /// A′(x) [m]: an edge pulled by Δl releases the energy E*Δl²/A′ per area.
    fn contact_area_slope(&self, x: f64) -> f64 {
        TAU * x
    }

    /// d ln A′/d ln x [1].
    fn contact_area_bend(&self, _x: f64) -> f64 {
        1.0
    }

    /// dA/dr [m], by which the area grows with the radius, or half width, `radius` [m].
    fn ring(&self, radius: f64) -> f64 {
        TAU * radius
    }

    /// Displacement [1] of the middle of the contact, times the modulus, under a stress of one at the radius `radius`
    /// [m], per radius: u(0) = (2/E*) ∫p dr.
    fn under_middle(&self, _radius: f64) -> f64 {
        2.0
    }

    /// Pressure [1/m] at the place `r` < `a` under an edge at `a` that carries the line load one.
    fn edge_pressure(&self, r: f64, a: f64) -> f64 {
        FRAC_1_PI / ((a - r) * (a + r)).sqrt()
    }

    /// Displacement [1] of the surface at the place `r` ≥ `a` under an edge at `a` displaced by one.
    fn edge_surface(&self, r: f64, a: f64) -> f64 {
        FRAC_2_PI * (a / r).min(1.0).asin()
    }

    /// Pressure [Pa] at the place `r` under the line load `load` q(x) [N/m]; `ends` are the borders of panels on which
    /// it is smooth, ascending, and it is zero beyond the last.
    ///
    /// By parts, with x² = r² + s²: π p(r) = q(r)/√(a²−r²) + ∫ (q(r) − q(x))/s² ds.
    fn pressure_of(&self, load: &dyn Fn(f64) -> f64, ends: &[f64], r: f64) -> f64 {
        let Some(&a) = ends.last() else { return 0.0 };
        if r >= a {
            return 0.0;
        }
        let here = load(r);
        let to_s = |x: f64| ((x - r) * (x + r)).sqrt();
        let breaks: Vec<f64> = ends.iter().filter(|&&x| x > r && x < a).map(|&x| to_s(x)).collect();
        let fall = |s: f64| (here - load(r.hypot(s))) / (s * s);
        FRAC_1_PI * (here / to_s(a) + quadrature::panels(fall, (0.0, to_s(a)), &breaks))
    }

    /// Displacement [m] of the surface at the place `r` [m] over springs displaced by `displacement` u(x) [m]; `ends` as
    /// of [`pressure_of`](Self::pressure_of).
    ///
    /// u_z(r) = (2/π) ∫₀^r u(x) dx/√(r²−x²); x = r sin θ takes the root away. The transform knows no time: springs let
    /// go and still creeping back count with what is left of their displacement.
    fn surface_of(&self, displacement: &dyn Fn(f64) -> f64, ends: &[f64], r: f64) -> f64 {
        let Some(&last) = ends.last() else { return 0.0 };
        let angle = |x: f64| if x < r { (x / r).asin() } else { FRAC_PI_2 };
        let breaks: Vec<f64> = ends.iter().map(|&x| angle(x)).collect();
        FRAC_2_PI * quadrature::panels(|theta| displacement(r * theta.sin()), (0.0, angle(last)), &breaks)
    }
}

/// g(x) from f′(r) by the integral over θ, which has no singularity.
///
/// `slope` is f′(r); `breaks` are radii below `x` where f′ or a derivative of it jumps.
pub fn reduced_by_integral(slope: impl Fn(f64) -> f64, x: f64, breaks: &[f64]) -> f64 {
    let angles: Vec<f64> = breaks.iter().filter(|&&r| r > 0.0 && r < x).map(|&r| (r / x).asin()).collect();
    x * quadrature::panels(|theta| slope(x * theta.sin()), (0.0, FRAC_PI_2), &angles)
}

/// f(r) from g(x) by the inverse transform; `breaks` as for the forward one.
pub fn height_by_integral(reduced: impl Fn(f64) -> f64, r: f64, breaks: &[f64]) -> f64 {
    let angles: Vec<f64> = breaks.iter().filter(|&&x| x > 0.0 && x < r).map(|&x| (x / r).asin()).collect();
    FRAC_2_PI * quadrature::panels(|theta| reduced(r * theta.sin()), (0.0, FRAC_PI_2), &angles)
}

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
    /// Rough line, alone or on a smooth shape.
    RoughLine(RoughShape),
    /// Heights of a measured or generated surface, a plain matrix or `.npy` [m], and the size of a pixel.
    HeightMap(PathBuf, Length),
    /// Cylinder lying on its side.
    Cylinder(Cylinder),
    /// Sinusoidal section, long across: one period.
    PlaneWave(PlaneWave),
    /// Wavy parabolic section, long across.
    PlaneWavy(PlaneWavy),
}

/// What a shape is pressed as.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Family<'s> {
    /// A profile over a radius, or over the places of the bed of a [`Lying`] section.
    Round,
    /// A rough line.
    Line(&'s RoughShape),
    /// Heights of a surface and the size of a pixel.
    Map(&'s Path, Length),
    /// A wavy section, long across, whose contact may fall into pieces.
    Wavy(&'s PlaneWavy),
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
            Self::RoughLine(_) => "RoughLine",
            Self::Cylinder(_) => "Cylinder",
            Self::PlaneWave(_) => "PlaneWave",
            Self::PlaneWavy(_) => "PlaneWavy",
            Self::HeightMap(..) => "HeightMap",
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
            _ => None,
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
            | Self::Table(_) => Family::Round,
            Self::RoughLine(line) => Family::Line(line),
            Self::HeightMap(path, pixel) => Family::Map(path, *pixel),
            Self::PlaneWavy(wavy) => Family::Wavy(wavy),
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
            Self::RoughLine(line) => match &line.base {
                Some(base) => base.profile(tables)?,
                None => return Err(ShapeError::NoProfile(self.name())),
            },
            Self::PlaneWavy(_) | Self::HeightMap(..) => {
                return Err(ShapeError::NoProfile(self.name()));
            }
        })
    }
}

#[cfg(test)]
mod tests;
