//! What glides, as the springs of a bed see it: corners one width apart, with chords between them.

use super::{MARGIN, number, signed};
use crate::contact::error::{BedError, ContactError};
use crate::contact::gliding::GlidingLine;
use crate::shape::Profile;
use std::ops::Range;
use std::sync::Arc;

/// The polygon that glides.
#[derive(Debug, Clone)]
pub(super) enum Outline {
    /// A round profile, the same on both sides of the corner 0.
    Round {
        profile: Arc<dyn Profile>,
        /// Heights [m] at kh, k = 0, 1, …, as far as they have been asked for.
        heights: Vec<f64>,
    },
    /// A rough line, which is its own polygon.
    Line(Arc<GlidingLine>),
}

impl Outline {
    pub fn round(profile: Arc<dyn Profile>) -> Self {
        Self::Round { heights: vec![profile.reduced(0.0)], profile }
    }

    /// Where the spring 0 stands at first, from the corner 0, in widths: half a chord away under a round profile; under a
    /// corner of a line, so that at rest its bed is that of its points.
    pub fn offset(&self) -> f64 {
        match self {
            Self::Round { .. } => 0.5,
            Self::Line(_) => 0.0,
        }
    }

    /// Springs of a ground that comes again and again.
    pub fn ring(&self) -> Option<usize> {
        match self {
            Self::Line(line) if line.is_periodic() => Some(line.corners()),
            Self::Line(_) | Self::Round { .. } => None,
        }
    }

    /// Height [m] of the corner k, infinite beyond what is known.
    pub fn height(&self, corner: i64) -> f64 {
        match self {
            Self::Round { heights, .. } => {
                let known = usize::try_from(corner.unsigned_abs()).ok().and_then(|k| heights.get(k));
                known.copied().unwrap_or(f64::INFINITY)
            }
            Self::Line(line) => line.gap(corner),
        }
    }

    /// Corners between which lies everything that is known.
    pub fn extent(&self) -> Range<i64> {
        match self {
            Self::Round { heights, .. } => -signed(heights.len())..signed(heights.len()),
            Self::Line(line) => -signed(MARGIN)..signed(line.corners() + MARGIN),
        }
    }

    /// Chords that a contact of the depth `depth` [m] can reach, by their lower corners; `width` [m] is that of a chord.
    pub fn reach(&mut self, depth: f64, width: f64) -> Result<Range<i64>, ContactError> {
        match self {
            Self::Round { profile, heights } => {
                let reach = signed(on_either_side(profile.as_ref(), heights, (depth, width))?);
                Ok(-reach..reach)
            }
            Self::Line(line) => line.chords_below(depth, MARGIN),
        }
    }
}

/// Chords on either side of the middle of a round profile; heights that are not known yet are found.
fn on_either_side(
    profile: &dyn Profile,
    heights: &mut Vec<f64>,
    (depth, width): (f64, f64),
) -> Result<usize, ContactError> {
    let outgrown = || ContactError::from(BedError::BeyondProfile { indentation: depth });
    let known = heights.partition_point(|height| *height < depth);
    if known + MARGIN < heights.len() || depth <= 0.0 && heights.len() > MARGIN {
        return Ok(known + MARGIN);
    }
    let end = profile.rim().radius();
    let edge = profile.edge(depth.max(0.0)).ok_or_else(outgrown)?;
    if edge >= end {
        return Err(outgrown());
    }
    let corners = number((edge / width).ceil()) + 2 * MARGIN + 1;
    let height = |k: usize| {
        let x = k as f64 * width;
        // Beyond its end the profile goes on straight, where nothing meets it.
        let inside = x.min(end);
        profile.reduced(inside) + (x - inside) * profile.reduced_slope(inside)
    };
    let more: Vec<f64> = (heights.len()..=corners).map(height).collect();
    heights.extend(more);
    Ok(heights.partition_point(|height| *height < depth) + MARGIN)
}
