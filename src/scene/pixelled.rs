//! A scene on the pixels of a half-space: what is pressed, on how many pixels, and what repeats.

use super::read::Geometry;
use super::surface::{Source, Surface};
use crate::shape::{Boundary, PlacedTip, Profile, Shape};
use std::num::NonZeroUsize;
use std::sync::Arc;

/// Pixels along a smooth shape unless the scene says otherwise.
const SMOOTH: usize = 256;
/// Pixels on the shortest wave of a spectrum unless the scene says otherwise.
const PER_WAVE: f64 = 4.0;
/// Fewest and most pixels along a spectrum unless the scene says otherwise.
const SPECTRUM: (f64, f64) = (128.0, 1024.0);

/// What is pressed on the pixels of a half-space.
#[derive(Debug, Clone)]
pub enum PixelledIndenter {
    /// A profile over a radius.
    Smooth(Arc<dyn Profile>),
    /// The principal radii along x and y [m] of an ellipsoid, and the profile of its effective radius.
    Ellipsoid([f64; 2], Arc<dyn Profile>),
    /// Several tips side by side.
    Tips(Arc<[PlacedTip]>),
    /// A rough surface, on a profile if not on a flat.
    Rough(Arc<Surface>, Option<Arc<dyn Profile>>),
}

impl PixelledIndenter {
    /// What a shape is on pixels; `None` of a section, which is refused.
    pub(super) fn of(shape: &Shape, geometry: &Geometry) -> Option<Self> {
        Some(match (geometry, shape) {
            (Geometry::Round(profile), Shape::Ellipsoid(ellipsoid)) => {
                Self::Ellipsoid([ellipsoid.radius_x.si(), ellipsoid.radius_y.si()], profile.clone())
            }
            (Geometry::Round(profile), _) => Self::Smooth(profile.clone()),
            (Geometry::Rough(surface, base), _) => Self::Rough(surface.clone(), base.clone()),
            (Geometry::Tips(tips), _) => Self::Tips(tips.clone()),
            (Geometry::Wavy(_) | Geometry::Pad(_), _) => return None,
        })
    }

    /// The smooth profile, if there is one.
    #[must_use]
    pub fn profile(&self) -> Option<&dyn Profile> {
        match self {
            Self::Smooth(profile) | Self::Ellipsoid(_, profile) => Some(profile.as_ref()),
            Self::Tips(_) => None,
            Self::Rough(_, base) => base.as_deref(),
        }
    }

    /// The roughness, if there is one.
    #[must_use]
    pub fn surface(&self) -> Option<&Surface> {
        match self {
            Self::Smooth(_) | Self::Ellipsoid(..) | Self::Tips(_) => None,
            Self::Rough(surface, _) => Some(surface),
        }
    }
}

/// A random surface on a flat repeats; nobody knows how a measured one goes on, and a tip stands alone.
pub(super) fn suiting(indenter: &PixelledIndenter) -> Boundary {
    match indenter {
        PixelledIndenter::Rough(surface, None) => match surface.source {
            Source::Spectrum(_) => Boundary::Periodic,
            Source::Map(_) => Boundary::Free,
        },
        PixelledIndenter::Smooth(_)
        | PixelledIndenter::Ellipsoid(..)
        | PixelledIndenter::Tips(_)
        | PixelledIndenter::Rough(_, Some(_)) => Boundary::Free,
    }
}

/// Rows and columns of pixels.
pub(super) fn size(indenter: &PixelledIndenter, asked: Option<NonZeroUsize>, window: Option<f64>) -> [usize; 2] {
    let asked = asked.map(NonZeroUsize::get);
    match indenter {
        PixelledIndenter::Smooth(_) | PixelledIndenter::Ellipsoid(..) | PixelledIndenter::Tips(_) => {
            [asked.unwrap_or(SMOOTH); 2]
        }
        PixelledIndenter::Rough(surface, _) => of_surface(surface, asked, window),
    }
}

#[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "positive and within the limits of a grid")]
fn of_surface(surface: &Surface, asked: Option<usize>, window: Option<f64>) -> [usize; 2] {
    match &surface.source {
        Source::Spectrum(spectrum) => {
            let shortest = std::f64::consts::TAU / spectrum.cut_offs().1;
            let (fewest, most) = SPECTRUM;
            let waves = surface.length() / shortest;
            let suits = (PER_WAVE * waves).clamp(fewest, most).max((2.0 * waves).ceil());
            [asked.unwrap_or(even(suits.ceil() as usize)); 2]
        }
        Source::Map(map) => {
            let [rows, columns] = [map.heights().nrows(), map.heights().ncols()];
            let (x, y) = map.sides();
            let [x, y] = [x, y].map(|side| window.map_or(side, |window| window.min(side)));
            let own = |side: f64, pixel: f64| ((side / pixel).round() as usize).max(1);
            let own = [own(y, map.pixel().1).min(rows), own(x, map.pixel().0).min(columns)];
            asked.map_or(own, |grid| [((grid as f64 * y / x).round() as usize).max(1), grid])
        }
    }
}

fn even(count: usize) -> usize {
    count + count % 2
}
