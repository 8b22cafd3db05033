//! How far a contact on a curved shape may spread on a line that is as long as it is.
//!
//! # Examples
//! ```
//! use springbed::contact::error::LineTooShort;
//!
//! let short = LineTooShort { indentation: 1e-6, length: 1e-4 };
//! assert!(short.to_string().contains("1e-4"));
//! ```

use crate::contact::error::{ContactError, LineTooShort};
use crate::shape::rough::{RoughError, RoughLine};
use crate::shape::{Profile, Rim};
use std::ops::Range;

/// Part of the line at either end that a contact on a curved shape must not reach.
const MARGIN: f64 = 1.0 / 16.0;

/// How deep a line can be pressed before a contact on a curved shape reaches its ends.
#[derive(Debug, Clone, Copy)]
pub(super) struct LineEnds {
    /// Indentation from first touch at which they are reached [m]; infinite over a flat.
    depth: f64,
    /// Length of the line [m].
    length: f64,
}

impl LineEnds {
    pub(super) fn of(
        line: &RoughLine,
        points: usize,
        base: Option<&dyn Profile>,
        first_touch: f64,
    ) -> Result<Self, RoughError> {
        Ok(Self { depth: least_gap_at_ends(base, line, points)? - first_touch, length: line.length() })
    }

    pub(super) fn hold(&self, depth: f64) -> Result<(), ContactError> {
        if depth > self.depth {
            return Err(LineTooShort { indentation: depth, length: self.length }.into());
        }
        Ok(())
    }
}

/// Least gap near the ends of the line; infinite over a flat, whose edge the contact may reach.
fn least_gap_at_ends(base: Option<&dyn Profile>, line: &RoughLine, points: usize) -> Result<f64, RoughError> {
    let Some(profile) = base else { return Ok(f64::INFINITY) };
    let (places, within) = (line.places(points), within(profile, line, points));
    let near = places.iter().zip(line.heights(points)?).enumerate().filter(|(spring, _)| !within.contains(spring));
    Ok(near.map(|(_, (x, z))| profile.reduced(x.abs()) + z).fold(f64::INFINITY, f64::min))
}

/// The springs of a line of `points` that a contact on a curved shape may reach; all of them where a wall ends it.
pub(super) fn within(profile: &dyn Profile, line: &RoughLine, points: usize) -> Range<usize> {
    let half = 0.5 * line.length();
    if matches!(profile.rim(), Rim::Wall(end) if end <= half) {
        return 0..points;
    }
    let places = line.places(points);
    let near = |x: &f64| x.abs() > (1.0 - MARGIN) * half;
    let first = places.iter().take_while(|x| near(x)).count();
    first..points - first
}
