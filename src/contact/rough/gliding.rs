//! A rough line that glides.
//!
//! # Examples
//! ```
//! use springbed::contact::gliding::SteadyGlide;
//! use springbed::contact::rough::gliding_line;
//! use springbed::material::{Relaxation, Spectrum};
//! use springbed::shape::rough::{Rings, RoughLine, RoughnessSpectrum};
//! use std::sync::Arc;
//!
//! // In full contact on rubber with one relaxation time the resistance is the most where half of it has relaxed.
//! let roughness = RoughnessSpectrum::table(&[(6.4, 1e-12), (64.0, 1e-15)])?;
//! let line = RoughLine::new(&Rings::of(&roughness, 1.0, 1000)?, 7);
//! let rubber = Relaxation { equilibrium: 1.0, terms: vec![(1.0, 0.1)], viscosity: 0.0 };
//! let glide = SteadyGlide::line(Arc::new(Spectrum::new(&rubber)), Arc::new(gliding_line(&line, 1000, None)?));
//! let resistance = |speed: f64| glide.at_depth(speed, 1.0).map(|state| state.resistance);
//! assert!(resistance(1.0)? > 10.0 * resistance(1e-3)? && resistance(1.0)? > 10.0 * resistance(1e3)?);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

use super::bed::{RoughBed, number};
use crate::contact::gliding::GlidingLine;
use crate::shape::Profile;
use crate::shape::rough::{RoughError, RoughLine};

/// A line of `points` points as it glides: again and again over a nominally flat body, or once, on the profile `base`.
///
/// # Errors
/// Fewer than two points on the shortest wave.
pub fn gliding_line(line: &RoughLine, points: usize, base: Option<&dyn Profile>) -> Result<GlidingLine, RoughError> {
    let gaps = RoughBed::gaps_under(line, points, |x| base.map_or(0.0, |base| base.reduced(x)))?;
    let step = line.length() / number(points);
    Ok(if base.is_some() { GlidingLine::single(&gaps, step) } else { GlidingLine::periodic(&gaps, step) })
}
