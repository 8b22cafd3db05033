//! What lies on the smooth profile of a scene: roughness, made ready.
//!
//! # Examples
//! ```
//! use springbed::input::table::InMemory;
//! use springbed::scene::surface::{Source, of_map};
//! use ndarray::Array2;
//!
//! // A map of 16 × 16 pixels with waves in it.
//! let heights = Array2::from_shape_fn((16, 16), |(i, j)| 1e-8 * (0.7 * i as f64 + 0.4 * j as f64).sin());
//! let tables = InMemory::default().with_heights("map.csv", heights);
//! let surface = of_map("map.csv".as_ref(), "1 um".parse()?, &tables).map_err(|problems| problems[0].clone())?;
//! assert!((surface.length() - 16e-6).abs() < 1e-18 && matches!(surface.source, Source::Map(_)));
//! assert!(surface.roughness().rms_height > 0.0);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

use crate::input::problem::Problem;
use crate::input::quantity::Length;
use crate::input::table::Tables;
use crate::shape::rough::{Border, HeightMap, Rings, Roughness, RoughnessSpectrum, SourceError};
use crate::shape::{Rim, RoughShape, Topography, Treated};
use std::path::Path;
use std::sync::Arc;

/// Most springs of a rough line: their state alone has a gigabyte.
const MOST_POINTS: usize = 1 << 25;
/// Most members of an ensemble.
const MOST_MEMBERS: usize = 100_000;
/// Springs per ring under a height map, and at least.
const PER_RING: usize = 8;
const LEAST_POINTS: usize = 1 << 14;

/// A rough surface ready to be pressed.
#[derive(Debug, Clone, PartialEq)]
pub struct Surface {
    /// Variance by rings of wavevectors.
    pub rings: Rings,
    /// Where the roughness comes from.
    pub source: Source,
    /// Springs of the equivalent line.
    pub points: usize,
    /// One seed per member of the ensemble.
    pub seeds: Vec<u64>,
}

/// Where a roughness comes from.
#[derive(Debug, Clone, PartialEq)]
pub enum Source {
    /// A power spectrum.
    Spectrum(RoughnessSpectrum),
    /// Measured or generated heights.
    Map(Arc<HeightMap>),
}

impl Surface {
    /// Side of the nominal area [m].
    #[must_use]
    pub fn length(&self) -> f64 {
        self.rings.length()
    }

    /// Root mean square height [m], slope and mean curvature [1/m].
    #[must_use]
    pub fn roughness(&self) -> Roughness {
        match &self.source {
            Source::Map(map) => map.roughness(Border::Cut),
            Source::Spectrum(spectrum) => Roughness {
                rms_height: spectrum.rms_height(),
                rms_slope: spectrum.rms_slope(),
                rms_curvature: spectrum.rms_curvature(),
                peak_to_valley: None,
            },
        }
    }
}

/// The roughness of a line.
///
/// # Errors
/// Spectra that do not fit the line, tables that cannot be read, a base that is rough or too short.
pub fn of_line(line: &RoughShape, tables: &dyn Tables) -> Result<Surface, Vec<Problem>> {
    let mut problems = sizes(line);
    problems.extend(beyond_base(line, tables));
    let spectrum = line.spectrum.spectrum(tables);
    let rings = spectrum.and_then(|spectrum| {
        let rings = Rings::of(&spectrum, line.length.si(), line.points.get());
        Ok((rings.map_err(SourceError::from)?, spectrum))
    });
    match rings {
        Ok((rings, spectrum)) if problems.is_empty() => {
            let source = Source::Spectrum(spectrum);
            Ok(Surface { rings, source, points: line.points.get(), seeds: line.seeds() })
        }
        Ok(_) => Err(problems),
        Err(error) => {
            problems.push(Problem::new("shape.spectrum", error.to_string()));
            Err(problems)
        }
    }
}

/// Numbers of springs and members that are too large.
fn sizes(line: &RoughShape) -> Vec<Problem> {
    let mut problems = Vec::new();
    let mut too_many = |field: &str, count: usize, most: usize| {
        if count > most {
            problems.push(Problem::new(field, format!("{count} is too many: expected at most {most}")));
        }
    };
    too_many("shape.points", line.points.get(), MOST_POINTS);
    too_many("shape.seeds", line.seeds.map_or(0, std::num::NonZeroUsize::get), MOST_MEMBERS);
    too_many("shape.seed", line.seed.as_ref().map_or(0, |seeds| seeds.0.len()), MOST_MEMBERS);
    if line.seed.is_some() && line.seeds.is_some() {
        problems.push(Problem::new("shape.seeds", "is given beside `seed`: expected one of the two"));
    }
    problems
}

/// A line that is longer than the shape it lies on, or lies on another rough shape.
fn beyond_base(line: &RoughShape, tables: &dyn Tables) -> Option<Problem> {
    let base = line.base.as_deref()?;
    if base.is_rough() {
        return Some(Problem::new("shape.base", "is rough itself: expected a smooth shape"));
    }
    if base.is_plane() {
        return Some(Problem::new(
            "shape.base",
            format!(
                "{} is long across, and the line stands for a surface that is alike in all directions: expected a round shape",
                base.name()
            ),
        ));
    }
    let Ok(profile) = base.profile(tables) else { return None };
    let Rim::End(end) = profile.rim() else { return None };
    (0.5 * line.length.si() > end).then(|| {
        Problem::new("shape.length", format!("reaches beyond the end of the base: expected at most {:e} m", 2.0 * end))
    })
}

/// The roughness of the height map at `path` with pixels of the size `pixel`.
///
/// # Errors
/// The map cannot be read.
pub fn of_map(path: &Path, pixel: Length, tables: &dyn Tables) -> Result<Surface, Vec<Problem>> {
    let problem = |what: String| vec![Problem::new("shape", what)];
    let heights = tables.heights(path).map_err(|error| problem(error.to_string()))?;
    let map = HeightMap::new(heights, (pixel.si(), pixel.si()));
    Ok(of_heights(map.map_err(|error| problem(format!("{}: {error}", path.display())))?))
}

/// The roughness of a measured surface, treated as it says.
///
/// # Errors
/// The map cannot be read, or has holes.
pub fn of_topography(topography: &Topography, tables: &dyn Tables) -> Result<Surface, Vec<Problem>> {
    let problem = |what: String| vec![Problem::new("shape", what)];
    let Treated { heights, pixel } = topography.treated(tables).map_err(|error| problem(error.to_string()))?;
    let map = HeightMap::new(heights, pixel);
    Ok(of_heights(map.map_err(|error| problem(format!("{}: {error}", topography.file.display())))?))
}

fn of_heights(map: HeightMap) -> Surface {
    let rings = map.rings(Border::Cut);
    let points = (PER_RING * rings.variances().len()).max(LEAST_POINTS);
    Surface { rings, source: Source::Map(Arc::new(map)), points, seeds: vec![1] }
}
